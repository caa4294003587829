// SPDX-License-Identifier: MIT
// Roads and ribbons along the curves of `filigree spline`.
#pragma once

#include <string>
#include <vector>

#include "command.h"
#include "documents/session.h"
#include "filigree/filigree_spline.h"

namespace flg::cli {

struct RoadOptions {
    double width = 0, spacing = 0, height = 0, bank = 0, texture_length = 0;
    std::vector<double> up;
    uint32_t columns = 4;
    std::string output;

    bool is_wanted() const { return width > 0; }
};

void add_road_options(CLI::App& app, RoadOptions& options);

// Refuses options that do not go together, and files that are none. Throws UsageError, InputError.
void check_road_options(const RoadOptions& options);

// One mesh of a road along each spline. `on_mesh`: whether they are on a mesh's manifold.
void write_roads(Session& session, const RoadOptions& options, bool on_mesh, const std::vector<FlgSpline>& splines,
                 Report& report);

}  // namespace flg::cli
