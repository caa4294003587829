// SPDX-License-Identifier: MIT
#include "splines/obstacle_path.h"

#include <algorithm>
#include <cmath>

#include "core/failure.h"

namespace flg {

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double tolerance = 1e-9;  // of the size of its coordinates: so far a point may be inside
constexpr uint32_t push_rounds = 16;
constexpr uint32_t near_cells = 3;   // around a given point nodes are joined to it straight
constexpr uint32_t look_steps = 64;  // of a look, a unit
constexpr uint32_t tighten_rounds = 16, tries = 6;
constexpr double least_move = 1e-2;   // of the spacing: rounds end when no vertex moves more
constexpr uint32_t hop_steps = 1024;  // of a way to a neighbour

double distance(const Obstacle::Place& a, const Obstacle::Place& b) {
    return std::sqrt((b[0] - a[0]) * (b[0] - a[0]) + (b[1] - a[1]) * (b[1] - a[1]) + (b[2] - a[2]) * (b[2] - a[2]));
}

}  // namespace

ObstaclePathKernel::ObstaclePathKernel(const ObstacleSet& obstacles, std::span<const double> points, bool closed,
                                       std::span<const ObstacleSide> sides, ObstaclePath& path, Memory* memory)
    : obstacles_(obstacles),
      points_(points),
      d_(obstacles.dimension()),
      count_(static_cast<uint32_t>(points.size() / d_)),
      legs_(closed ? count_ : count_ - 1),
      path_(path),
      memory_(memory),
      grid_(obstacles, points, sides, memory),
      sweep_(memory),
      seeds_(memory),
      trail_(memory),
      taut_(memory) {
    if (count_ < 2) throw Failure(FLG_ERROR_INVALID_ARGUMENT, "a path has %u points, it must have 2 at least", count_);
}

ObstaclePathKernel::Place ObstaclePathKernel::given(uint32_t i) const {
    Place x{};
    std::copy_n(points_.data() + size_t(i % count_) * d_, d_, x.begin());
    return x;
}

void ObstaclePathKernel::add(const Place& x) {
    path_.points.insert(path_.points.end(), x.begin(), x.begin() + d_);
}

bool ObstaclePathKernel::run(uint32_t count) {
    for (; count > 0 && pass_ != Pass::done; --count) {
        switch (pass_) {
            case Pass::points: check_point(); break;
            case Pass::grid:
                if (!grid_.run(1)) break;
                path_.spacing = grid_.grid().spacing;
                sweep_.emplace_back(grid_.grid(), grid_.flags(), memory_);
                at_ = 0;
                pass_ = Pass::leg;
                break;
            case Pass::leg: begin_leg(); break;
            case Pass::straight: straight(); break;
            case Pass::seeds: seed(); break;
            case Pass::sweep:
                if (!sweep_[0].run(1)) break;
                at_ = 0;
                least_ = infinite;
                strict_ = true;
                pass_ = Pass::arrive;
                break;
            case Pass::arrive: arrive(); break;
            case Pass::descend: descend(); break;
            case Pass::pull: pull(); break;
            case Pass::tighten: tighten(); break;
            case Pass::done: break;
        }
    }
    return pass_ == Pass::done;
}

void ObstaclePathKernel::check_point() {
    const Place x = given(at_);
    double size = 0;
    for (uint32_t k = 0; k < d_; ++k) {
        if (!std::isfinite(x[k])) throw Failure(FLG_ERROR_INVALID_ARGUMENT, "point %u is not finite", at_);
        size = std::max(size, std::abs(x[k]));
    }
    uint32_t which = 0;
    const double away = obstacles_.distance(x.data(), &which);
    if (away < -tolerance * size) {
        throw Failure(FLG_ERROR_INVALID_ARGUMENT, "point %u is %g inside of obstacle %u, or nearer than the clearance",
                      at_, -away, which);
    }
    if (++at_ == count_) pass_ = Pass::grid;
}

// A point that is nearer to an obstacle than nodes are goes straight away from it first.
ObstaclePathKernel::Place ObstaclePathKernel::free_place(uint32_t i) const {
    Place x = given(i), gradient{};
    for (uint32_t round = 0; round < push_rounds; ++round) {
        const double away = obstacles_.distance(x.data(), nullptr, gradient.data());
        if (away >= grid_.margin()) return x;
        for (uint32_t k = 0; k < d_; ++k) x[k] += (2 * grid_.margin() - away) * gradient[k];
    }
    throw Failure(FLG_ERROR_INVALID_ARGUMENT, "point %u is in a gap between obstacles that is narrower than %g",
                  i % count_, 2 * grid_.margin());
}

