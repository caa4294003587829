// SPDX-License-Identifier: MIT
#include "surfaces/mesh_edit_replay.h"

namespace flg {

MeshEditReplay::MeshEditReplay(Mesh& mesh, MeshColumns& columns, MeshEdit& edit, Direction direction)
    : mesh_(mesh),
      columns_(columns),
      edit_(edit),
      undo_(direction != Direction::redo),
      keep_(direction != Direction::abandon) {
    if (undo_ && keep_) {
        size_t bytes = 0;
        for (size_t i = 0; i < array_count(); ++i) bytes += array(i).count * array(i).width;
        edit.added() = Buffer<std::byte>(bytes, edit.memory());
    }
    pass_ = Pass::words;
}

MeshEditReplay::Array MeshEditReplay::array(size_t index) {
    const MeshEdit::Counts &before = edit_.before(), &after = edit_.after();
    const auto of = [](auto& buffer, size_t width, size_t first, size_t end) {
        return Array{reinterpret_cast<std::byte*>(buffer.data()), width, first, end - first};
    };
    switch (index) {
        case array_positions: return of(mesh_.positions, sizeof(Position), before.vertices, after.vertices);
        case array_corners: return of(mesh_.corner_of_vertex, sizeof(Corner), before.vertices, after.vertices);
        case array_triangles: return of(mesh_.triangles, sizeof(Triple), before.triangles, after.triangles);
        case array_neighbours: return of(mesh_.neighbours, sizeof(Triple), before.triangles, after.triangles);
        case array_regions: return of(mesh_.regions, sizeof(uint32_t), before.triangles, after.triangles);
        default: break;
    }
    MeshColumn& column = columns_[index - array_columns];
    return of(column.values, column.components * sizeof(float), before.vertices, after.vertices);
}

void MeshEditReplay::swap_word(MeshEdit::Word& word) {
    if (word.array >= array_count()) return;  // of a column that only the cut itself carried along
    std::byte* place = array(word.array).data + size_t{word.index} * sizeof(uint32_t);
    uint32_t value;
    std::memcpy(&value, place, sizeof value);
    std::memcpy(place, &word.value, sizeof value);
    word.value = value;
}

void MeshEditReplay::write_labels(uint32_t& count) {
    const auto& runs = edit_.labels();
    const MeshEdit::LabelRun& run = runs[undo_ ? runs.size() - 1 - at_ : at_];
    for (; count > 0 && within_ < run.count; ++within_, --count) {
        mesh_.regions[run.first + within_] = undo_ ? run.old : run.label;
    }
    if (within_ < run.count) return;
    within_ = 0;
    ++at_;
}

void MeshEditReplay::move_added(uint32_t& count) {
    const Array moving = array(at_);
    const size_t bytes = moving.count * moving.width;
    const size_t step = std::min<size_t>(bytes - within_, size_t{count} * sizeof(uint32_t));
    std::byte* in_mesh = moving.data + moving.first * moving.width + within_;
    std::byte* kept = edit_.added().data() + moved_ + within_;
    if (step != 0) undo_ ? std::memcpy(kept, in_mesh, step) : std::memcpy(in_mesh, kept, step);
    within_ += step;
    count -= static_cast<uint32_t>(step / sizeof(uint32_t));
    if (within_ < bytes) return;
    moved_ += bytes;
    within_ = 0;
    ++at_;
}

void MeshEditReplay::enter(Pass pass) {
    pass_ = pass;
    at_ = within_ = 0;
    if (pass != Pass::done) return;
    const MeshEdit::Counts& counts = undo_ ? edit_.before() : edit_.after();
    resize_mesh(mesh_, columns_, counts.vertices, counts.triangles);
    if (!undo_) edit_.added() = {};
}

bool MeshEditReplay::run(uint32_t count) {
    while (count > 0 && pass_ != Pass::done) {
        switch (pass_) {
            case Pass::words: {
                const size_t size = edit_.words().size();
                for (; count > 0 && at_ < size; ++at_, --count) swap_word(edit_.words()[undo_ ? size - 1 - at_ : at_]);
                if (at_ == size) enter(Pass::labels);
                break;
            }
            case Pass::labels:
                if (at_ < edit_.labels().size()) {
                    write_labels(count);
                } else {
                    enter(keep_ ? Pass::added : Pass::done);
                }
                break;
            case Pass::added:
                if (at_ == array_count()) {
                    enter(Pass::done);
                } else {
                    move_added(count);
                }
                break;
            case Pass::done: break;
        }
    }
    return pass_ == Pass::done;
}

}  // namespace flg
