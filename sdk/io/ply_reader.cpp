// SPDX-License-Identifier: MIT
// Source: Turk, The PLY Polygon File Format (1994); strips as in the models of the Stanford 3D Scanning Repository: one
// list of vertices, where -1 begins a new strip, every other triangle turns the other way, and triangles that name a
// vertex twice only lead on.
// Invariant: nothing is allocated for rows that the file has no room for.
#include "io/ply_reader.h"

#include <algorithm>
#include <limits>

#include "io/ply_rows.h"

namespace flg::io {

namespace {

// Where the value of a vertex's property goes.
struct VertexTarget {
    float* values = nullptr;  // null: nowhere
    uint32_t stride = 0;      // floats
    float scale = 1;
};

bool is_index_list(const PlyProperty& property) {
    return property.is_list() && is_integer(property.type) &&
           (property.name == "vertex_indices" || property.name == "vertex_index");
}

float largest_integer(PlyType type) {
    switch (type) {
        case PlyType::int8: return std::numeric_limits<int8_t>::max();
        case PlyType::uint8: return std::numeric_limits<uint8_t>::max();
        case PlyType::int16: return std::numeric_limits<int16_t>::max();
        case PlyType::uint16: return std::numeric_limits<uint16_t>::max();
        case PlyType::int32: return static_cast<float>(std::numeric_limits<int32_t>::max());
        default: return static_cast<float>(std::numeric_limits<uint32_t>::max());
    }
}

template <class Rows>
class PlyReader {
public:
    PlyReader(const PlyHeader& header, Rows rows) : header_(header), rows_(std::move(rows)) {}

    MeshData read() {
        data_.format = "ply";
        check_elements();
        for (const PlyElement& element : header_.elements) {
            // Rows of nothing take no place.
            if (element.properties.empty()) continue;
            check_count(element);
            if (element.name == "vertex")
                read_vertices(element);
            else if (element.name == "face")
                read_faces(element);
            else if (element.name == "tristrips")
                read_strips(element);
            else
                skip_rows(element);
        }
        if (data_.triangles.empty()) fail(FLG_ERROR_FORMAT, rows_.place(), "the file holds no faces");
        pad_labels();
        return std::move(data_);
    }

    // What follows the last row.
    const Rows& rows() const { return rows_; }

private:
    void check_elements() {
        const PlyElement* vertex = header_.find("vertex");
        if (!vertex) fail(FLG_ERROR_FORMAT, "", "has no element vertex");
        for (const char* name : {"x", "y", "z"}) {
            const PlyProperty* property = vertex->find(name);
            if (property && !property->is_list()) continue;
            fail(FLG_ERROR_FORMAT, line_place(vertex->line), "the element vertex has no property %s", name);
        }
        for (const char* name : {"face", "tristrips"}) {
            const PlyElement* element = header_.find(name);
            if (!element || element->count == 0) continue;
            bool has_indices = false;
            for (const PlyProperty& property : element->properties) has_indices |= is_index_list(property);
            if (has_indices) continue;
            fail(FLG_ERROR_FORMAT, line_place(element->line), "the element %s has no list of integers vertex_indices",
                 name);
        }
        vertex_count_ = vertex->count;
    }

    void check_count(const PlyElement& element) const {
        // The last line of a text may lack its end.
        const uint64_t fitting = (rows_.left() + 1) / header_.least_row(element);
        if (element.count <= fitting) return;
        fail(FLG_ERROR_FORMAT, line_place(element.line), "declares %llu rows of the element %s, but at most %llu fit",
             static_cast<unsigned long long>(element.count), cited(element.name).c_str(),
             static_cast<unsigned long long>(fitting));
    }

    void skip(const PlyProperty& property) {
        uint64_t count = property.is_list() ? read_list_size(property) : 1;
        for (; count > 0; --count) rows_.skip(property.type, property.name.c_str());
    }

