// SPDX-License-Identifier: MIT
#include "surfaces/geodesic_path.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace flg {

namespace {

double angle_between(const Vec2& a, const Vec2& b) {
    return std::atan2(std::abs(cross(a, b)), a.dot(b));
}

// The vertices of what a place lies on, rising; returns how many.
uint32_t vertices_around(const Mesh& mesh, const SurfacePlace& place, std::array<uint32_t, 3>& out) {
    uint32_t count = 0;
    switch (place.on) {
        case SurfacePlace::On::vertex: out[count++] = place.index; break;
        case SurfacePlace::On::edge:
            out[count++] = mesh.vertex_at(place.index);
            out[count++] = mesh.vertex_at(next_corner(place.index));
            break;
        case SurfacePlace::On::triangle:
            for (uint32_t vertex : mesh.triangles[place.index]) out[count++] = vertex;
            break;
    }
    std::sort(out.begin(), out.begin() + count);
    return count;
}

IntegralCurveOptions descent_to(const Mesh& mesh, const SurfacePlace& to, std::array<uint32_t, 3>& targets) {
    IntegralCurveOptions options;
    options.downhill = true;
    options.along_borders = true;
    options.targets = {targets.data(), vertices_around(mesh, to, targets)};
    return options;
}

}  // namespace

GeodesicPathKernel::GeodesicPathKernel(const Mesh& mesh, const SurfacePoint& from, const SurfacePoint& to,
                                       std::span<const float> distances, const RegionSet& regions, SurfaceCurves& out,
                                       Memory* memory)
    : mesh_(mesh),
      regions_(regions),
      start_(from),
      from_(place_in(mesh, from)),
      to_(place_in(mesh, to)),
      out_(out),
      traced_(memory),
      trace_(mesh, distances, regions, {&start_, 1}, descent_to(mesh, to_, targets_), traced_, memory),
      sleeves_{{mesh, regions, from_, to_, memory}, {mesh, regions, from_, to_, memory}},
      funnel_(mesh, memory),
      flips_(memory) {
    // Where both are in one triangle there is nothing to trace.
    if (is_open(from.triangle)) {
        sleeve_->enter(from.triangle);
        if (sleeve_->is_complete()) begin_unfold();
    }
}

// Every stretch of the way down is in one triangle; what lies between two of them shares their common point.
void GeodesicPathKernel::begin_follow() {
    sleeve_->clear();
    if (traced_.curve_count() > 0) {
        sleeve_->enter(traced_.points[0].triangle);
        pass_ = Pass::follow;
        at_ = 1;
        return;
    }
    // The start is an end of the way down already.
    if (from_.on == SurfacePlace::On::vertex) {
        const Corner first = mesh_.corner_of_vertex[from_.index];
        Corner corner = first;
        do {
            if (is_open(triangle_of(corner))) {
                sleeve_->enter(triangle_of(corner));
                break;
            }
            corner = mesh_.turn(corner);
        } while (corner != first && corner != no_index);
    } else if (is_open(start_.triangle)) {
        sleeve_->enter(start_.triangle);
    }
    if (sleeve_->size() > 0) {
        follow_to_end(from_);
    } else {
        pass_ = Pass::done;
    }
}

void GeodesicPathKernel::follow_point() {
    const SurfacePlace place = place_in(mesh_, traced_.points[at_]);
    const bool is_last = at_ + 1 == traced_.points.size();
    if (is_last || sleeve_->is_complete()) {
        follow_to_end(place);
    } else if (place.on == SurfacePlace::On::vertex) {
        uint32_t cost = 0;
        if (!sleeve_->turn_to(place.index, traced_.points[at_].triangle, cost)) pass_ = Pass::done;
        charge(cost);
    } else {
        sleeve_->enter(traced_.points[at_].triangle);
    }
    ++at_;
}

