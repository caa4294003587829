// SPDX-License-Identifier: MIT
// Buffers: formats, strides, and what is refused with a sentence and nothing written.
#include <algorithm>
#include <functional>
#include <string>

#include "brush/strokes.h"
#include "core/number_formats.h"

namespace flg::test {
namespace {

// A valid call, to be spoilt.
struct Call {
    Stroke stroke = bent_stroke(10);
    FlgCurveSetView view = stroke.view;
    std::vector<FlgColumn> inputs = stroke.columns;
    FlgBrushMeshDesc desc = flgBrushMeshDefaults();
    FlgBrushMeshSizes sizes = flgBrushMeshSizesDefaults();
    std::vector<Vertex> vertices;
    std::vector<uint32_t> indices;
    std::vector<FlgBufferColumn> columns;
    FlgBrushMeshOutput output = flgBrushMeshOutputDefaults();
    FlgBrushMeshState state = flgBrushMeshStateDefaults();
    bool growing = false;

    Call() {
        stroke.view.columns = nullptr;
        view.columns = inputs.data();
        view.curve_offsets = stroke.offsets.data();
        view.curve_flags = stroke.flags.data();
        inputs[0].data = stroke.positions.data();
        inputs[1].data = stroke.radii.data();
        inputs[2].data = stroke.colors.data();
        desc.curves = &view;
        EXPECT_EQ(flgBrushMeshGetSizes(&desc, nullptr, &sizes), FLG_OK) << flgErrorGetMessage();
        vertices.assign(sizes.vertex_count + 4, Vertex{});
        indices.assign(sizes.index_count, 77);
        columns = columns_of(vertices, false);
        output.columns = columns.data();
        output.column_count = static_cast<uint32_t>(columns.size());
        output.vertex_capacity = sizes.vertex_count;
        output.indices = indices.data();
        output.index_capacity = sizes.index_count;
    }
    Call(const Call&) = delete;
    Call& operator=(const Call&) = delete;

