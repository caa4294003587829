// SPDX-License-Identifier: MIT
#include "skeletons/contour_triangulation.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "core/random.h"

namespace flg {

namespace {

// Cells before those of round `level`, which are 2^level by 2^level.
uint32_t cells_below(uint32_t level) {
    return ((1u << (2 * level)) - 1) / 3;
}

// The place of a cell on Hilbert's curve through 2^level by 2^level cells.
uint32_t hilbert(uint32_t x, uint32_t y, uint32_t level) {
    const uint32_t size = 1u << level;
    uint32_t place = 0;
    for (uint32_t s = size / 2; s > 0; s /= 2) {
        const uint32_t right = (x & s) != 0, upper = (y & s) != 0;
        place += s * s * ((3 * right) ^ upper);
        if (upper == 0) {
            if (right != 0) {
                x = size - 1 - x;
                y = size - 1 - y;
            }
            std::swap(x, y);
        }
    }
    return place;
}

}  // namespace

ContourTriangulation::ContourTriangulation(std::span<const Point2> points, std::span<const uint32_t> next,
                                           Memory* memory)
    : next_(next),
      size_(static_cast<int32_t>(points.size())),
      points_(points.size() + 3, memory),
      triangles_(2 * points.size() + 1, memory),
      triangle_of_(points.size() + 3, memory),
      order_(points.size(), memory),
      inside_(2 * points.size() + 1, memory),
      stack_(memory),
      crossed_(memory),
      input_(points) {
    while (levels_ < 10 && (1u << (2 * levels_)) < points.size() / 2) ++levels_;
    first_of_key_ = Buffer<uint32_t>(cells_below(levels_ + 1) + 1, memory);
}

void ContourTriangulation::begin() {
    const double width = high_.x - low_.x, height = high_.y - low_.y;
    extent_ = std::max(width, height);
    const double x = (low_.x + high_.x) / 2, y = (low_.y + high_.y) / 2;
    points_[size_] = {x - 20 * extent_, y - 20 * extent_};
    points_[size_ + 1] = {x + 20 * extent_, y - 20 * extent_};
    points_[size_ + 2] = {x, y + 30 * extent_};
    triangles_[0] = {{size_, size_ + 1, size_ + 2}, {-1, -1, -1}, {}};
    count_ = 1;
    for (int32_t k = 0; k < 3; ++k) triangle_of_[size_ + k] = 0;
}

void ContourTriangulation::stop(ContourFault::Kind kind, int32_t first, int32_t second) {
    fault_ = {kind, static_cast<uint32_t>(first), static_cast<uint32_t>(second)};
    pass_ = Pass::done;
}

// A quarter of the points is in an earlier round than the last, a quarter of those in one before that.
uint32_t ContourTriangulation::order_key(uint32_t point) const {
    const auto earlier = static_cast<uint32_t>(std::countr_zero(mix64(point)) / 2);
    const uint32_t level = levels_ - std::min(levels_, earlier);
    const double cells = 1u << level, scale = cells / extent_;
    const auto cell = [&](double offset) { return static_cast<uint32_t>(std::min(offset * scale, cells - 1)); };
    return cells_below(level) + hilbert(cell(points_[point].x - low_.x), cell(points_[point].y - low_.y), level);
}

void ContourTriangulation::step() {
    const auto size = static_cast<uint32_t>(size_);
    switch (pass_) {
        case Pass::copy:
            for (const uint32_t end = std::min(size, at_ + batch); at_ < end; ++at_) {
                const Point2& p = points_[at_] = input_[at_];
                if (at_ == 0) low_ = high_ = p;
                low_ = {std::min(low_.x, p.x), std::min(low_.y, p.y)};
                high_ = {std::max(high_.x, p.x), std::max(high_.y, p.y)};
            }
            if (at_ == size) {
                begin();
                enter(Pass::zero);
            }
            break;
        case Pass::zero: {
            const auto keys = static_cast<uint32_t>(first_of_key_.size());
            for (const uint32_t end = std::min(keys, at_ + batch); at_ < end; ++at_) first_of_key_[at_] = 0;
            if (at_ == keys) enter(Pass::key);
            break;
        }
        case Pass::key:
            for (const uint32_t end = std::min(size, at_ + batch); at_ < end; ++at_)
                ++first_of_key_[order_key(at_) + 1];
            if (at_ == size) enter(Pass::sum);
            break;
        case Pass::sum: {
            const auto keys = static_cast<uint32_t>(first_of_key_.size());
            for (const uint32_t end = std::min(keys - 1, at_ + batch); at_ < end; ++at_)
                first_of_key_[at_ + 1] += first_of_key_[at_];
            if (at_ == keys - 1) enter(Pass::sort);
            break;
        }
        case Pass::sort:
            for (const uint32_t end = std::min(size, at_ + batch); at_ < end; ++at_)
                order_[first_of_key_[order_key(at_)]++] = at_;
            if (at_ == size) enter(Pass::locate);
            break;
        case Pass::locate:
            if (at_ < size) {
                locate();
            } else {
                enter(Pass::join);
            }
            break;
        case Pass::legalize:
            if (stack_.empty()) {
                pass_ = Pass::locate;
            } else {
                legalize();
            }
            break;
        case Pass::join:
            if (at_ < size) {
                join();
            } else {
                enter(Pass::mark);
            }
            break;
        case Pass::aim: aim(); break;
        case Pass::cross: cross(); break;
        case Pass::clear: clear(); break;
        case Pass::mark:
            for (const uint32_t end = std::min(count_, at_ + batch); at_ < end; ++at_) inside_[at_] = 0;
            if (at_ == count_) enter(Pass::seed);
            break;
        case Pass::seed:
            if (at_ < size) {
                seed();
            } else {
                enter(Pass::check);
            }
            break;
        case Pass::flood:
            if (stack_.empty()) {
                pass_ = Pass::seed;
            } else {
                flood();
            }
            break;
        case Pass::check:
            if (at_ < size) {
                check();
            } else {
                pass_ = Pass::done;
            }
            break;
        case Pass::done: break;
    }
}

// Of triangles (a, b, c) and (d, c, b), with a at corner k, makes (a, b, d) and (a, d, c).
void ContourTriangulation::flip(int32_t triangle, uint32_t k) {
    const Triangle here = triangles_[triangle];
    const int32_t other = here.neighbours[k];
    const uint32_t j = side_to(other, triangle);
    const Triangle there = triangles_[other];
    const int32_t a = here.vertices[k], b = here.vertices[after(k)], c = here.vertices[before(k)],
                  d = there.vertices[j];
    triangles_[triangle] = {{a, b, d},
                            {there.neighbours[after(j)], other, here.neighbours[before(k)]},
                            {there.is_edge[after(j)], false, here.is_edge[before(k)]}};
    triangles_[other] = {{a, d, c},
                         {there.neighbours[before(j)], here.neighbours[after(k)], triangle},
                         {there.is_edge[before(j)], here.is_edge[after(k)], false}};
    const int32_t beyond_d = there.neighbours[after(j)], beyond_c = here.neighbours[after(k)];
    if (beyond_d >= 0) triangles_[beyond_d].neighbours[side_to(beyond_d, other)] = triangle;
    if (beyond_c >= 0) triangles_[beyond_c].neighbours[side_to(beyond_c, triangle)] = other;
    triangle_of_[a] = triangle_of_[b] = triangle_of_[d] = triangle;
    triangle_of_[c] = other;
}

}  // namespace flg
