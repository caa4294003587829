// SPDX-License-Identifier: MIT
// Normals of vertices: the mean of their triangles' normals by the triangles' angles there (Thurmer, Wuthrich: Computing
// vertex normals from polygonal facets, 1998), so that they don't depend on how a surface is cut into triangles.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

namespace flg::render {

// Of any length; 0 where no triangle around has an area, or all cancel out. About 25 ns a triangle.
std::vector<glm::vec3> vertex_normals(std::span<const glm::vec3> positions, std::span<const uint32_t> triangles);

}  // namespace flg::render
