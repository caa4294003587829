// SPDX-License-Identifier: MIT
#include "surfaces/tracing/integral_curves.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "runtime/each.h"
#include "surfaces/mesh/surface_place.h"

namespace flg {

namespace {

// A field that curves climb: the values, or for those that go down their opposite.
class SlopedField {
public:
    SlopedField(const Mesh& mesh, std::span<const float> values, const RegionSet& regions, bool downhill)
        : mesh_(mesh), values_(values), regions_(regions), sign_(downhill ? -1 : 1) {}

    const Mesh& mesh() const { return mesh_; }
    double height(uint32_t vertex) const { return sign_ * double{values_[vertex]}; }
    double height(const SurfacePlace& place) const;
    bool is_in_regions(uint32_t triangle) const { return regions_.contains(mesh_.regions[triangle]); }
    // Of the regions, and all of its values finite.
    bool is_open(uint32_t triangle) const;

private:
    const Mesh& mesh_;
    std::span<const float> values_;
    const RegionSet& regions_;
    double sign_;
};

bool SlopedField::is_open(uint32_t triangle) const {
    const Triple& t = mesh_.triangles[triangle];
    return regions_.contains(mesh_.regions[triangle]) && std::isfinite(values_[t[0]]) && std::isfinite(values_[t[1]]) &&
           std::isfinite(values_[t[2]]);
}

double SlopedField::height(const SurfacePlace& place) const {
    switch (place.on) {
        case SurfacePlace::On::vertex: return height(place.index);
        case SurfacePlace::On::edge: {
            // From the lower end, so that both sides of the edge agree to the bit.
            const double a = height(mesh_.vertex_at(place.index)),
                         b = height(mesh_.vertex_at(next_corner(place.index)));
            const double t = place.u;
            return a <= b ? a + t * (b - a) : b + (1 - t) * (a - b);
        }
        default: {
            const Triple& t = mesh_.triangles[place.index];
            const double base = height(t[0]);
            return base + place.u * (height(t[1]) - base) + place.v * (height(t[2]) - base);
        }
    }
}

// One step of an integral curve: from a place on the mesh straight through one triangle, the way the field rises most.
//
// The gradient is constant in a triangle. Its direction is kept as the rates at which the three weights change: with
// the edge e_i opposite to corner i and w = sum f_j e_j, rate i is e_i . w up to a positive factor, and the field rises
// at w . w. No division by the area: triangles without area are crossed like any other, unless the field is linear
// along their line too: then they have no direction, and a curve that meets one slides along its edge.
struct IntegralCurveStep {
    bool rises = false;      // false: nothing near the place is higher, or it lies outside of the field
    uint32_t triangle = 0;   // that it goes through
    SurfacePlace to{};       // at the triangle's border; always strictly higher
    bool at_border = false;  // the place is on the border of the mesh, the regions or the finite values
    bool leaves = false;     // the field would rise beyond that border: the step, if any, slides along it
    uint32_t cost = 1;       // triangles looked at
};

struct Slope {
    Weights rates{};               // how the weights change uphill; the largest is 1 in size; 0 where flat
    double steepness_squared = 0;  // (value / metre)^2; infinite without area
    bool is_flat() const { return rates == Weights{}; }
};

Slope slope_of(const SlopedField& field, uint32_t triangle) {
    const Mesh& mesh = field.mesh();
    const Triple& t = mesh.triangles[triangle];
    const Vec3 edges[3] = {mesh.position(t[2]) - mesh.position(t[1]), mesh.position(t[0]) - mesh.position(t[2]),
                           mesh.position(t[1]) - mesh.position(t[0])};
    const double base = field.height(t[0]);
    const Vec3 w = (field.height(t[1]) - base) * edges[1] + (field.height(t[2]) - base) * edges[2];
    Slope slope;
    const double u = edges[1].dot(w), v = edges[2].dot(w);
    slope.rates = {-u - v, u, v};  // their sum is 0
    const double largest = std::max({std::abs(u), std::abs(v), std::abs(u + v)});
    if (largest == 0) return slope;
    for (double& rate : slope.rates) rate /= largest;
    const double area_squared = edges[1].cross(edges[2]).squaredNorm();
    slope.steepness_squared =
        area_squared > 0 ? w.squaredNorm() / area_squared : std::numeric_limits<double>::infinity();
    return slope;
}

// Where the way uphill from `weights` leaves the triangle.
SurfacePlace exit_of(const Mesh& mesh, uint32_t triangle, const Weights& weights, const Weights& rates) {
    uint32_t out = 0;
    double time = std::numeric_limits<double>::infinity();
    for (uint32_t k = 0; k < 3; ++k) {
        if (rates[k] < 0 && weights[k] < -rates[k] * time) {
            time = weights[k] / -rates[k];
            out = k;
        }
    }
    const uint32_t from = (out + 1) % 3, to = (out + 2) % 3;
    const double at_from = std::max(0.0, weights[from] + time * rates[from]);
    const double at_to = std::max(0.0, weights[to] + time * rates[to]);
    return place_on_edge(mesh, 3 * triangle + from, at_to / (at_from + at_to));
}

// Straight uphill through a triangle from a place in it; to its highest corner if rounding leaves nothing of the rise,
// or if it has no area and so no direction. Leaves the step as it is if that isn't higher either.
void cross(const SlopedField& field, const SurfacePlace& from, uint32_t triangle, const Slope& slope,
           IntegralCurveStep& step) {
    const Mesh& mesh = field.mesh();
    const double height = field.height(from);
    const Triple& t = mesh.triangles[triangle];
    SurfacePlace to = place_at_vertex(*std::max_element(
        t.begin(), t.end(), [&](uint32_t a, uint32_t b) { return field.height(a) < field.height(b); }));
    SurfacePoint point;
    if (!slope.is_flat() && find_in(mesh, from, triangle, point)) {
        const SurfacePlace exit = exit_of(mesh, triangle, weights_of(point), slope.rates);
        if (field.height(exit) > height) to = exit;
    }
    if (!(field.height(to) > height)) return;
    step.rises = true;
    step.triangle = triangle;
    step.to = to;
}

IntegralCurveStep step_from_vertex(const SlopedField& field, const SurfacePlace& from) {
    const Mesh& mesh = field.mesh();
    IntegralCurveStep step;
    const double height = field.height(from.index);
    double steepest_squared = -1;
    Slope slope_through;
    uint32_t through = no_index;
    const auto try_edge = [&](uint32_t triangle, uint32_t end) {
        const double rise = field.height(end) - height;
        if (!(rise > 0) || !std::isfinite(rise)) return;
        const double length_squared = (mesh.position(end) - mesh.position(from.index)).squaredNorm();
        const double squared =
            length_squared > 0 ? rise * rise / length_squared : std::numeric_limits<double>::infinity();
        if (squared <= steepest_squared) return;
        steepest_squared = squared;
        through = no_index;
        step.rises = true;
        step.triangle = triangle;
        step.to = place_at_vertex(end);
    };
    const auto try_edges = [&](Corner corner) {
        try_edge(triangle_of(corner), mesh.vertex_at(next_corner(corner)));
        try_edge(triangle_of(corner), mesh.vertex_at(previous_corner(corner)));
    };
    const Corner first = mesh.corner_of_vertex[from.index];
    Corner corner = first;
    step.cost = 0;
    do {
        ++step.cost;
        const uint32_t triangle = triangle_of(corner);
        if (!field.is_open(triangle)) {
            step.at_border = true;
        } else {
            try_edges(corner);
            const Slope slope = slope_of(field, triangle);
            if (slope.rates[next_corner(corner) % 3] > 0 && slope.rates[previous_corner(corner) % 3] > 0 &&
                slope.steepness_squared > steepest_squared && std::isfinite(slope.steepness_squared)) {
                steepest_squared = slope.steepness_squared;
                through = triangle;
                slope_through = slope;
            }
        }
        corner = mesh.turn(corner);
    } while (corner != first && corner != no_index);
    if (corner == no_index) step.at_border = true;
    if (through != no_index) cross(field, from, through, slope_through, step);
    if (step.rises || !step.at_border) return step;
    // A solver that stopped early may leave nothing finite beside an edge but its ends.
    corner = first;
    do {
        if (field.is_in_regions(triangle_of(corner))) try_edges(corner);
        corner = mesh.turn(corner);
    } while (corner != first && corner != no_index);
    step.leaves = step.rises;
    step.cost *= 2;
    return step;
}

IntegralCurveStep step_from_edge(const SlopedField& field, const SurfacePlace& from) {
    const Mesh& mesh = field.mesh();
    IntegralCurveStep step;
    step.cost = 2;
    const Corner sides[2] = {from.index, mesh.opposite(from.index)};
    uint32_t through = no_index, along = no_index;
    Slope slope_through;
    for (Corner side : sides) {
        if (side == no_index || !field.is_open(triangle_of(side))) {
            step.at_border = true;
            continue;
        }
        along = triangle_of(side);
        const Slope slope = slope_of(field, along);
        if (slope.rates[previous_corner(side) % 3] > 0 &&
            (through == no_index || slope.steepness_squared > slope_through.steepness_squared)) {
            through = along;
            slope_through = slope;
        }
    }
    if (through != no_index) {
        cross(field, from, through, slope_through, step);
        if (step.rises) return step;
    }
    step.leaves = step.at_border;
    if (along == no_index) return step;
    const uint32_t a = mesh.vertex_at(from.index), b = mesh.vertex_at(next_corner(from.index));
    step.triangle = along;
    step.to = place_at_vertex(field.height(a) > field.height(b) ? a : b);
    step.rises = field.height(step.to) > field.height(from);
    return step;
}

IntegralCurveStep step_from_triangle(const SlopedField& field, const SurfacePlace& from) {
    IntegralCurveStep step;
    step.at_border = !field.is_open(from.index);
    if (step.at_border) return step;
    cross(field, from, from.index, slope_of(field, from.index), step);
    return step;
}

// From a vertex: along the steepest of its edges and triangles. From an edge: into the triangle whose field rises away
// from it, the steeper one of two; along the edge where both fall away, or at a border.
IntegralCurveStep next_step(const SlopedField& field, const SurfacePlace& from) {
    switch (from.on) {
        case SurfacePlace::On::vertex: return step_from_vertex(field, from);
        case SurfacePlace::On::edge: return step_from_edge(field, from);
        default: return step_from_triangle(field, from);
    }
}

class CurveTracer {
public:
    static constexpr uint32_t plateau_limit = 128;

