// SPDX-License-Identifier: MIT
#include "tangles/step_record.h"

#include <algorithm>

#include "runtime/each.h"
#include "surfaces/surface_inputs.h"
#include "tangles/room_work.h"

namespace flg {

namespace {

// So many triangles are looked at of each region, then every second one, and so on: whatever numbers they have.
constexpr uint32_t looks_a_region = 256;

struct Candidate {
    uint32_t seen;
    uint32_t triangle;
    float room;
};

// How far its middle is from what is not the region's, about: the radius of its inner circle, thrice that if the
// region goes on beyond all its edges.
float room_within(const Mesh& mesh, uint32_t triangle) {
    const Triple& corners = mesh.triangles[triangle];
    const Vec3 a = mesh.position(corners[0]), b = mesh.position(corners[1]), c = mesh.position(corners[2]);
    const double around = (b - a).norm() + (c - b).norm() + (a - c).norm();
    const double radius = around > 0 ? (b - a).cross(c - a).norm() / around : 0;
    for (const uint32_t across : mesh.neighbours[triangle]) {
        if (across == no_index || mesh.regions[across] != mesh.regions[triangle]) return static_cast<float>(radius);
    }
    return static_cast<float>(3 * radius);
}

Position middle_of(const Mesh& mesh, uint32_t triangle) {
    constexpr float third = 1.0f / 3;
    Position middle;
    store_vec3(position_of(mesh, {triangle, third, third}), middle.data());
    return middle;
}

Task<void> record_points(Pace& pace, const Mesh& mesh, const TangleSeeds& seeds, const char* argument,
                         SeedAnchors& anchors) {
    if (anchors.given) co_return;
    co_await check_points(pace, mesh, seeds.points, argument);
    anchors.points = co_await positions_of(pace, mesh, seeds.points);
    if (!seeds.curves) co_return;
    const std::pmr::deque<SurfacePoint>& points = seeds.curves->curves.points;
    Buffer<Position> positions(points.size(), pace.memory());
    co_await each(pace, points.size(), Cost::tens_of_ns, [&](uint32_t i) {
        // Those of a history may be any.
        if (points[i].triangle >= mesh.triangle_count())
            throw Failure(FLG_ERROR_INVALID_ARGUMENT, "curves.points[%u] is in triangle %u, but there are %u triangles",
                          i, points[i].triangle, mesh.triangle_count());
        store_vec3(position_of(mesh, points[i]), positions[i].data());
    });
    anchors.curve_points = std::move(positions);
}

template <class T>
Task<Buffer<T>> copy_buffer(Pace& pace, const Buffer<T>& from) {
    Buffer<T> copy(from.size(), pace.memory());
    co_await each(pace, copy.size(), Cost::some_ns, [to = copy.data(), &from](uint32_t i) { to[i] = from[i]; });
    co_return copy;
}

// Without anchors.
Task<TangleSeeds> copy_seeds(Pace& pace, const TangleSeeds& from) {
    TangleSeeds copy(pace.memory());
    copy.borders = from.borders;
    copy.stretches = from.stretches;
    copy.loops = from.loops;
    copy.first_loop = from.first_loop;
    copy.points = co_await copy_buffer(pace, from.points);
    copy.curves = from.curves;
    copy.sample_radius = from.sample_radius;
    copy.sample_count = from.sample_count;
    copy.samples_fit = from.samples_fit;
    copy.border_spacing = from.border_spacing;
    copy.seed = from.seed;
    copy.regions = from.regions;
    co_return copy;
}

Task<void> copy_anchors(Pace& pace, const SeedAnchors& from, SeedAnchors& to) {
    to.points = co_await copy_buffer(pace, from.points);
    to.curve_points = co_await copy_buffer(pace, from.curve_points);
    to.loops = co_await copy_buffer(pace, from.loops);
    to.samples = co_await copy_buffer(pace, from.samples);
    to.known = from.known;
    to.given = from.given;
    to.given_curves = from.given_curves;
}

template <class Request>
Request with_regions_of(const Request& from, Memory* memory) {
    Request copy(memory);
    copy.desc = from.desc;
    copy.regions = from.regions;
    return copy;
}

}  // namespace

Task<std::shared_ptr<StepRecord>> copy_record(Pace& pace, const StepRecord& record) {
    Memory* const memory = pace.memory();
    StepRecords copies(memory);
    if (const auto* const divide = std::get_if<DivideRequest>(&record.request)) {
        DivideRequest copy = with_regions_of(*divide, memory);
        copy.a = co_await copy_seeds(pace, divide->a);
        copy.b = co_await copy_seeds(pace, divide->b);
        copies = record_step(std::move(copy), memory);
        co_await copy_anchors(pace, record.a, copies[0]->a);
        co_await copy_anchors(pace, record.b, copies[0]->b);
    } else if (const auto* const displace = std::get_if<DisplaceRequest>(&record.request)) {
        copies = record_step(with_regions_of(*displace, memory), memory);
    } else if (const auto* const group = std::get_if<GroupRequest>(&record.request)) {
        copies = record_step(GroupRequest{{group->regions, memory}}, memory);
    } else if (const auto* const join = std::get_if<JoinRequest>(&record.request)) {
        copies = record_step(JoinRequest{{join->regions, memory}}, memory);
    } else {
        copies = record_step(std::get<UngroupRequest>(record.request), memory);
    }
    StepRecord& copy = *copies[0];
    if (record.macro) copy.macro.emplace(with_regions_of(*record.macro, memory));
    copy.wanted = record.wanted;
    copy.first_region = record.first_region;
    copy.places = co_await copy_buffer(pace, record.places);
    co_return std::move(copies[0]);
}

StepRecords record_step(StepRecord::Request request, Memory* memory) {
    StepRecords records(memory);
    records.push_back(
        std::allocate_shared<StepRecord>(std::pmr::polymorphic_allocator<StepRecord>(memory), std::move(request)));
    StepRecord& record = *records.back();
    if (auto* const divide = std::get_if<DivideRequest>(&record.request)) {
        divide->a.anchors = &record.a;
        divide->b.anchors = &record.b;
    }
    return records;
}

StepRecords record_step(MacroRequest macro, Memory* memory) {
    StepRecords records(memory);
    for (DivideRequest& request : expand_macro(macro, memory)) {
        records.push_back(std::move(record_step(std::move(request), memory)[0]));
    }
    records[0]->macro.emplace(std::move(macro));
    return records;
}

Task<void> record_seeds(Pace& pace, const Mesh& mesh, StepRecord& record) {
    const auto& divide = std::get<DivideRequest>(record.request);
    co_await record_points(pace, mesh, divide.a, "desc.a.points", record.a);
    co_await record_points(pace, mesh, divide.b, "desc.b.points", record.b);
}

Task<void> record_places(Pace& pace, const Mesh& mesh, uint32_t region_count, StepRecord& record) {
    const RegionId first = record.first_region;
    Buffer<Candidate> candidates(region_count - first, pace.memory());
    co_await each(pace, candidates.size(), Cost::some_ns, [&](uint32_t i) { candidates[i] = {0, no_index, -1}; });
    const auto look_at = [&](uint32_t t) {
        Candidate& candidate = candidates[mesh.regions[t] - first];
        const uint32_t seen = candidate.seen++;
        if (seen % (seen / looks_a_region + 1) != 0) return;
        const float room = room_within(mesh, t);
        if (room > candidate.room) {
            candidate.room = room;
            candidate.triangle = t;
        }
    };
    Buffer<uint32_t> labels(candidates.size(), pace.memory());
    co_await each(pace, labels.size(), Cost::some_ns, [&](uint32_t i) { labels[i] = first + i; });
    const RegionSet made(labels.data(), static_cast<uint32_t>(labels.size()), pace.memory());
    if (!candidates.empty()) co_await each_within(pace, mesh, made, Cost::tens_of_ns, look_at);
    Buffer<Position> places(candidates.size(), pace.memory());
    co_await each(pace, places.size(), Cost::tens_of_ns, [&](uint32_t i) {
        places[i] = candidates[i].triangle == no_index ? Position{} : middle_of(mesh, candidates[i].triangle);
    });
    record.places = std::move(places);
}

}  // namespace flg
