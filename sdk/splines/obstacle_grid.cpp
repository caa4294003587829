// SPDX-License-Identifier: MIT
#include "splines/obstacle_grid.h"

#include <algorithm>
#include <cmath>

#include "core/failure.h"

namespace flg {

namespace {

constexpr double border = 0.1;  // of the longest side, around points and obstacles
constexpr double cells_per_gap = 4;
constexpr uint32_t gap_rounds = 8;
constexpr double margin_share = 1.0 / 16;  // of the spacing
constexpr uint32_t edge_steps = 64;        // of a way as long as a cell: with a margin of 1/64 it has no more

uint32_t fewest_cells(uint32_t dimension) {
    return dimension == 2 ? 128 : 48;
}
uint32_t most_cells(uint32_t dimension) {
    return dimension == 2 ? 512 : 96;
}

}  // namespace

ObstacleGrid::ObstacleGrid(const ObstacleSet& obstacles, std::span<const double> points,
                           std::span<const ObstacleSide> sides, Memory* memory)
    : obstacles_(obstacles), sides_(sides.begin(), sides.end(), memory), memory_(memory) {
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
    bool any = obstacles.box(box_);
    for (size_t p = 0; p < points.size() / d; ++p) {
        for (uint32_t k = 0; k < d; ++k) {
            const double x = points[p * d + k];
            box_.lower[k] = any ? std::min(box_.lower[k], x) : x;
            box_.upper[k] = any ? std::max(box_.upper[k], x) : x;
        }
        any = true;
    }
    for (uint32_t k = 0; k < d; ++k) longest_ = std::max(longest_, box_.upper[k] - box_.lower[k]);
    if (!(longest_ > 0)) longest_ = 1;
    for (uint32_t k = 0; k < d; ++k) {
        box_.lower[k] -= border * longest_;
        box_.upper[k] += border * longest_;
    }
    longest_ *= 1 + 2 * border;
    // What an obstacle leaves free that is not bounded is about so wide.
    for (uint32_t i = 0; i < obstacles.count(); ++i) {
        const double wide = 2 * (obstacles[i].core_depth() - obstacles.clearance());
        if (!obstacles[i].bounded() && wide > 0) gap_ = std::min(gap_, wide);
    }
}

bool ObstacleGrid::run(uint32_t count) {
    for (; count > 0 && pass_ != Pass::done; --count) {
        if (pass_ == Pass::gaps) {
            if (at_ + 1 >= obstacles_.count())
                choose_spacing();
            else
                measure_gap();
            continue;
        }
        if (at_ == grid_.size()) {
            at_ = 0;
            pass_ = pass_ == Pass::nodes ? Pass::edges : Pass::done;
            continue;
        }
        if (pass_ == Pass::nodes)
            flag_node();
        else
            close_edge();
        ++at_;
    }
    return pass_ == Pass::done;
}

// From the middle of one to the boundary of the other and back, until the way is the gap. One that overlaps the other
// has none.
void ObstacleGrid::measure_gap() {
    const uint32_t d = obstacles_.dimension(), i = at_, j = other_;
    if (++other_ == obstacles_.count()) {
        ++at_;
        other_ = at_ + 1;
    }
    const Obstacle &a = obstacles_[i], &b = obstacles_[j];
    if (!a.bounded() || !b.bounded()) return;
    Obstacle::Place x{}, gradient{};
    double apart = 0;
    for (uint32_t k = 0; k < d; ++k) {
        x[k] = 0.5 * (a.box().lower[k] + a.box().upper[k]);
        const double away = std::max({a.box().lower[k] - b.box().upper[k], b.box().lower[k] - a.box().upper[k], 0.0});
        apart += away * away;
    }
    if (std::sqrt(apart) > gap_ + 2 * obstacles_.clearance()) return;
    double gap = 0;
    for (uint32_t round = 0; round < gap_rounds; ++round) {
        for (const Obstacle* to : {&b, &a}) {
            gap = to->evaluate(x.data(), gradient.data(), nullptr);
            if (!(gap > 0)) break;
            for (uint32_t k = 0; k < d; ++k) x[k] -= gap * gradient[k];
        }
        if (!(gap > 0)) return;
    }
    gap -= 2 * obstacles_.clearance();
    if (gap > 0) gap_ = std::min(gap_, gap);
}

void ObstacleGrid::choose_spacing() {
    const uint32_t d = obstacles_.dimension();
    const double h = std::max(longest_ / most_cells(d), std::min(longest_ / fewest_cells(d), gap_ / cells_per_gap));
    grid_.dimension = d;
    grid_.spacing = h;
    grid_.origin = box_.lower;
    for (uint32_t k = 0; k < d; ++k) {
        // As many on both sides of the box's middle.
        const double side = box_.upper[k] - box_.lower[k];
        grid_.counts[k] = static_cast<uint32_t>(std::ceil(side / h - 1e-6)) + 1;
        grid_.origin[k] -= 0.5 * (h * (grid_.counts[k] - 1) - side);
    }
    margin_ = margin_share * h;
    away_ = Buffer<float>(grid_.size(), memory_);
    flags_ = Buffer<uint8_t>(grid_.size(), memory_);
    at_ = 0;
    pass_ = Pass::nodes;
}

void ObstacleGrid::flag_node() {
    const Obstacle::Place x = grid_.place(at_);
    const double d = obstacles_.distance(x.data());
    away_[at_] = static_cast<float>(d);
    flags_[at_] = d >= margin_ ? 0 : SweepDistance::unused;
    for (const ObstacleSide& side : sides_) {
        // Thinner ones are taken for bars two cells wide.
        const double wider = std::max(grid_.spacing - obstacles_[side.obstacle].core_depth(), 0.0);
        if (!in_extension(side, x.data(), wider)) continue;
        flags_[at_] = SweepDistance::unused | extension;
        return;
    }
}

// If both ends are farther than the edge is long, it is open.
void ObstacleGrid::close_edge() {
    const std::array<uint32_t, 3> cell = grid_.cell(at_);
    for (uint32_t k = 0; k < grid_.dimension; ++k) {
        if (cell[k] + 1 == grid_.counts[k]) continue;
        const uint32_t next = at_ + grid_.stride(k);
        if (!free(at_) || !free(next)) continue;
        if (double(away_[at_]) + double(away_[next]) > 1.001 * grid_.spacing) continue;
        const Obstacle::Place a = grid_.place(at_), b = grid_.place(next);
        double done = 0;
        if (obstacles_.follow(a.data(), b.data(), way_margin(), edge_steps, &done) == ObstacleSet::Way::clear) continue;
        flags_[at_] |= SweepDistance::closed(k);
    }
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

}  // namespace flg
