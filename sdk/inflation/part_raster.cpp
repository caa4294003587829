// SPDX-License-Identifier: MIT
#include "inflation/part_raster.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "runtime/each.h"

namespace flg {

namespace {

constexpr double max_values = 500;  // a side
constexpr double by_spacing = 0.6;  // between values, by the spacing of the triangulation
constexpr uint32_t margin = 3;      // values around the contour's box
constexpr double reach = 1.5;       // from edges to the values that they are offered to, by the spacing
constexpr uint32_t sweeps = 4;      // forward and backward, twice
constexpr double source = 4;        // of the heights
constexpr double slack = 1e-9;      // of rows and columns: no value falls between two triangles
constexpr uint32_t no_edge = UINT32_MAX, inside_mark = UINT32_MAX - 1;

struct Edge {
    uint32_t a, b;  // vertices
};

// What the quadratics follow from.
struct Slopes {
    Slopes(size_t vertices, Memory* memory)
        : slope(vertices, memory), weight(vertices, memory), residual(vertices, memory), edges(memory) {}

    void clear(uint32_t vertex) {
        slope[vertex] = {0, 0};
        weight[vertex] = residual[vertex] = 0;
    }

    void gather(const InflatedPart& part, uint32_t triangle) {
        const TriangleVertices& t = part.triangles[triangle];
        const Point2 p[3] = {part.points[t[0]], part.points[t[1]], part.points[t[2]]};
        const double twice = (p[1].x - p[0].x) * (p[2].y - p[0].y) - (p[1].y - p[0].y) * (p[2].x - p[0].x);
        Point2 hat[3], sum = {0, 0};  // gradients, times twice the area
        for (uint32_t k = 0; k < 3; ++k) {
            const Point2 &a = p[(k + 1) % 3], &b = p[(k + 2) % 3];
            hat[k] = {a.y - b.y, b.x - a.x};
            sum.x += part.squares[t[k]] * hat[k].x;
            sum.y += part.squares[t[k]] * hat[k].y;
        }
        for (uint32_t k = 0; k < 3; ++k) {
            if (part.on_border[t[k]]) {
                residual[t[k]] += (sum.x * hat[k].x + sum.y * hat[k].y) / (2 * twice) - source * twice / 6;
            } else {
                slope[t[k]].x += sum.x;
                slope[t[k]].y += sum.y;
                weight[t[k]] += twice;
            }
            // A side with both ends on the border is the border's: there are no chords.
            const uint32_t a = t[(k + 1) % 3], b = t[(k + 2) % 3];
            if (!part.on_border[a] || !part.on_border[b]) continue;
            edges.push_back({a, b});
            const double length = std::hypot(hat[k].x, hat[k].y);
            for (const uint32_t end : {a, b}) {
                slope[end].x -= hat[k].x;
                slope[end].y -= hat[k].y;
                weight[end] += length / 2;
            }
        }
    }

    void finish(bool on_border, uint32_t vertex) {
        Point2& own = slope[vertex];
        if (!on_border) {
            own = {own.x / weight[vertex], own.y / weight[vertex]};
            return;
        }
        // So far twice the mean normal by length, outwards.
        const double length = std::hypot(own.x, own.y), steep = residual[vertex] / weight[vertex];
        own = length > 0 ? Point2{own.x / length * steep, own.y / length * steep} : Point2{0, 0};
        residual[vertex] = std::max(0.0, -steep);
    }

