// SPDX-License-Identifier: MIT
// Drawings made by code: what people draw, for skeletons.
#pragma once

#include <array>
#include <cmath>
#include <vector>

namespace flg::test {

using Line = std::vector<std::array<double, 2>>;

// A closed Catmull-Rom curve through the points, as plain numbers.
inline std::vector<double> smooth(const Line& line) {
    constexpr int steps = 8;
    std::vector<double> points;
    const size_t n = line.size();
    for (size_t i = 0; i < n; ++i) {
        const auto &a = line[(i + n - 1) % n], &b = line[i], &c = line[(i + 1) % n], &d = line[(i + 2) % n];
        for (int k = 0; k < steps; ++k) {
            const double t = static_cast<double>(k) / steps;
            for (size_t x = 0; x < 2; ++x)
                points.push_back(
                    b[x] + 0.5 * t *
                               (c[x] - a[x] +
                                t * (2 * a[x] - 5 * b[x] + 4 * c[x] - d[x] + t * (3 * (b[x] - c[x]) + d[x] - a[x]))));
        }
    }
    return points;
}

// The right half from the top to the bottom of the axis x = 0, and its image.
inline Line with_image(const Line& right) {
    Line line = right;
    for (size_t i = right.size(); i-- > 0;)
        if (right[i][0] != 0) line.push_back({-right[i][0], right[i][1]});
    return line;
}

// Around a way of places with their radii.
inline Line tube(const std::vector<std::array<double, 3>>& way) {
    Line right, left;
    for (size_t i = 0; i < way.size(); ++i) {
        const auto &a = way[i == 0 ? 0 : i - 1], &b = way[std::min(i + 1, way.size() - 1)];
        const double length = std::hypot(b[0] - a[0], b[1] - a[1]);
        const double x = (b[1] - a[1]) / length * way[i][2], y = (b[0] - a[0]) / length * way[i][2];
        right.push_back({way[i][0] + x, way[i][1] - y});
        left.push_back({way[i][0] - x, way[i][1] + y});
    }
    right.insert(right.end(), left.rbegin(), left.rend());
    return right;
}

// Straight limbs around a disc: where they point to, in degrees, ascending, their length and widths.
struct Limb {
    double angle, length, width, tip;
};
inline Line creature(double radius, const std::vector<Limb>& limbs) {
    Line line;
    const double degree = std::acos(-1.0) / 180;
    for (size_t n = 0; n < limbs.size(); ++n) {
        const Limb& limb = limbs[n];
        const double x = std::cos(limb.angle * degree), y = std::sin(limb.angle * degree);
        const auto at = [&](double along, double across) {
            const double from = 0.9 * radius + along;
            line.push_back({from * x + across * y, from * y - across * x});
        };
        constexpr int steps = 8;
        const auto width = [&](int i) { return limb.width + (limb.tip - limb.width) * i / steps; };
        for (int i = 0; i <= steps; ++i) at(limb.length * i / steps, width(i));
        at(limb.length + limb.tip, 0);
        for (int i = steps; i >= 0; --i) at(limb.length * i / steps, -width(i));
        const double gap = std::fmod(limbs[(n + 1) % limbs.size()].angle - limb.angle + 360, 360);
        const int points = static_cast<int>(gap / 20) - 1;
        for (int k = 1; k < points; ++k) {
            const double angle = (limb.angle + gap * k / points) * degree;
            line.push_back({radius * std::cos(angle), radius * std::sin(angle)});
        }
    }
    return line;
}

inline Line person() {
    return with_image({{0, 10},      {0.7, 9.75}, {1, 9},      {0.75, 8.25}, {0.4, 7.95}, {0.5, 7.6},  {1.6, 7.4},
                       {2.4, 6.8},   {3.3, 5.4},  {4.1, 4.3},  {4.6, 3.6},   {4.35, 3.2}, {3.9, 3.6},  {3.6, 4.0},
                       {2.75, 5.1},  {1.6, 6.2},  {1.2, 4.9},  {1.5, 3.9},   {1.45, 2.1}, {1.15, 0.5}, {1.7, 0.1},
                       {1.6, -0.15}, {0.6, -0.1}, {0.65, 0.5}, {0.7, 2.0},   {0.25, 3.2}, {0, 3.35}});
}

inline Line person_without_arms() {
    return with_image({{0, 10},
                       {0.7, 9.75},
                       {1, 9},
                       {0.75, 8.25},
                       {0.4, 7.95},
                       {0.5, 7.6},
                       {1.5, 7.4},
                       {1.6, 6.5},
                       {1.2, 4.9},
                       {1.5, 3.9},
                       {1.45, 2.1},
                       {1.15, 0.5},
                       {1.7, 0.1},
                       {1.6, -0.15},
                       {0.6, -0.1},
                       {0.65, 0.5},
                       {0.7, 2.0},
                       {0.25, 3.2},
                       {0, 3.35}});
}

// Its upper end is in the trunk's middle, where the other arm's is too.
inline Line arm(double side) {
    Line line = tube({{0.2, 6.9, 0.45}, {1.5, 6.9, 0.5}, {2.6, 6.0, 0.4}, {3.4, 4.9, 0.35}, {4.4, 3.6, 0.35}});
    for (auto& point : line) point[0] *= side;
    return line;
}

inline Line hand() {
    return creature(2.6, {{15, 2.6, 0.5, 0.4},
                          {62, 3.2, 0.42, 0.36},
                          {85, 4, 0.42, 0.36},
                          {107, 3.7, 0.42, 0.36},
                          {130, 2.8, 0.4, 0.33},
                          {270, 1.8, 1.3, 1.25}});
}

inline Line octopus() {
    std::vector<Limb> arms;
    for (int i = 0; i < 8; ++i) arms.push_back({180 + 22.5 * (i + 0.5), 8, 0.42, 0.12});
    return creature(2.8, arms);
}

inline Line spider() {
    return creature(1.2, {{-55, 5, 0.17, 0.08},
                          {-20, 5, 0.17, 0.08},
                          {15, 5, 0.17, 0.08},
                          {50, 5, 0.17, 0.08},
                          {130, 5, 0.17, 0.08},
                          {165, 5, 0.17, 0.08},
                          {200, 5, 0.17, 0.08},
                          {235, 5, 0.17, 0.08}});
}

inline Line starfish() {
    std::vector<Limb> arms;
    for (int i = 0; i < 5; ++i) arms.push_back({90 + 72.0 * i, 3, 0.62, 0.2});
    return creature(1.1, arms);
}

inline Line snake() {
    std::vector<std::array<double, 3>> way;
    for (int i = 0; i <= 16; ++i) way.push_back({0.8 * i, 1.6 * std::sin(0.8 * i), 0.42 * (1 - 0.6 * i / 16)});
    return tube(way);
}

}  // namespace flg::test
