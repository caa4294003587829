// SPDX-License-Identifier: MIT
// What rays meet on one mesh, in the mesh's own space. Its structure is built in a thread of its own, which takes a
// second for a million triangles; until then nothing is met.
#pragma once

#include <future>
#include <glm/glm.hpp>
#include <optional>

#include "filigree/filigree.hpp"
#include "filigree/filigree_pick.h"

namespace flg::studio {

class MeshPicker {
public:
    MeshPicker();
    ~MeshPicker();
    MeshPicker(const MeshPicker&) = delete;
    MeshPicker& operator=(const MeshPicker&) = delete;

    // Takes in what the mesh has become, unless it is building; once a frame.
    void update(const filigree::Surface& surface, const FlgSurfaceView& view);
    // The first time, wholly in a thread, which reads the surface until is_built().
    void begin(const FlgSurfaceView& view);
    bool is_built() const;
    // The mesh has another surface.
    void forget() { is_set_ = false; }
    // It knows this revision.
    bool knows(uint32_t revision) const { return is_set_ && revision_ == revision && !building_.valid(); }
    std::optional<FlgHit> hit(const glm::vec3& origin, const glm::vec3& direction) const;
    std::optional<FlgHit> nearest(const glm::vec3& place) const;

private:
    FlgPickScene scene_ = nullptr;
    std::future<FlgResult> building_;  // nobody may use the scene meanwhile
    bool is_set_ = false;
    uint32_t revision_ = 0;
};

}  // namespace flg::studio