    Buffer<Point2> slope;     // of g at vertices
    Buffer<double> weight;    // inside: twice the area around; on the border: half the length of the edges at it
    Buffer<double> residual;  // at border vertices; after finish() how steep it is there
    std::pmr::vector<Edge> edges;
};

// Values inside of a triangle. Returns about how many it looked at.
uint32_t draw_triangle(const InflatedPart& part, const Slopes& slopes, PartRaster& raster, uint32_t* nearest,
                       uint32_t triangle) {
    const TriangleVertices& t = part.triangles[triangle];
    const Point2 p[3] = {part.points[t[0]], part.points[t[1]], part.points[t[2]]};
    const double twice = (p[1].x - p[0].x) * (p[2].y - p[0].y) - (p[1].y - p[0].y) * (p[2].x - p[0].x);
    double bump[3];  // of the side across from each corner
    for (uint32_t k = 0; k < 3; ++k) {
        const uint32_t a = t[(k + 1) % 3], b = t[(k + 2) % 3];
        const Point2 &pa = p[(k + 1) % 3], &pb = p[(k + 2) % 3], &sa = slopes.slope[a], &sb = slopes.slope[b];
        bump[k] = part.on_border[a] && part.on_border[b]
                      ? 0
                      : ((sa.x - sb.x) * (pb.x - pa.x) + (sa.y - sb.y) * (pb.y - pa.y)) / 2;
    }
    const double low_y = std::min({p[0].y, p[1].y, p[2].y}), high_y = std::max({p[0].y, p[1].y, p[2].y});
    auto row = static_cast<uint32_t>(std::ceil((low_y - raster.origin.y) / raster.spacing - slack));
    const uint32_t end_row = static_cast<uint32_t>(std::floor((high_y - raster.origin.y) / raster.spacing + slack)) + 1;
    uint32_t looked_at = 4;
    for (; row < end_row; ++row) {
        const double y = raster.origin.y + raster.spacing * row;
        double low = HUGE_VAL, high = -HUGE_VAL;
        for (uint32_t k = 0; k < 3; ++k) {
            const Point2 &a = p[k], &b = p[(k + 1) % 3];
            const double at = std::clamp(y, low_y, high_y);
            if ((a.y < at) == (b.y < at) && a.y != at && b.y != at) continue;
            const double crossing = a.y == b.y ? a.x : a.x + (b.x - a.x) * (at - a.y) / (b.y - a.y);
            low = std::min({low, crossing, a.y == b.y ? b.x : crossing});
            high = std::max({high, crossing, a.y == b.y ? b.x : crossing});
        }
        const auto first = static_cast<int64_t>(std::ceil((low - raster.origin.x) / raster.spacing - slack));
        const auto last = static_cast<int64_t>(std::floor((high - raster.origin.x) / raster.spacing + slack));
        for (int64_t column = first; column <= last; ++column) {
            const double x = raster.origin.x + raster.spacing * static_cast<double>(column);
            double share[3];
            for (uint32_t k = 0; k < 3; ++k) {
                const Point2 &a = p[(k + 1) % 3], &b = p[(k + 2) % 3];
                share[k] = std::max(0.0, ((b.x - a.x) * (y - a.y) - (b.y - a.y) * (x - a.x)) / twice);
            }
            double value = 0;
            for (uint32_t k = 0; k < 3; ++k)
                value += share[k] * part.squares[t[k]] + share[(k + 1) % 3] * share[(k + 2) % 3] * bump[k];
            const size_t place = size_t{raster.width} * row + static_cast<size_t>(column);
            raster.values[place] = value;
            nearest[place] = inside_mark;
            ++looked_at;
        }
        looked_at += 2;
    }
    return looked_at;
}

// The nearest edge of the border, of the values outside.
class NearestEdges {
public:
    NearestEdges(const InflatedPart& part, const PartRaster& raster, std::span<const Edge> edges, Memory* memory)
        : part_(part),
          raster_(raster),
          edges_(edges),
          nearest_(raster.values.size(), memory),
          distance_(raster.values.size(), memory) {}

    uint32_t* data() { return nearest_.data(); }
    bool is_outside(uint32_t place) const { return nearest_[place] < inside_mark; }
    const Edge& edge(uint32_t place) const { return edges_[nearest_[place]]; }

    void clear(uint32_t place) {
        nearest_[place] = no_edge;
        distance_[place] = HUGE_VALF;
    }

    // To the values around it. Returns how many.
    uint32_t offer_around(uint32_t edge) {
        const Point2 &a = part_.points[edges_[edge].a], &b = part_.points[edges_[edge].b];
        const auto place = [this](double offset, double more) {
            return static_cast<uint32_t>(std::max(0.0, offset / raster_.spacing + more));
        };
        const uint32_t left = place(std::min(a.x, b.x) - raster_.origin.x, -reach),
                       right = std::min(raster_.width - 1, place(std::max(a.x, b.x) - raster_.origin.x, reach + 1)),
                       low = place(std::min(a.y, b.y) - raster_.origin.y, -reach),
                       high = std::min(raster_.height - 1, place(std::max(a.y, b.y) - raster_.origin.y, reach + 1));
        for (uint32_t y = low; y <= high; ++y)
            for (uint32_t x = left; x <= right; ++x) offer(size_t{raster_.width} * y + x, edge);
        return (right - left + 1) * (high - low + 1);
    }

    // What the neighbours that the sweep has passed know, is offered here.
    void pass_on(uint32_t place, int sign) {
        const auto x = static_cast<int>(place % raster_.width), y = static_cast<int>(place / raster_.width);
        constexpr int steps[4][2] = {{1, 0}, {1, 1}, {0, 1}, {-1, 1}};
        for (const auto& step : steps) {
            const int u = x + sign * step[0], v = y + sign * step[1];
            if (u < 0 || v < 0 || u >= static_cast<int>(raster_.width) || v >= static_cast<int>(raster_.height))
                continue;
            const uint32_t edge = nearest_[size_t{raster_.width} * static_cast<size_t>(v) + static_cast<size_t>(u)];
            if (edge < inside_mark) offer(place, edge);
        }
    }

