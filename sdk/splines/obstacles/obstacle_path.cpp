// SPDX-License-Identifier: MIT
#include "splines/obstacles/obstacle_path.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/failure.h"
#include "splines/obstacles/clearance.h"

namespace flg {

namespace {

using Place = Obstacle::Place;
using Places = std::pmr::vector<Place>;

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double tolerance = 1e-9;  // of the size of its coordinates: so far a point may be inside
constexpr uint32_t push_rounds = 16;
constexpr uint32_t near_cells = 3;   // around a given point nodes are joined to it straight
constexpr uint32_t look_steps = 64;  // of a look, between two pauses
constexpr uint32_t tighten_rounds = 16, tries = 6;
constexpr double min_move = 1e-2;                     // of the spacing: rounds end when no vertex moves more
constexpr uint32_t hop_steps = 1024;                  // of a way to a neighbour
constexpr double first_length = 1.06, longer = 1.12;  // of ways that are looked for
constexpr double coarse_spacing = 2;                  // times that of the grid

double distance(const Obstacle::Place& a, const Obstacle::Place& b) {
    return std::sqrt((b[0] - a[0]) * (b[0] - a[0]) + (b[1] - a[1]) * (b[1] - a[1]) + (b[2] - a[2]) * (b[2] - a[2]));
}

// What paths are looked for in.
struct Scene {
    Place given(uint32_t i) const {
        Place x{};
        std::copy_n(points.data() + size_t{i % count} * d, d, x.begin());
        return x;
    }

    void check_side(uint32_t i, const ObstacleGrid& grid) const {
        const uint32_t side = grid.behind(given(i).data());
        if (side == grid.side_count()) return;
        throw Failure(FLG_ERROR_INVALID_ARGUMENT,
                      "point %u is behind obstacle %u, seen from the side that sides[%u] says the path passes",
                      i % count, grid.side(side).obstacle, side);
    }

    // A point that is nearer to an obstacle than nodes are goes straight away from it first.
    Place free_place(uint32_t i, const ObstacleGrid& grid) const {
        Place x = given(i), gradient{};
        for (uint32_t round = 0; round < push_rounds; ++round) {
            const double away = obstacles.distance(x.data(), nullptr, gradient.data());
            if (away >= grid.margin()) return x;
            for (uint32_t k = 0; k < d; ++k) x[k] += (2 * grid.margin() - away) * gradient[k];
        }
        throw Failure(FLG_ERROR_INVALID_ARGUMENT, "point %u is in a gap between obstacles that is narrower than %g",
                      i % count, 2 * grid.margin());
    }

    void check_evaluations(uint32_t leg) const {
        if (!evaluations || !evaluations->are_spent()) return;
        throw Failure(FLG_ERROR_INVALID_ARGUMENT,
                      "desc.max_evaluations, %llu, were used up before a way was found from point %u to point %u",
                      static_cast<unsigned long long>(evaluations->most()), leg, (leg + 1) % count);
    }

