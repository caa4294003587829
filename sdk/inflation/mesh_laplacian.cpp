// SPDX-License-Identifier: MIT
#include "inflation/mesh_laplacian.h"

#include <algorithm>

#include "linear/dissection_order.h"
#include "runtime/each.h"

namespace flg {

namespace {

// One direction of an edge of a triangle, with the cotangent across from it. Each corner gives two.
struct HalfEdge {
    uint32_t from, to;
    double cotangent;
};

HalfEdge half_edge(const LaplacianInput& input, uint32_t number) {
    const uint32_t corner = number / 2;
    const TriangleVertices& t = input.triangles[corner / 3];
    const uint32_t k = corner % 3, a = t[(k + 1) % 3], b = t[(k + 2) % 3];
    const double cotangent = input.cotangents[corner / 3][k];
    return number % 2 == 0 ? HalfEdge{a, b, cotangent} : HalfEdge{b, a, cotangent};
}

uint32_t row_of(const LaplacianInput& input, uint32_t vertex) {
    return input.row_of_vertex.empty() ? vertex : input.row_of_vertex[vertex];
}

// What stands in a row, by vertex. Equal ones stay in the order of their triangles.
void sort_by_vertex(std::span<HalfEdge> row) {
    for (size_t i = 1; i < row.size(); ++i) {
        const HalfEdge moving = row[i];
        size_t j = i;
        for (; j > 0 && row[j - 1].to > moving.to; --j) row[j] = row[j - 1];
        row[j] = moving;
    }
}

}  // namespace

Task<SymmetricMatrix> mesh_laplacian(Pace& pace, LaplacianInput input) {
    Memory* memory = pace.memory();
    const size_t count = 6 * input.triangles.size();
    static_assert(no_row == no_key);
    Groups of_row = co_await group_by(pace, count, input.row_count,
                                      [&](uint32_t i) { return row_of(input, half_edge(input, i).from); });
    Buffer<HalfEdge> entries(of_row.count(), memory);
    co_await each(pace, entries.size(), Cost::tens_of_ns,
                  [&](uint32_t i) { entries[i] = half_edge(input, of_row.items[i]); });
    of_row.items = {};

    // Twice the room that manifold meshes without a border need.
    SymmetricMatrix matrix{Buffer<double>(input.row_count, memory),
                           Buffer<uint32_t>(input.row_count + size_t{1}, memory), Buffer<uint32_t>(count, memory),
                           Buffer<double>(count, memory)};
    uint32_t written = 0;
    matrix.offsets[0] = 0;
    co_await each_by_work(pace, input.row_count, Cost::tens_of_ns, [&](uint32_t row) {
        const uint32_t begin = of_row.offsets[row], length = of_row.offsets[row + 1] - begin;
        const std::span<HalfEdge> around{entries.data() + begin, length};
        sort_by_vertex(around);
        double diagonal = input.mass.empty() ? 0 : input.mass[row];
        for (uint32_t i = 0; i < length;) {
            const uint32_t vertex = around[i].to;
            double weight = 0;
            for (; i < length && around[i].to == vertex; ++i) weight += around[i].cotangent;
            weight = std::max(weight, input.min_weight);
            const uint32_t column = row_of(input, vertex);
            if (!input.scale.empty()) {
                const double own = input.scale[row], other = column == no_row ? own : input.scale[column];
                weight *= 0.5 * (own + other);
            }
            diagonal += weight;
            if (column == no_row) continue;
            matrix.columns[written] = column;
            matrix.values[written] = -weight;
            ++written;
        }
        matrix.diagonal[row] = diagonal;
        matrix.offsets[row + 1] = written;
        return 2 * length;
    });
    entries = {};
    co_await pace;
    co_return matrix;
}

Task<CholeskyFactor> factorize_laplacian(Pace& pace, LaplacianInput input, std::span<const Vec3> places) {
    SymmetricMatrix matrix = co_await mesh_laplacian(pace, input);
    Buffer<uint32_t> order = co_await dissection_order(pace, matrix, places);
    CholeskyFactor factor = co_await factorize(pace, matrix, std::move(order));
    matrix.values = {};
    co_await pace;
    co_return factor;
}

}  // namespace flg