    // From the nearest edge of a place; where along it.
    double distance(uint32_t place, double* share) const {
        return distance_to(nearest_[place], place_of(place), share);
    }

private:
    double distance_to(uint32_t edge, const Point2& p, double* share) const {
        const Point2 &a = part_.points[edges_[edge].a], &b = part_.points[edges_[edge].b];
        const double x = b.x - a.x, y = b.y - a.y;
        *share = std::clamp(((p.x - a.x) * x + (p.y - a.y) * y) / (x * x + y * y), 0.0, 1.0);
        return std::hypot(p.x - a.x - *share * x, p.y - a.y - *share * y);
    }
    Point2 place_of(uint32_t place) const {
        const uint32_t column = place % raster_.width, row = place / raster_.width;
        return {raster_.origin.x + raster_.spacing * column, raster_.origin.y + raster_.spacing * row};
    }
    void offer(size_t place, uint32_t edge) {
        if (nearest_[place] == inside_mark || nearest_[place] == edge) return;
        double share;
        const auto distance = static_cast<float>(distance_to(edge, place_of(static_cast<uint32_t>(place)), &share));
        if (distance >= distance_[place]) return;
        distance_[place] = distance;
        nearest_[place] = edge;
    }

    const InflatedPart& part_;
    const PartRaster& raster_;
    std::span<const Edge> edges_;
    Buffer<uint32_t> nearest_;  // edge, by value; or a mark that it is inside
    Buffer<float> distance_;    // to it
};

// Its middle is the middle of the contour's box.
PartRaster empty_raster(const Point2& low, const Point2& high, double spacing, Memory* memory) {
    const double width = high.x - low.x, height = high.y - low.y;
    PartRaster raster;
    raster.spacing = std::max(by_spacing * spacing, std::max(width, height) / max_values);
    raster.width = static_cast<uint32_t>(std::ceil(width / raster.spacing)) + 1 + 2 * margin;
    raster.height = static_cast<uint32_t>(std::ceil(height / raster.spacing)) + 1 + 2 * margin;
    raster.origin = {low.x + width / 2 - raster.spacing * (raster.width - 1) / 2,
                     low.y + height / 2 - raster.spacing * (raster.height - 1) / 2};
    raster.values = Buffer<double>(size_t{raster.width} * raster.height, memory);
    return raster;
}

}  // namespace

Task<void> part_raster(Pace& pace, InflatedPart& part) {
    const size_t vertices = part.points.size(), triangles = part.triangles.size();
    Slopes slopes(vertices, pace.memory());
    Point2 low = part.points[0], high = low;
    co_await each(pace, vertices, Cost::some_ns, [&](uint32_t v) {
        const Point2& p = part.points[v];
        low = {std::min(low.x, p.x), std::min(low.y, p.y)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y)};
        slopes.clear(v);
    });
    co_await each(pace, triangles, Cost::hundreds_of_ns, [&](uint32_t t) { slopes.gather(part, t); });
    co_await each(pace, vertices, Cost::tens_of_ns, [&](uint32_t v) { slopes.finish(part.on_border[v] != 0, v); });

    part.raster = empty_raster(low, high, part.spacing, pace.memory());
    PartRaster& raster = part.raster;
    const auto values = static_cast<uint32_t>(raster.values.size());
    NearestEdges nearest(part, raster, slopes.edges, pace.memory());
    co_await each(pace, values, Cost::some_ns, [&](uint32_t place) {
        raster.values[place] = 0;
        nearest.clear(place);
    });
    co_await each_by_work(pace, triangles, Cost::tens_of_ns,
                          [&](uint32_t t) { return draw_triangle(part, slopes, raster, nearest.data(), t); });

    co_await each_by_work(pace, slopes.edges.size(), Cost::tens_of_ns,
                          [&](uint32_t edge) { return nearest.offer_around(edge); });
    for (uint32_t sweep = 0; sweep < sweeps; ++sweep) {
        const bool forward = sweep % 2 == 0;
        co_await each(pace, values, Cost::hundreds_of_ns,
                      [&, forward](uint32_t i) { nearest.pass_on(forward ? i : values - 1 - i, forward ? -1 : 1); });
    }
    co_await each(pace, values, Cost::hundreds_of_ns, [&](uint32_t place) {
        if (!nearest.is_outside(place)) return;
        double share = 0;
        const double distance = nearest.distance(place, &share);
        const Edge& edge = nearest.edge(place);
        const double steep = slopes.residual[edge.a] + share * (slopes.residual[edge.b] - slopes.residual[edge.a]);
        raster.values[place] = -distance * (steep + distance);
    });
}

}  // namespace flg