    const ObstacleSet& obstacles;
    std::span<const double> points;
    uint32_t d, count;
    Evaluations* evaluations;  // or null
};

Task<bool> sees(Pace& pace, const Scene& scene, const ObstacleGrid& grid, Place a, Place b) {
    if (!grid.on_side(a.data(), b.data())) co_return false;
    co_return co_await is_clear(pace, scene.obstacles, a, b, grid.way_margin());
}

// Node `number` of those around a place, 7^d. No node, the grid's size, if it is not free or not joined straight.
// `strict`: the way to it stays on the side.
uint32_t joined_node(const Scene& scene, const ObstacleGrid& all, const Place& centre, uint32_t number, bool strict) {
    constexpr uint32_t side = 2 * near_cells + 1;
    const SweepGrid& grid = all.grid();
    const uint32_t none = grid.size();
    const uint32_t offset[3] = {number % side, number / side % side,
                                scene.d == 2 ? near_cells : number / (side * side)};
    std::array<uint32_t, 3> cell = grid.nearest(centre.data());
    for (uint32_t k = 0; k < scene.d; ++k) {
        const uint32_t shifted = cell[k] + offset[k];
        if (shifted < near_cells || shifted - near_cells >= grid.counts[k]) return none;
        cell[k] = shifted - near_cells;
    }
    const uint32_t node = grid.node(cell);
    const Place at = grid.place(node);
    if (!all.free(node)) return none;
    // A point beside an extension may have a nearest node inside of it: then only the nodes next to it count.
    if (strict ? !all.on_side(centre.data(), at.data()) : distance(centre, at) > 1.5 * grid.spacing) return none;
    double done = 0;
    const auto way = scene.obstacles.follow(centre.data(), at.data(), all.way_margin(), hop_steps, &done);
    return way == ObstacleSet::Way::clear ? node : none;
}

using Seeds = std::pmr::vector<SweepDistance::Seed>;

// The nodes that are joined to a place, with their distances from it.
Task<void> join(Pace& pace, const Scene& scene, const ObstacleGrid& grid, Place centre, bool strict, Seeds& out) {
    constexpr uint32_t side = 2 * near_cells + 1;
    out.clear();
    for (uint32_t i = 0; i < (scene.d == 2 ? side * side : side * side * side); ++i) {
        const uint32_t node = joined_node(scene, grid, centre, i, strict);
        if (node != grid.grid().size()) out.push_back({node, distance(centre, grid.grid().place(node))});
        co_await pace;
    }
}

// The neighbour that the steepest way down from a node leads to. A node that is no seed has a smaller neighbour along
// an open edge.
uint32_t next_down(const Scene& scene, const ObstacleGrid& all, const SweepDistance& distances, uint32_t from) {
    const SweepGrid& grid = all.grid();
    const std::array<uint32_t, 3> cell = grid.cell(from);
    const Place here = grid.place(from);
    double steepest = 0;
    uint32_t next = from;
    for (uint32_t offset = 0; offset < (scene.d == 2 ? 9u : 27u); ++offset) {
        const uint32_t by[3] = {offset % 3, offset / 3 % 3, scene.d == 2 ? 1 : offset / 9};
        std::array<uint32_t, 3> other{};
        bool inside = true;
        uint32_t axes = 0, axis = 0;
        for (uint32_t k = 0; k < scene.d; ++k) {
            other[k] = cell[k] + by[k] - 1;
            inside = inside && other[k] < grid.counts[k];
            if (by[k] != 1) ++axes, axis = k;
        }
        if (!inside || axes == 0) continue;
        const uint32_t node = grid.node(other);
        const double slope = (distances[from] - distances[node]) / std::sqrt(double(axes));
        if (!all.free(node) || !(slope > steepest)) continue;
        if (axes == 1) {
            if ((all.flags()[std::min(node, from)] & SweepDistance::closed(axis)) != 0) continue;
        } else {
            double done = 0;
            const Place there = grid.place(node);
            if (!all.on_side(here.data(), there.data())) continue;
            const auto way = scene.obstacles.follow(here.data(), there.data(), all.way_margin(), look_steps, &done);
            if (way != ObstacleSet::Way::clear) continue;
        }
        steepest = slope;
        next = node;
    }
    if (next == from) throw Failure(FLG_ERROR_INTERNAL, "the distance on the grid has a hollow at node %u", from);
    return next;
}

// Half the extent along an axis of all ways from a to b that are no longer than `length`: an ellipsoid.
double half_extent(const Place& a, const Place& b, double length, uint32_t k) {
    const double apart = distance(a, b), across = 0.5 * std::sqrt(std::max(length * length - apart * apart, 0.0));
    const double u = apart > 0 ? (b[k] - a[k]) / apart : 0;
    return std::sqrt(0.25 * length * length * u * u + across * across * (1 - std::min(u * u, 1.0)));
}

// All nodes on ways from a to b that are no longer than `length`, and those around a and b: the box of an ellipsoid.
SweepRange around_ways(const SweepGrid& grid, const Place& a, const Place& b, double length) {
    SweepRange range;
    for (uint32_t k = 0; k < grid.dimension; ++k) {
        const double middle = 0.5 * (a[k] + b[k]), half = half_extent(a, b, length, k);
        const double low = (middle - half - grid.origin[k]) / grid.spacing - near_cells - 1,
                     high = (middle + half - grid.origin[k]) / grid.spacing + near_cells + 1, last = grid.counts[k] - 1;
        range.lower[k] = static_cast<uint32_t>(std::clamp(std::floor(low), 0.0, last));
        range.upper[k] = static_cast<uint32_t>(std::clamp(std::ceil(high), 0.0, last));
    }
    return range;
}

// Has all ways from point to point that are no longer than `longest`; none if that is infinite.
std::optional<Obstacle::Box> box_of_ways(const Scene& scene, bool closed, double longest) {
    if (longest == infinite) return std::nullopt;
    Obstacle::Box box;
    for (uint32_t k = 0; k < scene.d; ++k) {
        box.lower[k] = infinite;
        box.upper[k] = -infinite;
        for (uint32_t leg = 0; leg < (closed ? scene.count : scene.count - 1); ++leg) {
            const Place a = scene.given(leg), b = scene.given(leg + 1);
            const double middle = 0.5 * (a[k] + b[k]), half = half_extent(a, b, longest, k);
            box.lower[k] = std::min(box.lower[k], middle - half);
            box.upper[k] = std::max(box.upper[k], middle + half);
        }
    }
    return box;
}

// What a way is looked for on.
struct Field {
    Field(ObstacleGrid made, Memory* memory) : grid(std::move(made)), distances(grid.grid(), grid.flags(), memory) {}

