// SPDX-License-Identifier: MIT
// Source: Geomview's manual, OFF files. The keyword may have C (colours) and N (normals) before it, of which colours
// are read; the counts of vertices, faces and edges follow, on the same line or the next; then a line each. A # ends
// what a line says. Colours of vertices are 0 to 1, or 0 to 255 as many programs write them: so if one of them is above
// 1. Departures: no binary, four-dimensional or textured files; colours of faces are passed over.
#include "io/text/off.h"

#include <algorithm>
#include <limits>

#include "io/text/text_lines.h"

namespace flg::io {

namespace {

// Numbers that are read are finite.
constexpr float no_alpha = std::numeric_limits<float>::infinity();

class OffReader {
public:
    OffReader(std::string_view text, const Origin& origin) : lines_(text), origin_(origin) {}

    MeshData read() {
        data_.format = "off";
        read_header();
        for (uint64_t i = 0; i < vertex_count_; ++i) read_vertex();
        for (uint64_t i = 0; i < face_count_; ++i) read_face();
        if (data_.triangles.empty()) fail(FLG_ERROR_FORMAT, place(), "the file holds no faces");
        if (has_colors_) {
            const bool bytes =
                std::any_of(colors_.begin(), colors_.end(), [](float value) { return value > 1 && value != no_alpha; });
            for (float& value : colors_) value = value == no_alpha ? 1 : value / (bytes ? 255.0f : 1.0f);
            data_.columns.push_back({FLG_ATTRIBUTE_COLOR, 4, std::move(colors_)});
        }
        Tally more;
        while (find_line()) more.add(lines_.number());
        data_.warn(more, "line", "after the last face, left out");
        return std::move(data_);
    }

private:
    String place() const { return line_place(lines_.number()); }

    // The next line that says something.
    bool find_line() {
        for (std::string_view line; lines_.next(line);) {
            cursor_ = LineCursor(line.substr(0, line.find('#')), lines_.number());
            if (cursor_.more()) return true;
        }
        return false;
    }
    void next_line(const char* what) {
        if (!find_line()) fail(FLG_ERROR_FORMAT, place(), "ends too early: %s is missing", what);
    }

    void read_header() {
        next_line("the keyword OFF");
        const std::string_view keyword = cursor_.word();
        if (keyword != "OFF" && keyword != "COFF" && keyword != "NOFF" && keyword != "CNOFF") {
            fail(FLG_ERROR_FORMAT, place(), "begins with none of OFF, COFF, NOFF and CNOFF: %s",
                 cited(keyword).c_str());
        }
        has_colors_ = keyword.starts_with('C');
        has_normals_ = keyword.ends_with("NOFF");
        if (!cursor_.more()) next_line("the line of counts");
        vertex_count_ = read_count("number of vertices");
        face_count_ = read_count("number of faces");
        // The third, of edges, is often 0 or left out.
        check_count(vertex_count_, "vertices");
        check_count(face_count_, "faces");
        data_.check_room(vertex_count_, face_count_, place());
        data_.positions.reserve(3 * vertex_count_);
        data_.triangles.reserve(3 * face_count_);
    }

    uint64_t read_count(const char* what) {
        const int64_t count = cursor_.integer(what);
        if (count < 0) fail(FLG_ERROR_FORMAT, place(), "the %s is %lld", what, static_cast<long long>(count));
        return static_cast<uint64_t>(count);
    }

    // Three numbers and what parts them take six bytes; the last line may lack its end.
    void check_count(uint64_t count, const char* what) const {
        constexpr uint64_t min_line = 6;
        const uint64_t fitting = (lines_.rest().size() + 1) / min_line;
        if (count <= fitting) return;
        fail(FLG_ERROR_FORMAT, place(), "declares %llu %s, but at most %llu fit",
             static_cast<unsigned long long>(count), what, static_cast<unsigned long long>(fitting));
    }

    void read_vertex() {
        next_line("a vertex");
        constexpr const char* coordinates[] = {"x", "y", "z"};
        for (size_t k = 0; k < 3; ++k) data_.positions.push_back(cursor_.coordinate(coordinates[k], origin_[k]));
        for (int k = 0; has_normals_ && k < 3; ++k) cursor_.number("normal");
        if (!has_colors_) return;
        for (const char* what : {"red", "green", "blue"}) colors_.push_back(cursor_.number(what));
        colors_.push_back(cursor_.more() ? cursor_.number("alpha") : no_alpha);
    }

    void read_face() {
        next_line("a face");
        const int64_t count = cursor_.integer("number of vertices");
        if (count < 3) {
            fail(FLG_ERROR_FORMAT, place(), "a face of %lld vertices: it needs three", static_cast<long long>(count));
        }
        corners_.clear();
        for (int64_t k = 0; k < count; ++k) {
            const int64_t index = cursor_.integer("vertex index");
            if (index < 0 || static_cast<uint64_t>(index) >= vertex_count_) {
                fail(FLG_ERROR_FORMAT, place(), "the vertex index %lld is out of range: the file has %llu vertices",
                     static_cast<long long>(index), static_cast<unsigned long long>(vertex_count_));
            }
            corners_.push_back(static_cast<uint32_t>(index));
        }
        data_.add_polygon(corners_);
    }

    TextLines lines_;
    const Origin origin_;
    LineCursor cursor_{{}, 0};
    MeshData data_;
    uint64_t vertex_count_ = 0, face_count_ = 0;
    bool has_colors_ = false, has_normals_ = false;
    Vector<float> colors_;
    Vector<uint32_t> corners_;
};

}  // namespace

MeshData read_off(std::string_view text, const Origin& origin) {
    return OffReader(text, origin).read();
}

void write_off(const CheckedMesh& mesh, FileWriter& file) {
    String& text = file.text;
    text.append(mesh.color ? "COFF\n" : "OFF\n").append(to_text(mesh.vertex_count())).append(" ");
    text.append(to_text(mesh.triangle_count())).append(" 0\n");
    for (size_t i = 0; i < mesh.vertex_count(); ++i) {
        for (size_t k = 0; k < 3; ++k) append_coordinate(text += ' ', mesh.position.at(i)[k], mesh.origin()[k]);
        if (mesh.color) append_numbers(text, mesh.color.at(i), 4);
        text += '\n';
        file.drain();
    }
    for (size_t t = 0; t < mesh.triangle_count(); ++t) {
        text += '3';
        for (uint32_t k = 0; k < 3; ++k) text.append(" ").append(to_text(mesh.triangle(t)[k]));
        text += '\n';
        file.drain();
    }
}

}  // namespace flg::io
