// SPDX-License-Identifier: MIT
// Cables of `filigree spline --cable`: hung between the points of its curves.
#pragma once

#include <string>
#include <vector>

#include "command.h"
#include "documents/session.h"
#include "documents/space_lines.h"
#include "filigree/filigree_spline.h"

namespace flg::cli {

struct CableOptions {
    bool is_wanted = false;
    double slack = flgCableHangDefaults().slack;
    std::vector<double> lengths, gravity;
    uint32_t segments = flgCableHangDefaults().segments;
};

void add_cable_options(CLI::App& app, CableOptions& options);

// A cable for each curve; `obstacles` may be none.
FlgCurveSet hang_cables(Session& session, const CableOptions& options, const SpaceLines& lines, FlgObstacles obstacles,
                        const std::string& subject, Report& report);

}  // namespace flg::cli
