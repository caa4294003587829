// SPDX-License-Identifier: MIT
#include "surfaces/mesh/mesh_edit.h"

#include <bit>
#include <cstring>

#include "runtime/each.h"
#include "surfaces/mesh/marks.h"

namespace flg {

void MeshEdit::set_position(Mesh& mesh, uint32_t vertex, const Position& position) {
    Position& place = mesh.positions[vertex];
    for (uint32_t k = 0; k < 3; ++k) remember(array_positions, 3 * vertex + k, std::bit_cast<uint32_t>(place[k]));
    place = position;
}

void MeshEdit::set_value(MeshColumns& columns, uint32_t column, uint32_t vertex, float value) {
    float& word = columns[column].values[vertex];
    if (vertex < before_.vertices) words_.push_back({array_columns + column, vertex, std::bit_cast<uint32_t>(word)});
    word = value;
}

void MeshEdit::set_word(Mesh& mesh, MeshColumns& columns, uint32_t array, uint32_t index, uint32_t value) {
    std::byte* data = nullptr;
    switch (array) {
        case array_positions: data = reinterpret_cast<std::byte*>(mesh.positions.data()); break;
        case array_corners: data = reinterpret_cast<std::byte*>(mesh.corner_of_vertex.data()); break;
        case array_triangles: data = reinterpret_cast<std::byte*>(mesh.triangles.data()); break;
        case array_neighbours: data = reinterpret_cast<std::byte*>(mesh.neighbours.data()); break;
        default: data = reinterpret_cast<std::byte*>(columns[array - array_columns].values.data());
    }
    uint32_t old;
    std::memcpy(&old, data + size_t{index} * sizeof old, sizeof old);
    words_.push_back({array, index, old});
    std::memcpy(data + size_t{index} * sizeof value, &value, sizeof value);
}

// ---- Taken back and made again

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
        case array_sources: {
            if (mesh_.source_triangles.size() == 0) return {nullptr, sizeof(uint32_t), 0, 0};
            return of(mesh_.source_triangles, sizeof(uint32_t), before.triangles, after.triangles);
        }
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

// The steps return true when done; they lower `count` by what they did.
bool MeshEditReplay::swap_words(uint32_t& count) {
    auto& words = edit_.words();
    for (; count > 0 && word_ < words.size(); ++word_, --count) {
        swap_word(words[undo_ ? words.size() - 1 - word_ : word_]);
    }
    return word_ == words.size();
}

bool MeshEditReplay::write_labels(uint32_t& count) {
    const auto& runs = edit_.labels();
    for (; label_run_ < runs.size(); ++label_run_, within_ = 0) {
        const MeshEdit::LabelRun& run = runs[undo_ ? runs.size() - 1 - label_run_ : label_run_];
        for (; count > 0 && within_ < run.count; ++within_, --count) {
            mesh_.regions[run.first + within_] = undo_ ? run.old : run.label;
        }
        if (within_ < run.count) return false;
    }
    return true;
}

bool MeshEditReplay::move_added(uint32_t& count) {
    for (; array_ < array_count(); ++array_, within_ = 0) {
        const Array moving = array(array_);
        const size_t bytes = moving.count * moving.width;
        const size_t step = std::min<size_t>(bytes - within_, size_t{count} * sizeof(uint32_t));
        std::byte* in_mesh = moving.data + moving.first * moving.width + within_;
        std::byte* kept = edit_.added().data() + moved_ + within_;
        if (step != 0) undo_ ? std::memcpy(kept, in_mesh, step) : std::memcpy(in_mesh, kept, step);
        within_ += step;
        count -= static_cast<uint32_t>(step / sizeof(uint32_t));
        if (within_ < bytes) return false;
        moved_ += bytes;
    }
    return true;
}

bool MeshEditReplay::run(uint32_t count) {
    if (!swap_words(count) || !write_labels(count)) return false;
    if (keep_ && !move_added(count)) return false;
    const MeshEdit::Counts& counts = undo_ ? edit_.before() : edit_.after();
    resize_mesh(mesh_, columns_, counts.vertices, counts.triangles);
    if (!undo_) edit_.added() = {};
    return true;
}

// ---- Labels

Task<void> forget_passing_labels(Pace& pace, const Mesh& mesh, size_t count, MeshEdit& edit) {
    std::pmr::deque<MeshEdit::LabelRun> runs(edit.labels().get_allocator());
    Slice slice(Cost::some_ns);
    for (size_t i = 0; i < count; ++i) {
        const MeshEdit::LabelRun passing = edit.labels()[i];
        for (Portion part(slice, passing.first, passing.first + passing.count); part.next();) {
            for (uint32_t t = part.begin; t < part.end; ++t) {
                const uint32_t label = mesh.regions[t];
                if (!runs.empty() && runs.back().first + runs.back().count == t && runs.back().old == passing.old &&
                    runs.back().label == label)
                    ++runs.back().count;
                else
                    runs.push_back({t, 1, passing.old, label});
            }
            if (part.is_over()) co_await pace;
        }
    }
    edit.labels().swap(runs);
    for (; !runs.empty(); runs.pop_back())
        if (slice.is_over()) co_await pace;
}

// ---- Touched vertices

namespace {

// visit(triangle) for those that change `i` is about: first come the words that were overwritten, then the triangles
// that were added.
template <class Visit>
void visit_changed(const Mesh& mesh, const MeshEdit& edit, uint32_t i, Visit visit) {
    const auto words = static_cast<uint32_t>(edit.words().size());
    if (i >= words) {
        visit(edit.before().triangles + i - words);
        return;
    }
    const MeshEdit::Word& word = edit.words()[i];
    if (word.index % 3 != 0) return;
    if (word.array == array_triangles) {
        visit(word.index / 3);
    } else if (word.array == array_positions) {
        const Corner first = mesh.corner_of_vertex[word.index / 3];
        Corner corner = first;
        do {
            visit(triangle_of(corner));
            corner = mesh.turn(corner);
        } while (corner != first && corner != no_index);
    }
}

}  // namespace

Task<std::pmr::deque<uint32_t>> find_touched(Pace& pace, const Mesh& mesh, const MeshEdit& edit) {
    std::pmr::deque<uint32_t> touched(pace.memory());
    Marks marks = co_await no_marks(pace, edit.before().vertices);
    const size_t changes = edit.words().size() + edit.after().triangles - edit.before().triangles;
    co_await each(pace, changes, Cost::tens_of_ns, [&](uint32_t i) {
        visit_changed(mesh, edit, i, [&](uint32_t triangle) {
            for (const uint32_t vertex : mesh.triangles[triangle])
                if (vertex < edit.before().vertices && marks.set(vertex)) touched.push_back(vertex);
        });
    });
    co_return touched;
}

}  // namespace flg
