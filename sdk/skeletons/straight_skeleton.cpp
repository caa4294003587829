// SPDX-License-Identifier: MIT
#include "skeletons/straight_skeleton.h"

#include <algorithm>
#include <cmath>

#include "core/random.h"

namespace flg {

namespace {

// What one try takes of a contour that small.
constexpr uint32_t arena_points = 300;
constexpr size_t arena_bytes = 8192, arena_bytes_a_point = 1400;

// By how much of the contour's diagonal points are moved, and below what |n1 + n2| edges face each other. Measured on
// grids and pixels whose points were moved by 1e-13 to 1e-5, where the first fails for up to one in three: the second
// comes through for nine of ten of those, and each of the last ones for nearly all.
struct Try {
    double perturbation, facing;
};
constexpr Try tries[] = {{0, 1e-8},    {0, 1e-6},    {1e-9, 1e-6}, {1e-7, 1e-8}, {1e-7, 1e-6},
                         {1e-7, 1e-8}, {1e-7, 1e-6}, {1e-7, 1e-8}, {1e-7, 1e-6}, {1e-7, 1e-8}};

}  // namespace

StraightSkeletonKernel::StraightSkeletonKernel(const Contour& contour, StraightSkeleton& out, Memory* memory)
    : contour_(contour),
      out_(out),
      arena_(arena_bytes + arena_bytes_a_point * std::min(contour.size(), arena_points), memory),
      memory_(contour.size() <= arena_points ? &arena_ : memory),
      next_(contour.size(), memory_),
      scaled_(contour.size(), memory_),
      centred_(contour.size(), memory_),
      original_(contour.size(), memory_),
      low_(contour.points[0]),
      high_(contour.points[0]) {}

bool StraightSkeletonKernel::run(uint32_t count) {
    const uint32_t size = contour_.size();
    for (; count > 0 && pass_ != Pass::done; --count) {
        switch (pass_) {
            case Pass::measure: {
                const Point2& p = contour_.points[at_];
                low_ = {std::min(low_.x, p.x), std::min(low_.y, p.y)};
                high_ = {std::max(high_.x, p.x), std::max(high_.y, p.y)};
                if (++at_ == size) begin_try();
                break;
            }
            case Pass::place:
                place(at_);
                if (++at_ == size) {
                    triangulation_.emplace(std::span<const Point2>(scaled_.data(), size),
                                           std::span<const uint32_t>(next_.data(), size), memory_);
                    pass_ = Pass::triangulate;
                }
                break;
            case Pass::triangulate:
                if (!triangulation_->run(count)) return false;
                end_triangulation();
                break;
            case Pass::move:
                if (!wavefront_->run(count)) return false;
                if (wavefront_->failed()) {
                    try_again();
                    break;
                }
                begin_chaining();
                break;
            case Pass::chain:
                if (!faces_->run(count)) return false;
                if (faces_->failed()) {
                    try_again();
                    break;
                }
                begin_check();
                break;
            case Pass::check:
                if (!check_->run(count)) return false;
                if (check_->failed()) {
                    try_again();
                    break;
                }
                out_.perturbation = tries[try_].perturbation;
                at_ = 0;
                pass_ = Pass::finish;
                break;
            case Pass::finish:
                finish(at_);
                if (++at_ == out_.nodes.size()) pass_ = Pass::done;
                break;
            case Pass::done: break;
        }
    }
    return pass_ == Pass::done;
}

void StraightSkeletonKernel::begin_try() {
    exponent_ = std::ilogb(std::hypot(high_.x - low_.x, high_.y - low_.y));
    const Point2 low = {std::ldexp(low_.x, -exponent_), std::ldexp(low_.y, -exponent_)};
    const Point2 high = {std::ldexp(high_.x, -exponent_), std::ldexp(high_.y, -exponent_)};
    middle_ = {(low.x + high.x) / 2, (low.y + high.y) / 2};
    size_ = std::hypot(high.x - low.x, high.y - low.y);
    at_ = 0;
    pass_ = Pass::place;
}

void StraightSkeletonKernel::place(uint32_t point) {
    next_[point] = contour_.next(point);
    const Point2 at = {std::ldexp(contour_.points[point].x, -exponent_),
                       std::ldexp(contour_.points[point].y, -exponent_)};
    const double reach = tries[try_].perturbation * size_;
    const auto moved = [&](double value, uint32_t axis) {
        return reach == 0 ? value : value + reach * (2 * random_unit(try_, point, axis) - 1);
    };
    scaled_[point] = {moved(at.x, 0), moved(at.y, 1)};
    centred_[point] = {scaled_[point].x - middle_.x, scaled_[point].y - middle_.y};
    original_[point] = {at.x - middle_.x, at.y - middle_.y};
}

void StraightSkeletonKernel::end_triangulation() {
    if (triangulation_->fault().kind != ContourFault::Kind::none) {
        if (try_ == 0) throw describe_fault(contour_, triangulation_->fault());
        try_again();
        return;
    }
    const uint32_t size = contour_.size();
    wavefront_.emplace(*triangulation_, std::span<const Point2>(centred_.data(), size),
                       std::span<const uint32_t>(next_.data(), size), size_, tries[try_].facing, memory_);
    pass_ = Pass::move;
}

void StraightSkeletonKernel::begin_chaining() {
    const uint32_t size = contour_.size();
    triangulation_.reset();
    faces_.emplace(wavefront_->nodes(), wavefront_->arcs(), std::span<const Point2>(original_.data(), size),
                   std::span<const uint32_t>(next_.data(), size), size_, out_, memory_);
    pass_ = Pass::chain;
}

void StraightSkeletonKernel::begin_check() {
    const uint32_t size = contour_.size();
    faces_.reset();
    wavefront_.reset();
    check_.emplace(std::span<const Point2>(original_.data(), size), std::span<const uint32_t>(next_.data(), size),
                   contour_.ring_count(), size_, tries[try_].perturbation, out_, memory_);
    pass_ = Pass::check;
}

void StraightSkeletonKernel::try_again() {
    check_.reset();
    faces_.reset();
    wavefront_.reset();
    triangulation_.reset();
    if (++try_ == std::size(tries))
        throw Failure(FLG_ERROR_INTERNAL,
                      "contour: its %u points have too many changes at one time: no skeleton was found",
                      contour_.size());
    begin_try();
}

void StraightSkeletonKernel::finish(uint32_t node) {
    SkeletonNode& n = out_.nodes[node];
    const Point2 at = {n.at.x + middle_.x, n.at.y + middle_.y};
    n.at = node < contour_.size() ? contour_.points[node]
                                  : Point2{std::ldexp(at.x, exponent_), std::ldexp(at.y, exponent_)};
    n.time = std::ldexp(n.time, exponent_);
}

}  // namespace flg
