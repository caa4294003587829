// SPDX-License-Identifier: MIT
// Source: Wavefront's OBJ specification (v, vt, l, f, usemtl, mtllib; the rest is passed over).
//
// Lines: `l a b c` is a curve; one whose last index equals its first is closed; `l a a` is a curve of one point.
// Statements of two indices that follow each other and chain (as programs write edge by edge) are joined into one
// curve.
//
// Faces: colours may stand behind positions, as MeshLab and others write them. Regions are materials, numbered by the
// first face that has them.
#include "io/text/obj.h"

#include <algorithm>

#include "io/base/polylines.h"
#include "io/text/mtl.h"
#include "io/text/text_lines.h"

namespace flg::io {

namespace {

// Hands out statements: lines, joined where a backslash continues them.
class ObjStatements {
public:
    explicit ObjStatements(std::string_view text) : lines_(text) {}

    // Lives until the next call.
    bool next(std::string_view& statement) {
        if (!lines_.next(statement)) return false;
        line_ = lines_.number();
        if (!statement.ends_with('\\')) return true;
        joined_.clear();
        do {
            joined_.append(statement.substr(0, statement.size() - 1)) += ' ';
        } while (lines_.next(statement) && statement.ends_with('\\'));
        if (!statement.ends_with('\\')) joined_.append(statement);
        statement = joined_;
        return true;
    }
    uint64_t line() const { return line_; }  // of the statement's first line, from 1
    uint64_t last_line() const { return lines_.number(); }

private:
    TextLines lines_;
    String joined_;
    uint64_t line_ = 0;
};

// The vertex of `v`, `v/vt`, `v//vn` or `v/vt/vn`, from 0, by the number of vertices so far; whether it exists is seen
// at the end of the file.
inline uint32_t read_obj_index(std::string_view word, uint64_t vertex_count, uint64_t line) {
    const int64_t count = static_cast<int64_t>(vertex_count);
    int64_t value = 0;
    const auto [stop, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    const bool whole = stop == word.data() + word.size() || *stop == '/';
    if (error == std::errc::invalid_argument || !whole) {
        fail(FLG_ERROR_FORMAT, line_place(line), "no vertex index: %s", cited(word).c_str());
    }
    const int64_t index = value < 0 ? count + value : value - 1;
    if (error != std::errc{} || index < 0 || index >= static_cast<int64_t>(max_points)) {
        fail(FLG_ERROR_FORMAT, line_place(line), "the vertex index %s is out of range: %lld vertices so far",
             cited(word).c_str(), static_cast<long long>(count));
    }
    return static_cast<uint32_t>(index);
}

struct Statement {
    uint64_t line;
    size_t begin;  // of its indices
};

constexpr const char* coordinates[] = {"x", "y", "z"};

class ObjReader {
public:
    explicit ObjReader(const Origin& origin) : origin_(origin) {}

    CurveData read(std::string_view text) {
        data_.format = "obj";
        ObjStatements statements(text);
        for (std::string_view statement; statements.next(statement);) {
            read_statement(LineCursor(statement, statements.line()), statements.line());
        }
        if (statements_.empty())
            fail(FLG_ERROR_FORMAT, line_place(statements.last_line()), "the file holds no lines (`l`)");
        data_.warn(faces_, "face", "left out: only lines are read");
        build();
        return std::move(data_);
    }

private:
    void read_statement(LineCursor cursor, uint64_t line) {
        const std::string_view keyword = cursor.word();
        if (keyword == "v") {
            // A weight or a colour may follow.
            for (size_t k = 0; k < 3; ++k) vertices_.push_back(cursor.coordinate(coordinates[k], origin_[k]));
            if (vertices_.size() / 3 > max_points) fail(FLG_ERROR_LIMIT, line_place(line), "more than 2^31 vertices");
        } else if (keyword == "f") {
            faces_.add(line);
        } else if (keyword == "l") {
            statements_.push_back({line, indices_.size()});
            while (cursor.more()) indices_.push_back(read_obj_index(cursor.word(), vertices_.size() / 3, line));
            if (indices_.size() - statements_.back().begin < 2) {
                fail(FLG_ERROR_FORMAT, line_place(line), "a line of fewer than two vertices");
            }
            if (indices_.size() > max_points) fail(FLG_ERROR_LIMIT, line_place(line), "more than 2^31 points");
        }
    }

    void build() {
        const size_t vertex_count = vertices_.size() / 3;
        Polylines lines;
        size_t edges_begin = 0;  // of the run of two-index statements that is being gathered
        for (size_t s = 0; s < statements_.size(); ++s) {
            const size_t begin = statements_[s].begin;
            const size_t end = s + 1 < statements_.size() ? statements_[s + 1].begin : indices_.size();
            for (size_t i = begin; i < end; ++i) {
                if (indices_[i] < vertex_count) continue;
                fail(FLG_ERROR_FORMAT, line_place(statements_[s].line),
                     "the vertex index %u is out of range: the file has %zu vertices", indices_[i] + 1, vertex_count);
            }
            if (end - begin == 2 && indices_[begin] != indices_[begin + 1]) continue;
            add_edges(lines, edges_begin, begin);
            lines.indices.insert(lines.indices.end(), indices_.begin() + static_cast<ptrdiff_t>(begin),
                                 indices_.begin() + static_cast<ptrdiff_t>(end));
            lines.end(false);
            edges_begin = end;
        }
        add_edges(lines, edges_begin, indices_.size());

        data_.positions.reserve(lines.indices.size() * 3);
        for (size_t c = 0; c < lines.count(); ++c) {
            for (size_t i = lines.offsets[c]; i < lines.offsets[c + 1]; ++i) {
                const float* vertex = &vertices_[size_t{lines.indices[i]} * 3];
                data_.positions.insert(data_.positions.end(), vertex, vertex + 3);
            }
            data_.end_curve(lines.closed[c]);
        }
    }

    void add_edges(Polylines& lines, size_t begin, size_t end) const {
        const uint32_t* pairs = indices_.data() + begin;
        join_edges((end - begin) / 2, [&](size_t e) { return std::pair(pairs[2 * e], pairs[2 * e + 1]); },
                   [](uint32_t a, uint32_t b) { return a == b; }, lines);
    }

    const Origin origin_;
    CurveData data_;
    Vector<float> vertices_;
    Vector<uint32_t> indices_;
    Vector<Statement> statements_;
    Tally faces_;
};

}  // namespace

CurveData read_obj(std::string_view text, const Origin& origin) {
    return ObjReader(origin).read(text);
}

void write_obj(const CheckedView& view, FileWriter& file) {
    String& text = file.text;
    for (size_t i = 0; i < view.point_count(); ++i) {
        text += 'v';
        for (size_t k = 0; k < 3; ++k) append_coordinate(text += ' ', view.position.at(i)[k], view.origin()[k]);
        text += '\n';
        file.drain();
    }
    for (uint32_t c = 0; c < view.curve_count(); ++c) {
        text += 'l';
        for (size_t i = view.begin(c); i < view.end(c); ++i) {
            text.append(" ").append(to_text(i + 1));
            file.drain();
        }
        // A curve of one point has it twice: the format has no shorter lines.
        if (view.closed(c) || view.end(c) - view.begin(c) == 1) text.append(" ").append(to_text(view.begin(c) + 1));
        text += '\n';
        file.drain();
    }
}

namespace {

constexpr uint32_t no_region = UINT32_MAX, none = UINT32_MAX;

class ObjMeshReader {
public:
    ObjMeshReader(const Path& path, const Origin& origin) : origin_(origin), library_(path) {}

