// SPDX-License-Identifier: MIT
// Source: Wavefront's OBJ specification (v, l; the rest is passed over).
// `l a b c` is a curve; one whose last index equals its first is closed; `l a a` is a curve of one point. Statements of
// two indices that follow each other and chain (as programs write edge by edge) are joined into one curve.
#include "io/obj_lines.h"

#include "io/obj_statements.h"
#include "io/polylines.h"

namespace flg::io {

namespace {

struct Statement {
    uint64_t line;
    size_t begin;  // of its indices
};

class ObjReader {
public:
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
            for (const char* what : {"x", "y", "z"}) vertices_.push_back(cursor.number(what));
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

    CurveData data_;
    std::vector<float> vertices_;
    std::vector<uint32_t> indices_;
    std::vector<Statement> statements_;
    Tally faces_;
};

}  // namespace

CurveData read_obj(std::string_view text) {
    return ObjReader().read(text);
}

std::string write_obj(const CheckedView& view) {
    constexpr size_t usual_point = 48;
    std::string text;
    text.reserve(view.point_count() * usual_point);
    for (size_t i = 0; i < view.point_count(); ++i) {
        text += 'v';
        for (int k = 0; k < 3; ++k) {
            text += ' ';
            append_number(text, view.position.at(i)[k]);
        }
        text += '\n';
    }
    for (uint32_t c = 0; c < view.curve_count(); ++c) {
        text += 'l';
        for (size_t i = view.begin(c); i < view.end(c); ++i) text.append(" ").append(std::to_string(i + 1));
        // A curve of one point has it twice: the format has no shorter lines.
        if (view.closed(c) || view.end(c) - view.begin(c) == 1)
            text.append(" ").append(std::to_string(view.begin(c) + 1));
        text += '\n';
    }
    return text;
}

}  // namespace flg::io
