// SPDX-License-Identifier: MIT
#include "splines/obstacles/obstacle_grid.h"

#include <algorithm>
#include <cmath>

#include "core/failure.h"
#include "core/vec.h"

namespace flg {

namespace {

constexpr double border = 0.1;  // of the longest side, around points and obstacles
constexpr double cells_per_gap = 4;
constexpr uint32_t gap_rounds = 8;
constexpr double margin_share = 1.0 / 16;  // of the spacing
constexpr double wall_share = 2;           // of an obstacle's height: so far its wall goes beside it
constexpr double least_across = 1e-3;      // the sine of a side's angle with the way past the obstacle
constexpr uint32_t edge_steps = 64;        // of a way as long as a cell: with a margin of 1/64 it has no more

uint32_t min_cells(uint32_t dimension) {
    return dimension == 2 ? 128 : 48;
}
uint32_t max_cells(uint32_t dimension) {
    return dimension == 2 ? 512 : 96;
}

bool is_endless(const Obstacle& obstacle) {
    return !std::isfinite(obstacle.box().lower[0]);
}

// The narrowest gap so far, `least`, or that between two: from the middle of one to the boundary of the other and back,
// until the way is the gap. One that overlaps the other has none.
double gap_between(const ObstacleSet& obstacles, const Obstacle& a, const Obstacle& b, double least) {
    if (!a.bounded() && !is_endless(a)) return least;
    if (!b.bounded() && (!is_endless(b) || !a.bounded())) return least;
    if (!a.bounded()) return gap_between(obstacles, b, a, least);
    const uint32_t d = obstacles.dimension();
    Obstacle::Place x{}, gradient{};
    double apart = 0;
    for (uint32_t k = 0; k < d; ++k) {
        x[k] = 0.5 * (a.box().lower[k] + a.box().upper[k]);
        const double away = std::max({a.box().lower[k] - b.box().upper[k], b.box().lower[k] - a.box().upper[k], 0.0});
        apart += away * away;
    }
    if (std::sqrt(apart) > least + 2 * obstacles.clearance()) return least;
    double gap = 0;
    for (uint32_t round = 0; round < gap_rounds; ++round) {
        for (const Obstacle* to : {&b, &a}) {
            gap = to->evaluate(x.data(), gradient.data(), nullptr);
            if (!(gap > 0)) break;
            for (uint32_t k = 0; k < d; ++k) x[k] -= gap * gradient[k];
        }
        if (!(gap > 0)) return least;
    }
    gap -= 2 * obstacles.clearance();
    return gap > 0 ? std::min(least, gap) : least;
}

SweepGrid grid_around(const ObstacleSet& obstacles, std::span<const double> points,
                      const std::optional<Obstacle::Box>& within, double gap, double coarser) {
    const uint32_t d = obstacles.dimension();
    Obstacle::Box box;
    double longest = 0;
    bool any = obstacles.box(box);
    for (uint32_t k = 0; k < d && any && within; ++k) {
        box.lower[k] = std::clamp(box.lower[k], within->lower[k], within->upper[k]);
        box.upper[k] = std::clamp(box.upper[k], within->lower[k], within->upper[k]);
    }
    for (size_t p = 0; p < points.size() / d; ++p) {
        for (uint32_t k = 0; k < d; ++k) {
            const double x = points[p * d + k];
            box.lower[k] = any ? std::min(box.lower[k], x) : x;
            box.upper[k] = any ? std::max(box.upper[k], x) : x;
        }
        any = true;
    }
    for (uint32_t k = 0; k < d; ++k) longest = std::max(longest, box.upper[k] - box.lower[k]);
    if (!(longest > 0)) longest = 1;
    for (uint32_t k = 0; k < d; ++k) {
        box.lower[k] -= border * longest;
        box.upper[k] += border * longest;
    }
    longest *= 1 + 2 * border;
    const double h = coarser * std::max(longest / max_cells(d), std::min(longest / min_cells(d), gap / cells_per_gap));
    SweepGrid grid;
    grid.dimension = d;
    grid.spacing = h;
    grid.origin = box.lower;
    for (uint32_t k = 0; k < d; ++k) {
        // As many on both sides of the box's middle.
        const double side = box.upper[k] - box.lower[k];
        grid.counts[k] = static_cast<uint32_t>(std::ceil(side / h - 1e-6)) + 1;
        grid.origin[k] -= 0.5 * (h * (grid.counts[k] - 1) - side);
    }
    return grid;
}

}  // namespace

ObstacleGrid::ObstacleGrid(const ObstacleSet& obstacles, std::span<const ObstacleSide> sides, Memory* memory)
    : obstacles_(obstacles), sides_(sides.begin(), sides.end(), memory), across_(sides.size(), memory) {
    const uint32_t d = obstacles.dimension();
    for (size_t s = 0; s < sides_.size(); ++s) {
        ObstacleSide& side = sides_[s];
        if (side.obstacle >= obstacles.count() || !obstacles[side.obstacle].bounded()) {
            throw Failure(FLG_ERROR_INVALID_ARGUMENT, "sides[%zu] is of obstacle %u, which %s", s, side.obstacle,
                          side.obstacle >= obstacles.count() ? "there is not" : "has no other side");
        }
        double square = 0;
        for (uint32_t k = 0; k < d; ++k) square += side.direction[k] * side.direction[k];
        if (!(square > 0) || !std::isfinite(square)) {
            throw Failure(FLG_ERROR_INVALID_ARGUMENT, "sides[%zu] has a direction without length", s);
        }
        for (uint32_t k = 0; k < d; ++k) side.direction[k] /= std::sqrt(square);
    }
}

// Whether it is new.
bool ObstacleGrid::flag_node(uint32_t node) {
    if ((flags_[node] & known) != 0) return false;
    const Obstacle::Place x = grid_.place(node);
    const double d = obstacles_.distance(x.data());
    away_[node] = static_cast<float>(d);
    flags_[node] = d >= margin_ ? known : known | SweepDistance::unused;
    for (size_t s = 0; s < sides_.size(); ++s) {
        // Thinner ones are taken for bars two cells wide.
        const double wider = std::max(grid_.spacing - obstacles_[sides_[s].obstacle].core_depth(), 0.0);
        if (!in_wall(s, x.data(), wider)) continue;
        flags_[node] = known | SweepDistance::unused | extension;
        break;
    }
    return true;
}

// Edges whose ends are both farther than they are long are open. Returns what that cost, in microseconds about.
uint32_t ObstacleGrid::close_edges(uint32_t node) {
    if ((flags_[node] & has_edges) != 0) return 1;
    const std::array<uint32_t, 3> cell = grid_.cell(node);
    for (uint32_t k = 0; k < grid_.dimension; ++k)
        if (cell[k] + 1 != grid_.counts[k] && (flags_[node + grid_.stride(k)] & known) == 0) return 1;
    flags_[node] |= has_edges;
    uint32_t cost = 1;
    for (uint32_t k = 0; k < grid_.dimension; ++k) {
        if (cell[k] + 1 == grid_.counts[k]) continue;
        const uint32_t next = node + grid_.stride(k);
        if (!free(node) || !free(next)) continue;
        if (double(away_[node]) + double(away_[next]) > 1.001 * grid_.spacing) continue;
        const Obstacle::Place a = grid_.place(node), b = grid_.place(next);
        double done = 0;
        cost += 2;
        if (obstacles_.follow(a.data(), b.data(), way_margin(), edge_steps, &done) == ObstacleSet::Way::clear) continue;
        flags_[node] |= SweepDistance::closed(k);
    }
    return cost;
}

bool ObstacleGrid::in_extension(const ObstacleSide& side, const double* x, double margin) const {
    const uint32_t d = grid_.dimension;
    const Obstacle::Box& box = obstacles_[side.obstacle].box();
    const double wider = obstacles_.clearance() + margin;
    double length = wider, along = 0, middle = 0, half = 0;  // until the box is behind; of its ball's middle; squares
    for (uint32_t k = 0; k < d; ++k) {
        const double low = box.lower[k] - x[k], high = box.upper[k] - x[k], u = side.direction[k];
        length += std::max(u * low, u * high);
        along += 0.5 * (low + high) * u;
        middle += 0.25 * (low + high) * (low + high);
        half += 0.25 * (high - low) * (high - low);
    }
    const double ball = std::sqrt(half) + wider;
    if (length < 0 || middle - along * along > ball * ball) return false;
    for (double t = 0; t <= length;) {
        Obstacle::Place at{};
        for (uint32_t k = 0; k < d; ++k) at[k] = x[k] + t * side.direction[k];
        const double away = obstacles_.evaluate(side.obstacle, at.data(), nullptr, nullptr) - margin;
        if (away < 0) return true;
        t += std::max(away, 0.5 * grid_.spacing);
    }
    return false;
}

// By the straight way from point to point that is nearest to the obstacle.
void ObstacleGrid::widen(size_t side, std::span<const double> points) {
    const Obstacle& obstacle = obstacles_[sides_[side].obstacle];
    const Vec3 core(obstacle.core().data()), up(sides_[side].direction.data());
    double nearest = HUGE_VAL;
    Vec3 along = Vec3::Zero();
    for (size_t p = 0; p + 5 < points.size(); p += 3) {
        const Vec3 a(&points[p]), way = Vec3(&points[p + 3]) - a;
        const double square = way.squaredNorm(), t = square > 0 ? std::clamp(way.dot(core - a) / square, 0.0, 1.0) : 0;
        const double away = (a + t * way - core).norm();
        if (!(away < nearest)) continue;
        nearest = away;
        along = way;
    }
    const Vec3 across = up.cross(along);
    if (!(across.norm() > least_across * along.norm())) return;
    const Vec3 aside = across.normalized();
    double high = 0, wide = 0;
    for (uint32_t k = 0; k < 3; ++k) {
        const double length = obstacle.box().upper[k] - obstacle.box().lower[k];
        high += std::abs(up[k]) * length;
        wide += std::abs(aside[k]) * length;
    }
    std::copy_n(aside.data(), 3, across_[side].along.begin());
    across_[side].reach = 0.5 * wide + wall_share * high;
}

// In space beside the extension, too.
bool ObstacleGrid::in_wall(size_t side, const double* x, double margin) const {
    if (in_extension(sides_[side], x, margin)) return true;
    const Across& across = across_[side];
    const Obstacle::Place& core = obstacles_[sides_[side].obstacle].core();
    double aside = 0;
    for (uint32_t k = 0; k < grid_.dimension; ++k) aside += across.along[k] * (x[k] - core[k]);
    if (aside == 0 || std::abs(aside) > across.reach) return false;
    Obstacle::Place beside{};
    for (uint32_t k = 0; k < grid_.dimension; ++k) beside[k] = x[k] - aside * across.along[k];
    return in_extension(sides_[side], beside.data(), margin);
}

bool ObstacleGrid::on_side(const double* a, const double* b) const {
    if (sides_.empty()) return true;
    const uint32_t d = grid_.dimension;
    double square = 0;
    for (uint32_t k = 0; k < d; ++k) square += (b[k] - a[k]) * (b[k] - a[k]);
    const auto steps = static_cast<uint32_t>(std::ceil(2 * std::sqrt(square) / grid_.spacing));
    for (uint32_t s = 0; s <= steps; ++s) {
        const double t = steps == 0 ? 0 : double(s) / steps;
        Obstacle::Place x{};
        for (uint32_t k = 0; k < d; ++k) x[k] = a[k] + t * (b[k] - a[k]);
        if ((flags_[grid_.node(grid_.nearest(x.data()))] & extension) != 0) return false;
    }
    return true;
}

uint32_t ObstacleGrid::behind(const double* x) const {
    for (uint32_t s = 0; s < sides_.size(); ++s) {
        if (in_extension(sides_[s], x, 0)) return s;
    }
    return static_cast<uint32_t>(sides_.size());
}

Task<uint32_t> ObstacleGrid::look(Pace& pace, ObstacleGrid& of, SweepRange range) {
    const SweepGrid& grid = of.grid_;
    uint32_t added = 0;
    co_await each(pace, range.size(), Cost::microseconds,
                  [&, range](uint32_t i) { added += of.flag_node(grid.node(range.cell(i))) ? 1 : 0; });
    co_await each_by_work(pace, range.size(), Cost::microseconds,
                          [&, range](uint32_t i) { return of.close_edges(grid.node(range.cell(i))); });
    co_return added;
}

Task<ObstacleGrid> obstacle_grid(Pace& pace, const ObstacleSet& obstacles, std::span<const double> points,
                                 std::span<const ObstacleSide> sides, std::optional<Obstacle::Box> within,
                                 double coarser) {
    ObstacleGrid made(obstacles, sides, pace.memory());
    const uint32_t count = obstacles.count();
    double gap = std::numeric_limits<double>::infinity();
    // What an obstacle leaves free that is not bounded is about so wide.
    for (uint32_t i = 0; i < count; ++i) {
        const double wide = 2 * (obstacles[i].core_depth() - obstacles.clearance());
        if (!obstacles[i].bounded() && wide > 0) gap = std::min(gap, wide);
    }
    Slice slice(Cost::microseconds);
    for (uint32_t i = 0; i < count; ++i) {
        for (uint32_t j = i + 1; j < count; ++j) {
            gap = gap_between(obstacles, obstacles[i], obstacles[j], gap);
            if (slice.is_over()) co_await pace;
        }
    }
    made.grid_ = grid_around(obstacles, points, within, gap, coarser);
    made.margin_ = margin_share * made.grid_.spacing;
    const uint32_t nodes = made.grid_.size();
    made.away_ = Buffer<float>(nodes, pace.memory());
    made.flags_ = Buffer<uint8_t>(nodes, pace.memory());
    co_await each(pace, nodes, Cost::some_ns, [&](uint32_t node) { made.flags_[node] = SweepDistance::unused; });
    if (made.sides_.empty()) co_return made;
    for (size_t s = 0; s < made.sides_.size() && obstacles.dimension() == 3; ++s) made.widen(s, points);
    co_await ObstacleGrid::look(pace, made, made.grid_.whole());
    co_return made;
}

}  // namespace flg
