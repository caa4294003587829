// SPDX-License-Identifier: MIT
#include "surfaces/isolines.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace flg {

namespace {

constexpr uint16_t no_class = 0xffff;  // of values that are not finite
constexpr uint32_t segment_units = 8;

}  // namespace

IsolineKernel::IsolineKernel(const Mesh& mesh, std::span<const float> values, std::span<const float> levels,
                             const RegionSet& regions, SurfaceCurves& out, Memory* memory)
    : mesh_(mesh),
      values_(values),
      levels_(levels),
      regions_(regions),
      out_(out),
      classes_(mesh.vertex_count(), memory),
      marks_((size_t{mesh.triangle_count()} + 63) / 64, memory),
      crossed_(memory),
      segments_(memory) {}

void IsolineKernel::classify(uint32_t vertex) {
    const float value = values_[vertex];
    // Mostly the band of the vertex before.
    if (!(band_begin_ <= value && value < band_end_)) {
        if (!std::isfinite(value)) {
            classes_[vertex] = no_class;
            return;
        }
        const auto above = std::upper_bound(levels_.begin(), levels_.end(), value);
        band_ = static_cast<uint16_t>(above - levels_.begin());
        band_begin_ = above == levels_.begin() ? std::numeric_limits<float>::lowest() : *(above - 1);
        band_end_ = above == levels_.end() ? std::numeric_limits<float>::infinity() : *above;
    }
    classes_[vertex] = band_;
}

// The part above, walked around counter-clockwise, goes below the level on the edge `in` and comes back on `out`; the
// segment leads from `in` to `out` and has that part on its left.
IsolineKernel::Crossing IsolineKernel::crossing(uint32_t triangle, uint32_t level) const {
    const Triple& vertices = mesh_.triangles[triangle];
    const auto is_above = [&](uint32_t k) { return classes_[vertices[k % 3]] > level; };
    // The same from both sides of an edge: always reckoned from below.
    const auto height = [&](uint32_t below, uint32_t above) {
        const double low = values_[vertices[below % 3]], high = values_[vertices[above % 3]];
        return round_on_edge((double{levels_[level]} - low) / (high - low));
    };
    Crossing found{};
    for (uint32_t k = 0; k < 3; ++k) {
        if (is_above(k) && !is_above(k + 1)) found.in = k;
        if (!is_above(k) && is_above(k + 1)) found.out = k;
    }
    const float in_height = height(found.in + 1, found.in), out_height = height(found.out, found.out + 1);
    found.in_at = 1 - in_height;
    found.out_at = out_height;
    const bool one_above = (found.out + 1) % 3 == found.in;
    found.has_length = one_above ? in_height != 1 || out_height != 1 : in_height != 0 || out_height != 0;
    return found;
}

void IsolineKernel::begin_crossing(uint32_t triangle) {
    if (!regions_.contains(mesh_.regions[triangle])) return;
    const Triple& vertices = mesh_.triangles[triangle];
    const auto [lowest, highest] = std::minmax({classes_[vertices[0]], classes_[vertices[1]], classes_[vertices[2]]});
    if (highest == no_class) return;
    marks_[triangle / 64].crossed |= uint64_t{1} << triangle % 64;
    crossed_.push_back({static_cast<uint32_t>(segments_.size()), lowest});
    next_level_ = lowest;
    end_level_ = highest;
}

void IsolineKernel::cross_next_level(uint32_t triangle) {
    const Crossing c = crossing(triangle, next_level_);
    segments_.push_back({point_on_edge(3 * triangle + c.in, c.in_at), mesh_.neighbours[triangle][c.out], next_level_,
                         c.has_length, false, false});
    ++next_level_;
}

