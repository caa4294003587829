// SPDX-License-Identifier: MIT
#include "inflation/part_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "core/memory.h"
#include "runtime/each.h"
#include "skeletons/contour_triangulation.h"
#include "skeletons/point2.h"

namespace flg {

namespace {

// ---- A triangulation of what is inside of a contour, that takes more points: in its triangles, on its edges, on its
// border. After each point flips make it Delaunay again (Lawson: Software for C1 surface interpolation, 1977).
//
// Invariants
// - All triangles turn counter-clockwise, by exact signs; what would turn one is refused.
// - Sides without a neighbour are the border; flips never touch it.
// - Flips make no chord: no side inside gets both ends on the border that had not. It is Delaunay but for that.

class PlaneMesh {
public:
    struct Triangle {
        std::array<int32_t, 3> vertices, neighbours;  // neighbours[k] is across from vertices[k]; -1: none
    };
    struct Place {
        int32_t triangle;
        int32_t side;  // -1: inside; else the point is on this side, or beyond this side of the border
        bool beyond;
    };

    // Room for so many of each.
    PlaneMesh(size_t vertices, size_t triangles, Memory* memory);

    uint32_t vertex_count() const { return vertex_count_; }
    uint32_t triangle_count() const { return triangle_count_; }
    size_t vertex_capacity() const { return points_.size(); }
    const Point2& point(int32_t vertex) const { return points_[vertex]; }
    bool on_border(int32_t vertex) const { return border_[vertex] != 0; }
    const Triangle& triangle(int32_t index) const { return triangles_[index]; }
    int32_t triangle_of(int32_t vertex) const { return triangle_of_[vertex]; }

    // While it is filled.
    void add_vertex(const Point2& point, bool border);
    void add_triangle(const Triangle& triangle);
    // Has a triangle looked at by legalize().
    void check(int32_t triangle) { stack_.push_back(triangle); }

    // Walks at most `steps` triangles towards a point; a place without triangle (-1) if that was not enough.
    Place locate(int32_t from, const Point2& point, uint32_t steps) const;
    // Adds a point at a place that locate found, or a border point within rounding of side `side`. False, and nothing
    // changed, if a triangle would not turn counter-clockwise. Needs room for one vertex and two triangles.
    bool insert(int32_t triangle, int32_t side, const Point2& point);
    // Looks at one triangle that changed; true if none was left. Those that flips change are called for.
    template <class Changed>
    bool legalize(const Changed& changed) {
        if (stack_.empty()) return true;
        const int32_t t = stack_.back();
        stack_.pop_back();
        changed(t);
        for (uint32_t k = 0; k < 3; ++k) {
            if (!flips(t, k)) continue;
            const int32_t other = triangles_[t].neighbours[k];
            flip(t, k);
            stack_.push_back(t);
            stack_.push_back(other);
            break;
        }
        return stack_.empty();
    }
    bool is_chord(int32_t triangle, uint32_t side) const;

private:
    static uint32_t after(uint32_t k) { return k == 2 ? 0 : k + 1; }
    static uint32_t before(uint32_t k) { return k == 0 ? 2 : k - 1; }
    bool flips(int32_t triangle, uint32_t k) const;
    void flip(int32_t triangle, uint32_t k);
    void replace_neighbour(int32_t of, int32_t old, int32_t now);
    int turn(int32_t a, int32_t b, int32_t c) const { return orientation(points_[a], points_[b], points_[c]); }

