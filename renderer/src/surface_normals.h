// SPDX-License-Identifier: MIT
// Normals of vertices: the mean of their triangles' normals by the triangles' angles there (Thurmer, Wuthrich:
// Computing vertex normals from polygonal facets, 1998), so that they don't depend on how a surface is cut into
// triangles.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

namespace flg::render {

// Of any length; 0 where no triangle around has an area, or all cancel out. About 25 ns a triangle.
std::vector<glm::vec3> vertex_normals(std::span<const glm::vec3> positions, std::span<const uint32_t> triangles);

// The same where vertex i >= positions.size() - copied.size() is a copy, on another side of a border, of the vertex
// that `copied` says. Where the surface goes on smoothly across the border all have the normal of all triangles around,
// at a crease each has that of its own side.
std::vector<glm::vec3> creased_normals(std::span<const glm::vec3> positions, std::span<const uint32_t> triangles,
                                       std::span<const uint32_t> copied);

}  // namespace flg::render
