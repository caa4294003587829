// SPDX-License-Identifier: MIT
// Source: Khronos, glTF 2.0 specification (3.7.2 primitives).
//
// Read: each line primitive of each mesh that a node of the scene shows becomes curves, in the order of the nodes: a
// strip or loop one curve, single lines curves as far as one goes on where the one before it ended (the same index or
// the same position). Nodes' transforms are applied; radii (_RADIUS) grow by the cube root of the volume's change.
// A strip of the indices `a a` is a curve of one point.
//
// Written: lines are one LINE_STRIP or LINE_LOOP a curve, all in shared buffer views. Surfaces are primitives of
// triangles, a material for tubes and one for ribbons, quantized by KHR_mesh_quantization.
#include "io/gltf/gltf_curves.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>
#include <string_view>
#include <type_traits>
#include <utility>

#include "io/base/column_names.h"
#include "io/base/failure.h"
#include "io/base/json_text.h"
#include "io/base/limits.h"
#include "io/base/polylines.h"
#include "io/gltf/glb_builder.h"
#include "io/gltf/gltf_scene.h"
#include "io/gltf/swept_mesh.h"

namespace flg::io {

namespace {

// ---- Columns of curves as attributes of glTF lines, besides positions, colours and radii; filigree_io.h lists them.
// Lengths and speeds grow by the cube root of the volume's change under their node, directions are turned by it.

constexpr uint32_t max_gltf_components = 4;

// One of a primitive's, checked to fit its vertices.
struct GltfColumn {
    FlgAttribute attribute;
    GltfValues values;
};

// A vertex' values, placed: `components` of them are added to `out`.
void append_placed(const GltfColumn& column, uint32_t vertex, const Transform& transform, Vector<float>& out);

struct NamedAttribute {
    FlgAttribute attribute;
    uint32_t components;
    const char* name;
};
constexpr NamedAttribute named[] = {
    {FLG_ATTRIBUTE_NORMAL, 3, "NORMAL"},
    {FLG_ATTRIBUTE_TIME, 1, "_TIME"},
    {FLG_ATTRIBUTE_PRESSURE, 1, "_PRESSURE"},
    {FLG_ATTRIBUTE_STYLE_INDEX, 1, "_STYLE_INDEX"},
    {FLG_ATTRIBUTE_RADII, 3, "_RADII"},
    {FLG_ATTRIBUTE_ANGLE, 1, "_ANGLE"},
    {FLG_ATTRIBUTE_WIDTH, 1, "_WIDTH"},
    {FLG_ATTRIBUTE_SPEED, 1, "_SPEED"},
    {FLG_ATTRIBUTE_DISPLACEMENT, 3, "_DISPLACEMENT"},
};
constexpr std::string_view user_prefix = "_USER";

bool is_direction(FlgAttribute attribute) {
    return attribute == FLG_ATTRIBUTE_NORMAL || attribute == FLG_ATTRIBUTE_DISPLACEMENT;
}

// The leading components, so many, grow with the node.
uint32_t size_count(FlgAttribute attribute) {
    switch (attribute) {
        case FLG_ATTRIBUTE_WIDTH:
        case FLG_ATTRIBUTE_SPEED: return 1;
        case FLG_ATTRIBUTE_RADII: return 2;
        default: return 0;
    }
}

// The attribute of a name and the components it has to have, 0: any; no attribute: POSITION.
NamedAttribute attribute_of(std::string_view name) {
    for (const NamedAttribute& known : named) {
        if (name == known.name) return known;
    }
    constexpr NamedAttribute none = {FLG_ATTRIBUTE_POSITION, 0, ""};
    if (!name.starts_with(user_prefix)) return none;
    name.remove_prefix(user_prefix.size());
    uint32_t number = 0;
    const auto [stop, error] = std::from_chars(name.data(), name.data() + name.size(), number);
    const bool known = error == std::errc{} && stop == name.data() + name.size() &&
                       number < uint32_t{FLG_ATTRIBUTE_FORCE_32BIT} - FLG_ATTRIBUTE_USER;
    if (!known) return none;
    return {static_cast<FlgAttribute>(FLG_ATTRIBUTE_USER + number), 0, ""};
}

// "NORMAL", "_WIDTH", "_USER3"; empty for what has no name in glTF lines, or is named elsewhere.
String gltf_column_name(FlgAttribute attribute) {
    if (attribute >= FLG_ATTRIBUTE_USER) return String(user_prefix) + to_text(attribute - FLG_ATTRIBUTE_USER);
    for (const NamedAttribute& known : named) {
        if (known.attribute == attribute) return known.name;
    }
    return "";
}

Vector<GltfColumn> read_columns(const GltfDocument& document, const GltfPrimitive& primitive, uint64_t vertex_count) {
    constexpr size_t max_columns = 13;  // beside positions, colours and radii
    Vector<GltfColumn> columns;
    for (const JsonMember& member : primitive.json.find("attributes")->members()) {
        const NamedAttribute known = attribute_of(member.name);
        if (known.attribute == FLG_ATTRIBUTE_POSITION) continue;
        GltfValues values = *read_attribute(document, primitive, String(member.name).c_str());
        const bool fits =
            known.components == 0 ? values.components <= max_gltf_components : values.components == known.components;
        if (!fits || values.count != vertex_count) {
            fail(FLG_ERROR_FORMAT, values.place, "holds no values fit for %llu vertices",
                 static_cast<unsigned long long>(vertex_count));
        }
        const auto same = [&](const GltfColumn& other) { return other.attribute == known.attribute; };
        if (columns.size() == max_columns || std::any_of(columns.begin(), columns.end(), same)) {
            fail(FLG_ERROR_FORMAT, values.place, "is one column too many, or one that is there already");
        }
        columns.push_back({known.attribute, std::move(values)});
    }
    return columns;
}

void append_placed(const GltfColumn& column, uint32_t vertex, const Transform& t, Vector<float>& out) {
    const uint32_t count = column.values.components;
    double values[max_gltf_components];
    for (uint32_t k = 0; k < count; ++k) values[k] = column.values.number(vertex, k);
    if (is_direction(column.attribute)) {
        double turned[3];
        for (size_t row = 0; row < 3; ++row) {
            turned[row] = t[row] * values[0] + t[3 + row] * values[1] + t[6 + row] * values[2];
        }
        const double length = std::hypot(turned[0], turned[1], turned[2]);
        const bool unit = column.attribute == FLG_ATTRIBUTE_NORMAL && length > 0;
        for (size_t row = 0; row < 3; ++row) values[row] = unit ? turned[row] / length : turned[row];
    }
    const double scale = size_count(column.attribute) > 0 ? std::cbrt(std::abs(determinant(t))) : 1.0;
    for (uint32_t k = 0; k < count; ++k) {
        const auto value = static_cast<float>(k < size_count(column.attribute) ? scale * values[k] : values[k]);
        if (!(std::abs(value) <= max_coordinate)) refuse_value(column.values, vertex, value);
        if (const char* rule = rule_broken_by(column.attribute, k, value)) {
            fail(FLG_ERROR_FORMAT, column.values.place, "vertex %u gives %g: %s", vertex, double{value}, rule);
        }
        out.push_back(value);
    }
}

// Of positions, radii and colours together: what is made of a file is limited like the file.
constexpr uint64_t floats_per_point = 8;

class GltfReader {
public:
    GltfReader(const Path& path, const Origin& origin) : document_(path), origin_(origin) {}

