// SPDX-License-Identifier: MIT
#include "skeletons/wavefront.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "skeletons/passes.h"

namespace flg {

namespace {

// ---- When each triangle of a wavefront changes next, the earliest first: a binary heap with one place a triangle, so
// that events that no longer hold leave nothing behind. Memory is taken once.

struct WaveEvent {
    enum class Kind : uint8_t {
        edge,      // a wavefront edge shrinks to a point
        diagonal,  // two ends of a side between triangles meet
        flat,      // the triangle's corners come to be on one line
        last       // to be done after all else at its time
    };
    double time;
    Kind kind;
    uint8_t side;
};

class EventQueue {
public:
    static constexpr uint32_t none = ~0u;

    EventQueue(size_t triangles, Memory* memory)
        : events_(triangles, memory), heap_(triangles, memory), place_(triangles, memory) {}

    void begin_triangle(uint32_t triangle) { place_[triangle] = none; }
    bool empty() const { return size_ == 0; }
    uint32_t first() const { return heap_[0]; }
    const WaveEvent& event(uint32_t triangle) const { return events_[triangle]; }

    void set(uint32_t triangle, const WaveEvent& event) {
        events_[triangle] = event;
        if (place_[triangle] == none) {
            place_[triangle] = static_cast<uint32_t>(size_);
            heap_[size_++] = triangle;
        }
        sink(place_[triangle]);
        rise(place_[triangle]);
    }
    void remove(uint32_t triangle) {
        const uint32_t at = place_[triangle];
        if (at == none) return;
        place_[triangle] = none;
        const uint32_t moved = heap_[--size_];
        if (moved == triangle) return;
        put(at, moved);
        sink(at);
        rise(place_[moved]);
    }

private:
    // Ties are decided by number, for the same bits everywhere.
    bool is_before(uint32_t a, uint32_t b) const {
        const WaveEvent &x = events_[a], &y = events_[b];
        if (x.time != y.time) return x.time < y.time;
        const bool x_last = x.kind == WaveEvent::Kind::last, y_last = y.kind == WaveEvent::Kind::last;
        return x_last != y_last ? y_last : a < b;
    }
    void put(uint32_t at, uint32_t triangle) {
        heap_[at] = triangle;
        place_[triangle] = at;
    }
    void rise(uint32_t at) {
        const uint32_t triangle = heap_[at];
        for (; at > 0 && is_before(triangle, heap_[(at - 1) / 2]); at = (at - 1) / 2) put(at, heap_[(at - 1) / 2]);
        put(at, triangle);
    }
    void sink(uint32_t at) {
        const uint32_t triangle = heap_[at];
        for (uint32_t child = 2 * at + 1; child < size_; child = 2 * at + 1) {
            if (child + 1 < size_ && is_before(heap_[child + 1], heap_[child])) ++child;
            if (!is_before(heap_[child], triangle)) break;
            put(at, heap_[child]);
            at = child;
        }
        put(at, triangle);
    }

    Buffer<WaveEvent> events_;
    Buffer<uint32_t> heap_, place_;
    size_t size_ = 0;
};

// What the front takes for zero. Lengths are shares of the contour's diagonal; found by measuring on contours drawn by
// chance on grids, turned and jittered.
namespace wave {

constexpr double coincident = 1e-12;        // vertices nearer than this are at one place
constexpr double closes = 1e-11;            // a diagonal's ends that pass each other nearer than this meet
constexpr double closing_lead = 1e-7;       // before a diagonal closes its triangle seems flat: a double root's error
constexpr double on_line = 4e-15;           // a vertex nearer than this to an edge's line is on it
constexpr double flat_height = 1e-15;       // a triangle less high than this is flat
constexpr double walk_height = 1e-13;       // the same for the neighbour of a flat one
constexpr double rate_noise = 1e-12;        // relative, of the rate at which an area changes
constexpr double far_from_parallel = 1e-2;  // |n1 x n2| above this: two lines give a good point
constexpr double one_place = 1e-6;          // the last two vertices of a loop nearer than this end in one node

}  // namespace wave

// Measured: at most 2.5 events and flips a point, on all that comes through.
constexpr uint64_t events_a_point = 12, events_at_least = 10'000;

// A contour of n points and any holes has less than 2 n triangles; each event that ends vertices takes one away,
// makes at most two vertices and two nodes; each vertex draws one arc, and each loop one more.
constexpr size_t triangles_a_point = 2, vertices_a_point = 5, nodes_a_point = 5, arcs_a_point = 7;

constexpr double never = std::numeric_limits<double>::infinity();
constexpr uint32_t hops_at_once = 8;
constexpr double as_flat = 4;  // by the area of the triangle that is flat

double cross(const Point2& a, const Point2& b) {
    return a.x * b.y - a.y * b.x;
}
double dot(const Point2& a, const Point2& b) {
    return a.x * b.x + a.y * b.y;
}
Point2 difference(const Point2& a, const Point2& b) {
    return {a.x - b.x, a.y - b.y};
}

class Wavefront {
public:
    Wavefront(const ContourTriangulation& triangulation, std::span<const Point2> points, std::span<const uint32_t> next,
              double size, double facing, Memory* memory);

