// SPDX-License-Identifier: MIT
// Distances along a mesh as commands ask for them: sources, how far.
#pragma once

#include <limits>

#include "documents/mesh_places.h"

namespace flg::cli {

struct GeodesicOptions {
    std::string mesh;
    std::vector<Place> sources;
    FlgAccuracy accuracy = FLG_ACCURACY_REFINED;
    float max_distance = std::numeric_limits<float>::infinity();

    void add_to(CLI::App& app);
    void describe(Report& report) const;
    // The distances, ready, from the sources to every vertex of the surface; their number and the furthest go into the
    // report. Throws InputError.
    FlgField solve(Session& session, const MeshSurface& surface, Report& report) const;
};

FlgFieldView view_of(FlgContext context, FlgField field);

}  // namespace flg::cli
