// SPDX-License-Identifier: MIT
// Brush meshes: descriptors, curves and buffers checked whole before anything is written.
#include <algorithm>
#include <cmath>
#include <cstring>

#include "api/columns.h"
#include "api/descriptors.h"
#include "api/error.h"
#include "api/host_buffers.h"
#include "api/inputs.h"
#include "brush/brush_mesh.h"
#include "core/number_formats.h"
#include "filigree/filigree_brush.h"

namespace flg {
namespace {

constexpr uint64_t max_vertices = UINT32_MAX;

static_assert(sizeof(brush::Growth) + sizeof(uint64_t) + sizeof(Origin) <= sizeof FlgBrushMeshState::opaque);

FlgBrushMeshDesc default_desc() {
    auto desc = sized<FlgBrushMeshDesc>();
    desc.shape = FLG_BRUSH_SHAPE_TUBE;
    desc.sides = 8;
    desc.curve_count = FLG_UNLIMITED;
    desc.default_radius = 0.005f;
    desc.radius_scale = 1;
    std::fill(desc.default_color, desc.default_color + 4, 1.0f);
    desc.start_cap = desc.end_cap = FLG_BRUSH_CAP_FLAT;
    desc.cap_length = 2;
    desc.join = FLG_BRUSH_JOIN_MITER;
    desc.corner_angle = 0.785398163f;
    desc.uv_along = FLG_BRUSH_UV_METRES;
    desc.uv_around = FLG_BRUSH_UV_UNIT;
    return desc;
}

FlgBrushMeshOutput default_output() {
    auto output = sized<FlgBrushMeshOutput>();
    output.index_format = FLG_NUMBER_FORMAT_UINT32;
    return output;
}

bool is_size(float value) {
    return value >= 0 && is_coordinate(value);
}

void check_desc(const FlgBrushMeshDesc& desc) {
    check_enum(desc.shape, FLG_BRUSH_SHAPE_RIBBON, FLG_BRUSH_SHAPE_TUBE, "desc.shape", "FLG_BRUSH_SHAPE_");
    check_enum(desc.start_cap, FLG_BRUSH_CAP_NONE, FLG_BRUSH_CAP_TAPERED, "desc.start_cap", "FLG_BRUSH_CAP_");
    check_enum(desc.end_cap, FLG_BRUSH_CAP_NONE, FLG_BRUSH_CAP_TAPERED, "desc.end_cap", "FLG_BRUSH_CAP_");
    check_enum(desc.join, FLG_BRUSH_JOIN_MITER, FLG_BRUSH_JOIN_NARROW, "desc.join", "FLG_BRUSH_JOIN_");
    check_enum(desc.uv_along, FLG_BRUSH_UV_UNIT, FLG_BRUSH_UV_METRES, "desc.uv_along", "FLG_BRUSH_UV_");
    check_enum(desc.uv_around, FLG_BRUSH_UV_UNIT, FLG_BRUSH_UV_METRES, "desc.uv_around", "FLG_BRUSH_UV_");
    check_range(desc.sides >= brush::min_sides && desc.sides <= brush::max_sides, "desc.sides", desc.sides, "3 to 64");
    check_range(is_size(desc.tolerance), "desc.tolerance", desc.tolerance, "0 to 1e30");
    check_range(is_size(desc.default_radius), "desc.default_radius", desc.default_radius, "0 to 1e30");
    check_range(is_size(desc.radius_scale), "desc.radius_scale", desc.radius_scale, "0 to 1e30");
    check_range(desc.cap_length >= 0 && desc.cap_length <= 1000, "desc.cap_length", desc.cap_length, "0 to 1000");
    check_range(desc.corner_angle >= 0 && desc.corner_angle <= 3.15f, "desc.corner_angle", desc.corner_angle,
                "0 to pi");
    for (const float value : desc.default_color)
        check_range(is_coordinate(value), "desc.default_color", value, "finite and at most 1e30 in size");
    check_range(desc.reserved == 0, "desc.reserved", desc.reserved, "0");
}

// The range of curves that a descriptor asks for, with columns resolved.
class Curves {
public:
    explicit Curves(const FlgBrushMeshDesc& desc) : desc_(desc) {
        FlgCurveSetView none{};
        none.struct_size = sizeof none;
        view_ = read_struct(desc.curves, none, "desc.curves");
        check_structure();
        check_columns(view_.columns, view_.column_count, "desc.curves");
        position_ = column(FLG_ATTRIBUTE_POSITION);
        radius_ = column(FLG_ATTRIBUTE_RADIUS);
        color_ = column(FLG_ATTRIBUTE_COLOR);
        if (desc.shape == FLG_BRUSH_SHAPE_RIBBON) normal_ = column(FLG_ATTRIBUTE_NORMAL);
        for (uint32_t c = desc.first_curve; c < end(); ++c) check_values(c);
    }

