// SPDX-License-Identifier: MIT
#include "surfaces/cutting_jobs.h"

#include <algorithm>
#include <bit>
#include <exception>

#include "core/failure.h"
#include "runtime/each.h"
#include "surfaces/cutting/cut_curves.h"
#include "surfaces/cutting/cut_isolines.h"
#include "surfaces/cutting/cut_regions.h"
#include "surfaces/mesh/extra_column.h"
#include "surfaces/mesh/mesh_edit.h"
#include "surfaces/surface_update.h"

namespace flg {

namespace {

constexpr uint32_t copy_chunk = 4000;  // words, about 10 us

// The labels that are there, rising.
Task<std::pmr::vector<uint32_t>> list_regions(Pace& pace, const Mesh& mesh) {
    std::pmr::vector<uint64_t> bits(pace.memory());
    co_await each(pace, mesh.triangle_count(), Cost::some_ns, [&](uint32_t t) {
        const uint32_t region = mesh.regions[t];
        if (region / 64 >= bits.size()) bits.resize(region / 64 + 1);
        bits[region / 64] |= uint64_t{1} << region % 64;
    });
    std::pmr::vector<uint32_t> regions(pace.memory());
    co_await each(pace, bits.size(), Cost::tens_of_ns, [&](uint32_t word) {
        for (uint64_t left = bits[word]; left != 0; left &= left - 1) {
            regions.push_back(64 * word + static_cast<uint32_t>(std::countr_zero(left)));
        }
    });
    co_return regions;
}

// What each region's triangles are labelled with.
Task<std::pmr::vector<RegionLevels>> list_labels(Pace& pace, const CutIsolinesRequest& request, uint32_t level_count) {
    const bool all = request.regions.empty();
    // (Not a conditional expression: GCC 12 destroys what is awaited in one twice.)
    std::pmr::vector<uint32_t> regions(request.regions, pace.memory());
    if (all) regions = co_await list_regions(pace, request.field->surface->mesh());
    std::pmr::vector<RegionLevels> labels(pace.memory());
    co_await each(pace, regions.size(), Cost::some_ns, [&](uint32_t i) {
        const uint64_t first = request.first_label + (all ? 0 : uint64_t{level_count + 1} * labels.size());
        if (request.first_label != no_index && first + level_count > FLG_REGION_MAX) {
            throw Failure(FLG_ERROR_LIMIT, "labels up to %llu would be needed, the largest is %u",
                          static_cast<unsigned long long>(first + level_count), FLG_REGION_MAX);
        }
        labels.push_back({regions[i], request.first_label == no_index ? no_index : static_cast<uint32_t>(first)});
    });
    co_return labels;
}

Task<Buffer<float>> copy_out(Pace& pace, const GrowingBuffer<float>& from) {
    Buffer<float> copy(from.size(), pace.memory());
    co_await each(pace, from.size(), Cost::some_ns, [&](uint32_t i) { copy[i] = from[i]; });
    co_return copy;
}

// A change of the surface: all of it or, if it fails, nothing. It takes no memory to take one back.
Task<void> run_or_take_back(Pace& pace, Surface& surface, MeshEdit& edit, Task<void>& change) {
    edit.begin(surface.mesh());  // it may fail before it comes to that
    std::exception_ptr failure;
    try {
        co_await std::move(change);
    } catch (...) {
        failure = std::current_exception();
    }
    if (!failure) co_return;
    MeshEditReplay back(surface.mesh(), surface.columns, edit, MeshEditReplay::Direction::abandon);
    while (!back.run(copy_chunk)) co_await pace;
    std::rethrow_exception(failure);
}

// Gives back some of the memory of an edit that is over; true when there is no more. (All at once, that of an edit of
// many triangles would take milliseconds. It is no task: that would take memory.)
bool release(MeshEdit& edit) {
    auto& words = edit.words();
    for (uint32_t i = 0; i < copy_chunk && !words.empty(); ++i) words.pop_back();
    return words.empty();
}

Task<void> cut_along_isolines(Pace& pace, const CutIsolinesRequest& request, const CutLevels& levels,
                              const ExtraColumn& field, MeshEdit& edit) {
    Surface& surface = *request.field->surface;
    co_await embed_isolines(pace, surface.mesh(), surface.columns, field.index(), levels, edit);
    if (request.out) request.out->data.distances = co_await copy_out(pace, field.values());
    co_await update_after_edit(pace, surface, edit, request.revision);
}

Task<void> cut_along_curves(Pace& pace, const TracedCurves& curves, uint32_t first_label, uint32_t revision,
                            MeshEdit& edit) {
    Surface& surface = *curves.surface;
    EmbeddedCurves embedded(pace.memory());
    co_await embed_curves(pace, surface.mesh(), surface.columns, curves.curves, edit, embedded);
    if (first_label != no_index) {
        pace.stage("label");
        std::pmr::deque<RegionPart> parts(pace.memory());
        co_await divide_regions(pace, surface.mesh(), embedded.edges, first_label, edit, parts);
    }
    co_await update_after_edit(pace, surface, edit, revision);
}

}  // namespace

Task<void> cut_isolines(Pace& pace, CutIsolinesRequest request) {
    Surface& surface = *request.field->surface;
    pace.stage("levels");
    const Buffer<float> levels = co_await list_levels(pace, request.field->data, request.levels, max_cut_levels);
    // As many labels as were asked for, also where the field does not reach all levels.
    const auto level_count = request.levels.count > 0 ? request.levels.count : static_cast<uint32_t>(levels.size());
    const std::pmr::vector<RegionLevels> labels = co_await list_labels(pace, request, level_count);
    const CutLevels cut_levels({levels.data(), levels.size()}, labels);
    GrowingBuffer<float> values = co_await copy_values(pace, request.field->data.distances);

    pace.stage("cut");
    pace.commit();
    MeshEdit edit(pace.memory());
    const ExtraColumn field(surface.columns, std::move(values));
    Task<void> cut = cut_along_isolines(pace, request, cut_levels, field, edit);
    co_await run_or_take_back(pace, surface, edit, cut);
    while (!release(edit)) co_await pace;
}

Task<void> cut_curves(Pace& pace, std::shared_ptr<const TracedCurves> curves, uint32_t first_label, uint32_t revision) {
    pace.stage("cut");
    MeshEdit edit(pace.memory());
    Task<void> cut = cut_along_curves(pace, *curves, first_label, revision, edit);
    co_await run_or_take_back(pace, *curves->surface, edit, cut);
    while (!release(edit)) co_await pace;
}

}  // namespace flg
