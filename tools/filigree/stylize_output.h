// SPDX-License-Identifier: MIT
// What `stylize` leaves behind: files, counts, and what can be said of the result's quality.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "documents/report.h"
#include "filigree/filigree_io.h"
#include "surface_options.h"

namespace flg::cli {

struct StylizedCurves {
    FlgCurveSetView view;
    std::vector<FlgCurveGeometry> shapes;  // of the target's strokes, one a curve; empty: it says nothing of them
    std::optional<float> default_radius;   // metres, of curves that have none; from the size of the whole if not given
};

struct StylizeOutput {
    std::string curves, guide, matching, path;  // files; empty: not wanted
    SurfaceOptions surface;
    bool all_columns = false;

    // Refuses files that can't be written, before any work is done.
    void check_paths() const;
    // `style` must be ready.
    void write(FlgContext context, FlgStyle style, const StylizedCurves& result, Report& report) const;
};

}  // namespace flg::cli