    Buffer<Point2> points_;
    Buffer<uint8_t> border_;
    Buffer<int32_t> triangle_of_;
    Buffer<Triangle> triangles_;
    std::pmr::vector<int32_t> stack_;
    uint32_t vertex_count_ = 0, triangle_count_ = 0;
};

// Of rounding in the determinant below, relative to what is added up in it.
constexpr double circle_noise = 1e-14;

bool in_circle(const Point2& a, const Point2& b, const Point2& c, const Point2& d) {
    const double ax = a.x - d.x, ay = a.y - d.y, bx = b.x - d.x, by = b.y - d.y, cx = c.x - d.x, cy = c.y - d.y;
    const double aa = ax * ax + ay * ay, bb = bx * bx + by * by, cc = cx * cx + cy * cy;
    const double determinant = aa * (bx * cy - cx * by) + bb * (cx * ay - ax * cy) + cc * (ax * by - bx * ay);
    const double magnitude = aa * (std::fabs(bx * cy) + std::fabs(cx * by)) +
                             bb * (std::fabs(cx * ay) + std::fabs(ax * cy)) +
                             cc * (std::fabs(ax * by) + std::fabs(bx * ay));
    return determinant > circle_noise * magnitude;
}

PlaneMesh::PlaneMesh(size_t vertices, size_t triangles, Memory* memory)
    : points_(vertices, memory),
      border_(vertices, memory),
      triangle_of_(vertices, memory),
      triangles_(triangles, memory),
      stack_(memory) {}

void PlaneMesh::add_vertex(const Point2& point, bool border) {
    points_[vertex_count_] = point;
    border_[vertex_count_] = border;
    triangle_of_[vertex_count_] = -1;
    ++vertex_count_;
}

void PlaneMesh::add_triangle(const Triangle& triangle) {
    for (const int32_t vertex : triangle.vertices) triangle_of_[vertex] = static_cast<int32_t>(triangle_count_);
    triangles_[triangle_count_++] = triangle;
}

bool PlaneMesh::is_chord(int32_t triangle, uint32_t side) const {
    const Triangle& t = triangles_[triangle];
    return t.neighbours[side] >= 0 && on_border(t.vertices[after(side)]) && on_border(t.vertices[before(side)]);
}

PlaneMesh::Place PlaneMesh::locate(int32_t from, const Point2& point, uint32_t steps) const {
    int32_t here = from, came_from = -1;
    for (; steps > 0; --steps) {
        const Triangle& t = triangles_[here];
        int32_t on = -1, to = -1;
        for (uint32_t i = 0; i < 3 && to < 0; ++i) {
            // Turns with the steps, so that no walk goes in circles.
            const uint32_t k = (i + steps) % 3;
            if (t.neighbours[k] >= 0 && t.neighbours[k] == came_from) continue;
            const int side = orientation(points_[t.vertices[after(k)]], points_[t.vertices[before(k)]], point);
            if (side == 0) on = static_cast<int32_t>(k);
            if (side >= 0) continue;
            if (t.neighbours[k] < 0) return {here, static_cast<int32_t>(k), true};
            to = t.neighbours[k];
        }
        if (to < 0) return {here, on, false};
        came_from = here;
        here = to;
    }
    return {-1, -1, false};
}

void PlaneMesh::replace_neighbour(int32_t of, int32_t old, int32_t now) {
    if (of >= 0) triangles_[of].neighbours[place_in(triangles_[of].neighbours, old)] = now;
}

bool PlaneMesh::insert(int32_t triangle, int32_t side, const Point2& point) {
    const auto vertex = static_cast<int32_t>(vertex_count_), added = static_cast<int32_t>(triangle_count_);
    const Triangle old = triangles_[triangle];
    const auto turns_left = [&](int32_t a, int32_t b) { return orientation(points_[a], points_[b], point) > 0; };
    if (side < 0) {
        for (uint32_t k = 0; k < 3; ++k)
            if (!turns_left(old.vertices[after(k)], old.vertices[before(k)])) return false;
        add_vertex(point, false);
        const std::array<int32_t, 3> parts = {triangle, added, added + 1};
        triangle_count_ += 2;
        for (uint32_t k = 0; k < 3; ++k) {
            const int32_t a = old.vertices[after(k)], b = old.vertices[before(k)], beyond = old.neighbours[k];
            triangles_[parts[k]] = {{vertex, a, b}, {beyond, parts[after(k)], parts[before(k)]}};
            if (parts[k] != triangle) replace_neighbour(beyond, triangle, parts[k]);
            triangle_of_[a] = parts[k];
            check(parts[k]);
        }
        triangle_of_[vertex] = triangle;
        return true;
    }
    // Of triangle (a, b, c) with the point on (b, c), (a, b, p) stays and (a, p, c) is added; so beyond.
    const auto k = static_cast<uint32_t>(side);
    const int32_t a = old.vertices[k], b = old.vertices[after(k)], c = old.vertices[before(k)];
    const int32_t other = old.neighbours[k];
    if (!turns_left(a, b) || !turns_left(c, a)) return false;
    Triangle there{};
    int32_t d = -1;
    uint32_t j = 0;
    if (other >= 0) {
        there = triangles_[other];
        j = place_in(there.neighbours, triangle);
        d = there.vertices[j];
        if (!turns_left(d, c) || !turns_left(b, d)) return false;
    }
    add_vertex(point, other < 0);
    const int32_t beyond_b = old.neighbours[before(k)], beyond_c = old.neighbours[after(k)];
    triangle_count_ += other >= 0 ? 2 : 1;
    triangles_[triangle] = {{a, b, vertex}, {other >= 0 ? added + 1 : -1, added, beyond_b}};
    triangles_[added] = {{a, vertex, c}, {other, beyond_c, triangle}};
    replace_neighbour(beyond_c, triangle, added);
    triangle_of_[vertex] = triangle_of_[a] = triangle_of_[b] = triangle;
    triangle_of_[c] = added;
    check(triangle);
    check(added);
    if (other >= 0) {
        // (d, c, b): the part at c stays, next to `added`.
        const int32_t beyond_db = there.neighbours[after(j)], beyond_dc = there.neighbours[before(j)];
        triangles_[other] = {{d, c, vertex}, {added, added + 1, beyond_dc}};
        triangles_[added + 1] = {{d, vertex, b}, {triangle, beyond_db, other}};
        replace_neighbour(beyond_db, other, added + 1);
        triangle_of_[d] = other;
        check(other);
        check(added + 1);
    }
    return true;
}

bool PlaneMesh::flips(int32_t triangle, uint32_t k) const {
    const Triangle& here = triangles_[triangle];
    const int32_t other = here.neighbours[k];
    if (other < 0) return false;
    const Triangle& there = triangles_[other];
    const int32_t a = here.vertices[k], b = here.vertices[after(k)], c = here.vertices[before(k)];
    const int32_t d = there.vertices[place_in(there.neighbours, triangle)];
    if (border_[a] != 0 && border_[d] != 0) return false;
    return in_circle(points_[a], points_[b], points_[c], points_[d]) && turn(a, b, d) > 0 && turn(a, d, c) > 0;
}

// Of triangles (a, b, c) and (d, c, b), with a at corner k, makes (a, b, d) and (a, d, c).
void PlaneMesh::flip(int32_t triangle, uint32_t k) {
    const Triangle here = triangles_[triangle];
    const int32_t other = here.neighbours[k];
    const Triangle there = triangles_[other];
    const uint32_t j = place_in(there.neighbours, triangle);
    const int32_t a = here.vertices[k], b = here.vertices[after(k)], c = here.vertices[before(k)],
                  d = there.vertices[j];
    const int32_t beyond_ab = here.neighbours[before(k)], beyond_ca = here.neighbours[after(k)];
    const int32_t beyond_bd = there.neighbours[after(j)], beyond_dc = there.neighbours[before(j)];
    triangles_[triangle] = {{a, b, d}, {beyond_bd, other, beyond_ab}};
    triangles_[other] = {{a, d, c}, {beyond_dc, beyond_ca, triangle}};
    replace_neighbour(beyond_bd, other, triangle);
    replace_neighbour(beyond_ca, triangle, other);
    triangle_of_[a] = triangle_of_[b] = triangle_of_[d] = triangle;
    triangle_of_[c] = other;
}

// Of the vertices that a part should have if it is round, and of the most that it gets for being narrow.
constexpr double usual_vertices = 500, max_for_width = 3000;
constexpr double vertices_by_area = 0.866;  // area of a lattice's cell, by its spacing squared
constexpr double max_lattice_places = 1e6, max_border_points = 2e4;
// By the spacing: how far points may be off the way between those around them to be dropped; edges that are divided;
// what the lattice keeps from points of the border.
constexpr double off_line = 0.02, max_edge = 1.3, clearance = 0.75;
constexpr uint32_t max_chain = 64, max_walk = 200;
// By the spacing: edges that triangles are not improved below, and the largest circle through a triangle.
constexpr double min_edge = 1.0 / 8, max_circle = 1.0;
constexpr double circle_by_edge = 1.18;  // of a triangle with an angle of 25 degrees

double squared(const Point2& a, const Point2& b) {
    return (b.x - a.x) * (b.x - a.x) + (b.y - a.y) * (b.y - a.y);
}

Point2 between(const Point2& a, const Point2& b, double share) {
    return {a.x + share * (b.x - a.x), a.y + share * (b.y - a.y)};
}

Point2 middle_of(const Point2& a, const Point2& b) {
    return {a.x + (b.x - a.x) / 2, a.y + (b.y - a.y) / 2};
}

// From the line through a and b.
double off(const Point2& a, const Point2& b, const Point2& p) {
    const double length = distance(a, b);
    if (length == 0) return distance(a, p);
    return std::fabs((b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x)) / length;
}

Point2 circumcentre(const Point2& a, const Point2& b, const Point2& c) {
    const double bx = b.x - a.x, by = b.y - a.y, cx = c.x - a.x, cy = c.y - a.y;
    const double bb = bx * bx + by * by, cc = cx * cx + cy * cy, twice = 2 * (bx * cy - by * cx);
    return {a.x + (cy * bb - by * cc) / twice, a.y + (bx * cc - cx * bb) / twice};
}

// The contour's box, and a scale that takes it to [-1, 1] without rounding.
struct Frame {
    Point2 scaled(const Point2& p) const {
        return {std::ldexp(p.x - middle.x, -exponent), std::ldexp(p.y - middle.y, -exponent)};
    }
    Point2 unscaled(const Point2& p) const {
        return {std::ldexp(p.x, exponent) + middle.x, std::ldexp(p.y, exponent) + middle.y};
    }