    ObstacleGrid grid;
    SweepDistance distances;
};

// The distance from the seeds, and the node and length of the shortest way to `to`; infinite if none leads there.
Task<SweepDistance::Seed> shortest_way(Pace& pace, const Scene& scene, Field& field, SweepRange range, Place to,
                                       double longest, const Seeds& seeds) {
    const ObstacleGrid& grid = field.grid;
    const SweepDistance& distances = field.distances;
    // Nodes that are joined to the end are within some cells of it.
    const SweepGoal goal{to, longest + 2 * near_cells * grid.grid().spacing};
    const uint64_t passed = co_await SweepDistance::solve(pace, field.distances, range, seeds, goal);
    if (scene.evaluations) scene.evaluations->spend_swept(passed);
    Seeds arrivals(pace.memory());
    SweepDistance::Seed best{0, infinite};
    for (uint32_t attempt = 0; attempt < 2 && best.value == infinite; ++attempt) {
        co_await join(pace, scene, grid, to, attempt == 0, arrivals);
        for (const SweepDistance::Seed& arrival : arrivals) {
            const double through = distances[arrival.node] + arrival.value;
            if (through < best.value) best = {arrival.node, through};
        }
    }
    co_return best;
}

// From a place to another: the nodes that are joined to the first one, and the last node of the shortest way and its
// length, infinite if there is none. Ways are looked for farther and farther around, from those of `length` on, until
// none outside can be shorter.
Task<SweepDistance::Seed> find_way(Pace& pace, const Scene& scene, Field& field, uint32_t leg, Place from, Place to,
                                   double length, Seeds& seeds) {
    ObstacleGrid& grid = field.grid;
    SweepDistance::Seed found{0, infinite};
    for (bool is_last = false; found.value == infinite && !is_last;) {
        is_last = length == infinite;
        const SweepRange range = is_last ? grid.grid().whole() : around_ways(grid.grid(), from, to, length);
        const uint32_t added = co_await ObstacleGrid::look(pace, grid, range);
        if (scene.evaluations) scene.evaluations->spend_looks(2 * uint64_t{added});
        scene.check_evaluations(leg);
        co_await join(pace, scene, grid, from, true, seeds);
        if (seeds.empty()) co_await join(pace, scene, grid, from, false, seeds);
        if (seeds.empty()) break;
        found = co_await shortest_way(pace, scene, field, range, to, length, seeds);
        if (found.value > length) found.value = infinite;
        length = range.size() == grid.grid().size() ? infinite : length * longer;
        scene.check_evaluations(leg);
    }
    co_return found;
}

// From one place to another by the nodes in between: back down the distance from the first one.
Task<void> find_trail(Pace& pace, const Scene& scene, Field& coarse, Field& fine, uint32_t leg, Place from, Place to,
                      Places& trail) {
    Seeds seeds(pace.memory());
    const double apart = distance(from, to);
    const SweepDistance::Seed rough =
        co_await find_way(pace, scene, coarse, leg, from, to, first_length * apart, seeds);
    const double expected = rough.value < infinite ? rough.value : 0;
    const SweepDistance::Seed found =
        co_await find_way(pace, scene, fine, leg, from, to, std::max(expected, first_length * apart), seeds);
    const ObstacleGrid& grid = fine.grid;
    const SweepDistance& distances = fine.distances;
    if (seeds.empty()) {
        throw Failure(FLG_ERROR_INVALID_ARGUMENT, "no way leads from point %u on a grid with a spacing of %g", leg,
                      grid.grid().spacing);
    }
    if (found.value == infinite) {
        throw Failure(FLG_ERROR_INVALID_ARGUMENT,
                      "no way leads from point %u to point %u around the obstacles%s, on a grid with a spacing of %g",
                      leg, (leg + 1) % scene.count, grid.side_count() > 0 ? " on the sides they are to be passed" : "",
                      grid.grid().spacing);
    }
    uint32_t best = found.node;
    trail.assign(1, to);
    trail.push_back(grid.grid().place(best));
    const auto is_seed = [&](uint32_t node) {
        return std::any_of(seeds.begin(), seeds.end(), [&](const auto& seed) { return seed.node == node; });
    };
    while (!is_seed(best)) {
        best = next_down(scene, grid, distances, best);
        trail.push_back(grid.grid().place(best));
        co_await pace;
    }
    trail.push_back(from);
    std::reverse(trail.begin(), trail.end());
}

// From each vertex of the trail to the farthest one that it sees, by doubling and halving.
Task<void> pull(Pace& pace, const Scene& scene, const ObstacleGrid& grid, const Places& trail, Places& taut) {
    const auto last = static_cast<uint32_t>(trail.size()) - 1;
    taut.assign(1, trail[0]);
    for (uint32_t stand = 0; stand < last;) {
        // Seen are the vertices up to `seen`, as far as was looked; `unseen` (0: none yet) is not.
        uint32_t seen = stand + 1, unseen = 0, stride = 2;
        for (;;) {
            const uint32_t probe = unseen > 0 ? (seen + unseen) / 2 : std::min(stand + stride, last);
            if (probe <= seen) break;
            const bool is_seen = co_await sees(pace, scene, grid, trail[stand], trail[probe]);
            if (is_seen) {
                seen = probe;
                stride *= 2;
            } else {
                unseen = probe;
            }
        }
        taut.push_back(trail[seen]);
        stand = seen;
    }
}

// Each vertex in turn goes towards the straight way between its neighbours: all of it, and is left out, or a half, a
// quarter and so on, as far as both of them still see it.
Task<void> tighten(Pace& pace, const Scene& scene, const ObstacleGrid& grid, Places& taut) {
    for (uint32_t round = 0; round < tighten_rounds; ++round) {
        bool moved = false;
        for (uint32_t at = 1; at + 1 < taut.size();) {
            const Place a = taut[at - 1], x = taut[at], b = taut[at + 1];
            double along = 0, square = 0;
            for (uint32_t k = 0; k < scene.d; ++k) {
                along += (x[k] - a[k]) * (b[k] - a[k]);
                square += (b[k] - a[k]) * (b[k] - a[k]);
            }
            const double foot = square > 0 ? std::clamp(along / square, 0.0, 1.0) : 0;
            bool is_left_out = false;
            for (uint32_t halvings = 0; halvings < tries; ++halvings) {
                const double share = std::ldexp(1, -static_cast<int>(halvings));
                Place target = x;
                for (uint32_t k = 0; k < scene.d; ++k) target[k] += share * (a[k] + foot * (b[k] - a[k]) - x[k]);
                bool is_seen = co_await sees(pace, scene, grid, a, target);
                if (is_seen) is_seen = co_await sees(pace, scene, grid, target, b);
                if (!is_seen) continue;
                moved = moved || distance(target, x) > min_move * grid.grid().spacing;
                taut[at] = target;
                is_left_out = halvings == 0;
                break;
            }
            if (is_left_out) {
                taut.erase(taut.begin() + at);
            } else {
                ++at;
            }
        }
        if (!moved) break;
    }
}

}  // namespace

Task<void> refuse_inside(Pace& pace, const ObstacleSet& obstacles, std::span<const double> points, double slack) {
    const uint32_t d = obstacles.dimension();
    co_await each(pace, points.size() / d, Cost::microseconds, [&](uint32_t i) {
        const double* const x = &points[size_t{i} * d];
        double size = 0;
        for (uint32_t k = 0; k < d; ++k) {
            if (!std::isfinite(x[k])) throw Failure(FLG_ERROR_INVALID_ARGUMENT, "point %u is not finite", i);
            size = std::max(size, std::abs(x[k]));
        }
        uint32_t which = 0;
        const double away = obstacles.distance(x, &which) + slack;
        if (away >= -tolerance * size) return;
        throw Failure(FLG_ERROR_INVALID_ARGUMENT, "point %u is %g inside of obstacle %u, or nearer than the clearance",
                      i, -away, which);
    });
}

Task<ObstaclePath> obstacle_path(Pace& pace, const ObstacleSet& obstacles, std::span<const double> points, bool closed,
                                 std::span<const ObstacleSide> sides, double slack, Evaluations* evaluations,
                                 double longest) {
    const uint32_t d = obstacles.dimension(), count = static_cast<uint32_t>(points.size() / d);
    if (count < 2) throw Failure(FLG_ERROR_INVALID_ARGUMENT, "a path has %u points, it must have 2 at least", count);
    const Scene scene{obstacles, points, d, count, evaluations};
    co_await refuse_inside(pace, obstacles, points, slack);
    const std::optional<Obstacle::Box> within = box_of_ways(scene, closed, longest);
    ObstacleGrid made = co_await obstacle_grid(pace, obstacles, points, sides, within);
    Field fine(std::move(made), pace.memory());
    std::optional<Field> coarse;
    const ObstacleGrid& grid = fine.grid;
    ObstaclePath path(pace.memory());
    path.spacing = grid.grid().spacing;
    const auto add = [&](const Place& x) { path.points.insert(path.points.end(), x.begin(), x.begin() + d); };
    const auto add_given = [&](uint32_t i) {
        path.given.push_back(static_cast<uint32_t>(path.points.size() / d));
        add(scene.given(i));
    };
    Places trail(pace.memory()), taut(pace.memory());
    add_given(0);
    for (uint32_t leg = 0; leg < (closed ? count : count - 1); ++leg) {
        // Its ends, as far from the obstacles as nodes.
        const Place from = scene.free_place(leg, grid), to = scene.free_place(leg + 1, grid);
        scene.check_side(leg, grid);
        scene.check_side(leg + 1, grid);
        if (from != scene.given(leg)) add(from);
        const bool is_clear = co_await sees(pace, scene, grid, from, to);
        if (!is_clear) {
            if (!coarse) {
                ObstacleGrid coarser = co_await obstacle_grid(pace, obstacles, points, sides, within, coarse_spacing);
                coarse.emplace(std::move(coarser), pace.memory());
            }
            co_await find_trail(pace, scene, *coarse, fine, leg, from, to, trail);
            co_await pull(pace, scene, grid, trail, taut);
            co_await tighten(pace, scene, grid, taut);
            for (size_t i = 1; i + 1 < taut.size(); ++i) add(taut[i]);
        }
        if (to != scene.given(leg + 1)) add(to);
        add_given(leg + 1);
    }
    co_return path;
}

}  // namespace flg