    uint64_t read_list_size(const PlyProperty& property) {
        const int64_t count = rows_.integer(property.count_type, property.name.c_str());
        if (count < 0) {
            fail(FLG_ERROR_FORMAT, rows_.place(), "the list %s has %lld values", property.name.c_str(),
                 static_cast<long long>(count));
        }
        return static_cast<uint64_t>(count);
    }

    void skip_rows(const PlyElement& element) {
        for (uint64_t row = 0; row < element.count; ++row) {
            rows_.begin_row(element);
            for (const PlyProperty& property : element.properties) skip(property);
            rows_.end_row();
        }
    }

    VertexTarget target(const PlyProperty& property) {
        if (property.is_list()) return {};
        for (uint32_t k = 0; k < 3; ++k) {
            if (property.name == column_name(FLG_ATTRIBUTE_POSITION, 3, k)) {
                return {data_.positions.data() + k, 3, 1};
            }
        }
        for (VertexColumn& column : data_.columns) {
            for (uint32_t k = 0; k < column.components; ++k) {
                if (property.name != column_name(column.attribute, column.components, k)) continue;
                const bool fraction = column.attribute == FLG_ATTRIBUTE_COLOR && is_integer(property.type);
                return {column.values.data() + k, column.components, fraction ? largest_integer(property.type) : 1};
            }
        }
        return {};
    }

    void read_vertices(const PlyElement& element) {
        std::vector<std::string_view> names;
        for (const PlyProperty& property : element.properties) {
            if (!property.is_list()) names.push_back(property.name);
        }
        data_.columns = columns_of_names(names);
        data_.check_room(element.count, 0, line_place(element.line));
        if (element.count == 0) return;  // there is no place for a value
        data_.positions.resize(3 * element.count);
        for (VertexColumn& column : data_.columns) column.values.resize(column.components * element.count, 1.0f);
        std::vector<VertexTarget> targets;
        targets.reserve(element.properties.size());
        for (const PlyProperty& property : element.properties) targets.push_back(target(property));
        for (uint64_t row = 0; row < element.count; ++row) {
            rows_.begin_row(element);
            for (size_t i = 0; i < targets.size(); ++i) {
                VertexTarget& to = targets[i];
                const PlyProperty& property = element.properties[i];
                if (to.values) {
                    *to.values = rows_.number(property.type, property.name.c_str()) / to.scale;
                    to.values += to.stride;
                } else {
                    skip(property);
                }
            }
            rows_.end_row();
        }
    }

    uint32_t read_index(const PlyProperty& property) {
        const int64_t index = rows_.integer(property.type, "vertex index");
        if (index < 0 || static_cast<uint64_t>(index) >= vertex_count_) refuse_index(index);
        return static_cast<uint32_t>(index);
    }
    [[noreturn]] void refuse_index(int64_t index) const {
        fail(FLG_ERROR_FORMAT, rows_.place(), "the vertex index %lld is out of range: the file has %llu vertices",
             static_cast<long long>(index), static_cast<unsigned long long>(vertex_count_));
    }

