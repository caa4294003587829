// SPDX-License-Identifier: MIT
// A repaired mesh that needs no repair where it is read. Repairs keep sheets apart that only touch, at vertices of the
// same place; readers weld these, and are where the repair began. So all but one of such vertices are moved, by about a
// millionth of their triangles' size, into these triangles.
#pragma once

#include <vector>

#include "documents/mesh_surface.h"

namespace flg::cli {

class SettledMesh {
public:
    // Of a surface as it was made. Throws InputError if it does not settle.
    SettledMesh(Session& session, const MeshSurface& surface, Report& report);

    // Lives as long as this and the session.
    const FlgMeshView& view() const { return view_; }
    uint32_t moved_vertices() const { return moved_; }
    // Metres.
    double farthest_move() const { return farthest_; }

private:
    // Returns whether there were vertices to move.
    bool separate();

    FlgMeshView view_;
    std::vector<float> positions_;
    std::vector<FlgColumn> columns_;
    uint32_t moved_ = 0;
    double farthest_ = 0.0;
};

}  // namespace flg::cli