    CurveData read() {
        data_.format = "gltf";
        data_.units = "metres";
        visit_primitives(document_, origin_, [this](const GltfPrimitive& primitive) { read_primitive(primitive); });
        data_.warn(surfaces_, "primitive", "of points or triangles, left out: only lines are read");
        if (data_.curve_count() == 0) fail(FLG_ERROR_FORMAT, "meshes", "the file shows no lines");
        data_.warn(partial_columns_, "curve", "other columns than the curves before, these left out");
        if (has_radius_) data_.warn(no_radius_, "curve", "no _RADIUS where others have one, set to 0.005 m");
        if (!has_radius_) data_.radii.clear();
        if (!has_color_) data_.colors.clear();
        return std::move(data_);
    }

private:
    void read_primitive(const GltfPrimitive& primitive) {
        if (primitive.mode != gltf_lines && primitive.mode != gltf_line_loop && primitive.mode != gltf_line_strip) {
            surfaces_.add(primitive.index);
            return;
        }
        const GltfVertices vertices = read_vertices(document_, primitive);
        const std::optional<GltfValues> radii = read_attribute(document_, primitive, "_RADIUS");
        if (radii && (radii->components != 1 || radii->count != vertices.positions.count)) {
            fail(FLG_ERROR_FORMAT, radii->place, "holds no radii fit for %llu vertices",
                 static_cast<unsigned long long>(vertices.positions.count));
        }
        const Vector<GltfColumn> columns = read_columns(document_, primitive, vertices.positions.count);
        begin_columns(columns);
        const Polylines lines = read_polylines(primitive, vertices.positions);
        if (!data_.placing.stored) data_.placing.stored = place_of(primitive);
        append(lines, vertices, radii, primitive.transform);
        append_columns(lines, columns, primitive.transform);
    }

