// SPDX-License-Identifier: MIT
#include "surfaces/geodesics/intrinsic_triangles.h"

#include <gtest/gtest.h>

#include <numbers>

#include "surfaces/test_meshes.h"

namespace flg::test {
namespace {

struct Flipped {
    explicit Flipped(const Soup& soup) : mesh(make_mesh(soup)), triangles(test_memory()) {
        FlipRequest request(test_memory());
        for (Corner edge = 0; edge < 3 * mesh.triangle_count(); ++edge) request.edges.push_back(edge);
        const IntrinsicSurface all = surface();
        changed = run_haltingly(test_memory(), [&](Pace& pace) { return flip_edges(pace, all, request, triangles); });
    }
    IntrinsicSurface surface() const { return {.mesh = mesh, .positions = mesh.positions, .flipped = &triangles}; }

    Mesh mesh;
    IntrinsicTriangles triangles;
    std::pmr::deque<uint32_t> changed;
};

// In the plane an edge is as long as its ends are apart, wherever it was flipped to.
TEST(IntrinsicTriangles, LieInThePlane) {
    const Flipped flipped(stretched(plane(20, 0.2), {1, 20, 1}));
    uint32_t moved = 0;
    double area = 0;
    for (uint32_t t = 0; t < flipped.mesh.triangle_count(); ++t) {
        const IntrinsicTriangle triangle = flipped.surface().triangle(t);
        moved += triangle.vertices != flipped.mesh.triangles[t];
        area += triangle.twice_area() / 2;
        for (uint32_t k = 0; k < 3; ++k) {
            const Vec3 begin = flipped.mesh.position(triangle.vertices[k]),
                       end = flipped.mesh.position(triangle.vertices[(k + 1) % 3]);
            EXPECT_NEAR(triangle.lengths[k], (end - begin).norm(), 1e-4);
        }
    }
    EXPECT_GT(moved, flipped.mesh.triangle_count() / 2);
    EXPECT_NEAR(area, 20, 1e-4);
}

TEST(IntrinsicTriangles, KnowEachOtherAndAreNowhereFarFromDelaunay) {
    for (const Vec3& stretch : {Vec3(1, 20, 1), Vec3(10, 1, 0.2), Vec3(1, 1.5, 1)}) {
        const Flipped flipped(stretched(torus(30, 20), stretch));
        const IntrinsicSurface surface = flipped.surface();
        EXPECT_FALSE(flipped.triangles.empty());
        for (Corner edge = 0; edge < 3 * flipped.mesh.triangle_count(); ++edge) {
            const Corner across = surface.opposite(edge);
            ASSERT_NE(across, no_index);
            EXPECT_EQ(surface.opposite(across), edge);
            EXPECT_EQ(surface.vertex_at(edge), surface.vertex_at(next_corner(across)));
            const IntrinsicTriangle one = surface.triangle(triangle_of(edge)),
                                    other = surface.triangle(triangle_of(across));
            EXPECT_EQ(one.lengths[edge % 3], other.lengths[across % 3]);
            const double angles =
                2 * std::atan(one.half_tangent((edge + 2) % 3)) + 2 * std::atan(other.half_tangent((across + 2) % 3));
            EXPECT_LT(angles, 1.2301 * std::numbers::pi);
        }
    }
}

TEST(IntrinsicTriangles, AreTheMeshsWhereThatIsNearlyDelaunay) {
    for (const Soup& soup : {plane(20), sphere(3), tetrahedron()}) {
        const Flipped flipped(soup);
        EXPECT_TRUE(flipped.triangles.empty());
        EXPECT_TRUE(flipped.changed.empty());
    }
}

}  // namespace
}  // namespace flg::test
