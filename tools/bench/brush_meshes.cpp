// SPDX-License-Identifier: MIT
// Brush meshes: the Thomas attractor as a tube, whole and point by point, into buffers that the host has. What the
// memory alone takes is measured beside it: the same bytes, copied; and the same tube as io sweeps it for a file.
#include <algorithm>
#include <cstdio>
#include <cstring>

#include "bench/groups.h"
#include "bench/host.h"
#include "filigree/filigree_brush.h"
#include "io/gltf/swept_mesh.h"

namespace flg::bench {
namespace {

constexpr uint32_t kPoints = 369'400, kSides = 8;
constexpr float kRadius = 0.002f;
constexpr double kBarMs = 40.0, kGrowingBarUs = 20.0;
constexpr int kBrushRuns = 9;

// Buffers as a graphics card's are mapped: one for vertices, one for indices.
struct Buffers {
    struct Vertex {
        float position[3], normal[3];
    };
    std::vector<Vertex> vertices;
    std::vector<uint32_t> indices;

    void write(const FlgBrushMeshDesc& desc, FlgBrushMeshState* state) {
        FlgBrushMeshSizes sizes = flgBrushMeshSizesDefaults();
        check(flgBrushMeshGetSizes(&desc, state, &sizes));
        vertices.resize(std::max(vertices.size(), size_t{sizes.first_vertex + sizes.vertex_count}));
        indices.resize(std::max(indices.size(), size_t{sizes.first_index + sizes.index_count}));
        Vertex* const first = vertices.data() + sizes.first_vertex;
        const FlgBufferColumn columns[] = {
            {FLG_ATTRIBUTE_POSITION, FLG_NUMBER_FORMAT_FLOAT32, first->position, sizeof(Vertex), 0, {}, 0, 0},
            {FLG_ATTRIBUTE_NORMAL, FLG_NUMBER_FORMAT_FLOAT32, first->normal, sizeof(Vertex), 0, {}, 0, 0}};
        FlgBrushMeshOutput output = flgBrushMeshOutputDefaults();
        output.columns = columns;
        output.column_count = 2;
        output.vertex_capacity = sizes.vertex_count;
        output.indices = indices.data() + sizes.first_index;
        output.index_capacity = sizes.index_count;
        check(flgBrushMeshWrite(&desc, state, &output, nullptr));
    }
    size_t bytes() const { return vertices.size() * sizeof(Vertex) + indices.size() * sizeof(uint32_t); }
};

}  // namespace

std::vector<Row> run_brush_meshes() {
    Host host;
    const FlgCurveSetView view = host.view(host.add(scenes::make_target("thomas", kPoints)));
    FlgBrushMeshDesc desc = flgBrushMeshDefaults();
    desc.curves = &view;
    desc.sides = kSides;
    desc.default_radius = kRadius;

    Buffers whole;
    whole.write(desc, nullptr);  // touches the pages
    Buffers copy = whole;
    FlgCurveFileWriteDesc swept = flgCurveFileWriteDefaults();
    swept.geometry = FLG_CURVE_GEOMETRY_TUBE;
    swept.tube_sides = kSides;
    swept.default_radius = kRadius;
    swept.tolerance = 0;
    const io::CheckedView checked(&view);
    std::vector<double> whole_ms, copy_ms, swept_ms, ratios;
    for (int run = 0; run < kBrushRuns; ++run) {
        whole_ms.push_back(time_ms([&] { whole.write(desc, nullptr); }));
        copy_ms.push_back(time_ms([&] {
            std::memcpy(copy.vertices.data(), whole.vertices.data(), whole.vertices.size() * sizeof(Buffers::Vertex));
            std::memcpy(copy.indices.data(), whole.indices.data(), whole.indices.size() * sizeof(uint32_t));
        }));
        swept_ms.push_back(time_ms([&] { io::sweep(checked, swept); }));
        ratios.push_back(whole_ms.back() / swept_ms.back());
    }
    char note[96], swept_note[96];
    std::snprintf(note, sizeof note, "longest %.1f; %.0f MB, to copy them takes %.1f ms",
                  *std::max_element(whole_ms.begin(), whole_ms.end()), 1e-6 * static_cast<double>(whole.bytes()),
                  median(copy_ms));
    std::snprintf(swept_note, sizeof swept_note, "pairs in turn; io's take %.1f ms, new memory among them",
                  median(swept_ms));

    // A stroke that grows by a point at a time costs its new points, however long it is.
    Buffers grown = whole;
    FlgBrushMeshState state = flgBrushMeshStateDefaults();
    std::vector<double> call_us;
    FlgCurveSetView piece = view;
    const uint32_t offsets[] = {0, 1};
    FlgColumn column = view.columns[0];
    piece.curve_offsets = offsets;
    piece.columns = &column;
    piece.column_count = 1;
    piece.curve_flags = nullptr;
    desc.curves = &piece;
    for (uint32_t i = 0; i < kPoints; ++i) {
        column.data = view.columns[0].data + size_t{3} * i;
        call_us.push_back(1e3 * time_ms([&] { grown.write(desc, &state); }));
    }
    const bool same =
        grown.bytes() == whole.bytes() &&
        std::memcmp(grown.vertices.data(), whole.vertices.data(), whole.vertices.size() * sizeof(Buffers::Vertex)) ==
            0 &&
        std::memcmp(grown.indices.data(), whole.indices.data(), whole.indices.size() * sizeof(uint32_t)) == 0;
    char growing_note[64];
    std::snprintf(growing_note, sizeof growing_note, "longest %.0f; %s bits at the end",
                  *std::max_element(call_us.begin(), call_us.end()), same ? "the same" : "OTHER");
    return {below("tube of 369,400 points, 8 sides, into buffers", median(whole_ms), "ms", kBarMs, note),
            below("the same over io's swept mesh", median(ratios), "x", 1.0, swept_note),
            below("the same point by point, a call", median(call_us), "us", kGrowingBarUs, growing_note)};
}

}  // namespace flg::bench
