// SPDX-License-Identifier: MIT
#include "surfaces/integral_curves.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace flg {

IntegralCurveKernel::IntegralCurveKernel(const Mesh& mesh, std::span<const float> values, const RegionSet& regions,
                                         std::span<const SurfacePoint> starts, const IntegralCurveOptions& options,
                                         SurfaceCurves& out, Memory* memory)
    : field_(mesh, values, regions, options.downhill),
      starts_(starts),
      options_(options),
      end_height_(!options.level     ? std::numeric_limits<double>::infinity()
                  : options.downhill ? -double{*options.level}
                                     : double{*options.level}),
      out_(out),
      ends_(memory),
      plateau_(memory) {}

void IntegralCurveKernel::begin_curve() {
    const SurfacePoint& start = starts_[ends_.size()];
    tracing_ = true;
    place_ = place_in(field_.mesh(), start.triangle, weights_of(start));
    may_leave_border_ = true;
    last_triangle_ = no_index;
    const double height = field_.height(place_);
    if (!std::isfinite(height)) {
        end_curve(IntegralCurveStop::border);
    } else if (height >= end_height_) {
        end_curve(IntegralCurveStop::level);
    } else {
        arrive();
    }
}

void IntegralCurveKernel::end_curve(IntegralCurveStop stop) {
    tracing_ = false;
    if (last_triangle_ == no_index) {
        ends_.push_back({stop, no_index});
        return;
    }
    SurfacePoint last{};
    find_in(field_.mesh(), place_, last_triangle_, last);
    out_.points.push_back(last);
    out_.offsets.push_back(static_cast<uint32_t>(out_.points.size()));
    out_.closed.push_back(false);
    const double height = field_.height(place_);
    out_.values.push_back(static_cast<float>(options_.downhill ? -height : height));
    ends_.push_back({stop, out_.curve_count() - 1});
}

// Ends the curve if the vertex it has come to is a target.
void IntegralCurveKernel::arrive() {
    if (place_.on == SurfacePlace::On::vertex && is_target(place_.index)) end_curve(IntegralCurveStop::target);
}

bool IntegralCurveKernel::is_target(uint32_t vertex) const {
    return std::binary_search(options_.targets.begin(), options_.targets.end(), vertex);
}

void IntegralCurveKernel::move_to(uint32_t triangle, const SurfacePlace& to) {
    SurfacePoint point{};
    find_in(field_.mesh(), place_, triangle, point);
    out_.points.push_back(point);
    last_triangle_ = triangle;
    place_ = to;
}

// Returns the units it took.
uint32_t IntegralCurveKernel::advance() {
    const Mesh& mesh = field_.mesh();
    const IntegralCurveStep step = next_step(field_, place_);
    const bool came_to_border = place_.on == SurfacePlace::On::vertex && step.at_border && !may_leave_border_;
    if (!options_.along_borders && (came_to_border || step.leaves)) {
        end_curve(IntegralCurveStop::border);
        return step.cost;
    }
    if (!step.rises) {
        begin_plateau(step.at_border ? IntegralCurveStop::border : IntegralCurveStop::extremum);
        return step.cost;
    }
    may_leave_border_ = false;
    const double from = field_.height(place_), to = field_.height(step.to);
    if (to > end_height_) {
        // Straight on to where the level is, in the same triangle.
        SurfacePoint a{}, b{};
        find_in(mesh, place_, step.triangle, a);
        find_in(mesh, step.to, step.triangle, b);
        const Weights at_a = weights_of(a), at_b = weights_of(b);
        const double part = (end_height_ - from) / (to - from);
        Weights weights;
        for (uint32_t k = 0; k < 3; ++k) weights[k] = at_a[k] + part * (at_b[k] - at_a[k]);
        const SurfacePlace end = place_in(mesh, step.triangle, weights);
        SurfacePoint at_end{};
        find_in(mesh, end, step.triangle, at_end);
        // Snapping may leave nothing of the way.
        if (weights_of(at_end) != at_a) move_to(step.triangle, end);
        end_curve(IntegralCurveStop::level);
        return step.cost;
    }
    move_to(step.triangle, step.to);
    if (to == end_height_) {
        end_curve(IntegralCurveStop::level);
    } else {
        arrive();
    }
    return step.cost;
}

