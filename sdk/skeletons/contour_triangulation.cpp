// SPDX-License-Identifier: MIT
#include "skeletons/contour_triangulation.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <vector>

#include "core/random.h"
#include "skeletons/passes.h"

namespace flg {

namespace {

constexpr uint32_t hops_at_once = 16;
constexpr size_t max_cleared = 1000;  // that the list of crossing sides still holds, if these are half of it
// Of rounding in the determinant of a circle's test, with coordinates relative to the fourth point.
constexpr double circle_noise = 4e-15;

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

using Triangle = ContourTriangulation::Triangle;

class Builder {
public:
    Builder(std::span<const Point2> points, std::span<const uint32_t> next, Memory* memory);

    void copy(uint32_t point);
    void begin();
    uint32_t key_count() const { return cells_below(levels_ + 1); }
    uint32_t order_key(uint32_t point) const;
    bool walk_to(uint32_t vertex);
    void insert(int32_t vertex);
    bool legalize();
    bool is_joined(uint32_t edge);
    bool aim(uint32_t edge);
    bool cross(uint32_t edge);
    bool clear(uint32_t edge);
    uint32_t triangle_count() const { return count_; }
    void empty(uint32_t triangle) { inside_[triangle] = 0; }
    void seed(uint32_t edge);
    bool flood();
    void check(uint32_t edge);
    bool has_fault() const { return fault_.kind != ContourFault::Kind::none; }
    ContourTriangulation take() { return {std::move(triangles_), std::move(inside_), count_, fault_}; }

private:
    struct Side {
        int32_t triangle;
        uint32_t k;  // no side: the triangle is -1
    };

    static uint32_t after(uint32_t k) { return k == 2 ? 0 : k + 1; }
    static uint32_t before(uint32_t k) { return k == 0 ? 2 : k - 1; }
    void stop(ContourFault::Kind kind, int32_t first, int32_t second);
    bool in_circle(const Point2& a, const Point2& b, const Point2& c, const Point2& d) const;
    void flip(int32_t triangle, uint32_t k);
    uint32_t corner(int32_t triangle, int32_t vertex) const { return place_in(triangles_[triangle].vertices, vertex); }
    uint32_t side_to(int32_t triangle, int32_t neighbour) const {
        return place_in(triangles_[triangle].neighbours, neighbour);
    }
    int turn(int32_t a, int32_t b, int32_t c) const { return orientation(points_[a], points_[b], points_[c]); }
    Side find(int32_t a, int32_t b) const;
    void mark(const Side& side);
    int32_t edge_between(int32_t a, int32_t b) const;

