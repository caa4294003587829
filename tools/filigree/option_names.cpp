// SPDX-License-Identifier: MIT
#include "option_names.h"

#include <algorithm>
#include <cctype>
#include <utility>

#include "documents/failure.h"

namespace flg::cli {
namespace {

using Names = std::vector<std::pair<std::string, std::string>>;

bool is_word(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

// Whole names alone: desc.scale isn't part of desc.scales.
void replace_all(std::string& text, const std::string& name, const std::string& word) {
    for (size_t at = text.find(name); at != std::string::npos; at = text.find(name, at)) {
        const size_t end = at + name.size();
        const bool whole = end == text.size() || !is_word(name.back()) || !is_word(text[end]);
        if (whole) text.replace(at, name.size(), word);
        at += whole ? word.size() : 1;
    }
}

Names names_of(const std::vector<std::string>& drives) {
    Names names;
    for (size_t k = 0; k < drives.size(); ++k) {
        const std::string field = "desc.drives[" + std::to_string(k) + "]", option = "--drive " + drives[k];
        names.emplace_back(field + ".at_from", option + ": A");
        names.emplace_back(field + ".at_to", option + ": B");
        names.emplace_back(field + ".from", option + ": FROM");
        names.emplace_back(field + ".to", option + ": TO");
        names.emplace_back("another number than `from`", "another number than FROM");
        names.emplace_back(field, option);
    }
    for (size_t k = 0; k < 8; ++k) {
        names.emplace_back("desc.further_styles[" + std::to_string(k) + "]", "style " + std::to_string(k + 1));
    }
    const Names options = {{"desc.drives drive", "--drive changes"},
                           {"desc.drive_count", "the number of --drive"},
                           {"desc.start_cap and desc.end_cap are", "--caps gives"},
                           {"desc.start_cap", "--caps START"},
                           {"desc.end_cap", "--caps END"},
                           {"desc.style", "the example"},
                           {"desc.guide", "--guide"},
                           {"desc.target", "the target"},
                           {"desc.magnitude", "--sigma"},
                           {"desc.temperature", "--tau"},
                           {"desc.scale", "--scale"},
                           {"desc.basis", "--basis"},
                           {"desc.frame", "--frame"},
                           {"desc.start", "--start"},
                           {"desc.strokes", "--strokes"},
                           {"desc.max_points", "--max-points"},
                           {"desc.fit", "--fit"},
                           {"desc.corners", "--corners"},
                           {"desc.corner_angle", "--corner-angle"},
                           {"desc.corner_caps", "--corner-caps"},
                           {"desc.smooth_junctions", "--smooth-junctions"},
                           {"desc.pin_ends", "--network"},
                           {"desc.style_blend", "--style-blend"},
                           {"desc.patch", "--patch"},
                           {"desc.patch_sizes", "--multiresolution"},
                           {"desc.point_count", "--points"},
                           {"desc.alpha", "--alpha"},
                           {"desc.beta", "--beta"},
                           {"desc.smoothing", "--smoothing"},
                           {"desc.attributes", "--attributes"}};
    names.insert(names.end(), options.begin(), options.end());
    return names;
}

}  // namespace

std::string in_option_names(const std::string& sentence, const std::vector<std::string>& drives) {
    std::string text = sentence;
    for (const auto& [name, word] : names_of(drives)) replace_all(text, name, word);
    return text;
}

void with_option_names(const std::vector<std::string>& drives, const std::function<void()>& run) {
    try {
        run();
    } catch (const InputError& error) {
        throw InputError(in_option_names(error.what(), drives));
    }
}

}  // namespace flg::cli
