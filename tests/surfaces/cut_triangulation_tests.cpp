// SPDX-License-Identifier: MIT
#include "surfaces/cutting/cut_triangulation.h"

#include <gtest/gtest.h>

#include <set>

#include "core/random.h"
#include "surfaces/test_meshes.h"

namespace flg::test {
namespace {

constexpr int32_t scale = CutTriangulation::scale, tolerance = CutTriangulation::tolerance;

using Edge = std::pair<uint32_t, uint32_t>;
using Path = std::vector<uint32_t>;

struct Division {
    Division() { triangulation.reset({1, 0, 0}, {0.3, 0.8, 0}); }

    Path connect(uint32_t from, uint32_t to) {
        triangulation.begin_segment(from, to);
        while (!triangulation.step()) {}
        return {triangulation.path().begin(), triangulation.path().end()};
    }
    void improve() {
        triangulation.begin_improvement();
        while (!triangulation.improve()) {}
    }
    // With the crossings of segments that came later.
    Path follow(const Path& path) const {
        Path all(1, path[0]);
        for (size_t i = 0; i + 1 < path.size(); ++i) {
            triangulation.follow(path[i], path[i + 1], [&](uint32_t vertex) { all.push_back(vertex); });
        }
        return all;
    }

    CutTriangulation triangulation{test_memory()};
};

int64_t area_of(const CutTriangulation& triangulation, const Triple& vertices) {
    const auto& points = triangulation.points();
    const auto &a = points[vertices[0]], &b = points[vertices[1]], &c = points[vertices[2]];
    return int64_t{b.x - a.x} * (c.y - a.y) - int64_t{b.y - a.y} * (c.x - a.x);
}

// Counter-clockwise triangles without gaps, whose neighbours agree; returns the edges of segments.
std::set<Edge> expect_division(const CutTriangulation& triangulation) {
    const auto& triangles = triangulation.triangles();
    std::set<Edge> segments;
    int64_t area = 0;
    for (uint32_t t = 0; t < triangles.size(); ++t) {
        const auto& [vertices, neighbours, is_segment] = triangles[t];
        EXPECT_GT(area_of(triangulation, vertices), 0);
        area += area_of(triangulation, vertices);
        for (uint32_t k = 0; k < 3; ++k) {
            const uint32_t a = vertices[k], b = vertices[(k + 1) % 3];
            if (is_segment[k]) segments.insert(std::minmax(a, b));
            if (neighbours[k] >= Pieces::outer_edge) continue;
            const CutTriangulation::Triangle& other = triangles[neighbours[k]];
            const uint32_t j = other.vertices[0] == b ? 0 : other.vertices[1] == b ? 1 : 2;
            EXPECT_EQ(other.vertices[j], b);
            EXPECT_EQ(other.vertices[(j + 1) % 3], a);
            EXPECT_EQ(other.neighbours[j], t);
            EXPECT_EQ(other.is_segment[j], is_segment[k]);
        }
    }
    EXPECT_EQ(area, int64_t{scale} * scale);
    return segments;
}

TEST(CutTriangulation, JoinsPointsOfTheEdges) {
    Division division;
    const uint32_t a = division.triangulation.add_on_edge(0, scale / 4);
    const uint32_t b = division.triangulation.add_on_edge(0, scale / 2);
    const uint32_t c = division.triangulation.add_on_edge(1, scale / 2);
    const uint32_t d = division.triangulation.add_on_edge(2, scale / 2);
    EXPECT_EQ(division.connect(a, d), (Path{a, d}));
    EXPECT_EQ(division.connect(b, c), (Path{b, c}));
    EXPECT_EQ(division.connect(a, b), (Path{a, b}));
    EXPECT_EQ(division.connect(0, 1), (Path{0, a, b, 1}));
    division.improve();
    EXPECT_EQ(expect_division(division.triangulation), (std::set<Edge>{{a, d}, {b, c}, {a, b}, {0, a}, {1, b}}));
    EXPECT_EQ(division.triangulation.triangles().size(), 5u);
}

TEST(CutTriangulation, SegmentsMeetInAVertexWhereTheyCross) {
    Division division;
    const uint32_t a = division.triangulation.add_on_edge(0, scale / 2);
    const uint32_t b = division.triangulation.add_on_edge(1, scale / 4);
    const uint32_t c = division.triangulation.add_on_edge(2, scale / 4);
    const Path first = division.connect(a, 2);
    const Path second = division.connect(b, c);
    ASSERT_EQ(second.size(), 3u);
    const uint32_t crossing = second[1];
    EXPECT_EQ(first, (Path{a, 2}));
    EXPECT_EQ(division.follow(first), (Path{a, crossing, 2}));
    // x + 0.5 y = 0.5 and the line from (0.75, 0.25) to (0, 0.75).
    EXPECT_EQ(division.triangulation.points()[crossing].x, std::lround(scale * 0.1875));
    EXPECT_EQ(division.triangulation.points()[crossing].y, std::lround(scale * 0.625));
    division.improve();
    EXPECT_EQ(expect_division(division.triangulation).size(), 4u);
}

TEST(CutTriangulation, PointsAndSegmentsKeepTheirDistance) {
    Division division;
    const uint32_t a = division.triangulation.add({scale / 3, scale / 3});
    EXPECT_EQ(division.triangulation.add({scale / 3 + tolerance / 2, scale / 3 - tolerance / 2}), a);
    const uint32_t b = division.triangulation.add({scale / 3 + 4 * tolerance, scale / 3});
    EXPECT_NE(b, a);
    // Beside the way to a, but not beside that to b.
    const uint32_t c = division.triangulation.add({scale / 5, scale / 5 + tolerance / 2});
    EXPECT_EQ(division.connect(0, a), (Path{0, c, a}));
    EXPECT_EQ(division.connect(0, b), (Path{0, b}));
    expect_division(division.triangulation);
}

// Random points, those inside often in line with each other, and segments among them and their crossings.
void divide_at_random(uint64_t round, uint32_t segment_count, double furthest) {
    SCOPED_TRACE(testing::Message() << "round " << round << ", " << segment_count << " segments");
    uint64_t draw = 0;
    const auto below = [&](uint32_t count) { return random_below(99, round, draw++, count); };
    Division division;
    for (uint32_t k = 0; k < 3; ++k) {
        int32_t along = 0;
        for (uint32_t i = below(5); i > 0; --i) {
            along += 2 * tolerance + static_cast<int32_t>(below(scale / 6));
            division.triangulation.add_on_edge(k, along);
        }
    }
    for (uint32_t i = below(6); i > 0; --i) {
        const auto x = static_cast<int32_t>(1 + below(6)) * (scale / 8) + (below(2) == 0 ? 0 : tolerance);
        const auto y = static_cast<int32_t>(1 + below(6)) * (scale / 8);
        if (x + y < scale - tolerance) division.triangulation.add({x, y});
    }
    const auto vertices = static_cast<uint32_t>(division.triangulation.points().size());
    std::vector<Path> paths;
    for (uint32_t i = 0; i < segment_count; ++i) {
        const uint32_t from = below(vertices), to = below(vertices);
        paths.push_back(division.connect(from, to));
        EXPECT_EQ(paths.back().front(), from);
        EXPECT_EQ(paths.back().back(), to);
        const auto& points = division.triangulation.points();
        const auto &a = points[from], &b = points[to];
        const double dx = b.x - a.x, dy = b.y - a.y, length = std::hypot(dx, dy);
        for (uint32_t vertex : paths.back()) {
            const double area = (points[vertex].x - a.x) * dy - (points[vertex].y - a.y) * dx;
            EXPECT_LE(std::abs(area), furthest * scale * length);
        }
    }
    division.improve();
    const std::set<Edge> segments = expect_division(division.triangulation);
    std::set<Edge> followed;
    for (const Path& path : paths) {
        const Path all = division.follow(path);
        for (size_t i = 0; i + 1 < all.size(); ++i) followed.insert(std::minmax(all[i], all[i + 1]));
    }
    EXPECT_EQ(followed, segments);
}

TEST(CutTriangulation, HoldsUpUnderRandomSegments) {
    for (uint64_t round = 0; round < 500; ++round) divide_at_random(round, 1 + round % 5, 4 * cut_tolerance);
    for (uint64_t round = 0; round < 50; ++round) divide_at_random(1000 + round, 40, 10 * cut_tolerance);
    for (uint64_t round = 0; round < 3; ++round) divide_at_random(2000 + round, 300, 1);
}

}  // namespace
}  // namespace flg::test
