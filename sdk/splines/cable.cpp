// SPDX-License-Identifier: MIT
#include "splines/cable.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/failure.h"
#include "splines/cable_way.h"
#include "splines/catenary.h"
#include "splines/hanging_chain.h"
#include "splines/obstacles/obstacle_path.h"

namespace flg {

namespace {

constexpr double depth_tolerance = 1e-6;  // of the scene's size: how deep a cable may be beside its ends
constexpr double rest_share = 0.5;        // of that: so far above solids it is laid
constexpr double reach_share = 0.1;       // of the length
constexpr double even_share = 5e-2;       // of the tension: what differs by more along the chain can slide
constexpr double narrow_share = 0.5;      // of a segment: a narrower bend has a point of its own
constexpr double gain_share = 1e-3;       // of the tension times the length: energy worth sliding for
constexpr uint32_t most_pushes = 2;

// At rest with links of one length, and then with links that slide, if they would.
Task<bool> come_to_rest(Pace& pace, HangingChain& chain, const ChainScale& scale) {
    const bool is_at_rest = co_await settle_chain(pace, chain, scale);
    if (chain.is_equal || (is_at_rest && chain.unevenness() <= even_share * chain.greatest_tension()))
        co_return is_at_rest;
    const size_t count = chain.places.size();
    Buffer<Vec3> places(count, pace.memory());
    Buffer<double> slid(count, pace.memory());
    double least = HUGE_VAL;
    const auto keep = [&] {
        least = chain.energy();
        return each(pace, count, Cost::some_ns, [&](uint32_t i) {
            places[i] = chain.places[i];
            slid[i] = chain.slid[i];
        });
    };
    if (is_at_rest) co_await keep();
    chain.slides = true;
    const double gain = gain_share * chain.greatest_tension() * chain.length * chain.pieces;
    for (uint32_t push = 0; push <= most_pushes; ++push) {
        const bool settled = co_await settle_chain(pace, chain, scale);
        if (!settled || !(chain.energy() < least - gain)) break;
        co_await keep();
        const bool pushed = co_await push_from_saddle(pace, chain);
        if (!pushed) break;
    }
    if (least == HUGE_VAL) co_return false;
    co_await each(pace, count, Cost::some_ns, [&](uint32_t i) {
        chain.places[i] = places[i];
        chain.slid[i] = slid[i];
    });
    co_return true;
}

// Why a chain does not come to rest.
Task<void> refuse_restless(Pace& pace, const HangingChain& chain, const CableSpan& span) {
    const std::pmr::vector<Breach> breaches =
        co_await find_breaches(pace, chain.contacts.set, chain.places, span.slack);
    if (breaches.empty())
        throw Failure(FLG_ERROR_INVALID_ARGUMENT,
                      "the cable from point %u to point %u does not come to rest on the obstacles", span.number,
                      span.number + 1);
    const Breach worst = *std::max_element(breaches.begin(), breaches.end(),
                                           [](const Breach& a, const Breach& b) { return a.depth < b.depth; });
    const Vec3 at = chain.places[worst.piece] + worst.at * (chain.places[worst.piece + 1] - chain.places[worst.piece]);
    throw Failure(FLG_ERROR_INVALID_ARGUMENT,
                  "the cable from point %u to point %u can't keep out of obstacle %u near (%g, %g, %g): it is %g deep",
                  span.number, span.number + 1, worst.obstacle, at.x(), at.y(), at.z(), worst.depth);
}

}  // namespace

Task<HungCable> hang_cable(Pace& pace, const ObstacleSet* obstacles, Vec3 from, Vec3 to, double length,
                           uint32_t segments, Vec3 down, double size, uint32_t number) {
    HungCable out(pace.memory());
    const Catenary catenary(from, to, length, down);
    const size_t count = size_t{segments} + 1;
    out.places.resize(count);
    out.lengths.resize(count);
    const std::optional<double> bend = catenary.bend(narrow_share * length / segments);
    const double nearest = bend ? std::round(*bend / length * segments) : 0;
    co_await each(pace, count, Cost::hundreds_of_ns, [&](uint32_t i) {
        // A bend between two of them would be cut off.
        out.lengths[i] = i == nearest && i > 0 && i < segments ? *bend : length * i / segments;
        out.places[i] = catenary.place(out.lengths[i]);
    });
    out.places.front() = from;
    out.places.back() = to;
    if (!obstacles) co_return out;
    const CableSpan span{from, to, length, down, depth_tolerance * size, number};
    HangingChain chain(*obstacles, segments, length / segments, down, pace.memory());
    co_await each(pace, count, Cost::some_ns, [&](uint32_t i) {
        chain.places[i] = out.places[i];
        chain.slid[i] = 0;
    });
    const bool hangs_free = co_await is_free(pace, *obstacles, chain.places, span.slack);
    const Vec3 straight[] = {from, to};
    co_await lay_along(pace, straight, chain.places);
    const std::pmr::vector<Breach> breaches = co_await find_breaches(pace, *obstacles, chain.places, span.slack);
    if (!breaches.empty()) {
        const bool is_laid = co_await lay_over(pace, *obstacles, span, breaches, hangs_free, chain.places);
        if (!is_laid) co_return out;
    } else if (hangs_free) {
        const bool falls_free = co_await is_swept_free(pace, *obstacles, span, out.places);
        if (falls_free) co_return out;
    }
    const ChainScale scale{std::max(catenary.tension(), length), rest_share * span.slack, span.slack};
    chain.contacts.reach = std::max(reach_share * length, chain.length);
    co_await each(pace, segments, Cost::hundreds_of_ns, [&](uint32_t i) {
        chain.tension[i] = 0;
        const bool is_end = i == 0 || i + 1 == segments;
        chain.contacts.pieces.emplace_back().margin = is_end ? 0 : scale.rest;
    });
    const bool is_at_rest = co_await come_to_rest(pace, chain, scale);
    if (!is_at_rest) co_await refuse_restless(pace, chain, span);
    out.rounds = chain.rounds;
    co_await each(pace, count, Cost::some_ns, [&](uint32_t i) {
        out.places[i] = chain.places[i];
        out.lengths[i] += chain.slid[i];
    });
    Slice slice(Cost::hundreds_of_ns);
    for (; !chain.contacts.pieces.empty(); chain.contacts.pieces.pop_back())
        if (slice.is_over()) co_await pace;
    co_return out;
}

Task<void> hang_cables(Pace& pace, CableRequest request) {
    pace.stage("hang");
    std::optional<PlacedObstacles> placed;
    const ObstacleSet* set = nullptr;
    double size = 0;
    const auto points = static_cast<uint32_t>(request.points.size() / 3);
    const auto point = [&](uint32_t i) { return Vec3(&request.points[size_t{3} * i]); };
    if (request.obstacles) {
        set = &placed.emplace(request.obstacles, request.out->origin, 0, pace.memory()).set();
        co_await refuse_inside(pace, *set, {request.points.data(), request.points.size()}, 0);
        Obstacle::Box box;
        const bool has_box = set->box(box);
        Vec3 low = has_box ? Vec3(box.lower.data()) : point(0), high = has_box ? Vec3(box.upper.data()) : point(0);
        co_await each(pace, points, Cost::some_ns, [&](uint32_t i) {
            low = low.cwiseMin(point(i));
            high = high.cwiseMax(point(i));
        });
        size = (high - low).norm();
    }
    const auto cables = static_cast<uint32_t>(request.offsets.size()) - 1;
    CurveSet& out = *request.out;
    out.allocate_curves(cables);
    out.offsets()[0] = 0;
    for (uint32_t k = 0; k < cables; ++k) {
        const uint32_t spans = request.offsets[k + 1] - request.offsets[k] - 1;
        out.offsets()[k + 1] = out.offsets()[k] + spans * request.segments + 1;
        out.begin_curve(k, 0);
    }
    out.allocate_columns(std::pmr::vector<CurveSet::ColumnLayout>(
        {{FLG_ATTRIBUTE_POSITION, 3}, {FLG_ATTRIBUTE_TIME, 1}}, pace.memory()));
    float* const positions = out.find(FLG_ATTRIBUTE_POSITION)->values.data();
    float* const times = out.find(FLG_ATTRIBUTE_TIME)->values.data();
    uint32_t span = 0;
    for (uint32_t k = 0; k < cables; ++k) {
        double before = 0;
        uint32_t row = out.offsets()[k];
        for (uint32_t p = request.offsets[k]; p + 1 < request.offsets[k + 1]; ++p, ++span) {
            const HungCable hung = co_await hang_cable(pace, set, point(p), point(p + 1), request.lengths[span],
                                                       request.segments, request.down, size, p);
            co_await each(pace, size_t{request.segments} + 1, Cost::some_ns, [&](uint32_t i) {
                store_vec3(hung.places[i], positions + size_t{3} * (row + i));
                times[row + i] = static_cast<float>(before + hung.lengths[i]);
            });
            row += request.segments;
            before += request.lengths[span];
            co_await pace;
        }
        out.complete_curve(k);
    }
}

}  // namespace flg