    MeshData read(std::string_view text) {
        data_.format = "obj";
        ObjStatements statements(text);
        for (std::string_view statement; statements.next(statement);) {
            read_statement(LineCursor(statement, statements.line()), statements.line());
        }
        if (data_.triangles.empty()) {
            fail(FLG_ERROR_FORMAT, line_place(statements.last_line()), "the file holds no faces (`f`)");
        }
        if (largest_index_ >= data_.vertex_count()) {
            fail(FLG_ERROR_FORMAT, line_place(largest_line_),
                 "the vertex index %llu is out of range: the file has %zu vertices",
                 static_cast<unsigned long long>(largest_index_) + 1, data_.vertex_count());
        }
        end_region();
        if (regions_.size() == 1) data_.regions.clear();
        find_materials();
        place_uvs();
        if (!colors_.empty()) {
            colors_.resize(4 * data_.vertex_count(), 1.0f);
            data_.columns.push_back({FLG_ATTRIBUTE_COLOR, 4, std::move(colors_)});
        }
        data_.warn(lost_uvs_, "line", "with texture coordinates that are not there");
        data_.warn(lines_, "line", "of lines or points (`l`, `p`), left out: only faces are read");
        return std::move(data_);
    }

private:
    void read_statement(LineCursor cursor, uint64_t line) {
        const std::string_view keyword = cursor.word();
        if (keyword == "v") {
            read_vertex(cursor);
        } else if (keyword == "f") {
            read_face(cursor, line);
        } else if (keyword == "usemtl") {
            end_region();
            material_ = cursor.rest();
            region_ = no_region;
        } else if (keyword == "vt") {
            // They go up; ours go down.
            const float u = cursor.number("u"), v = cursor.more() ? cursor.number("v") : 0;
            uvs_.insert(uvs_.end(), {u, 1 - v});
        } else if (keyword == "mtllib") {
            library_.read(cursor.rest());
        } else if (keyword == "l" || keyword == "p") {
            lines_.add(line);
        }
    }

