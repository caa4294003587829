// SPDX-License-Identifier: MIT
// The JSON report (--report), the same shape for every command.
#pragma once

#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "documents/common.h"

namespace flg::cli {

struct TickTimes {
    std::vector<float> ticks_us;
    float max_slice_us = 0.0f;
    std::string max_slice_stage;
};

class Report {
public:
    Report(const std::string& command, const CommonOptions& common);

    nlohmann::ordered_json parameters = nlohmann::ordered_json::object();
    nlohmann::ordered_json counts = nlohmann::ordered_json::object();
    nlohmann::ordered_json quality = nlohmann::ordered_json::object();

    // Adds up when a stage comes twice. Microseconds.
    void add_stage(const std::string& name, double wall_us, double busy_us);
    // A warning for the JSON alone, already said elsewhere.
    void note(const std::string& sentence) { warnings_.push_back(sentence); }
    // Also says it on stderr, unless --quiet.
    void warn(const std::string& sentence);
    void set_ticks(const TickTimes& times) { times_ = times; }

    nlohmann::ordered_json json() const;
    // Writes it if the user asked for one.
    void write() const;

private:
    struct Stage {
        std::string name;
        double wall_us, busy_us;
    };
    std::string command_;
    const CommonOptions& common_;
    std::vector<Stage> stages_;
    std::vector<std::string> warnings_;
    TickTimes times_;
};

// The smallest value that a share `p` of all values does not pass; 0 of none.
float percentile(std::vector<float> values, double p);

}  // namespace flg::cli
