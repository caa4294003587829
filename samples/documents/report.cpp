// SPDX-License-Identifier: MIT
#include "documents/report.h"

#include <algorithm>
#include <cmath>
#include <iostream>

#include "documents/progress.h"
#include "documents/text_file.h"
#include "filigree/filigree.h"

namespace flg::cli {

float percentile(std::vector<float> values, double p) {
    if (values.empty()) return 0.0f;
    const double last = static_cast<double>(values.size()) - 1.0;
    const auto rank =
        static_cast<size_t>(std::clamp(std::ceil(p * static_cast<double>(values.size())) - 1.0, 0.0, last));
    std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(rank), values.end());
    return values[rank];
}

Report::Report(const std::string& command, const CommonOptions& common) : command_(command), common_(common) {}

void Report::add_stage(const std::string& name, double wall_us, double busy_us) {
    const auto known = std::find_if(stages_.begin(), stages_.end(), [&](const Stage& s) { return s.name == name; });
    if (known == stages_.end()) {
        stages_.push_back({name, wall_us, busy_us});
    } else {
        known->wall_us += wall_us;
        known->busy_us += busy_us;
    }
}

void Report::warn(const std::string& sentence) {
    note(sentence);
    if (common_.quiet) return;
    clear_progress_line();
    std::cerr << "filigree: warning: " << sentence << "\n";
}

nlohmann::ordered_json Report::json() const {
    nlohmann::ordered_json stages = nlohmann::ordered_json::object();
    for (const Stage& stage : stages_) {
        stages[stage.name] = {{"wall_ms", stage.wall_us / 1000.0}, {"cpu_ms", stage.busy_us / 1000.0}};
    }
    const std::vector<float>& ticks = times_.ticks_us;
    nlohmann::ordered_json json;
    json["command"] = command_;
    json["version"] = std::to_string(FLG_VERSION_MAJOR) + "." + std::to_string(FLG_VERSION_MINOR) + "." +
                      std::to_string(FLG_VERSION_PATCH);
    json["seed"] = common_.seed;
    json["workers"] = common_.workers;
    json["parameters"] = parameters;
    json["counts"] = counts;
    json["stages"] = stages;
    json["ticks"] = {{"count", ticks.size()},
                     {"budget_us", common_.budget_us},
                     {"p50_us", percentile(ticks, 0.50)},
                     {"p99_us", percentile(ticks, 0.99)},
                     {"max_us", percentile(ticks, 1.0)},
                     {"longest_chunk_us", times_.max_slice_us},
                     {"longest_chunk_stage", times_.max_slice_stage}};
    json["warnings"] = warnings_;
    json["quality"] = quality;
    return json;
}

void Report::write() const {
    if (!common_.report.empty()) write_text_file(common_.report, json().dump(2) + "\n");
}

}  // namespace flg::cli
