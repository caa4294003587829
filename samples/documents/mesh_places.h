// SPDX-License-Identifier: MIT
// Places on a mesh as users name them: a vertex of the file, or a point in space, for which the nearest of the surface
// stands.
#pragma once

#include <CLI/CLI.hpp>
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "documents/mesh_nearest.h"

namespace flg::cli {

struct Place {
    std::string text;                // as given
    std::optional<uint32_t> vertex;  // else:
    std::array<double, 3> position;
};

// An option for places with `;` between them.
CLI::Option* add_places(CLI::App& app, const std::string& option, std::vector<Place>& places,
                        const std::string& description);
// An option for one place.
CLI::Option* add_place(CLI::App& app, const std::string& option, Place& place, const std::string& description);

class PlaceFinder {
public:
    // `option` is what errors are about, besides the surface's file.
    PlaceFinder(const MeshSurface& surface, const std::string& option);

    // Of a place that is a vertex, its number on the surface. Throws InputError if the file has no such vertex or the
    // surface has dropped it.
    uint32_t vertex(const Place& place) const;
    // Of vertices, a corner of one of their triangles.
    FlgSurfacePoint point(const Place& place);
    // How far the furthest point in space was from the surface, metres.
    float gap() const { return gap_; }

private:
    const MeshSurface& surface_;
    FlgSurfaceView view_;
    std::string subject_;
    std::unique_ptr<NearestSearch> search_;  // once needed
    float gap_ = 0.0f;
};

}  // namespace flg::cli