    FlgResult write() { return flgBrushMeshWrite(&desc, growing ? &state : nullptr, &output, nullptr); }
    bool untouched() const {
        const Vertex none = {};
        for (const Vertex& v : vertices) {
            if (std::memcmp(&v, &none, sizeof v) != 0) return false;
        }
        for (const uint32_t i : indices) {
            if (i != 77) return false;
        }
        const FlgBrushMeshState begin = flgBrushMeshStateDefaults();
        return std::memcmp(state.opaque, begin.opaque, sizeof state.opaque) == 0 && state.vertex_count == 0;
    }
};

void expect_refused(const std::function<void(Call&)>& spoil, const std::string& sentence,
                    FlgResult result = FLG_ERROR_INVALID_ARGUMENT) {
    Call call;
    spoil(call);
    EXPECT_EQ(call.write(), result) << sentence;
    EXPECT_NE(std::string(flgErrorGetMessage()).find(sentence), std::string::npos)
        << flgErrorGetMessage() << " / " << sentence;
    EXPECT_TRUE(call.untouched()) << sentence;
}

TEST(BrushRefusals, ValidCallsPass) {
    Call call;
    EXPECT_EQ(call.write(), FLG_OK) << flgErrorGetMessage();
    EXPECT_FALSE(call.untouched());
    Call growing;
    growing.growing = true;
    EXPECT_EQ(growing.write(), FLG_OK) << flgErrorGetMessage();
    Call nothing;
    nothing.output.column_count = 0;
    nothing.output.indices = nullptr;
    EXPECT_EQ(nothing.write(), FLG_OK) << flgErrorGetMessage();
    EXPECT_TRUE(nothing.untouched());
}

TEST(BrushRefusals, Descriptors) {
    EXPECT_EQ(flgBrushMeshWrite(nullptr, nullptr, nullptr, nullptr), FLG_ERROR_INVALID_ARGUMENT);
    EXPECT_STREQ(flgErrorGetMessage(), "desc is null");
    expect_refused([](Call& c) { c.desc.struct_size = 4; }, "desc: struct_size is 4");
    expect_refused([](Call& c) { c.desc.struct_size += 8; }, "desc: struct_size is");
    expect_refused([](Call& c) { c.desc.curves = nullptr; }, "desc.curves is null");
    expect_refused([](Call& c) { c.view.struct_size = 0; }, "desc.curves: struct_size is 0");
    expect_refused([](Call& c) { std::memset(&c.desc.shape, 9, 4); }, "desc.shape is 151587081");
    expect_refused([](Call& c) { std::memset(&c.desc.join, 9, 4); }, "desc.join is");
    expect_refused([](Call& c) { std::memset(&c.desc.start_cap, 9, 4); }, "desc.start_cap is");
    expect_refused([](Call& c) { std::memset(&c.desc.end_cap, 9, 4); }, "desc.end_cap is");
    expect_refused([](Call& c) { std::memset(&c.desc.uv_along, 9, 4); }, "desc.uv_along is");
    expect_refused([](Call& c) { std::memset(&c.desc.uv_around, 9, 4); }, "desc.uv_around is");
    expect_refused([](Call& c) { c.desc.sides = 2; }, "desc.sides is 2, must be 3 to 64");
    expect_refused([](Call& c) { c.desc.sides = 65; }, "desc.sides is 65");
    expect_refused([](Call& c) { c.desc.tolerance = -1; }, "desc.tolerance is -1");
    expect_refused([](Call& c) { c.desc.default_radius = NAN; }, "desc.default_radius is nan");
    expect_refused([](Call& c) { c.desc.radius_scale = 1e31f; }, "desc.radius_scale is");
    expect_refused([](Call& c) { c.desc.cap_length = 2000; }, "desc.cap_length is 2000");
    expect_refused([](Call& c) { c.desc.corner_angle = 4; }, "desc.corner_angle is 4");
    expect_refused([](Call& c) { c.desc.default_color[2] = INFINITY; }, "desc.default_color is inf");
    expect_refused([](Call& c) { c.desc.reserved = 1; }, "desc.reserved is 1, must be 0");
    expect_refused([](Call& c) { c.desc.first_curve = 1; }, "desc.first_curve is 1");
    expect_refused([](Call& c) { c.desc.curve_count = 2; }, "desc.curve_count 2");
    expect_refused([](Call& c) { c.desc.curve_count = 0; }, "desc.curve_count is 0, must be at least 1");
    expect_refused([](Call& c) { c.desc.base_vertex = UINT32_MAX; }, "desc.base_vertex", FLG_ERROR_LIMIT);
}

TEST(BrushRefusals, Curves) {
    expect_refused([](Call& c) { c.view.curve_offsets = nullptr; }, "desc.curves.curve_offsets is null");
    expect_refused([](Call& c) { c.view.curve_count = 0; }, "desc.curves.curve_count is 0");
    expect_refused([](Call& c) { c.stroke.offsets[0] = 1; }, "desc.curves.curve_offsets[0] is 1");
    expect_refused([](Call& c) { c.stroke.offsets[1] = 0; }, "desc.curves.curve_offsets[1] is 0 after 0");
    expect_refused([](Call& c) { c.stroke.flags[0] = 2; }, "desc.curves.curve_flags[0] is 2");
    expect_refused([](Call& c) { c.view.columns = nullptr; }, "desc.curves.columns is null");
    expect_refused([](Call& c) { c.inputs[0].stride = 7; }, "desc.curves.columns[0].stride is 7");
    expect_refused([](Call& c) { c.stroke.positions[5] = NAN; }, "point 1 of curve 0 has a coordinate of nan");
    expect_refused([](Call& c) { c.stroke.radii[3] = -1; }, "point 3 of curve 0 has a radius of -1");
    expect_refused([](Call& c) { c.stroke.colors[4] = INFINITY; }, "point 1 of curve 0 has a colour of inf");
    expect_refused([](Call& c) { c.stroke.radii[3] = 1e30f, c.desc.radius_scale = 2; }, "desc.radius_scale is 2");
}

TEST(BrushRefusals, Buffers) {
    expect_refused([](Call& c) { c.output.struct_size = 0; }, "output: struct_size is 0");
    expect_refused([](Call& c) { c.output.column_count = 6; }, "output.column_count is 6");
    expect_refused([](Call& c) { c.output.columns = nullptr; }, "output.columns is null");
    expect_refused([](Call& c) { c.columns[1].data = nullptr; }, "output.columns[1].data is null");
    expect_refused([](Call& c) { std::memset(&c.columns[1].attribute, 9, 4); }, "output.columns[1].attribute is");
    expect_refused([](Call& c) { std::memset(&c.columns[1].format, 9, 4); }, "output.columns[1].format is");
    expect_refused([](Call& c) { c.columns[0].format = FLG_NUMBER_FORMAT_UNORM8; },
                   "output.columns[0].format is 2, which");
    expect_refused([](Call& c) { c.columns[0].format = FLG_NUMBER_FORMAT_UINT32; },
                   "output.columns[0].format is 6, which");
    expect_refused([](Call& c) { c.columns[1].attribute = FLG_ATTRIBUTE_POSITION; }, "[1].attribute is 0 once more");
    expect_refused([](Call& c) { c.columns[0].data = static_cast<char*>(c.columns[0].data) + 2; },
                   "must be aligned to 4 bytes");
    expect_refused([](Call& c) { c.columns[0].stride = 8; }, "output.columns[0].stride is 8 bytes");
    expect_refused([](Call& c) { c.columns[0].stride = 14; }, "output.columns[0].stride is 14 bytes");
    expect_refused([](Call& c) { c.columns[0].attribute = FLG_ATTRIBUTE_UV; }, "but desc.uv is 0");
    expect_refused([](Call& c) { c.columns[0].attribute = FLG_ATTRIBUTE_RADIUS; },
                   "vertices of brush meshes don't have");
    expect_refused([](Call& c) { c.columns[0].components = 5; }, "output.columns[0].components is 5, must be 0 to 4");
    expect_refused([](Call& c) { c.columns[0].fill[1] = NAN; }, "output.columns[0].fill[1] is nan");
    expect_refused([](Call& c) { c.columns[0].reserved = 1; }, "output.columns[0].reserved is 1");
    expect_refused([](Call& c) { --c.output.vertex_capacity; }, "output.vertex_capacity is");
    expect_refused([](Call& c) { --c.output.index_capacity; }, "output.index_capacity is");
    expect_refused([](Call& c) { c.output.indices = reinterpret_cast<char*>(c.indices.data()) + 1; },
                   "output.indices is 0x");
    expect_refused([](Call& c) { c.output.index_format = FLG_NUMBER_FORMAT_FLOAT32; }, "output.index_format is 0");
    expect_refused(
        [](Call& c) {
            c.output.index_format = FLG_NUMBER_FORMAT_UINT16;
            c.desc.base_vertex = 65500;
        },
        "the limit is 65534", FLG_ERROR_LIMIT);
}

TEST(BrushRefusals, Overlaps) {
    expect_refused([](Call& c) { c.columns[1].data = c.columns[0].data; },
                   "output.columns[1] overlaps output.columns[0]");
    expect_refused([](Call& c) { c.columns[1].data = &c.vertices[3].position[1]; },
                   "output.columns[1] overlaps output.columns[0]");
    expect_refused([](Call& c) { c.columns[1].stride = 12; }, "output.columns[1] overlaps output.columns[0]");
    expect_refused([](Call& c) { c.output.indices = c.vertices.data(); }, "output.indices overlaps output.columns[0]");
    expect_refused([](Call& c) { c.inputs[2].data = c.vertices[2].position; },
                   "output.columns[0] overlaps desc.curves.columns[2]");
    // In one buffer with nothing else: what lies beside a vector of its own is the heap's choice.
    std::vector<float> radii(size_t{1} << 16, 0.1f);
    expect_refused(
        [&](Call& c) {
            c.inputs[2].data = radii.data() + 1;
            c.output.indices = radii.data();
        },
        "output.indices overlaps desc.curves.columns[2]");
}

TEST(BrushRefusals, GrowingCurves) {
    const auto growing = [](const std::function<void(Call&)>& spoil, const std::string& sentence) {
        expect_refused(
            [&](Call& c) {
                c.growing = true;
                spoil(c);
            },
            sentence);
    };
    growing([](Call& c) { c.state.struct_size = 3; }, "state: struct_size is 3");
    growing([](Call& c) { c.stroke.flags[0] = FLG_CURVE_CLOSED; }, "is a closed curve");
    growing([](Call& c) { c.desc.tolerance = 1; }, "desc.tolerance is 1, must be 0 with a state");
    growing([](Call& c) { c.desc.uv = 1, c.desc.uv_along = FLG_BRUSH_UV_UNIT; }, "desc.uv_along is");
    Call call;
    call.growing = true;
    ASSERT_EQ(call.write(), FLG_OK);
    call.desc.sides = 6;
    EXPECT_EQ(call.write(), FLG_ERROR_INVALID_ARGUMENT);
    EXPECT_NE(std::string(flgErrorGetMessage()).find("must stay"), std::string::npos);
    // What is in the buffers is relative to another place.
    Call moved;
    moved.growing = true;
    ASSERT_EQ(moved.write(), FLG_OK);
    moved.view.origin[0] = 10;
    EXPECT_EQ(moved.write(), FLG_ERROR_INVALID_ARGUMENT);
    EXPECT_NE(std::string(flgErrorGetMessage()).find("desc.curves.origin is not that of the calls"), std::string::npos)
        << flgErrorGetMessage();
}

TEST(BrushFormats, HalvesAreTheNearest) {
    EXPECT_EQ(to_half(0.0f), 0);
    EXPECT_EQ(to_half(-0.0f), 0x8000);
    EXPECT_EQ(to_half(1.0f), 0x3c00);
    EXPECT_EQ(to_half(-2.0f), 0xc000);
    EXPECT_EQ(to_half(65504.0f), 0x7bff);
    EXPECT_EQ(to_half(1e30f), 0x7bff);
    EXPECT_EQ(to_half(-1e30f), 0xfbff);
    // Every half that is finite, and halfway to the next.
    for (uint32_t half = 0; half < 0x7bff; ++half) {
        const auto value = [](uint32_t h) {
            const int exponent = static_cast<int>(h >> 10);
            const double fraction = (h & 0x3ff) / 1024.0;
            return exponent == 0 ? std::ldexp(fraction, -14) : std::ldexp(1 + fraction, exponent - 15);
        };
        const double at = value(half), next = value(half + 1);
        ASSERT_EQ(to_half(static_cast<float>(at)), half);
        const uint32_t even = half % 2 == 0 ? half : half + 1;
        ASSERT_EQ(to_half(static_cast<float>((at + next) / 2)), even) << half;
    }
}

TEST(BrushFormats, ColumnsInSmallFormatsAreTheFloatsRounded) {
    const Stroke stroke = bent_stroke();
    FlgBrushMeshDesc desc = desc_of(stroke);
    desc.uv = 1;
    const BrushMesh mesh = mesh_of(desc);
    struct Small {
        uint16_t position[3], uv[2];
        int16_t normal[3];
        int8_t tangent[4];
        uint8_t color[4];
        uint16_t untouched;
    };
    std::vector<Small> small(mesh.vertices.size(), Small{{}, {}, {}, {}, {}, 0x1234});
    std::vector<uint16_t> indices(mesh.indices.size());
    const FlgBufferColumn columns[] = {
        {FLG_ATTRIBUTE_COLOR, FLG_NUMBER_FORMAT_UNORM8, small[0].color, sizeof(Small), 0, {}, 0, 0},
        {FLG_ATTRIBUTE_POSITION, FLG_NUMBER_FORMAT_FLOAT16, small[0].position, sizeof(Small), 0, {}, 0, 0},
        {FLG_ATTRIBUTE_UV, FLG_NUMBER_FORMAT_FLOAT16, small[0].uv, sizeof(Small), 0, {}, 0, 0},
        {FLG_ATTRIBUTE_NORMAL, FLG_NUMBER_FORMAT_SNORM16, small[0].normal, sizeof(Small), 0, {}, 0, 0},
        {FLG_ATTRIBUTE_TANGENT, FLG_NUMBER_FORMAT_SNORM8, small[0].tangent, sizeof(Small), 0, {}, 0, 0}};
    FlgBrushMeshOutput output = flgBrushMeshOutputDefaults();
    output.columns = columns;
    output.column_count = 5;
    output.vertex_capacity = small.size();
    output.indices = indices.data();
    output.index_capacity = indices.size();
    output.index_format = FLG_NUMBER_FORMAT_UINT16;
    ASSERT_EQ(flgBrushMeshWrite(&desc, nullptr, &output, nullptr), FLG_OK) << flgErrorGetMessage();
    for (size_t i = 0; i < indices.size(); ++i) ASSERT_EQ(indices[i], mesh.indices[i]);
    for (size_t v = 0; v < small.size(); ++v) {
        const Vertex& exact = mesh.vertices[v];
        for (int k = 0; k < 3; ++k) {
            ASSERT_EQ(small[v].position[k], to_half(exact.position[k]));
            ASSERT_NEAR(small[v].normal[k] / 32767.0, exact.normal[k], 0.503 / 32767);  // floats count in 0.002
        }
        for (int k = 0; k < 4; ++k) {
            ASSERT_NEAR(small[v].tangent[k] / 127.0, exact.tangent[k], 0.5001 / 127);
            ASSERT_NEAR(small[v].color[k] / 255.0, exact.color[k], 0.5001 / 255);
        }
        for (int k = 0; k < 2; ++k) ASSERT_EQ(small[v].uv[k], to_half(exact.uv[k]));
        ASSERT_EQ(small[v].untouched, 0x1234);
    }
}

TEST(BrushFormats, PackedRowsAndFilledNumbers) {
    const Stroke stroke = bent_stroke();
    const FlgBrushMeshDesc desc = desc_of(stroke);
    const BrushMesh mesh = mesh_of(desc);
    struct Packed {
        float place[4];
        int16_t normal[2], tangent[2];
        uint8_t color[4];
        float uv[2];
        float across[2];
    };
    std::vector<Packed> packed(mesh.vertices.size());
    FlgBufferColumn columns[] = {
        {FLG_ATTRIBUTE_POSITION, FLG_NUMBER_FORMAT_FLOAT32, packed[0].place, sizeof(Packed), 4, {7, 7, 7, 1}, 0, 0},
        {FLG_ATTRIBUTE_NORMAL, FLG_NUMBER_FORMAT_OCTAHEDRAL16, packed[0].normal, sizeof(Packed), 0, {}, 0, 0},
        {FLG_ATTRIBUTE_TANGENT, FLG_NUMBER_FORMAT_OCTAHEDRAL16, packed[0].tangent, sizeof(Packed), 0, {}, 0, 0},
        {FLG_ATTRIBUTE_COLOR, FLG_NUMBER_FORMAT_SRGB8, packed[0].color, sizeof(Packed), 0, {}, 0, 0},
        {FLG_ATTRIBUTE_UV, FLG_NUMBER_FORMAT_FLOAT32, packed[0].uv, sizeof(Packed), 0, {0.25f, 0.5f}, 1, 0}};
    FlgBrushMeshOutput output = flgBrushMeshOutputDefaults();
    output.columns = columns;
    output.column_count = 5;
    output.vertex_capacity = packed.size();
    ASSERT_EQ(flgBrushMeshWrite(&desc, nullptr, &output, nullptr), FLG_OK) << flgErrorGetMessage();
    for (size_t v = 0; v < packed.size(); ++v) {
        const Vertex& exact = mesh.vertices[v];
        int16_t direction[2];
        to_octahedral16(exact.normal, direction);
        ASSERT_EQ(std::memcmp(packed[v].normal, direction, sizeof direction), 0) << v;
        to_octahedral16(exact.tangent, direction);
        ASSERT_EQ(std::memcmp(packed[v].tangent, direction, sizeof direction), 0) << v;
        ASSERT_EQ(std::memcmp(packed[v].place, exact.position, sizeof exact.position), 0) << v;
        ASSERT_EQ(packed[v].place[3], 1) << v;
        for (int k = 0; k < 3; ++k) ASSERT_EQ(packed[v].color[k], to_srgb8(exact.color[k])) << v;
        ASSERT_EQ(packed[v].color[3], to_unorm8(exact.color[3])) << v;
        ASSERT_EQ(packed[v].uv[0], 0.25f);
        ASSERT_EQ(packed[v].uv[1], 0.5f);
    }
    columns[0].components = 2;
    columns[0].data = packed[0].across;
    ASSERT_EQ(flgBrushMeshWrite(&desc, nullptr, &output, nullptr), FLG_OK) << flgErrorGetMessage();
    for (size_t v = 0; v < packed.size(); ++v)
        ASSERT_EQ(std::memcmp(packed[v].across, mesh.vertices[v].position, 2 * sizeof(float)), 0) << v;
}

TEST(BrushFormats, ColumnsAloneHaveTheBitsOfAll) {
    const Stroke stroke = bent_stroke();
    for (const FlgBrushShape shape : {FLG_BRUSH_SHAPE_TUBE, FLG_BRUSH_SHAPE_RIBBON}) {
        FlgBrushMeshDesc desc = desc_of(stroke, shape);
        desc.uv = 1;
        const BrushMesh mesh = mesh_of(desc);
        std::vector<Vertex> alone(mesh.vertices.size());
        std::memset(static_cast<void*>(alone.data()), 0x5a, alone.size() * sizeof(Vertex));
        for (const FlgBufferColumn& column : columns_of(alone, true)) {
            FlgBrushMeshOutput output = flgBrushMeshOutputDefaults();
            output.columns = &column;
            output.column_count = 1;
            output.vertex_capacity = alone.size();
            ASSERT_EQ(flgBrushMeshWrite(&desc, nullptr, &output, nullptr), FLG_OK) << flgErrorGetMessage();
        }
        ASSERT_EQ(std::memcmp(alone.data(), mesh.vertices.data(), alone.size() * sizeof(Vertex)), 0);
    }
}

TEST(BrushFormats, IndicesCountFromTheBase) {
    Call call;
    call.desc.base_vertex = 1000;
    ASSERT_EQ(call.write(), FLG_OK);
    EXPECT_EQ(*std::min_element(call.indices.begin(), call.indices.end()), 1000u);
}

}  // namespace
}  // namespace flg::test