void IntegralCurveKernel::add_to_plateau(uint32_t vertex, uint32_t from, uint32_t triangle) {
    if (plateau_.size() == plateau_limit || field_.height(vertex) != field_.height(place_)) return;
    for (const PlateauVertex& known : plateau_) {
        if (known.vertex == vertex) return;
    }
    plateau_.push_back({vertex, from, triangle});
}

// Begins with the vertices of what the place lies on. If none of the plateau leads on the curve ends with `if_none`.
void IntegralCurveKernel::begin_plateau(IntegralCurveStop if_none) {
    const Mesh& mesh = field_.mesh();
    plateau_.clear();
    plateau_at_ = 0;
    if_no_way_ = if_none;
    switch (place_.on) {
        case SurfacePlace::On::vertex: add_to_plateau(place_.index, no_index, no_index); break;
        case SurfacePlace::On::edge:
            for (Corner side : {place_.index, mesh.opposite(place_.index)}) {
                if (side == no_index || !field_.is_open(triangle_of(side))) continue;
                add_to_plateau(mesh.vertex_at(side), no_index, triangle_of(side));
                add_to_plateau(mesh.vertex_at(next_corner(side)), no_index, triangle_of(side));
            }
            break;
        case SurfacePlace::On::triangle:
            if (!field_.is_open(place_.index)) break;
            for (uint32_t vertex : mesh.triangles[place_.index]) add_to_plateau(vertex, no_index, place_.index);
            break;
    }
    if (plateau_.empty()) end_curve(if_none);
}

// Looks at the next vertex of the plateau; returns the units it took.
uint32_t IntegralCurveKernel::search_plateau() {
    const Mesh& mesh = field_.mesh();
    const uint32_t vertex = plateau_[plateau_at_].vertex;
    const IntegralCurveStep step = next_step(field_, place_at_vertex(vertex));
    if (step.rises || is_target(vertex)) {
        cross_plateau(plateau_at_);
        return step.cost;
    }
    const Corner first = mesh.corner_of_vertex[vertex];
    Corner corner = first;
    do {
        const uint32_t triangle = triangle_of(corner);
        if (field_.is_open(triangle)) {
            add_to_plateau(mesh.vertex_at(next_corner(corner)), plateau_at_, triangle);
            add_to_plateau(mesh.vertex_at(previous_corner(corner)), plateau_at_, triangle);
        }
        corner = mesh.turn(corner);
    } while (corner != first && corner != no_index);
    if (++plateau_at_ == plateau_.size()) {
        plateau_.clear();
        end_curve(if_no_way_);
    }
    return 2 * step.cost;
}

void IntegralCurveKernel::cross_plateau(uint32_t last) {
    // Turns the links from the last vertex back into links ahead.
    uint32_t at = last, ahead = no_index;
    while (at != no_index) at = std::exchange(plateau_[at].from, std::exchange(ahead, at));
    for (at = ahead; at != no_index; at = plateau_[at].from) {
        if (plateau_[at].triangle != no_index) move_to(plateau_[at].triangle, place_at_vertex(plateau_[at].vertex));
    }
    plateau_.clear();
    may_leave_border_ = true;
    arrive();
}

bool IntegralCurveKernel::run(uint32_t count) {
    while (count > 0 && (tracing_ || ends_.size() < starts_.size())) {
        uint32_t spent = 1;
        if (!tracing_) {
            begin_curve();
        } else if (!plateau_.empty()) {
            spent = search_plateau();
        } else {
            spent = advance();
        }
        count -= std::min(count, spent);
    }
    return !tracing_ && ends_.size() == starts_.size();
}

}  // namespace flg
