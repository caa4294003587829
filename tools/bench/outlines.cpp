// SPDX-License-Identifier: MIT
#include "bench/outlines.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "bench/host.h"
#include "bench/meshes.h"
#include "core/random.h"
#include "filigree/filigree_model.h"

namespace flg::bench {
namespace {

// Strokes of width 2, heights of 10.
std::vector<Ring> letters() {
    return {
        {{0, 0}, {2, 0}, {2, 10}, {0, 10}},                                                                    // I
        {{0, 0}, {6, 0}, {6, 2}, {2, 2}, {2, 10}, {0, 10}},                                                    // L
        {{3, 0}, {5, 0}, {5, 8}, {8, 8}, {8, 10}, {0, 10}, {0, 8}, {3, 8}},                                    // T
        {{3.5, 0}, {4.5, 0}, {8, 10}, {6, 10}, {4, 3.5}, {2, 10}, {0, 10}},                                    // V
        {{0, 0}, {7, 0}, {7, 2}, {2.6, 2}, {7, 8.2}, {7, 10}, {0, 10}, {0, 8}, {4.4, 8}, {0, 1.8}},            // Z
        {{0, 0}, {2, 0}, {2, 6.2}, {6, 0}, {8, 0}, {8, 10}, {6, 10}, {6, 3.8}, {2, 10}, {0, 10}},              // N
        {{3, 0}, {5, 0}, {5, 4}, {8, 10}, {6, 10}, {4, 6}, {2, 10}, {0, 10}, {3, 4}},                          // Y
        {{0, 0}, {2, 0}, {2, 4}, {5, 4}, {5, 6}, {2, 6}, {2, 8}, {6, 8}, {6, 10}, {0, 10}},                    // F
        {{0, 0}, {6, 0}, {6, 2}, {2, 2}, {2, 4}, {5, 4}, {5, 6}, {2, 6}, {2, 8}, {6, 8}, {6, 10}, {0, 10}},    // E
        {{0, 0}, {2, 0}, {2, 4}, {5, 4}, {5, 0}, {7, 0}, {7, 10}, {5, 10}, {5, 6}, {2, 6}, {2, 10}, {0, 10}},  // H
        {{0, 0},
         {2.2, 0},
         {4, 3.3},
         {5.8, 0},
         {8, 0},
         {5.1, 5},
         {8, 10},
         {5.8, 10},
         {4, 6.7},
         {2.2, 10},
         {0, 10},
         {2.9, 5}},  // X
        {{0, 0},
         {2, 0},
         {2, 3},
         {3, 4.3},
         {5.6, 0},
         {8, 0},
         {4.4, 5.8},
         {8, 10},
         {5.4, 10},
         {2, 5.8},
         {2, 10},
         {0, 10}},  // K
        {{0, 0},
         {2, 0},
         {2, 6},
         {4.5, 2},
         {5.5, 2},
         {8, 6},
         {8, 0},
         {10, 0},
         {10, 10},
         {8, 10},
         {5, 5.4},
         {2, 10},
         {0, 10}},  // M
    };
}

// With round corners, each of an arc between its edges.
Ring rounded(const Ring& ring, double radius, uint32_t steps) {
    Ring out;
    for (size_t i = 0; i < ring.size(); ++i) {
        const Point2 &a = ring[(i + ring.size() - 1) % ring.size()], &b = ring[i], &c = ring[(i + 1) % ring.size()];
        const auto beside = [&](const Point2& to) {
            const double share = radius / std::hypot(to.x - b.x, to.y - b.y);
            return Point2{b.x + share * (to.x - b.x), b.y + share * (to.y - b.y)};
        };
        const Point2 from = beside(a), to = beside(c);
        for (uint32_t k = 0; k <= steps; ++k) {
            const double t = static_cast<double>(k) / steps, u = 1 - t;
            out.push_back(
                {u * u * from.x + 2 * u * t * b.x + t * t * to.x, u * u * from.y + 2 * u * t * b.y + t * t * to.y});
        }
    }
    return out;
}

// An island: middles of its sides are moved at random, in or out, again and again, by less than half their distance
// from it; sides of a round island seen from its middle stay in their order, so none cross.
Ring coastline(uint64_t seed, uint32_t begin, uint32_t rounds) {
    std::vector<double> radii;
    for (uint32_t i = 0; i < begin; ++i) radii.push_back(0.6 + 0.8 * random_unit(seed, i, 0));
    double height = 0.35;
    for (uint32_t round = 1; round <= rounds; ++round, height *= 0.55) {
        std::vector<double> finer;
        for (size_t i = 0; i < radii.size(); ++i) {
            const double middle = (radii[i] + radii[(i + 1) % radii.size()]) / 2;
            finer.push_back(radii[i]);
            finer.push_back(middle * (1 + height * (2 * random_unit(seed, i, round) - 1)));
        }
        radii = std::move(finer);
    }
    Ring ring;
    for (size_t i = 0; i < radii.size(); ++i) {
        const double angle = 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(radii.size());
        ring.push_back({1.6 * radii[i] * std::cos(angle), radii[i] * std::sin(angle)});
    }
    return ring;
}

// What a mesh covers, seen from a direction: ring 0 of its outline.
Ring silhouette(const MeshArrays& mesh, const float (&direction)[3]) {
    Host host;
    FlgColumn column{};
    const FlgMeshView view = mesh.view(column);
    FlgSurfaceDesc desc = flgSurfaceDefaults();
    desc.mesh = &view;
    FlgOutlineDesc of_outline = flgOutlineDefaults();
    check(flgSurfaceCreate(host.context(), &desc, &of_outline.surface, nullptr));
    std::copy(std::begin(direction), std::end(direction), of_outline.direction);
    FlgOutline outline{};
    check(flgOutlineCreate(host.context(), &of_outline, &outline, nullptr));
    host.run();
    FlgOutlineView found = flgOutlineViewDefaults();
    check(flgOutlineGetView(host.context(), outline, &found));
    Ring ring;
    for (uint32_t i = 0; i < found.contour->ring_offsets[1]; ++i)
        ring.push_back({found.contour->points[2 * i], found.contour->points[2 * i + 1]});
    return ring;
}

}  // namespace

std::vector<OutlineClass> outline_classes() {
    std::vector<Ring> rings = letters();
    for (const Ring& letter : letters())
        for (const uint32_t steps : {3u, 24u}) rings.push_back(rounded(letter, 0.45, steps));
    for (uint64_t seed = 1; seed <= 4; ++seed)
        for (const uint32_t rounds : {3u, 5u, 8u}) rings.push_back(coastline(seed, 8, rounds));
    for (const uint32_t triangles : {1'500u, 400'000u}) {
        rings.push_back(silhouette(bumpy_torus(triangles), {0.2f, 1, 0.3f}));
        rings.push_back(silhouette(wavy_torus(triangles, 0.03), {1, 0.3f, 0.1f}));
    }
    std::vector<OutlineClass> classes = {
        {"below 15 points", {}}, {"15 to 99 points", {}}, {"100 to 999 points", {}}, {"1,000 points and more", {}}};
    for (Ring& ring : rings) {
        const size_t n = ring.size();
        classes[n < 15 ? 0 : n < 100 ? 1 : n < 1000 ? 2 : 3].rings.push_back(std::move(ring));
    }
    return classes;
}

}  // namespace flg::bench