    Point2 low, high, middle{};
    int exponent = 0;
    double spacing = 0;  // as scaled
};

// Also finds the part's area and spacing.
Task<Frame> measure(Pace& pace, double wanted_spacing, InflatedPart& part) {
    const Contour& contour = part.contour;
    Frame frame{.low = contour.points[0], .high = contour.points[0]};
    double perimeter = 0, twice_area = 0;
    co_await each(pace, contour.size(), Cost::tens_of_ns, [&](uint32_t i) {
        const Point2 &p = contour.points[i], &q = contour.points[contour.next(i)], &o = contour.points[0];
        frame.low = {std::min(frame.low.x, p.x), std::min(frame.low.y, p.y)};
        frame.high = {std::max(frame.high.x, p.x), std::max(frame.high.y, p.y)};
        perimeter += distance(p, q);
        twice_area += (p.x - o.x) * (q.y - o.y) - (p.y - o.y) * (q.x - o.x);
    });
    const double width = frame.high.x - frame.low.x, height = frame.high.y - frame.low.y;
    frame.middle = {frame.low.x + width / 2, frame.low.y + height / 2};
    frame.exponent = std::ilogb(std::max(width, height));
    part.area = std::max(twice_area / 2, 1e-12 * width * height);
    double spacing = wanted_spacing;
    if (!(spacing > 0))
        spacing =
            std::max(std::min(std::sqrt(part.area / (vertices_by_area * usual_vertices)), part.area / (4 * perimeter)),
                     std::sqrt(part.area / (vertices_by_area * max_for_width)));
    part.spacing = std::max(
        {spacing, std::sqrt(width * height / (vertices_by_area * max_lattice_places)), perimeter / max_border_points});
    frame.spacing = std::ldexp(part.spacing, -frame.exponent);
    co_return frame;
}

// Rings as they are triangulated.
struct Border {
    explicit Border(Memory* memory) : points(memory), next(memory), owner(memory) {}
    uint32_t size() const { return static_cast<uint32_t>(points.size()); }

