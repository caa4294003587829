// SPDX-License-Identifier: MIT
// The built-in scene, shared by command line, benchmarks, tests and samples: style strokes with character and targets to
// put them on, all made here. Plain C++ without the SDK, so that a sample shows what a host would write itself.
//
// Everything is a function of its arguments: same name and count, same bits. Metres, right-handed, y up.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace flg::scenes {

struct Point {
    float x, y, z;
};

struct Curve {
    std::vector<Point> points;
    std::vector<float> radii;                               // one a point, metres; may be empty
    std::array<float, 4> color = {1.0f, 1.0f, 1.0f, 1.0f};  // linear RGBA
    bool closed = false;
};

// loops, zigzag, curls, knots, tremor, braid.
const std::vector<std::string>& style_names();

// An open stroke of about a metre that looks drawn by hand: 150 to 600 points, with radii. Empty for an unknown name.
Curve make_style(std::string_view name);

// s_curve, spiral, flourish, ring (closed), lorenz, thomas.
const std::vector<std::string>& target_names();

// A target with `count` points, 2 to 100 million; 0 = the usual number for it. The short ones are sampled more densely
// by a higher count, the attractors are followed for longer. Empty for an unknown name.
Curve make_target(std::string_view name, uint32_t count = 0);

// A picture's worth of strokes: a bouquet of stems that end in volutes, with radii and colours.
std::vector<Curve> make_bouquet();

// The attractors' differential equations and how their targets are scaled: for tests.
struct Attractor {
    std::array<double, 3> (*velocity)(const std::array<double, 3>& position);
    std::array<double, 3> centre;  // of the picture, in the equations' units
    double metres;                 // one of the equations' units
    double step;                   // time from one point to the next
};
const Attractor& lorenz();
const Attractor& thomas();

}  // namespace flg::scenes
