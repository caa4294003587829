// SPDX-License-Identifier: MIT
// A stroke that grows by calls with new points alone has the bits of the whole.
#include "brush/strokes.h"

namespace flg::test {
namespace {

// A buffer that a stroke grows in; each call may write only where its sizes say.
struct Growing {
    FlgBrushMeshState state = flgBrushMeshStateDefaults();
    BrushMesh mesh;

    void add(const FlgBrushMeshDesc& desc) {
        FlgBrushMeshSizes sizes = flgBrushMeshSizesDefaults();
        ASSERT_EQ(flgBrushMeshGetSizes(&desc, &state, &sizes), FLG_OK) << flgErrorGetMessage();
        mesh.vertices.resize(sizes.first_vertex + sizes.vertex_count);
        mesh.indices.resize(sizes.first_index + sizes.index_count);
        std::vector<Vertex> vertices(sizes.vertex_count + 1);
        std::vector<uint32_t> indices(sizes.index_count + 1);
        const auto columns = columns_of(vertices, desc.uv != 0);
        FlgBrushMeshOutput output = flgBrushMeshOutputDefaults();
        output.columns = columns.data();
        output.column_count = static_cast<uint32_t>(columns.size());
        output.vertex_capacity = sizes.vertex_count;
        output.indices = indices.data();
        output.index_capacity = sizes.index_count;
        ASSERT_EQ(flgBrushMeshWrite(&desc, &state, &output, nullptr), FLG_OK) << flgErrorGetMessage();
        std::copy(vertices.begin(), vertices.end() - 1, mesh.vertices.begin() + static_cast<long>(sizes.first_vertex));
        std::copy(indices.begin(), indices.end() - 1, mesh.indices.begin() + static_cast<long>(sizes.first_index));
        EXPECT_EQ(state.vertex_count, mesh.vertices.size());
        EXPECT_EQ(state.index_count, mesh.indices.size());
    }
};

void expect_same(const BrushMesh& a, const BrushMesh& b, bool uv) {
    ASSERT_EQ(a.vertices.size(), b.vertices.size());
    ASSERT_EQ(a.indices, b.indices);
    const size_t bytes = uv ? sizeof(Vertex) : offsetof(Vertex, uv);
    for (size_t v = 0; v < a.vertices.size(); ++v)
        ASSERT_EQ(std::memcmp(&a.vertices[v], &b.vertices[v], bytes), 0) << "vertex " << v;
}

// Points, some repeated, some of sharp corners and turns back.
Stroke wild_stroke() {
    Stroke stroke;
    for (uint32_t i = 0; i < 90; ++i) {
        const Vec3 p = i % 17 == 16 ? bent(0.02 * (i - 2)) : i % 11 == 10 ? bent(0.02 * (i - 1)) : bent(0.02 * i);
        stroke.add(p, 0.02 + 0.001 * (i % 7));
        for (int k = 0; k < 4; ++k) stroke.colors.push_back(static_cast<float>(i) / 100);
        for (const double n : {0.2, std::cos(0.3 * i), std::sin(0.3 * i)})
            stroke.normals.push_back(static_cast<float>(n));
    }
    stroke.end();
    return stroke;
}

// The points from `first` on to before `end`, as a view of their own.
struct Piece {
    Stroke stroke;
    Piece(const Stroke& whole, uint32_t first, uint32_t end) : stroke() {
        const auto part = [&](const std::vector<float>& from, size_t components) {
            if (from.empty()) return from;
            return std::vector<float>(from.begin() + static_cast<long>(first * components),
                                      from.begin() + static_cast<long>(end * components));
        };
        stroke.positions = part(whole.positions, 3);
        stroke.radii = part(whole.radii, 1);
        stroke.colors = part(whole.colors, 4);
        stroke.normals = part(whole.normals, 3);
        stroke.end();
    }
};

TEST(BrushGrowth, PiecesHaveTheBitsOfTheWhole) {
    const Stroke stroke = wild_stroke();
    for (const FlgBrushShape shape : {FLG_BRUSH_SHAPE_TUBE, FLG_BRUSH_SHAPE_RIBBON}) {
        for (const FlgBrushJoin join :
             {FLG_BRUSH_JOIN_MITER, FLG_BRUSH_JOIN_BEVEL, FLG_BRUSH_JOIN_ROUND, FLG_BRUSH_JOIN_NARROW}) {
            for (const uint32_t flags : {0u, 1u, 2u}) {
                FlgBrushMeshDesc desc = desc_of(stroke, shape);
                desc.join = join;
                desc.uv = flags & 1;
                desc.hard_normals = flags & 2;
                desc.start_cap = FLG_BRUSH_CAP_ROUND;
                desc.end_cap = FLG_BRUSH_CAP_TAPERED;
                const BrushMesh whole = mesh_of(desc);
                for (const uint32_t step : {1u, 2u, 7u, 40u}) {
                    Growing growing;
                    for (uint32_t first = 0; first < stroke.size(); first += step) {
                        const Piece piece(stroke, first, std::min(first + step, stroke.size()));
                        FlgBrushMeshDesc part = desc;
                        part.curves = &piece.stroke.view;
                        growing.add(part);
                    }
                    expect_same(growing.mesh, whole, desc.uv != 0);
                }
            }
        }
    }
}

// Each point has more rows than a block of points has room for.
TEST(BrushGrowth, CornersOfManyRowsHaveTheBitsOfTheWhole) {
    Stroke zigzag;
    for (uint32_t i = 0; i < 80; ++i) zigzag.add(Vec3(0.01 * i, i % 2, 0.1 * std::sin(i)), 0.02);
    zigzag.end();
    for (const FlgBrushShape shape : {FLG_BRUSH_SHAPE_TUBE, FLG_BRUSH_SHAPE_RIBBON}) {
        FlgBrushMeshDesc desc = desc_of(zigzag, shape);
        desc.join = FLG_BRUSH_JOIN_ROUND;
        desc.sides = 64;
        const BrushMesh whole = mesh_of(desc);
        EXPECT_GT(whole.vertices.size(), 78u * 30u * (shape == FLG_BRUSH_SHAPE_TUBE ? 64u : 2u));
        Growing growing;
        for (uint32_t i = 0; i < zigzag.size(); ++i) {
            const Piece piece(zigzag, i, i + 1);
            FlgBrushMeshDesc part = desc;
            part.curves = &piece.stroke.view;
            growing.add(part);
        }
        expect_same(growing.mesh, whole, false);
    }
}

TEST(BrushGrowth, WholeViewsGrowByTheirFirstPoint) {
    const Stroke stroke = bent_stroke(50);
    FlgBrushMeshDesc desc = desc_of(stroke);
    const BrushMesh whole = mesh_of(desc);
    Growing growing;
    for (const uint32_t end : {1u, 2u, 20u, 21u, 50u}) {
        const Piece shown(stroke, 0, end);
        FlgBrushMeshDesc part = desc;
        part.curves = &shown.stroke.view;
        part.first_point = end == 1 ? 0 : end == 2 ? 1 : end == 20 ? 2 : end == 21 ? 20 : 21;
        growing.add(part);
    }
    expect_same(growing.mesh, whole, false);
    // Nothing new: the end is written once more.
    desc.first_point = 50;
    growing.add(desc);
    expect_same(growing.mesh, whole, false);
}

TEST(BrushGrowth, ACopyOfTheStateIsABookmark) {
    const Stroke stroke = bent_stroke(50);
    const Piece first(stroke, 0, 30), rest(stroke, 30, 50);
    Stroke tip;
    for (int i = 0; i < 5; ++i) {
        tip.add(bent(1.2) + Vec3(0.01 * i, 0.02, 0), 0.02);
        for (int k = 0; k < 4; ++k) tip.colors.push_back(1);
    }
    tip.end();
    FlgBrushMeshDesc desc = desc_of(first.stroke);
    Growing growing;
    growing.add(desc);
    Growing provisional = growing;
    desc.curves = &tip.view;
    provisional.add(desc);
    desc.curves = &rest.stroke.view;
    growing.add(desc);
    expect_same(growing.mesh, mesh_of(desc_of(stroke)), false);
}

TEST(BrushGrowth, ACallWritesItsNewPointsAlone) {
    const Stroke stroke = bent_stroke(400);
    FlgBrushMeshDesc desc = desc_of(stroke);
    Growing growing;
    const Piece most(stroke, 0, 399), last(stroke, 399, 400);
    desc.curves = &most.stroke.view;
    growing.add(desc);
    desc.curves = &last.stroke.view;
    FlgBrushMeshSizes sizes = flgBrushMeshSizesDefaults();
    ASSERT_EQ(flgBrushMeshGetSizes(&desc, &growing.state, &sizes), FLG_OK);
    EXPECT_EQ(sizes.vertex_count, 2u * 8 + 9);
    EXPECT_EQ(sizes.index_count, 6u * 8 * 2 + 3 * 8);
    EXPECT_EQ(sizes.first_vertex, 9u + 398 * 8);
}

}  // namespace
}  // namespace flg::test
