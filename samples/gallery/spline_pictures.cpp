// SPDX-License-Identifier: MIT
// Splines on surfaces, after figures 1, 2, 7, 8 and 17 of Hofer, Pottmann: Energy-minimizing splines in manifolds
// (2004), on shapes made here.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "gallery/forms.h"
#include "gallery/looks.h"
#include "gallery/pictures.h"
#include "gallery/spline_forms.h"
#include "support/curve_source.h"

namespace flg::gallery {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;
constexpr glm::vec3 kFromTheFront = {-0.35f, -0.40f, -1.0f};

// A curve with balls where it was given.
void show(Stage& stage, const filigree::Spline& curve, const glm::vec3& color, float radius, double height = 0) {
    stage.curve(nodes_of(curve, height), color, radius, curve.view().closed != 0);
    stage.dots(given_of(curve, height), kPearl, 1.9f * radius);
}

// ---- Fig. 1

// A band bent into a horseshoe, and up and down.
glm::dvec3 on_band(double u, double v) {
    const double angle = 5.2 * (u - 0.5), radius = 0.30 + 0.42 * v;
    return {radius * std::sin(angle), 0.13 * std::cos(2.2 * angle) * (0.4 + v), -radius * std::cos(angle)};
}

void meshes(Workshop& workshop, Studio& studio) {
    Stage whole(workshop, {-0.55f, -0.30f, -1.0f}), open(workshop, {-0.15f, -0.85f, -1.0f});
    filigree::Surface figure = cat(workshop);
    const filigree::Manifold body = manifold_of(workshop, figure);
    FlgSplineDesc desc = flgSplineDefaults();
    desc.manifold = body.get();
    desc.closed = 1;
    Points girth, collar;
    for (int i = 0; i < 5; ++i) {
        const double angle = kTurn * (i + 0.3) / 5;
        girth.emplace_back(0.22 - 0.07 * std::cos(2 * angle), 0.30 + 0.12 * std::cos(angle),
                           0.15 + 0.20 * std::sin(angle));
        collar.emplace_back(0.5 + 0.2 * std::cos(angle), 0.45, 0.15 + 0.25 * std::sin(angle));
    }
    show(whole, spline(workshop, girth, desc), kRed, 0.0075f);
    show(whole, spline(workshop, collar, desc), kBlue, 0.0075f);
    desc.closed = 0;
    const Points along = {{-0.15, 0.66, 0.20}, {-0.13, 0.42, 0.21}, {0.04, 0.28, 0.30}, {0.34, 0.34, 0.30},
                          {0.47, 0.60, 0.30},  {0.62, 0.66, 0.28},  {0.78, 0.55, 0.20}};
    show(whole, spline(workshop, along, desc), kGold, 0.0075f);
    whole.surface(std::move(figure), kSlate);

    filigree::Surface band = surface_of(workshop, sheet(320, 60, false, on_band));
    const filigree::Manifold manifold = manifold_of(workshop, band);
    FlgObstacle border = flgObstacleDefaults();
    border.kind = FLG_OBSTACLE_KIND_BORDER;
    border.surface = band.get();
    const filigree::Obstacles beyond = obstacles_of(workshop, {&border, 1}, 3);
    desc = flgSplineDefaults();
    desc.manifold = manifold.get();
    desc.obstacles = beyond.get();
    const Points across = {on_band(0.05, 0.8), on_band(0.5, 0.75), on_band(0.95, 0.8)};
    show(open, spline(workshop, across, desc), kRed, 0.010f);
    const Points waves = {on_band(0.03, 0.3),  on_band(0.2, 0.93), on_band(0.38, 0.07),
                          on_band(0.62, 0.93), on_band(0.8, 0.07), on_band(0.97, 0.6)};
    show(open, spline(workshop, waves, desc), kGold, 0.010f);
    open.surface(std::move(band), kSlate);
    std::vector<Panel> panels = {whole.panel, open.panel};
    entitle(panels, {"On a closed mesh", "On a mesh with borders"});
    studio.take("spline_meshes", panels, 2, kWidth, 440);
}

// ---- Fig. 2 and 7

// A jar: turned about the y axis, the parameters angle and height.
struct Jar {
    static constexpr double kHeight = 1.1, kRadius = 0.40, kSwell = 0.11, kWaves = 5.6, kPhase = -0.4;
    static void evaluate(void* /*user_data*/, double u, double v, double* out) {
        const double angle = kTurn * u, c = std::cos(angle), s = -std::sin(angle), w = kWaves * v + kPhase;
        const double r = kRadius + kSwell * std::sin(w), r1 = kWaves * kSwell * std::cos(w),
                     r2 = -kWaves * kWaves * kSwell * std::sin(w);
        // The derivatives of (c, s) by u are kTurn (s, -c).
        const double rows[6][3] = {{r * c, kHeight * v, r * s},
                                   {kTurn * r * s, 0, -kTurn * r * c},
                                   {r1 * c, kHeight, r1 * s},
                                   {-kTurn * kTurn * r * c, 0, -kTurn * kTurn * r * s},
                                   {kTurn * r1 * s, 0, -kTurn * r1 * c},
                                   {r2 * c, 0, r2 * s}};
        for (int i = 0; i < 18; ++i) out[i] = rows[i / 3][i % 3];
    }
    static glm::dvec3 at(double u, double v) {
        double row[18];
        evaluate(nullptr, u, v, row);
        return {row[0], row[1], row[2]};
    }
};

filigree::Manifold jar(Workshop& workshop) {
    FlgPatchFunctions functions = flgPatchFunctionsDefaults();
    functions.periodic[0] = 1;
    functions.evaluate = Jar::evaluate;
    FlgManifold manifold{};
    filigree::check(flgManifoldCreatePatch(workshop.context().get(), &functions, &manifold));
    return {workshop.context().get(), manifold};
}

filigree::Surface jar_surface(Workshop& workshop) {
    return surface_of(workshop, sheet(360, 240, true, Jar::at));
}

// Fourth derivatives between given points, by differences of nodes, which are at even parameters there.
void fourth_derivatives(Stage& stage, const filigree::Spline& curve) {
    constexpr double kLongest = 0.20;
    constexpr uint32_t kEvery = 2, kReach = 2;
    const FlgSplineView view = curve.view();
    const Points x = nodes_of(curve);
    std::vector<Points> normals, vectors;
    double largest = 0;
    for (uint32_t segment = 0; segment + 1 < view.point_count; ++segment) {
        for (uint32_t i = view.point_nodes[segment] + kReach; i + kReach <= view.point_nodes[segment + 1];
             i += kEvery) {
            const double step = view.parameters[i + 1] - view.parameters[i];
            const glm::dvec3 fourth =
                (x[i - 2] - 4.0 * x[i - 1] + 6.0 * x[i] - 4.0 * x[i + 1] + x[i + 2]) / std::pow(step, 4);
            const float* const n = view.normals + size_t{3} * i;
            normals.push_back({x[i], x[i] + kLongest * glm::dvec3(n[0], n[1], n[2])});
            vectors.push_back({x[i], fourth});
            largest = std::max(largest, glm::length(fourth));
        }
    }
    for (Points& line : vectors) line[1] = line[0] + kLongest / largest * line[1];
    stage.lines(normals, kYellow, 0.0022f);
    stage.lines(vectors, kBlue, 0.0050f);
}

void energies(Workshop& workshop, Studio& studio) {
    const filigree::Manifold manifold = jar(workshop);
    Stage forces(workshop, kFromTheFront), compared(workshop, kFromTheFront);
    FlgSplineDesc desc = flgSplineDefaults();
    desc.manifold = manifold.get();
    const Points wide = {Jar::at(-0.50, 0.30), Jar::at(-0.30, 0.62), Jar::at(-0.12, 0.36), Jar::at(0.05, 0.72)};
    const filigree::Spline first = spline(workshop, wide, desc);
    fourth_derivatives(forces, first);
    for (Layer& layer : forces.panel.layers) layer.look.casts_shadow = false;  // arrows would streak the jar
    show(forces, first, kRed, 0.010f);
    const Points zigzag = {Jar::at(-0.42, 0.22), Jar::at(-0.36, 0.66), Jar::at(-0.22, 0.70),
                           Jar::at(-0.19, 0.28), Jar::at(-0.07, 0.24), Jar::at(-0.01, 0.72)};
    const filigree::Spline e2 = spline(workshop, zigzag, desc);
    desc.energy = FLG_SPLINE_ENERGY_ET;
    desc.tension = 90;
    const filigree::Spline et = spline(workshop, zigzag, desc);
    desc.energy = FLG_SPLINE_ENERGY_E1;
    const filigree::Spline e1 = spline(workshop, zigzag, desc);
    compared.curve(nodes_of(e2), kBlue, 0.009f);
    compared.curve(nodes_of(et), kRed, 0.009f);
    compared.curve(nodes_of(e1), kGreen, 0.009f);
    compared.dots(given_of(e2), kPearl, 0.020f);
    for (Stage* stage : {&forces, &compared}) stage->surface(jar_surface(workshop), kSand);
    std::vector<Panel> panels = {forces.panel, compared.panel};
    aim_together(panels);
    for (Panel& panel : panels) panel.margin = 1.20f;  // below the keys
    panels[0].keys = {{kRed, "spline"}, {kYellow, "normals of the surface"}, {kBlue, "fourth derivative"}};
    entitle(panels, {"Least E2: its fourth derivative is normal", "Three energies, the same points"});
    panels[1].keys = {{kBlue, "least E2"}, {kRed, "least Et"}, {kGreen, "least E1"}};
    studio.take("spline_energies", panels, 2, kWidth, 560);
}

// A line by a hand that trembles.
Points trembling() {
    constexpr int kCount = 260;
    constexpr double kTremor = 0.011;
    uint32_t state = 12345;
    const auto noise = [&] {
        state = 1664525u * state + 1013904223u;
        return kTremor * (2.0 * (state >> 8) / 16777216.0 - 1.0);
    };
    Points points;
    for (int i = 0; i < kCount; ++i) {
        const double t = i / (kCount - 1.0);
        glm::dvec3 p = Jar::at(-0.48 + 0.50 * t + 0.05 * std::sin(3 * kTurn * t), 0.5 + 0.26 * std::cos(3 * kTurn * t));
        for (int c = 0; c < 3; ++c) p[c] += noise();
        points.push_back(p);
    }
    return points;
}

void smoothing(Workshop& workshop, Studio& studio) {
    const filigree::Manifold manifold = jar(workshop);
    const Points drawn = trembling();
    std::vector<double> curve;
    std::vector<uint32_t> knots;
    for (uint32_t i = 0; i < drawn.size(); ++i) {
        curve.insert(curve.end(), {drawn[i].x, drawn[i].y, drawn[i].z});
        knots.push_back(i);
    }
    FlgSplineDesc desc = flgSplineDefaults();
    desc.manifold = manifold.get();
    desc.curve = curve.data();
    desc.curve_knots = knots.data();
    desc.curve_count = static_cast<uint32_t>(drawn.size());
    // As it was drawn, then two weights of the points.
    std::deque<Stage> stages;
    for (const double smoothing : {1e-12, 2e-6, 3e-4}) {
        desc.smoothing = smoothing;
        desc.max_rounds = 4;
        Stage& stage = stages.emplace_back(workshop, kFromTheFront);
        stage.curve(nodes_of(spline(workshop, drawn, desc)), kRed, 0.0095f);
        stage.surface(jar_surface(workshop), kSlate);
    }
    std::vector<Panel> panels;
    for (const Stage& stage : stages) panels.push_back(stage.panel);
    entitle(panels, {"As drawn", "Smoothed a little", "Smoothed more"});
    studio.take("spline_smoothing", panels, 3, kWidth, 400);
}

// ---- Fig. 8

// Eight lumps joined to a cube, half a metre each way.
double lumps(const glm::dvec3& p) {
    const glm::dvec3 s = 4.4 * p * (4.4 * p);
    return s.x * s.x + s.y * s.y + s.z * s.z - 5 * (s.x + s.y + s.z) + 11.6;
}

// Two rings that run together, one lying, one standing.
double rings(const glm::dvec3& p) {
    constexpr double kRadius = 0.30, kTube = 0.105, kSoft = 0.06, kApart = 0.24;
    const double lying = std::hypot(std::hypot(p.x + kApart, p.z) - kRadius, p.y) - kTube,
                 standing = std::hypot(std::hypot(p.x - kApart, p.y) - kRadius, p.z) - kTube,
                 share = std::clamp(0.5 + 0.5 * (standing - lying) / kSoft, 0.0, 1.0);
    return standing + share * (lying - standing) - kSoft * share * (1 - share);
}

void implicit_and_cloud(Workshop& workshop, Studio& studio) {
    Stage left(workshop, {-0.55f, -0.45f, -1.0f}), right(workshop, {-0.40f, -0.75f, -1.0f});
    Solid cube = solid(workshop, 0.62, 110, lumps);
    FlgSplineDesc desc = flgSplineDefaults();
    desc.manifold = cube.manifold.get();
    desc.closed = 1;
    Points corners;
    for (const int corner : {0, 1, 3, 2, 6, 7, 5, 4})
        corners.push_back(0.5 * glm::dvec3(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1));
    show(left, spline(workshop, corners, desc), kRed, 0.012f);
    left.surface(std::move(cube.surface), kSlate);

    const Solid both = solid(workshop, 0.75, 130, rings);
    const FlgMeshView& mesh = both.surface.view().mesh;
    std::vector<float> cloud;
    Points places;
    for (uint32_t i = 0; i < mesh.vertex_count; ++i) {
        const float* const p = samples::value_at(mesh.columns[0], i);
        cloud.insert(cloud.end(), p, p + 3);
        places.emplace_back(p[0], p[1], p[2]);
    }
    FlgManifoldFromPointsDesc points = flgManifoldFromPointsDefaults();
    points.points = cloud.data();
    points.point_count = static_cast<uint32_t>(places.size());
    const filigree::Manifold manifold = workshop.finished(workshop.context().manifold_from_points(points));
    desc.manifold = manifold.get();
    Points around;
    for (int i = 0; i < 8; ++i) {
        const double angle = kTurn * (i + 0.5) / 8, radius = i % 2 == 0 ? 0.36 : 0.27;
        around.emplace_back(-0.24 + radius * std::cos(angle), 0.11, radius * std::sin(angle));
    }
    show(right, spline(workshop, around, desc), kRed, 0.011f, 0.005);
    Points upright;
    for (int i = 0; i < 7; ++i) {
        const double angle = kTurn * (i + 0.35) / 7;
        upright.emplace_back(0.24 + 0.33 * std::cos(angle), 0.33 * std::sin(angle), i % 2 == 0 ? 0.09 : 0.04);
    }
    show(right, spline(workshop, upright, desc), kGold, 0.011f, 0.005);
    right.dots(places, kSlate, 0.0052f);
    std::vector<Panel> panels = {left.panel, right.panel};
    entitle(panels, {"On an implicit surface", "On a cloud of points"});
    studio.take("spline_implicit", panels, 2, kWidth, 480);
}

// ---- Fig. 17

constexpr double kBank = 0.22, kBend = 5.2;

// A terrace whose edge winds.
glm::dvec3 on_terrace(double u, double v) {
    const double x = 1.5 * (u - 0.5), z = 0.45 - 0.9 * v;
    return {x, -0.10 * std::tanh((z - kBank * std::sin(kBend * x)) / 0.022), z};
}

void features(Workshop& workshop, Studio& studio) {
    filigree::Surface terrace = surface_of(workshop, sheet(420, 260, false, on_terrace));
    const filigree::Manifold plain = manifold_of(workshop, terrace);
    FlgManifold image{};
    filigree::check(flgManifoldCreateImage(workshop.context().get(), plain.get(), 0.35, &image));
    const filigree::Manifold sensitive(workshop.context().get(), image);
    // Behind the edge, at its ends and where it comes back.
    Points points;
    for (const double x : {-0.60, 0.0, 0.60}) points.emplace_back(x, 0.10, kBank * std::sin(kBend * x) - 0.055);
    Stage stage(workshop, {-0.15f, -0.75f, -1.0f});
    FlgSplineDesc desc = flgSplineDefaults();
    desc.manifold = plain.get();
    show(stage, spline(workshop, points, desc), kBlue, 0.009f);
    desc.manifold = sensitive.get();
    show(stage, spline(workshop, points, desc), kRed, 0.009f);
    stage.surface(std::move(terrace), kSand);
    stage.panel.keys = {{kBlue, "ignores the edge"}, {kRed, "follows the edge"}};
    studio.take("spline_features", {&stage.panel, 1}, 1, kWidth, 500);
}

constexpr Picture kPictures[] = {
    {"spline_meshes", "Fig. 1: splines on a closed mesh and on one with borders", true, meshes},
    {"spline_energies", "Fig. 2: fourth derivatives along the normals; E2, Et and E1", true, energies},
    {"spline_smoothing", "Fig. 7: a trembling line, made fair", true, smoothing},
    {"spline_implicit", "Fig. 8: splines on an implicit surface and on a point cloud", true, implicit_and_cloud},
    {"spline_features", "Fig. 17: a spline, and one in the image manifold of normals", true, features},
};

}  // namespace

std::span<const Picture> spline_pictures() {
    return kPictures;
}

}  // namespace flg::gallery