    void read_vertex(LineCursor& cursor) {
        for (size_t k = 0; k < 3; ++k) data_.positions.push_back(cursor.coordinate(coordinates[k], origin_[k]));
        if (!cursor.more()) return;
        float rest[3] = {cursor.number("weight or red"), 0, 0};
        // A single number is a weight, which only rational curves and surfaces use.
        if (!cursor.more()) return;
        rest[1] = cursor.number("green");
        rest[2] = cursor.number("blue");
        colors_.resize(4 * (data_.vertex_count() - 1), 1.0f);
        colors_.insert(colors_.end(), {rest[0], rest[1], rest[2], 1.0f});
    }

    // Of a corner, `v/vt...`; `none` if it has none.
    uint32_t uv_of(std::string_view word, uint64_t line) {
        const size_t slash = word.find('/');
        if (slash == word.npos || slash + 1 == word.size() || word[slash + 1] == '/') return none;
        int64_t value = 0;
        const char* const begin = word.data() + slash + 1;
        const auto [stop, error] = std::from_chars(begin, word.data() + word.size(), value);
        const int64_t index = value < 0 ? static_cast<int64_t>(uvs_.size() / 2) + value : value - 1;
        if (error == std::errc{} && index >= 0 && index < int64_t{none}) return static_cast<uint32_t>(index);
        lost_uvs_.add(line);
        return none;
    }

    void read_face(LineCursor& cursor, uint64_t line) {
        corners_.clear();
        face_uvs_.clear();
        while (cursor.more()) {
            const std::string_view word = cursor.word();
            face_uvs_.push_back(uv_of(word, line));
            const uint32_t index = read_obj_index(word, data_.vertex_count(), line);
            if (index > largest_index_ || largest_line_ == 0) {
                largest_index_ = index;
                largest_line_ = line;
            }
            corners_.push_back(index);
        }
        if (corners_.size() < 3) {
            fail(FLG_ERROR_FORMAT, line_place(line), "a face of %zu vertices: it needs three", corners_.size());
        }
        if (region_ == no_region) {
            region_ = regions_.try_emplace(material_, static_cast<uint32_t>(regions_.size())).first->second;
        }
        // Up to the last that has some.
        if (std::any_of(face_uvs_.begin(), face_uvs_.end(), [](uint32_t uv) { return uv != none; })) {
            corner_uvs_.resize(3 * data_.triangle_count(), none);
            for (size_t k = 2; k < face_uvs_.size(); ++k)
                corner_uvs_.insert(corner_uvs_.end(), {face_uvs_[0], face_uvs_[k - 1], face_uvs_[k]});
        }
        data_.add_polygon(corners_);
    }

