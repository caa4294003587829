// SPDX-License-Identifier: MIT
#include "skeletons/contour_repair.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <unordered_map>
#include <vector>

#include "core/random.h"
#include "runtime/each.h"
#include "skeletons/node_clusters.h"

namespace flg {

namespace {

constexpr int grid_bits = 26;
constexpr int64_t margin = 1 << 12;       // cells around the drawing, for corners that are moved
constexpr int64_t area_origin = 1 << 26;  // of areas: about the middle
constexpr uint32_t pairs_at_once = 8, edges_at_once = 8;
// Each bends edges by up to a cell; drawings take three.
constexpr uint32_t max_rounds = 60;
constexpr int64_t min_area = 10'000;  // twice, in cells: about a millionth of the drawing wide and high
constexpr double corner_step = 8;     // cells
constexpr uint32_t max_moves = 8;

uint64_t key_of(uint64_t high, uint64_t low) {
    return high << 32 | low;
}

bool is_upper(int64_t x, int64_t y) {
    return y > 0 || (y == 0 && x > 0);
}

class Repair {
public:
    Repair(const Contour& rings, Memory* memory);

    void add_point(uint32_t point);
    void add_segment(uint32_t point) {
        add_segment(chain_[point], chain_[input_.next(point)], input_.ring_of(point), 0);
    }

    void begin_round();
    uint32_t segment_count() const { return static_cast<uint32_t>(segments_.size()); }
    uint32_t part_count() const { return static_cast<uint32_t>(parts_.size()); }
    uint32_t vertex_count() const { return static_cast<uint32_t>(vertices_.size()); }
    uint32_t bucket(uint32_t segment) const;
    void add_head() { first_cut_.push_back(no_input_point); }
    bool sweep(uint32_t segment);
    void cut(uint32_t segment);
    bool end_round();
    void add_part_head() { first_part_.push_back(no_input_point); }
    void merge(uint32_t segment);

    void keep_if_it_separates(uint32_t part);
    void begin_regions();
    uint32_t from(uint32_t half) const { return half % 2 == 0 ? segments_[half / 2].a : segments_[half / 2].b; }
    void clear_half(uint32_t half) { cycle_of_[half] = no_input_point; }
    void set_fans(Groups fans) { fans_ = std::move(fans); }
    void sort_fan(uint32_t vertex);
    bool begin_cycle(uint32_t half);
    bool walk_cycle();
    uint32_t cycle_count() const { return static_cast<uint32_t>(cycles_.size()); }
    uint32_t outer_cycle_count() const { return static_cast<uint32_t>(outer_cycles_.size()); }
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
    void choose_region();
    bool begin_border(uint32_t half);
    bool walk_border();
    bool end_borders();
    Contour contour() const;

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
    bool is_before(uint32_t half, uint32_t other) const;
    bool is_inside(uint32_t cycle) const { return cycles_[cycle].outer != 0 && cycles_[cycle].hole == 0; }
    bool is_border(uint32_t half);
    void end_ring();
    void move_corners(const std::pmr::vector<uint32_t>& visits);
    [[noreturn]] void refuse() const;

