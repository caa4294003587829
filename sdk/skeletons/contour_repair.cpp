// SPDX-License-Identifier: MIT
#include "skeletons/contour_repair.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "core/growing_list.h"
#include "core/random.h"
#include "runtime/each.h"
#include "runtime/merge_sort.h"
#include "skeletons/node_clusters.h"
#include "surfaces/mesh/index_table.h"

namespace flg {

namespace {

constexpr int grid_bits = 26;
constexpr int64_t margin = 1 << 12;       // cells around the drawing, for corners that are moved
constexpr int64_t area_origin = 1 << 26;  // of areas: about the middle
constexpr uint32_t pairs_at_once = 8, edges_at_once = 8;
constexpr uint32_t sorted_at_once = 32;  // cuts of an edge, edges of a vertex
// Each bends edges by up to a cell; drawings take three.
constexpr uint32_t max_rounds = 60;
constexpr int64_t min_area = 10'000;  // twice, in cells: about a millionth of the drawing wide and high
constexpr double corner_step = 8;     // cells
constexpr uint32_t max_moves = 8;

// Of a cell; mixed, or the cells of a grid would fall into few places of a table.
uint64_t key_of(uint64_t x, uint64_t y) {
    return mix64(x << 32 | y);
}

bool is_upper(int64_t x, int64_t y) {
    return y > 0 || (y == 0 && x > 0);
}

class Repair {
public:
    Repair(const Contour& rings, Memory* memory);

    void measure_point(uint32_t point);
    void begin_points();
    void add_point(uint32_t point);
    // Of vertices: as many as a step makes.
    bool has_room() const { return vertex_of_.has_room(pairs_at_once); }
    Task<void> make_room(Pace& pace, size_t more) { return KeyTable<uint64_t>::reserve(pace, vertex_of_, more); }
    void add_segment(uint32_t point) {
        add_segment(chain_[point], chain_[input_.next(point)], input_.ring_of(point), 0);
    }

    void begin_round();
    uint32_t segment_count() const { return segments_.size(); }
    uint32_t part_count() const { return parts_.size(); }
    uint32_t vertex_count() const { return vertices_.size(); }
    uint32_t bucket(uint32_t segment) const;
    void clear_head(uint32_t segment) { first_cut_[segment] = no_input_point; }
    bool sweep(uint32_t segment);
    void begin_cuts() { chain_.clear(); }
    uint32_t first_cut(uint32_t segment) const { return first_cut_[segment]; }
    uint32_t gather_cut(uint32_t cut);
    uint32_t chain_length() const { return chain_.size(); }
    void sort_short_chain(uint32_t segment);
    static Task<void> sort_long_chain(Pace& pace, Repair& repair, uint32_t segment);
    void begin_parts(uint32_t segment) { part_begin_ = segments_[segment].a; }
    void add_part(uint32_t segment, uint32_t end);
    uint32_t chain_vertex(uint32_t i) const { return chain_[i]; }
    uint32_t end_of(uint32_t segment) const { return segments_[segment].b; }
    bool end_round();
    void begin_merging() { first_part_ = Buffer<uint32_t>(vertices_.size(), memory_); }
    void clear_part_head(uint32_t vertex) { first_part_[vertex] = no_input_point; }
    void begin_merge(uint32_t segment);
    bool merge();

    void keep_if_it_separates(uint32_t part);
    void begin_regions();
    uint32_t from(uint32_t half) const { return half % 2 == 0 ? segments_[half / 2].a : segments_[half / 2].b; }
    void clear_half(uint32_t half) { cycle_of_[half] = no_input_point; }
    void set_fans(Groups fans) { fans_ = std::move(fans); }
    std::span<uint32_t> fan(uint32_t vertex) {
        return {fans_.items.data() + fans_.offsets[vertex], fans_.items.data() + fans_.offsets[vertex + 1]};
    }
    bool is_before(uint32_t half, uint32_t other) const;
    void place_half(uint32_t i) { place_[fans_.items[i]] = i; }
    bool begin_cycle(uint32_t half);
    bool walk_cycle();
    uint32_t cycle_count() const { return cycles_.size(); }
    uint32_t outer_cycle_count() const { return outer_cycles_.size(); }
    void begin_ray();
    bool shoot(uint32_t outer_cycle);
    bool begin_spread();
    bool spread();
    void begin_regions_of_cycles();
    void begin_cycle_region(uint32_t cycle) {
        regions_->begin(cycle);
        areas_[cycle] = 0;
    }
    void join_regions(uint32_t segment);
    void measure_region(uint32_t cycle);
    void choose_region(uint32_t cycle);
    void begin_borders();
    void clear_use(uint32_t half) { is_used_[half] = 0; }
    bool begin_border(uint32_t half);
    bool walk_border();
    void end_ring();
    void end_borders() const;
    // How often the rings pass each vertex.
    void begin_visits() { visits_ = Buffer<uint32_t>(vertices_.size(), memory_); }
    void clear_visits(uint32_t vertex) { visits_[vertex] = 0; }
    void visit(uint32_t i) { touches_ |= ++visits_[ring_vertices_[i]] > 1; }
    uint32_t ring_size() const { return ring_vertices_.size(); }
    uint32_t ring_count() const { return ring_begin_.size() - 1; }
    uint32_t ring_begin(uint32_t ring) const { return ring_begin_[ring]; }
    bool touches() const { return touches_; }
    void begin_moves();
    void move_corner(uint32_t i);
    void add_moved(uint32_t i);
    uint32_t outer_ring() const { return outer_ring_; }
    Point2 point_at(uint32_t i) const;
    uint32_t source_at(uint32_t i) const;
    uint32_t pieces_left_out() const { return left_out_; }

private:
    struct Cell {
        int64_t x, y;
    };
    // How often it is drawn from a to b less than from b to a: by ring 0, and by the others, each with a weight of
    // its own so that what two of them wind around does not cancel out.
    struct Segment {
        uint32_t a, b;
        int64_t outer, hole;
    };
    struct Cut {
        uint32_t vertex, next;  // of the same segment
    };
    struct Cycle {
        uint64_t twice_area;  // of a whole number that may be below 0; sums on the way wrap
        uint32_t leftmost;    // vertex
        uint32_t begin;       // half
        uint32_t container;   // of an outer one: the cycle around it
        int64_t outer, hole;
        bool is_known;
    };

