// SPDX-License-Identifier: MIT
// Of the repair: the faces between edges that do not meet, what rings wind around them, and the border of the largest
// region.
#include <algorithm>
#include <cmath>

#include "skeletons/contour_repair.h"

namespace flg {

namespace {

constexpr uint32_t edges_a_unit = 8;
constexpr int64_t least_area = 10'000;  // twice, in cells: about a millionth of the drawing wide and high
constexpr double corner_step = 8;       // cells
constexpr uint32_t most_moves = 8;

bool is_upper(int64_t x, int64_t y) {
    return y > 0 || (y == 0 && x > 0);
}

}  // namespace

void ContourRepair::step_region() {
    const size_t halves = 2 * segments_.size();
    switch (pass_) {
        case Pass::halves: {
            // Edges that are drawn as often one way as the other separate nothing.
            if (at_ == 0) segments_.clear();
            if (parts_[at_].outer != 0 || parts_[at_].hole != 0) segments_.push_back(parts_[at_]);
            next_of(parts_.size(), Pass::clear);
            if (pass_ == Pass::clear) begin_regions();
            break;
        }
        case Pass::clear:
            if (at_ < vertices_.size() + 2) fan_begin_.push_back(0);
            if (at_ < halves) {
                fan_.push_back(0);
                place_.push_back(0);
                cycle_of_.push_back(no_point);
            }
            next_of(std::max(halves, vertices_.size() + 2), Pass::degrees);
            break;
        case Pass::degrees:
            for (const uint32_t vertex : {segments_[at_].a, segments_[at_].b}) ++fan_begin_[vertex + 2];
            next_of(segments_.size(), Pass::sum_degrees);
            break;
        case Pass::sum_degrees:
            fan_begin_[at_ + 1] += fan_begin_[at_];
            next_of(fan_begin_.size() - 1, Pass::fan);
            break;
        case Pass::fan:
            fan_[fan_begin_[from(at_) + 1]++] = at_;
            next_of(halves, Pass::sort);
            break;
        case Pass::sort:
            std::sort(fan_.begin() + fan_begin_[at_], fan_.begin() + fan_begin_[at_ + 1],
                      [&](uint32_t a, uint32_t b) { return is_before(a, b); });
            for (uint32_t i = fan_begin_[at_]; i < fan_begin_[at_ + 1]; ++i) place_[fan_[i]] = i;
            next_of(vertices_.size(), Pass::cycles);
            break;
        case Pass::cycles: walk_cycle(); break;
        case Pass::rays: shoot(); break;
        case Pass::spread: spread(); break;
        case Pass::join: join_regions(); break;
        case Pass::sizes: measure_regions(); break;
        case Pass::borders: walk_border(); break;
        default: break;
    }
}

void ContourRepair::begin_regions() {
    if (segments_.empty()) refuse();
    fan_begin_.clear();
    fan_begin_.reserve(vertices_.size() + 2);
    for (auto* list : {&fan_, &place_, &cycle_of_}) {
        list->clear();
        list->reserve(2 * segments_.size());
    }
    cycles_.clear();
    outer_cycles_.clear();
}

// Counter-clockwise by direction.
bool ContourRepair::is_before(uint32_t half, uint32_t other) const {
    const Cell &o = vertices_[from(half)], &p = vertices_[to(half)], &q = vertices_[to(other)];
    const bool first_upper = is_upper(p.x - o.x, p.y - o.y), second_upper = is_upper(q.x - o.x, q.y - o.y);
    return first_upper != second_upper ? first_upper : turn(o, p, q) > 0;
}

// The half that begins where this one does, next to its right.
uint32_t ContourRepair::clockwise(uint32_t half) const {
    const uint32_t vertex = from(half), i = place_[half];
    return fan_[i == fan_begin_[vertex] ? fan_begin_[vertex + 1] - 1 : i - 1];
}

uint64_t ContourRepair::twice_area_under(const Cell& a, const Cell& b) {
    return static_cast<uint64_t>((a.x - area_origin) * (b.y - area_origin) - (b.x - area_origin) * (a.y - area_origin));
}

// Halves around a face, which is on their left. Outer cycles, around whole parts of the drawing, turn clockwise.
void ContourRepair::walk_cycle() {
    if (walk_at_ == no_point) {
        if (cycle_of_[at_] == no_point) {
            cycles_.push_back({0, from(at_), at_, no_point, 0, 0, false});
            walk_at_ = at_;
        } else if (++at_ == cycle_of_.size()) {
            begin_rays();
        }
        return;
    }
    const auto number = static_cast<uint32_t>(cycles_.size()) - 1;
    Cycle& cycle = cycles_[number];
    const Cell &a = vertices_[from(walk_at_)], &b = vertices_[to(walk_at_)], &left = vertices_[cycle.leftmost];
    cycle.twice_area += twice_area_under(a, b);
    if (a.x < left.x || (a.x == left.x && a.y < left.y)) cycle.leftmost = from(walk_at_);
    cycle_of_[walk_at_] = number;
    walk_at_ = clockwise(walk_at_ ^ 1);
    if (walk_at_ != cycle.begin) return;
    walk_at_ = no_point;
    if (static_cast<int64_t>(cycle.twice_area) < 0) outer_cycles_.push_back(number);
}

void ContourRepair::begin_rays() {
    enter(Pass::rays);
    ray_edge_ = 0;
    nearest_ = no_point;
    ray_outer_ = ray_hole_ = 0;
}

// From an outer cycle's leftmost vertex to the left: what winds around it, and the face that it is in.
void ContourRepair::shoot() {
    Cycle& cycle = cycles_[outer_cycles_[at_]];
    const Cell p = vertices_[cycle.leftmost];
    for (uint32_t i = 0; i < edges_a_unit && ray_edge_ < segments_.size(); ++i, ++ray_edge_) {
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
        if (nearest_ != no_point && (x < nearest_x_ || (x == nearest_x_ && slope <= nearest_slope_))) continue;
        nearest_slope_ = slope;
        nearest_ = 2 * ray_edge_ + rises;  // the half that falls
        nearest_x_ = x;
    }
    if (ray_edge_ < segments_.size()) return;
    cycle.outer = ray_outer_;
    cycle.hole = ray_hole_;
    cycle.is_known = true;
    cycle.container = nearest_ == no_point ? no_point : cycle_of_[nearest_];
    stack_.push_back(outer_cycles_[at_]);
    const uint32_t next = at_ + 1;
    begin_rays();
    at_ = next;
    if (at_ == outer_cycles_.size()) enter(Pass::spread);
}

// From a cycle that is known to those across its edges.
void ContourRepair::spread() {
    if (walk_at_ == no_point) {
        if (stack_.empty()) {
            begin_join();
            return;
        }
        walk_at_ = cycles_[stack_.back()].begin;
        walk_begin_ = walk_at_;
        stack_.pop_back();
    }
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
    if (walk_at_ == walk_begin_) walk_at_ = no_point;
}

void ContourRepair::begin_join() {
    enter(Pass::join);
    regions_.emplace(cycles_.size(), memory_);
    for (uint32_t c = 0; c < cycles_.size(); ++c) regions_->begin(c);
    areas_.assign(cycles_.size(), 0);
    best_ = no_point;
}

void ContourRepair::join_regions() {
    const uint32_t left = cycle_of_[2 * at_], right = cycle_of_[2 * at_ + 1];
    if (is_inside(left) && is_inside(right)) regions_->join(left, right);
    if (at_ < outer_cycles_.size()) {
        const uint32_t outer = outer_cycles_[at_], container = cycles_[outer].container;
        if (container != no_point && is_inside(outer)) regions_->join(outer, container);
    }
    next_of(segments_.size(), Pass::sizes);
}

void ContourRepair::measure_regions() {
    if (is_inside(at_)) {
        const uint32_t region = regions_->first(at_);
        areas_[region] += cycles_[at_].twice_area;
    }
    if (++at_ < cycles_.size()) return;
    int64_t most = least_area - 1;
    for (uint32_t c = 0; c < cycles_.size(); ++c) {
        if (const auto area = static_cast<int64_t>(areas_[c]); area > most) {
            most = area;
            best_ = c;
        }
    }
    if (best_ == no_point) refuse();
    enter(Pass::borders);
    is_used_.assign(2 * segments_.size(), 0);
    ring_vertices_.clear();
    ring_begin_.assign(1, 0);
}

bool ContourRepair::is_border(uint32_t half) {
    const uint32_t left = cycle_of_[half];
    return is_inside(left) && !is_inside(cycle_of_[half ^ 1]) && regions_->first(left) == best_;
}

// Around the region's sectors at each vertex, so that rings are parted where it meets itself in a point.
void ContourRepair::walk_border() {
    if (walk_at_ == no_point) {
        if (is_used_[at_] == 0 && is_border(at_)) {
            walk_at_ = walk_begin_ = at_;
        } else if (++at_ == is_used_.size()) {
            end_borders();
        }
        return;
    }
    is_used_[walk_at_] = 1;
    ring_vertices_.push_back(from(walk_at_));
    walk_at_ = clockwise(walk_at_ ^ 1);
    while (!is_border(walk_at_)) walk_at_ = clockwise(walk_at_);
    if (walk_at_ != walk_begin_) return;
    walk_at_ = no_point;
    end_ring();
}

// Holes that can hardly be seen are left out.
void ContourRepair::end_ring() {
    const uint32_t begin = ring_begin_.back(), end = static_cast<uint32_t>(ring_vertices_.size());
    uint64_t sum = 0;
    for (uint32_t i = begin; i < end; ++i) {
        const Cell &a = vertices_[ring_vertices_[i]], &b = vertices_[ring_vertices_[i + 1 == end ? begin : i + 1]];
        sum += twice_area_under(a, b);
    }
    const auto twice_area = static_cast<int64_t>(sum);
    if (std::abs(twice_area) < least_area) {
        ring_vertices_.resize(begin);
        return;
    }
    if (twice_area > 0) outer_ring_ = static_cast<uint32_t>(ring_begin_.size()) - 1;
    ring_begin_.push_back(end);
}

void ContourRepair::end_borders() {
    if (ring_begin_.size() < 2) refuse();
    std::pmr::vector<uint32_t> visits(vertices_.size(), 0, memory_);
    bool is_apart = true;
    for (const uint32_t v : ring_vertices_) is_apart &= ++visits[v] == 1;
    if (is_apart) {
        pass_ = Pass::done;
        return;
    }
    if (++moves_ > most_moves)
        throw Failure(FLG_ERROR_INVALID_ARGUMENT, "contour: it touches itself too often in one place to be repaired");
    move_corners(visits);
}

// Into the region, by some cells; the rings are taken through all of it again.
void ContourRepair::move_corners(const std::pmr::vector<uint32_t>& visits) {
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
            chain_.push_back(vertex_at({v.x + std::llround(step * x), v.y + std::llround(step * y)}, no_point));
        }
        for (uint32_t i = begin; i < end; ++i) {
            const uint32_t a = chain_[i], b = chain_[i + 1 == end ? begin : i + 1];
            add_segment(a, b, static_cast<uint32_t>(r), outer_ring_);
        }
    }
    rounds_ = 0;
    enter(Pass::begin_round);
}