// The way down ends at a vertex of what the end lies on, or on an edge between two that are equally far.
void GeodesicPathKernel::follow_to_end(const SurfacePlace& last) {
    const auto enter_if_open = [&](Corner corner) {
        if (corner != no_index && is_open(triangle_of(corner))) sleeve_->enter(triangle_of(corner));
    };
    if (last.on == SurfacePlace::On::edge) {
        enter_if_open(last.index);
        enter_if_open(mesh_.opposite(last.index));
    } else if (!sleeve_->is_complete() && trace_.ends().front().stop == IntegralCurveStop::target) {
        uint32_t triangle = to_.on == SurfacePlace::On::triangle ? to_.index : triangle_of(to_.index);
        if (to_.on == SurfacePlace::On::edge && !is_open(triangle)) triangle = mesh_.neighbour_at(to_.index);
        uint32_t cost = 0;
        if (triangle != no_index) sleeve_->turn_to(last.index, triangle, cost);
        charge(cost);
    }
    if (sleeve_->is_complete()) {
        begin_unfold();
    } else {
        pass_ = Pass::done;
    }
}

void GeodesicPathKernel::begin_unfold() {
    found_ = true;
    funnel_.begin(*sleeve_, from_, to_);
    pass_ = Pass::unfold;
}

// Of the gates that end at the bend, which follow each other.
uint32_t GeodesicPathKernel::last_gate_at(const PathBend& bend) const {
    const uint32_t vertex = funnel_.end_vertex(bend.gate, bend.at_left);
    uint32_t last = bend.gate;
    while (last + 1 < funnel_.gates().size() && funnel_.end_vertex(last + 1, bend.at_left) == vertex) ++last;
    return last;
}

double GeodesicPathKernel::corner_angle(uint32_t triangle, uint32_t vertex) const {
    const Triple& t = mesh_.triangles[triangle];
    const uint32_t k = t[0] == vertex ? 0 : t[1] == vertex ? 1 : 2;
    const Vec3 at = mesh_.position(vertex);
    const Vec3 a = mesh_.position(t[(k + 1) % 3]) - at, b = mesh_.position(t[(k + 2) % 3]) - at;
    return std::atan2(a.cross(b).norm(), a.dot(b));
}

// Whether the path's angle at the bend, on the side that the sleeve does not cover, is less than straight.
bool GeodesicPathKernel::is_shorter_around(uint32_t index, Flip& flip) {
    const PathBend& bend = funnel_.bends()[index];
    const uint32_t vertex = funnel_.end_vertex(bend.gate, bend.at_left);
    const uint32_t last_gate = last_gate_at(bend);
    // The sleeve turns about a vertex on its left counter-clockwise.
    flip = {bend.gate, last_gate + 1, vertex, !bend.at_left};
    const uint32_t first = (*sleeve_)[flip.first], last = (*sleeve_)[flip.last];
    charge(flip.last - flip.first);
    if (first == last) return true;  // the sleeve goes all the way around

    const Vec2 before = (index == 0 ? funnel_.start() : funnel_.bends()[index - 1].at) - bend.at;
    const Vec2 after = funnel_.bends()[index + 1].at - bend.at;
    const auto along_gate = [&](uint32_t gate) -> Vec2 {
        const SleeveGate& g = funnel_.gates()[gate];
        return (bend.at_left ? g.right : g.left) - bend.at;
    };
    double angle = corner_angle(first, vertex) - angle_between(before, along_gate(bend.gate)) +
                   corner_angle(last, vertex) - angle_between(after, along_gate(last_gate));
    constexpr double straight = std::numbers::pi - angle_tolerance;
    uint32_t triangle = next_about(mesh_, regions_, vertex, first, flip.counter_clockwise);
    for (; angle < straight && triangle != last; charge(1)) {
        if (triangle == no_index) return false;
        angle += corner_angle(triangle, vertex);
        triangle = next_about(mesh_, regions_, vertex, triangle, flip.counter_clockwise);
    }
    return angle < straight;
}

void GeodesicPathKernel::test_bend() {
    if (at_ + 1 < funnel_.bends().size()) {
        Flip flip{};
        const bool is_free = flips_.size() == 0 || flips_.back().last <= funnel_.bends()[at_].gate;
        if (is_free && is_shorter_around(at_, flip)) flips_.push_back(flip);
        ++at_;
        return;
    }
    at_ = item_at_ = 0;
    length_ = funnel_.length();
    idle_rounds_ = length_ < shortest_ ? 0 : idle_rounds_ + 1;
    shortest_ = std::min(shortest_, length_);
    if (flips_.size() > 0 && idle_rounds_ < max_idle_rounds) {
        flipped_->clear();
        pass_ = Pass::flip;
        return;
    }
    if (from_ == to_) {
        pass_ = Pass::done;
        return;
    }
    straight_from_ = funnel_.start();
    drawn_ = from_;
    drawn_triangle_ = (*sleeve_)[0];
    if (out_.points.size() > out_.offsets.back()) out_.points.pop_back();
    pass_ = Pass::draw;
}

