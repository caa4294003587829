// SPDX-License-Identifier: MIT
#include "surfaces/refined_solver_fronts.h"

#include <algorithm>
#include <cmath>

namespace flg {

namespace {

// Of the edge from v to m: how much further than from the unfolded point m may be. That point is not where it should be by
// the surface's curvature and by the distances' errors.
constexpr float tolerance = 0.015f;
constexpr uint32_t most_edges = 4;  // looked at around v

struct Angle {
    float cosine = 1, sine = 0;

    static Angle from_half_tangent(float tangent) {
        const float inverse = 1 / (1 + tangent * tangent);
        return {(1 - tangent * tangent) * inverse, (tangent + tangent) * inverse};
    }
    Angle operator+(const Angle& other) const {
        return {cosine * other.cosine - sine * other.sine, sine * other.cosine + cosine * other.sine};
    }
    Angle operator-() const { return {cosine, -sine}; }
};

// Goes around a vertex from lane to lane, one way or the other.
class FanWalk {
public:
    FanWalk(const GeodesicBlock& block, uint32_t lane, bool forth) : block_(block), lane_(lane), forth_(forth) {
        while (last_ > 0 && block.rank(last_) == nowhere) --last_;
        closed_ = last_ > 2 && block.rank(0) == block.rank(last_);
    }
    // False where the fan, or the block, has no further triangle.
    bool advance() {
        if (lane_ == (forth_ ? last_ : 0)) {
            if (!closed_) return false;
            lane_ = last_ - lane_;
        }
        const float tangent = block_.tangents[forth_ ? lane_ : lane_ - 1];
        lane_ = forth_ ? lane_ + 1 : lane_ - 1;
        turned_ = Angle::from_half_tangent(tangent);
        return tangent > 0;
    }
    uint32_t rank() const { return block_.rank(lane_); }
    float length() const { return block_.lengths[lane_]; }
    const Angle& turned() const { return turned_; }  // by the last advance

private:
    const GeodesicBlock& block_;
    uint32_t lane_;
    uint32_t last_ = lane_count - 1;
    bool forth_;
    bool closed_;
    Angle turned_;
};

// How much further it is to a point that is `length` from the vertex, the front having that curvature at it and its source
// being seen at that angle from the point.
float way_on(float front, float length, float cosine) {
    const float excess = length * (front * length - (cosine + cosine));
    return excess / (1 + std::sqrt(std::max(1 + front * excess, 0.0f)));
}

// What the vertex and the end of one of its edges tell together, as in the step.
struct Sight {
    Sight(const WaveState& own, const WaveState& end, float length) {
        const float ahead_by = own.distance - end.distance, slope = ahead_by / length;
        const float moved = end.front / (1 + end.front * ahead_by);
        const float trust = own.distance / std::max(own.distance + end.distance, 1e-30f);
        front = own.front + trust * (moved - own.front);
        source.cosine = std::clamp(slope + 0.5f * length * front * (1 - slope * slope), -1.0f, 1.0f);
        source.sine = std::sqrt((1 - source.cosine) * (1 + source.cosine));
    }
    float front;
    Angle source;  // from the edge, on its other side
};

}  // namespace

std::optional<float> distance_by_own_front(const GeodesicBlock& block, const WaveState* states, const WaveState& own,
                                           uint32_t lane, bool across_next) {
    const float target = block.lengths[lane], along = own.distance + target;
    FanWalk walk(block, lane, across_next);
    if (!walk.advance()) return {};
    Angle from_target = walk.turned();
    for (uint32_t edge = 0; edge < most_edges; ++edge) {
        const WaveState& end = states[walk.rank()];
        if (end.distance == std::numeric_limits<float>::infinity()) return along;
        const Sight sight(own, end, walk.length());
        bool is_one_front = true;
        if (walk.advance()) {
            const float passed =
                own.distance + way_on(sight.front, walk.length(), (sight.source + -walk.turned()).cosine);
            is_one_front = passed > std::max(own.distance, end.distance) ||
                           states[walk.rank()].distance <= passed + tolerance * walk.length();
        }
        if (is_one_front && edge == 0) return {};
        if (is_one_front) {
            const Angle apart = sight.source + from_target;
            const bool is_straight = from_target.sine > 0 && apart.sine >= 0;
            return is_straight ? own.distance + std::max(way_on(sight.front, target, apart.cosine), 0.0f) : along;
        }
        from_target = from_target + walk.turned();
    }
    return along;
}

}  // namespace flg
