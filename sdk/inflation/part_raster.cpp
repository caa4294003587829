// SPDX-License-Identifier: MIT
#include "inflation/part_raster.h"

#include <algorithm>
#include <cmath>

namespace flg {

namespace {

constexpr uint32_t batch = 16;
constexpr double most_values = 500;  // a side
constexpr double by_spacing = 0.6;   // between values, by the spacing of the triangulation
constexpr uint32_t margin = 3;       // values around the contour's box
constexpr double reach = 1.5;        // from edges to the values that they are offered to, by the spacing
constexpr uint32_t sweeps = 4;       // forward and backward, twice
constexpr double source = 4;         // of the heights
constexpr double slack = 1e-9;       // of rows and columns: no value falls between two triangles
constexpr uint32_t no_edge = UINT32_MAX, inside_mark = UINT32_MAX - 1;

}  // namespace

PartRasterKernel::PartRasterKernel(InflatedPart& part, Memory* memory)
    : part_(part),
      raster_(part.raster),
      memory_(memory),
      slopes_(part.points.size(), memory),
      weights_(part.points.size(), memory),
      residuals_(part.points.size(), memory),
      edges_(memory) {}

bool PartRasterKernel::run(uint32_t count) {
    for (; count > 0 && pass_ != Pass::done; --count) step();
    return pass_ == Pass::done;
}

void PartRasterKernel::step() {
    const auto vertices = static_cast<uint32_t>(part_.points.size());
    const auto triangles = static_cast<uint32_t>(part_.triangles.size());
    const auto values = static_cast<uint32_t>(raster_.values.size());
    const auto then = [this](Pass pass) {
        at_ = 0;
        pass_ = pass;
    };
    switch (pass_) {
        case Pass::clear: {
            if (at_ == 0) low_ = high_ = part_.points[0];
            for (const uint32_t stop = std::min(vertices, at_ + batch); at_ < stop; ++at_) {
                const Point2& p = part_.points[at_];
                low_ = {std::min(low_.x, p.x), std::min(low_.y, p.y)};
                high_ = {std::max(high_.x, p.x), std::max(high_.y, p.y)};
                slopes_[at_] = {0, 0};
                weights_[at_] = residuals_[at_] = 0;
            }
            if (at_ == vertices) then(Pass::gather);
            break;
        }
        case Pass::gather:
            for (const uint32_t stop = std::min(triangles, at_ + batch / 4); at_ < stop; ++at_) gather(at_);
            if (at_ == triangles) then(Pass::slopes);
            break;
        case Pass::slopes:
            for (const uint32_t stop = std::min(vertices, at_ + batch); at_ < stop; ++at_) {
                Point2& slope = slopes_[at_];
                if (!part_.on_border[at_]) {
                    slope = {slope.x / weights_[at_], slope.y / weights_[at_]};
                    continue;
                }
                // So far twice the mean normal by length, outwards.
                const double length = std::hypot(slope.x, slope.y), steep = residuals_[at_] / weights_[at_];
                slope = length > 0 ? Point2{slope.x / length * steep, slope.y / length * steep} : Point2{0, 0};
                residuals_[at_] = std::max(0.0, -steep);
            }
            if (at_ == vertices) begin_values();
            break;
        case Pass::empty:
            for (const uint32_t stop = std::min(values, at_ + 2 * batch); at_ < stop; ++at_) {
                nearest_[at_] = no_edge;
                raster_.values[at_] = 0;
                distance_[at_] = HUGE_VALF;
            }
            if (at_ == values) {
                then(Pass::inside);
                begin_inside();
            }
            break;
        case Pass::inside: inside(); break;
        case Pass::edges:
            if (at_ < edges_.size()) {
                add_near_edge(at_++);
            } else {
                then(Pass::sweep);
            }
            break;
        case Pass::sweep:
            for (const uint32_t stop = std::min(values, at_ + batch / 4); at_ < stop; ++at_)
                pass_on(sweep_ % 2 == 0 ? at_ : values - 1 - at_);
            if (at_ == values) then(++sweep_ == sweeps ? Pass::finish : Pass::sweep);
            break;
        case Pass::finish:
            for (const uint32_t stop = std::min(values, at_ + batch / 4); at_ < stop; ++at_) finish(at_);
            if (at_ == values) pass_ = Pass::done;
            break;
        case Pass::done: break;
    }
}

void PartRasterKernel::gather(uint32_t triangle) {
    const TriangleVertices& t = part_.triangles[triangle];
    const Point2 p[3] = {part_.points[t[0]], part_.points[t[1]], part_.points[t[2]]};
    const double twice = (p[1].x - p[0].x) * (p[2].y - p[0].y) - (p[1].y - p[0].y) * (p[2].x - p[0].x);
    Point2 hat[3], slope = {0, 0};  // gradients, times twice the area
    for (uint32_t k = 0; k < 3; ++k) {
        const Point2 &a = p[(k + 1) % 3], &b = p[(k + 2) % 3];
        hat[k] = {a.y - b.y, b.x - a.x};
        slope.x += part_.squares[t[k]] * hat[k].x;
        slope.y += part_.squares[t[k]] * hat[k].y;
    }
    for (uint32_t k = 0; k < 3; ++k) {
        if (part_.on_border[t[k]]) {
            residuals_[t[k]] += (slope.x * hat[k].x + slope.y * hat[k].y) / (2 * twice) - source * twice / 6;
        } else {
            slopes_[t[k]].x += slope.x;
            slopes_[t[k]].y += slope.y;
            weights_[t[k]] += twice;
        }
        // A side with both ends on the border is the border's: there are no chords.
        const uint32_t a = t[(k + 1) % 3], b = t[(k + 2) % 3];
        if (!part_.on_border[a] || !part_.on_border[b]) continue;
        edges_.push_back({a, b});
        const double length = std::hypot(hat[k].x, hat[k].y);
        for (const uint32_t end : {a, b}) {
            slopes_[end].x -= hat[k].x;
            slopes_[end].y -= hat[k].y;
            weights_[end] += length / 2;
        }
    }
}

void PartRasterKernel::begin_values() {
    const double width = high_.x - low_.x, height = high_.y - low_.y;
    raster_.spacing = std::max(by_spacing * part_.spacing, std::max(width, height) / most_values);
    raster_.width = static_cast<uint32_t>(std::ceil(width / raster_.spacing)) + 1 + 2 * margin;
    raster_.height = static_cast<uint32_t>(std::ceil(height / raster_.spacing)) + 1 + 2 * margin;
    // The middle of the raster is the contour's.
    raster_.origin = {low_.x + width / 2 - raster_.spacing * (raster_.width - 1) / 2,
                      low_.y + height / 2 - raster_.spacing * (raster_.height - 1) / 2};
    const size_t values = size_t{raster_.width} * raster_.height;
    raster_.values = Buffer<double>(values, memory_);
    nearest_ = Buffer<uint32_t>(values, memory_);
    distance_ = Buffer<float>(values, memory_);
    at_ = 0;
    pass_ = Pass::empty;
}

Point2 PartRasterKernel::place_of(uint32_t place) const {
    const uint32_t column = place % raster_.width, row = place / raster_.width;
    return {raster_.origin.x + raster_.spacing * column, raster_.origin.y + raster_.spacing * row};
}

// The rows that a triangle reaches.
void PartRasterKernel::begin_inside() {
    const TriangleVertices& t = part_.triangles[at_];
    const double y[3] = {part_.points[t[0]].y, part_.points[t[1]].y, part_.points[t[2]].y};
    const double low = *std::min_element(y, y + 3), high = *std::max_element(y, y + 3);
    row_ = static_cast<uint32_t>(std::ceil((low - raster_.origin.y) / raster_.spacing - slack));
    end_row_ = static_cast<uint32_t>(std::floor((high - raster_.origin.y) / raster_.spacing + slack)) + 1;
}

// One row of a triangle.
void PartRasterKernel::inside() {
    if (row_ >= end_row_) {
        if (++at_ < part_.triangles.size()) {
            begin_inside();
        } else {
            at_ = 0;
            pass_ = Pass::edges;
        }
        return;
    }
    const TriangleVertices& t = part_.triangles[at_];
    const Point2 p[3] = {part_.points[t[0]], part_.points[t[1]], part_.points[t[2]]};
    const double twice = (p[1].x - p[0].x) * (p[2].y - p[0].y) - (p[1].y - p[0].y) * (p[2].x - p[0].x);
    const double y = raster_.origin.y + raster_.spacing * row_;
    const double low_y = std::min({p[0].y, p[1].y, p[2].y}), high_y = std::max({p[0].y, p[1].y, p[2].y});
    double low = HUGE_VAL, high = -HUGE_VAL;
    for (uint32_t k = 0; k < 3; ++k) {
        const Point2 &a = p[k], &b = p[(k + 1) % 3];
        const double row = std::clamp(y, low_y, high_y);
        if ((a.y < row) == (b.y < row) && a.y != row && b.y != row) continue;
        const double crossing = a.y == b.y ? a.x : a.x + (b.x - a.x) * (row - a.y) / (b.y - a.y);
        low = std::min({low, crossing, a.y == b.y ? b.x : crossing});
        high = std::max({high, crossing, a.y == b.y ? b.x : crossing});
    }
    double bump[3];  // of the side across from each corner
    for (uint32_t k = 0; k < 3; ++k) {
        const uint32_t a = t[(k + 1) % 3], b = t[(k + 2) % 3];
        const Point2 &pa = p[(k + 1) % 3], &pb = p[(k + 2) % 3];
        bump[k] =
            part_.on_border[a] && part_.on_border[b]
                ? 0
                : ((slopes_[a].x - slopes_[b].x) * (pb.x - pa.x) + (slopes_[a].y - slopes_[b].y) * (pb.y - pa.y)) / 2;
    }
    const auto first = static_cast<int64_t>(std::ceil((low - raster_.origin.x) / raster_.spacing - slack));
    const auto last = static_cast<int64_t>(std::floor((high - raster_.origin.x) / raster_.spacing + slack));
    for (int64_t column = first; column <= last; ++column) {
        const double x = raster_.origin.x + raster_.spacing * static_cast<double>(column);
        double share[3];
        for (uint32_t k = 0; k < 3; ++k) {
            const Point2 &a = p[(k + 1) % 3], &b = p[(k + 2) % 3];
            share[k] = std::max(0.0, ((b.x - a.x) * (y - a.y) - (b.y - a.y) * (x - a.x)) / twice);
        }
        double value = 0;
        for (uint32_t k = 0; k < 3; ++k)
            value += share[k] * part_.squares[t[k]] + share[(k + 1) % 3] * share[(k + 2) % 3] * bump[k];
        const size_t place = size_t{raster_.width} * row_ + static_cast<size_t>(column);
        raster_.values[place] = value;
        nearest_[place] = inside_mark;
    }
    ++row_;
}

double PartRasterKernel::distance_to(uint32_t edge, const Point2& p, double* share) const {
    const Point2 &a = part_.points[edges_[edge].a], &b = part_.points[edges_[edge].b];
    const double x = b.x - a.x, y = b.y - a.y;
    *share = std::clamp(((p.x - a.x) * x + (p.y - a.y) * y) / (x * x + y * y), 0.0, 1.0);
    return std::hypot(p.x - a.x - *share * x, p.y - a.y - *share * y);
}

void PartRasterKernel::offer(size_t place, uint32_t edge) {
    if (nearest_[place] == inside_mark || nearest_[place] == edge) return;
    double share;
    const auto distance = static_cast<float>(distance_to(edge, place_of(static_cast<uint32_t>(place)), &share));
    if (distance >= distance_[place]) return;
    distance_[place] = distance;
    nearest_[place] = edge;
}

void PartRasterKernel::add_near_edge(uint32_t edge) {
    const Point2 &a = part_.points[edges_[edge].a], &b = part_.points[edges_[edge].b];
    const auto place = [&](double offset, double more) {
        return static_cast<uint32_t>(std::max(0.0, offset / raster_.spacing + more));
    };
    const uint32_t left = place(std::min(a.x, b.x) - raster_.origin.x, -reach),
                   right = std::min(raster_.width - 1, place(std::max(a.x, b.x) - raster_.origin.x, reach + 1)),
                   top = std::min(raster_.height - 1, place(std::max(a.y, b.y) - raster_.origin.y, reach + 1));
    for (uint32_t y = place(std::min(a.y, b.y) - raster_.origin.y, -reach); y <= top; ++y)
        for (uint32_t x = left; x <= right; ++x) offer(size_t{raster_.width} * y + x, edge);
}

// What the neighbours that the sweep has passed know, is offered here.
void PartRasterKernel::pass_on(uint32_t place) {
    const auto x = static_cast<int>(place % raster_.width), y = static_cast<int>(place / raster_.width);
    const int sign = sweep_ % 2 == 0 ? -1 : 1;
    constexpr int steps[4][2] = {{1, 0}, {1, 1}, {0, 1}, {-1, 1}};
    for (const auto& step : steps) {
        const int u = x + sign * step[0], v = y + sign * step[1];
        if (u < 0 || v < 0 || u >= static_cast<int>(raster_.width) || v >= static_cast<int>(raster_.height)) continue;
        const uint32_t edge = nearest_[size_t{raster_.width} * static_cast<size_t>(v) + static_cast<size_t>(u)];
        if (edge < inside_mark) offer(place, edge);
    }
}

void PartRasterKernel::finish(uint32_t place) {
    if (nearest_[place] >= inside_mark) return;
    double share = 0;
    const double distance = distance_to(nearest_[place], place_of(place), &share);
    const Edge& edge = edges_[nearest_[place]];
    const double steep = residuals_[edge.a] + share * (residuals_[edge.b] - residuals_[edge.a]);
    raster_.values[place] = -distance * (steep + distance);
}

}  // namespace flg
