// SPDX-License-Identifier: MIT
// Source: Khronos, glTF 2.0 specification (3.7.2 primitives).
// Each line primitive of each mesh that a node of the scene shows becomes curves, in the order of the nodes: a strip or
// loop one curve, single lines curves as far as one goes on where the one before it ended (the same index or the same
// position). Nodes' transforms are applied; radii (_RADIUS) grow by the cube root of the volume's change.
// A strip of the indices `a a` is a curve of one point (gltf_writer.cpp writes them so).
#include "io/gltf_reader.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "io/failure.h"
#include "io/gltf_columns.h"
#include "io/gltf_scene.h"
#include "io/limits.h"
#include "io/polylines.h"

namespace flg::io {

namespace {

// Of positions, radii and colours together: what is made of a file is limited like the file.
constexpr uint64_t floats_per_point = 8;

class GltfReader {
public:
    explicit GltfReader(const std::filesystem::path& path) : document_(path) {}

    CurveData read() {
        data_.format = "gltf";
        data_.units = "metres";
        visit_primitives(document_, [this](const GltfPrimitive& primitive) { read_primitive(primitive); });
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
        const std::vector<GltfColumn> columns = read_columns(document_, primitive, vertices.positions.count);
        begin_columns(columns);
        const Polylines lines = read_polylines(primitive, vertices.positions);
        append(lines, vertices, radii, primitive.transform);
        append_columns(lines, columns, primitive.transform);
    }

    Polylines read_polylines(const GltfPrimitive& primitive, const GltfValues& positions) const {
        const std::optional<GltfValues> values = read_index_values(document_, primitive);
        check_room(values ? values->count : positions.count, primitive.place);
        std::vector<uint32_t> indices = read_indices(values, positions.count);

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
    void check_room(uint64_t points, const std::string& place) const {
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
    void begin_columns(const std::vector<GltfColumn>& columns) {
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

    static const GltfColumn* find(const std::vector<GltfColumn>& columns, const VertexColumn& column) {
        const auto same = [&](const GltfColumn& other) {
            return other.attribute == column.attribute && other.values.components == column.components;
        };
        const auto place = std::find_if(columns.begin(), columns.end(), same);
        return place == columns.end() ? nullptr : &*place;
    }

    void append_columns(const Polylines& lines, const std::vector<GltfColumn>& columns, const Transform& transform) {
        for (VertexColumn& column : data_.columns) {
            const GltfColumn& values = *find(columns, column);
            for (uint32_t vertex : lines.indices) append_placed(values, vertex, transform, column.values);
        }
    }

    GltfDocument document_;
    CurveData data_;
    bool has_color_ = false;
    bool has_radius_ = false;
    Tally surfaces_;
    Tally no_radius_;
    Tally partial_columns_;
};

}  // namespace

CurveData read_gltf(const std::filesystem::path& path) {
    return GltfReader(path).read();
}

}  // namespace flg::io