uint32_t IsolineKernel::segment_at(uint32_t triangle, uint32_t level) const {
    if (triangle == no_index) return no_index;
    const Mark& mark = marks_[triangle / 64];
    const uint64_t bit = uint64_t{1} << triangle % 64;
    if ((mark.crossed & bit) == 0) return no_index;
    const CrossedTriangle& found =
        crossed_[mark.before + static_cast<uint32_t>(std::popcount(mark.crossed & (bit - 1)))];
    return found.first_segment + level - found.lowest_level;
}

void IsolineKernel::draw(uint32_t index) {
    Segment& segment = segments_[index];
    segment.is_drawn = true;
    if (segment.has_length) {
        out_.points.push_back(segment.start);
        last_drawn_ = index;
    }
    drawing_ = segment.following;
    if (drawing_ == no_index) {
        if (last_drawn_ != no_index) {
            const Segment& last = segments_[last_drawn_];
            const Crossing c = crossing(last.start.triangle, last.level);
            out_.points.push_back(point_on_edge(3 * last.start.triangle + c.out, c.out_at));
        }
        end_curve(false);
    } else if (segments_[drawing_].is_drawn) {
        drawing_ = no_index;
        end_curve(true);
    }
}

void IsolineKernel::end_curve(bool closed) {
    const uint32_t first = out_.offsets.back();
    const auto end = static_cast<uint32_t>(out_.points.size());
    if (end - first < (closed ? 3 : 2)) {
        out_.points.resize(first);
    } else {
        out_.offsets.push_back(end);
        out_.closed.push_back(closed);
        out_.values.push_back(levels_[segments_[last_drawn_].level]);
    }
    last_drawn_ = no_index;
}

void IsolineKernel::enter(Pass pass) {
    pass_ = pass;
    at_ = 0;
}

bool IsolineKernel::run(uint32_t count) {
    const uint32_t vertices = mesh_.vertex_count(), triangles = mesh_.triangle_count();
    while (count > 0 && pass_ != Pass::done) {
        const auto segments = static_cast<uint32_t>(segments_.size());
        switch (pass_) {
            case Pass::classify: {
                const uint32_t end = at_ + std::min(count, vertices - at_);
                count -= end - at_;
                for (; at_ < end; ++at_) classify(at_);
                if (at_ == vertices) enter(Pass::scan);
                break;
            }
            case Pass::scan:
                if (next_level_ < end_level_) {
                    cross_next_level(at_ - 1);
                    count -= std::min(count, segment_units);
                } else if (at_ < triangles) {
                    // As far as the next triangle that is crossed, in the same mark.
                    const uint32_t end = at_ + std::min({count, triangles - at_, 64 - at_ % 64});
                    if (at_ % 64 == 0) marks_[at_ / 64] = {0, static_cast<uint32_t>(crossed_.size())};
                    while (at_ < end && next_level_ == end_level_) {
                        --count;
                        const Triple& t = mesh_.triangles[at_++];
                        const uint16_t a = classes_[t[0]], b = classes_[t[1]], c = classes_[t[2]];
                        if (a != b || b != c) begin_crossing(at_ - 1);
                    }
                } else {
                    enter(Pass::link);
                }
                break;
            case Pass::link:
                if (at_ < segments) {
                    Segment& segment = segments_[at_++];
                    segment.following = segment_at(segment.following, segment.level);
                    if (segment.following != no_index) segments_[segment.following].has_preceding = true;
                    count -= std::min(count, segment_units);
                } else {
                    enter(Pass::chains);
                }
                break;
            case Pass::chains:
            case Pass::loops:
                if (drawing_ != no_index) {
                    draw(drawing_);
                    count -= std::min(count, segment_units);
                } else if (at_ < segments) {
                    const Segment& segment = segments_[at_];
                    if (!segment.is_drawn && (pass_ == Pass::loops || !segment.has_preceding)) drawing_ = at_;
                    ++at_;
                    --count;
                } else {
                    enter(pass_ == Pass::chains ? Pass::loops : Pass::done);
                }
                break;
            case Pass::done: break;
        }
    }
    return pass_ == Pass::done;
}

}  // namespace flg