void ObstaclePathKernel::begin_leg() {
    if (leg_ == 0) {
        path_.given.push_back(0);
        add(given(0));
    }
    from_ = free_place(leg_);
    to_ = free_place(leg_ + 1);
    for (const uint32_t i : {leg_, leg_ + 1}) {
        const uint32_t side = grid_.behind(given(i).data());
        if (side != grid_.side_count()) {
            throw Failure(FLG_ERROR_INVALID_ARGUMENT,
                          "point %u is behind obstacle %u, seen from the side that sides[%u] says the path passes",
                          i % count_, grid_.side(side).obstacle, side);
        }
    }
    if (from_ != given(leg_)) add(from_);
    done_ = 0;
    pass_ = Pass::straight;
}

void ObstaclePathKernel::finish_leg() {
    if (to_ != given(leg_ + 1)) add(to_);
    path_.given.push_back(static_cast<uint32_t>(path_.points.size() / d_));
    add(given(leg_ + 1));
    pass_ = ++leg_ == legs_ ? Pass::done : Pass::leg;
}

// One unit of a look from a to b; true when it is known whether b is seen.
bool ObstaclePathKernel::look(const Place& a, const Place& b, bool* sees) {
    *sees = false;
    if (done_ == 0 && !grid_.on_side(a.data(), b.data())) return true;
    const ObstacleSet::Way way = obstacles_.follow(a.data(), b.data(), grid_.way_margin(), look_steps, &done_);
    if (way == ObstacleSet::Way::unfinished) return false;
    *sees = way == ObstacleSet::Way::clear;
    done_ = 0;
    return true;
}

void ObstaclePathKernel::straight() {
    bool sees = false;
    if (!look(from_, to_, &sees)) return;
    if (sees) return finish_leg();
    seeds_.clear();
    at_ = 0;
    strict_ = true;
    pass_ = Pass::seeds;
}

// Node at_ of those around a place: 7^d. False after the last one. *node is no node if it is not free or not joined
// straight.
bool ObstaclePathKernel::try_node(const Place& centre, uint32_t* node, Place* at) {
    constexpr uint32_t side = 2 * near_cells + 1;
    const SweepGrid& grid = grid_.grid();
    *node = grid.size();
    if (at_ >= (d_ == 2 ? side * side : side * side * side)) return false;
    const uint32_t offset[3] = {at_ % side, at_ / side % side, d_ == 2 ? near_cells : at_ / (side * side)};
    ++at_;
    std::array<uint32_t, 3> cell = grid.nearest(centre.data());
    for (uint32_t k = 0; k < d_; ++k) {
        const uint32_t shifted = cell[k] + offset[k];
        if (shifted < near_cells || shifted - near_cells >= grid.counts[k]) return true;
        cell[k] = shifted - near_cells;
    }
    const uint32_t index = grid.node(cell);
    *at = grid.place(index);
    if (!grid_.free(index)) return true;
    // A point beside an extension may have a nearest node inside of it: then only the nodes next to it count.
    if (strict_ ? !grid_.on_side(centre.data(), at->data()) : distance(centre, *at) > 1.5 * grid.spacing) return true;
    double done = 0;
    const auto way = obstacles_.follow(centre.data(), at->data(), grid_.way_margin(), hop_steps, &done);
    if (way == ObstacleSet::Way::clear) *node = index;
    return true;
}

void ObstaclePathKernel::seed() {
    uint32_t node = 0;
    Place x{};
    if (try_node(from_, &node, &x)) {
        if (node != grid_.grid().size()) seeds_.push_back({node, distance(from_, x)});
        return;
    }
    if (seeds_.empty() && strict_) {
        strict_ = false;
        at_ = 0;
        return;
    }
    if (seeds_.empty()) {
        throw Failure(FLG_ERROR_INVALID_ARGUMENT, "no way leads from point %u on a grid with a spacing of %g", leg_,
                      grid_.grid().spacing);
    }
    sweep_[0].begin(seeds_);
    pass_ = Pass::sweep;
}

void ObstaclePathKernel::arrive() {
    uint32_t node = 0;
    Place x{};
    if (try_node(to_, &node, &x)) {
        if (node == grid_.grid().size()) return;
        const double through = sweep_[0][node] + distance(to_, x);
        if (through < least_) least_ = through, best_ = node;
        return;
    }
    if (least_ == infinite && strict_) {
        strict_ = false;
        at_ = 0;
        return;
    }
    if (least_ == infinite) {
        throw Failure(FLG_ERROR_INVALID_ARGUMENT,
                      "no way leads from point %u to point %u around the obstacles%s, on a grid with a spacing of %g",
                      leg_, (leg_ + 1) % count_, grid_.side_count() > 0 ? " on the sides they are to be passed" : "",
                      grid_.grid().spacing);
    }
    trail_.assign({to_, grid_.grid().place(best_)});
    pass_ = Pass::descend;
}