    void add_edge(const Contour& contour, const Frame& frame, uint32_t from, uint32_t to) {
        const Point2 a = frame.scaled(contour.points[from]), b = frame.scaled(contour.points[to]);
        const double length = distance(a, b);
        const auto pieces =
            length > max_edge * frame.spacing ? static_cast<uint32_t>(std::ceil(length / frame.spacing - 0.3)) : 1u;
        for (uint32_t i = 0; i < pieces; ++i) {
            points.push_back(i == 0 ? a : between(a, b, static_cast<double>(i) / pieces));
            next.push_back(static_cast<uint32_t>(points.size()));
            owner.push_back(from);
        }
    }

    std::pmr::vector<Point2> points;
    std::pmr::vector<uint32_t> next;
    std::pmr::vector<uint32_t> owner;  // the contour's point before or at it
};

// Drops points that are nearly on the way between others, if `thin`, and divides long edges.
Task<Border> even_border(Pace& pace, const Contour& contour, const Frame& frame, bool thin) {
    Border border(pace.memory());
    std::pmr::vector<uint32_t> kept(pace.memory());
    for (uint32_t ring = 0; ring < contour.ring_count(); ++ring) {
        const uint32_t begin = contour.offsets[ring], end = contour.offsets[ring + 1];
        kept.assign(1, begin);
        // Keeps a point, or drops it: if all points dropped since the last one kept are nearly on the way to the next.
        co_await each(pace, begin + 1, end, Cost::hundreds_of_ns, [&](uint32_t at) {
            const uint32_t last = kept.back();
            const Point2 from = frame.scaled(contour.points[last]), to = frame.scaled(contour.points[contour.next(at)]);
            bool keep = !thin || at - last >= max_chain || distance(from, to) > frame.spacing;
            for (uint32_t i = last + 1; i <= at && !keep; ++i)
                keep = off(from, to, frame.scaled(contour.points[i])) > off_line * frame.spacing;
            if (keep) kept.push_back(at);
        });
        if (kept.size() < 3) {
            kept.clear();
            for (uint32_t i = begin; i < end; ++i) kept.push_back(i);
        }
        const uint32_t first = border.size();
        co_await each(pace, kept.size(), Cost::hundreds_of_ns, [&](uint32_t i) {
            border.add_edge(contour, frame, kept[i], kept[i + 1 == kept.size() ? 0 : i + 1]);
        });
        border.next.back() = first;
    }
    co_return border;
}

// Places for points inside.
struct Lattice {
    Lattice(const Frame& frame, Memory* memory) : origin(frame.scaled(frame.low)), spacing(frame.spacing) {
        const Point2 high = frame.scaled(frame.high);
        width = static_cast<uint32_t>((high.x - origin.x) / spacing) + 2;
        height = static_cast<uint32_t>((high.y - origin.y) / (spacing * vertices_by_area)) + 2;
        places = Buffer<uint8_t>(size_t{width} * height, memory);
    }
    Point2 point(uint32_t row, uint32_t column) const {
        return {origin.x + spacing * (column + (row % 2 == 0 ? 0.25 : 0.75)),
                origin.y + spacing * vertices_by_area * (row + 0.5)};
    }
    // What is too near to a point of the border, and where the edge from it crosses the rows.
    void mark(const Point2& a, const Point2& b) {
        const double reach = clearance * spacing, row_height = spacing * vertices_by_area;
        const auto row_at = [&](double y) { return static_cast<int>(std::ceil((y - origin.y) / row_height - 0.5)); };
        const auto column_at = [&](double x, int row) {
            return static_cast<int>(std::ceil((x - origin.x) / spacing - (row % 2 == 0 ? 0.25 : 0.75)));
        };
        const int columns = static_cast<int>(width), rows = static_cast<int>(height);
        for (int row = std::max(0, row_at(a.y - reach)); row < std::min(rows, row_at(a.y + reach) + 1); ++row) {
            for (int column = std::max(0, column_at(a.x - reach, row));
                 column < std::min(columns, column_at(a.x + reach, row) + 1); ++column) {
                if (distance(a, point(row, column)) < reach) places[size_t{width} * row + column] |= 2;
            }
        }
        // Rows with a.y < y <= b.y, or the other way around: each crossing counts for one edge.
        for (int row = std::max(0, row_at(std::min(a.y, b.y)) - 1);
             row <= std::min(rows - 1, row_at(std::max(a.y, b.y)) + 1); ++row) {
            const double y = point(row, 0).y;
            if ((a.y < y) == (b.y < y)) continue;
            const double x = a.x + (b.x - a.x) * (y - a.y) / (b.y - a.y);
            const int column = std::max(0, column_at(x, row));
            if (column < columns) places[size_t{width} * row + column] ^= 1;
        }
    }

