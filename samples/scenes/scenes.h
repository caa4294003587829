// SPDX-License-Identifier: MIT
// The built-in scene, shared by command line, benchmarks, tests and samples: style strokes with character and targets
// to put them on, all made here. Plain C++ without the SDK, so that a sample shows what a host would write itself.
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

using Color = std::array<float, 4>;  // linear RGBA

// What there is one of a point may be empty.
struct Curve {
    std::vector<Point> points;
    std::vector<float> radii;    // metres
    std::vector<float> angles;   // of a ribbon about the tangent, radians
    std::vector<Color> colors;   // in place of `color`
    std::vector<Point> normals;  // of a ribbon, unit length, perpendicular to the curve
    Color color = {1.0f, 1.0f, 1.0f, 1.0f};
    bool closed = false;
};

// loops, zigzag, curls, knots, tremor, braid; wave and knit, drawn in the plane z = 0; and with attributes: beads
// (radius, colour), twist (angle of a ribbon, radius, colour).
const std::vector<std::string>& style_names();

// The style library: those, and bubbles, clouds, fret, grass, hearts, heartbeat, leaves, ripples, rope, rosettes,
// script, scrolls, stars, thorns.
const std::vector<std::string>& library_names();

// A style of the library: an open stroke of about a metre that looks drawn by hand, with 150 to 600 points and radii.
// Empty for an unknown name.
Curve make_style(std::string_view name);

// s_curve, spiral, flourish, ring (closed), vine (closed), coaster (closed, with normals that bank), lorenz, thomas.
const std::vector<std::string>& target_names();

// A target with `count` points, 2 to 100 million; 0 = the usual number for it. The short ones are sampled more densely
// by a higher count, the attractors are followed for longer. Empty for an unknown name.
Curve make_target(std::string_view name, uint32_t count = 0);

// Curves that belong together.
struct Scene {
    std::vector<Curve> curves;
    // Curves meet at their ends: points that are the same are so bit by bit.
    bool network = false;
};

// bouquet, hair, tree (network), icosahedron (network), tower (network), flow.
const std::vector<std::string>& scene_names();

// `count` is the number of hairs or flow lines, at most 100,000; 0 = the usual number; the other scenes have but one
// size. No curves for an unknown name. Beside the names above: head and flow_ball, the tubes that hair grows on and
// flow parts around.
Scene make_scene(std::string_view name, uint32_t count = 0);

// A picture's worth of strokes: a bouquet of stems that end in volutes, with radii and colours.
std::vector<Curve> make_bouquet();

// A triangle mesh.
struct Mesh {
    std::vector<Point> vertices, normals;
    std::vector<std::array<uint32_t, 3>> triangles;
};

// A cat of blocks, 1 m long, closed and manifold: to be subdivided. No normals.
Mesh make_figure();

// figure, scalp, vase, dish, ball, egg, cloth, torus.
const std::vector<std::string>& mesh_names();

// One of those below. `count` is the vase's columns, 3 to 100,000; 0 = the usual number; the others have but one size.
// No vertices for an unknown name.
Mesh make_mesh(std::string_view name, uint32_t count = 0);

// The part of the head that hair grows on; and the head as a tube whose radius changes along its axis, for pictures.
Mesh make_scalp();
Curve make_head();

// The ball that the flow parts around, as such a tube.
Curve make_ball();

// Turned about the y axis, open above and below, of so many vertices around. The border below is loop 0, that above
// loop 1.
Mesh make_vase(uint32_t columns = 640);

// A shallow dish of five lobes, hollow side down, with a hole in its middle. Its rim is loop 0, the hole loop 1.
Mesh make_dish();

// Cubes blown up, of six faces each whose seams are vertices no further apart than this: to be welded.
constexpr float kFaceSeam = 1e-6f;
Mesh make_ball_mesh();  // radius 0.5 m
Mesh make_egg();        // a metre high, standing on its blunt end; 1.5 million triangles

// A square metre of cloth in waves, as long on all four sides. Its outline begins in the front left corner.
Mesh make_cloth();

// Lying, 0.8 m wide, of a tube half as thick as the hole; closed.
Mesh make_torus();

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
