// SPDX-License-Identifier: MIT
#include "surfaces/border_sampling.h"

#include <algorithm>
#include <cmath>

#include "core/failure.h"

namespace flg {

namespace {

constexpr double most_points = 0x1p24;

double length_of(const Mesh& mesh, Corner edge) {
    return (mesh.position(mesh.vertex_at(next_corner(edge))) - mesh.position(mesh.vertex_at(edge))).norm();
}

}  // namespace

BorderSamplingKernel::BorderSamplingKernel(const Mesh& mesh, const RegionSet& regions, float spacing,
                                           SurfaceCurves& curves, Memory* memory)
    : mesh_(mesh),
      regions_(regions),
      spacing_(spacing),
      curves_(curves),
      visited_((3 * size_t{mesh.triangle_count()} + 63) / 64, memory) {}

bool BorderSamplingKernel::run(uint32_t count) {
    const Corner edges = 3 * mesh_.triangle_count();
    for (; count > 0 && pass_ != Pass::done; --count) {
        switch (pass_) {
            case Pass::clear:
                if (at_ < visited_.size()) {
                    visited_[at_++] = 0;
                } else {
                    at_ = 0;
                    pass_ = Pass::find;
                }
                break;
            case Pass::find:
                if (at_ == edges) {
                    pass_ = Pass::done;
                } else if ((visited_[at_ / 64] >> at_ % 64 & 1) != 0 || !is_border(at_)) {
                    ++at_;
                } else {
                    edge_ = at_;
                    walked_ = 0;
                    pass_ = Pass::measure;
                }
                break;
            case Pass::measure:
                if (walk()) begin_places();
                break;
            case Pass::place: place(); break;
            case Pass::done: break;
        }
    }
    return pass_ == Pass::done;
}

bool BorderSamplingKernel::is_border(Corner edge) const {
    if (!regions_.contains(mesh_.regions[triangle_of(edge)])) return false;
    const uint32_t across = mesh_.neighbour_at(edge);
    return across == no_index || !regions_.contains(mesh_.regions[across]);
}

// Turns about the edge's end, through the regions' triangles, until it meets the next edge; true at the first one again.
bool BorderSamplingKernel::walk() {
    if (turning_ == no_index) {
        visited_[edge_ / 64] |= uint64_t{1} << edge_ % 64;
        walked_ += length_of(mesh_, edge_);
        turning_ = next_corner(edge_);
    } else if (!is_border(turning_)) {
        turning_ = next_corner(mesh_.opposite(turning_));
    } else {
        edge_ = turning_;
        turning_ = no_index;
        return edge_ == at_;
    }
    return false;
}

void BorderSamplingKernel::begin_places() {
    length_ = walked_;
    walked_ = 0;
    const double steps = std::round(length_ / spacing_);
    if (!(steps <= most_points)) {
        throw Failure(FLG_ERROR_LIMIT, "spacing %g makes more than 2^24 points of a border of %g m", double{spacing_},
                      length_);
    }
    count_ = std::max(3u, static_cast<uint32_t>(steps));
    placed_ = 0;
    pass_ = Pass::place;
}

// A point, or on to the next edge. A border without length has all its points in one place.
void BorderSamplingKernel::place() {
    if (turning_ != no_index) {
        walk();
        return;
    }
    const double place = length_ * placed_ / count_, length = length_of(mesh_, edge_);
    if (placed_ < count_ && (place < walked_ + length || length_ == 0)) {
        const double t = length > 0 ? (place - walked_) / length : 0;
        curves_.points.push_back(point_on_edge(edge_, round_on_edge(std::clamp(t, 0.0, 1.0))));
        ++placed_;
    } else if (placed_ < count_) {
        walk();
    } else {
        curves_.offsets.push_back(static_cast<uint32_t>(curves_.points.size()));
        curves_.closed.push_back(true);
        curves_.values.push_back(static_cast<float>(length_));
        pass_ = Pass::find;
    }
}

}  // namespace flg