    uint32_t begin() const { return desc_.first_curve; }
    uint32_t end() const {
        return desc_.curve_count == FLG_UNLIMITED ? view_.curve_count : desc_.first_curve + desc_.curve_count;
    }
    const FlgCurveSetView& view() const { return view_; }

    // Its points from the range's first on; none may be left.
    brush::Curve curve(uint32_t c) const {
        const uint32_t first = first_point(c);
        const auto from = [&](brush::Column column) {
            if (column) column.data = column.at(first);
            return column;
        };
        brush::Curve curve;
        curve.position = from(position_);
        curve.radius = from(radius_);
        curve.color = from(color_);
        curve.normal = from(normal_);
        curve.count = view_.curve_offsets[c + 1] - first;
        curve.closed = view_.curve_flags && (view_.curve_flags[c] & FLG_CURVE_CLOSED);
        curve.default_radius = desc_.default_radius;
        curve.radius_scale = desc_.radius_scale;
        std::copy(desc_.default_color, desc_.default_color + 4, curve.default_color);
        return curve;
    }

private:
    uint32_t first_point(uint32_t c) const {
        const uint32_t first = view_.curve_offsets[c];
        return first + std::min(desc_.first_point, view_.curve_offsets[c + 1] - first);
    }
    void check_structure() const {
        const uint32_t* const offsets = &require(view_.curve_offsets, "desc.curves.curve_offsets");
        check_range(view_.curve_count > 0, "desc.curves.curve_count", 0, "at least 1");
        check_range(offsets[0] == 0, "desc.curves.curve_offsets[0]", offsets[0], "0");
        for (uint32_t c = 0; c < view_.curve_count; ++c) {
            if (offsets[c + 1] <= offsets[c]) {
                throw Failure(FLG_ERROR_INVALID_ARGUMENT,
                              "desc.curves.curve_offsets[%u] is %u after %u; every curve needs at least one point",
                              c + 1, offsets[c + 1], offsets[c]);
            }
            if (view_.curve_flags && (view_.curve_flags[c] & ~FLG_CURVE_CLOSED) != 0) {
                throw Failure(FLG_ERROR_INVALID_ARGUMENT,
                              "desc.curves.curve_flags[%u] is %u, must be 0 or FLG_CURVE_CLOSED", c,
                              view_.curve_flags[c]);
            }
        }
        check_range(desc_.curve_count > 0, "desc.curve_count", 0, "at least 1");
        const bool is_limited = desc_.curve_count != FLG_UNLIMITED;
        if (desc_.first_curve >= view_.curve_count ||
            (is_limited && desc_.curve_count > view_.curve_count - desc_.first_curve)) {
            throw Failure(FLG_ERROR_INVALID_ARGUMENT,
                          "desc.first_curve is %u and desc.curve_count %u, but there are %u curves", desc_.first_curve,
                          desc_.curve_count, view_.curve_count);
        }
    }
    brush::Column column(FlgAttribute attribute) const {
        const FlgColumn* const found = find_column(view_.columns, view_.column_count, attribute);
        if (!found) return {};
        return {found->data, found->stride ? found->stride / sizeof(float) : found->components};
    }
    void check_values(uint32_t c) const {
        const uint32_t first = first_point(c), last = view_.curve_offsets[c + 1];
        const auto check = [&](const brush::Column& values, uint32_t components, float least, const char* name) {
            if (!values) return;
            for (uint32_t i = first; i < last; ++i) {
                const float* const at = values.at(i);
                bool sound = true;
                for (uint32_t k = 0; k < components; ++k) sound &= is_coordinate(at[k]) && at[k] >= least;
                if (sound) continue;
                const float* const bad = std::find_if(
                    at, at + components, [&](float value) { return !(is_coordinate(value) && value >= least); });
                throw Failure(
                    FLG_ERROR_INVALID_ARGUMENT,
                    "desc.curves: point %u of curve %u has a %s of %g, must be finite, at most 1e30 in size%s",
                    i - view_.curve_offsets[c], c, name, static_cast<double>(*bad),
                    least == 0 ? " and not negative" : "");
            }
        };
        check(position_, 3, -HUGE_VALF, "coordinate");
        check(radius_, 1, 0, "radius");
        check(color_, 4, -HUGE_VALF, "colour");
        check(normal_, 3, -HUGE_VALF, "normal");
        if (!radius_) return;
        for (uint32_t i = first; i < last; ++i) {
            if (is_coordinate(desc_.radius_scale * *radius_.at(i))) continue;
            throw Failure(FLG_ERROR_INVALID_ARGUMENT,
                          "desc.radius_scale is %g, with which point %u of curve %u gets "
                          "a radius above 1e30",
                          static_cast<double>(desc_.radius_scale), i - view_.curve_offsets[c], c);
        }
    }