    Polylines read_polylines(const GltfPrimitive& primitive, const GltfValues& positions) const {
        const std::optional<GltfValues> values = read_index_values(document_, primitive);
        check_room(values ? values->count : positions.count, primitive.place);
        Vector<uint32_t> indices = read_indices(values, positions.count);

        Polylines lines;
        if (primitive.mode != gltf_lines) {
            lines.indices = std::move(indices);
            lines.end(primitive.mode == gltf_line_loop);
            return lines;
        }
        if (indices.size() % 2 != 0) {
            fail(FLG_ERROR_FORMAT, primitive.place, "has %zu ends of lines, not pairs", indices.size());
        }
        const auto same = [&](uint32_t a, uint32_t b) {
            return a == b || (positions.number(a, 0) == positions.number(b, 0) &&
                              positions.number(a, 1) == positions.number(b, 1) &&
                              positions.number(a, 2) == positions.number(b, 2));
        };
        join_edges(
            indices.size() / 2, [&](size_t e) { return std::pair(indices[2 * e], indices[2 * e + 1]); }, same, lines);
        return lines;
    }

    // Meshes may be shown many times, and primitives share vertices: a small file could ask for very much.
    void check_room(uint64_t points, const String& place) const {
        uint64_t floats = floats_per_point;
        for (const VertexColumn& column : data_.columns) floats += column.components;
        if ((data_.point_count() + points) * floats * sizeof(float) > max_bytes) {
            fail(FLG_ERROR_LIMIT, place, "the file's curves take more than the limit of 2 GiB");
        }
    }

    void append(const Polylines& lines, const GltfVertices& vertices, const std::optional<GltfValues>& radii,
                const Transform& transform) {
        const float radius_scale = static_cast<float>(std::cbrt(std::abs(determinant(transform))));
        has_color_ |= vertices.colors.has_value();
        has_radius_ |= radii.has_value();
        for (size_t c = 0; c < lines.count(); ++c) {
            if (!radii) no_radius_.add(data_.curve_count());
            for (size_t i = lines.offsets[c]; i < lines.offsets[c + 1]; ++i) {
                const uint32_t vertex = lines.indices[i];
                for (float value : vertices.position(vertex, transform)) data_.positions.push_back(value);
                for (float value : vertices.color(vertex)) data_.colors.push_back(value);
                const float radius = radii ? radii->number(vertex, 0) * radius_scale : default_radius;
                if (!(radius >= 0 && radius <= max_coordinate)) refuse_value(*radii, vertex, radius);
                data_.radii.push_back(radius);
            }
            data_.end_curve(lines.closed[c]);
        }
    }

    // Columns are kept while all curves have them.
    void begin_columns(const Vector<GltfColumn>& columns) {
        if (data_.point_count() == 0) {
            for (const GltfColumn& column : columns) {
                data_.columns.push_back({column.attribute, column.values.components, {}});
            }
        }
        const auto is_missing = [&](const VertexColumn& column) { return !find(columns, column); };
        const size_t before = data_.columns.size();
        std::erase_if(data_.columns, is_missing);
        if (data_.columns.size() < before || columns.size() > data_.columns.size()) {
            partial_columns_.add(data_.curve_count());
        }
    }

    static const GltfColumn* find(const Vector<GltfColumn>& columns, const VertexColumn& column) {
        const auto same = [&](const GltfColumn& other) {
            return other.attribute == column.attribute && other.values.components == column.components;
        };
        const auto place = std::find_if(columns.begin(), columns.end(), same);
        return place == columns.end() ? nullptr : &*place;
    }