    // Texture coordinates may stand behind the faces that name them.
    void place_uvs() {
        if (corner_uvs_.empty() || uvs_.empty()) return;
        data_.corner_uvs.resize(6 * data_.triangle_count());
        for (size_t c = 0; c < corner_uvs_.size(); ++c) {
            const size_t uv = corner_uvs_[c];
            if (uv == none) continue;
            if (uv >= uvs_.size() / 2)
                lost_uvs_.add(0);
            else
                std::copy_n(&uvs_[2 * uv], 2, &data_.corner_uvs[2 * c]);
        }
    }

    // By region, where a library knows one of them.
    void find_materials() {
        Vector<String> names(regions_.size());
        bool says_color = false;
        for (const auto& [name, region] : regions_) {
            names[region] = name;
            says_color = says_color || library_.says_color(name);
        }
        for (const String& name : names)
            if (says_color) data_.materials.push_back(library_.find(name));
        data_.textures = library_.take(data_.warnings);
    }

    // The triangles since the last material are its.
    void end_region() {
        if (region_ != no_region) data_.regions.resize(data_.triangle_count(), region_);
    }

    const Origin origin_;
    MeshData data_;
    Vector<float> colors_;  // of the vertices up to the last that has one
    Vector<uint32_t> corners_;
    uint32_t largest_index_ = 0;  // and the line that has it first
    uint64_t largest_line_ = 0;
    String material_;  // of the next face; what comes before the first `usemtl` is nameless
    uint32_t region_ = no_region;
    Map<String, uint32_t> regions_;
    MtlLibrary library_;
    Vector<float> uvs_;
    Vector<uint32_t> face_uvs_, corner_uvs_;  // by corner: a pair of `uvs_`, or none
    Tally lines_, lost_uvs_;
};

}  // namespace

MeshData read_obj_mesh(std::string_view text, const Path& path, const Origin& origin) {
    return ObjMeshReader(path, origin).read(text);
}

void write_obj_mesh(const CheckedMesh& mesh, FileWriter& file) {
    String& text = file.text;
    for (size_t i = 0; i < mesh.vertex_count(); ++i) {
        text += 'v';
        for (size_t k = 0; k < 3; ++k) append_coordinate(text += ' ', mesh.position.at(i)[k], mesh.origin()[k]);
        if (mesh.color) append_numbers(text, mesh.color.at(i), 3);
        text += '\n';
        file.drain();
    }
    for (size_t i = 0; i < mesh.vertex_count() && mesh.uv; ++i) {
        const float from_below[2] = {mesh.uv.at(i)[0], 1 - mesh.uv.at(i)[1]};
        append_numbers(text += "vt", from_below, 2);
        text += '\n';
        file.drain();
    }
    for (size_t t = 0; t < mesh.triangle_count(); ++t) {
        if (mesh.regions() && (t == 0 || mesh.region(t) != mesh.region(t - 1))) {
            text.append("usemtl region_").append(to_text(mesh.region(t))) += '\n';
        }
        text += 'f';
        for (uint32_t k = 0; k < 3; ++k) {
            const String vertex = to_text(mesh.triangle(t)[k] + 1);
            text.append(" ").append(vertex);
            if (mesh.uv) text.append("/").append(vertex);
        }
        text += '\n';
        file.drain();
    }
}

}  // namespace flg::io
