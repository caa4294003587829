// SPDX-License-Identifier: MIT
// Curves beside the curves of `filigree spline`.
#pragma once

#include <string>
#include <vector>

#include "command.h"
#include "documents/session.h"
#include "filigree/filigree_spline.h"

namespace flg::cli {

struct BesideOptions {
    double left = 0, above = 0;
    std::vector<double> up;
    bool turns_least = false, keeps_loops = false;

    // Left alone can be had over the triangles of a mesh, too.
    bool is_more_than_left() const { return above != 0 || !up.empty() || turns_least || keeps_loops; }
    bool is_wanted() const { return left != 0 || above != 0; }
};

void add_beside_options(CLI::App& app, BesideOptions& options);

// Refuses options that do not go together. Throws UsageError.
void check_beside_options(const BesideOptions& options, bool on_mesh);

// The view lives as long as the session.
FlgCurveSetView curve_beside(Session& session, const BesideOptions& options, FlgSpline spline,
                             const std::string& subject, Report& report);

}  // namespace flg::cli