    Point2 origin;
    double spacing;
    uint32_t width = 0, height = 0;
    Buffer<uint8_t> places;  // bit 0: the border is crossed before it; bit 1: too near to the border
};

// The places of the lattice that are inside and not too near to the border, row by row.
Task<Buffer<uint32_t>> places_inside(Pace& pace, Lattice& lattice, const Border& border) {
    Buffer<uint8_t>& places = lattice.places;
    co_await each(pace, places.size(), Cost::some_ns, [&](uint32_t i) { places[i] = 0; });
    co_await each(pace, border.size(), Cost::hundreds_of_ns,
                  [&](uint32_t i) { lattice.mark(border.points[i], border.points[border.next[i]]); });
    bool is_inside = false;
    uint32_t count = 0;
    co_await each(pace, places.size(), Cost::some_ns, [&](uint32_t i) {
        if (i % lattice.width == 0) is_inside = false;
        is_inside ^= (places[i] & 1) != 0;
        places[i] = is_inside && (places[i] & 2) == 0;
        count += places[i];
    });
    Buffer<uint32_t> inside(count, pace.memory());
    count = 0;
    co_await each(pace, places.size(), Cost::some_ns, [&](uint32_t i) {
        if (places[i] != 0) inside[count++] = i;
    });
    co_return inside;
}

// The mesh while it gets its points, and the triangles that are to be looked at.
class Refinement {
public:
    Refinement(size_t vertices, Memory* memory)
        : mesh(vertices, 2 * vertices, memory), waiting_(2 * vertices, memory), is_waiting_(2 * vertices, memory) {}

