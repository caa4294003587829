// SPDX-License-Identifier: MIT
#include "reference/literal_cable.h"

#include <cmath>

namespace flg::reference {

std::vector<Vec3> literal_cable(const ObstacleSet* solids, const Vec3& from, const Vec3& to, double length,
                                uint32_t segments, const Vec3& down, uint32_t rounds) {
    constexpr uint32_t passes = 60;
    const double rod = length / segments, last_share = 1e-6;
    const double shrink = std::pow(last_share, 1.0 / rounds);
    std::vector<Vec3> places(segments + 1);
    for (uint32_t i = 0; i <= segments; ++i) places[i] = from + (to - from) * i / segments;
    double fall = 0.2 * rod;
    for (uint32_t round = 0; round < rounds; ++round, fall *= shrink) {
        for (uint32_t i = 1; i < segments; ++i) places[i] += fall * down;
        for (uint32_t pass = 0; pass < passes; ++pass) {
            for (uint32_t k = 0; k < segments; ++k) {
                const uint32_t i = pass % 2 == 0 ? k : segments - 1 - k;
                const Vec3 along = places[i + 1] - places[i];
                const double own = along.norm();
                const Vec3 back = (own - rod) / own * along;
                const bool first = i == 0, last = i + 1 == segments;
                if (!first) places[i] += (last ? 1 : 0.5) * back;
                if (!last) places[i + 1] -= (first ? 1 : 0.5) * back;
            }
            if (!solids) continue;
            for (uint32_t i = 1; i < segments; ++i) {
                Vec3 outwards = Vec3::Zero();
                const double away = solids->distance(places[i].data(), nullptr, outwards.data());
                if (away < 0) places[i] -= away * outwards;
            }
        }
    }
    return places;
}

double mean_height(const std::vector<Vec3>& places, const Vec3& down) {
    double sum = 0;
    for (size_t i = 0; i + 1 < places.size(); ++i) sum -= 0.5 * down.dot(places[i] + places[i + 1]);
    return sum / static_cast<double>(places.size() - 1);
}

}  // namespace flg::reference
