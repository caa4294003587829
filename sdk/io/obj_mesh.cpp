// SPDX-License-Identifier: MIT
// Source: Wavefront's OBJ specification (v, f, usemtl; the rest is passed over), with colours behind positions as MeshLab
// and others write them. Regions are materials, numbered by the first face that has them.
#include "io/obj_mesh.h"

#include <map>

#include "io/obj_statements.h"

namespace flg::io {

namespace {

constexpr uint32_t no_region = UINT32_MAX;

class ObjMeshReader {
public:
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
        if (!colors_.empty()) {
            colors_.resize(4 * data_.vertex_count(), 1.0f);
            data_.columns.push_back({FLG_ATTRIBUTE_COLOR, 4, std::move(colors_)});
        }
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
            material_ = cursor.word();
            region_ = no_region;
        } else if (keyword == "l" || keyword == "p") {
            lines_.add(line);
        }
    }

    void read_vertex(LineCursor& cursor) {
        for (const char* what : {"x", "y", "z"}) data_.positions.push_back(cursor.number(what));
        if (!cursor.more()) return;
        float rest[3] = {cursor.number("weight or red"), 0, 0};
        // A single number is a weight, which only rational curves and surfaces use.
        if (!cursor.more()) return;
        rest[1] = cursor.number("green");
        rest[2] = cursor.number("blue");
        colors_.resize(4 * (data_.vertex_count() - 1), 1.0f);
        colors_.insert(colors_.end(), {rest[0], rest[1], rest[2], 1.0f});
    }

    void read_face(LineCursor& cursor, uint64_t line) {
        corners_.clear();
        while (cursor.more()) {
            const uint32_t index = read_obj_index(cursor.word(), data_.vertex_count(), line);
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
        data_.add_polygon(corners_);
    }

    // The triangles since the last material are its.
    void end_region() {
        if (region_ != no_region) data_.regions.resize(data_.triangle_count(), region_);
    }

    MeshData data_;
    std::vector<float> colors_;  // of the vertices up to the last that has one
    std::vector<uint32_t> corners_;
    uint32_t largest_index_ = 0;  // and the line that has it first
    uint64_t largest_line_ = 0;
    std::string material_;  // of the next face; what comes before the first `usemtl` is nameless
    uint32_t region_ = no_region;
    std::map<std::string, uint32_t> regions_;
    Tally lines_;
};

}  // namespace

MeshData read_obj_mesh(std::string_view text) {
    return ObjMeshReader().read(text);
}

std::string write_obj_mesh(const CheckedMesh& mesh) {
    constexpr size_t usual_line = 36;
    std::string text;
    text.reserve((mesh.vertex_count() + mesh.triangle_count()) * usual_line);
    for (size_t i = 0; i < mesh.vertex_count(); ++i) {
        text += 'v';
        append_numbers(text, mesh.position.at(i), 3);
        if (mesh.color) append_numbers(text, mesh.color.at(i), 3);
        text += '\n';
    }
    for (size_t t = 0; t < mesh.triangle_count(); ++t) {
        if (mesh.regions() && (t == 0 || mesh.region(t) != mesh.region(t - 1))) {
            text.append("usemtl region_").append(std::to_string(mesh.region(t))) += '\n';
        }
        text += 'f';
        for (uint32_t k = 0; k < 3; ++k) text.append(" ").append(std::to_string(mesh.triangle(t)[k] + 1));
        text += '\n';
    }
    return text;
}

}  // namespace flg::io
