// SPDX-License-Identifier: MIT
#include "surfaces/cutting/cut_isolines.h"

#include "surfaces/cut_meshes.h"

namespace flg::test {
namespace {

constexpr float infinite = std::numeric_limits<float>::infinity();

struct Cut {
    explicit Cut(const Soup& soup) : mesh(make_mesh(soup)) {}

    uint32_t add(const std::function<double(const Vec3&)>& value) {
        columns.push_back(make_column(mesh, value));
        return static_cast<uint32_t>(columns.size() - 1);
    }
    void along(const std::vector<float>& levels, const std::vector<RegionLevels>& regions = {{0, 0}},
               bool haltingly = false) {
        cut_isolines(mesh, columns, 0, levels, edit, regions, haltingly);
    }
    float value(uint32_t vertex) const { return columns[0].values[vertex]; }

    Mesh mesh;
    MeshColumns columns{test_memory()};
    MeshEdit edit{test_memory()};
};

// Each triangle of the regions 0 to levels.size() lies between the levels that its label says.
void expect_between_levels(const Cut& cut, const std::vector<float>& levels) {
    for (uint32_t t = 0; t < cut.mesh.triangle_count(); ++t) {
        const uint32_t interval = cut.mesh.regions[t];
        ASSERT_LE(interval, levels.size());
        for (uint32_t vertex : cut.mesh.triangles[t]) {
            EXPECT_GE(cut.value(vertex), interval > 0 ? levels[interval - 1] : -infinite) << "triangle " << t;
            EXPECT_LE(cut.value(vertex), interval < levels.size() ? levels[interval] : infinite) << "triangle " << t;
        }
    }
}

TEST(IsolineCutter, CapsOfASphere) {
    Cut cut(sphere(5));
    cut.add([](const Vec3& p) { return std::asin(p.z()); });
    const double area = area_of(cut.mesh);
    const std::vector<float> levels = {-1.1f, -0.3f, 0.0f, 0.45f, 0.46f, 1.2f};
    cut.along(levels);
    expect_valid(cut.mesh);
    expect_between_levels(cut, levels);
    EXPECT_EQ(euler_number(cut.mesh), 2);
    EXPECT_NEAR(area_of(cut.mesh), area, 1e-6 * area);
    double low = -1;
    for (uint32_t i = 0; i <= levels.size(); ++i) {
        const double high = i < levels.size() ? std::sin(levels[i]) : 1;
        EXPECT_NEAR(area_of(cut.mesh, i), 2 * std::numbers::pi * (high - low), 0.02) << "zone " << i;
        low = high;
    }
}

TEST(IsolineCutter, RingsOfAPlane) {
    Cut cut(plane(60, 0.3));
    cut.add([](const Vec3& p) { return (p - Vec3(0.5, 0.5, 0)).norm(); });
    const std::vector<float> levels = {0.1f, 0.2f, 0.31f, 0.4f};
    cut.along(levels);
    expect_valid(cut.mesh);
    expect_between_levels(cut, levels);
    EXPECT_EQ(euler_number(cut.mesh), 1);
    EXPECT_NEAR(area_of(cut.mesh), 1, 1e-6);
    double inner = 0;
    for (uint32_t i = 0; i < levels.size(); ++i) {
        const double disk = std::numbers::pi * levels[i] * levels[i];
        EXPECT_NEAR(area_of(cut.mesh, i), disk - inner, 2e-3);
        inner = disk;
    }
}

// Where labels change, the edge lies on the level between them, to the bit.
TEST(IsolineCutter, BordersAreOnTheirLevel) {
    Cut cut(torus(40, 24));
    cut.add([](const Vec3& p) { return p.x() + 0.3 * std::sin(5 * p.y()) + p.z(); });
    const std::vector<float> levels = {-0.7f, -0.65f, 0.1f, 0.5f, 1.3f};
    cut.along(levels);
    expect_valid(cut.mesh);
    expect_between_levels(cut, levels);
    EXPECT_EQ(euler_number(cut.mesh), 0);
    uint32_t edges = 0;
    for (Corner corner = 0; corner < 3 * cut.mesh.triangle_count(); ++corner) {
        const uint32_t here = cut.mesh.regions[corner / 3], there = cut.mesh.regions[cut.mesh.neighbour_at(corner)];
        if (here <= there) continue;
        ++edges;
        ASSERT_EQ(here, there + 1);
        EXPECT_EQ(cut.value(cut.mesh.vertex_at(corner)), levels[there]);
        EXPECT_EQ(cut.value(cut.mesh.vertex_at(next_corner(corner))), levels[there]);
    }
    EXPECT_GT(edges, 200u);
}

// Of one level: no new point is closer to an end of its edge than the tolerance, and values moved no further than that.
TEST(IsolineCutter, SnapsToVerticesThatAreNear) {
    Cut cut(plane(30, 0.3));
    cut.add([](const Vec3& p) { return std::sin(7 * p.x()) + std::cos(9 * p.y()); });
    const std::vector<float> before(cut.columns[0].values.begin(), cut.columns[0].values.end());
    const uint32_t vertices = cut.mesh.vertex_count();
    const Mesh whole = make_mesh(plane(30, 0.3));
    cut.along({0.25f});
    expect_valid(cut.mesh);
    double steepest = 0;
    for (Corner corner = 0; corner < 3 * whole.triangle_count(); ++corner) {
        const uint32_t a = whole.vertex_at(corner), b = whole.vertex_at(next_corner(corner));
        steepest = std::max(steepest, std::abs(double{before[a]} - before[b]));
        const double from = cut.value(a), to = cut.value(b);
        if ((from < 0.25) == (to < 0.25) || from == 0.25 || to == 0.25) continue;
        EXPECT_GT(std::abs(0.25 - from), cut_tolerance * std::abs(to - from));
        EXPECT_GT(std::abs(0.25 - to), cut_tolerance * std::abs(to - from));
    }
    uint32_t moved = 0;
    for (uint32_t v = 0; v < vertices; ++v) {
        moved += cut.value(v) != before[v];
        EXPECT_LE(std::abs(double{cut.value(v)} - before[v]), cut_tolerance * steepest);
    }
    EXPECT_GT(moved, 0u);
    double shortest = 1, smallest = 1;
    for (uint32_t t = 0; t < cut.mesh.triangle_count(); ++t) {
        for (uint32_t k = 0; k < 3; ++k) {
            const Triple& corners = cut.mesh.triangles[t];
            const Vec3 side = cut.mesh.position(corners[(k + 1) % 3]) - cut.mesh.position(corners[k]);
            const Vec3 other = cut.mesh.position(corners[(k + 2) % 3]) - cut.mesh.position(corners[k]);
            shortest = std::min(shortest, side.norm());
            smallest = std::min(smallest, side.cross(other).norm() / (side.norm() * other.norm()));
        }
    }
    // The mesh has edges of at least 0.4 / 30 and angles of at least 15 degrees.
    EXPECT_GT(shortest, cut_tolerance * 0.4 / 30);
    EXPECT_GT(smallest, cut_tolerance * std::sin(0.25));
}

TEST(IsolineCutter, PassesThroughVerticesAndAlongEdges) {
    Cut cut(plane(8));
    cut.add([](const Vec3& p) { return p.x(); });
    const uint32_t vertices = cut.mesh.vertex_count(), triangles = cut.mesh.triangle_count();
    cut.along({0.25f, 0.5f, 1.0f});
    expect_valid(cut.mesh);
    EXPECT_EQ(cut.mesh.vertex_count(), vertices);
    EXPECT_EQ(cut.mesh.triangle_count(), triangles);
    EXPECT_DOUBLE_EQ(area_of(cut.mesh, 0), 0.25);
    EXPECT_DOUBLE_EQ(area_of(cut.mesh, 1), 0.25);
    EXPECT_DOUBLE_EQ(area_of(cut.mesh, 2), 0.5);
    EXPECT_DOUBLE_EQ(area_of(cut.mesh, 3), 0);
}

TEST(IsolineCutter, FlatTrianglesLieBelowTheirLevel) {
    Cut cut(plane(8));
    cut.add([](const Vec3& p) { return std::max(p.x(), 0.5); });
    cut.along({0.5f});
    expect_valid(cut.mesh);
    EXPECT_DOUBLE_EQ(area_of(cut.mesh, 0), 0.5);
    EXPECT_DOUBLE_EQ(area_of(cut.mesh, 1), 0.5);
}

// Triangles with an infinite value keep whole but for edges that a neighbour cuts.
TEST(IsolineCutter, DoesNotCutWhereValuesAreInfinite) {
    Cut cut(plane(10));
    cut.add([](const Vec3& p) { return p.y() > 0.55 ? infinite : p.x(); });
    cut.along({0.33f});
    expect_valid(cut.mesh);
    EXPECT_NEAR(area_of(cut.mesh), 1, 1e-6);
    EXPECT_NEAR(area_of(cut.mesh, 0), 0.33 * 0.5, 1e-6);
    for (uint32_t v = 0; v < cut.mesh.vertex_count(); ++v) EXPECT_FALSE(std::isnan(cut.value(v)));
    for (uint32_t v = 121; v < cut.mesh.vertex_count(); ++v) EXPECT_LE(cut.mesh.position(v).y(), 0.5 + 1e-6);
}

TEST(IsolineCutter, KeepsToItsRegions) {
    Cut cut(plane(20, 0.2));
    cut.add([](const Vec3& p) { return p.x() + 0.1 * p.y(); });
    for (uint32_t t = 0; t < cut.mesh.triangle_count(); ++t) cut.mesh.regions[t] = t / 160;  // five bands in y
    std::vector<double> areas;
    for (uint32_t region = 0; region < 5; ++region) areas.push_back(area_of(cut.mesh, region));
    cut.along({0.3f, 0.303f, 0.77f}, {{1, 10}, {2, 20}});
    expect_valid(cut.mesh);
    for (uint32_t region : {0u, 3u, 4u}) EXPECT_NEAR(area_of(cut.mesh, region), areas[region], 1e-6);
    for (uint32_t region : {1u, 2u}) {
        double sum = 0;
        for (uint32_t k = 0; k < 4; ++k) {
            EXPECT_GT(area_of(cut.mesh, 10 * region + k), 0);
            sum += area_of(cut.mesh, 10 * region + k);
        }
        EXPECT_NEAR(sum, areas[region], 1e-6);
        EXPECT_EQ(area_of(cut.mesh, region), 0);
    }
    // Beyond the bands next to the cut ones nothing was split.
    uint32_t far = 0;
    for (uint32_t t = 0; t < cut.mesh.triangle_count(); ++t) far += cut.mesh.regions[t] == 4;
    EXPECT_EQ(far, 160u);
}

TEST(IsolineCutter, ManyLevelsInOneTriangle) {
    Cut cut(Soup{{{0, 0, 0}, {1, 0, 0}, {0.3f, 1, 0}}, {{0, 1, 2}}});
    cut.add([](const Vec3& p) { return p.x() + 2 * p.y(); });
    std::vector<float> levels;
    for (uint32_t i = 1; i <= 200; ++i) levels.push_back(static_cast<float>(i) / 90);
    cut.along(levels);
    expect_valid(cut.mesh);
    expect_between_levels(cut, levels);
    EXPECT_EQ(euler_number(cut.mesh), 1);
    EXPECT_NEAR(area_of(cut.mesh), 0.5, 1e-6);
}

// Triangles without area or length, a vertex with a thousand of them, values as close as floats can be.
TEST(IsolineCutter, HoldsUpOnDegenerateTriangles) {
    Soup flat = plane(8);
    for (uint32_t v = 0; v < flat.positions.size(); ++v) {
        if (v % 3 != 0) flat.positions[v] = flat.positions[v / 2];
    }
    Soup fan{{{0, 0, 0}}, {}};
    for (uint32_t i = 0; i < 1000; ++i) {
        const double angle = 2 * std::numbers::pi * i / 1000;
        fan.positions.push_back(to_position({std::cos(angle), std::sin(angle), 0}));
        fan.triangles.push_back({0, 1 + i, 1 + (i + 1) % 1000});
    }
    for (const Soup& soup : {flat, fan}) {
        uint64_t item = 0;
        Cut cut(soup);
        cut.add([&](const Vec3&) { return 1 + std::floor(8 * random_unit(5, item++, 0)) * 0x1p-23; });
        const std::vector<float> levels = {1 + 0x1p-23f, 1 + 0x3p-23f, 1 + 0x4p-23f};
        const int64_t euler = euler_number(cut.mesh);
        cut.along(levels);
        expect_valid(cut.mesh);
        expect_between_levels(cut, levels);
        EXPECT_EQ(euler_number(cut.mesh), euler);
        EXPECT_GT(cut.mesh.triangle_count(), soup.triangles.size());
    }
}

TEST(IsolineCutter, CarriesColumnsLinearly) {
    Cut cut(sphere(3));
    cut.add([](const Vec3& p) { return p.z() + 0.5 * p.x(); });
    MeshColumn both{2, GrowingBuffer<float>(2 * cut.mesh.vertex_count(), test_memory())};
    for (uint32_t v = 0; v < cut.mesh.vertex_count(); ++v) {
        both.values[2 * v] = cut.mesh.positions[v][0];
        both.values[2 * v + 1] = -3 * cut.mesh.positions[v][1];
    }
    cut.columns.push_back(std::move(both));
    const uint32_t vertices = cut.mesh.vertex_count();
    cut.along({-0.5f, 0.1f, 0.2f});
    ASSERT_GT(cut.mesh.vertex_count(), vertices);
    for (uint32_t v = 0; v < cut.mesh.vertex_count(); ++v) {
        EXPECT_EQ(cut.columns[1].values[2 * v], cut.mesh.positions[v][0]);
        EXPECT_FLOAT_EQ(cut.columns[1].values[2 * v + 1], -3 * cut.mesh.positions[v][1]);
    }
}

TEST(IsolineCutter, DoesNotDependOnSlices) {
    std::vector<uint32_t> expected;
    for (bool haltingly : {false, true}) {
        Cut cut(sphere(3));
        cut.add([](const Vec3& p) { return p.z() + 0.2 * p.x(); });
        cut.along({-0.5f, 0.0f, 0.2f}, {{0, 3}}, haltingly);
        if (expected.empty()) expected = bits_of(cut.mesh, cut.columns);
        EXPECT_EQ(bits_of(cut.mesh, cut.columns), expected) << "haltingly " << haltingly;
    }
}

TEST(IsolineCutter, ManyCutsKeepTheMeshWhole) {
    const Soup soups[] = {sphere(2), torus(12, 8), plane(8, 0.3)};
    const int euler[] = {2, 0, 1};
    for (uint32_t i = 0; i < 3; ++i) {
        Mesh mesh = make_mesh(soups[i]);
        MeshColumns columns{test_memory()};
        const double area = area_of(mesh);
        for (uint32_t n = 0; n < 334; ++n) {
            const Vec3 direction(random_unit(i, n, 0) - 0.5, random_unit(i, n, 1) - 0.5, random_unit(i, n, 2) - 0.5);
            const double wave = 4 * random_unit(i, n, 3);
            columns.clear();
            columns.push_back(make_column(
                mesh, [&](const Vec3& p) { return direction.dot(p) + 0.1 * std::sin(wave * p.x() + p.y()); }));
            // Planes through the middle of the meshes would all meet there.
            const float level = static_cast<float>(0.8 * random_unit(i, n, 4) - 0.3);
            MeshEdit edit(test_memory());
            const uint32_t region = random_below(i, n, 5, 6);
            cut_isolines(mesh, columns, 0, {level}, edit, {{region, random_below(i, n, 6, 5)}}, true);
        }
        expect_valid(mesh);
        EXPECT_EQ(euler_number(mesh), euler[i]);
        EXPECT_NEAR(area_of(mesh), area, 1e-6 * area);
        EXPECT_GT(mesh.triangle_count(), 5 * soups[i].triangles.size());
    }
}

}  // namespace
}  // namespace flg::test
