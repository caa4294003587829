// SPDX-License-Identifier: MIT
// What the cuts have in common: the triangles that a cut changes, their new vertices, and how the pieces of one take
// its place: the first overwrites it, the others are appended; neighbours, corners of vertices and regions follow,
// here and across the edges.
#pragma once

#include <bit>
#include <vector>

#include "surfaces/mesh/mesh_edit.h"
#include "surfaces/mesh/mesh_growth.h"
#include "surfaces/mesh/source_weights.h"

namespace flg {

// The triangles a cut changes, found by their index in constant time without a hash map: a bit a triangle, and for each
// 64 of them how many were set before. Of 64 such words a bit says which are in use: only these are touched. Slots are
// numbered by rising triangle.
class TriangleSet {
public:
    TriangleSet(uint32_t triangle_count, Memory* memory)
        : words_((size_t{triangle_count} + 63) / 64, memory), used_((words_.size() + 63) / 64, memory) {}

    uint32_t group_count() const { return static_cast<uint32_t>(used_.size()); }  // of 4096 triangles
    uint32_t size() const { return size_; }

    // Every group must be cleared before any triangle is inserted; triangles before sums.
    void clear_group(uint32_t group) { used_[group] = 0; }
    void insert(uint32_t triangle) {
        const uint32_t word = triangle / 64;
        if (!is_used(word)) {
            used_[word / 64] |= uint64_t{1} << word % 64;
            words_[word].bits = 0;
        }
        words_[word].bits |= uint64_t{1} << triangle % 64;
    }
    // In rising order.
    void sum_group(uint32_t group) {
        visit_words(group, [this](uint32_t word) {
            words_[word].before = size_;
            size_ += static_cast<uint32_t>(std::popcount(words_[word].bits));
        });
    }
    // visit(triangle), rising.
    template <class Visit>
    void visit(uint32_t group, Visit visit) const {
        visit_words(group, [&](uint32_t word) {
            for (uint64_t bits = words_[word].bits; bits != 0; bits &= bits - 1)
                visit(64 * word + static_cast<uint32_t>(std::countr_zero(bits)));
        });
    }

    // no_index if it is not one of them.
    uint32_t slot_of(uint32_t triangle) const {
        if (!is_used(triangle / 64)) return no_index;
        const Word& word = words_[triangle / 64];
        const uint64_t bit = uint64_t{1} << triangle % 64;
        if ((word.bits & bit) == 0) return no_index;
        return word.before + static_cast<uint32_t>(std::popcount(word.bits & (bit - 1)));
    }

private:
    struct Word {
        uint64_t bits;
        uint32_t before;
    };
    bool is_used(uint32_t word) const { return (used_[word / 64] >> word % 64 & 1) != 0; }
    template <class Visit>
    void visit_words(uint32_t group, Visit visit) const {
        for (uint64_t left = used_[group]; left != 0; left &= left - 1)
            visit(64 * group + static_cast<uint32_t>(std::countr_zero(left)));
    }

    Buffer<Word> words_;
    Buffer<uint64_t> used_;
    uint32_t size_ = 0;
};

// Points closer to a vertex than this fraction of an edge become that vertex: nearer ones would make slivers, which are
// hard on everything that comes after, and at a hundredth of an edge no eye and no distance notices the move.
constexpr double cut_tolerance = 0.01;

// A triangle that gets new points on its edges. Both triangles of an edge know its points; the one of lower index owns
// them.
struct CutTriangle {
    struct Edge {
        uint32_t points;        // 0: not split
        uint32_t first_vertex;  // of the points, numbered one after the other
        uint32_t twin;          // 3 * slot + edge of the owner across; no_index if this is the owner
        Corner start;           // once written: the piece at the edge's start
    };
    uint32_t triangle;
    uint32_t first_added;  // where its pieces but the first go
    std::array<Edge, 3> edges;
};

// The position and columns of a vertex that a cut adds, linear in the triangle that it comes to lie in.
// At `weights` of the corners, whose sum is 1; computed in double, rounded once. Corners of no weight have no say, be
// their values infinite.
inline void place_vertex(Mesh& mesh, MeshColumns& columns, uint32_t vertex, const Triple& corners,
                         const std::array<double, 3>& weights) {
    const auto interpolate = [&](const float* from, size_t components, float* to) {
        for (size_t c = 0; c < components; ++c) {
            double sum = 0;
            for (uint32_t k = 0; k < 3; ++k) {
                if (weights[k] != 0) sum += weights[k] * from[components * corners[k] + c];
            }
            to[c] = static_cast<float>(sum);
        }
    };
    interpolate(mesh.positions.data()->data(), 3, mesh.positions[vertex].data());
    for (MeshColumn& column : columns) {
        const size_t n = column.components;
        if (column.of_sources)
            store(mix(column, corners, weights), column, vertex);
        else
            interpolate(column.values.data(), n, column.values.data() + n * vertex);
    }
}

// A triangulation of one triangle. Its neighbours are pieces, or outer_edge | k: the piece's edge lies on edge k of the
// triangle.
struct Pieces {
    static constexpr uint32_t outer_edge = 0xfffffffcu;

    explicit Pieces(Memory* memory) : triangles(memory), neighbours(memory), regions(memory) {}
    void clear() {
        triangles.clear();
        neighbours.clear();
        regions.clear();
    }
    void add(const Triple& vertices, const Triple& across, uint32_t region) {
        triangles.push_back(vertices);
        neighbours.push_back(across);
        regions.push_back(region);
    }
    uint32_t size() const { return static_cast<uint32_t>(triangles.size()); }

    std::pmr::vector<Triple> triangles;  // vertices of the mesh, counter-clockwise
    std::pmr::vector<Triple> neighbours;
    std::pmr::vector<uint32_t> regions;
};

class PieceWriter {
public:
    // Slots are written in rising order; the mesh has room for all.
    PieceWriter(Mesh& mesh, MeshEdit& edit, Buffer<CutTriangle>& slots) : mesh_(mesh), edit_(edit), slots_(slots) {}

    void write(CutTriangle& slot, const Pieces& pieces);

private:
    void write_outer(CutTriangle& slot, const Triple& corners, uint32_t k, Corner corner);

    Mesh& mesh_;
    MeshEdit& edit_;
    Buffer<CutTriangle>& slots_;
    Triple across_{};  // of the triangle being replaced
};

}  // namespace flg
