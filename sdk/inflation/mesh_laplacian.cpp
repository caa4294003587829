// SPDX-License-Identifier: MIT
#include "inflation/mesh_laplacian.h"

#include <algorithm>

namespace flg {

namespace {

constexpr uint32_t batch = 32;

}  // namespace

MeshLaplacian::MeshLaplacian(const LaplacianInput& input, SymmetricMatrix& out, Memory* memory)
    : input_(input),
      out_(out),
      offsets_(input.row_count + size_t{2}, memory),
      entries_(6 * input.triangles.size(), memory) {
    out.diagonal = Buffer<double>(input.row_count, memory);
    out.offsets = Buffer<uint32_t>(input.row_count + size_t{1}, memory);
    // Twice what manifold meshes without a border need.
    out.columns = Buffer<uint32_t>(6 * input.triangles.size(), memory);
    out.values = Buffer<double>(6 * input.triangles.size(), memory);
}

// The two directions of each edge of a triangle, with the cotangent across from it.
template <class Action>
void MeshLaplacian::each_edge(uint32_t triangle, const Action& action) const {
    const TriangleVertices& t = input_.triangles[triangle];
    for (uint32_t k = 0; k < 3; ++k) {
        const uint32_t a = t[(k + 1) % 3], b = t[(k + 2) % 3];
        if (row_of(a) != no_row) action(row_of(a), b, input_.cotangents[triangle][k]);
        if (row_of(b) != no_row) action(row_of(b), a, input_.cotangents[triangle][k]);
    }
}

bool MeshLaplacian::run(uint32_t count) {
    const uint32_t rows = input_.row_count;
    const auto triangles = static_cast<uint32_t>(input_.triangles.size());
    for (; count > 0 && pass_ != Pass::done; --count) {
        switch (pass_) {
            case Pass::clear:
                for (const uint32_t stop = std::min(rows + 2, at_ + batch); at_ < stop; ++at_) offsets_[at_] = 0;
                if (at_ < rows + 2) break;
                at_ = 0;
                pass_ = Pass::count;
                break;
            case Pass::count:
                for (const uint32_t stop = std::min(triangles, at_ + batch / 4); at_ < stop; ++at_)
                    each_edge(at_, [&](uint32_t row, uint32_t, double) { ++offsets_[row + 2]; });
                if (at_ < triangles) break;
                at_ = 0;
                pass_ = Pass::sum;
                break;
            case Pass::sum:
                for (const uint32_t stop = std::min(rows, at_ + batch); at_ < stop; ++at_)
                    offsets_[at_ + 2] += offsets_[at_ + 1];
                if (at_ < rows) break;
                at_ = 0;
                pass_ = Pass::scatter;
                break;
            case Pass::scatter:
                for (const uint32_t stop = std::min(triangles, at_ + batch / 4); at_ < stop; ++at_)
                    each_edge(at_, [&](uint32_t row, uint32_t vertex, double weight) {
                        entries_[offsets_[row + 1]++] = {vertex, weight};
                    });
                if (at_ < triangles) break;
                at_ = 0;
                out_.offsets[0] = 0;
                pass_ = Pass::row;
                break;
            case Pass::row:
                if (at_ == rows) {
                    pass_ = Pass::done;
                    break;
                }
                finish_row();
                ++at_;
                break;
            case Pass::done: break;
        }
    }
    return pass_ == Pass::done;
}

// Sorts a row by vertex, which keeps the order of triangles among equal ones, and adds these up.
void MeshLaplacian::finish_row() {
    Entry* begin = entries_.data() + offsets_[at_];
    const uint32_t length = offsets_[at_ + 1] - offsets_[at_];
    for (uint32_t i = 1; i < length; ++i) {
        const Entry moving = begin[i];
        uint32_t j = i;
        for (; j > 0 && begin[j - 1].vertex > moving.vertex; --j) begin[j] = begin[j - 1];
        begin[j] = moving;
    }
    double diagonal = input_.mass.empty() ? 0 : input_.mass[at_];
    for (uint32_t i = 0; i < length;) {
        const uint32_t vertex = begin[i].vertex;
        double weight = 0;
        for (; i < length && begin[i].vertex == vertex; ++i) weight += begin[i].weight;
        weight = std::max(weight, input_.least_weight);
        const uint32_t column = row_of(vertex);
        if (!input_.scale.empty()) {
            const double own = input_.scale[at_], other = column == no_row ? own : input_.scale[column];
            weight *= 0.5 * (own + other);
        }
        diagonal += weight;
        if (column == no_row) continue;
        out_.columns[written_] = column;
        out_.values[written_] = -weight;
        ++written_;
    }
    out_.diagonal[at_] = diagonal;
    out_.offsets[at_ + 1] = written_;
}

}  // namespace flg