    void add_edge(uint32_t point);
    void add_point(uint32_t point);
    void number(uint32_t triangle) {
        number_[triangle] = triangulation_.is_inside(triangle) ? static_cast<int32_t>(triangle_count_++) : -1;
    }
    void add_triangle(uint32_t triangle);
    uint32_t triangle_count() const { return triangle_count_; }
    void schedule(int32_t triangle);
    bool step();
    // No event took it away.
    bool is_alive(int32_t triangle) const { return triangles_[triangle].vertices[0] >= 0; }
    void fail() { has_failed_ = true; }
    FrontTrace take() { return {std::move(nodes_), std::move(arcs_), node_count_, arc_count_, has_failed_}; }

private:
    struct Line {
        Point2 normal, direction;
        double offset;  // at time t the line is where normal . x = offset + t
    };
    struct Vertex {
        Point2 at;  // at `time`
        Point2 velocity;
        double time;
        uint32_t left, right;  // the edge that ends here and the one that begins
        uint32_t node;
        bool is_infinite;
    };
    // neighbours[k] is across from vertices[k]; below 0: front edge ~neighbour. Without vertices: vertices[0] is -1.
    struct Triangle {
        std::array<int32_t, 3> vertices, neighbours;
    };
    // Triangles around a vertex that are still to get another one.
    struct Fan {
        int32_t triangle, from, to;
        bool by_before;
    };
    enum class Change { edge, diagonal, split, flip, walk };
    // A triangle's corners and sides at a moment.
    struct Shape {
        std::array<Point2, 3> at, velocity;
        std::array<double, 3> lengths;
    };

    static constexpr uint32_t none = ~0u;

    static uint32_t after(uint32_t k) { return k == 2 ? 0 : k + 1; }
    static uint32_t before(uint32_t k) { return k == 0 ? 2 : k - 1; }
    Point2 position(const Vertex& vertex) const {
        const double age = now_ - vertex.time;
        return {vertex.at.x + vertex.velocity.x * age, vertex.at.y + vertex.velocity.y * age};
    }
    Shape shape(const Triangle& triangle) const;
    static uint32_t front_sides(const Triangle& t) {
        return (t.neighbours[0] < 0) + (t.neighbours[1] < 0) + (t.neighbours[2] < 0);
    }
    void remove(int32_t triangle);

    int32_t add_vertex(uint32_t left, uint32_t right, const Point2& at, uint32_t node);
    uint32_t add_node(const Point2& at);
    void end_vertex(int32_t vertex, uint32_t node);

    void hold_if_turned_out(const Triangle& t);
    void closing_edges(const Triangle& t, const Shape& s, WaveEvent& event) const;
    void closing_diagonals(const Triangle& t, const Shape& s, WaveEvent& event) const;
    double reaches_edge(const Triangle& t, const Shape& s) const;
    double gets_flat(const Shape& s) const;

    void next_event();
    bool waits(const WaveEvent& event, uint32_t triangle);
    Change decide(int32_t triangle, uint32_t& side, const WaveEvent& event) const;
    Change decide_flat(const Triangle& t, uint32_t& side) const;
    uint32_t shortest_front(const Triangle& t, uint32_t best) const;
    static uint32_t max_side(const Shape& s);
    void walk();
    bool has_infinite(const Triangle& t) const {
        return std::any_of(t.vertices.begin(), t.vertices.end(),
                           [&](int32_t vertex) { return vertices_[vertex].is_infinite; });
    }
    bool hop();
    bool comes_back(int32_t other, uint32_t shared) const;
    void change(Change change);

    uint32_t corner(int32_t triangle, int32_t vertex) const { return place_in(triangles_[triangle].vertices, vertex); }
    uint32_t side_to(int32_t triangle, int32_t neighbour) const {
        return place_in(triangles_[triangle].neighbours, neighbour);
    }
    void give(int32_t triangle, bool by_before, int32_t from, int32_t to);
    void relabel_one();
    bool join(int32_t triangle, uint32_t i, uint32_t j);
    Point2 slower_place(int32_t a, int32_t b) const;
    void close_loop(int32_t vertex, int32_t last, const Point2& at);
    void collapse_edge(int32_t triangle, uint32_t side);
    void collapse_diagonal(int32_t triangle, uint32_t side);
    void split(int32_t triangle, uint32_t side);
    void flip(int32_t triangle, uint32_t side);