    void append_columns(const Polylines& lines, const Vector<GltfColumn>& columns, const Transform& transform) {
        for (VertexColumn& column : data_.columns) {
            const GltfColumn& values = *find(columns, column);
            for (uint32_t vertex : lines.indices) append_placed(values, vertex, transform, column.values);
        }
    }

    GltfDocument document_;
    const Origin origin_;
    CurveData data_;
    bool has_color_ = false;
    bool has_radius_ = false;
    Tally surfaces_;
    Tally no_radius_;
    Tally partial_columns_;
};

}  // namespace

CurveData read_gltf(const Path& path, const Origin& origin) {
    return GltfReader(path, origin).read();
}

namespace {

struct LineColumn {
    String name;
    uint32_t components;
    size_t view;
};

// The columns that are written besides positions, colours and radii.
Vector<LineColumn> line_columns(const CheckedView& view, GlbBuilder& glb) {
    Vector<LineColumn> columns;
    for (size_t i = 0; i < view.columns().size(); ++i) {
        const FlgColumn& column = view.columns()[i];
        const String name = gltf_column_name(column.attribute);
        if (name.empty()) continue;
        if (column.components > max_gltf_components) {
            fail(FLG_ERROR_INVALID_ARGUMENT, "view.columns[" + to_text(i) + "].components",
                 "is %u, .glb holds at most 4", column.components);
        }
        const Vector<float> values = packed(resolved(column), view.point_count(), column.components);
        columns.push_back({name, column.components, glb.add_view(values, column.components)});
    }
    return columns;
}

String write_lines(const CheckedView& view, bool all_columns) {
    GlbBuilder glb;
    const Vector<float> positions = packed(view.position, view.point_count(), 3);
    const size_t position_view = glb.add_view(positions, 3);
    size_t color_view = 0;
    size_t radius_view = 0;
    if (view.color) color_view = glb.add_colors(packed(view.color, view.point_count(), 4));
    if (view.radius) radius_view = glb.add_view(packed(view.radius, view.point_count(), 1), 1);
    Vector<LineColumn> columns;
    if (all_columns) columns = line_columns(view, glb);
    String lone_indices;  // of all curves of one point

    for (uint32_t c = 0; c < view.curve_count(); ++c) {
        const size_t first = view.begin(c);
        const size_t count = view.end(c) - first;
        String attributes = "\"POSITION\":" + to_text(glb.add_positions(position_view, positions, first, count));
        if (view.color) {
            const size_t accessor = glb.add_accessor(color_view, first * 4 * sizeof(float), count, glb_float, "VEC4");
            attributes += ",\"COLOR_0\":" + to_text(accessor);
        }
        if (view.radius) {
            const size_t accessor = glb.add_accessor(radius_view, first * sizeof(float), count, glb_float, "SCALAR");
            attributes += ",\"_RADIUS\":" + to_text(accessor);
        }
        for (const LineColumn& column : columns) {
            constexpr const char* types[] = {"SCALAR", "VEC2", "VEC3", "VEC4"};
            const size_t accessor = glb.add_accessor(column.view, first * column.components * sizeof(float), count,
                                                     glb_float, types[column.components - 1]);
            attributes += ",\"" + column.name + "\":" + to_text(accessor);
        }
        if (count == 1 && lone_indices.empty()) {
            const uint32_t zeros[] = {0, 0};
            const size_t accessor = glb.add_accessor(glb.add_view(zeros), 0, 2, glb_unsigned, "SCALAR");
            lone_indices = ",\"indices\":" + to_text(accessor);
        }
        glb.add_primitive(attributes, view.closed(c) ? glb_line_loop : glb_line_strip, count == 1 ? lone_indices : "");
    }
    return glb.finish("", view.origin());
}

// Those of the pieces, tubes first. White, so that programs that give materials without a colour one of their own
// don't.
class SurfaceMaterials {
public:
    explicit SurfaceMaterials(const Vector<SweptPiece>& pieces) {
        const auto has = [&](FlgCurveGeometry geometry) {
            return std::any_of(pieces.begin(), pieces.end(),
                               [&](const SweptPiece& piece) { return piece.geometry == geometry; });
        };
        has_tubes_ = has(FLG_CURVE_GEOMETRY_TUBE);
        constexpr const char* look =
            "\"pbrMetallicRoughness\":{\"baseColorFactor\":[1,1,1,1],\"metallicFactor\":0,\"roughnessFactor\":0.6}}";
        json_ = "\"materials\":[";
        if (has_tubes_) json_ += String("{\"name\":\"tube\",") + look;
        if (has(FLG_CURVE_GEOMETRY_RIBBON)) {
            if (has_tubes_) json_ += ',';
            json_ += String("{\"name\":\"ribbon\",\"doubleSided\":true,") + look;
        }
        json_ += "],";
    }