    const FlgBrushMeshDesc& desc_;
    FlgCurveSetView view_;
    brush::Column position_, radius_, color_, normal_;
};

brush::Style style_of(const FlgBrushMeshDesc& desc, const brush::Curve& curve) {
    brush::Style style;
    style.shape = desc.shape;
    style.start_cap = desc.start_cap;
    style.end_cap = desc.end_cap;
    style.join = desc.join;
    style.cap_length = desc.cap_length;
    style.corner_angle = double{desc.corner_angle};
    style.sides = desc.sides;
    if (desc.tolerance > 0) {
        const double widest = double{brush::widest_radius(curve)};
        style.sides = brush::sides_within(widest, double{desc.tolerance}, desc.sides);
    }
    style.hard = desc.hard_normals != 0;
    style.uv = desc.uv != 0;
    style.uv_along_unit = desc.uv_along == FLG_BRUSH_UV_UNIT;
    style.uv_around_unit = desc.uv_around == FLG_BRUSH_UV_UNIT;
    style.left_handed = desc.left_handed != 0;
    return style;
}

// What tells whether calls with one state belong together.
uint64_t layout_of(const FlgBrushMeshDesc& desc) {
    uint64_t layout = desc.sides;
    for (const int64_t part : {int64_t{desc.shape}, int64_t{desc.join}, int64_t{desc.start_cap},
                               int64_t{desc.hard_normals != 0}, int64_t{desc.uv != 0}, int64_t{desc.left_handed != 0}})
        layout = 8 * layout + static_cast<uint64_t>(part);
    return layout;
}

// A state as the host keeps it.
struct KeptGrowth {
    uint64_t layout = 0;
    Origin origin{};
    brush::Growth growth;
};

KeptGrowth read_state(const FlgBrushMeshState& state, const FlgBrushMeshDesc& desc, const Curves& curves) {
    if (curves.end() - curves.begin() != 1) {
        throw Failure(FLG_ERROR_INVALID_ARGUMENT, "desc.curve_count is %u curves, must be 1 with a state",
                      curves.end() - curves.begin());
    }
    const uint8_t* const flags = curves.view().curve_flags;
    if (flags && flags[curves.begin()] != 0)
        throw Failure(FLG_ERROR_INVALID_ARGUMENT, "desc.first_curve is a closed curve: only open ones grow");
    check_range(desc.tolerance == 0, "desc.tolerance", desc.tolerance, "0 with a state");
    if (desc.uv != 0 && desc.uv_along == FLG_BRUSH_UV_UNIT)
        throw Failure(FLG_ERROR_INVALID_ARGUMENT,
                      "desc.uv_along is FLG_BRUSH_UV_UNIT, but the length of a growing "
                      "curve is not known");
    KeptGrowth kept;
    kept.layout = layout_of(desc);
    std::copy_n(curves.view().origin, 3, kept.origin.begin());
    if (!state.begun) return kept;
    const Origin origin = kept.origin;
    std::memcpy(static_cast<void*>(&kept), state.opaque, sizeof kept);
    if (kept.layout != layout_of(desc)) {
        throw Failure(FLG_ERROR_INVALID_ARGUMENT,
                      "desc is not that of the calls that made the state: shape, sides, "
                      "join, start_cap, hard_normals, uv and left_handed must stay");
    }
    if (kept.origin != origin) {
        throw Failure(FLG_ERROR_INVALID_ARGUMENT,
                      "desc.curves.origin is not that of the calls that made the state: %.17g %.17g %.17g",
                      kept.origin[0], kept.origin[1], kept.origin[2]);
    }
    return kept;
}

// A call that was checked, but for its buffers.
struct Request {
    FlgBrushMeshDesc desc;
    Curves curves;
    bool growing;
    KeptGrowth kept;
    FlgBrushMeshSizes sizes = sized<FlgBrushMeshSizes>();

