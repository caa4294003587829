// SPDX-License-Identifier: MIT
#include "shell/report.h"

#include <filesystem>
#include <fstream>

#include "shell/studio_error.h"
#include "shell/widgets.h"

namespace flg::studio {

nlohmann::json report_of(const View& view, const Input& input) {
    nlohmann::json labels = nlohmann::json::object();
    for (const auto& [label, rect] : ui::widgets())
        labels[label] = {rect.low.x,      rect.low.y,      rect.high.x,      rect.high.y,
                         rect.pane_low.x, rect.pane_low.y, rect.pane_high.x, rect.pane_high.y};
    const glm::ivec4 v = view.viewport;
    return {{"labels", labels},
            {"picture", {v.x, v.y, v.z, v.w}},
            {"pointer", {input.px.x, input.px.y}},
            {"taken",
             {{"buttons", input.taken.buttons},
              {"keys", input.taken.keys},
              {"notches", input.taken.notches},
              {"drops", input.taken.drops}}}};
}

void write_report(const std::string& path, const nlohmann::json& report) {
    const std::string beside = path + ".new";
    {
        std::ofstream file(beside, std::ios::binary);
        file << report.dump();
        if (!file.flush()) throw StudioError("The report " + path + " can't be written.");
    }
    std::error_code error;
    std::filesystem::rename(beside, path, error);
    if (error) throw StudioError("The report " + path + " can't be written: " + error.message() + ".");
}

}  // namespace flg::studio
