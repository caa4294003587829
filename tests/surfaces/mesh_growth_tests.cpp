// SPDX-License-Identifier: MIT
#include "surfaces/mesh/mesh_growth.h"

#include "surfaces/cut_meshes.h"

namespace flg::test {
namespace {

TEST(MeshGrowth, MakesRoomAndKeepsWhatThereIs) {
    Mesh mesh = make_mesh(sphere(2));
    MeshColumns columns{test_memory()};
    columns.push_back(make_column(mesh, [](const Vec3& p) { return p.z(); }));
    columns.push_back({3, GrowingBuffer<float>(3 * mesh.vertex_count(), test_memory())});
    std::fill(columns[1].values.begin(), columns[1].values.end(), 2.0f);
    const std::vector<uint32_t> before = bits_of(mesh, columns);
    MeshGrowth growth(mesh, columns, 1000, 3000);
    while (!growth.run(3)) {}
    EXPECT_EQ(bits_of(mesh, columns), before);
    EXPECT_EQ(mesh.positions.capacity(), 1250u);
    EXPECT_EQ(mesh.corner_of_vertex.capacity(), 1250u);
    EXPECT_EQ(mesh.triangles.capacity(), 3750u);
    EXPECT_EQ(mesh.neighbours.capacity(), 3750u);
    EXPECT_EQ(mesh.regions.capacity(), 3750u);
    EXPECT_EQ(columns[0].values.capacity(), 1250u);
    EXPECT_EQ(columns[1].values.capacity(), 3750u);
}

TEST(MeshGrowth, LeavesWhatIsLargeEnough) {
    Mesh mesh = make_mesh(sphere(2));
    MeshColumns columns{test_memory()};
    const Position* place = mesh.positions.data();
    MeshGrowth growth(mesh, columns, mesh.vertex_count(), mesh.triangle_count() + 1);
    while (!growth.run(1)) {}
    EXPECT_EQ(mesh.positions.data(), place);
    EXPECT_GT(mesh.regions.capacity(), mesh.regions.size());
}

}  // namespace
}  // namespace flg::test
