// SPDX-License-Identifier: MIT
#include "surfaces/mesh_edit.h"

#include <bit>

namespace flg {

void MeshEdit::set_position(Mesh& mesh, uint32_t vertex, const Position& position) {
    Position& place = mesh.positions[vertex];
    for (uint32_t k = 0; k < 3; ++k) remember(array_positions, 3 * vertex + k, std::bit_cast<uint32_t>(place[k]));
    place = position;
}

void MeshEdit::set_value(MeshColumns& columns, uint32_t column, uint32_t vertex, float value) {
    float& word = columns[column].values[vertex];
    if (vertex < before_.vertices) words_.push_back({array_columns + column, vertex, std::bit_cast<uint32_t>(word)});
    word = value;
}

}  // namespace flg