    const String& json() const { return json_; }
    const char* index(FlgCurveGeometry geometry) const {
        return geometry == FLG_CURVE_GEOMETRY_RIBBON && has_tubes_ ? "1" : "0";
    }

private:
    String json_;
    bool has_tubes_ = false;
};

template <class Number>
Number rounded_share(float share) {
    constexpr float most = std::numeric_limits<Number>::max();
    return static_cast<Number>(std::lround(most * std::clamp(share, std::is_signed_v<Number> ? -1.0f : 0.0f, 1.0f)));
}

constexpr const char* normalized_values = ",\"normalized\":true";

template <class Number>
Vector<Number> rounded_shares(const Vector<float>& shares) {
    Vector<Number> rounded(shares.size());
    std::transform(shares.begin(), shares.end(), rounded.begin(), rounded_share<Number>);
    return rounded;
}

// COLOR_0 in 16 bits, or 8.
size_t add_colors(GlbBuilder& glb, const SweptPiece& piece, bool quantized) {
    const size_t view = quantized ? glb.add_view(rounded_shares<uint8_t>(piece.colors))
                                  : glb.add_view(rounded_shares<uint16_t>(piece.colors));
    return glb.add_accessor(view, 0, piece.vertex_count(), quantized ? glb_unsigned_byte : glb_unsigned_short, "VEC4",
                            normalized_values);
}

size_t add_quantized_normals(GlbBuilder& glb, const SweptPiece& piece) {
    Vector<uint8_t> normals;
    for (size_t i = 0; i < piece.normals.size(); ++i) {
        normals.push_back(static_cast<uint8_t>(rounded_share<int8_t>(piece.normals[i])));
        if (i % 3 == 2) normals.push_back(0);
    }
    return glb.add_accessor(glb.add_view(normals), 0, piece.vertex_count(), glb_byte, "VEC3", normalized_values);
}

// The steps that positions are counted in, from a corner of their box.
struct PositionGrid {
    float corner[3];
    float step;
};

PositionGrid grid_of(const SweptPiece& piece) {
    constexpr float most = 65535;
    PositionGrid grid = {};
    float extent = 0;
    for (size_t k = 0; k < 3; ++k) {
        float low = piece.positions[k], high = low;
        for (size_t i = k; i < piece.positions.size(); i += 3) {
            low = std::min(low, piece.positions[i]);
            high = std::max(high, piece.positions[i]);
        }
        grid.corner[k] = low;
        extent = std::max(extent, high - low);
    }
    grid.step = extent > 0 ? extent / most : 1;
    return grid;
}

size_t add_quantized_positions(GlbBuilder& glb, const SweptPiece& piece, const PositionGrid& grid) {
    Vector<uint16_t> positions;
    int low[3] = {65535, 65535, 65535}, high[3] = {};
    for (size_t i = 0; i < piece.positions.size(); ++i) {
        const size_t k = i % 3;
        const double steps = (double{piece.positions[i]} - double{grid.corner[k]}) / double{grid.step};
        positions.push_back(static_cast<uint16_t>(std::clamp(std::lround(steps), 0l, 65535l)));
        low[k] = std::min<int>(low[k], positions.back());
        high[k] = std::max<int>(high[k], positions.back());
        if (k == 2) positions.push_back(0);
    }
    String bounds;
    for (const auto& [name, values] : {std::pair(",\"min\":[", low), std::pair(",\"max\":[", high)}) {
        bounds += name;
        for (size_t k = 0; k < 3; ++k) {
            if (k != 0) bounds += ',';
            bounds += to_text(values[k]);
        }
        bounds += ']';
    }
    const size_t view = glb.add_view(positions);
    return glb.add_accessor(view, 0, piece.vertex_count(), glb_unsigned_short, "VEC3", bounds);
}

// Adds the piece's primitive; its POSITION accessor is there already.
void add_piece(GlbBuilder& glb, const SweptPiece& piece, const SurfaceMaterials& materials, size_t positions,
               bool quantized) {
    const size_t normals =
        quantized ? add_quantized_normals(glb, piece)
                  : glb.add_accessor(glb.add_view(piece.normals, 3), 0, piece.vertex_count(), glb_float, "VEC3");
    String attributes = "\"POSITION\":" + to_text(positions) + ",\"NORMAL\":" + to_text(normals);
    if (!piece.colors.empty()) attributes += ",\"COLOR_0\":" + to_text(add_colors(glb, piece, quantized));
    const size_t indices = glb.add_indices(piece.indices);
    String rest = ",\"indices\":";
    rest += to_text(indices);
    rest += ",\"material\":";
    rest += materials.index(piece.geometry);
    glb.add_primitive(attributes, glb_triangles, rest);
}

// A mesh and a node for each piece: the node takes steps to metres. Pieces too wide for steps within the tolerance have
// positions in floats.
String write_quantized(const Vector<SweptPiece>& pieces, const Origin& origin, float tolerance) {
    GlbBuilder glb;
    const SurfaceMaterials materials(pieces);
    String nodes, roots;
    for (const SweptPiece& piece : pieces) {
        const PositionGrid grid = grid_of(piece);
        const bool fits = !(tolerance > 0) || grid.step <= tolerance;
        const size_t positions =
            fits ? add_quantized_positions(glb, piece, grid)
                 : glb.add_positions(glb.add_view(piece.positions, 3), piece.positions, 0, piece.vertex_count());
        add_piece(glb, piece, materials, positions, true);
        const String mesh = to_text(glb.end_mesh());
        if (!roots.empty()) {
            roots += ',';
            nodes += ',';
        }
        roots += mesh;
        nodes += "{\"mesh\":";
        nodes += mesh;
        if (fits) {
            nodes += ",\"translation\":";
            nodes += json_triple(double{grid.corner[0]} + origin[0], double{grid.corner[1]} + origin[1],
                                 double{grid.corner[2]} + origin[2]);
            nodes += ",\"scale\":";
            nodes += json_triple(double{grid.step}, double{grid.step}, double{grid.step});
        } else {
            nodes += json_translation(origin);
        }
        nodes += '}';
    }
    String top =
        "\"extensionsUsed\":[\"KHR_mesh_quantization\"],\"extensionsRequired\":[\"KHR_mesh_quantization\"],"
        "\"scene\":0,\"scenes\":[{\"nodes\":[";
    top += roots;
    top += "]}],\"nodes\":[";
    top += nodes;
    top += "],";
    top += materials.json();
    return glb.finish_scene(top, "");
}

String write_surface(const CheckedView& view, const FlgCurveFileWriteDesc& desc) {
    const Vector<SweptPiece> pieces = sweep(view, desc);
    if (pieces.empty()) {
        fail(FLG_ERROR_INVALID_ARGUMENT, "view", "has no curve with a length: there is no surface to write");
    }
    // A radius near the limit may carry a vertex beyond it.
    for (const SweptPiece& piece : pieces) {
        for (float value : piece.positions) {
            if (!std::isfinite(value))
                fail(FLG_ERROR_INVALID_ARGUMENT, "view", "has radii too large for its positions");
        }
    }
    if (desc.quantize) return write_quantized(pieces, view.origin(), desc.tolerance);
    GlbBuilder glb;
    const SurfaceMaterials materials(pieces);
    for (const SweptPiece& piece : pieces) {
        const size_t view_index = glb.add_view(piece.positions, 3);
        add_piece(glb, piece, materials, glb.add_positions(view_index, piece.positions, 0, piece.vertex_count()),
                  false);
    }
    return glb.finish(materials.json(), view.origin());
}

}  // namespace

String write_glb(const CheckedView& view, const FlgCurveFileWriteDesc& desc) {
    const bool lines = !desc.geometries && desc.geometry == FLG_CURVE_GEOMETRY_LINES;
    return lines ? write_lines(view, desc.all_columns != 0) : write_surface(view, desc);
}

}  // namespace flg::io
