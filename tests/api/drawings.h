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

// With a head much wider than the trunk.
inline Line person_with_big_head() {
    return with_image({{0, 2.24},      {0.105, 2.225}, {0.212, 2.175}, {0.295, 2.1},   {0.353, 2},     {0.38, 1.85},
                       {0.345, 1.7},   {0.251, 1.575}, {0.075, 1.48},  {0.073, 1.45},  {0.2, 1.446},   {0.239, 1.425},
                       {0.425, 1.145}, {0.524, 0.85},  {0.5, 0.829},   {0.475, 0.836}, {0.306, 1.15},  {0.2, 1.28},
                       {0.175, 1.292}, {0.163, 1.275}, {0.117, 1.1},   {0.168, 0.9},   {0.145, 0.125}, {0.152, 0.1},
                       {0.217, 0.05},  {0.215, 0.025}, {0.175, 0},     {0.1, 0.006},   {0.06, 0.05},   {0.048, 0.55},
                       {0.029, 0.775}, {0, 0.814}});
}

// As toys are drawn: the head is the largest of it.
inline Line chibi() {
    return with_image({{0, 10},    {1.6, 9.7}, {2.6, 8.6}, {2.8, 7.2}, {2.3, 5.9}, {1.2, 5.1}, {0.7, 4.9},
                       {1.3, 4.6}, {2.2, 3.9}, {2.9, 3.1}, {2.7, 2.7}, {2.2, 2.9}, {1.4, 3.6}, {1.2, 2.6},
                       {1.4, 1.2}, {1.6, 0.2}, {1.2, 0},   {0.6, 0},   {0.5, 0.6}, {0.3, 1.4}, {0, 1.5}});
}
inline Line chibi_with_level_arms() {
    return with_image({{0, 10},    {2, 9.8},    {3.2, 8.6},  {3.5, 7},   {3, 5.4},   {1.6, 4.4}, {1.0, 4.3}, {1.6, 4.1},
                       {2.6, 4.0}, {3.4, 3.9},  {3.5, 3.5},  {3.3, 3.2}, {2.5, 3.2}, {1.5, 3.2}, {1.3, 2.2}, {1.4, 1.0},
                       {1.5, 0.1}, {1.2, -0.1}, {0.5, -0.1}, {0.4, 0.3}, {0.3, 1.0}, {0, 1.1}});
}
inline Line chibi_with_ears() {
    return with_image({{0, 9.6},   {0.9, 9.7}, {1.6, 11},  {2.3, 10.6}, {2.4, 9},   {2.9, 8.2}, {2.8, 6.9}, {2.3, 5.9},
                       {1.2, 5.1}, {0.8, 4.9}, {1.3, 4.6}, {2.2, 3.9},  {2.9, 3.1}, {2.7, 2.7}, {2.2, 2.9}, {1.4, 3.6},
                       {1.2, 2.6}, {1.4, 1.2}, {1.6, 0.2}, {1.2, 0},    {0.6, 0},   {0.5, 0.6}, {0.3, 1.4}, {0, 1.5}});
}
inline Line chibi_without_neck() {
    return with_image({{0, 8},
                       {1.5, 7.6},
                       {2, 6.4},
                       {1.8, 5.4},
                       {1.3, 4.8},
                       {2, 4.3},
                       {3.1, 3.3},
                       {3, 2.8},
                       {2.5, 2.8},
                       {1.6, 3.3},
                       {1.5, 2},
                       {1.4, 0.3},
                       {1.1, 0},
                       {0.5, 0},
                       {0.4, 0.8},
                       {0, 1.0}});
}

// With skirts whose hems are flared: to the ankles, and to the knees.
inline Line person_in_a_skirt() {
    return with_image({{0, 1.76},      {0.05, 1.751},  {0.092, 1.725}, {0.115, 1.7},   {0.137, 1.65},  {0.133, 1.575},
                       {0.065, 1.475}, {0.071, 1.45},  {0.125, 1.44},  {0.2, 1.446},   {0.239, 1.425}, {0.292, 1.325},
                       {0.375, 1.203}, {0.425, 1.145}, {0.443, 1.075}, {0.522, 0.875}, {0.524, 0.85},  {0.5, 0.829},
                       {0.475, 0.836}, {0.464, 0.85},  {0.375, 1.039}, {0.306, 1.15},  {0.2, 1.28},    {0.175, 1.292},
                       {0.154, 1.25},  {0.117, 1.1},   {0.176, 0.925}, {0.196, 0.825}, {0.373, 0.225}, {0.35, 0.2},
                       {0.175, 0.199}, {0.15, 0.179},  {0.145, 0.125}, {0.152, 0.1},   {0.2, 0.073},   {0.217, 0.05},
                       {0.215, 0.025}, {0.2, 0.007},   {0.175, 0},     {0.1, 0.006},   {0.07, 0.025},  {0.06, 0.05},
                       {0.07, 0.125},  {0.065, 0.175}, {0.05, 0.194},  {0, 0.2}});
}
inline Line person_in_a_dress() {
    return with_image({{0, 10},    {0.7, 9.75},  {1, 9},      {0.75, 8.25}, {0.4, 7.95}, {0.5, 7.6}, {1.6, 7.4},
                       {2.4, 6.6}, {3.3, 5.2},   {3.9, 4.4},  {3.6, 4.0},   {3.0, 4.6},  {1.9, 5.9}, {1.2, 6.2},
                       {1.0, 5.4}, {1.5, 4.4},   {2.2, 3.0},  {2.6, 2.4},   {1.4, 2.3},  {1.3, 1.2}, {1.25, 0.4},
                       {1.7, 0.1}, {1.6, -0.15}, {0.7, -0.1}, {0.65, 0.5},  {0.6, 1.3},  {0.5, 2.2}, {0, 2.25}});
}

