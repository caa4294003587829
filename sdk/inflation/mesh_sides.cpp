// SPDX-License-Identifier: MIT
#include "inflation/mesh_sides.h"

#include <algorithm>

namespace flg {

namespace {

constexpr uint32_t batch = 16;

}  // namespace

MeshSides::MeshSides(uint32_t vertices, std::span<const TriangleVertices> triangles, std::span<Across> out,
                     Memory* memory)
    : triangles_(triangles), out_(out), offsets_(vertices + size_t{2}, memory), sides_(3 * triangles.size(), memory) {}

bool MeshSides::run(uint32_t count) {
    const auto offsets = static_cast<uint32_t>(offsets_.size()), triangles = static_cast<uint32_t>(triangles_.size());
    // Side k of a triangle begins at the corner after k.
    for (; count > 0 && pass_ != Pass::done; --count) {
        const uint32_t end = pass_ == Pass::clear ? offsets : pass_ == Pass::sum ? offsets - 2 : triangles;
        for (const uint32_t stop = std::min(end, at_ + batch / (pass_ == Pass::match ? 4 : 1)); at_ < stop; ++at_) {
            switch (pass_) {
                case Pass::clear: offsets_[at_] = 0; break;
                case Pass::count:
                    for (const uint32_t vertex : triangles_[at_]) ++offsets_[vertex + 2];
                    break;
                case Pass::sum: offsets_[at_ + 2] += offsets_[at_ + 1]; break;
                case Pass::scatter:
                    for (uint32_t k = 0; k < 3; ++k) sides_[offsets_[triangles_[at_][(k + 1) % 3] + 1]++] = 3 * at_ + k;
                    break;
                default:
                    for (uint32_t k = 0; k < 3; ++k) {
                        const uint32_t from = triangles_[at_][(k + 1) % 3], to = triangles_[at_][(k + 2) % 3];
                        for (uint32_t i = offsets_[to]; i < offsets_[to + 1]; ++i) {
                            const uint32_t other = sides_[i] / 3, side = sides_[i] % 3;
                            if (triangles_[other][(side + 2) % 3] == from) out_[at_][k] = other;
                        }
                    }
                    break;
            }
        }
        if (at_ == end) {
            at_ = 0;
            pass_ = static_cast<Pass>(static_cast<int>(pass_) + 1);
        }
    }
    return pass_ == Pass::done;
}

}  // namespace flg