    const ContourTriangulation& triangulation_;
    std::span<const Point2> points_;
    std::span<const uint32_t> next_;
    double size_, facing_;
    double now_ = 0;
    Buffer<Line> lines_;
    Buffer<uint32_t> previous_;
    Buffer<int32_t> number_;  // of the triangulation's triangles, here
    Buffer<Triangle> triangles_;
    Buffer<Vertex> vertices_;
    Buffer<SkeletonNode> nodes_;
    Buffer<SkeletonArc> arcs_;
    EventQueue queue_;
    // The change that is under way: of the triangle whose event it is, or of one that was reached from it.
    int32_t begun_ = -1, changing_ = -1;
    uint32_t side_ = 0;
    bool walks_ = false;  // it is still to be found
    // The way there: triangles, each with the side that it was left by.
    struct Hop {
        int32_t triangle;
        uint32_t side;
    };
    Buffer<Hop> way_;
    uint32_t way_length_ = 0;
    int32_t left_behind_ = -1;  // the triangle that it was reached from, without an event
    std::array<Fan, 4> fans_;
    uint32_t fan_count_ = 0;
    uint32_t triangle_count_ = 0, vertex_count_ = 0, node_count_ = 0, arc_count_ = 0;
    uint64_t events_left_;
    bool has_failed_ = false;
};

// Setting up.

Wavefront::Wavefront(const ContourTriangulation& triangulation, std::span<const Point2> points,
                     std::span<const uint32_t> next, double size, double facing, Memory* memory)
    : triangulation_(triangulation),
      points_(points),
      next_(next),
      size_(size),
      facing_(facing),
      lines_(points.size(), memory),
      previous_(points.size(), memory),
      number_(triangulation.count, memory),
      triangles_(triangles_a_point * points.size(), memory),
      vertices_(vertices_a_point * points.size(), memory),
      nodes_(nodes_a_point * points.size(), memory),
      arcs_(arcs_a_point * points.size(), memory),
      queue_(triangles_a_point * points.size(), memory),
      way_(triangles_a_point * points.size(), memory),
      events_left_(events_a_point * points.size() + events_at_least) {}

void Wavefront::add_edge(uint32_t point) {
    const Point2 &a = points_[point], &b = points_[next_[point]];
    const double dx = b.x - a.x, dy = b.y - a.y, length = std::sqrt(dx * dx + dy * dy);
    Line& line = lines_[point];
    line.direction = {dx / length, dy / length};
    line.normal = {-line.direction.y, line.direction.x};
    line.offset = line.normal.x * (a.x + b.x) * 0.5 + line.normal.y * (a.y + b.y) * 0.5;
    previous_[next_[point]] = point;
}

void Wavefront::add_point(uint32_t point) {
    const int32_t vertex = add_vertex(previous_[point], point, points_[point], add_node(points_[point]));
    vertices_[vertex].at = points_[point];
}

void Wavefront::add_triangle(uint32_t index) {
    if (number_[index] < 0) return;
    const ContourTriangulation::Triangle& source = triangulation_.triangles[index];
    Triangle& triangle = triangles_[number_[index]];
    triangle.vertices = source.vertices;
    for (uint32_t k = 0; k < 3; ++k)
        triangle.neighbours[k] = source.is_edge[k] ? ~source.vertices[after(k)] : number_[source.neighbours[k]];
    queue_.begin_triangle(static_cast<uint32_t>(number_[index]));
}

// At `at` and the time that is now, moving with the lines of both edges.
int32_t Wavefront::add_vertex(uint32_t left, uint32_t right, const Point2& at, uint32_t node) {
    Vertex& vertex = vertices_[vertex_count_];
    vertex = {at, {0, 0}, now_, left, right, node, false};
    const Line &a = lines_[left], &b = lines_[right];
    const Point2 sum = {a.normal.x + b.normal.x, a.normal.y + b.normal.y};
    const double sum_sq = sum.x * sum.x + sum.y * sum.y;
    if (sum_sq < facing_ * facing_) {
        vertex.is_infinite = true;
    } else {
        vertex.velocity = {2 * sum.x / sum_sq, 2 * sum.y / sum_sq};
        const double off_a = a.offset + now_ - (a.normal.x * at.x + a.normal.y * at.y);
        const double off_b = b.offset + now_ - (b.normal.x * at.x + b.normal.y * at.y);
        const double cross = a.normal.x * b.normal.y - a.normal.y * b.normal.x;
        if (std::fabs(cross) > wave::far_from_parallel) {
            vertex.at.x += (off_a * b.normal.y - off_b * a.normal.y) / cross;
            vertex.at.y += (a.normal.x * off_b - b.normal.x * off_a) / cross;
        } else if (sum_sq > 1) {
            const double off = (off_a + off_b) / 4;
            vertex.at.x += off * sum.x;
            vertex.at.y += off * sum.y;
        }
    }
    return static_cast<int32_t>(vertex_count_++);
}

uint32_t Wavefront::add_node(const Point2& at) {
    nodes_[node_count_] = {at, now_};
    return node_count_++;
}

void Wavefront::end_vertex(int32_t vertex, uint32_t node) {
    const Vertex& v = vertices_[vertex];
    arcs_[arc_count_++] = {v.node, node, v.left, v.right};
}

void Wavefront::remove(int32_t triangle) {
    triangles_[triangle].vertices[0] = -1;
    queue_.remove(static_cast<uint32_t>(triangle));
}

// What comes next: the rest of a change that is under way, or an event. False at the end, or when it failed.
bool Wavefront::step() {
    if (fan_count_ > 0) {
        relabel_one();
    } else if (walks_) {
        walk();
    } else if (left_behind_ >= 0) {
        if (is_alive(left_behind_)) schedule(left_behind_);
        left_behind_ = -1;
    } else if (!queue_.empty()) {
        next_event();
    } else {
        return false;
    }
    return !has_failed_;
}

// Whether a triangle with an infinitely fast vertex has to wait for others at its time.
bool Wavefront::waits(const WaveEvent& event, uint32_t triangle) {
    if (event.kind != WaveEvent::Kind::last) return false;
    queue_.remove(triangle);
    if (!queue_.empty()) {
        const WaveEvent& other = queue_.event(queue_.first());
        if (other.kind != WaveEvent::Kind::last && other.time <= event.time + wave::closes * size_) {
            queue_.set(triangle, {other.time, event.kind, event.side});
            return true;
        }
    }
    return false;
}

void Wavefront::next_event() {
    if (events_left_-- == 0) {
        fail();
        return;
    }
    const uint32_t first = queue_.first();
    const WaveEvent event = queue_.event(first);
    if (waits(event, first)) return;
    queue_.remove(first);
    now_ = std::max(now_, event.time);
    begun_ = changing_ = static_cast<int32_t>(first);
    side_ = event.side;
    const Change decided = decide(begun_, side_, event);
    if (decided == Change::walk) {
        walks_ = true;
        way_length_ = 0;
    } else {
        change(decided);
    }
}

void Wavefront::change(Change change) {
    walks_ = false;
    if (changing_ != begun_) left_behind_ = begun_;
    switch (change) {
        case Change::edge: collapse_edge(changing_, side_); break;
        case Change::diagonal: collapse_diagonal(changing_, side_); break;
        case Change::split: split(changing_, side_); break;
        case Change::flip: flip(changing_, side_); break;
        case Change::walk: break;
    }
}

// When a triangle changes next, and what the change is.

Wavefront::Shape Wavefront::shape(const Triangle& triangle) const {
    Shape s;
    for (uint32_t k = 0; k < 3; ++k) {
        const Vertex& vertex = vertices_[triangle.vertices[k]];
        s.at[k] = position(vertex);
        s.velocity[k] = vertex.velocity;
    }
    for (uint32_t k = 0; k < 3; ++k) {
        const Point2 side = difference(s.at[before(k)], s.at[after(k)]);
        s.lengths[k] = std::sqrt(dot(side, side));
    }
    return s;
}

void Wavefront::closing_edges(const Triangle& t, const Shape& s, WaveEvent& event) const {
    for (uint32_t k = 0; k < 3; ++k) {
        if (t.neighbours[k] >= 0) continue;
        const Point2& direction = lines_[~t.neighbours[k]].direction;
        const double length = dot(direction, difference(s.at[before(k)], s.at[after(k)]));
        const double growth = dot(direction, difference(s.velocity[before(k)], s.velocity[after(k)]));
        const double time = length <= wave::coincident * size_ ? now_ : growth < 0 ? now_ - length / growth : never;
        if (time < event.time) event = {time, WaveEvent::Kind::edge, static_cast<uint8_t>(k)};
    }
}

void Wavefront::closing_diagonals(const Triangle& t, const Shape& s, WaveEvent& event) const {
    for (uint32_t k = 0; k < 3; ++k) {
        if (t.neighbours[k] < 0) continue;
        const Point2 apart = difference(s.at[before(k)], s.at[after(k)]);
        const Point2 speed = difference(s.velocity[before(k)], s.velocity[after(k)]);
        const double approach = dot(apart, speed), speed_sq = dot(speed, speed), miss = cross(apart, speed);
        const double bound = wave::closes * size_;
        if (approach >= 0 || miss * miss > speed_sq * bound * bound) continue;
        const double time = now_ - approach / speed_sq;
        if (time < event.time) event = {time, WaveEvent::Kind::diagonal, static_cast<uint8_t>(k)};
    }
}

// Of a triangle with one front edge: when the corner across from it reaches it.
double Wavefront::reaches_edge(const Triangle& t, const Shape& s) const {
    const uint32_t k = t.neighbours[0] < 0 ? 0 : t.neighbours[1] < 0 ? 1 : 2;
    const Line& line = lines_[~t.neighbours[k]];
    const double height = dot(line.normal, s.at[k]) - line.offset - now_, growth = dot(line.normal, s.velocity[k]) - 1;
    if (height <= wave::on_line * size_) return growth <= 1e-9 ? now_ : never;
    return growth < 0 ? now_ - height / growth : never;
}

// Of a triangle without front edges: when its area gets zero, a quadratic equation.
double Wavefront::gets_flat(const Shape& s) const {
    const Point2 b = difference(s.at[1], s.at[0]), c = difference(s.at[2], s.at[0]);
    const Point2 u = difference(s.velocity[1], s.velocity[0]), w = difference(s.velocity[2], s.velocity[0]);
    const double area = cross(b, c), rate = cross(b, w) + cross(u, c), bend = cross(u, w);
    const double longest = std::max(s.lengths[0], std::max(s.lengths[1], s.lengths[2]));
    const double noise = wave::flat_height * size_ * longest;
    if (area <= noise) {
        const double speed = std::fabs(u.x) + std::fabs(u.y) + std::fabs(w.x) + std::fabs(w.y);
        if (rate <= wave::rate_noise * longest * speed) return now_;
        return bend < 0 ? now_ - rate / bend : never;
    }
    const double discriminant = rate * rate - 4 * area * bend;
    if (discriminant < 0) {
        const bool touches = rate < 0 && bend > 0 && area - rate * rate / (4 * bend) <= noise;
        return touches ? now_ - rate / (2 * bend) : never;
    }
    const double root = std::sqrt(discriminant);
    if (rate < 0) return now_ + 2 * area / (root - rate);
    return bend < 0 ? now_ - (rate + root) / (2 * bend) : never;
}

// A vertex with one triangle turns by less than a half turn. If its lines say more, they are about to be one:
// rounding has put what happens there in a wrong order, and all of it happens now.
void Wavefront::hold_if_turned_out(const Triangle& t) {
    for (uint32_t k = 0; k < 3; ++k) {
        if (t.neighbours[after(k)] >= 0 || t.neighbours[before(k)] >= 0) continue;
        Vertex& v = vertices_[t.vertices[k]];
        const Point2 &in = lines_[v.left].direction, &out = lines_[v.right].direction;
        if (v.is_infinite || dot(in, out) >= 0 || cross(in, out) >= 0) continue;
        v.at = position(v);
        v.time = now_;
        v.velocity = {0, 0};
        v.is_infinite = true;
    }
}

void Wavefront::schedule(int32_t index) {
    const Triangle& t = triangles_[index];
    if (front_sides(t) > 1) hold_if_turned_out(t);
    const Shape s = shape(t);
    const uint32_t front = front_sides(t);
    WaveEvent event = {never, WaveEvent::Kind::flat, 0};
    closing_edges(t, s, event);
    for (uint32_t k = 0; k < 3; ++k) {
        const bool closed = t.neighbours[k] >= 0 && s.lengths[k] <= wave::coincident * size_;
        if (closed && now_ < event.time) event = {now_, WaveEvent::Kind::flat, 0};
    }
    const auto is_infinite = [&](uint32_t k) { return vertices_[t.vertices[k]].is_infinite; };
    if (is_infinite(0) || is_infinite(1) || is_infinite(2)) {
        if (event.time > now_) event = {now_, WaveEvent::Kind::last, 0};
    } else if (front < 3) {
        WaveEvent closing = {never, WaveEvent::Kind::diagonal, 0};
        closing_diagonals(t, s, closing);
        const double flat = front == 1 ? reaches_edge(t, s) : front == 0 ? gets_flat(s) : never;
        if (closing.time < event.time) event = closing;
        if (flat < event.time && flat < closing.time - wave::closing_lead * size_)
            event = {flat, WaveEvent::Kind::flat, 0};
    }
    // No front outlives its contour's diagonal.
    if (event.time < now_ + 2 * size_) {
        queue_.set(static_cast<uint32_t>(index), event);
    } else {
        queue_.remove(static_cast<uint32_t>(index));
    }
}

// What happens to a triangle; of one that gets flat together with others walk() finds out.
Wavefront::Change Wavefront::decide(int32_t triangle, uint32_t& side, const WaveEvent& event) const {
    const Triangle& t = triangles_[triangle];
    if (event.kind == WaveEvent::Kind::diagonal) return Change::diagonal;
    if (event.kind == WaveEvent::Kind::edge) {
        if (front_sides(t) > 1) side = shortest_front(t, side);
        return Change::edge;
    }
    for (uint32_t k = 0; k < 3; ++k) {
        const uint32_t i = after(k), j = before(k);
        if (!vertices_[t.vertices[k]].is_infinite || t.neighbours[i] >= 0 || t.neighbours[j] >= 0) continue;
        const Shape s = shape(t);
        side = s.lengths[i] <= s.lengths[j] ? i : j;
        return Change::edge;
    }
    const Change change = decide_flat(t, side);
    if (change != Change::split || front_sides(t) < 2) return change;
    side = shortest_front(t, none);
    return Change::edge;
}

uint32_t Wavefront::shortest_front(const Triangle& t, uint32_t best) const {
    const Shape s = shape(t);
    for (uint32_t k = 0; k < 3; ++k) {
        if (t.neighbours[k] < 0 && (best == none || s.lengths[k] < s.lengths[best])) best = k;
    }
    return best;
}

Wavefront::Change Wavefront::decide_flat(const Triangle& t, uint32_t& side) const {
    const Shape s = shape(t);
    uint32_t shortest = 0;
    for (uint32_t k = 1; k < 3; ++k) {
        if (s.lengths[k] < s.lengths[shortest]) shortest = k;
    }
    if (s.lengths[shortest] <= 10 * wave::coincident * size_) {
        side = shortest;
        return t.neighbours[shortest] < 0 ? Change::edge : Change::diagonal;
    }
    side = max_side(s);
    return t.neighbours[side] < 0 ? Change::split : Change::walk;
}

uint32_t Wavefront::max_side(const Shape& s) {
    const uint32_t longest = s.lengths[1] > s.lengths[0] ? 1 : 0;
    return s.lengths[2] > s.lengths[longest] ? 2 : longest;
}

// Some steps through neighbours that are flat too, each across the longest side of the one before, while sides get
// longer. What is found there is done, and the way goes on from the triangle before: from the first one it would lead
// there again.
void Wavefront::walk() {
    for (uint32_t i = 0; i < hops_at_once; ++i) {
        const bool is_split = triangles_[changing_].neighbours[side_] < 0;
        if (!is_split && hop()) continue;
        if (is_split && (front_sides(triangles_[changing_]) > 1 || has_infinite(triangles_[changing_]))) {
            walks_ = false;
            left_behind_ = begun_;
            return;
        }
        if (is_split) {
            split(changing_, side_);
        } else {
            flip(changing_, side_);
        }
        walks_ = way_length_ > 0;
        if (!walks_) return;
        if (events_left_-- == 0) return fail();
        const Hop& before = way_[--way_length_];
        changing_ = before.triangle;
        side_ = before.side;
        return;
    }
}

bool Wavefront::hop() {
    const int32_t other = triangles_[changing_].neighbours[side_];
    const Triangle& t = triangles_[other];
    if (front_sides(t) > 1 || has_infinite(t)) return false;
    const Shape s = shape(t);
    const uint32_t longest = max_side(s), shared = side_to(other, changing_);
    if (longest == shared || s.lengths[longest] <= s.lengths[shared]) return false;
    const double area = cross(difference(s.at[1], s.at[0]), difference(s.at[2], s.at[0]));
    const bool is_flat = area <= wave::walk_height * size_ * s.lengths[longest];
    if (!is_flat && (s.lengths[longest] < wave::one_place * size_ || !comes_back(other, shared))) return false;
    const double bound = 10 * wave::coincident * size_;
    if (s.lengths[after(longest)] <= bound || s.lengths[before(longest)] <= bound) return false;
    way_[way_length_++] = {changing_, side_};
    changing_ = other;
    side_ = longest;
    return true;
}

// Whether the triangles that a flip makes would be as flat, and the new side the longest of one: errors of long lines
// have grown beyond walk_height, and the side would be flipped to and fro.
bool Wavefront::comes_back(int32_t other, uint32_t shared) const {
    const Triangle& here = triangles_[changing_];
    const Point2 tip = position(vertices_[here.vertices[side_]]),
                 beyond = position(vertices_[triangles_[other].vertices[shared]]);
    const Point2 ends[] = {position(vertices_[here.vertices[after(side_)]]),
                           position(vertices_[here.vertices[before(side_)]])};
    const Point2 across = difference(beyond, tip);
    const double flat = as_flat * std::fabs(cross(difference(ends[0], tip), difference(ends[1], tip)));
    return std::any_of(std::begin(ends), std::end(ends), [&](const Point2& end) {
        const Point2 side = difference(end, tip), other_side = difference(end, beyond);
        return std::fabs(cross(across, side)) <= flat && dot(across, across) >= dot(side, side) &&
               dot(across, across) >= dot(other_side, other_side);
    });
}

// The four changes.

// The triangles around vertex `from` get another one, from `triangle` on to the front: by the side before their
// corner at it, or the one after. They are done one a unit, once the change itself is done.
void Wavefront::give(int32_t triangle, bool by_before, int32_t from, int32_t to) {
    if (triangle >= 0) fans_[fan_count_++] = {triangle, from, to, by_before};
}

void Wavefront::relabel_one() {
    Fan& fan = fans_[fan_count_ - 1];
    const int32_t index = fan.triangle;
    const uint32_t k = corner(index, fan.from);
    Triangle& t = triangles_[index];
    t.vertices[k] = fan.to;
    fan.triangle = t.neighbours[fan.by_before ? before(k) : after(k)];
    if (fan.triangle < 0) --fan_count_;
    schedule(index);
}

// Sides i and j of a triangle that goes away become one. True if both were the front's: then nothing is left there.
bool Wavefront::join(int32_t triangle, uint32_t i, uint32_t j) {
    const int32_t a = triangles_[triangle].neighbours[i], b = triangles_[triangle].neighbours[j];
    if (a >= 0) triangles_[a].neighbours[side_to(a, triangle)] = b;
    if (b >= 0) triangles_[b].neighbours[side_to(b, triangle)] = a;
    return a < 0 && b < 0;
}

// Where the slower of two vertices that meet is: its place has the smaller error.
Point2 Wavefront::slower_place(int32_t a, int32_t b) const {
    const auto speed_sq = [](const Vertex& v) {
        if (v.is_infinite) return std::numeric_limits<double>::max();
        return v.velocity.x * v.velocity.x + v.velocity.y * v.velocity.y;
    };
    return position(vertices_[speed_sq(vertices_[a]) <= speed_sq(vertices_[b]) ? a : b]);
}

// The new vertex and the last one of its loop enclose nothing: an arc joins them, unless they are at one place.
void Wavefront::close_loop(int32_t vertex, int32_t last, const Point2& at) {
    const Vertex& v = vertices_[vertex];
    const Point2 end = position(vertices_[last]);
    if (std::hypot(end.x - at.x, end.y - at.y) <= wave::one_place * size_) {
        end_vertex(last, v.node);
    } else {
        const uint32_t node = add_node(end);
        end_vertex(last, node);
        arcs_[arc_count_++] = {v.node, node, v.left, v.right};
    }
}

// A front edge vanishes: its ends become one vertex.
void Wavefront::collapse_edge(int32_t triangle, uint32_t side) {
    const Triangle t = triangles_[triangle];
    const int32_t a = t.vertices[after(side)], b = t.vertices[before(side)], last = t.vertices[side];
    const Point2 at = slower_place(a, b);
    const uint32_t node = add_node(at), left = vertices_[a].left, right = vertices_[b].right;
    end_vertex(a, node);
    end_vertex(b, node);
    const bool ends = join(triangle, after(side), before(side));
    remove(triangle);
    const int32_t vertex = add_vertex(left, right, at, node);
    if (ends) {
        close_loop(vertex, last, at);
    } else {
        give(t.neighbours[after(side)], true, b, vertex);
        give(t.neighbours[before(side)], false, a, vertex);
    }
}

// Two vertices that are not neighbours on the front meet: it parts into one on each side of the diagonal.
void Wavefront::collapse_diagonal(int32_t triangle, uint32_t side) {
    const int32_t other = triangles_[triangle].neighbours[side];
    const uint32_t j = side_to(other, triangle);
    const Triangle t = triangles_[triangle], o = triangles_[other];
    const int32_t u = t.vertices[after(side)], w = t.vertices[before(side)];
    const Point2 at = slower_place(u, w);
    const uint32_t node = add_node(at);
    const Vertex from_u = vertices_[u], from_w = vertices_[w];
    end_vertex(u, node);
    end_vertex(w, node);
    const bool here_ends = join(triangle, after(side), before(side)), there_ends = join(other, after(j), before(j));
    remove(triangle);
    remove(other);
    const int32_t here = add_vertex(from_u.left, from_w.right, at, node);
    if (here_ends) {
        close_loop(here, t.vertices[side], at);
    } else {
        give(t.neighbours[after(side)], true, w, here);
        give(t.neighbours[before(side)], false, u, here);
    }
    const int32_t there = add_vertex(from_w.left, from_u.right, at, node);
    if (there_ends) {
        close_loop(there, o.vertices[j], at);
    } else {
        give(o.neighbours[after(j)], true, u, there);
        give(o.neighbours[before(j)], false, w, there);
    }
}

// A vertex reaches a front edge and parts it.
void Wavefront::split(int32_t triangle, uint32_t side) {
    const Triangle t = triangles_[triangle];
    const int32_t tip = t.vertices[side], edge = t.neighbours[side];
    const int32_t at_begin = t.neighbours[before(side)], at_end = t.neighbours[after(side)];
    if (at_begin < 0 || at_end < 0) {
        fail();
        return;
    }
    const Point2 at = position(vertices_[tip]);
    const uint32_t node = add_node(at), left = vertices_[tip].left, right = vertices_[tip].right;
    end_vertex(tip, node);
    triangles_[at_begin].neighbours[side_to(at_begin, triangle)] = edge;
    triangles_[at_end].neighbours[side_to(at_end, triangle)] = edge;
    remove(triangle);
    give(at_begin, true, tip, add_vertex(static_cast<uint32_t>(~edge), right, at, node));
    give(at_end, false, tip, add_vertex(left, static_cast<uint32_t>(~edge), at, node));
}

void Wavefront::flip(int32_t triangle, uint32_t k) {
    const Triangle here = triangles_[triangle];
    const int32_t other = here.neighbours[k];
    const uint32_t j = side_to(other, triangle);
    const Triangle there = triangles_[other];
    const int32_t a = here.vertices[k], b = here.vertices[after(k)], c = here.vertices[before(k)],
                  d = there.vertices[j];
    triangles_[triangle] = {{a, b, d}, {there.neighbours[after(j)], other, here.neighbours[before(k)]}};
    triangles_[other] = {{a, d, c}, {there.neighbours[before(j)], here.neighbours[after(k)], triangle}};
    const int32_t beyond_d = there.neighbours[after(j)], beyond_c = here.neighbours[after(k)];
    if (beyond_d >= 0) triangles_[beyond_d].neighbours[side_to(beyond_d, other)] = triangle;
    if (beyond_c >= 0) triangles_[beyond_c].neighbours[side_to(beyond_c, triangle)] = other;
    schedule(triangle);
    schedule(other);
}

}  // namespace

Task<FrontTrace> move_front(Pace& pace, const ContourTriangulation& triangulation, std::span<const Point2> points,
                            std::span<const uint32_t> next, double size, double facing, Memory* memory) {
    Wavefront front(triangulation, points, next, size, facing, memory);
    // Lines first: a vertex needs both of its own.
    co_await pass(pace, points.size(), Cost::tens_of_ns, [&](uint32_t i) { front.add_edge(i); });
    co_await pass(pace, points.size(), Cost::tens_of_ns, [&](uint32_t i) { front.add_point(i); });
    co_await pass(pace, triangulation.count, Cost::some_ns, [&](uint32_t i) { front.number(i); });
    co_await pass(pace, triangulation.count, Cost::tens_of_ns, [&](uint32_t i) { front.add_triangle(i); });
    const uint32_t triangles = front.triangle_count();
    const auto schedule = [&](uint32_t i) { front.schedule(static_cast<int32_t>(i)); };
    co_await pass(pace, triangles, Cost::hundreds_of_ns, schedule);
    co_await repeat(pace, Cost::hundreds_of_ns, [&] { return front.step(); });
    const auto look = [&](uint32_t i) {
        if (front.is_alive(static_cast<int32_t>(i))) front.fail();
    };
    co_await pass(pace, triangles, Cost::some_ns, look);
    co_return front.take();
}

}  // namespace flg