// A node that is no seed has a smaller neighbour along an open edge.
void ObstaclePathKernel::descend() {
    const SweepGrid& grid = grid_.grid();
    for (const SweepDistance::Seed& s : seeds_) {
        if (s.node != best_) continue;
        trail_.push_back(from_);
        std::reverse(trail_.begin(), trail_.end());
        taut_.assign({from_});
        stand_ = 0;
        seen_ = 1;
        stride_ = 2;
        unseen_ = 0;
        done_ = 0;
        pass_ = Pass::pull;
        return;
    }
    const std::array<uint32_t, 3> cell = grid.cell(best_);
    const Place here = grid.place(best_);
    double steepest = 0;
    uint32_t next = best_;
    for (uint32_t offset = 0; offset < (d_ == 2 ? 9u : 27u); ++offset) {
        const uint32_t by[3] = {offset % 3, offset / 3 % 3, d_ == 2 ? 1 : offset / 9};
        std::array<uint32_t, 3> other{};
        bool inside = true;
        uint32_t axes = 0, axis = 0;
        for (uint32_t k = 0; k < d_; ++k) {
            other[k] = cell[k] + by[k] - 1;
            inside = inside && other[k] < grid.counts[k];
            if (by[k] != 1) ++axes, axis = k;
        }
        if (!inside || axes == 0) continue;
        const uint32_t node = grid.node(other);
        const double slope = (sweep_[0][best_] - sweep_[0][node]) / std::sqrt(double(axes));
        if (!grid_.free(node) || !(slope > steepest)) continue;
        if (axes == 1) {
            if ((grid_.flags()[std::min(node, best_)] & SweepDistance::closed(axis)) != 0) continue;
        } else {
            double done = 0;
            const Place there = grid.place(node);
            if (!grid_.on_side(here.data(), there.data())) continue;
            const auto way = obstacles_.follow(here.data(), there.data(), grid_.way_margin(), look_steps, &done);
            if (way != ObstacleSet::Way::clear) continue;
        }
        steepest = slope;
        next = node;
    }
    if (next == best_) throw Failure(FLG_ERROR_INTERNAL, "the distance on the grid has a hollow at node %u", best_);
    best_ = next;
    trail_.push_back(grid.place(best_));
}

// From stand_ the vertices up to seen_ are seen, as far as was looked; unseen_ (0: none yet) is not.
void ObstaclePathKernel::pull() {
    const auto last = static_cast<uint32_t>(trail_.size()) - 1;
    const uint32_t probe = unseen_ > 0 ? (seen_ + unseen_) / 2 : std::min(stand_ + stride_, last);
    if (probe > seen_) {
        bool sees = false;
        if (!look(trail_[stand_], trail_[probe], &sees)) return;
        if (sees) {
            seen_ = probe;
            stride_ *= 2;
        } else {
            unseen_ = probe;
        }
        return;
    }
    // The vertex is the next one of the path.
    taut_.push_back(trail_[seen_]);
    if (seen_ == last) {
        at_ = 1;
        try_ = round_ = 0;
        moved_ = second_ = false;
        pass_ = Pass::tighten;
        return;
    }
    stand_ = seen_++;
    stride_ = 2;
    unseen_ = 0;
}

// Each vertex in turn goes towards the straight way between its neighbours: all of it, and is left out, or a half, a
// quarter and so on, as far as both of them still see it.
void ObstaclePathKernel::tighten() {
    if (at_ + 1 >= taut_.size()) {
        if (moved_ && ++round_ < tighten_rounds) {
            moved_ = false;
            at_ = 1;
            return;
        }
        for (size_t i = 1; i + 1 < taut_.size(); ++i) add(taut_[i]);
        return finish_leg();
    }
    const Place &a = taut_[at_ - 1], &x = taut_[at_], &b = taut_[at_ + 1];
    double along = 0, square = 0;
    for (uint32_t k = 0; k < d_; ++k) {
        along += (x[k] - a[k]) * (b[k] - a[k]);
        square += (b[k] - a[k]) * (b[k] - a[k]);
    }
    const double foot = square > 0 ? std::clamp(along / square, 0.0, 1.0) : 0,
                 share = std::ldexp(1, -static_cast<int>(try_));
    Place target = x;
    for (uint32_t k = 0; k < d_; ++k) target[k] += share * (a[k] + foot * (b[k] - a[k]) - x[k]);
    bool sees = false;
    if (!look(second_ ? target : a, second_ ? b : target, &sees)) return;
    if (sees && !second_) {
        second_ = true;
        return;
    }
    second_ = false;
    if (!sees && ++try_ < tries) return;
    if (sees) {
        moved_ = moved_ || distance(target, x) > least_move * grid_.grid().spacing;
        taut_[at_] = target;
        if (try_ == 0) {
            taut_.erase(taut_.begin() + at_);
            return;
        }
    }
    try_ = 0;
    ++at_;
}

}  // namespace flg
