// SPDX-License-Identifier: MIT
#include "surfaces/refined_solver_fronts.h"

#include <algorithm>
#include <cmath>

namespace flg {

namespace {

// Of the edge from v to m: how much further than from the unfolded point m may be. That point is not where it should be by
// the surface's curvature and by the distances' errors.
constexpr float tolerance = 0.03f;
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

// From a point at the distance `a`, to one at the distance `b`, that are seen so far apart.
float third_side(float a, float b, float cosine) {
    return std::sqrt(std::max(a * a + b * (b - (a + a) * cosine), 0.0f));
}

}  // namespace

std::optional<float> distance_by_own_front(const GeodesicBlock& block, const WaveState* states, float distance,
                                           uint32_t lane, bool across_next) {
    const float target = block.lengths[lane], along = distance + target;
    FanWalk walk(block, lane, across_next);
    if (!walk.advance()) return {};
    Angle from_target = walk.turned();
    for (uint32_t edge = 0; edge < most_edges; ++edge) {
        const float length = walk.length(), at_end = states[walk.rank()].distance;
        if (at_end == std::numeric_limits<float>::infinity()) return along;
        const float cosine = std::clamp(
            (length * length + (distance - at_end) * (distance + at_end)) / (2 * length * distance), -1.0f, 1.0f);
        const Angle source = {cosine, std::sqrt((1 - cosine) * (1 + cosine))};  // from the edge, on its other side
        bool is_one_front = true;
        if (walk.advance()) {
            const float passed = third_side(distance, walk.length(), (source + -walk.turned()).cosine);
            is_one_front = passed > std::max(distance, at_end) ||
                           states[walk.rank()].distance <= passed + tolerance * walk.length();
        }
        if (is_one_front && edge == 0) return {};
        if (is_one_front) {
            const Angle apart = source + from_target;
            const bool is_straight = from_target.sine > 0 && apart.sine >= 0;
            return is_straight ? std::max(third_side(distance, target, apart.cosine), distance) : along;
        }
        from_target = from_target + walk.turned();
    }
    return along;
}

}  // namespace flg
