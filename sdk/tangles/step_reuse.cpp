// SPDX-License-Identifier: MIT
#include "tangles/step_reuse.h"

#include <array>
#include <cstring>

#include "surfaces/surface_update.h"
#include "tangles/room_work.h"
#include "tangles/tangle_jobs.h"

namespace flg {

namespace {

constexpr uint32_t growth_chunk = 4000;  // triangles, about 10 us

// The leaves a step reads.
Task<LeafSet> leaves_read(Pace& pace, const RegionTree& tree, StepRecord& record) {
    const RegionLists lists = lists_of(record.request);
    std::pmr::vector<RegionId> all(pace.memory());
    for (const std::pmr::vector<RegionId>* list : {lists.regions, lists.a, lists.b}) {
        if (!list) continue;
        co_await each(pace, list->size(), Cost::some_ns, [&](uint32_t i) { all.push_back((*list)[i]); });
    }
    co_return co_await list_leaves(pace, tree, all, "regions");
}

bool can_be_used_again(const TangleStep& step) {
    if (step.state != StepState::made || step.record->wanted) return false;
    if (std::holds_alternative<DisplaceRequest>(step.record->request)) return true;
    const auto* const divide = std::get_if<DivideRequest>(&step.record->request);
    return divide && !divide->a.curves && !divide->b.curves && !step.record->a.given && !step.record->b.given;
}

// Whether all that a step reads is as it was.
Task<bool> is_clean(Pace& pace, const Mesh& mesh, const LeafSet& leaves, uint32_t expected,
                    const MeshChanges& changes) {
    uint32_t count = 0;
    bool clean = true;
    RegionCursor cursor(mesh, leaves.set);
    while (!cursor.at_end() && clean) {
        detail::visit_some(cursor, static_cast<uint32_t>(Cost::tens_of_ns), static_cast<uint32_t>(Cost::tens_of_ns),
                           [&](uint32_t t) {
                               ++count;
                               const Triple& corners = mesh.triangles[t];
                               clean &= !changes.label_changed(t) && !changes.shape_changed(corners[0]) &&
                                        !changes.shape_changed(corners[1]) && !changes.shape_changed(corners[2]);
                           });
        co_await pace;
    }
    co_return clean&& count == expected;
}

// Words of an edit that was taken back, by the numbers after the edit of the history.
class Renumbering {
public:
    Renumbering(const MeshColumns& columns, const MeshChanges& changes)
        : column_count_(columns.size()), changes_(changes) {}

    // Of a column that only the cut itself carried along.
    bool is_passing(const MeshEdit::Word& word) const { return word.array >= array_columns + column_count_; }
    uint32_t index(const MeshColumns& columns, const MeshEdit::Word& word) const {
        if (word.array >= array_columns) {
            const uint32_t width = columns[word.array - array_columns].components;
            return at(changes_.vertices, word.index, width);
        }
        if (word.array == array_corners) return changes_.vertices[word.index];
        return at(word.array == array_positions ? changes_.vertices : changes_.triangles, word.index, 3);
    }
    uint32_t value(const MeshEdit::Word& word) const { return value(word.array, word.value); }
    uint32_t value(uint32_t array, uint32_t old) const {
        if (array == array_corners) return corner(old);
        if (array == array_triangles) return changes_.vertices[old];
        if (array == array_neighbours) return changes_.triangles[old];
        return old;
    }
    // Whether it has a number where it had one.
    bool is_known(uint32_t array, uint32_t old) const {
        const bool is_index = array == array_corners || array == array_triangles || array == array_neighbours;
        return !is_index || old == no_index || value(array, old) != no_index;
    }

private:
    static uint32_t at(const NumberMap& map, uint32_t index, uint32_t width) {
        const uint32_t now = map[index / width];
        return now == no_index ? no_index : width * now + index % width;
    }
    uint32_t corner(uint32_t old) const { return old == no_index ? no_index : at(changes_.triangles, old, 3); }

