// SPDX-License-Identifier: MIT
#include <fstream>

#include "documents/text_lines.h"
#include "shell/script.h"
#include "shell/studio_error.h"

namespace flg::studio {

std::vector<ScriptStep> read_script(const std::string& path) {
    std::ifstream file(path);
    if (!file) throw StudioError("The script " + path + " cannot be read.");
    std::vector<ScriptStep> steps;
    std::string line;
    for (int number = 1; cli::next_line(file, line); ++number) {
        ScriptStep step;
        step.line = number;
        for (size_t i = 0; i < line.size();) {
            const char c = line[i];
            if (c == '#') break;
            if (c == ' ' || c == '\t' || c == '\r') {
                ++i;
            } else if (c == '"') {
                const size_t end = line.find('"', i + 1);
                if (end == std::string::npos)
                    throw StudioError(path + ":" + std::to_string(number) + ": a quotation mark is missing.");
                step.words.push_back(line.substr(i + 1, end - i - 1));
                step.quoted.push_back(true);
                i = end + 1;
            } else {
                const size_t end = std::min(line.find_first_of(" \t\r", i), line.size());
                step.words.push_back(line.substr(i, end - i));
                step.quoted.push_back(false);
                i = end;
            }
        }
        if (!step.words.empty()) steps.push_back(std::move(step));
    }
    return steps;
}

}  // namespace flg::studio
