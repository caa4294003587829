// SPDX-License-Identifier: MIT
// Source: Turk, The PLY Polygon File Format (1994), with the sized type names that later writers use; strips as in the
// models of the Stanford 3D Scanning Repository: one list of vertices, where -1 begins a new strip, every other
// triangle turns the other way, and triangles that name a vertex twice only lead on. Texture coordinates as in files of
// Blender (s t of vertices), PCL (u v, texture_u texture_v) and MeshLab (lists `texcoord` of faces, with comments
// `TextureFile` and numbers `texnumber` of these).
//
// Written: columns are float properties of the vertices, in the view's order; labels are uint properties of the faces,
// behind the list that all readers look for.
//
// Invariants: nothing is allocated for rows that the file has no room for. Names are printable, those of elements
// unique, those of properties within their element; lists are counted by integers.
#include "io/text/ply.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <optional>
#include <string_view>
#include <type_traits>

#include "io/base/byte_reader.h"
#include "io/base/column_names.h"
#include "io/base/failure.h"
#include "io/base/limits.h"
#include "io/text/mtl.h"
#include "io/text/text_lines.h"

namespace flg::io {

namespace {

// ---- The header: which elements follow, and what each of their rows holds

enum class PlyType : uint8_t { none, int8, uint8, int16, uint16, int32, uint32, float32, float64 };

constexpr uint32_t ply_size(PlyType type) {
    constexpr uint32_t sizes[] = {0, 1, 1, 2, 2, 4, 4, 4, 8};
    return sizes[static_cast<size_t>(type)];
}
constexpr bool is_integer(PlyType type) {
    return type != PlyType::none && type < PlyType::float32;
}

struct PlyProperty {
    String name;
    PlyType type = PlyType::none;
    PlyType count_type = PlyType::none;  // of a list

    bool is_list() const { return count_type != PlyType::none; }
};

struct PlyElement {
    String name;
    uint64_t count = 0;
    uint64_t line = 0;  // of the header
    Vector<PlyProperty> properties;

    // Null if there is none.
    const PlyProperty* find(std::string_view property) const;
};

enum class PlyEncoding : uint8_t { ascii, little_endian, big_endian };

struct PlyHeader {
    PlyEncoding encoding = PlyEncoding::ascii;
    Vector<PlyElement> elements;
    Vector<String> pictures;  // files

    // Null if there is none.
    const PlyElement* find(std::string_view element) const;
    // The fewest bytes a row of this element can take.
    uint64_t min_row(const PlyElement& element) const;
};

struct TypeName {
    std::string_view name, sized_name;
    PlyType type;
};
constexpr TypeName type_names[] = {
    {"char", "int8", PlyType::int8},        {"uchar", "uint8", PlyType::uint8},
    {"short", "int16", PlyType::int16},     {"ushort", "uint16", PlyType::uint16},
    {"int", "int32", PlyType::int32},       {"uint", "uint32", PlyType::uint32},
    {"float", "float32", PlyType::float32}, {"double", "float64", PlyType::float64},
};

constexpr size_t max_entries = 256;

class HeaderReader {
public:
    explicit HeaderReader(TextLines& lines) : lines_(lines) {}

    PlyHeader read() {
        if (next_keyword() != "ply") refuse("no PLY file: its first word is not 'ply'", keyword_);
        if (next_keyword() != "format") refuse("`format` must come second", keyword_);
        read_format();
        while (next_keyword() != "end_header") {
            if (keyword_ == "element")
                read_element();
            else if (keyword_ == "property")
                read_property();
            else
                refuse("no keyword of a PLY header", keyword_);
        }
        return std::move(header_);
    }

private:
    String place() const { return line_place(lines_.number()); }

    [[noreturn]] void refuse(const char* reason, std::string_view word) const {
        fail(FLG_ERROR_FORMAT, place(), "%s: %s", reason, cited(word).c_str());
    }

