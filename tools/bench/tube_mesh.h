// SPDX-License-Identifier: MIT
// Tubes as triangles made on the processor: what the renderer's expansion in the vertex shader is measured against.
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "filigree/filigree_surface.h"

namespace flg::bench {

struct TubeMesh {
    std::vector<glm::vec3> positions, normals;
    std::vector<uint32_t> triangles;
    std::vector<FlgColumn> columns;

    // Around a polyline of which no two points in a row are equal; ends stay open.
    TubeMesh(const std::vector<glm::vec3>& points, float radius, uint32_t sides);
    FlgMeshView view();
};

}  // namespace flg::bench
