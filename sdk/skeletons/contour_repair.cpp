// SPDX-License-Identifier: MIT
// Of the repair: edges get points where they meet, until none do.
#include "skeletons/contour_repair.h"

#include <algorithm>
#include <cmath>

#include "core/random.h"

namespace flg {

namespace {

constexpr int grid_bits = 26;
constexpr uint32_t pairs_a_unit = 8;
// Each bends edges by up to a cell; drawings take three.
constexpr uint32_t most_rounds = 60;

uint64_t key_of(uint64_t high, uint64_t low) {
    return high << 32 | low;
}

}  // namespace

ContourRepair::ContourRepair(const Contour& rings, Memory* memory)
    : input_(rings),
      memory_(memory),
      vertices_(memory),
      sources_(memory),
      vertex_of_(memory),
      segments_(memory),
      parts_(memory),
      first_cut_(memory),
      cuts_(memory),
      bucket_begin_(memory),
      order_(memory),
      active_(memory),
      chain_(memory),
      first_part_(memory),
      next_part_(memory),
      fan_begin_(memory),
      fan_(memory),
      place_(memory),
      cycle_of_(memory),
      cycles_(memory),
      outer_cycles_(memory),
      stack_(memory),
      areas_(memory),
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
    for (auto* list : {&sources_, &order_, &bucket_begin_, &first_cut_, &chain_, &first_part_, &next_part_})
        list->reserve(likely);
}

void ContourRepair::step() {
    switch (pass_) {
        case Pass::points: add_point(); break;
        case Pass::segments: add_segment(); break;
        case Pass::begin_round: begin_round(); break;
        case Pass::zero:
            bucket_begin_.push_back(0);
            next_of(segments_.size() + 2, Pass::count);
            break;
        case Pass::count:
            ++bucket_begin_[bucket(segments_[at_]) + 2];
            first_cut_.push_back(no_point);
            next_of(segments_.size(), Pass::sum);
            break;
        case Pass::sum:
            bucket_begin_[at_ + 1] += bucket_begin_[at_];
            order_.push_back(0);
            next_of(segments_.size() + 1, Pass::list);
            break;
        case Pass::list:
            order_[bucket_begin_[bucket(segments_[at_]) + 1]++] = at_;
            next_of(segments_.size(), Pass::sweep);
            break;
        case Pass::sweep: sweep(); break;
        case Pass::cut: cut(); break;
        case Pass::end_round: end_round(); break;
        case Pass::heads:
            first_part_.push_back(no_point);
            next_of(vertices_.size(), Pass::merge);
            break;
        case Pass::merge: merge(); break;
        case Pass::done: break;
        default: step_region(); break;
    }
}

uint32_t ContourRepair::vertex_at(const Cell& cell, uint32_t source) {
    const auto key = key_of(static_cast<uint64_t>(cell.x), static_cast<uint64_t>(cell.y));
    const auto [found, is_new] = vertex_of_.try_emplace(key, static_cast<uint32_t>(vertices_.size()));
    if (is_new) {
        vertices_.push_back(cell);
        sources_.push_back(source);
    } else if (source != no_point) {
        has_met_ = true;  // two points of the input in one cell
    }
    return found->second;
}

void ContourRepair::add_point() {
    const Point2& p = input_.points[at_];
    chain_.push_back(
        vertex_at({std::llround((p.x - low_.x) / cell_) + margin, std::llround((p.y - low_.y) / cell_) + margin}, at_));
    next_of(input_.points.size(), Pass::segments);
}

void ContourRepair::add_segment() {
    add_segment(chain_[at_], chain_[input_.next(at_)], input_.ring_of(at_), 0);
    next_of(input_.points.size(), Pass::begin_round);
}

void ContourRepair::add_segment(uint32_t a, uint32_t b, uint32_t ring, uint32_t outer_ring) {
    const bool is_outer = ring == outer_ring;
    if (a != b) segments_.push_back({a, b, is_outer, is_outer ? 0 : static_cast<int64_t>(mix64(ring) >> 24 | 1)});
}