    // Of the next line that says something.
    std::string_view next_keyword() {
        do {
            std::string_view line;
            if (!lines_.next(line)) fail(FLG_ERROR_FORMAT, place(), "ends within the header: no end_header");
            cursor_ = LineCursor(line, lines_.number());
            keyword_ = cursor_.word();
            if (keyword_ == "comment") read_comment();
        } while (keyword_.empty() || keyword_ == "comment" || keyword_ == "obj_info");
        return keyword_;
    }

    void read_comment() {
        if (cursor_.word() != "TextureFile" || !cursor_.more()) return;
        if (header_.pictures.size() == max_entries)
            fail(FLG_ERROR_LIMIT, place(), "more than %zu textures", max_entries);
        header_.pictures.emplace_back(cursor_.rest());
    }

    void read_format() {
        const std::string_view encoding = cursor_.word();
        if (encoding == "ascii")
            header_.encoding = PlyEncoding::ascii;
        else if (encoding == "binary_little_endian")
            header_.encoding = PlyEncoding::little_endian;
        else if (encoding == "binary_big_endian")
            header_.encoding = PlyEncoding::big_endian;
        else
            refuse("no format of a PLY file", encoding);
        const std::string_view version = cursor_.word();
        if (version != "1.0") refuse("only the version 1.0 is known", version);
    }

    String read_name(size_t entries) {
        const std::string_view name = cursor_.word();
        const bool printable = std::all_of(name.begin(), name.end(), [](char c) { return c > ' ' && c <= '~'; });
        if (name.empty() || !printable) refuse("no name", name);
        if (entries == max_entries) {
            fail(FLG_ERROR_LIMIT, place(), "more than %zu elements, or properties of one", max_entries);
        }
        return String(name);
    }

    void read_element() {
        PlyElement element;
        element.name = read_name(header_.elements.size());
        element.line = lines_.number();
        const std::string_view count = cursor_.word();
        const auto [stop, error] = std::from_chars(count.data(), count.data() + count.size(), element.count);
        if (error != std::errc{} || stop != count.data() + count.size()) {
            refuse("no count of rows", count);
        }
        if (header_.find(element.name)) refuse("a second element of this name", element.name);
        header_.elements.push_back(std::move(element));
    }

    PlyType read_type() {
        const std::string_view word = cursor_.word();
        for (const TypeName& known : type_names) {
            if (word == known.name || word == known.sized_name) return known.type;
        }
        refuse("no type of a PLY property", word);
    }

    void read_property() {
        if (header_.elements.empty()) fail(FLG_ERROR_FORMAT, place(), "a property before the first element");
        PlyProperty property;
        LineCursor ahead = cursor_;
        if (ahead.word() == "list") {
            cursor_ = ahead;
            property.count_type = read_type();
            if (!is_integer(property.count_type)) fail(FLG_ERROR_FORMAT, place(), "a list must be counted by integers");
        }
        property.type = read_type();
        PlyElement& element = header_.elements.back();
        property.name = read_name(element.properties.size());
        if (element.find(property.name)) refuse("a second property of this name", property.name);
        element.properties.push_back(std::move(property));
    }

    TextLines& lines_;
    LineCursor cursor_{{}, 0};
    std::string_view keyword_;
    PlyHeader header_;
};

const PlyProperty* PlyElement::find(std::string_view property) const {
    const auto found =
        std::find_if(properties.begin(), properties.end(), [&](const PlyProperty& p) { return p.name == property; });
    return found == properties.end() ? nullptr : &*found;
}

const PlyElement* PlyHeader::find(std::string_view element) const {
    const auto found =
        std::find_if(elements.begin(), elements.end(), [&](const PlyElement& e) { return e.name == element; });
    return found == elements.end() ? nullptr : &*found;
}

uint64_t PlyHeader::min_row(const PlyElement& element) const {
    // A digit each, and blanks or the end of the line between them.
    if (encoding == PlyEncoding::ascii) return 2 * element.properties.size();
    uint64_t size = 0;
    for (const PlyProperty& property : element.properties) {
        size += ply_size(property.is_list() ? property.count_type : property.type);
    }
    return size;
}

// Takes the header off the lines; the rows follow.
PlyHeader read_ply_header(TextLines& lines) {
    return HeaderReader(lines).read();
}

// ---- The rows of elements, as text or as bytes: the same questions to both

// One row a line; lines without words are passed over.
class PlyTextRows {
public:
    explicit PlyTextRows(TextLines& lines) : lines_(lines) {}