inline Line thin_person() {
    return with_image({{0, 1.76},      {0.05, 1.751},  {0.092, 1.725}, {0.115, 1.7},   {0.137, 1.65},  {0.133, 1.575},
                       {0.065, 1.475}, {0.071, 1.45},  {0.1, 1.441},   {0.2, 1.441},   {0.231, 1.425}, {0.249, 1.4},
                       {0.272, 1.325}, {0.419, 1.125}, {0.429, 1.075}, {0.511, 0.875}, {0.511, 0.85},  {0.5, 0.84},
                       {0.475, 0.851}, {0.375, 1.066}, {0.324, 1.15},  {0.225, 1.277}, {0.2, 1.301},   {0.175, 1.309},
                       {0.143, 1.275}, {0.078, 1.1},   {0.093, 0.975}, {0.115, 0.9},   {0.103, 0.55},  {0.112, 0.475},
                       {0.102, 0.425}, {0.097, 0.125}, {0.106, 0.1},   {0.158, 0.075}, {0.181, 0.05},  {0.179, 0.025},
                       {0.15, 0.001},  {0.05, 0.011},  {0.026, 0.05},  {0.046, 0.125}, {0.038, 0.4},   {0.026, 0.475},
                       {0.032, 0.55},  {0.025, 0.672}, {0.015, 0.775}, {0, 0.806}});
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

// With fingers that part in points.
inline Line sharp_hand() {
    return {{0, -2.88},    {0.54, -2.65}, {0.8, -0.76},  {1.09, -0.15}, {1.1, 1.07},   {1.25, 1.31},
            {1.71, 3.2},   {1.54, 3.44},  {1.25, 3.36},  {0.7, 1.85},   {0.77, 3.78},  {0.5, 3.98},
            {0.25, 3.81},  {0.03, 2.1},   {-0.18, 3.84}, {-0.44, 4.03}, {-0.69, 3.84}, {-0.67, 1.99},
            {-1.16, 3.55}, {-1.43, 3.66}, {-1.63, 3.46}, {-1.2, 1.31},  {-1.11, 0.51}, {-1.66, 0.84},
            {-2.18, 1.45}, {-2.44, 1.44}, {-2.58, 1.19}, {-2.14, 0.38}, {-0.8, -0.76}, {-0.67, -2.4}};
}

// With a palm that is not round, and a wrist.
inline Line open_hand() {
    return {{-0.073, -1.17}, {0.03, -1.178},  {0.144, -1.14}, {0.214, -1.08},  {0.27, -0.973}, {0.3, -0.513},
            {0.381, -0.48},  {0.41, 0.18},    {0.55, 1.05},   {0.515, 1.11},   {0.48, 1.12},   {0.417, 1.08},
            {0.27, 0.443},   {0.24, 0.394},   {0.223, 0.45},  {0.227, 1.32},   {0.18, 1.367},  {0.112, 1.35},
            {0.089, 1.29},   {0.027, 0.42},   {0, 0.379},     {-0.027, 0.42},  {-0.09, 1.351}, {-0.12, 1.407},
            {-0.15, 1.419},  {-0.21, 1.398},  {-0.23, 1.35},  {-0.221, 0.42},  {-0.24, 0.365}, {-0.276, 0.39},
            {-0.433, 1.17},  {-0.451, 1.2},   {-0.51, 1.219}, {-0.567, 1.17},  {-0.443, 0.21}, {-0.441, 0.06},
            {-0.48, 0.067},  {-0.645, 0.18},  {-0.865, 0.48}, {-0.93, 0.483},  {-0.97, 0.42},  {-0.801, 0.03},
            {-0.426, -0.27}, {-0.401, -0.48}, {-0.3, -0.513}, {-0.265, -0.99}, {-0.185, -1.11}};
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
