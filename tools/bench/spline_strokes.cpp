// SPDX-License-Identifier: MIT
// Strokes as people draw them on meshes as people have them: whether there is a curve, whether it comes to rest, how
// smooth it is, and what it costs.
#include <algorithm>
#include <cmath>

#include "bench/splines.h"
#include "core/random.h"
#include "core/vec.h"

namespace flg::bench {
namespace {

constexpr uint32_t kStrokes = 30, kNodes = 289;
constexpr double kStep = 0.1;     // of the diagonal, from point to point
constexpr double kMaxTurn = 45;   // degrees from node to node, of a curve that can be used
constexpr uint32_t kMaxHeld = 3;  // nodes, of a curve that has come to rest
constexpr double kConverged = 97, kUsable = 95, kMedianMs = 10, kHighMs = 20;

Vec3 vertex(const MeshArrays& mesh, size_t v) {
    return Vec3(mesh.positions[3 * v], mesh.positions[3 * v + 1], mesh.positions[3 * v + 2]);
}

// 5 to 12 vertices, about a step apart, on a way that winds a little.
std::vector<double> stroke(const MeshArrays& mesh, uint64_t seed, double step) {
    const auto count = static_cast<uint32_t>(mesh.positions.size() / 3), length = 5 + random_below(seed, 0, 0, 8);
    uint32_t at = random_below(seed, 1, 0, count), draws = 0;
    const auto random_vector = [&] {
        Vec3 v;
        for (double& c : v) c = 2 * random_unit(seed, 2, draws++) - 1;
        return v;
    };
    Vec3 way = random_vector().normalized();
    std::vector<double> points;
    for (uint32_t i = 0; i < length; ++i) {
        const Vec3 from = vertex(mesh, at);
        points.insert(points.end(), {from.x(), from.y(), from.z()});
        const Vec3 goal = from + step * (way + 0.3 * random_vector()).normalized();
        double nearest = HUGE_VAL;
        for (uint32_t v = 0; v < count; ++v) {
            const Vec3 place = vertex(mesh, v);
            const double away = (place - goal).squaredNorm();
            if (away >= nearest || (place - from).norm() < 0.6 * step) continue;
            nearest = away;
            at = v;
        }
        way = (vertex(mesh, at) - from).normalized();
    }
    return points;
}

double largest_turn(const FlgSplineView& view) {
    double largest = 0;
    const auto node = [&](uint32_t i) { return Vec3(view.nodes + size_t{3} * i); };
    for (uint32_t i = 1; i + 1 < view.node_count; ++i) {
        const Vec3 before = node(i) - node(i - 1), after = node(i + 1) - node(i);
        largest = std::max(largest, std::atan2(before.cross(after).norm(), before.dot(after)));
    }
    return largest * 180 / std::acos(-1.0);
}

std::vector<Row> stroke_rows(const std::string& name, const MeshArrays& mesh, double smoothing_scale) {
    SplineBench bench(mesh);
    bench.see_through(smoothing_scale);
    bench.make_manifold();
    Vec3 lower = vertex(mesh, 0), upper = lower;
    for (size_t v = 0; v < mesh.positions.size() / 3; ++v) {
        lower = lower.cwiseMin(vertex(mesh, v));
        upper = upper.cwiseMax(vertex(mesh, v));
    }
    uint32_t converged = 0, usable = 0, max_held = 0;
    std::vector<double> times;
    for (uint64_t seed = 0; seed < kStrokes; ++seed) {
        const std::vector<double> points = stroke(mesh, seed, kStep * (upper - lower).norm());
        FlgSplineDesc desc = bench.desc(points);
        desc.node_count = kNodes;
        FlgSpline spline{};
        FlgSplineView view{};
        times.push_back(bench.spline_ms(desc, view, &spline));
        converged += view.ending == FLG_SPLINE_ENDING_CONVERGED && view.held_count <= kMaxHeld ? 1 : 0;
        usable += largest_turn(view) <= kMaxTurn ? 1 : 0;
        max_held = std::max(max_held, view.held_count);
        check(flgSplineRelease(bench.host().context(), spline));
    }
    std::sort(times.begin(), times.end());
    const std::string strokes = name + ", " + std::to_string(kStrokes) + " strokes: ";
    return {
        at_least(strokes + "come to rest", 100.0 * converged / kStrokes, "%", kConverged,
                 "at most " + std::to_string(max_held) + " nodes held"),
        at_least(strokes + "no turn over 45 degrees", 100.0 * usable / kStrokes, "%", kUsable),
        below(strokes + "median", times[kStrokes / 2], "ms", kMedianMs),
        below(strokes + "90 of 100", times[kStrokes * 9 / 10], "ms", kHighMs),
    };
}

}  // namespace

std::vector<Row> spline_strokes() {
    std::vector<Row> rows;
    const auto append = [&](const std::string& name, const MeshArrays& mesh, double smoothing_scale) {
        const std::vector<Row> more = stroke_rows(name, mesh, smoothing_scale);
        rows.insert(rows.end(), more.begin(), more.end());
    };
    const MeshArrays ground = rough_ground(100'000);
    MeshArrays scan = bumpy_torus(70'000);
    add_noise(scan, 0.3);
    append("rough ground", ground, 0);
    append("rough ground through 2 cm", ground, 0.02);
    append("noisy torus", scan, 0);
    append("noisy torus through 5 cm", scan, 0.05);
    append("torus with bumps", bumpy_torus(70'000), 0);
    return rows;
}

}  // namespace flg::bench