    // A triangle that changed is looked at again.
    void wait(int32_t triangle) {
        while (known_ < mesh.triangle_count()) is_waiting_[known_++] = 0;
        if (is_waiting_[triangle] != 0) return;
        is_waiting_[triangle] = 1;
        waiting_[(first_ + count_++) % waiting_.size()] = triangle;
    }
    bool has_waiting() const { return count_ > 0; }
    int32_t next() {
        const int32_t triangle = waiting_[first_];
        first_ = first_ + 1 == waiting_.size() ? 0 : first_ + 1;
        --count_;
        is_waiting_[triangle] = 0;
        return triangle;
    }

    bool split_chord(const Frame& frame, int32_t triangle) {
        for (uint32_t k = 0; k < 3; ++k) {
            if (!mesh.is_chord(triangle, k)) continue;
            const PlaneMesh::Triangle& t = mesh.triangle(triangle);
            const Point2 point = middle_of(mesh.point(t.vertices[(k + 1) % 3]), mesh.point(t.vertices[(k + 2) % 3]));
            // A chord so short that its middle is not between its ends' neighbours is beyond what doubles can part.
            if (!mesh.insert(triangle, static_cast<int32_t>(k), point)) {
                const Point2 at = frame.unscaled(point);
                throw Failure(FLG_ERROR_INVALID_ARGUMENT, "contour: at (%.9g, %.9g) it is too narrow to be inflated",
                              at.x, at.y);
            }
            return true;
        }
        return false;
    }

    // Adds the centre of a bad triangle's circle, or splits the edge of the border that is in its way.
    void improve(double spacing, int32_t triangle) {
        const PlaneMesh::Triangle& t = mesh.triangle(triangle);
        const Point2 p[3] = {mesh.point(t.vertices[0]), mesh.point(t.vertices[1]), mesh.point(t.vertices[2])};
        double across[3];
        for (uint32_t k = 0; k < 3; ++k) across[k] = squared(p[(k + 1) % 3], p[(k + 2) % 3]);
        const auto sharpest = static_cast<uint32_t>(std::min_element(across, across + 3) - across);
        const double shortest = across[sharpest];
        if (shortest < min_edge * min_edge * spacing * spacing) return;
        const Point2 centre = circumcentre(p[0], p[1], p[2]);
        const double radius = squared(centre, p[0]);
        const bool corner = t.neighbours[(sharpest + 1) % 3] < 0 && t.neighbours[(sharpest + 2) % 3] < 0;
        const bool sharp = radius > circle_by_edge * circle_by_edge * shortest && !corner;
        if (!sharp && radius <= max_circle * max_circle * spacing * spacing) return;
        const PlaneMesh::Place place = mesh.locate(triangle, centre, max_walk);
        if (place.triangle < 0) return;
        if (place.beyond) {
            split_border(spacing, place.triangle, static_cast<uint32_t>(place.side));
            return;
        }
        // An edge of the border that would see the new point at more than a right angle is split instead.
        const PlaneMesh::Triangle around = mesh.triangle(place.triangle);
        if (split_if_seen(spacing, place.triangle, centre)) return;
        for (const int32_t neighbour : around.neighbours)
            if (neighbour >= 0 && split_if_seen(spacing, neighbour, centre)) return;
        mesh.insert(place.triangle, place.side, centre);
    }

