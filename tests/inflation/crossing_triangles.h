// SPDX-License-Identifier: MIT
// Where a surface cuts through itself: pairs of triangles without a vertex in common, a side of one of which passes
// through the other.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <unordered_map>
#include <utility>
#include <vector>

namespace flg::test {

using Place = std::array<double, 3>;

inline Place from_to(const Place& a, const Place& b) {
    return {b[0] - a[0], b[1] - a[1], b[2] - a[2]};
}

// Six times the volume of a tetrahedron.
inline double volume(const Place& a, const Place& b, const Place& c, const Place& d) {
    const Place x = from_to(a, b), y = from_to(a, c), z = from_to(a, d);
    return x[0] * (y[1] * z[2] - y[2] * z[1]) - x[1] * (y[0] * z[2] - y[2] * z[0]) + x[2] * (y[0] * z[1] - y[1] * z[0]);
}

inline bool passes(const Place& from, const Place& to, const std::array<Place, 3>& t) {
    const double below = volume(t[0], t[1], t[2], from), above = volume(t[0], t[1], t[2], to);
    if ((below > 0) == (above > 0)) return false;
    const double a = volume(from, to, t[0], t[1]), b = volume(from, to, t[1], t[2]), c = volume(from, to, t[2], t[0]);
    return (a > 0 && b > 0 && c > 0) || (a < 0 && b < 0 && c < 0);
}

// `positions`: 3 a vertex; `triangles`: 3 each.
template <class Number>
std::vector<std::pair<uint32_t, uint32_t>> crossing_triangles(std::span<const Number> positions,
                                                              std::span<const uint32_t> triangles) {
    const auto count = static_cast<uint32_t>(triangles.size() / 3);
    const auto corners = [&](uint32_t i) {
        std::array<Place, 3> t;
        for (size_t k = 0; k < 3; ++k)
            for (size_t x = 0; x < 3; ++x) t[k][x] = static_cast<double>(positions[3 * triangles[3 * i + k] + x]);
        return t;
    };
    double longest = 0;
    for (uint32_t i = 0; i < count; ++i) {
        const auto t = corners(i);
        for (size_t k = 0; k < 3; ++k) {
            const Place side = from_to(t[k], t[(k + 1) % 3]);
            longest = std::max(longest, std::hypot(side[0], side[1], side[2]));
        }
    }
    // By cells as long as the longest side: what a triangle meets is in the same or the next.
    const auto cell = [&](const Place& p, int x, int y, int z) {
        const auto at = [&](double c, int step) { return static_cast<int64_t>(std::floor(c / longest)) + step; };
        return static_cast<uint64_t>(at(p[0], x) * 73856093 ^ at(p[1], y) * 19349663 ^ at(p[2], z) * 83492791);
    };
    const auto middle = [&](const std::array<Place, 3>& t) {
        return Place{(t[0][0] + t[1][0] + t[2][0]) / 3, (t[0][1] + t[1][1] + t[2][1]) / 3,
                     (t[0][2] + t[1][2] + t[2][2]) / 3};
    };
    std::unordered_map<uint64_t, std::vector<uint32_t>> in_cell;
    for (uint32_t i = 0; i < count; ++i) in_cell[cell(middle(corners(i)), 0, 0, 0)].push_back(i);
    std::vector<std::pair<uint32_t, uint32_t>> found;
    for (uint32_t i = 0; i < count; ++i) {
        const auto t = corners(i);
        for (int n = 0; n < 27; ++n) {
            const auto near = in_cell.find(cell(middle(t), n % 3 - 1, n / 3 % 3 - 1, n / 9 - 1));
            if (near == in_cell.end()) continue;
            for (const uint32_t j : near->second) {
                const uint32_t *a = &triangles[3 * i], *b = &triangles[3 * j];
                if (j <= i || std::any_of(a, a + 3, [&](uint32_t v) { return std::find(b, b + 3, v) != b + 3; }))
                    continue;
                const auto o = corners(j);
                bool cross = false;
                for (size_t k = 0; k < 3; ++k)
                    cross = cross || passes(t[k], t[(k + 1) % 3], o) || passes(o[k], o[(k + 1) % 3], t);
                if (cross) found.emplace_back(i, j);
            }
        }
    }
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
}

}  // namespace flg::test
