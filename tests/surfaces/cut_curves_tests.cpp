// SPDX-License-Identifier: MIT
#include "surfaces/cut_curves.h"

#include <set>

#include "core/failure.h"
#include "surfaces/cut_meshes.h"
#include "surfaces/cut_regions.h"
#include "surfaces/isolines.h"

namespace flg::test {
namespace {

void add_curve(SurfaceCurves& curves, const std::vector<SurfacePoint>& points, bool closed = false) {
    curves.points.insert(curves.points.end(), points.begin(), points.end());
    curves.offsets.push_back(static_cast<uint32_t>(curves.points.size()));
    curves.closed.push_back(closed);
    curves.values.push_back(0);
}

// The corners of the triangle in the plane z = 0.
double turn(const Vec3& a, const Vec3& b, const Vec3& c) {
    return (b - a).cross(c - a).z();
}

// Of a point in the plane z = 0, in a triangle; clamped to it.
SurfacePoint in_triangle(const Mesh& mesh, uint32_t triangle, const Vec3& p) {
    const auto [a, b, c] = mesh.triangles[triangle];
    const Vec3 x = mesh.position(a), y = mesh.position(b), z = mesh.position(c);
    const double area = turn(x, y, z);
    const double u = std::clamp(turn(x, p, z) / area, 0.0, 1.0), v = std::clamp(turn(x, y, p) / area, 0.0, 1.0 - u);
    return {triangle, static_cast<float>(u), static_cast<float>(v)};
}

uint32_t triangle_at(const Mesh& mesh, const Vec3& p) {
    for (uint32_t t = 0; t < mesh.triangle_count(); ++t) {
        const auto [a, b, c] = mesh.triangles[t];
        const Vec3 x = mesh.position(a), y = mesh.position(b), z = mesh.position(c);
        if (turn(x, y, p) >= 0 && turn(y, z, p) >= 0 && turn(z, x, p) >= 0) return t;
    }
    return no_index;
}

// The straight way from a to b in a mesh of the plane z = 0, without b itself. It must not meet a vertex.
std::vector<SurfacePoint> straight(const Mesh& mesh, const Vec3& a, const Vec3& b) {
    uint32_t triangle = triangle_at(mesh, a);
    std::vector<SurfacePoint> points = {in_triangle(mesh, triangle, a)};
    uint32_t from = no_index;
    while (triangle != triangle_at(mesh, b)) {
        for (Corner corner = 3 * triangle; corner < 3 * triangle + 3; ++corner) {
            const Vec3 x = mesh.position(mesh.vertex_at(corner)),
                       y = mesh.position(mesh.vertex_at(next_corner(corner)));
            const uint32_t next = mesh.neighbour_at(corner);
            if (next == no_index || next == from || turn(a, b, x) > 0 || turn(a, b, y) < 0) continue;
            const double t = turn(a, b, x) / (turn(a, b, x) - turn(a, b, y));
            points.push_back(point_on_edge(mesh.opposite(corner), static_cast<float>(1 - t)));
            from = std::exchange(triangle, next);
            break;
        }
    }
    return points;
}

struct Cut {
    explicit Cut(const Soup& soup) : mesh(make_mesh(soup)) {
        columns.push_back(make_column(mesh, [](const Vec3& p) { return p.x() - 2 * p.y() + p.z(); }));
    }
    void add_line(std::vector<Vec3> corners, bool closed = false) {
        std::vector<SurfacePoint> points;
        if (closed) corners.push_back(corners[0]);
        for (size_t i = 0; i + 1 < corners.size(); ++i) {
            const std::vector<SurfacePoint> part = straight(mesh, corners[i], corners[i + 1]);
            points.insert(points.end(), part.begin(), part.end());
        }
        if (!closed) points.push_back(in_triangle(mesh, triangle_at(mesh, corners.back()), corners.back()));
        add_curve(curves, points, closed);
    }
    void run(uint32_t first_label = 1, uint32_t slice = 1000) {
        CurveCutter cutter(mesh, columns, curves, edit, out, test_memory());
        while (!cutter.run(slice)) {}
        RegionDivider divider(mesh, out.edges, first_label, edit, parts, test_memory());
        while (!divider.run(slice)) {}
    }