    void begin_row(const PlyElement& element) {
        for (std::string_view line; lines_.next(line);) {
            cursor_ = LineCursor(line, lines_.number());
            if (cursor_.more()) return;
        }
        fail(FLG_ERROR_FORMAT, place(), "ends too early: rows of the element %s are missing",
             cited(element.name).c_str());
    }
    void end_row() {
        if (!cursor_.more()) return;
        fail(FLG_ERROR_FORMAT, place(), "more values than the element has: %s", cited(cursor_.word()).c_str());
    }
    float number(PlyType, const char* name) { return cursor_.number(name); }
    float coordinate(PlyType, const char* name, double origin) { return cursor_.coordinate(name, origin); }
    static bool is_precise(PlyType) { return true; }
    int64_t integer(PlyType, const char* name) { return cursor_.integer(name); }
    void skip(PlyType, const char* name) {
        if (cursor_.word().empty()) fail(FLG_ERROR_FORMAT, place(), "the %.80s is missing", name);
    }

    String place() const { return line_place(lines_.number()); }
    uint64_t left() const { return lines_.rest().size(); }

private:
    TextLines& lines_;
    LineCursor cursor_{{}, 0};
};

template <std::endian order>
class PlyByteRows {
public:
    PlyByteRows(Bytes file, size_t position) : reader_(file, "", position) {}

    void begin_row(const PlyElement&) {}
    void end_row() {}
    float number(PlyType type, const char* name) {
        const float value = type == PlyType::float32   ? read<float>(name)
                            : type == PlyType::float64 ? static_cast<float>(read<double>(name))
                                                       : static_cast<float>(integer(type, name));
        if (!(std::abs(value) <= max_coordinate)) {
            fail(FLG_ERROR_FORMAT, byte_place("", reader_.position() - ply_size(type)),
                 "the %.80s is %g: must be finite and at most 1e30 in size", name, double{value});
        }
        return value;
    }
    // Relative to an origin's.
    float coordinate(PlyType type, const char* name, double origin) {
        if (origin == 0 || !is_precise(type)) return number(type, name);
        const double value = type == PlyType::float64 ? read<double>(name) : static_cast<double>(integer(type, name));
        return static_cast<float>(value - origin);
    }
    // Whether numbers of this type have more digits than floats have.
    static bool is_precise(PlyType type) { return type != PlyType::float32; }
    int64_t integer(PlyType type, const char* name) {
        switch (type) {
            case PlyType::int8: return read<int8_t>(name);
            case PlyType::uint8: return read<uint8_t>(name);
            case PlyType::int16: return read<int16_t>(name);
            case PlyType::uint16: return read<uint16_t>(name);
            case PlyType::int32: return read<int32_t>(name);
            default: return read<uint32_t>(name);
        }
    }
    void skip(PlyType type, const char* name) { reader_.take(ply_size(type), name); }

    String place() const { return reader_.place(); }
    uint64_t left() const { return reader_.left(); }

private:
    template <class T>
    T read(const char* name) {
        T value = reader_.read<T>(name);
        if constexpr (order != std::endian::native && sizeof(T) > 1) {
            using Bits =
                std::conditional_t<sizeof(T) == 2, uint16_t, std::conditional_t<sizeof(T) == 4, uint32_t, uint64_t>>;
            Bits bits = std::bit_cast<Bits>(value), turned = 0;
            for (size_t i = 0; i < sizeof(T); ++i) turned = static_cast<Bits>(turned << 8 | (bits >> (8 * i) & 0xff));
            value = std::bit_cast<T>(turned);
        }
        return value;
    }