Contour ContourRepair::take_contour() {
    std::pmr::vector<Point2> points(memory_);
    std::pmr::vector<uint32_t> offsets(1, 0, memory_), sources(memory_);
    const auto add = [&](uint32_t ring) {
        for (uint32_t i = ring_begin_[ring]; i < ring_begin_[ring + 1]; ++i) {
            const uint32_t vertex = ring_vertices_[i], source = sources_[vertex];
            const Cell& cell = vertices_[vertex];
            points.push_back(has_met_ ? Point2{low_.x + cell_ * static_cast<double>(cell.x - margin),
                                               low_.y + cell_ * static_cast<double>(cell.y - margin)}
                                      : input_.points[source]);
            sources.push_back(source == no_point ? no_point : input_.input_points[source]);
        }
        offsets.push_back(static_cast<uint32_t>(points.size()));
    };
    add(outer_ring_);
    for (uint32_t r = 0; r + 1 < ring_begin_.size(); ++r) {
        if (r != outer_ring_) add(r);
    }
    Contour contour = clean_contour(points, offsets, memory_);
    for (uint32_t& point : contour.input_points) point = sources[point];
    return contour;
}

void ContourRepair::refuse() const {
    throw Failure(FLG_ERROR_INVALID_ARGUMENT, "contour: its rings go around nothing that has an area");
}

}  // namespace flg
