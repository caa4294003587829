// SPDX-License-Identifier: MIT
#include "inflation/part_mesh.h"

#include <gtest/gtest.h>

#include <map>

#include "core/random.h"
#include "inflation/shapes.h"

namespace flg::test {
namespace {

struct Quality {
    double min_angle = 180, mean_least = 0, area = 0;
    int euler = 0;
    uint32_t chords = 0, bad_edges = 0;
};

Quality quality_of(const InflatedPart& part) {
    Quality quality;
    std::map<std::pair<uint32_t, uint32_t>, int> edges;
    for (const TriangleVertices& t : part.triangles) {
        double least = 180;
        for (uint32_t k = 0; k < 3; ++k) {
            const Point2 &a = part.points[t[k]], &b = part.points[t[(k + 1) % 3]], &c = part.points[t[(k + 2) % 3]];
            const double cross = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
            const double dot = (b.x - a.x) * (c.x - a.x) + (b.y - a.y) * (c.y - a.y);
            least = std::min(least, std::atan2(cross, dot) * 180 / std::numbers::pi);
            if (k == 0) quality.area += cross / 2;
            if (!edges.emplace(std::pair{t[k], t[(k + 1) % 3]}, 1).second) ++quality.bad_edges;
        }
        quality.min_angle = std::min(quality.min_angle, least);
        quality.mean_least += least / static_cast<double>(part.triangles.size());
    }
    size_t sides = 0;
    for (const auto& [edge, one] : edges) {
        const bool inner = edges.contains({edge.second, edge.first});
        sides += inner ? 1 : 2;
        if (inner && part.on_border[edge.first] && part.on_border[edge.second]) ++quality.chords;
        if (!inner && !(part.on_border[edge.first] && part.on_border[edge.second])) ++quality.bad_edges;
    }
    quality.euler =
        static_cast<int>(part.points.size()) - static_cast<int>(sides / 2) + static_cast<int>(part.triangles.size());
    return quality;
}

double area_of(const Rings& rings) {
    double area = 0;
    const Contour contour = contour_of(rings);
    for (uint32_t i = 0; i < contour.size(); ++i) {
        const Point2 &a = contour.points[i], &b = contour.points[contour.next(i)];
        area += (a.x * b.y - a.y * b.x) / 2;
    }
    return area;
}

Ring blob(uint64_t seed, uint32_t n) {
    Ring ring;
    for (uint32_t i = 0; i < n; ++i) {
        const double angle = 2 * std::numbers::pi * i / n;
        double radius = 100;
        for (uint32_t k = 2; k < 6; ++k)
            radius +=
                40.0 / k * (random_unit(seed, k, 0) - 0.5) * 2 * std::sin(k * angle + 6.28 * random_unit(seed, k, 1));
        ring.push_back({radius * std::cos(angle), radius * std::sin(angle)});
    }
    return ring;
}

TEST(PartMesh, SmoothContoursGetGoodTriangles) {
    std::vector<Rings> all = {{ellipse(0, 0, 1, 1)}, {ellipse(5, 5, 300, 80, 300)}, {capsule(0, 0, 1, 8, 2, 0.7)}};
    for (uint64_t seed = 0; seed < 20; ++seed) all.push_back({blob(seed, 400)});
    for (const Rings& rings : all) {
        const InflatedPart part = mesh_of(rings);
        const Quality quality = quality_of(part);
        EXPECT_GT(quality.min_angle, 22);
        EXPECT_GT(quality.mean_least, 48);
        EXPECT_EQ(quality.euler, 1);
        EXPECT_EQ(quality.chords, 0u);
        EXPECT_EQ(quality.bad_edges, 0u);
        EXPECT_NEAR(quality.area, area_of(rings), 0.01 * quality.area);
        EXPECT_GT(part.points.size(), 350u);
        EXPECT_LT(part.points.size(), 4000u);
    }
}

TEST(PartMesh, HolesStayOpen) {
    const Rings rings = {ellipse(0, 0, 2, 2), ellipse(0.6, 0, 0.7, 0.7), ellipse(-1, 0.5, 0.4, 0.4)};
    const Quality quality = quality_of(mesh_of(rings));
    EXPECT_EQ(quality.euler, -1);
    EXPECT_EQ(quality.chords, 0u);
    EXPECT_EQ(quality.bad_edges, 0u);
    EXPECT_NEAR(quality.area, area_of(rings), 0.01 * quality.area);
}

// Corners, needles and strips that are narrower than the spacing.
TEST(PartMesh, NoChordsAnywhere) {
    const std::vector<Rings> all = {
        {{{0, 0}, {1, 0}, {0, 1}}},
        {{{0, 0}, {10, 0}, {10, 10}, {0, 10}}},
        {{{0, 0}, {100, 0}, {100, 1}, {0, 1}}},
        {{{0, 0}, {10, 0}, {10, 0.01}, {5, 0.01}, {5, 5}, {4, 5}, {4, 0.01}, {0, 0.01}}},
        {{{0, 0}, {10, 1e-6}, {0.01, 3}}},
        {{{0, 0}, {4, 0}, {4, 4}, {3, 4}, {3, 1}, {1, 1}, {1, 4}, {0, 4}}},
    };
    for (const Rings& rings : all) {
        const Quality quality = quality_of(mesh_of(rings));
        EXPECT_EQ(quality.euler, 1);
        EXPECT_EQ(quality.chords, 0u);
        EXPECT_EQ(quality.bad_edges, 0u);
        EXPECT_GT(quality.min_angle, 0);
        EXPECT_NEAR(quality.area, area_of(rings), 0.01 * quality.area);
    }
}

TEST(PartMesh, NoisyContours) {
    for (uint64_t seed = 0; seed < 30; ++seed) {
        Ring ring;
        const uint32_t n = 20 + random_below(seed, 0, 0, 400);
        for (uint32_t i = 0; i < n; ++i) {
            const double angle = 2 * std::numbers::pi * i / n, radius = 0.4 + 0.6 * random_unit(seed, i, 1);
            ring.push_back({radius * std::cos(angle), radius * std::sin(angle)});
        }
        const Quality quality = quality_of(mesh_of({ring}));
        EXPECT_EQ(quality.euler, 1);
        EXPECT_EQ(quality.chords, 0u);
        EXPECT_EQ(quality.bad_edges, 0u);
    }
}

TEST(PartMesh, SpacingIsTaken) {
    const InflatedPart coarse = mesh_of({ellipse(0, 0, 1, 1)}, {.spacing = 0.2}),
                       fine = mesh_of({ellipse(0, 0, 1, 1)}, {.spacing = 0.05});
    EXPECT_NEAR(static_cast<double>(fine.points.size()) / static_cast<double>(coarse.points.size()), 16, 5);
}

TEST(PartMesh, CrossingsAreRefused) {
    EXPECT_THROW(mesh_of({{{0, 0}, {10, 8}, {10, 0}, {0, 10}}}), Failure);
}

bool same(const InflatedPart& a, const InflatedPart& b) {
    return std::equal(a.points.begin(), a.points.end(), b.points.begin(), b.points.end()) &&
           std::equal(a.triangles.begin(), a.triangles.end(), b.triangles.begin(), b.triangles.end()) &&
           std::equal(a.squares.begin(), a.squares.end(), b.squares.begin(), b.squares.end());
}

TEST(PartMesh, SameBitsWithPauses) {
    const Rings rings = {ellipse(0, 0, 2, 2), ellipse(0.6, 0, 0.7, 0.7)};
    EXPECT_TRUE(same(heights_of(rings), heights_of(rings, {}, true)));
}

TEST(HeightField, DiscsBecomeBalls) {
    double last = 0;
    for (const double spacing : {0.2, 0.1, 0.05}) {
        const InflatedPart part = heights_of({ellipse(3, 4, 1, 1, 800)}, {.spacing = spacing});
        double error = 0;
        for (size_t i = 0; i < part.points.size(); ++i) {
            const double x = part.points[i].x - 3, y = part.points[i].y - 4;
            error = std::max(error, std::fabs(part.squares[i] - (1 - x * x - y * y)));
        }
        EXPECT_LT(error, 0.6 * spacing * spacing);
        if (last != 0) {
            EXPECT_LT(error, 0.45 * last);
        }
        last = error;
        EXPECT_NEAR(part.highest, 1, 0.3 * spacing * spacing);
    }
}

TEST(HeightField, EllipsesBecomeEllipsoids) {
    const double a = 3, b = 1, c = 2 / (1 / (a * a) + 1 / (b * b));
    const InflatedPart part = heights_of({ellipse(0, 0, a, b, 800)}, {.spacing = 0.08});
    for (size_t i = 0; i < part.points.size(); ++i) {
        const double x = part.points[i].x / a, y = part.points[i].y / b;
        EXPECT_NEAR(part.squares[i], c * (1 - x * x - y * y), 0.01);
    }
}

// g of a strip of half width w is 2 (w^2 - y^2) far from its ends.
TEST(HeightField, StripsBecomeTubes) {
    const InflatedPart part = heights_of({{{-20, -1}, {20, -1}, {20, 1}, {-20, 1}}}, {.thickness = 0.5});
    EXPECT_NEAR(part.highest, 0.5 * std::sqrt(2.0), 0.01);
    for (size_t i = 0; i < part.points.size(); ++i)
        if (std::fabs(part.points[i].x) < 12) {
            EXPECT_NEAR(part.squares[i], 2 * (1 - part.points[i].y * part.points[i].y), 0.05);
        }
}

TEST(HeightField, EachVertexInsideIsAboveThePlane) {
    const InflatedPart part =
        heights_of({{{0, 0}, {10, 0}, {10, 0.01}, {5, 0.01}, {5, 5}, {4, 5}, {4, 0.01}, {0, 0.01}}});
    for (size_t i = 0; i < part.points.size(); ++i) EXPECT_EQ(part.squares[i] > 0, part.on_border[i] == 0);
}

}  // namespace
}  // namespace flg::test