    Request(const FlgBrushMeshDesc* given, const FlgBrushMeshState* state)
        : desc(checked(given)), curves(desc), growing(state != nullptr) {
        if (state) {
            check_struct_size<FlgBrushMeshState>(state->struct_size, "state");
            kept = read_state(*state, desc, curves);
            sizes.first_vertex = kept.growth.before.vertices;
            sizes.first_index = kept.growth.before.indices;
        }
        for (uint32_t c = curves.begin(); c < curves.end(); ++c) {
            const brush::Curve curve = curves.curve(c);
            const brush::Counts counts = brush::count(curve, style_of(desc, curve), state ? &kept.growth : nullptr);
            sizes.vertex_count += counts.vertices;
            sizes.index_count += counts.indices;
        }
        if (end_vertex() > max_vertices) {
            throw Failure(FLG_ERROR_LIMIT,
                          "the mesh has %llu vertices from desc.base_vertex = %u on, the limit is "
                          "2^32 - 1",
                          static_cast<unsigned long long>(sizes.vertex_count), desc.base_vertex);
        }
    }
    uint64_t end_vertex() const { return desc.base_vertex + sizes.first_vertex + sizes.vertex_count; }

private:
    static FlgBrushMeshDesc checked(const FlgBrushMeshDesc* given) {
        const FlgBrushMeshDesc desc = read_struct(given, default_desc(), "desc");
        check_desc(desc);
        return desc;
    }
};

// A column of vertices, and how many numbers it has.
struct Kind {
    FlgAttribute attribute;
    uint32_t components;
};
constexpr Kind kinds[brush::column_kinds] = {{FLG_ATTRIBUTE_POSITION, 3},
                                             {FLG_ATTRIBUTE_NORMAL, 3},
                                             {FLG_ATTRIBUTE_TANGENT, 4},
                                             {FLG_ATTRIBUTE_COLOR, 4},
                                             {FLG_ATTRIBUTE_UV, 2}};

// What a call writes to, checked.
class Buffers {
public:
    Buffers(const FlgBrushMeshOutput& given, const Request& request) : given_(given), request_(request) {
        check_range(given.column_count <= brush::column_kinds, "output.column_count", given.column_count, "0 to 5");
        if (given.column_count > 0) require(given.columns, "output.columns");
        for (uint32_t i = 0; i < given.column_count; ++i) add_column(i);
        if (given.column_count > 0)
            check_capacity(given.vertex_capacity, request.sizes.vertex_count, "output.vertex_capacity");
        if (given.indices) add_indices();
        add_inputs();
        blocks_.check_apart();
        output_.first_index_value = static_cast<uint32_t>(request.desc.base_vertex + request.sizes.first_vertex);
    }
    brush::Output& output() { return output_; }

private:
    void add_column(uint32_t i) {
        check_buffer_column(given_.columns, i);
        FlgBufferColumn column = given_.columns[i];
        const auto named = [i](const char* field) { return BlockName("output.columns[%u].%s", i, field); };
        const Kind* const kind = std::find_if(std::begin(kinds), std::end(kinds),
                                              [&](const Kind& k) { return k.attribute == column.attribute; });
        if (kind == std::end(kinds)) {
            throw Failure(FLG_ERROR_INVALID_ARGUMENT,
                          "output.columns[%u].attribute is %d, which vertices of brush meshes don't have", i,
                          static_cast<int>(column.attribute));
        }
        if (column.attribute == FLG_ATTRIBUTE_UV && request_.desc.uv == 0 && !column.optional)
            throw Failure(FLG_ERROR_INVALID_ARGUMENT,
                          "output.columns[%u] are texture coordinates, but desc.uv is 0; `optional` would fill them",
                          i);
        check_range(column.components <= 4, named("components").text, column.components, "0 to 4");
        if (column.components == 0)
            column.components = column.format == FLG_NUMBER_FORMAT_OCTAHEDRAL16 ? 3 : kind->components;
        const uint32_t size = row_size(column.format, column.components);
        column.stride = checked_stride(column.stride, bytes_of(column.format), size, named("stride").text);
        output_.columns[kind - kinds] = column;
        blocks_.add_output(
            {BlockName("output.columns[%u]", i), column.data, column.stride, size, request_.sizes.vertex_count});
    }
    void add_indices() {
        check_indices(given_.indices, given_.index_format, given_.index_capacity, request_.sizes.index_count,
                      request_.end_vertex());
        output_.narrow_indices = given_.index_format == FLG_NUMBER_FORMAT_UINT16;
        output_.indices = given_.indices;
        const uint32_t number = bytes_of(given_.index_format);
        blocks_.add_output({BlockName("output.indices"), given_.indices, number, number, request_.sizes.index_count});
    }
    void add_inputs() {
        const FlgCurveSetView& view = request_.curves.view();
        for (uint32_t c = 0; c < view.column_count; ++c)
            blocks_.add_input(view.columns[c], view.curve_offsets[view.curve_count],
                              BlockName("desc.curves.columns[%u]", c));
    }