void GeodesicPathKernel::flip_next() {
    flipped_->enter((*sleeve_)[at_]);
    if (!flipped_->is_complete() && item_at_ < flips_.size() && flips_[item_at_].first == at_) {
        const Flip& flip = flips_[item_at_++];
        const uint32_t before = flipped_->size();
        flipped_->turn(flip.vertex, flip.counter_clockwise, (*sleeve_)[flip.last]);
        charge(std::max(flipped_->size(), before) - before);
        at_ = flip.last;
    } else {
        ++at_;
    }
    if (flipped_->is_complete()) {
        std::swap(sleeve_, flipped_);
        begin_unfold();
    }
}

// Draws a place a step late: several gates may be crossed at the same vertex.
void GeodesicPathKernel::pass_through(const SurfacePlace& place, uint32_t triangle) {
    if (place != drawn_) {
        SurfacePoint point{};
        find_in(mesh_, drawn_, drawn_triangle_, point);
        out_.points.push_back(point);
        drawn_ = place;
    }
    drawn_triangle_ = triangle;
}

void GeodesicPathKernel::draw_next() {
    const PathBend& bend = funnel_.bends()[item_at_];
    if (at_ < bend.gate) {
        const SleeveGate& gate = funnel_.gates()[at_++];
        const Vec2 way = bend.at - straight_from_;
        const double t = cross(straight_from_ - gate.right, way) / cross(gate.left - gate.right, way);
        // Not a number only where the gate has no length or lies along the path: any of its points will do.
        const double snapped = !(t >= snap_weight) ? 0 : t > 1 - snap_weight ? 1 : t;
        pass_through(place_on_edge(mesh_, gate.corner, snapped), (*sleeve_)[at_]);
    } else if (item_at_ + 1 < funnel_.bends().size()) {
        // On to the next bend along a gate's edge, or beyond the last gate that ends here.
        const uint32_t next = std::min(last_gate_at(bend), funnel_.bends()[item_at_ + 1].gate);
        charge(next - at_ + 1);
        pass_through(place_at_vertex(funnel_.end_vertex(bend.gate, bend.at_left)), (*sleeve_)[next + 1]);
        straight_from_ = bend.at;
        at_ = std::min(next + 1, funnel_.bends()[++item_at_].gate);
    } else {
        const uint32_t triangle = drawn_triangle_;
        pass_through(to_, triangle);
        SurfacePoint last{};
        find_in(mesh_, to_, triangle, last);
        out_.points.push_back(last);
        pass_ = Pass::done;
    }
}

bool GeodesicPathKernel::run(uint32_t count) {
    units_ = count;
    while (units_ > 0 && pass_ != Pass::done) {
        switch (pass_) {
            case Pass::trace: {
                // A step there costs as much as a few here.
                const uint32_t steps = units_ / 6 + 1;
                if (trace_.run(steps)) begin_follow();
                units_ = 0;
                break;
            }
            case Pass::follow: follow_point(); break;
            case Pass::unfold:
                if (funnel_.run(units_)) {
                    pass_ = Pass::test_bends;
                    flips_.clear();
                    at_ = 0;
                }
                break;
            case Pass::test_bends: test_bend(); break;
            case Pass::flip: flip_next(); break;
            case Pass::draw: draw_next(); break;
            case Pass::done: break;
        }
        charge(1);
    }
    return pass_ == Pass::done;
}

bool end_polyline(SurfaceCurves& out, bool closed, double length) {
    const uint32_t first = out.offsets.back();
    if (closed && out.points.size() > first) out.points.pop_back();
    const auto end = static_cast<uint32_t>(out.points.size());
    if (end - first < (closed ? 3 : 2)) {
        out.points.resize(first);
        return false;
    }
    out.offsets.push_back(end);
    out.closed.push_back(closed);
    out.values.push_back(static_cast<float>(length));
    return true;
}

}  // namespace flg