    std::span<const Point2> input_;
    std::span<const uint32_t> next_;
    int32_t size_;
    Buffer<Point2> points_;  // the contour's and three around them
    Buffer<Triangle> triangles_;
    Buffer<int32_t> triangle_of_;  // by vertex, one of its triangles
    Buffer<uint8_t> inside_;
    std::pmr::vector<int32_t> stack_;
    std::pmr::vector<std::array<int32_t, 2>> crossed_;  // sides that cross the edge that is being joined
    size_t crossed_at_ = 0, flips_left_ = 0;
    uint32_t count_ = 0;
    uint32_t levels_ = 0;  // rounds; each but the first has four times the cells of the one before
    Point2 low_{}, high_{};
    double extent_ = 0;
    int32_t here_ = 0;   // where the search for the next point, or along the edge, is
    uint32_t side_ = 0;  // the side of that triangle through which the edge leaves, and its ends
    int32_t right_ = 0, left_ = 0;
    uint32_t search_ = 0;   // steps of it
    int32_t inserted_ = 0;  // the vertex whose triangles are on the stack
    int32_t ring_edge_ = 0;
    ContourFault fault_;
};

Builder::Builder(std::span<const Point2> points, std::span<const uint32_t> next, Memory* memory)
    : input_(points),
      next_(next),
      size_(static_cast<int32_t>(points.size())),
      points_(points.size() + 3, memory),
      triangles_(2 * points.size() + 1, memory),
      triangle_of_(points.size() + 3, memory),
      inside_(2 * points.size() + 1, memory),
      stack_(memory),
      crossed_(memory) {
    while (levels_ < 10 && (1u << (2 * levels_)) < points.size() / 2) ++levels_;
}

void Builder::copy(uint32_t point) {
    const Point2& p = points_[point] = input_[point];
    if (point == 0) low_ = high_ = p;
    low_ = {std::min(low_.x, p.x), std::min(low_.y, p.y)};
    high_ = {std::max(high_.x, p.x), std::max(high_.y, p.y)};
}

// One triangle around all.
void Builder::begin() {
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

void Builder::stop(ContourFault::Kind kind, int32_t first, int32_t second) {
    fault_ = {kind, static_cast<uint32_t>(first), static_cast<uint32_t>(second)};
}

// A quarter of the points is in an earlier round than the last, a quarter of those in one before that.
uint32_t Builder::order_key(uint32_t point) const {
    const auto earlier = static_cast<uint32_t>(std::countr_zero(mix64(point)) / 2);
    const uint32_t level = levels_ - std::min(levels_, earlier);
    const double cells = 1u << level, scale = cells / extent_;
    const auto cell = [&](double offset) { return static_cast<uint32_t>(std::min(offset * scale, cells - 1)); };
    return cells_below(level) + hilbert(cell(points_[point].x - low_.x), cell(points_[point].y - low_.y), level);
}

// Some steps to the triangle that holds the point; true when it is reached. Which side is looked at first is drawn,
// so that no walk goes in circles.
bool Builder::walk_to(uint32_t vertex) {
    const Point2& point = points_[vertex];
    for (uint32_t hop = 0; hop < hops_at_once; ++hop) {
        const Triangle& here = triangles_[here_];
        const auto first = static_cast<uint32_t>(mix64(search_++) % 3);
        int32_t to = -1;
        for (uint32_t i = 0; i < 3 && to < 0; ++i) {
            const uint32_t k = (first + i) % 3;
            const int32_t a = here.vertices[after(k)], b = here.vertices[before(k)];
            if (here.neighbours[k] >= 0 && orientation(points_[a], points_[b], point) < 0) to = here.neighbours[k];
        }
        if (to < 0) {
            return true;
        }
        here_ = to;
    }
    return false;
}

// Splits the triangle in three; of a point on a side, the flat one of these is flipped away.
void Builder::insert(int32_t vertex) {
    const Triangle old = triangles_[here_];
    int32_t on = -1;
    for (uint32_t k = 0; k < 3; ++k) {
        const int32_t a = old.vertices[after(k)], b = old.vertices[before(k)];
        if (turn(a, b, vertex) != 0) continue;
        if (on >= 0) {
            const int32_t shared = old.vertices[3 - k - static_cast<uint32_t>(on)];
            stop(ContourFault::Kind::same_point, std::min(vertex, shared), std::max(vertex, shared));
            return;
        }
        on = static_cast<int32_t>(k);
    }
    const auto added = static_cast<int32_t>(count_);
    const std::array<int32_t, 3> parts = {added, added + 1, here_};  // across from corner 0, 1, 2
    count_ += 2;
    for (uint32_t k = 0; k < 3; ++k) {
        const int32_t a = old.vertices[after(k)], b = old.vertices[before(k)], beyond = old.neighbours[k];
        triangles_[parts[k]] = {{a, b, vertex}, {parts[after(k)], parts[before(k)], beyond}, {}};
        if (beyond >= 0) triangles_[beyond].neighbours[side_to(beyond, here_)] = parts[k];
        triangle_of_[a] = parts[k];
    }
    triangle_of_[vertex] = here_;
    stack_.assign(parts.begin(), parts.end());
    if (on >= 0) {
        const int32_t flat = parts[on], other = triangles_[flat].neighbours[2];
        flip(flat, 2);
        stack_.push_back(other);
    }
    inserted_ = vertex;
}

// Flips the side across from the new vertex if the circle through it and that side holds what is beyond. False if
// none is left to be looked at.
bool Builder::legalize() {
    if (stack_.empty()) return false;
    const int32_t t = stack_.back();
    stack_.pop_back();
    const uint32_t k = corner(t, inserted_);
    const int32_t other = triangles_[t].neighbours[k];
    if (other < 0) return true;
    const int32_t b = triangles_[t].vertices[after(k)], c = triangles_[t].vertices[before(k)];
    const int32_t d = triangles_[other].vertices[side_to(other, t)];
    if (!in_circle(points_[inserted_], points_[b], points_[c], points_[d])) return true;
    if (turn(inserted_, b, d) <= 0 || turn(inserted_, d, c) <= 0) return true;
    flip(t, k);
    stack_.push_back(t);
    stack_.push_back(other);
    return true;
}

bool Builder::in_circle(const Point2& a, const Point2& b, const Point2& c, const Point2& d) const {
    const double ax = a.x - d.x, ay = a.y - d.y, bx = b.x - d.x, by = b.y - d.y, cx = c.x - d.x, cy = c.y - d.y;
    const double aa = ax * ax + ay * ay, bb = bx * bx + by * by, cc = cx * cx + cy * cy;
    const double determinant = aa * (bx * cy - cx * by) + bb * (cx * ay - ax * cy) + cc * (ax * by - bx * ay);
    const double magnitude = aa * (std::fabs(bx * cy) + std::fabs(cx * by)) +
                             bb * (std::fabs(cx * ay) + std::fabs(ax * cy)) +
                             cc * (std::fabs(ax * by) + std::fabs(bx * ay));
    return determinant > circle_noise * magnitude;
}

// Of triangles (a, b, c) and (d, c, b), with a at corner k, makes (a, b, d) and (a, d, c).
void Builder::flip(int32_t triangle, uint32_t k) {
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

// The side between two vertices, of which one at least is the contour's: around both at once, so that it takes as
// long as around the one of fewer triangles.
Builder::Side Builder::find(int32_t a, int32_t b) const {
    if (a >= size_) std::swap(a, b);
    const bool both = b < size_;
    const int32_t first_a = triangle_of_[a], first_b = triangle_of_[b];
    int32_t at_a = first_a, at_b = first_b;
    for (;;) {
        const uint32_t k = corner(at_a, a);
        if (triangles_[at_a].vertices[after(k)] == b) return {at_a, before(k)};
        at_a = triangles_[at_a].neighbours[after(k)];
        if (at_a == first_a) break;
        if (!both) continue;
        const uint32_t j = corner(at_b, b);
        if (triangles_[at_b].vertices[after(j)] == a) return {at_b, before(j)};
        at_b = triangles_[at_b].neighbours[after(j)];
        if (at_b == first_b) break;
    }
    return {-1, 0};
}

int32_t Builder::edge_between(int32_t a, int32_t b) const {
    return static_cast<int32_t>(next_[a]) == b ? a : b;
}

void Builder::mark(const Side& side) {
    const int32_t other = triangles_[side.triangle].neighbours[side.k];
    triangles_[side.triangle].is_edge[side.k] = true;
    triangles_[other].is_edge[side_to(other, side.triangle)] = true;
}

// Marks the edge if it is there already.
bool Builder::is_joined(uint32_t edge) {
    const auto a = static_cast<int32_t>(edge), b = static_cast<int32_t>(next_[edge]);
    const Side side = find(a, b);
    if (side.triangle >= 0) {
        mark(side);
        return true;
    }
    crossed_.clear();
    crossed_at_ = 0;
    here_ = triangle_of_[a];
    return false;
}

// Around the edge's beginning to the triangle that it leaves through, some steps at a time; a point on the way is a
// fault.
bool Builder::aim(uint32_t edge) {
    const auto a = static_cast<int32_t>(edge), b = static_cast<int32_t>(next_[edge]);
    for (uint32_t hop = 0; hop < hops_at_once; ++hop) {
        const uint32_t k = corner(here_, a);
        right_ = triangles_[here_].vertices[after(k)];
        left_ = triangles_[here_].vertices[before(k)];
        const int side = turn(a, b, right_);
        if (side == 0) {
            const Point2 &from = points_[a], &to = points_[b], &between = points_[right_];
            if ((to.x - from.x) * (between.x - from.x) + (to.y - from.y) * (between.y - from.y) > 0) {
                stop(ContourFault::Kind::point_on_edge, right_, a);
                return true;
            }
        }
        if (side < 0 && turn(a, b, left_) > 0) {
            side_ = k;
            return true;
        }
        here_ = triangles_[here_].neighbours[after(k)];
        if (here_ == triangle_of_[a]) {
            stop(ContourFault::Kind::gave_up, a, b);
            return true;
        }
    }
    return false;
}

// Collects the sides that cross the edge, some at a time; an edge of the contour or a point in its way is a fault.
bool Builder::cross(uint32_t edge) {
    const auto a = static_cast<int32_t>(edge), b = static_cast<int32_t>(next_[edge]);
    for (uint32_t hop = 0; hop < hops_at_once; ++hop) {
        if (triangles_[here_].is_edge[side_]) {
            const int32_t crossed = edge_between(right_, left_);
            stop(ContourFault::Kind::edges_cross, std::min(a, crossed), std::max(a, crossed));
            return true;
        }
        crossed_.push_back({right_, left_});
        const int32_t beyond = triangles_[here_].neighbours[side_];
        const uint32_t j = side_to(beyond, here_);
        const int32_t tip = triangles_[beyond].vertices[j];
        if (tip == b) {
            flips_left_ = 1000 + 100 * crossed_.size() * crossed_.size();
            return true;
        }
        const int side = turn(a, b, tip);
        if (side == 0) {
            stop(ContourFault::Kind::point_on_edge, tip, a);
            return true;
        }
        // Seen from beyond, `left` comes after the tip's corner and `right` before it.
        side_ = side > 0 ? after(j) : before(j);
        (side > 0 ? left_ : right_) = tip;
        here_ = beyond;
    }
    return false;
}

// Flips one side out of the way, or puts it off if it is a corner's only one; true when the edge is
// there.
bool Builder::clear(uint32_t edge) {
    const auto a = static_cast<int32_t>(edge), b = static_cast<int32_t>(next_[edge]);
    if (crossed_at_ == crossed_.size()) {
        mark(find(a, b));
        return true;
    }
    if (--flips_left_ == 0) {
        stop(ContourFault::Kind::gave_up, a, b);
        return true;
    }
    const std::array<int32_t, 2> ends = crossed_[crossed_at_++];
    if (crossed_at_ > max_cleared && 2 * crossed_at_ > crossed_.size()) {
        crossed_.erase(crossed_.begin(), crossed_.begin() + static_cast<ptrdiff_t>(crossed_at_));
        crossed_at_ = 0;
    }
    const Side side = find(ends[0], ends[1]);
    const Triangle& here = triangles_[side.triangle];
    const int32_t other = here.neighbours[side.k], p = here.vertices[side.k];
    const int32_t q = triangles_[other].vertices[side_to(other, side.triangle)];
    if (turn(p, here.vertices[after(side.k)], q) <= 0 || turn(p, q, here.vertices[before(side.k)]) <= 0) {
        crossed_.push_back(ends);
        return false;
    }
    flip(side.triangle, side.k);
    const bool apart = p != a && p != b && q != a && q != b;
    if (apart && turn(a, b, p) * turn(a, b, q) < 0) crossed_.push_back({p, q});
    return false;
}

// Begins to flood the left of an edge, unless it is flooded.
void Builder::seed(uint32_t edge) {
    const auto a = static_cast<int32_t>(edge), b = static_cast<int32_t>(next_[edge]);
    Side side = find(a, b);
    if (triangles_[side.triangle].vertices[after(side.k)] != a)
        side.triangle = triangles_[side.triangle].neighbours[side.k];
    if (inside_[side.triangle] == 0) {
        inside_[side.triangle] = 1;
        stack_.assign(1, side.triangle);
        ring_edge_ = a;
    }
}

// False if nothing is left to be flooded, or at a fault.
bool Builder::flood() {
    if (stack_.empty()) return false;
    const Triangle& here = triangles_[stack_.back()];
    stack_.pop_back();
    for (uint32_t k = 0; k < 3; ++k) {
        if (here.vertices[k] >= size_) {
            stop(ContourFault::Kind::outside, ring_edge_, ring_edge_);
            return false;
        }
        if (here.is_edge[k] || inside_[here.neighbours[k]] != 0) continue;
        inside_[here.neighbours[k]] = 1;
        stack_.push_back(here.neighbours[k]);
    }
    return true;
}

void Builder::check(uint32_t edge) {
    const auto a = static_cast<int32_t>(edge), b = static_cast<int32_t>(next_[edge]);
    const Side side = find(a, b);
    const int32_t other = triangles_[side.triangle].neighbours[side.k];
    if (inside_[side.triangle] != 0 && inside_[other] != 0) stop(ContourFault::Kind::nested, a, a);
}

}  // namespace

Task<ContourTriangulation> triangulate_contour(Pace& pace, std::span<const Point2> points,
                                               std::span<const uint32_t> next, Memory* memory) {
    const auto size = static_cast<uint32_t>(points.size());
    Builder builder(points, next, memory);
    co_await pass(pace, size, Cost::some_ns, [&](uint32_t i) { builder.copy(i); });
    builder.begin();
    const auto key_of = [&](uint32_t i) { return builder.order_key(i); };
    const Groups order = co_await group_by(pace, size, builder.key_count(), key_of);
    Slice slice(Cost::hundreds_of_ns);
    for (const uint32_t vertex : order.items) {
        while (!builder.walk_to(vertex))
            if (slice.is_over()) co_await pace;
        builder.insert(static_cast<int32_t>(vertex));
        if (builder.has_fault()) co_return builder.take();
        do {
            if (slice.is_over()) co_await pace;
        } while (builder.legalize());
    }
    for (uint32_t edge = 0; edge < size; ++edge) {
        if (slice.is_over()) co_await pace;
        if (builder.is_joined(edge)) continue;
        while (!builder.aim(edge))
            if (slice.is_over()) co_await pace;
        while (!builder.has_fault() && !builder.cross(edge))
            if (slice.is_over()) co_await pace;
        while (!builder.has_fault() && !builder.clear(edge))
            if (slice.is_over()) co_await pace;
        if (builder.has_fault()) co_return builder.take();
    }
    co_await pass(pace, builder.triangle_count(), Cost::some_ns, [&](uint32_t i) { builder.empty(i); });
    for (uint32_t edge = 0; edge < size; ++edge) {
        builder.seed(edge);
        do {
            if (slice.is_over()) co_await pace;
        } while (builder.flood());
        if (builder.has_fault()) co_return builder.take();
    }
    for (uint32_t edge = 0; edge < size && !builder.has_fault(); ++edge) {
        builder.check(edge);
        if (slice.is_over()) co_await pace;
    }
    co_return builder.take();
}

}  // namespace flg
