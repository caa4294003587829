// SPDX-License-Identifier: MIT
#include "surfaces/mesh/mesh_edit.h"

#include <set>

#include "surfaces/cut_meshes.h"

namespace flg::test {
namespace {

using Direction = MeshEditReplay::Direction;

TEST(MeshEdit, TakesCutsBackAndMakesThemAgain) {
    for (const Soup& soup : {sphere(3), torus(20, 12), plane(12, 0.3)}) {
        Mesh mesh = make_mesh(soup);
        MeshColumns columns{test_memory()};
        columns.push_back(make_column(mesh, [](const Vec3& p) { return p.x() + p.y(); }));
        columns.push_back(make_column(mesh, [](const Vec3& p) { return p.x() - 0.6 * p.y() + 0.1; }));
        std::deque<MeshEdit> edits;
        std::vector<std::vector<uint32_t>> states = {bits_of(mesh, columns)};
        for (uint32_t i = 0; i < 6; ++i) {
            edits.emplace_back(test_memory());
            cut_isolines(mesh, columns, i % 2, {0.1f * static_cast<float>(i), 0.7f}, edits.back(),
                         {{0, 1}, {1, 0}, {2, 1}, {3, 0}});
            states.push_back(bits_of(mesh, columns));
            ASSERT_NE(states[i], states[i + 1]);
        }
        for (uint32_t slice : {1000000u, 5u}) {
            for (size_t i = edits.size(); i-- > 0;) {
                replay(mesh, columns, edits[i], Direction::undo, slice);
                EXPECT_EQ(bits_of(mesh, columns), states[i]) << "undo " << i << ", slice " << slice;
            }
            for (size_t i = 0; i < edits.size(); ++i) {
                replay(mesh, columns, edits[i], Direction::redo, slice);
                EXPECT_EQ(bits_of(mesh, columns), states[i + 1]) << "redo " << i << ", slice " << slice;
            }
        }
        expect_valid(mesh);
    }
}

// An edit costs what it changes, not what the mesh is.
TEST(MeshEdit, RemembersTheChangeOnly) {
    Mesh mesh = make_mesh(plane(200));
    MeshColumns columns{test_memory()};
    columns.push_back(make_column(mesh, [](const Vec3& p) { return (p - Vec3(0.5, 0.5, 0)).norm(); }));
    MeshEdit edit(test_memory());
    cut_isolines(mesh, columns, 0, {0.02f}, edit);
    const uint32_t added = edit.after().triangles - edit.before().triangles;
    ASSERT_GT(added, 20u);
    EXPECT_LT(edit.words().size(), 20 * added);
    EXPECT_LT(edit.labels().size(), added);
}

// Those whose ring of triangles differs.
TEST(MeshEdit, NamesTheVerticesItTouched) {
    for (const Soup& soup : {sphere(3), plane(12, 0.3)}) {
        Mesh mesh = make_mesh(soup);
        const Mesh old = make_mesh(soup);
        MeshColumns columns{test_memory()};
        columns.push_back(make_column(mesh, [](const Vec3& p) { return p.x() + 0.4 * p.y(); }));
        MeshEdit edit(test_memory());
        cut_isolines(mesh, columns, 0, {0.2f, 0.23f}, edit);

        std::set<uint32_t> changed;
        const auto is_changed = [&](uint32_t t) {
            return t >= old.triangle_count() || mesh.triangles[t] != old.triangles[t];
        };
        for (Corner corner = 0; corner < 3 * mesh.triangle_count(); ++corner) {
            if (!is_changed(triangle_of(corner))) continue;
            changed.insert(mesh.vertex_at(corner));
        }
        std::erase_if(changed, [&](uint32_t vertex) { return vertex >= old.vertex_count(); });
        ASSERT_GT(changed.size(), 5u);

        for (const bool haltingly : {false, true}) {
            const auto find = [&](Pace& pace) { return find_touched(pace, mesh, edit); };
            const std::pmr::deque<uint32_t> touched = run_now(test_memory(), find, haltingly);
            EXPECT_EQ(touched.size(), changed.size());
            EXPECT_EQ(std::set<uint32_t>(touched.begin(), touched.end()), changed);
        }
    }
}

}  // namespace
}  // namespace flg::test