void ContourRepair::begin_round() {
    if (segments_.size() < 3) refuse();
    if (++rounds_ > most_rounds)
        throw Failure(FLG_ERROR_INVALID_ARGUMENT, "contour: it crosses itself too often in one place to be repaired");
    bucket_begin_.clear();
    order_.clear();
    first_cut_.clear();
    cuts_.clear();
    active_.clear();
    parts_.clear();
    active_at_ = 0;
    enter(Pass::zero);
}

// By where it begins from the left, as many as there are edges.
uint32_t ContourRepair::bucket(const Segment& segment) const {
    const int64_t left = std::min(vertices_[segment.a].x, vertices_[segment.b].x);
    return static_cast<uint32_t>(left * static_cast<int64_t>(segments_.size()) >> (grid_bits + 2));
}

// The edge at hand against those that began before it and are not over.
void ContourRepair::sweep() {
    const uint32_t first = order_[at_];
    const Segment& s = segments_[first];
    const int64_t left = std::min(vertices_[s.a].x, vertices_[s.b].x);
    // The others of its bucket may begin before it, by no more than the bucket is wide.
    const int64_t bucket_width = (int64_t{1} << (grid_bits + 2)) / static_cast<int64_t>(segments_.size()) + 1;
    for (uint32_t i = 0; i < pairs_a_unit; ++i) {
        if (active_at_ == active_.size()) {
            active_.push_back(first);
            active_at_ = 0;
            next_of(segments_.size(), Pass::cut);
            return;
        }
        const Segment& other = segments_[active_[active_at_]];
        if (std::max(vertices_[other.a].x, vertices_[other.b].x) + bucket_width + 1 < left) {
            active_[active_at_] = active_.back();
            active_.pop_back();
        } else {
            meet(first, active_[active_at_++]);
        }
    }
}

void ContourRepair::meet(uint32_t first, uint32_t second) {
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
    const uint32_t vertex = vertex_at(at, no_point);
    cut_at(first, vertex);
    cut_at(second, vertex);
}

int64_t ContourRepair::turn(const Cell& a, const Cell& b, const Cell& c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

// If the vertex is nearer than a cell to the inside of an edge.
bool ContourRepair::lead_through(uint32_t segment, uint32_t vertex) {
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

void ContourRepair::cut_at(uint32_t segment, uint32_t vertex) {
    const Segment& s = segments_[segment];
    if (vertex == s.a || vertex == s.b) return;
    cuts_.push_back({vertex, first_cut_[segment]});
    first_cut_[segment] = static_cast<uint32_t>(cuts_.size()) - 1;
}

void ContourRepair::cut() {
    const Segment s = segments_[at_];
    chain_.clear();
    for (uint32_t c = first_cut_[at_]; c != no_point; c = cuts_[c].next) chain_.push_back(cuts_[c].vertex);
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
    next_of(segments_.size(), Pass::end_round);
}

void ContourRepair::end_round() {
    if (cuts_.empty()) {
        parts_.clear();
        first_part_.clear();
        next_part_.clear();
        enter(Pass::heads);
    } else {
        has_met_ = true;
        segments_.swap(parts_);
        enter(Pass::begin_round);
    }
}

// Those between the same two vertices become one.
void ContourRepair::merge() {
    Segment s = segments_[at_];
    if (s.a > s.b) s = {s.b, s.a, -s.outer, -s.hole};
    uint32_t same = first_part_[s.a];
    while (same != no_point && parts_[same].b != s.b) same = next_part_[same];
    if (same == no_point) {
        next_part_.push_back(first_part_[s.a]);
        first_part_[s.a] = static_cast<uint32_t>(parts_.size());
        parts_.push_back(s);
    } else {
        parts_[same].outer += s.outer;
        parts_[same].hole += s.hole;
        has_met_ = true;
    }
    next_of(segments_.size(), Pass::halves);
}

}  // namespace flg
