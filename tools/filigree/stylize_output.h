// SPDX-License-Identifier: MIT
// What `stylize` leaves behind: files, counts, and what can be said of the result's quality.
#pragma once

#include <string>

#include "filigree/filigree_io.h"
#include "report.h"

namespace flg::cli {

struct StylizeOutput {
    std::string curves, guide, matching, path;  // files; empty: not wanted
    FlgGeometry geometry;
    bool all_columns = false;

    // Refuses files that can't be written, before any work is done.
    void check_paths() const;
    // `style` and `result` must be ready.
    void write(FlgContext context, FlgStyle style, FlgCurveSet result, Report& report) const;
};

}  // namespace flg::cli