    const FlgBrushMeshOutput& given_;
    const Request& request_;
    brush::Output output_;
    Blocks blocks_;
};

}  // namespace
}  // namespace flg

using namespace flg;

extern "C" {

FlgResult flgBrushMeshDescInit(FlgBrushMeshDesc* desc, uint32_t struct_size) {
    return guarded([&] {
        init_struct(desc, struct_size, default_desc(), "desc");
        return FLG_OK;
    });
}

FlgResult flgBrushMeshStateInit(FlgBrushMeshState* state, uint32_t struct_size) {
    return guarded([&] {
        init_struct(state, struct_size, sized<FlgBrushMeshState>(), "state");
        return FLG_OK;
    });
}

FlgResult flgBrushMeshSizesInit(FlgBrushMeshSizes* sizes, uint32_t struct_size) {
    return guarded([&] {
        init_struct(sizes, struct_size, sized<FlgBrushMeshSizes>(), "sizes");
        return FLG_OK;
    });
}

FlgResult flgBrushMeshOutputInit(FlgBrushMeshOutput* output, uint32_t struct_size) {
    return guarded([&] {
        init_struct(output, struct_size, default_output(), "output");
        return FLG_OK;
    });
}

FlgResult flgBrushMeshGetSizes(const FlgBrushMeshDesc* desc, const FlgBrushMeshState* state,
                               FlgBrushMeshSizes* out_sizes) {
    return guarded([&] {
        write_struct(out_sizes, sized<FlgBrushMeshSizes>(), "out_sizes");
        const Request request(desc, state);
        write_struct(out_sizes, request.sizes, "out_sizes");
        return FLG_OK;
    });
}

FlgResult flgBrushMeshWrite(const FlgBrushMeshDesc* desc, FlgBrushMeshState* state, const FlgBrushMeshOutput* output,
                            FlgBrushMeshSizes* out_sizes) {
    return guarded([&] {
        if (out_sizes) write_struct(out_sizes, sized<FlgBrushMeshSizes>(), "out_sizes");
        Request request(desc, state);
        const FlgBrushMeshOutput given = read_struct(output, default_output(), "output");
        Buffers buffers(given, request);
        const FlgBrushMeshSizes& sizes = request.sizes;
        brush::Output& to = buffers.output();
        for (uint32_t c = request.curves.begin(); c < request.curves.end(); ++c) {
            const brush::Curve curve = request.curves.curve(c);
            const brush::Counts counts = brush::write(curve, style_of(request.desc, curve), to,
                                                      request.growing ? &request.kept.growth : nullptr);
            brush::advance(to, counts);
        }
        if (state) {
            state->begun = 1;
            state->vertex_count = sizes.first_vertex + sizes.vertex_count;
            state->index_count = sizes.first_index + sizes.index_count;
            std::memcpy(state->opaque, &request.kept, sizeof request.kept);
        }
        if (out_sizes) write_struct(out_sizes, sizes, "out_sizes");
        return FLG_OK;
    });
}

}  // extern "C"
