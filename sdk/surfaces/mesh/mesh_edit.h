// SPDX-License-Identifier: MIT
// What a cut changed in a mesh: enough to take it back and to make it again, to the bit, without a copy of the mesh.
// Memory is proportional to the change: 12 bytes an overwritten word, 16 bytes a run of relabelled triangles; while the
// cut is taken back, also what it had added.
//
// Invariants
// - Vertices and triangles are only added, at the end of the arrays; those there were keep their index.
// - Words and labels are remembered in the order they were written, each time they were: taking back goes from the last
//   to the first. What lies beyond the counts before is not remembered.
// - Edits of one mesh form a stack: only the last one that is made can be taken back, only the last one that was taken
//   back can be made again.
#pragma once

#include <deque>

#include "runtime/pace.h"
#include "runtime/task.h"
#include "surfaces/mesh/mesh_growth.h"

namespace flg {

// The arrays of 32-bit words a mesh consists of; the columns follow.
enum MeshArray : uint32_t {
    array_positions,
    array_corners,
    array_triangles,
    array_neighbours,
    array_regions,
    array_sources,
    array_columns
};

class MeshEdit {
public:
    explicit MeshEdit(Memory* memory) : words_(memory), labels_(memory), memory_(memory) {}

    struct Counts {
        uint32_t vertices = 0, triangles = 0;
    };
    const Counts& before() const { return before_; }
    const Counts& after() const { return after_; }

    // ---- for those who cut. Between begin and end, all changes to what there was go through these, which remember
    // before they write: if memory runs out in one, what was written so far can be taken back.
    void begin(const Mesh& mesh) { before_ = after_ = {mesh.vertex_count(), mesh.triangle_count()}; }
    void end(const Mesh& mesh) { after_ = {mesh.vertex_count(), mesh.triangle_count()}; }

    void set_triangle(Mesh& mesh, uint32_t triangle, const Triple& vertices) {
        for (uint32_t k = 0; k < 3; ++k) remember(array_triangles, 3 * triangle + k, mesh.triangles[triangle][k]);
        mesh.triangles[triangle] = vertices;
    }
    void set_neighbour(Mesh& mesh, Corner edge, uint32_t neighbour) {
        uint32_t& word = mesh.neighbours[edge / 3][edge % 3];
        if (triangle_of(edge) < before_.triangles && word != neighbour) remember(array_neighbours, edge, word);
        word = neighbour;
    }
    void set_position(Mesh& mesh, uint32_t vertex, const Position& position);
    void set_corner(Mesh& mesh, uint32_t vertex, Corner corner) {
        remember(array_corners, vertex, mesh.corner_of_vertex[vertex]);
        mesh.corner_of_vertex[vertex] = corner;
    }
    // Of a column of one component.
    void set_value(MeshColumns& columns, uint32_t column, uint32_t vertex, float value);
    // Any word of the arrays but labels, by its index in them.
    void set_word(Mesh& mesh, MeshColumns& columns, uint32_t array, uint32_t index, uint32_t value);
    // A triangle that was added lies in the input's triangle in which the one that it was cut out of lies.
    void set_source(Mesh& mesh, uint32_t triangle, uint32_t from) {
        if (mesh.source_triangles.size() != 0) mesh.source_triangles[triangle] = mesh.source_triangles[from];
    }
    // Triangles in rising order make long runs.
    void set_region(Mesh& mesh, uint32_t triangle, uint32_t label) {
        uint32_t& region = mesh.regions[triangle];
        const bool was_there = triangle < before_.triangles;
        if (was_there && region == label) return;
        if (was_there) remember_label(triangle, region, label);
        mesh.region_blocks.add(label, triangle);
        region = label;
    }

    // ---- for those who ask what was changed, and for MeshEditReplay
    struct Word {
        uint32_t array;  // MeshArray, or array_columns + column
        uint32_t index;  // of the word in it
        uint32_t value;  // the one it does not have now
    };
    struct LabelRun {
        uint32_t first, count;  // triangles
        uint32_t old, label;
    };
    std::pmr::deque<Word>& words() { return words_; }
    const std::pmr::deque<Word>& words() const { return words_; }
    std::pmr::deque<LabelRun>& labels() { return labels_; }
    const std::pmr::deque<LabelRun>& labels() const { return labels_; }
    // What the cut had added, one array behind the other; empty while the cut is in the mesh.
    Buffer<std::byte>& added() { return added_; }
    Memory* memory() const { return memory_; }

private:
    void remember_label(uint32_t triangle, uint32_t old, uint32_t label) {
        if (!labels_.empty()) {
            LabelRun& last = labels_.back();
            if (triangle == last.first + last.count && old == last.old && label == last.label) {
                ++last.count;
                return;
            }
        }
        labels_.push_back({triangle, 1, old, label});
    }
    // Words of an array.
    uint32_t count_before(MeshArray array) const {
        if (array == array_corners) return before_.vertices;
        return 3 * (array == array_positions ? before_.vertices : before_.triangles);
    }
    void remember(MeshArray array, uint32_t index, uint32_t value) {
        if (index < count_before(array)) words_.push_back({array, index, value});
    }

    Counts before_, after_;
    std::pmr::deque<Word> words_;
    std::pmr::deque<LabelRun> labels_;
    Buffer<std::byte> added_;
    Memory* memory_;
};

// Takes an edit back, or makes it again: overwritten words change places with those remembered, labels are written by
// runs, what the cut added moves out of the mesh's arrays and in again.
//
// A kernel and no task because it takes no memory once it is made, and none at all to abandon: what ran out of memory
// takes its changes back by it.
class MeshEditReplay {
public:
    // abandon: undo for good, also an edit that has not come to its end.
    enum class Direction { undo, redo, abandon };
    // The same mesh and columns as the edit was made in, with nothing changed since (but by later edits taken back).
    MeshEditReplay(Mesh& mesh, MeshColumns& columns, MeshEdit& edit, Direction direction);

    // Advances by `count` words; true when done.
    bool run(uint32_t count);

private:
    struct Array {
        std::byte* data;
        size_t width;         // bytes a vertex or triangle
        size_t first, count;  // those added
    };

    size_t array_count() const { return array_columns + columns_.size(); }
    Array array(size_t index);
    void swap_word(MeshEdit::Word& word);
    bool swap_words(uint32_t& count);
    bool write_labels(uint32_t& count);
    bool move_added(uint32_t& count);

    Mesh& mesh_;
    MeshColumns& columns_;
    MeshEdit& edit_;
    const bool undo_;
    const bool keep_;                              // what was added
    size_t word_ = 0, label_run_ = 0, array_ = 0;  // done of each
    size_t within_ = 0;                            // of the run: triangles; of the array: bytes
    size_t moved_ = 0;                             // bytes of the arrays before
};

// Where all triangles of the first `count` runs of labels have got others since: what they have now takes the place of
// those. Cost: some ns a triangle of these runs.
Task<void> forget_passing_labels(Pace& pace, const Mesh& mesh, size_t count, MeshEdit& edit);

// Vertices that an edit touched, for what is kept beside the mesh and must follow it (geodesic blocks): those of
// changed triangles, moved corners among the changes. Only such as were there before; added ones are known by their
// index. After the edit, before any other; the same list holds after it was taken back. About 50 ns a word that was
// overwritten and a triangle that was added, six times as much for a vertex that moved. Memory while it runs: a bit a
// vertex.
Task<std::pmr::deque<uint32_t>> find_touched(Pace& pace, const Mesh& mesh, const MeshEdit& edit);

}  // namespace flg
