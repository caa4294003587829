// SPDX-License-Identifier: MIT
// How a style is put on curves, as far as `stylize` and `replay` have the same options for it.
#pragma once

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <map>
#include <string>
#include <vector>

#include "documents/report.h"
#include "filigree/filigree.h"

namespace flg::cli {

class ApplyOptions {
public:
    // `frames`: what --frame may be, said by `frame_help`. Lives as long as the program.
    void add_to(CLI::App& app, const std::map<std::string, FlgFrameMethod>& frames, const std::string& frame_help);
    void describe(Report& report) const;
    // Refuses what does not go together (UsageError). `styles`: how many there are; `whole_motifs`: strokes have them.
    void check_usage(size_t styles, bool whole_motifs) const;
    // Refuses curves that lack a column which drives (InputError), and where `by_hand`, what no hand has.
    void check_columns(const FlgCurveSetView& view, const std::string& subject, bool by_hand) const;
    // Of drives, as they were given.
    const std::vector<std::string>& drives_said() const { return drives_said_; }

    // Along the curves: the same twice, unless it is driven.
    std::array<float, 2> temperatures() const;
    // 0: the SDK decides, as FlgCurveSetStylizeDesc::scale says.
    float scale() const { return scale_; }

    // Into FlgCurveSetStylizeDesc or FlgLiveStrokeDesc; not the scale.
    template <class Desc>
    void set(Desc& desc) const {
        desc.magnitude = magnitude_;
        desc.temperature = temperature_;
        desc.frame = frame_;
        desc.start = start_;
        std::copy(basis_.begin(), basis_.end(), desc.basis);
        desc.drives = drives_.empty() ? nullptr : drives_.data();
        desc.drive_count = static_cast<uint32_t>(drives_.size());
    }

private:
    // The SDK's defaults are the commands'.
    float magnitude_ = flgCurveSetStylizeDefaults().magnitude, temperature_ = flgCurveSetStylizeDefaults().temperature;
    float scale_ = 0.0f;
    FlgFrameMethod frame_ = flgCurveSetStylizeDefaults().frame;
    FlgStyleStart start_ = flgCurveSetStylizeDefaults().start;
    std::vector<float> basis_;  // empty: the identity
    std::vector<FlgStyleDrive> drives_;
    std::vector<std::string> drives_said_;
    const std::map<std::string, FlgFrameMethod>* frames_ = nullptr;
    // Nothing where motifs are whole.
    const CLI::Option* tau_ = nullptr;
    const CLI::Option* start_option_ = nullptr;
};

}  // namespace flg::cli
