// SPDX-License-Identifier: MIT
// What `stylize` does where targets turn, and where they meet.
#pragma once

#include <CLI/CLI.hpp>

#include "documents/report.h"
#include "filigree/filigree.h"

namespace flg::cli {

class CornerOptions {
public:
    // Lives as long as the program.
    void add_to(CLI::App& app);
    void describe(Report& report) const;
    void set(FlgCurveSetStylizeDesc& desc) const;
    // Refuses what does not go together (UsageError).
    void check_usage() const;
    bool motifs() const { return corners_ == FLG_STYLE_CORNERS_MOTIFS; }
    bool caps() const { return caps_; }

private:
    FlgStyleCorners corners_ = FLG_STYLE_CORNERS_THROUGH;
    float angle_deg_ = 50.0f;  // as the SDK has it
    bool caps_ = false, smooth_junctions_ = false;
    const CLI::Option* angle_ = nullptr;
};

}  // namespace flg::cli
