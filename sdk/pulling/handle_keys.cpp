// SPDX-License-Identifier: MIT
#include "pulling/handle_keys.h"

#include <algorithm>

#include "core/vec.h"

namespace flg {

namespace {

constexpr double fastest = 3;  // of the slower way: more would swing out

Vec3 position_of(const float* positions, size_t key) {
    const float* p = positions + 3 * key;
    return {double{p[0]}, double{p[1]}, double{p[2]}};
}

Vec3 velocity_at(std::span<const double> times, const float* positions, size_t key) {
    if (key == 0 || key + 1 == times.size()) return Vec3::Zero();
    const double before = times[key] - times[key - 1], after = times[key + 1] - times[key];
    const Vec3 at = position_of(positions, key);
    const Vec3 in = (at - position_of(positions, key - 1)) / before;
    const Vec3 out = (position_of(positions, key + 1) - at) / after;
    const Vec3 velocity = (after * in + before * out) / (before + after);
    const double limit = fastest * std::min(in.norm(), out.norm()), speed = velocity.norm();
    return speed > limit ? Vec3(velocity * (limit / speed)) : velocity;
}

}  // namespace

std::array<float, 3> handle_at(std::span<const double> times, const float* positions, double time) {
    const auto next = static_cast<size_t>(std::upper_bound(times.begin(), times.end(), time) - times.begin());
    const size_t key = next == 0 ? 0 : next - 1;
    const float* p = positions + 3 * key;
    if (next == 0 || next == times.size() || time == times[key]) return {p[0], p[1], p[2]};
    const double span = times[next] - times[key], t = (time - times[key]) / span, left = 1 - t;
    const Vec3 at =
        left * left * (1 + 2 * t) * position_of(positions, key) + t * t * (3 - 2 * t) * position_of(positions, next) +
        span * t * left * (left * velocity_at(times, positions, key) - t * velocity_at(times, positions, next));
    return {static_cast<float>(at.x()), static_cast<float>(at.y()), static_cast<float>(at.z())};
}

}  // namespace flg
