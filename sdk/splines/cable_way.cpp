// SPDX-License-Identifier: MIT
#include "splines/cable_way.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/failure.h"
#include "runtime/each.h"
#include "splines/catenary.h"
#include "splines/obstacles/obstacle_path.h"

namespace flg {

namespace {

constexpr uint32_t swept_steps = 12;  // of a fall

Task<std::optional<ObstaclePath>> path_over(Pace& pace, const ObstacleSet& set, std::span<const double> ends,
                                            std::span<const ObstacleSide> sides, double longest) {
    std::optional<ObstaclePath> path;
    try {
        path.emplace(co_await obstacle_path(pace, set, ends, false, sides, 0, nullptr, longest));
    } catch (const Failure& failure) {
        if (failure.result() != FLG_ERROR_INVALID_ARGUMENT) throw;
    }
    co_return path;
}

double line_length(const std::pmr::vector<Vec3>& line) {
    double length = 0;
    for (size_t i = 0; i + 1 < line.size(); ++i) length += (line[i + 1] - line[i]).norm();
    return length;
}

// With a node on each corner of the line, and between them evenly: as each straight part of it is free, so is all that
// lies along it. As long as there are more nodes than corners.
Task<void> lay_by_corners(Pace& pace, std::span<const Vec3> line, Buffer<Vec3>& places) {
    const auto last = static_cast<uint32_t>(places.size()) - 1, corners = static_cast<uint32_t>(line.size()) - 1;
    double length = 0, before = 0;
    for (uint32_t k = 0; k < corners; ++k) length += (line[k + 1] - line[k]).norm();
    for (uint32_t k = 0, first = 0; k < corners; ++k) {
        before += (line[k + 1] - line[k]).norm();
        const auto ideal = static_cast<uint32_t>(std::lround(before / length * last));
        const uint32_t end = k + 1 == corners ? last : std::clamp(ideal, first + 1, last - (corners - 1 - k));
        co_await each(pace, first, end + 1, Cost::some_ns, [&](uint32_t i) {
            places[i] = line[k] + static_cast<double>(i - first) / (end - first) * (line[k + 1] - line[k]);
        });
        first = end;
    }
    places[0] = line.front();
    places[last] = line.back();
}

// The obstacles that a cable from one end to the other can touch.
Task<std::pmr::vector<const Obstacle*>> within_reach(Pace& pace, const ObstacleSet& set, const CableSpan& span) {
    std::pmr::vector<const Obstacle*> near(pace.memory());
    const Vec3 middle = 0.5 * (span.from + span.to);
    co_await each(pace, set.count(), Cost::microseconds, [&](uint32_t i) {
        if (set.at_least(i, middle.data()) <= 0.5 * span.length) near.push_back(&set[i]);
    });
    co_return near;
}

}  // namespace

Task<bool> lay_over(Pace& pace, const ObstacleSet& set, const CableSpan& span, const std::pmr::vector<Breach>& breaches,
                    bool hangs_free, Buffer<Vec3>& places) {
    const std::pmr::vector<const Obstacle*> reached = co_await within_reach(pace, set, span);
    const ObstacleSet near(reached, set.clearance(), pace.memory());
    double ends[6];
    std::copy_n(span.from.data(), 3, ends);
    std::copy_n(span.to.data(), 3, ends + 3);
    std::pmr::vector<ObstacleSide> sides(pace.memory());
    const auto add_side = [&](const Breach& breach) {
        const Obstacle* const obstacle = &set[breach.obstacle];
        const auto at = static_cast<uint32_t>(std::find(reached.begin(), reached.end(), obstacle) - reached.begin());
        if (at == reached.size() || !obstacle->bounded()) return;
        for (const ObstacleSide& side : sides)
            if (side.obstacle == at) return;
        sides.push_back({at, {-span.down[0], -span.down[1], -span.down[2]}});
    };
    for (const Breach& breach : breaches) add_side(breach);
    double shortest = HUGE_VAL;
    // Over what blocks the straight way; then on any side; then, to say how long it is, a longer one.
    for (uint32_t attempt = sides.empty() ? 1 : 0; attempt < (hangs_free ? 2u : 3u); ++attempt) {
        const std::span<const ObstacleSide> own(sides.data(), attempt == 0 ? sides.size() : 0);
        const double longest = attempt < 2 ? span.length : HUGE_VAL;
        const std::optional<ObstaclePath> path = co_await path_over(pace, near, ends, own, longest);
        if (!path) continue;
        std::pmr::vector<Vec3> line(pace.memory());
        for (size_t i = 0; i + 2 < path->points.size(); i += 3) line.push_back(Vec3(&path->points[i]));
        const double length = line_length(line);
        shortest = std::min(shortest, length);
        if (length > span.length) continue;
        co_await lay_along(pace, line, places);
        if (line.size() > places.size()) co_return true;
        const bool free = co_await is_free(pace, set, places, span.slack);
        if (!free) co_await lay_by_corners(pace, line, places);
        co_return true;
    }
    if (hangs_free) co_return false;
    if (shortest == HUGE_VAL)
        throw Failure(FLG_ERROR_INVALID_ARGUMENT, "no way leads from point %u to point %u around the obstacles",
                      span.number, span.number + 1);
    throw Failure(FLG_ERROR_INVALID_ARGUMENT,
                  "the cable from point %u to point %u is %g m long, too short for the shortest way that was found "
                  "around the obstacles, %g m",
                  span.number, span.number + 1, span.length, shortest);
}

Task<void> lay_along(Pace& pace, std::span<const Vec3> line, Buffer<Vec3>& places) {
    const auto last = static_cast<uint32_t>(places.size()) - 1;
    double length = 0;
    for (size_t i = 0; i + 1 < line.size(); ++i) length += (line[i + 1] - line[i]).norm();
    size_t piece = 0;
    double before = 0;
    co_await each(pace, places.size(), Cost::tens_of_ns, [&](uint32_t i) {
        const double target = length * i / last;
        double own = (line[piece + 1] - line[piece]).norm();
        while (piece + 2 < line.size() && before + own < target) {
            before += own;
            ++piece;
            own = (line[piece + 1] - line[piece]).norm();
        }
        const double t = own > 0 ? std::clamp((target - before) / own, 0.0, 1.0) : 0;
        places[i] = line[piece] + t * (line[piece + 1] - line[piece]);
    });
    places[0] = line.front();
    places[last] = line.back();
}

Task<bool> is_swept_free(Pace& pace, const ObstacleSet& set, const CableSpan& span,
                         const std::pmr::vector<Vec3>& places) {
    const Vec3 &from = span.from, &to = span.to;
    const auto pieces = static_cast<uint32_t>(places.size()) - 1;
    const double straight = (to - from).norm();
    Buffer<Vec3> between(places.size(), pace.memory());
    for (uint32_t k = 1; k < swept_steps; ++k) {
        // Sags grow by equal steps.
        const double share = static_cast<double>(k) / swept_steps,
                     own = straight + (span.length - straight) * share * share;
        const Catenary catenary(from, to, own, span.down);
        co_await each(pace, places.size(), Cost::hundreds_of_ns,
                      [&](uint32_t i) { between[i] = catenary.place(own * i / pieces); });
        const bool free = co_await is_free(pace, set, between, span.slack);
        if (!free) co_return false;
    }
    Slice slice(Cost::tens_of_ns);
    for (uint32_t i = 1; i < pieces; ++i) {
        const Vec3 above = from + (to - from) * (static_cast<double>(i) / pieces);
        for (uint32_t k = 0; k < set.count(); ++k) {
            if (slice.is_over()) co_await pace;
            if (!may_be_below(set, k, above, places[i], 0)) continue;
            const Clearest least = co_await least_distance(pace, set, k, above, places[i]);
            if (least.away < -span.slack) co_return false;
            co_await pace;
        }
    }
    co_return true;
}

}  // namespace flg