    uint32_t vertex_at(const Cell& cell, uint32_t source);
    void add_segment(uint32_t a, uint32_t b, uint32_t ring, uint32_t outer_ring);
    void meet(uint32_t first, uint32_t second);
    static int64_t turn(const Cell& a, const Cell& b, const Cell& c);
    static uint64_t twice_area_under(const Cell& a, const Cell& b);
    bool lead_through(uint32_t segment, uint32_t vertex);
    void cut_at(uint32_t segment, uint32_t vertex);
    uint32_t to(uint32_t half) const { return from(half ^ 1); }
    uint32_t clockwise(uint32_t half) const;
    bool is_inside(uint32_t cycle) const { return cycles_[cycle].outer != 0 && cycles_[cycle].hole == 0; }
    bool is_border(uint32_t half);
    bool is_first_on_edge(uint32_t u, uint32_t v, const Segment& of) const;
    [[noreturn]] void refuse() const;

    const Contour& input_;
    Memory* memory_;
    Point2 low_{}, high_{};
    double cell_ = 0;
    GrowingList<Cell> vertices_;
    GrowingList<uint32_t> sources_;  // one a vertex: the input's point, or no_input_point
    KeyTable<uint64_t> vertex_of_;
    GrowingList<Segment> segments_, parts_;
    Buffer<uint32_t> first_cut_;
    GrowingList<Cut> cuts_;
    GrowingList<uint32_t> active_;
    uint32_t active_at_ = 0;
    GrowingList<uint32_t> chain_;
    uint32_t part_begin_ = 0;
    Buffer<uint32_t> first_part_;      // by vertex
    GrowingList<uint32_t> next_part_;  // of the same vertex
    Segment merged_{};
    uint32_t same_ = 0;  // part that it may be between the same vertices as
    uint32_t rounds_ = 0, moves_ = 0;
    bool has_met_ = false;
    Groups fans_;                        // halves by the vertex that they begin at, counter-clockwise
    Buffer<uint32_t> place_, cycle_of_;  // by half
    GrowingList<Cycle> cycles_;
    GrowingList<uint32_t> outer_cycles_, stack_;
    uint32_t ray_edge_ = 0, nearest_ = no_input_point;
    long double nearest_x_ = 0, nearest_slope_ = 0;
    int64_t ray_outer_ = 0, ray_hole_ = 0;
    uint32_t walk_at_ = 0, walk_begin_ = 0;  // halves, on the way around a cycle or a ring
    std::optional<NodeClusters> regions_;
    uint32_t left_out_ = 0;  // regions that are not the largest
    Buffer<uint64_t> areas_;
    int64_t largest_ = 0;  // area
    uint32_t best_ = no_input_point, region_count_ = 0;
    Buffer<uint8_t> is_used_;
    GrowingList<uint32_t> ring_vertices_, ring_begin_;
    uint64_t ring_area_ = 0;  // twice, as of cycles
    uint32_t outer_ring_ = 0;
    Buffer<uint32_t> visits_;
    bool touches_ = false;
    uint32_t moved_ring_ = 0;
};

Repair::Repair(const Contour& rings, Memory* memory)
    : input_(rings),
      memory_(memory),
      vertices_(memory),
      sources_(memory),
      segments_(memory),
      parts_(memory),
      cuts_(memory),
      active_(memory),
      chain_(memory),
      next_part_(memory),
      cycles_(memory),
      outer_cycles_(memory),
      stack_(memory),
      ring_vertices_(memory),
      ring_begin_(memory) {
    low_ = high_ = rings.points[0];
}

void Repair::measure_point(uint32_t point) {
    const Point2& p = input_.points[point];
    low_ = {std::min(low_.x, p.x), std::min(low_.y, p.y)};
    high_ = {std::max(high_.x, p.x), std::max(high_.y, p.y)};
}

void Repair::begin_points() {
    cell_ = std::ldexp(1, std::ilogb(std::hypot(high_.x - low_.x, high_.y - low_.y)) - grid_bits);
}

// There is room.
uint32_t Repair::vertex_at(const Cell& cell, uint32_t source) {
    const auto key = key_of(static_cast<uint64_t>(cell.x), static_cast<uint64_t>(cell.y));
    const uint32_t found = vertex_of_.find(key);
    if (found != no_index) {
        has_met_ |= source != no_input_point;  // two points of the input in one cell
        return found;
    }
    const uint32_t vertex = vertices_.size();
    vertex_of_.insert(key, vertex);
    vertices_.push_back(cell);
    sources_.push_back(source);
    return vertex;
}

void Repair::add_point(uint32_t point) {
    const Point2& p = input_.points[point];
    chain_.push_back(vertex_at(
        {std::llround((p.x - low_.x) / cell_) + margin, std::llround((p.y - low_.y) / cell_) + margin}, point));
}

void Repair::add_segment(uint32_t a, uint32_t b, uint32_t ring, uint32_t outer_ring) {
    const bool is_outer = ring == outer_ring;
    if (a != b) segments_.push_back({a, b, is_outer, is_outer ? 0 : static_cast<int64_t>(mix64(ring) >> 24 | 1)});
}

void Repair::begin_round() {
    if (segments_.size() < 3) refuse();
    if (++rounds_ > max_rounds)
        throw Failure(FLG_ERROR_INVALID_ARGUMENT, "contour: it crosses itself too often in one place to be repaired");
    first_cut_ = Buffer<uint32_t>(segments_.size(), memory_);
    cuts_.clear();
    active_.clear();
    parts_.clear();
    active_at_ = 0;
}

// By where it begins from the left, as many as there are edges.
uint32_t Repair::bucket(uint32_t segment) const {
    const Segment& s = segments_[segment];
    const int64_t left = std::min(vertices_[s.a].x, vertices_[s.b].x);
    return static_cast<uint32_t>(left * static_cast<int64_t>(segments_.size()) >> (grid_bits + 2));
}

// The edge at hand against those that began before it and are not over, some at a time;
// true when it met all.
bool Repair::sweep(uint32_t first) {
    const Segment& s = segments_[first];
    const int64_t left = std::min(vertices_[s.a].x, vertices_[s.b].x);
    // The others of its bucket may begin before it, by no more than the bucket is wide.
    const int64_t bucket_width = (int64_t{1} << (grid_bits + 2)) / static_cast<int64_t>(segments_.size()) + 1;
    for (uint32_t i = 0; i < pairs_at_once; ++i) {
        if (active_at_ == active_.size()) {
            active_.push_back(first);
            active_at_ = 0;
            return true;
        }
        const Segment& other = segments_[active_[active_at_]];
        if (std::max(vertices_[other.a].x, vertices_[other.b].x) + bucket_width + 1 < left) {
            active_[active_at_] = active_.back();
            active_.pop_back();
        } else {
            meet(first, active_[active_at_++]);
        }
    }
    return false;
}

void Repair::meet(uint32_t first, uint32_t second) {
    const Segment s = segments_[first], t = segments_[second];
    const Cell &a = vertices_[s.a], &b = vertices_[s.b], &c = vertices_[t.a], &d = vertices_[t.b];
    if (std::max(a.y, b.y) + 1 < std::min(c.y, d.y) || std::max(c.y, d.y) + 1 < std::min(a.y, b.y)) return;
    if (std::max(a.x, b.x) + 1 < std::min(c.x, d.x) || std::max(c.x, d.x) + 1 < std::min(a.x, b.x)) return;
    const bool is_led = int(lead_through(first, t.a)) + lead_through(first, t.b) + lead_through(second, s.a) +
                            lead_through(second, s.b) >
                        0;
    if (is_led || s.a == t.a || s.a == t.b || s.b == t.a || s.b == t.b) return;
    const int64_t ac = turn(a, b, c), ad = turn(a, b, d), ca = turn(c, d, a), cb = turn(c, d, b);
    if ((ac > 0) == (ad > 0) || (ca > 0) == (cb > 0)) return;
    const double share = static_cast<double>(ca) / (static_cast<double>(ca) - static_cast<double>(cb));
    const Cell at = {a.x + std::llround(share * static_cast<double>(b.x - a.x)),
                     a.y + std::llround(share * static_cast<double>(b.y - a.y))};
    const uint32_t vertex = vertex_at(at, no_input_point);
    cut_at(first, vertex);
    cut_at(second, vertex);
}

int64_t Repair::turn(const Cell& a, const Cell& b, const Cell& c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

// If the vertex is nearer than a cell to the inside of an edge.
bool Repair::lead_through(uint32_t segment, uint32_t vertex) {
    const Segment& s = segments_[segment];
    if (vertex == s.a || vertex == s.b) return false;
    const Cell &a = vertices_[s.a], &b = vertices_[s.b], &v = vertices_[vertex];
    const int64_t along = (v.x - a.x) * (b.x - a.x) + (v.y - a.y) * (b.y - a.y);
    const int64_t length_sq = (b.x - a.x) * (b.x - a.x) + (b.y - a.y) * (b.y - a.y);
    if (along <= 0 || along >= length_sq) return false;
    const auto off = static_cast<double>(turn(a, b, v));
    if (off * off >= static_cast<double>(length_sq)) return false;
    cut_at(segment, vertex);
    return true;
}

void Repair::cut_at(uint32_t segment, uint32_t vertex) {
    const Segment& s = segments_[segment];
    if (vertex == s.a || vertex == s.b) return;
    cuts_.push_back({vertex, first_cut_[segment]});
    first_cut_[segment] = cuts_.size() - 1;
}

// Returns the next one of the edge.
uint32_t Repair::gather_cut(uint32_t cut) {
    chain_.push_back(cuts_[cut].vertex);
    return cuts_[cut].next;
}

bool Repair::is_first_on_edge(uint32_t u, uint32_t v, const Segment& of) const {
    const Cell &a = vertices_[of.a], &b = vertices_[of.b];
    const auto along = [&](uint32_t w) {
        return (vertices_[w].x - a.x) * (b.x - a.x) + (vertices_[w].y - a.y) * (b.y - a.y);
    };
    const int64_t along_u = along(u), along_v = along(v);
    return along_u != along_v ? along_u < along_v : u < v;
}

void Repair::sort_short_chain(uint32_t segment) {
    const Segment& s = segments_[segment];
    uint32_t sorted[sorted_at_once];
    const uint32_t count = chain_.size();
    for (uint32_t i = 0; i < count; ++i) sorted[i] = chain_[i];
    std::sort(sorted, sorted + count, [&](uint32_t u, uint32_t v) { return is_first_on_edge(u, v, s); });
    for (uint32_t i = 0; i < count; ++i) chain_[i] = sorted[i];
}

Task<void> Repair::sort_long_chain(Pace& pace, Repair& repair, uint32_t segment) {
    const Segment s = repair.segments_[segment];
    GrowingList<uint32_t>& chain = repair.chain_;
    Buffer<uint32_t> sorted(chain.size(), pace.memory()), scratch(chain.size(), pace.memory());
    co_await each(pace, sorted.size(), Cost::some_ns, [&](uint32_t i) { sorted[i] = chain[i]; });
    co_await merge_sort(pace, std::span(sorted.data(), sorted.size()), std::span(scratch.data(), scratch.size()),
                        [&](uint32_t u, uint32_t v) { return repair.is_first_on_edge(u, v, s); });
    co_await each(pace, sorted.size(), Cost::some_ns, [&](uint32_t i) { chain[i] = sorted[i]; });
}

void Repair::add_part(uint32_t segment, uint32_t end) {
    if (end == part_begin_) return;
    parts_.push_back({part_begin_, end, segments_[segment].outer, segments_[segment].hole});
    part_begin_ = end;
}

// False if something was cut: then there is another round.
bool Repair::end_round() {
    if (cuts_.empty()) {
        parts_.clear();
        next_part_.clear();
        return true;
    }
    has_met_ = true;
    segments_.swap(parts_);
    return false;
}

// Those between the same two vertices become one: the edge against those of its vertex, one at a time.
void Repair::begin_merge(uint32_t segment) {
    merged_ = segments_[segment];
    if (merged_.a > merged_.b) merged_ = {merged_.b, merged_.a, -merged_.outer, -merged_.hole};
    same_ = first_part_[merged_.a];
}

// False when it is merged.
bool Repair::merge() {
    if (same_ == no_input_point) {
        next_part_.push_back(first_part_[merged_.a]);
        first_part_[merged_.a] = parts_.size();
        parts_.push_back(merged_);
        return false;
    }
    if (parts_[same_].b != merged_.b) {
        same_ = next_part_[same_];
        return true;
    }
    parts_[same_].outer += merged_.outer;
    parts_[same_].hole += merged_.hole;
    has_met_ = true;
    return false;
}

// Edges that are drawn as often one way as the other separate nothing.
void Repair::keep_if_it_separates(uint32_t part) {
    if (part == 0) segments_.clear();
    if (parts_[part].outer != 0 || parts_[part].hole != 0) segments_.push_back(parts_[part]);
}

void Repair::begin_regions() {
    if (segments_.empty()) refuse();
    place_ = Buffer<uint32_t>(2 * segments_.size(), memory_);
    cycle_of_ = Buffer<uint32_t>(2 * segments_.size(), memory_);
    cycles_.clear();
    outer_cycles_.clear();
}

// Counter-clockwise by direction.
bool Repair::is_before(uint32_t half, uint32_t other) const {
    const Cell &o = vertices_[from(half)], &p = vertices_[to(half)], &q = vertices_[to(other)];
    const bool first_upper = is_upper(p.x - o.x, p.y - o.y), second_upper = is_upper(q.x - o.x, q.y - o.y);
    return first_upper != second_upper ? first_upper : turn(o, p, q) > 0;
}

// The half that begins where this one does, next to its right.
uint32_t Repair::clockwise(uint32_t half) const {
    const uint32_t vertex = from(half), i = place_[half];
    return fans_.items[i == fans_.offsets[vertex] ? fans_.offsets[vertex + 1] - 1 : i - 1];
}

uint64_t Repair::twice_area_under(const Cell& a, const Cell& b) {
    return static_cast<uint64_t>((a.x - area_origin) * (b.y - area_origin) - (b.x - area_origin) * (a.y - area_origin));
}

// Halves around a face, which is on their left. Outer cycles, around whole parts of the drawing, turn clockwise. False
// if the half is in a cycle already.
bool Repair::begin_cycle(uint32_t half) {
    if (cycle_of_[half] != no_input_point) return false;
    cycles_.push_back({0, from(half), half, no_input_point, 0, 0, false});
    walk_at_ = half;
    return true;
}

// A half on the way; false after the last.
bool Repair::walk_cycle() {
    const uint32_t number = cycles_.size() - 1;
    Cycle& cycle = cycles_[number];
    const Cell &a = vertices_[from(walk_at_)], &b = vertices_[to(walk_at_)], &left = vertices_[cycle.leftmost];
    cycle.twice_area += twice_area_under(a, b);
    if (a.x < left.x || (a.x == left.x && a.y < left.y)) cycle.leftmost = from(walk_at_);
    cycle_of_[walk_at_] = number;
    walk_at_ = clockwise(walk_at_ ^ 1);
    if (walk_at_ != cycle.begin) return true;
    if (static_cast<int64_t>(cycle.twice_area) < 0) outer_cycles_.push_back(number);
    return false;
}

void Repair::begin_ray() {
    ray_edge_ = 0;
    nearest_ = no_input_point;
    ray_outer_ = ray_hole_ = 0;
}

// From an outer cycle's leftmost vertex to the left: what winds around it, and the face that it is in. Looks at
// some edges; true when it has looked at all.
bool Repair::shoot(uint32_t outer_cycle) {
    Cycle& cycle = cycles_[outer_cycles_[outer_cycle]];
    const Cell p = vertices_[cycle.leftmost];
    for (uint32_t i = 0; i < edges_at_once && ray_edge_ < segments_.size(); ++i, ++ray_edge_) {
        const Segment& s = segments_[ray_edge_];
        const Cell &u = vertices_[s.a], &v = vertices_[s.b];
        const bool rises = v.y > p.y;
        if ((u.y > p.y) == rises) continue;
        const int64_t side = rises ? turn(u, v, p) : turn(v, u, p);
        if (side >= 0) continue;  // not left of it
        ray_outer_ += rises ? -s.outer : s.outer;
        ray_hole_ += rises ? -s.hole : s.hole;
        // Of edges that part on the ray the one that is further right above it.
        const long double slope = static_cast<long double>(v.x - u.x) / static_cast<long double>(v.y - u.y);
        const long double x = u.x + static_cast<long double>(p.y - u.y) * static_cast<long double>(v.x - u.x) /
                                        static_cast<long double>(v.y - u.y);
        if (nearest_ != no_input_point && (x < nearest_x_ || (x == nearest_x_ && slope <= nearest_slope_))) continue;
        nearest_slope_ = slope;
        nearest_ = 2 * ray_edge_ + rises;  // the half that falls
        nearest_x_ = x;
    }
    if (ray_edge_ < segments_.size()) return false;
    cycle.outer = ray_outer_;
    cycle.hole = ray_hole_;
    cycle.is_known = true;
    cycle.container = nearest_ == no_input_point ? no_input_point : cycle_of_[nearest_];
    stack_.push_back(outer_cycles_[outer_cycle]);
    return true;
}

// From a cycle that is known to those across its edges. False if none is left.
bool Repair::begin_spread() {
    if (stack_.empty()) return false;
    walk_at_ = walk_begin_ = cycles_[stack_.back()].begin;
    stack_.pop_back();
    return true;
}

// An edge on the way; false after the last.
bool Repair::spread() {
    const Cycle here = cycles_[cycle_of_[walk_at_]];
    Cycle& across = cycles_[cycle_of_[walk_at_ ^ 1]];
    if (!across.is_known) {
        const Segment& s = segments_[walk_at_ / 2];
        const int64_t way = walk_at_ % 2 == 0 ? 1 : -1;
        across.outer = here.outer - way * s.outer;
        across.hole = here.hole - way * s.hole;
        across.is_known = true;
        stack_.push_back(cycle_of_[walk_at_ ^ 1]);
    }
    walk_at_ = clockwise(walk_at_ ^ 1);
    return walk_at_ != walk_begin_;
}

void Repair::begin_regions_of_cycles() {
    regions_.emplace(cycles_.size(), memory_);
    areas_ = Buffer<uint64_t>(cycles_.size(), memory_);
    best_ = no_input_point;
    largest_ = min_area - 1;
    region_count_ = 0;
}

void Repair::join_regions(uint32_t segment) {
    const uint32_t left = cycle_of_[2 * segment], right = cycle_of_[2 * segment + 1];
    if (is_inside(left) && is_inside(right)) regions_->join(left, right);
    if (segment < outer_cycles_.size()) {
        const uint32_t outer = outer_cycles_[segment], container = cycles_[outer].container;
        if (container != no_input_point && is_inside(outer)) regions_->join(outer, container);
    }
}

void Repair::measure_region(uint32_t cycle) {
    if (is_inside(cycle)) areas_[regions_->first(cycle)] += cycles_[cycle].twice_area;
}

void Repair::choose_region(uint32_t cycle) {
    const auto area = static_cast<int64_t>(areas_[cycle]);
    region_count_ += area >= min_area;
    if (area <= largest_) return;
    largest_ = area;
    best_ = cycle;
}

void Repair::begin_borders() {
    if (best_ == no_input_point) refuse();
    left_out_ += region_count_ - 1;
    is_used_ = Buffer<uint8_t>(size_t{2} * segments_.size(), memory_);
    ring_vertices_.clear();
    ring_begin_.clear();
    ring_begin_.push_back(0);
}

bool Repair::is_border(uint32_t half) {
    const uint32_t left = cycle_of_[half];
    return is_inside(left) && !is_inside(cycle_of_[half ^ 1]) && regions_->first(left) == best_;
}

// False if no border begins there that was not walked.
bool Repair::begin_border(uint32_t half) {
    if (is_used_[half] != 0 || !is_border(half)) return false;
    walk_at_ = walk_begin_ = half;
    ring_area_ = 0;
    return true;
}

// Around the region's sectors at each vertex, so that rings are parted where it meets itself in a point: to the next
// half of the vertex, and on along that if it is of the border. False after the last half.
bool Repair::walk_border() {
    if (is_border(walk_at_)) {
        if (walk_at_ == walk_begin_ && is_used_[walk_at_] != 0) return false;
        is_used_[walk_at_] = 1;
        ring_vertices_.push_back(from(walk_at_));
        ring_area_ += twice_area_under(vertices_[from(walk_at_)], vertices_[to(walk_at_)]);
        walk_at_ ^= 1;
    }
    walk_at_ = clockwise(walk_at_);
    return true;
}

// Holes that can hardly be seen are left out.
void Repair::end_ring() {
    const auto twice_area = static_cast<int64_t>(ring_area_);
    if (std::abs(twice_area) < min_area) return ring_vertices_.shrink(ring_begin_.back());
    if (twice_area > 0) outer_ring_ = ring_begin_.size() - 1;
    ring_begin_.push_back(ring_vertices_.size());
}

void Repair::end_borders() const {
    if (ring_begin_.size() < 2) refuse();
}

// Corners that touch, into the region by some cells; the rings are taken through all of it again.
void Repair::begin_moves() {
    if (++moves_ > max_moves)
        throw Failure(FLG_ERROR_INVALID_ARGUMENT, "contour: it touches itself too often in one place to be repaired");
    has_met_ = true;
    touches_ = false;
    segments_.clear();
    chain_.clear();
    moved_ring_ = 0;
    rounds_ = 0;
}

void Repair::move_corner(uint32_t i) {
    const uint32_t vertex = ring_vertices_[i];
    if (i == ring_begin_[moved_ring_ + 1]) ++moved_ring_;
    if (visits_[vertex] == 1) return chain_.push_back(vertex);
    const uint32_t begin = ring_begin_[moved_ring_], end = ring_begin_[moved_ring_ + 1];
    const Cell &p = vertices_[ring_vertices_[i == begin ? end - 1 : i - 1]], &v = vertices_[vertex],
               &q = vertices_[ring_vertices_[i + 1 == end ? begin : i + 1]];
    const double in_x = static_cast<double>(v.x - p.x), in_y = static_cast<double>(v.y - p.y),
                 out_x = static_cast<double>(q.x - v.x), out_y = static_cast<double>(q.y - v.y);
    const double in = std::hypot(in_x, in_y), out = std::hypot(out_x, out_y);
    // Half way between the two edges, on their left; of a spike, back along it.
    double x = out_x / out - in_x / in, y = out_y / out - in_y / in, length = std::hypot(x, y);
    const double sine = in_x * out_y - in_y * out_x;
    if (length < 1e-3) {
        x = -in_y / in;
        y = in_x / in;
        length = 1;
    } else if (sine < 0) {
        length = -length;
    }
    const double step = corner_step * static_cast<double>(1u << moves_) / length;
    chain_.push_back(vertex_at({v.x + std::llround(step * x), v.y + std::llround(step * y)}, no_input_point));
}

// The edge from corner i, when all have moved; in turn.
void Repair::add_moved(uint32_t i) {
    if (i == 0) moved_ring_ = 0;
    if (i == ring_begin_[moved_ring_ + 1]) ++moved_ring_;
    const uint32_t next = i + 1 == ring_begin_[moved_ring_ + 1] ? ring_begin_[moved_ring_] : i + 1;
    add_segment(chain_[i], chain_[next], moved_ring_, outer_ring_);
}

Point2 Repair::point_at(uint32_t i) const {
    const uint32_t vertex = ring_vertices_[i];
    if (!has_met_) return input_.points[sources_[vertex]];
    const Cell& cell = vertices_[vertex];
    return {low_.x + cell_ * static_cast<double>(cell.x - margin),
            low_.y + cell_ * static_cast<double>(cell.y - margin)};
}

uint32_t Repair::source_at(uint32_t i) const {
    const uint32_t source = sources_[ring_vertices_[i]];
    return source == no_input_point ? no_input_point : input_.input_points[source];
}

void Repair::refuse() const {
    throw Failure(FLG_ERROR_INVALID_ARGUMENT, "contour: its rings go around nothing that has an area");
}

// The points that edges got become their ends.
Task<void> cut_edges(Pace& pace, Repair& repair) {
    Slice slice(Cost::tens_of_ns);
    for (uint32_t segment = 0; segment < repair.segment_count(); ++segment) {
        repair.begin_cuts();
        for (uint32_t cut = repair.first_cut(segment); cut != no_input_point; cut = repair.gather_cut(cut))
            if (slice.is_over()) co_await pace;
        const uint32_t cuts = repair.chain_length();
        if (cuts > sorted_at_once) {
            co_await Repair::sort_long_chain(pace, repair, segment);
        } else {
            repair.sort_short_chain(segment);
            if (slice.is_over(2 * cuts)) co_await pace;
        }
        repair.begin_parts(segment);
        for (uint32_t i = 0; i < cuts; ++i) {
            repair.add_part(segment, repair.chain_vertex(i));
            if (slice.is_over()) co_await pace;
        }
        repair.add_part(segment, repair.end_of(segment));
        if (slice.is_over(2)) co_await pace;
    }
}

// Edges get points where they meet, until none do; then those between the same two vertices become one.
Task<void> part_edges(Pace& pace, Repair& repair) {
    Slice slice(Cost::hundreds_of_ns);
    do {
        repair.begin_round();
        const uint32_t count = repair.segment_count();
        const auto bucket_of = [&](uint32_t i) { return repair.bucket(i); };
        const Groups order = co_await group_by(pace, count, count, bucket_of);
        co_await each(pace, count, Cost::some_ns, [&](uint32_t i) { repair.clear_head(i); });
        for (const uint32_t segment : order.items) {
            do {
                if (!repair.has_room()) co_await repair.make_room(pace, repair.vertex_count() + pairs_at_once);
                if (slice.is_over()) co_await pace;
            } while (!repair.sweep(segment));
        }
        co_await cut_edges(pace, repair);
    } while (!repair.end_round());
    repair.begin_merging();
    co_await each(pace, repair.vertex_count(), Cost::some_ns, [&](uint32_t i) { repair.clear_part_head(i); });
    Slice merging(Cost::tens_of_ns);
    for (uint32_t i = 0; i < repair.segment_count(); ++i) {
        repair.begin_merge(i);
        do {
            if (merging.is_over()) co_await pace;
        } while (repair.merge());
    }
    co_await each(pace, repair.part_count(), Cost::some_ns, [&](uint32_t i) { repair.keep_if_it_separates(i); });
}

// The edges of each vertex, counter-clockwise.
Task<void> sort_fans(Pace& pace, Repair& repair) {
    const auto is_before = [&](uint32_t a, uint32_t b) { return repair.is_before(a, b); };
    const uint32_t vertices = repair.vertex_count();
    co_await each_by_work(pace, vertices, Cost::tens_of_ns, [&](uint32_t vertex) {
        const std::span<uint32_t> fan = repair.fan(vertex);
        if (fan.size() > sorted_at_once) return 1u;
        std::sort(fan.begin(), fan.end(), is_before);
        return 4 * static_cast<uint32_t>(fan.size()) + 1;
    });
    Buffer<uint32_t> scratch;
    Slice slice(Cost::some_ns);
    for (uint32_t vertex = 0; vertex < vertices; ++vertex) {
        if (slice.is_over()) co_await pace;
        const std::span<uint32_t> fan = repair.fan(vertex);
        if (fan.size() <= sorted_at_once) continue;
        scratch = Buffer<uint32_t>(fan.size(), pace.memory());
        co_await merge_sort(pace, fan, std::span(scratch.data(), scratch.size()), is_before);
    }
    co_await each(pace, 2 * repair.segment_count(), Cost::some_ns, [&](uint32_t i) { repair.place_half(i); });
}

// The faces between edges that do not meet, what rings wind around them, and the border of the largest region.
Task<void> find_border(Pace& pace, Repair& repair) {
    repair.begin_regions();
    Slice slice(Cost::tens_of_ns);
    const uint32_t segments = repair.segment_count(), halves = 2 * segments;
    const auto vertex_of = [&](uint32_t half) { return repair.from(half); };
    Groups fans = co_await group_by(pace, halves, repair.vertex_count(), vertex_of);
    repair.set_fans(std::move(fans));
    co_await each(pace, halves, Cost::some_ns, [&](uint32_t i) { repair.clear_half(i); });
    co_await sort_fans(pace, repair);
    for (uint32_t half = 0; half < halves; ++half) {
        bool is_walking = repair.begin_cycle(half);
        for (; is_walking; is_walking = repair.walk_cycle())
            if (slice.is_over()) co_await pace;
        if (slice.is_over()) co_await pace;
    }
    for (uint32_t i = 0; i < repair.outer_cycle_count(); ++i) {
        repair.begin_ray();
        while (!repair.shoot(i))
            if (slice.is_over(4)) co_await pace;
    }
    while (repair.begin_spread()) {
        do {
            if (slice.is_over()) co_await pace;
        } while (repair.spread());
    }
    repair.begin_regions_of_cycles();
    const uint32_t cycles = repair.cycle_count();
    co_await each(pace, cycles, Cost::some_ns, [&](uint32_t i) { repair.begin_cycle_region(i); });
    co_await each(pace, segments, Cost::tens_of_ns, [&](uint32_t i) { repair.join_regions(i); });
    co_await each(pace, cycles, Cost::tens_of_ns, [&](uint32_t i) { repair.measure_region(i); });
    co_await each(pace, cycles, Cost::some_ns, [&](uint32_t i) { repair.choose_region(i); });
    repair.begin_borders();
    co_await each(pace, halves, Cost::some_ns, [&](uint32_t i) { repair.clear_use(i); });
    for (uint32_t half = 0; half < halves; ++half) {
        if (slice.is_over()) co_await pace;
        if (!repair.begin_border(half)) continue;
        while (repair.walk_border())
            if (slice.is_over()) co_await pace;
        repair.end_ring();
    }
    repair.end_borders();
}

// Where rings touch each other, or themselves, corners move apart: then all of it is to be done again.
Task<bool> moves_apart(Pace& pace, Repair& repair) {
    repair.begin_visits();
    co_await each(pace, repair.vertex_count(), Cost::some_ns, [&](uint32_t i) { repair.clear_visits(i); });
    co_await each(pace, repair.ring_size(), Cost::tens_of_ns, [&](uint32_t i) { repair.visit(i); });
    if (!repair.touches()) co_return false;
    repair.begin_moves();
    const uint32_t count = repair.ring_size();
    co_await repair.make_room(pace, count);
    co_await each(pace, count, Cost::tens_of_ns, [&](uint32_t i) { repair.move_corner(i); });
    co_await each(pace, count, Cost::tens_of_ns, [&](uint32_t i) { repair.add_moved(i); });
    co_return true;
}

// The outer ring first.
Task<Contour> contour_of(Pace& pace, const Repair& repair) {
    std::pmr::vector<Point2> points(pace.memory());
    std::pmr::vector<uint32_t> offsets(1, 0, pace.memory()), sources(pace.memory());
    points.reserve(repair.ring_size());
    sources.reserve(repair.ring_size());
    offsets.reserve(repair.ring_count() + 1);
    for (uint32_t place = 0; place < repair.ring_count(); ++place) {
        const uint32_t outer = repair.outer_ring(), ring = place == 0 ? outer : place <= outer ? place - 1 : place;
        co_await each(pace, repair.ring_begin(ring), repair.ring_begin(ring + 1), Cost::tens_of_ns, [&](uint32_t i) {
            points.push_back(repair.point_at(i));
            sources.push_back(repair.source_at(i));
        });
        offsets.push_back(static_cast<uint32_t>(points.size()));
    }
    Contour contour = co_await clean_contour(pace, points, offsets);
    co_await each(pace, contour.size(), Cost::some_ns,
                  [&](uint32_t i) { contour.input_points[i] = sources[contour.input_points[i]]; });
    contour.pieces_left_out = repair.pieces_left_out();
    co_return contour;
}

}  // namespace

Task<Contour> repair_contour(Pace& pace, const Contour& rings) {
    Repair repair(rings, pace.memory());
    const auto count = static_cast<uint32_t>(rings.points.size());
    co_await each(pace, count, Cost::some_ns, [&](uint32_t i) { repair.measure_point(i); });
    repair.begin_points();
    co_await repair.make_room(pace, count);
    co_await each(pace, count, Cost::hundreds_of_ns, [&](uint32_t i) { repair.add_point(i); });
    co_await each(pace, count, Cost::tens_of_ns, [&](uint32_t i) { repair.add_segment(i); });
    do {
        co_await part_edges(pace, repair);
        co_await find_border(pace, repair);
    } while (co_await moves_apart(pace, repair));
    co_return co_await contour_of(pace, repair);
}

Task<ContourChange> find_change(Pace& pace, const Contour& contour, uint32_t input_points) {
    ContourChange change{.input = input_points, .pieces = contour.pieces_left_out};
    const uint32_t* const sources = contour.input_points.data();
    co_await each(pace, contour.size(), Cost::some_ns,
                  [&](uint32_t i) { change.added += sources[i] == no_input_point; });
    // A point that the region touches itself in is there twice.
    const uint32_t kept = contour.size() - change.added;
    change.dropped = input_points - std::min(input_points, kept);
    co_return change;
}

void ContourChange::warn(const Host& host, const char* object, uint64_t handle) const noexcept {
    host.warn(
        object, handle, "has another contour than was given",
        {{dropped, "points dropped"}, {added, "points added where edges cross"}, {pieces, "smaller pieces left out"}});
}

}  // namespace flg