    CurveTracer(const Mesh& mesh, std::span<const float> values, const RegionSet& regions,
                std::span<const SurfacePoint> starts, const IntegralCurveOptions& options, SurfaceCurves& out,
                Memory* memory);

    bool goes_on() const { return tracing_ || ends_.size() < starts_.size(); }
    // Through a triangle. Returns how many it looked at.
    uint32_t step() {
        if (tracing_) return plateau_.empty() ? advance() : search_plateau();
        begin_curve();
        return 1;
    }
    std::pmr::deque<IntegralCurveEnd> take_ends() { return std::move(ends_); }

private:
    struct PlateauVertex {
        uint32_t vertex;
        uint32_t from;      // index of the one before it
        uint32_t triangle;  // that holds both
    };

    void begin_curve();
    void end_curve(IntegralCurveStop stop);
    void arrive();
    bool is_target(uint32_t vertex) const;
    uint32_t advance();
    void move_to(uint32_t triangle, const SurfacePlace& to);
    void begin_plateau(IntegralCurveStop if_none);
    uint32_t search_plateau();
    void add_to_plateau(uint32_t vertex, uint32_t from, uint32_t triangle);
    void cross_plateau(uint32_t last);

    const SlopedField field_;
    const std::span<const SurfacePoint> starts_;
    const IntegralCurveOptions options_;
    const double end_height_;
    SurfaceCurves& out_;
    std::pmr::deque<IntegralCurveEnd> ends_;
    bool tracing_ = false;
    SurfacePlace place_{};
    bool may_leave_border_ = true;  // at the start of a curve and after a plateau
    uint32_t last_triangle_ = no_index;
    std::pmr::vector<PlateauVertex> plateau_;  // not empty while searched
    uint32_t plateau_at_ = 0;
    IntegralCurveStop if_no_way_{};
};

CurveTracer::CurveTracer(const Mesh& mesh, std::span<const float> values, const RegionSet& regions,
                         std::span<const SurfacePoint> starts, const IntegralCurveOptions& options, SurfaceCurves& out,
                         Memory* memory)
    : field_(mesh, values, regions, options.downhill),
      starts_(starts),
      options_(options),
      end_height_(!options.level     ? std::numeric_limits<double>::infinity()
                  : options.downhill ? -double{*options.level}
                                     : double{*options.level}),
      out_(out),
      ends_(memory),
      plateau_(memory) {}

void CurveTracer::begin_curve() {
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

void CurveTracer::end_curve(IntegralCurveStop stop) {
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
void CurveTracer::arrive() {
    if (place_.on == SurfacePlace::On::vertex && is_target(place_.index)) end_curve(IntegralCurveStop::target);
}

bool CurveTracer::is_target(uint32_t vertex) const {
    return std::binary_search(options_.targets.begin(), options_.targets.end(), vertex);
}

void CurveTracer::move_to(uint32_t triangle, const SurfacePlace& to) {
    SurfacePoint point{};
    find_in(field_.mesh(), place_, triangle, point);
    out_.points.push_back(point);
    last_triangle_ = triangle;
    place_ = to;
}

// Returns the units it took.
uint32_t CurveTracer::advance() {
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

void CurveTracer::add_to_plateau(uint32_t vertex, uint32_t from, uint32_t triangle) {
    if (plateau_.size() == plateau_limit || field_.height(vertex) != field_.height(place_)) return;
    for (const PlateauVertex& known : plateau_) {
        if (known.vertex == vertex) return;
    }
    plateau_.push_back({vertex, from, triangle});
}

// Begins with the vertices of what the place lies on. If none of the plateau leads on the curve ends with `if_none`.
void CurveTracer::begin_plateau(IntegralCurveStop if_none) {
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
uint32_t CurveTracer::search_plateau() {
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

void CurveTracer::cross_plateau(uint32_t last) {
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

}  // namespace

Task<std::pmr::deque<IntegralCurveEnd>> add_integral_curves(Pace& pace, const Mesh& mesh, std::span<const float> values,
                                                            const RegionSet& regions,
                                                            std::span<const SurfacePoint> starts,
                                                            IntegralCurveOptions options, SurfaceCurves& out) {
    CurveTracer tracer(mesh, values, regions, starts, options, out, pace.memory());
    Slice slice(Cost::hundreds_of_ns);
    while (tracer.goes_on())
        if (slice.is_over(tracer.step())) co_await pace;
    co_return tracer.take_ends();
}

}  // namespace flg