    ByteReader reader_;
};

// By what names vertices have texture coordinates.
constexpr std::array<std::array<std::string_view, 2>, 3> uv_names = {
    {{"s", "t"}, {"u", "v"}, {"texture_u", "texture_v"}}};

bool is_uv_list(const PlyProperty& property) {
    return property.is_list() && !is_integer(property.type) && property.name == "texcoord";
}

// Where the value of a vertex's property goes.
struct VertexTarget {
    float* values = nullptr;  // null: nowhere
    uint32_t stride = 0;      // floats
    float scale = 1;
    int axis = -1;  // of a position; no position: -1
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
    PlyReader(const PlyHeader& header, Rows rows, const Path& path, const Origin& origin)
        : header_(header), rows_(std::move(rows)), pictures_(path), origin_(origin) {}

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
        place_uvs();
        find_materials();
        data_.warn(lost_uvs_, "face", "with a list texcoord that has not two values a corner: left out");
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
        const uint64_t fitting = (rows_.left() + 1) / header_.min_row(element);
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
            fail(FLG_ERROR_FORMAT, rows_.place(), "the list %.80s has %lld values", property.name.c_str(),
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
                if (!Rows::is_precise(property.type)) data_.placing.stored = Origin{};
                return {data_.positions.data() + k, 3, 1, static_cast<int>(k)};
            }
        }
        for (uint32_t k = 0; k < 2 && uv_names_; ++k)
            if (property.name == (*uv_names_)[k]) return {vertex_uvs_.data() + k, 2, 1, -1};
        for (VertexColumn& column : data_.columns) {
            for (uint32_t k = 0; k < column.components; ++k) {
                if (property.name != column_name(column.attribute, column.components, k)) continue;
                const bool fraction = column.attribute == FLG_ATTRIBUTE_COLOR && is_integer(property.type);
                return {column.values.data() + k, column.components, fraction ? largest_integer(property.type) : 1, -1};
            }
        }
        return {};
    }