    PlaneMesh mesh;

private:
    bool split_if_seen(double spacing, int32_t triangle, const Point2& from) {
        const PlaneMesh::Triangle& near = mesh.triangle(triangle);
        for (uint32_t k = 0; k < 3; ++k) {
            if (near.neighbours[k] >= 0) continue;
            const Point2 &a = mesh.point(near.vertices[(k + 1) % 3]), &b = mesh.point(near.vertices[(k + 2) % 3]);
            if ((a.x - from.x) * (b.x - from.x) + (a.y - from.y) * (b.y - from.y) >= 0) continue;
            split_border(spacing, triangle, k);
            return true;
        }
        return false;
    }
    void split_border(double spacing, int32_t triangle, uint32_t side) {
        const PlaneMesh::Triangle& t = mesh.triangle(triangle);
        const Point2 &a = mesh.point(t.vertices[(side + 1) % 3]), &b = mesh.point(t.vertices[(side + 2) % 3]);
        if (squared(a, b) < 4 * min_edge * min_edge * spacing * spacing) return;
        mesh.insert(triangle, static_cast<int32_t>(side), middle_of(a, b));
    }

    Buffer<int32_t> waiting_;  // in a ring
    Buffer<uint8_t> is_waiting_;
    uint32_t first_ = 0, count_ = 0;
    uint32_t known_ = 0;  // triangles that is_waiting_ has an entry for
};

// The triangulation of the border as a mesh that takes more points.
Task<void> copy_triangulation(Pace& pace, const ContourTriangulation& from, const Border& border, PlaneMesh& mesh) {
    Buffer<int32_t> number(from.count, pace.memory());
    int32_t count = 0;
    co_await each(pace, from.count, Cost::some_ns, [&](uint32_t t) { number[t] = from.is_inside(t) ? count++ : -1; });
    co_await each(pace, border.size(), Cost::some_ns, [&](uint32_t i) { mesh.add_vertex(border.points[i], true); });
    co_await each(pace, from.count, Cost::tens_of_ns, [&](uint32_t i) {
        if (number[i] < 0) return;
        const auto& t = from.triangles[i];
        PlaneMesh::Triangle to{t.vertices, {-1, -1, -1}};
        for (uint32_t k = 0; k < 3; ++k)
            if (!t.is_edge[k] && t.neighbours[k] >= 0) to.neighbours[k] = number[t.neighbours[k]];
        mesh.add_triangle(to);
        mesh.check(static_cast<int32_t>(mesh.triangle_count()) - 1);
    });
    co_await repeat(pace, Cost::hundreds_of_ns, [&] { return !mesh.legalize([](int32_t) {}); });
}

// Inserts the places of the lattice.
Task<void> fill(Pace& pace, const Lattice& lattice, std::span<const uint32_t> places, PlaneMesh& mesh) {
    Slice slice(Cost::hundreds_of_ns);
    int32_t last = 0, row_first = 0;  // vertices added last, and first in the row
    uint32_t last_row = UINT32_MAX;
    for (const uint32_t at : places) {
        const uint32_t row = at / lattice.width;
        const Point2 point = lattice.point(row, at % lattice.width);
        PlaneMesh::Place place = mesh.locate(mesh.triangle_of(row == last_row ? last : row_first), point, max_walk);
        if (place.triangle < 0 || place.beyond) {
            // A notch in between: looked for everywhere.
            const auto count = static_cast<int32_t>(mesh.triangle_count());
            place.triangle = -1;
            for (int32_t t = 0; t < count && place.triangle < 0; ++t) {
                place = mesh.locate(t, point, 1);
                if (place.triangle != t || place.beyond) place.triangle = -1;
                if (slice.is_over()) co_await pace;
            }
            if (place.triangle < 0) continue;
        }
        if (mesh.insert(place.triangle, place.side, point)) {
            last = static_cast<int32_t>(mesh.vertex_count()) - 1;
            if (row != last_row) row_first = last;
            last_row = row;
        }
        do {
            if (slice.is_over()) co_await pace;
        } while (!mesh.legalize([](int32_t) {}));
    }
}

// Splits chords, and triangles of bad shape while there are not too many vertices.
Task<void> refine(Pace& pace, const Frame& frame, uint32_t max_vertices, Refinement& all) {
    co_await each(pace, all.mesh.triangle_count(), Cost::some_ns,
                  [&](uint32_t t) { all.wait(static_cast<int32_t>(t)); });
    Slice slice(Cost::hundreds_of_ns);
    while (all.has_waiting()) {
        const int32_t triangle = all.next();
        if (!all.split_chord(frame, triangle) && all.mesh.vertex_count() < max_vertices)
            all.improve(frame.spacing, triangle);
        do {
            if (slice.is_over()) co_await pace;
        } while (!all.mesh.legalize([&](int32_t changed) { all.wait(changed); }));
    }
}

Task<void> write(Pace& pace, const Frame& frame, const Border& border, const PlaneMesh& mesh, InflatedPart& part) {
    const uint32_t vertices = mesh.vertex_count(), triangles = mesh.triangle_count();
    part.points = Buffer<Point2>(vertices, pace.memory());
    part.on_border = Buffer<uint8_t>(vertices, pace.memory());
    part.triangles = Buffer<TriangleVertices>(triangles, pace.memory());
    co_await each(pace, vertices, Cost::tens_of_ns, [&](uint32_t v) {
        const auto vertex = static_cast<int32_t>(v);
        part.on_border[v] = mesh.on_border(vertex);
        const bool original = v < border.size() && (v == 0 || border.owner[v] != border.owner[v - 1]);
        part.points[v] = original ? part.contour.points[border.owner[v]] : frame.unscaled(mesh.point(vertex));
    });
    co_await each(pace, triangles, Cost::some_ns, [&](uint32_t t) {
        const auto& corners = mesh.triangle(static_cast<int32_t>(t)).vertices;
        for (uint32_t k = 0; k < 3; ++k) part.triangles[t][k] = static_cast<uint32_t>(corners[k]);
    });
}

}  // namespace

Task<void> part_mesh(Pace& pace, InflationOptions options, InflatedPart& part) {
    Memory* memory = pace.memory();
    part.thickness = options.thickness;
    const Frame frame = co_await measure(pace, options.spacing, part);
    Border border = co_await even_border(pace, part.contour, frame, true);
    ContourTriangulation triangulation = co_await triangulate_contour(pace, border.points, border.next, memory);
    if (triangulation.fault.kind != ContourFault::Kind::none) {
        // Thinning may make rings cross that don't: now all points stay.
        border = co_await even_border(pace, part.contour, frame, false);
        triangulation = co_await triangulate_contour(pace, border.points, border.next, memory);
        ContourFault fault = triangulation.fault;
        if (fault.kind != ContourFault::Kind::none) {
            fault.first = border.owner[fault.first];
            fault.second = border.owner[fault.second];
            throw describe_fault(part.contour, fault);
        }
    }
    Lattice lattice(frame, memory);
    const Buffer<uint32_t> places = co_await places_inside(pace, lattice, border);
    const uint32_t max_vertices = 2 * (border.size() + static_cast<uint32_t>(places.size())) + 64;
    Refinement refinement(2 * size_t{max_vertices} + 64, memory);
    co_await copy_triangulation(pace, triangulation, border, refinement.mesh);
    triangulation = ContourTriangulation();
    co_await fill(pace, lattice, {places.data(), places.size()}, refinement.mesh);
    co_await refine(pace, frame, max_vertices, refinement);
    co_await write(pace, frame, border, refinement.mesh, part);
}

}  // namespace flg