    const size_t column_count_;
    const MeshChanges& changes_;
};

// The words that an edit had added of one array.
struct AddedWords {
    const std::byte* bytes;
    size_t count;
    uint32_t operator[](size_t i) const {
        uint32_t word;
        std::memcpy(&word, bytes + i * sizeof word, sizeof word);
        return word;
    }
};

// In the order in which MeshEdit keeps them.
std::array<AddedWords, array_columns> added_words(const Mesh& mesh, MeshEdit& edit) {
    const size_t vertices = edit.after().vertices - edit.before().vertices;
    const size_t triangles = edit.after().triangles - edit.before().triangles;
    const size_t sources = mesh.source_triangles.size() == 0 ? 0 : triangles;
    const std::array<size_t, array_columns> counts = {3 * vertices,  vertices,  3 * triangles,
                                                      3 * triangles, triangles, sources};
    std::array<AddedWords, array_columns> words{};
    const std::byte* at = edit.added().data();
    for (size_t i = 0; i < words.size(); ++i) {
        words[i] = {at, counts[i]};
        at += counts[i] * sizeof(uint32_t);
    }
    return words;
}

Task<bool> all_known(Pace& pace, const Mesh& mesh, MeshEdit& edit, const MeshColumns& columns,
                     const Renumbering& numbers) {
    bool known = true;
    co_await each(pace, edit.words().size(), Cost::tens_of_ns, [&](uint32_t i) {
        const MeshEdit::Word& word = edit.words()[i];
        if (numbers.is_passing(word)) return;
        known &= numbers.index(columns, word) != no_index && numbers.is_known(word.array, word.value);
    });
    const std::array<AddedWords, array_columns> added = added_words(mesh, edit);
    for (const uint32_t array : {array_corners, array_triangles, array_neighbours})
        co_await each(pace, added[array].count, Cost::some_ns,
                      [&](uint32_t i) { known &= numbers.is_known(array, added[array][i]); });
    co_return known;
}

Task<void> write_words(Pace& pace, MeshEdit& from, Mesh& mesh, MeshColumns& columns, const Renumbering& numbers,
                       MeshEdit& edit) {
    co_await each(pace, from.words().size(), Cost::tens_of_ns, [&](uint32_t i) {
        const MeshEdit::Word& word = from.words()[i];
        if (numbers.is_passing(word)) return;
        edit.set_word(mesh, columns, word.array, numbers.index(columns, word), numbers.value(word));
    });
}

// What the edit had added, behind what there is.
Task<void> append_added(Pace& pace, MeshEdit& from, Mesh& mesh, MeshColumns& columns, const Renumbering& numbers,
                        const RegionMap& regions, uint32_t first_vertex, uint32_t first_triangle) {
    const std::array<AddedWords, array_columns> added = added_words(mesh, from);
    const std::array<uint32_t*, 5> to = {
        reinterpret_cast<uint32_t*>(mesh.positions.data() + first_vertex), mesh.corner_of_vertex.data() + first_vertex,
        reinterpret_cast<uint32_t*>(mesh.triangles.data() + first_triangle),
        reinterpret_cast<uint32_t*>(mesh.neighbours.data() + first_triangle), mesh.regions.data() + first_triangle};
    for (uint32_t array = 0; array < array_regions; ++array)
        co_await each(pace, added[array].count, Cost::some_ns,
                      [&, out = to[array]](uint32_t i) { out[i] = numbers.value(array, added[array][i]); });
    co_await each(pace, added[array_regions].count, Cost::some_ns, [&](uint32_t i) {
        mesh.regions[first_triangle + i] = regions[added[array_regions][i]];
        mesh.region_blocks.add(mesh.regions[first_triangle + i], first_triangle + i);
    });
    co_await each(pace, added[array_sources].count, Cost::some_ns,
                  [&](uint32_t i) { mesh.source_triangles[first_triangle + i] = added[array_sources][i]; });
    const std::byte* at = added[array_sources].bytes + added[array_sources].count * sizeof(uint32_t);
    const size_t vertices = from.after().vertices - from.before().vertices;
    for (MeshColumn& column : columns) {
        const AddedWords words{at, vertices * column.components};
        float* const values = column.values.data() + size_t{first_vertex} * column.components;
        co_await each(pace, words.count, Cost::some_ns, [&](uint32_t i) {
            const uint32_t word = words[i];
            std::memcpy(values + i, &word, sizeof word);
        });
        at += words.count * sizeof(uint32_t);
    }
}

Task<void> write_labels(Pace& pace, const MeshEdit& from, Mesh& mesh, const MeshChanges& changes,
                        const RegionMap& regions, MeshEdit& edit) {
    Slice slice(Cost::tens_of_ns);
    for (size_t r = 0; r < from.labels().size(); ++r) {
        const MeshEdit::LabelRun run = from.labels()[r];
        const RegionId label = regions[run.label];
        for (Portion part(slice, run.first, run.first + run.count); part.next();) {
            for (uint32_t t = part.begin; t < part.end; ++t) edit.set_region(mesh, changes.triangles[t], label);
            if (part.is_over()) co_await pace;
        }
    }
}

// The tree's part of a step, made as the operator makes it of what it cut.
Task<void> add_same_leaves(Pace& pace, Tangle& tangle, const TangleStep& before, RegionMap& regions, TangleStep& step) {
    const std::pmr::deque<RegionNode>& nodes = before.tree.added();
    if (nodes.empty()) co_return;
    const FlgTangleDivideDesc& desc = std::get<DivideRequest>(step.record->request).desc;
    Buffer<NewLeaf> leaves(nodes.size(), pace.memory());
    co_await each(pace, leaves.size(), Cost::tens_of_ns, [&](uint32_t i) {
        leaves[i] = {regions[nodes[i].parent], nodes[i].part};
    });
    const RegionId first = tangle.tree.size();
    const Buffer<RegionId> made =
        co_await add_leaves(pace, tangle.tree, step.tree, leaves, {desc.grouping, desc.cycle, desc.scaffold != 0});
    co_await each(pace, made.size(), Cost::some_ns,
                  [&](uint32_t i) { regions.set(before.record->first_region + i, made[i]); });
    co_await RegionBlocks::restart(pace, tangle.surface->mesh().region_blocks, first);
}

Task<void> copy_step(Pace& pace, Tangle& tangle, const OldStep& old, uint32_t revision, MeshChanges& changes,
                     RegionMap& regions, TangleStep& step) {
    co_await add_same_leaves(pace, tangle, *old.step, regions, step);
    if (!old.step->edit) co_return;
    Surface& surface = *tangle.surface;
    Mesh& mesh = surface.mesh();
    MeshEdit& from = *old.step->edit;
    const uint32_t vertices = mesh.vertex_count(), triangles = mesh.triangle_count();
    const uint32_t more_vertices = from.after().vertices - from.before().vertices;
    const uint32_t more_triangles = from.after().triangles - from.before().triangles;
    MeshGrowth growth(mesh, surface.columns, vertices + more_vertices, triangles + more_triangles);
    while (!growth.run(growth_chunk)) co_await pace;
    MeshEdit& edit = step.edit.emplace(pace.memory());
    edit.begin(mesh);
    const Renumbering numbers(surface.columns, changes);
    co_await write_words(pace, from, mesh, surface.columns, numbers, edit);
    co_await write_labels(pace, from, mesh, changes, regions, edit);
    resize_mesh(mesh, surface.columns, vertices + more_vertices, triangles + more_triangles);
    co_await append_added(pace, from, mesh, surface.columns, numbers, regions, vertices, triangles);
    edit.end(mesh);
    co_await update_after_edit(pace, surface, edit, revision);
}

}  // namespace

Task<void> begin(Pace& pace, MeshChanges& changes, const Mesh& mesh) {
    changes.vertices.begin(mesh.vertex_count());
    changes.triangles.begin(mesh.triangle_count());
    for (GrowingMarks* marks : {&changes.shapes_, &changes.labels_}) {
        const size_t count = marks == &changes.shapes_ ? mesh.vertex_count() : mesh.triangle_count();
        co_await each(pace, count / 64 + 1, Cost::tens_of_ns, [&](uint32_t) { marks->words().push_back(0); });
    }
}

Task<void> mark_old(Pace& pace, const OldStep& old, MeshChanges& changes) {
    co_await each(pace, old.touched.size(), Cost::tens_of_ns, [&](uint32_t i) {
        const uint32_t vertex = changes.vertices[old.touched[i]];
        if (vertex != no_index) changes.shapes_.set(vertex);
    });
    if (!old.step->edit) co_return;
    Slice slice(Cost::tens_of_ns);
    for (const MeshEdit::LabelRun& run : old.step->edit->labels()) {
        for (Portion part(slice, run.first, run.first + run.count); part.next();) {
            for (uint32_t t = part.begin; t < part.end; ++t) {
                const uint32_t triangle = changes.triangles[t];
                if (triangle != no_index) changes.labels_.set(triangle);
            }
            if (part.is_over()) co_await pace;
        }
    }
}

Task<void> mark_new(Pace& pace, const Mesh& mesh, const TangleStep& step, MeshChanges& changes) {
    if (!step.edit) co_return;
    const MeshEdit& edit = *step.edit;
    {
        const std::pmr::deque<uint32_t> touched = co_await find_touched(pace, mesh, edit);
        co_await each(pace, touched.size(), Cost::tens_of_ns, [&](uint32_t i) { changes.shapes_.set(touched[i]); });
    }
    co_await each(pace, edit.words().size(), Cost::tens_of_ns, [&](uint32_t i) {
        if (edit.words()[i].array == array_corners) changes.shapes_.set(edit.words()[i].index);
    });
    co_await each(pace, edit.before().vertices, edit.after().vertices, Cost::tens_of_ns,
                  [&](uint32_t v) { changes.shapes_.set(v); });
    co_await each(pace, edit.before().triangles, edit.after().triangles, Cost::tens_of_ns,
                  [&](uint32_t t) { changes.labels_.set(t); });
    Slice slice(Cost::tens_of_ns);
    for (const MeshEdit::LabelRun& run : edit.labels()) {
        for (Portion part(slice, run.first, run.first + run.count); part.next();) {
            for (uint32_t t = part.begin; t < part.end; ++t) changes.labels_.set(t);
            if (part.is_over()) co_await pace;
        }
    }
}

Task<void> look_back(Pace& pace, const Tangle& tangle, OldStep& old) {
    const Mesh& mesh = tangle.surface->mesh();
    if (old.step->edit) {
        const auto add = [&](uint32_t vertex) {
            if (old.touched.empty() || old.touched.back() != vertex) old.touched.push_back(vertex);
        };
        const auto add_triangle = [&](uint32_t t) {
            for (const uint32_t vertex : mesh.triangles[t]) add(vertex);
        };
        co_await each(pace, old.step->edit->words().size(), Cost::hundreds_of_ns, [&](uint32_t i) {
            const MeshEdit::Word& word = old.step->edit->words()[i];
            if (word.array == array_corners) add(word.index);
            if (word.array == array_triangles) {
                if (word.index % 3 == 0) add_triangle(word.index / 3);
                if (word.value < mesh.vertex_count()) add(word.value);
            }
            if (word.array != array_positions || word.index % 3 != 0) return;
            const Corner first = mesh.corner_of_vertex[word.index / 3];
            Corner corner = first;
            do {
                add_triangle(triangle_of(corner));
                corner = mesh.turn(corner);
            } while (corner != first && corner != no_index);
        });
    }
    if (!can_be_used_again(*old.step)) co_return;
    const LeafSet leaves = co_await leaves_read(pace, tangle.tree, *old.step->record);
    uint32_t count = 0;
    co_await each_within(pace, mesh, leaves.set, Cost::some_ns, [&](uint32_t) { ++count; });
    old.read = count;
}

Task<bool> use_again(Pace& pace, Tangle& tangle, const OldStep& old, uint32_t revision, MeshChanges& changes,
                     RegionMap& regions, TangleStep& step) {
    if (old.read == no_index || step.record->wanted) co_return false;
    pace.stage("reuse");
    const Mesh& mesh = tangle.surface->mesh();
    {
        const LeafSet leaves = co_await leaves_read(pace, tangle.tree, *step.record);
        if (!co_await is_clean(pace, mesh, leaves, old.read, changes)) co_return false;
    }
    for (const RegionNode& node : old.step->tree.added())
        if (regions[node.parent] == no_region) co_return false;
    const bool has_edit = old.step->edit.has_value();
    const MeshEdit::Counts before = has_edit ? old.step->edit->before() : MeshEdit::Counts{};
    const MeshEdit::Counts after = has_edit ? old.step->edit->after() : MeshEdit::Counts{};
    const size_t vertex_ranges = changes.vertices.range_count(), triangle_ranges = changes.triangles.range_count();
    changes.vertices.add(before.vertices, after.vertices - before.vertices, mesh.vertex_count());
    changes.triangles.add(before.triangles, after.triangles - before.triangles, mesh.triangle_count());
    if (has_edit) {
        const MeshColumns& columns = tangle.surface->columns;
        const Renumbering numbers(columns, changes);
        if (!co_await all_known(pace, tangle.surface->mesh(), *old.step->edit, columns, numbers)) {
            changes.vertices.forget_after(vertex_ranges);
            changes.triangles.forget_after(triangle_ranges);
            co_return false;
        }
    }
    step.record->first_region = tangle.tree.size();
    Task<void> change = copy_step(pace, tangle, old, revision, changes, regions, step);
    co_await run_step(pace, tangle, step, change);
    co_return true;
}

Task<bool> move_points(Pace& pace, const Mesh& mesh, const MeshChanges& changes, Buffer<SurfacePoint>& points) {
    bool same = true;
    co_await each(pace, points.size(), Cost::tens_of_ns, [&](uint32_t i) {
        const uint32_t triangle = changes.triangles[points[i].triangle];
        same &= triangle != no_index && triangle < mesh.triangle_count();
        for (size_t k = 0; same && k < 3; ++k) same &= !changes.shape_changed(mesh.triangles[triangle][k]);
    });
    if (!same) co_return false;
    co_await each(pace, points.size(), Cost::tens_of_ns,
                  [&](uint32_t i) { points[i].triangle = changes.triangles[points[i].triangle]; });
    co_return true;
}

}  // namespace flg