    void read_faces(const PlyElement& element) {
        // What each property is: the corners, a column of labels, or nothing.
        constexpr size_t nothing = SIZE_MAX, corners = SIZE_MAX - 1, region = SIZE_MAX - 2;
        std::vector<size_t> roles;
        for (const PlyProperty& property : element.properties) {
            size_t role = nothing;
            if (is_index_list(property)) {
                role = corners;
            } else if (!property.is_list() && is_integer(property.type)) {
                if (property.name == "region") {
                    role = region;
                } else if (data_.face_columns.size() < most_face_columns) {
                    role = data_.face_columns.size();
                    data_.face_columns.push_back({property.name, {}});
                }
            }
            roles.push_back(role);
        }
        has_regions_ = std::find(roles.begin(), roles.end(), region) != roles.end();
        data_.check_room(0, element.count, line_place(element.line));
        data_.triangles.reserve(3 * element.count);
        if (has_regions_) data_.regions.reserve(element.count);
        for (FaceColumn& column : data_.face_columns) column.values.reserve(element.count);
        pad_labels();
        std::vector<uint32_t> labels(data_.face_columns.size());
        uint32_t label = 0;
        for (uint64_t row = 0; row < element.count; ++row) {
            rows_.begin_row(element);
            for (size_t i = 0; i < roles.size(); ++i) {
                const PlyProperty& property = element.properties[i];
                if (roles[i] == corners)
                    read_corners(property);
                else if (roles[i] == nothing)
                    skip(property);
                else
                    (roles[i] == region ? label : labels[roles[i]]) =
                        static_cast<uint32_t>(rows_.integer(property.type, property.name.c_str()));
            }
            rows_.end_row();
            data_.add_polygon(corners_);
            if (has_regions_) data_.regions.resize(data_.triangle_count(), label);
            for (size_t i = 0; i < labels.size(); ++i) {
                data_.face_columns[i].values.resize(data_.triangle_count(), labels[i]);
            }
        }
    }

    void read_corners(const PlyProperty& property) {
        const uint64_t count = read_list_size(property);
        if (count < 3) {
            fail(FLG_ERROR_FORMAT, rows_.place(), "a face of %llu vertices: it needs three",
                 static_cast<unsigned long long>(count));
        }
        corners_.clear();
        for (uint64_t k = 0; k < count; ++k) corners_.push_back(read_index(property));
    }

    void read_strips(const PlyElement& element) {
        for (uint64_t row = 0; row < element.count; ++row) {
            rows_.begin_row(element);
            for (const PlyProperty& property : element.properties) {
                if (is_index_list(property))
                    read_strip(property);
                else
                    skip(property);
            }
            rows_.end_row();
        }
    }

    void read_strip(const PlyProperty& property) {
        uint32_t before = 0, last = 0;
        uint64_t length = 0;
        uint64_t left = read_list_size(property);
        data_.check_room(0, std::min(left, rows_.left()), rows_.place());
        for (; left > 0; --left) {
            const int64_t index = rows_.integer(property.type, "vertex index");
            if (index == -1) {
                length = 0;
                continue;
            }
            if (index < 0 || static_cast<uint64_t>(index) >= vertex_count_) refuse_index(index);
            const uint32_t vertex = static_cast<uint32_t>(index);
            if (++length > 2 && before != last && last != vertex && vertex != before) {
                if (length % 2 == 1)
                    data_.add_triangle(before, last, vertex);
                else
                    data_.add_triangle(last, before, vertex);
            }
            before = last;
            last = vertex;
        }
    }

    // Triangles that no face has labelled get 0.
    void pad_labels() {
        if (has_regions_) data_.regions.resize(data_.triangle_count());
        for (FaceColumn& column : data_.face_columns) column.values.resize(data_.triangle_count());
    }

    const PlyHeader& header_;
    Rows rows_;
    MeshData data_;
    uint64_t vertex_count_ = 0;
    bool has_regions_ = false;
    std::vector<uint32_t> corners_;
};

template <class Rows>
MeshData read_rows(const PlyHeader& header, Rows rows) {
    PlyReader<Rows> reader(header, std::move(rows));
    MeshData data = reader.read();
    if (const uint64_t left = reader.rows().left(); left != 0) {
        data.warnings.push_back(std::to_string(left) + " bytes after the last row, left out");
    }
    return data;
}

}  // namespace

MeshData read_ply(Bytes file) {
    TextLines lines(as_text(file));
    const PlyHeader header = read_ply_header(lines);
    const size_t body = file.size() - lines.rest().size();
    switch (header.encoding) {
        case PlyEncoding::ascii: return read_rows(header, PlyTextRows(lines));
        case PlyEncoding::little_endian: return read_rows(header, PlyByteRows<std::endian::little>(file, body));
        default: return read_rows(header, PlyByteRows<std::endian::big>(file, body));
    }
}

}  // namespace flg::io
