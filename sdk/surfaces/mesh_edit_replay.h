// SPDX-License-Identifier: MIT
// Takes an edit back, or makes it again: overwritten words change places with those remembered, labels are written by
// runs, what the cut added moves out of the mesh's arrays and in again.
#pragma once

#include "surfaces/mesh_edit.h"

namespace flg {

class MeshEditReplay {
public:
    // abandon: undo for good. Takes no memory, also for an edit that has not come to its end.
    enum class Direction { undo, redo, abandon };
    // The same mesh and columns as the edit was made in, with nothing changed since (but by later edits taken back).
    MeshEditReplay(Mesh& mesh, MeshColumns& columns, MeshEdit& edit, Direction direction);

    // Advances by `count` words; true when done.
    bool run(uint32_t count);

private:
    enum class Pass { words, labels, added, done };
    struct Array {
        std::byte* data;
        size_t width;         // bytes a vertex or triangle
        size_t first, count;  // those added
    };

    size_t array_count() const { return array_columns + columns_.size(); }
    Array array(size_t index);
    void swap_word(MeshEdit::Word& word);
    void write_labels(uint32_t& count);
    void move_added(uint32_t& count);
    void enter(Pass pass);

    Mesh& mesh_;
    MeshColumns& columns_;
    MeshEdit& edit_;
    const bool undo_;
    const bool keep_;  // what was added
    Pass pass_;
    size_t at_ = 0;      // word, run or array
    size_t within_ = 0;  // of the run: triangles; of the array: bytes
    size_t moved_ = 0;   // bytes of the arrays before
};

}  // namespace flg
