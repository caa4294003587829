// SPDX-License-Identifier: MIT
#include "inflation/two_sided_mesh.h"

#include <algorithm>
#include <cmath>

namespace flg {

namespace {

constexpr uint32_t batch = 16;

}  // namespace

TwoSidedMesh::TwoSidedMesh(const InflatedPart& part, PartSurface& out, Memory* memory)
    : part_(part),
      out_(out),
      memory_(memory),
      below_(part.points.size(), memory),
      count_(static_cast<uint32_t>(part.points.size())) {}

bool TwoSidedMesh::run(uint32_t count) {
    const auto vertices = static_cast<uint32_t>(part_.points.size());
    const auto triangles = static_cast<uint32_t>(part_.triangles.size());
    for (; count > 0 && pass_ != Pass::done; --count) {
        switch (pass_) {
            case Pass::number:
                for (const uint32_t stop = std::min(vertices, at_ + batch); at_ < stop; ++at_)
                    below_[at_] = part_.on_border[at_] ? at_ : count_++;
                if (at_ < vertices) break;
                out_.positions = Buffer<Vec3>(count_, memory_);
                out_.triangles = Buffer<TriangleVertices>(2 * size_t{triangles}, memory_);
                at_ = 0;
                pass_ = Pass::place;
                break;
            case Pass::place:
                for (const uint32_t stop = std::min(vertices, at_ + batch); at_ < stop; ++at_) {
                    const Point2& p = part_.points[at_];
                    const double height = part_.thickness * std::sqrt(part_.squares[at_]);
                    std::construct_at(&out_.positions[at_], p.x, p.y, height);
                    if (below_[at_] != at_) std::construct_at(&out_.positions[below_[at_]], p.x, p.y, -height);
                }
                if (at_ < vertices) break;
                at_ = 0;
                pass_ = Pass::join;
                break;
            case Pass::join:
                for (const uint32_t stop = std::min(triangles, at_ + batch); at_ < stop; ++at_) {
                    const TriangleVertices& t = part_.triangles[at_];
                    out_.triangles[at_] = t;
                    out_.triangles[triangles + at_] = {below_[t[2]], below_[t[1]], below_[t[0]]};
                }
                if (at_ == triangles) pass_ = Pass::done;
                break;
            case Pass::done: break;
        }
    }
    return pass_ == Pass::done;
}

}  // namespace flg