    const Contour& input_;
    Memory* memory_;
    Point2 low_{};
    double cell_ = 0;
    std::pmr::vector<Cell> vertices_;
    std::pmr::vector<uint32_t> sources_;  // one a vertex: the input's point, or no_input_point
    std::pmr::unordered_map<uint64_t, uint32_t> vertex_of_;
    std::pmr::vector<Segment> segments_, parts_;
    std::pmr::vector<uint32_t> first_cut_;
    std::pmr::vector<Cut> cuts_;
    std::pmr::vector<uint32_t> active_;
    uint32_t active_at_ = 0;
    std::pmr::vector<uint32_t> chain_;
    std::pmr::vector<uint32_t> first_part_, next_part_;  // by vertex, and of the same vertex
    uint32_t rounds_ = 0, moves_ = 0;
    bool has_met_ = false;
    Groups fans_;                        // halves by the vertex that they begin at, counter-clockwise
    Buffer<uint32_t> place_, cycle_of_;  // by half
    std::pmr::vector<Cycle> cycles_;
    std::pmr::vector<uint32_t> outer_cycles_, stack_;
    uint32_t ray_edge_ = 0, nearest_ = no_input_point;
    long double nearest_x_ = 0, nearest_slope_ = 0;
    int64_t ray_outer_ = 0, ray_hole_ = 0;
    uint32_t walk_at_ = 0, walk_begin_ = 0;  // halves, on the way around a cycle or a ring
    std::optional<NodeClusters> regions_;
    uint32_t left_out_ = 0;  // regions that are not the largest
    Buffer<uint64_t> areas_;
    uint32_t best_ = no_input_point;
    std::pmr::vector<uint8_t> is_used_;
    std::pmr::vector<uint32_t> ring_vertices_, ring_begin_;
    uint32_t outer_ring_ = 0;
};

Repair::Repair(const Contour& rings, Memory* memory)
    : input_(rings),
      memory_(memory),
      vertices_(memory),
      sources_(memory),
      vertex_of_(memory),
      segments_(memory),
      parts_(memory),
      first_cut_(memory),
      cuts_(memory),
      active_(memory),
      chain_(memory),
      first_part_(memory),
      next_part_(memory),
      cycles_(memory),
      outer_cycles_(memory),
      stack_(memory),
      is_used_(memory),
      ring_vertices_(memory),
      ring_begin_(memory) {
    Point2 low = rings.points[0], high = low;
    for (const Point2& p : rings.points) {
        low = {std::min(low.x, p.x), std::min(low.y, p.y)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
    low_ = low;
    cell_ = std::ldexp(1, std::ilogb(std::hypot(high.x - low.x, high.y - low.y)) - grid_bits);
    const size_t likely = 2 * rings.points.size();
    vertex_of_.reserve(likely);
    vertices_.reserve(likely);
    segments_.reserve(likely);
    parts_.reserve(likely);
    for (auto* list : {&sources_, &first_cut_, &chain_, &first_part_, &next_part_}) list->reserve(likely);
}

uint32_t Repair::vertex_at(const Cell& cell, uint32_t source) {
    const auto key = key_of(static_cast<uint64_t>(cell.x), static_cast<uint64_t>(cell.y));
    const auto [found, is_new] = vertex_of_.try_emplace(key, static_cast<uint32_t>(vertices_.size()));
    if (is_new) {
        vertices_.push_back(cell);
        sources_.push_back(source);
    } else if (source != no_input_point) {
        has_met_ = true;  // two points of the input in one cell
    }
    return found->second;
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
    first_cut_.clear();
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
    first_cut_[segment] = static_cast<uint32_t>(cuts_.size()) - 1;
}

void Repair::cut(uint32_t segment) {
    const Segment s = segments_[segment];
    chain_.clear();
    for (uint32_t c = first_cut_[segment]; c != no_input_point; c = cuts_[c].next) chain_.push_back(cuts_[c].vertex);
    const Cell a = vertices_[s.a], b = vertices_[s.b];
    const auto along = [&](uint32_t v) {
        return (vertices_[v].x - a.x) * (b.x - a.x) + (vertices_[v].y - a.y) * (b.y - a.y);
    };
    std::sort(chain_.begin(), chain_.end(), [&](uint32_t u, uint32_t v) {
        const int64_t along_u = along(u), along_v = along(v);
        return along_u != along_v ? along_u < along_v : u < v;
    });
    chain_.push_back(s.b);
    uint32_t last = s.a;
    for (const uint32_t v : chain_) {
        if (v == last) continue;
        parts_.push_back({last, v, s.outer, s.hole});
        last = v;
    }
}

// False if something was cut: then there is another round.
bool Repair::end_round() {
    if (cuts_.empty()) {
        parts_.clear();
        first_part_.clear();
        next_part_.clear();
        return true;
    }
    has_met_ = true;
    segments_.swap(parts_);
    return false;
}

// Those between the same two vertices become one.
void Repair::merge(uint32_t segment) {
    Segment s = segments_[segment];
    if (s.a > s.b) s = {s.b, s.a, -s.outer, -s.hole};
    uint32_t same = first_part_[s.a];
    while (same != no_input_point && parts_[same].b != s.b) same = next_part_[same];
    if (same == no_input_point) {
        next_part_.push_back(first_part_[s.a]);
        first_part_[s.a] = static_cast<uint32_t>(parts_.size());
        parts_.push_back(s);
    } else {
        parts_[same].outer += s.outer;
        parts_[same].hole += s.hole;
        has_met_ = true;
    }
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

void Repair::sort_fan(uint32_t vertex) {
    uint32_t* const fan = fans_.items.data();
    const uint32_t begin = fans_.offsets[vertex], end = fans_.offsets[vertex + 1];
    std::sort(fan + begin, fan + end, [&](uint32_t a, uint32_t b) { return is_before(a, b); });
    for (uint32_t i = begin; i < end; ++i) place_[fan[i]] = i;
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
    const auto number = static_cast<uint32_t>(cycles_.size()) - 1;
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

void Repair::choose_region() {
    int64_t largest = min_area - 1;
    uint32_t count = 0;
    for (uint32_t c = 0; c < cycles_.size(); ++c) {
        const auto area = static_cast<int64_t>(areas_[c]);
        count += area >= min_area;
        if (area > largest) {
            largest = area;
            best_ = c;
        }
    }
    if (best_ == no_input_point) refuse();
    left_out_ += count - 1;
    is_used_.assign(2 * segments_.size(), 0);
    ring_vertices_.clear();
    ring_begin_.assign(1, 0);
}

bool Repair::is_border(uint32_t half) {
    const uint32_t left = cycle_of_[half];
    return is_inside(left) && !is_inside(cycle_of_[half ^ 1]) && regions_->first(left) == best_;
}

// False if no border begins there that was not walked.
bool Repair::begin_border(uint32_t half) {
    if (is_used_[half] != 0 || !is_border(half)) return false;
    walk_at_ = walk_begin_ = half;
    return true;
}

// Around the region's sectors at each vertex, so that rings are parted where it meets itself in a point. False after
// the last half.
bool Repair::walk_border() {
    is_used_[walk_at_] = 1;
    ring_vertices_.push_back(from(walk_at_));
    walk_at_ = clockwise(walk_at_ ^ 1);
    while (!is_border(walk_at_)) walk_at_ = clockwise(walk_at_);
    if (walk_at_ != walk_begin_) return true;
    end_ring();
    return false;
}

// Holes that can hardly be seen are left out.
void Repair::end_ring() {
    const uint32_t begin = ring_begin_.back(), end = static_cast<uint32_t>(ring_vertices_.size());
    uint64_t sum = 0;
    for (uint32_t i = begin; i < end; ++i) {
        const Cell &a = vertices_[ring_vertices_[i]], &b = vertices_[ring_vertices_[i + 1 == end ? begin : i + 1]];
        sum += twice_area_under(a, b);
    }
    const auto twice_area = static_cast<int64_t>(sum);
    if (std::abs(twice_area) < min_area) {
        ring_vertices_.resize(begin);
        return;
    }
    if (twice_area > 0) outer_ring_ = static_cast<uint32_t>(ring_begin_.size()) - 1;
    ring_begin_.push_back(end);
}

// False if corners had to be moved: then all of it is to be done again.
bool Repair::end_borders() {
    if (ring_begin_.size() < 2) refuse();
    std::pmr::vector<uint32_t> visits(vertices_.size(), 0, memory_);
    bool is_apart = true;
    for (const uint32_t v : ring_vertices_) is_apart &= ++visits[v] == 1;
    if (is_apart) return true;
    if (++moves_ > max_moves)
        throw Failure(FLG_ERROR_INVALID_ARGUMENT, "contour: it touches itself too often in one place to be repaired");
    move_corners(visits);
    return false;
}

// Into the region, by some cells; the rings are taken through all of it again.
void Repair::move_corners(const std::pmr::vector<uint32_t>& visits) {
    has_met_ = true;
    segments_.clear();
    chain_.clear();
    for (size_t r = 0; r + 1 < ring_begin_.size(); ++r) {
        const uint32_t begin = ring_begin_[r], end = ring_begin_[r + 1];
        for (uint32_t i = begin; i < end; ++i) {
            const uint32_t vertex = ring_vertices_[i];
            if (visits[vertex] == 1) {
                chain_.push_back(vertex);
                continue;
            }
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
        for (uint32_t i = begin; i < end; ++i) {
            const uint32_t a = chain_[i], b = chain_[i + 1 == end ? begin : i + 1];
            add_segment(a, b, static_cast<uint32_t>(r), outer_ring_);
        }
    }
    rounds_ = 0;
}

Contour Repair::contour() const {
    std::pmr::vector<Point2> points(memory_);
    std::pmr::vector<uint32_t> offsets(1, 0, memory_), sources(memory_);
    const auto add = [&](uint32_t ring) {
        for (uint32_t i = ring_begin_[ring]; i < ring_begin_[ring + 1]; ++i) {
            const uint32_t vertex = ring_vertices_[i], source = sources_[vertex];
            const Cell& cell = vertices_[vertex];
            points.push_back(has_met_ ? Point2{low_.x + cell_ * static_cast<double>(cell.x - margin),
                                               low_.y + cell_ * static_cast<double>(cell.y - margin)}
                                      : input_.points[source]);
            sources.push_back(source == no_input_point ? no_input_point : input_.input_points[source]);
        }
        offsets.push_back(static_cast<uint32_t>(points.size()));
    };
    add(outer_ring_);
    for (uint32_t r = 0; r + 1 < ring_begin_.size(); ++r) {
        if (r != outer_ring_) add(r);
    }
    Contour contour = clean_contour(points, offsets, memory_);
    for (uint32_t& point : contour.input_points) point = sources[point];
    contour.pieces_left_out = left_out_;
    return contour;
}

void Repair::refuse() const {
    throw Failure(FLG_ERROR_INVALID_ARGUMENT, "contour: its rings go around nothing that has an area");
}

// Edges get points where they meet, until none do; then those between the same two vertices become one.
Task<void> part_edges(Pace& pace, Repair& repair) {
    Slice slice(Cost::hundreds_of_ns);
    do {
        repair.begin_round();
        const uint32_t count = repair.segment_count();
        const auto bucket_of = [&](uint32_t i) { return repair.bucket(i); };
        const Groups order = co_await group_by(pace, count, count, bucket_of);
        co_await each(pace, count, Cost::some_ns, [&](uint32_t) { repair.add_head(); });
        for (const uint32_t segment : order.items) {
            do {
                if (slice.is_over()) co_await pace;
            } while (!repair.sweep(segment));
        }
        co_await each(pace, count, Cost::hundreds_of_ns, [&](uint32_t i) { repair.cut(i); });
    } while (!repair.end_round());
    co_await each(pace, repair.vertex_count(), Cost::some_ns, [&](uint32_t) { repair.add_part_head(); });
    co_await each(pace, repair.segment_count(), Cost::tens_of_ns, [&](uint32_t i) { repair.merge(i); });
    co_await each(pace, repair.part_count(), Cost::some_ns, [&](uint32_t i) { repair.keep_if_it_separates(i); });
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
    co_await each(pace, repair.vertex_count(), Cost::hundreds_of_ns, [&](uint32_t i) { repair.sort_fan(i); });
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
    repair.choose_region();
    for (uint32_t half = 0; half < halves; ++half) {
        bool is_walking = repair.begin_border(half);
        for (; is_walking; is_walking = repair.walk_border())
            if (slice.is_over()) co_await pace;
        if (slice.is_over()) co_await pace;
    }
}

}  // namespace

Task<Contour> repair_contour(Pace& pace, const Contour& rings) {
    Repair repair(rings, pace.memory());
    const auto count = static_cast<uint32_t>(rings.points.size());
    co_await each(pace, count, Cost::hundreds_of_ns, [&](uint32_t i) { repair.add_point(i); });
    co_await each(pace, count, Cost::tens_of_ns, [&](uint32_t i) { repair.add_segment(i); });
    do {
        co_await part_edges(pace, repair);
        co_await find_border(pace, repair);
    } while (!repair.end_borders());
    co_return repair.contour();
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