    Mesh mesh;
    MeshColumns columns{test_memory()};
    SurfaceCurves curves{test_memory()};
    MeshEdit edit{test_memory()};
    EmbeddedCurves out{test_memory()};
    std::pmr::deque<RegionPart> parts;
};

std::set<std::pair<uint32_t, uint32_t>> edges_of(const Mesh& mesh) {
    std::set<std::pair<uint32_t, uint32_t>> edges;
    for (Corner corner = 0; corner < 3 * mesh.triangle_count(); ++corner) {
        edges.insert(std::minmax(mesh.vertex_at(corner), mesh.vertex_at(next_corner(corner))));
    }
    return edges;
}

// Each curve is a chain of edges of the mesh, and exactly those edges are named.
void expect_chains(const Cut& cut) {
    ASSERT_EQ(cut.out.offsets.size(), cut.curves.curve_count() + 1);
    std::set<std::pair<uint32_t, uint32_t>> chained, named;
    for (uint32_t c = 0; c < cut.curves.curve_count(); ++c) {
        const uint32_t first = cut.out.offsets[c], end = cut.out.offsets[c + 1];
        ASSERT_LT(first, end);
        for (uint32_t i = first; i + 1 < end; ++i) {
            chained.insert(std::minmax(cut.out.vertices[i], cut.out.vertices[i + 1]));
        }
        if (cut.curves.closed[c] && end - first > 1) {
            chained.insert(std::minmax(cut.out.vertices[end - 1], cut.out.vertices[first]));
        }
    }
    for (Corner corner : cut.out.edges) {
        named.insert(std::minmax(cut.mesh.vertex_at(corner), cut.mesh.vertex_at(next_corner(corner))));
    }
    const auto edges = edges_of(cut.mesh);
    for (const auto& edge : chained) EXPECT_TRUE(edges.contains(edge)) << edge.first << "-" << edge.second;
    EXPECT_EQ(chained, named);
}

TEST(CurveCutter, ALineHalvesTheSquare) {
    Cut cut(plane(20, 0.2));
    cut.add_line({{0, 0.301, 0}, {1, 0.532, 0}});
    cut.run();
    expect_valid(cut.mesh);
    expect_chains(cut);
    ASSERT_EQ(cut.parts.size(), 2u);
    EXPECT_EQ(cut.parts[0].old_label, 0u);
    EXPECT_NEAR(std::min(area_of(cut.mesh, 1), area_of(cut.mesh, 2)), 0.4165, 5e-4);
    EXPECT_NEAR(area_of(cut.mesh, 1) + area_of(cut.mesh, 2), 1, 1e-6);
    // The chain is the line.
    for (uint32_t vertex : cut.out.vertices) {
        const Vec3 p = cut.mesh.position(vertex);
        EXPECT_NEAR(p.y(), 0.301 + 0.231 * p.x(), 2 * cut_tolerance / 20);
    }
}

TEST(CurveCutter, LinesThatCrossMakeFourParts) {
    Cut cut(plane(7, 0.2));
    cut.add_line({{0, 0.301, 0}, {1, 0.532, 0}});
    cut.add_line({{0.432, 0, 0}, {0.617, 1, 0}});
    cut.run(5);
    expect_valid(cut.mesh);
    expect_chains(cut);
    ASSERT_EQ(cut.parts.size(), 4u);
    EXPECT_EQ(area_of(cut.mesh, 0), 0);
    // The crossing, of y = 0.301 + 0.231 x and x = 0.432 + 0.185 y, is a vertex of both chains.
    const double x = (0.432 + 0.185 * 0.301) / (1 - 0.185 * 0.231);
    const std::set<uint32_t> first(cut.out.vertices.begin(), cut.out.vertices.begin() + cut.out.offsets[1]);
    uint32_t shared = no_index;
    for (uint32_t i = cut.out.offsets[1]; i < cut.out.offsets[2]; ++i) {
        if (first.contains(cut.out.vertices[i])) shared = cut.out.vertices[i];
    }
    ASSERT_NE(shared, no_index);
    EXPECT_NEAR(cut.mesh.position(shared).x(), x, cut_tolerance / 7);
    EXPECT_NEAR(cut.mesh.position(shared).y(), 0.301 + 0.231 * x, cut_tolerance / 7);
}

TEST(CurveCutter, ALoopCutsOutItsInside) {
    Cut cut(plane(9, 0.2));
    cut.add_line({{0.21, 0.22, 0}, {0.83, 0.31, 0}, {0.47, 0.78, 0}}, true);
    cut.run();
    expect_valid(cut.mesh);
    expect_chains(cut);
    ASSERT_EQ(cut.parts.size(), 2u);
    const double inside = 0.5 * turn({0.21, 0.22, 0}, {0.83, 0.31, 0}, {0.47, 0.78, 0});
    EXPECT_NEAR(std::min(area_of(cut.mesh, 1), area_of(cut.mesh, 2)), inside, 2e-3);
}

TEST(CurveCutter, ACurveThatSeparatesNothingLeavesTheLabels) {
    Cut cut(plane(6, 0.2));
    cut.add_line({{0.21, 0.22, 0}, {0.83, 0.31, 0}, {0.47, 0.78, 0}});
    cut.run();
    expect_valid(cut.mesh);
    expect_chains(cut);
    EXPECT_TRUE(cut.parts.empty());
    EXPECT_NEAR(area_of(cut.mesh, 0), 1, 1e-6);
    const Vec3 start = cut.mesh.position(cut.out.vertices.front()), end = cut.mesh.position(cut.out.vertices.back());
    EXPECT_NEAR((start - Vec3(0.21, 0.22, 0)).norm(), 0, 2 * cut_tolerance / 6);
    EXPECT_NEAR((end - Vec3(0.47, 0.78, 0)).norm(), 0, 2 * cut_tolerance / 6);
}

// Along the edges y = 0.5, from vertex to vertex, and across a diagonal through its middle.
TEST(CurveCutter, RunsAlongEdgesAndThroughVertices) {
    Cut cut(plane(4));
    const uint32_t vertices = cut.mesh.vertex_count();
    std::vector<SurfacePoint> points;
    for (uint32_t x = 0; x < 4; ++x) points.push_back({2 * (2 * 4 + x), 0, 0});
    points.push_back({2 * (2 * 4 + 3), 1, 0});
    add_curve(cut.curves, points);
    cut.run();
    expect_valid(cut.mesh);
    expect_chains(cut);
    EXPECT_EQ(cut.mesh.vertex_count(), vertices);
    EXPECT_EQ(cut.out.vertices.size(), 5u);
    EXPECT_EQ(cut.parts.size(), 2u);
    EXPECT_DOUBLE_EQ(area_of(cut.mesh, 1), 0.5);
    EXPECT_DOUBLE_EQ(area_of(cut.mesh, 2), 0.5);
}

TEST(CurveCutter, ManySegmentsInOneTriangle) {
    Cut cut(Soup{{{0, 0, 0}, {1, 0, 0}, {0.2f, 0.9f, 0}}, {{0, 1, 2}}});
    for (uint32_t i = 0; i < 40; ++i) {
        const auto point = [&](uint32_t end) {
            const float t = static_cast<float>(random_unit(7, i, end));
            const float s = static_cast<float>(random_unit(8, i, end));
            return random_below(9, i, end, 3) == 0 ? SurfacePoint{0, t * s, t * (1 - s)}
                                                   : point_on_edge(random_below(6, i, end, 3), t);
        };
        add_curve(cut.curves, {point(0), point(1), point(2)}, i % 4 == 0);
    }
    cut.run();
    expect_valid(cut.mesh);
    expect_chains(cut);
    EXPECT_NEAR(area_of(cut.mesh), 0.45, 1e-6);
    EXPECT_EQ(euler_number(cut.mesh), 1);
    EXPECT_GT(cut.parts.size(), 100u);
    for (uint32_t t = 0; t < cut.mesh.triangle_count(); ++t) EXPECT_GT(area_vector(cut.mesh, t).z(), -1e-9);
}

// A walk from triangle to triangle: across edges, through vertices, sometimes with a corner inside.
std::vector<SurfacePoint> random_walk(const Mesh& mesh, uint64_t seed, uint64_t walk, uint32_t length) {
    uint64_t draw = 0;
    const auto below = [&](uint32_t count) { return random_below(seed, walk, draw++, count); };
    const auto unit = [&] { return static_cast<float>(random_unit(seed, walk, draw++)); };
    uint32_t triangle = below(mesh.triangle_count());
    const float start = unit();
    std::vector<SurfacePoint> points = {{triangle, start * 0.5f, unit() * 0.5f}};
    for (uint32_t i = 0; i < length; ++i) {
        const Corner corner = 3 * triangle + below(3);
        const uint32_t kind = below(8);
        if (kind == 0) {
            points.push_back({triangle, 0.3f * unit(), 0.7f * unit()});
        } else if (kind == 1) {
            // To a vertex, then into any triangle there.
            Corner next = corner;
            for (uint32_t turns = below(6); turns > 0 && mesh.turn(next) != no_index; --turns) next = mesh.turn(next);
            points.push_back(point_on_edge(next, 0));
            triangle = triangle_of(next);
        } else {
            const Corner across = mesh.opposite(corner);
            const float t = kind == 2 ? 0.02f * unit() : unit();
            if (across == no_index) continue;
            points.push_back(point_on_edge(across, t));
            triangle = triangle_of(across);
        }
    }
    points.push_back({triangle, 0.4f, 0.3f});
    return points;
}

TEST(CurveCutter, ManyCutsKeepTheMeshWhole) {
    const Soup soups[] = {sphere(2), torus(12, 8), plane(8, 0.3)};
    const int euler[] = {2, 0, 1};
    for (uint32_t i = 0; i < 3; ++i) {
        Cut cut(soups[i]);
        const double area = area_of(cut.mesh);
        std::deque<MeshEdit> edits;
        std::vector<std::vector<uint32_t>> states = {bits_of(cut.mesh, cut.columns)};
        for (uint32_t n = 0; n < 40; ++n) {
            SCOPED_TRACE(testing::Message() << "mesh " << i << ", cut " << n);
            cut.curves = SurfaceCurves(test_memory());
            cut.out = EmbeddedCurves(test_memory());
            for (uint32_t k = 0; k < 5; ++k) add_curve(cut.curves, random_walk(cut.mesh, i, 5 * n + k, 12));
            cut.edit = MeshEdit(test_memory());
            cut.run(n == 0 ? 1 : cut.parts.empty() ? 1 : cut.parts.back().label + 1, 50);
            edits.push_back(std::move(cut.edit));
            if (n % 10 == 0) {
                expect_valid(cut.mesh);
                expect_chains(cut);
                if (HasFailure()) return;
            }
            states.push_back(bits_of(cut.mesh, cut.columns));
        }
        EXPECT_EQ(euler_number(cut.mesh), euler[i]);
        EXPECT_NEAR(area_of(cut.mesh), area, 1e-6 * area);
        for (size_t n = edits.size(); n-- > 0;) {
            replay(cut.mesh, cut.columns, edits[n], MeshEditReplay::Direction::undo);
            EXPECT_EQ(bits_of(cut.mesh, cut.columns), states[n]) << "undo " << n;
        }
        for (size_t n = 0; n < edits.size(); ++n) {
            replay(cut.mesh, cut.columns, edits[n], MeshEditReplay::Direction::redo);
        }
        EXPECT_EQ(bits_of(cut.mesh, cut.columns), states.back());
    }
}

// Isolines traced and then embedded divide the surface as the cut along them does.
TEST(CurveCutter, AgreesWithTheCutAlongIsolines) {
    for (const Soup& soup : {sphere(4), torus(40, 24)}) {
        Cut traced(soup);
        Mesh sliced = make_mesh(soup);
        const auto height = [](const Vec3& p) { return p.z() + 0.2 * std::sin(3 * p.x()) * p.y(); };
        const std::vector<float> levels = {-0.21f, 0.13f};
        const MeshColumn column = make_column(traced.mesh, height);
        IsolineKernel kernel(traced.mesh, {column.values.data(), column.values.size()}, levels,
                             RegionSet(test_memory()), traced.curves, test_memory());
        while (!kernel.run(1000)) {}
        traced.run(10);
        expect_valid(traced.mesh);
        expect_chains(traced);
        MeshColumns columns{test_memory()};
        columns.push_back(make_column(sliced, height));
        MeshEdit edit(test_memory());
        cut_isolines(sliced, columns, 0, levels, edit);

        // Each part lies in one interval.
        const MeshColumn after = make_column(traced.mesh, height);
        std::array<double, 3> areas{};
        for (const RegionPart& part : traced.parts) {
            float low = 1, high = -1;
            for (uint32_t t = 0; t < traced.mesh.triangle_count(); ++t) {
                if (traced.mesh.regions[t] != part.label) continue;
                for (uint32_t vertex : traced.mesh.triangles[t]) {
                    low = std::min(low, after.values[vertex]);
                    high = std::max(high, after.values[vertex]);
                }
            }
            const auto middle = 0.5f * (low + high);
            areas[static_cast<size_t>((middle > levels[0]) + (middle > levels[1]))] += area_of(traced.mesh, part.label);
        }
        for (uint32_t i = 0; i < 3; ++i) EXPECT_NEAR(areas[i], area_of(sliced, i), 0.01) << "interval " << i;
    }
}

TEST(CurveCutter, DoesNotDependOnSlices) {
    std::vector<uint32_t> expected;
    for (uint32_t slice : {100000u, 1u, 7u}) {
        Cut cut(sphere(3));
        for (uint32_t k = 0; k < 20; ++k) add_curve(cut.curves, random_walk(cut.mesh, 3, k, 30));
        cut.run(1, slice);
        std::vector<uint32_t> bits = bits_of(cut.mesh, cut.columns);
        bits.insert(bits.end(), cut.out.vertices.begin(), cut.out.vertices.end());
        if (expected.empty()) expected = bits;
        EXPECT_EQ(bits, expected) << "slice " << slice;
    }
}

TEST(CurveCutter, CarriesColumnsLinearly) {
    Cut cut(plane(6, 0.2));
    for (uint32_t k = 0; k < 20; ++k) add_curve(cut.curves, random_walk(cut.mesh, 4, k, 30));
    cut.run();
    for (uint32_t v = 0; v < cut.mesh.vertex_count(); ++v) {
        const Vec3 p = cut.mesh.position(v);
        EXPECT_NEAR(cut.columns[0].values[v], p.x() - 2 * p.y(), 1e-6);
    }
}

TEST(CurveCutter, RefusesWhatIsNotOnTheMesh) {
    const auto fails = [](const std::vector<SurfacePoint>& points) {
        Cut cut(plane(4));
        const std::vector<uint32_t> before = bits_of(cut.mesh, cut.columns);
        add_curve(cut.curves, points);
        EXPECT_THROW(cut.run(), Failure);
        EXPECT_EQ(bits_of(cut.mesh, cut.columns), before);
    };
    fails({{0, 0.2f, 0.2f}, {32, 0.2f, 0.2f}});
    fails({{0, 0.2f, 0.2f}, {0, 0.7f, 0.7f}});
    fails({{0, 0.2f, 0.2f}, {0, -0.1f, 0.7f}});
    fails({{0, std::nanf(""), 0.2f}, {0, 0.1f, 0.7f}});
    fails({{0, 0.2f, 0.2f}, {9, 0.3f, 0.3f}});
}

}  // namespace
}  // namespace flg::test