    void read_vertices(const PlyElement& element) {
        Vector<std::string_view> names;
        for (const PlyProperty& property : element.properties) {
            if (!property.is_list()) names.push_back(property.name);
        }
        data_.columns = columns_of_names(names);
        data_.check_room(element.count, 0, line_place(element.line));
        if (element.count == 0) return;  // there is no place for a value
        data_.positions.resize(3 * element.count);
        for (VertexColumn& column : data_.columns) column.values.resize(column.components * element.count, 1.0f);
        const auto is_number = [&](std::string_view name) {
            const PlyProperty* property = element.find(name);
            return property && !property->is_list();
        };
        for (const auto& both : uv_names)
            if (!uv_names_ && is_number(both[0]) && is_number(both[1])) uv_names_ = both;
        if (uv_names_) vertex_uvs_.resize(2 * element.count);
        Vector<VertexTarget> targets;
        targets.reserve(element.properties.size());
        for (const PlyProperty& property : element.properties) targets.push_back(target(property));
        for (uint64_t row = 0; row < element.count; ++row) {
            rows_.begin_row(element);
            for (size_t i = 0; i < targets.size(); ++i) {
                VertexTarget& to = targets[i];
                const PlyProperty& property = element.properties[i];
                if (to.axis >= 0) {
                    const double origin = origin_[static_cast<size_t>(to.axis)];
                    *to.values = rows_.coordinate(property.type, property.name.c_str(), origin);
                    to.values += to.stride;
                } else if (to.values) {
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
        constexpr size_t nothing = SIZE_MAX, corners = SIZE_MAX - 1, region = SIZE_MAX - 2, uvs = SIZE_MAX - 3;
        Vector<size_t> roles;
        // Numbers of textures are regions where these have no labels.
        const PlyProperty* const of_region = element.find("region");
        const bool has_labels = of_region && !of_region->is_list() && is_integer(of_region->type);
        numbers_textures_ = !header_.pictures.empty() && !has_labels;
        for (const PlyProperty& property : element.properties) {
            size_t role = nothing;
            if (is_index_list(property)) {
                role = corners;
            } else if (is_uv_list(property)) {
                role = uvs;
            } else if (!property.is_list() && is_integer(property.type)) {
                if (property.name == "region" || (numbers_textures_ && property.name == "texnumber")) {
                    role = region;
                } else if (data_.face_columns.size() < max_face_columns) {
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
        Vector<uint32_t> labels(data_.face_columns.size());
        uint32_t label = 0;
        for (uint64_t row = 0; row < element.count; ++row) {
            rows_.begin_row(element);
            uvs_.clear();
            for (size_t i = 0; i < roles.size(); ++i) {
                const PlyProperty& property = element.properties[i];
                if (roles[i] == corners)
                    read_corners(property);
                else if (roles[i] == uvs)
                    read_uvs(property);
                else if (roles[i] == nothing)
                    skip(property);
                else
                    (roles[i] == region ? label : labels[roles[i]]) =
                        static_cast<uint32_t>(rows_.integer(property.type, property.name.c_str()));
            }
            rows_.end_row();
            data_.add_polygon(corners_);
            add_uvs(row);
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

    void read_uvs(const PlyProperty& property) {
        const uint64_t count = read_list_size(property);
        for (uint64_t k = 0; k < count; ++k) uvs_.push_back(rows_.number(property.type, property.name.c_str()));
    }

    // Of the face that was added last.
    void add_uvs(uint64_t face) {
        if (uvs_.empty()) return;
        if (uvs_.size() != 2 * corners_.size()) return lost_uvs_.add(face);
        data_.corner_uvs.resize(6 * (data_.triangle_count() + 2 - corners_.size()));
        const auto add = [&](size_t corner) {
            data_.corner_uvs.insert(data_.corner_uvs.end(), {uvs_[2 * corner], 1 - uvs_[2 * corner + 1]});
        };
        for (size_t k = 2; k < corners_.size(); ++k) {
            add(0);
            add(k - 1);
            add(k);
        }
    }

    // Those of corners count, else those of vertices. Vertices may stand behind the faces.
    void place_uvs() {
        if (!data_.corner_uvs.empty()) return data_.corner_uvs.resize(6 * data_.triangle_count());
        if (vertex_uvs_.empty()) return;
        data_.corner_uvs.resize(6);  // so that the limit counts them
        data_.check_room(0, 0, rows_.place());
        data_.corner_uvs.clear();
        data_.corner_uvs.reserve(6 * data_.triangle_count());
        for (const uint32_t v : data_.triangles)
            data_.corner_uvs.insert(data_.corner_uvs.end(),
                                    {vertex_uvs_[2 * size_t{v}], 1 - vertex_uvs_[2 * size_t{v} + 1]});
    }

    // A material for each texture, and one without for faces that have none of these.
    void find_materials() {
        if (header_.pictures.empty()) return;
        if (data_.corner_uvs.empty()) {
            data_.warnings.push_back("textures without texture coordinates: left out");
            return;
        }
        if (has_regions_ && !numbers_textures_) {
            data_.warnings.push_back("textures beside regions: left out");
            return;
        }
        const auto count = static_cast<uint32_t>(header_.pictures.size());
        if (!has_regions_ && count > 1)
            data_.warnings.push_back("textures but the first, as faces have no texnumber: left out");
        uint32_t highest = 0;
        for (uint32_t& region : data_.regions) highest = std::max(highest, region = std::min(region, count));
        for (uint32_t i = 0; i <= highest; ++i) {
            MaterialData& material = data_.materials.emplace_back(pictures_.find(""));
            if (i < count) material.texture = pictures_.texture_of(header_.pictures[i]);
        }
        data_.textures = pictures_.take(data_.warnings);
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
    MtlLibrary pictures_;
    const Origin origin_;
    MeshData data_;
    uint64_t vertex_count_ = 0;
    bool has_regions_ = false, numbers_textures_ = false;
    Vector<uint32_t> corners_;
    std::optional<std::array<std::string_view, 2>> uv_names_;  // of vertices
    Vector<float> vertex_uvs_, uvs_;                           // of vertices; of a face's corners
    Tally lost_uvs_;
};

template <class Rows>
MeshData read_rows(const PlyHeader& header, Rows rows, const Path& path, const Origin& origin) {
    PlyReader<Rows> reader(header, std::move(rows), path, origin);
    MeshData data = reader.read();
    if (const uint64_t left = reader.rows().left(); left != 0) {
        data.warnings.push_back(to_text(left) + " bytes after the last row, left out");
    }
    return data;
}

}  // namespace

MeshData read_ply(Bytes file, const Path& path, const Origin& origin) {
    TextLines lines(as_text(file));
    const PlyHeader header = read_ply_header(lines);
    const size_t body = file.size() - lines.rest().size();
    switch (header.encoding) {
        case PlyEncoding::ascii: return read_rows(header, PlyTextRows(lines), path, origin);
        case PlyEncoding::little_endian:
            return read_rows(header, PlyByteRows<std::endian::little>(file, body), path, origin);
        default: return read_rows(header, PlyByteRows<std::endian::big>(file, body), path, origin);
    }
}

static_assert(std::endian::native == std::endian::little, "values are copied as they lie in memory");

namespace {

// Positions with an origin are written from 0.
bool is_double(const CheckedMesh& mesh, const FlgColumn& column) {
    return column.attribute == FLG_ATTRIBUTE_POSITION && mesh.origin() != Origin{};
}

String write_header(const CheckedMesh& mesh) {
    String text =
        "ply\nformat binary_little_endian 1.0\ncomment Filigree\nelement vertex " + to_text(mesh.vertex_count()) + "\n";
    for (const FlgColumn& column : mesh.columns()) {
        const char* const type = is_double(mesh, column) ? "property double " : "property float ";
        for (uint32_t k = 0; k < column.components; ++k) {
            text += type + column_name(column.attribute, column.components, k) + "\n";
        }
    }
    text += "element face " + to_text(mesh.triangle_count()) + "\nproperty list uchar int vertex_indices\n";
    if (mesh.regions()) text += "property uint region\n";
    for (const FlgMeshFaceColumn& column : mesh.face_columns()) {
        text.append("property uint ").append(column.name) += '\n';
    }
    return text + "end_header\n";
}

char* put(char* to, const void* values, size_t size) {
    std::memcpy(to, values, size);
    return to + size;
}

}  // namespace

String write_ply(const CheckedMesh& mesh) {
    String file = write_header(mesh);
    size_t vertex_size = 0;
    for (const FlgColumn& column : mesh.columns())
        vertex_size += column.components * (is_double(mesh, column) ? sizeof(double) : sizeof(float));
    const size_t labels = (mesh.regions() ? 1 : 0) + mesh.face_columns().size();
    const size_t face_size = 1 + (3 + labels) * sizeof(uint32_t);
    const size_t header_size = file.size();
    const size_t total = header_size + mesh.vertex_count() * vertex_size + mesh.triangle_count() * face_size;
    if (total > max_bytes) fail(FLG_ERROR_LIMIT, "", "would take %zu bytes, more than the limit of 2 GiB", total);
    file.resize(total);

    char* to = file.data() + header_size;
    for (size_t i = 0; i < mesh.vertex_count(); ++i) {
        for (const FlgColumn& column : mesh.columns()) {
            const float* const values = resolved(column).at(i);
            if (is_double(mesh, column)) {
                for (size_t k = 0; k < 3; ++k) {
                    const double value = double{values[k]} + mesh.origin()[k];
                    to = put(to, &value, sizeof value);
                }
            } else if (column.attribute == FLG_ATTRIBUTE_UV) {
                const float from_below[2] = {values[0], 1 - values[1]};
                to = put(to, from_below, sizeof from_below);
            } else {
                to = put(to, values, column.components * sizeof(float));
            }
        }
    }
    for (size_t t = 0; t < mesh.triangle_count(); ++t) {
        *to++ = 3;
        to = put(to, mesh.triangle(t), 3 * sizeof(uint32_t));
        if (mesh.regions()) to = put(to, mesh.regions() + t, sizeof(uint32_t));
        for (const FlgMeshFaceColumn& column : mesh.face_columns()) to = put(to, column.values + t, sizeof(uint32_t));
    }
    return file;
}

}  // namespace flg::io
