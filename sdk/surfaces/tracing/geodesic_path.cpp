// SPDX-License-Identifier: MIT
#include "surfaces/tracing/geodesic_path.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

#include "runtime/each.h"
#include "surfaces/mesh/surface_place.h"
#include "surfaces/tracing/integral_curves.h"
#include "surfaces/tracing/triangle_strip.h"

namespace flg {

namespace {

// Grows at its end; clear() takes no time and keeps the memory.
template <class T>
class ReusedDeque {
public:
    explicit ReusedDeque(Memory* memory) : values_(memory) {}
    uint32_t size() const { return size_; }
    T& operator[](uint32_t i) { return values_[i]; }
    const T& operator[](uint32_t i) const { return values_[i]; }
    T& back() { return values_[size_ - 1]; }
    const T& back() const { return values_[size_ - 1]; }
    void clear() { size_ = 0; }
    void pop_back() { --size_; }
    void push_back(const T& value) {
        if (size_ < values_.size()) {
            values_[size_] = value;
        } else {
            values_.push_back(value);
        }
        ++size_;
    }

private:
    std::pmr::deque<T> values_;
    uint32_t size_ = 0;
};

// The next triangle about a vertex; no_index where the mesh or the regions end.
uint32_t next_about(const Mesh& mesh, const RegionSet& regions, uint32_t vertex, uint32_t triangle,
                    bool counter_clockwise) {
    const Triple& t = mesh.triangles[triangle];
    const uint32_t k = t[0] == vertex ? 0 : t[1] == vertex ? 1 : 2;
    const uint32_t next = mesh.neighbours[triangle][counter_clockwise ? (k + 2) % 3 : k];
    return next != no_index && regions.contains(mesh.regions[next]) ? next : no_index;
}

// The triangles that a path on a mesh runs through, one after the other across shared edges.
//
// Invariants: neighbours in the sleeve are neighbours in the mesh; only the first triangle holds the path's start and
// only the last its end; it never goes back to where it has just come from. All of its triangles are of the regions.
class GeodesicSleeve {
public:
    GeodesicSleeve(const Mesh& mesh, const RegionSet& regions, Memory* memory)
        : mesh_(mesh), regions_(regions), triangles_(memory) {}

    void begin(const SurfacePlace& from, const SurfacePlace& to);

    uint32_t size() const { return triangles_.size(); }
    uint32_t operator[](uint32_t i) const { return triangles_[i]; }
    uint32_t last() const { return triangles_.back(); }
    bool is_complete() const { return complete_; }

    void clear();
    // Goes on into a neighbour of the last triangle, or stays in it. Where that holds the start, the sleeve begins
    // there; where it holds the end it is complete, and further triangles are ignored.
    void enter(uint32_t triangle);
    // Goes on about a vertex of the last triangle to another of its triangles, over as few as possible. False if the
    // mesh or the regions end on both ways. `cost` rises by the triangles looked at.
    bool turn_to(uint32_t vertex, uint32_t triangle, uint32_t& cost);
    // Goes on about a vertex: counter-clockwise or clockwise until `triangle`: the mesh and the regions go on that far.
    void turn(uint32_t vertex, bool counter_clockwise, uint32_t triangle);

private:
    const Mesh& mesh_;
    const RegionSet& regions_;
    SurfacePlace from_{}, to_{};
    ReusedDeque<uint32_t> triangles_;
    bool complete_ = false;
};

void GeodesicSleeve::begin(const SurfacePlace& from, const SurfacePlace& to) {
    from_ = from;
    to_ = to;
    clear();
}

void GeodesicSleeve::clear() {
    triangles_.clear();
    complete_ = false;
}

void GeodesicSleeve::enter(uint32_t triangle) {
    const uint32_t count = triangles_.size();
    if (complete_ || (count > 0 && triangles_.back() == triangle)) return;
    SurfacePoint unused;
    if (count > 1 && triangles_[count - 2] == triangle) {
        triangles_.pop_back();
    } else {
        if (find_in(mesh_, from_, triangle, unused)) triangles_.clear();
        triangles_.push_back(triangle);
    }
    complete_ = find_in(mesh_, to_, triangle, unused);
}

void GeodesicSleeve::turn(uint32_t vertex, bool counter_clockwise, uint32_t triangle) {
    for (uint32_t at = triangles_.back(); at != triangle;) {
        at = next_about(mesh_, regions_, vertex, at, counter_clockwise);
        enter(at);
    }
}

bool GeodesicSleeve::turn_to(uint32_t vertex, uint32_t triangle, uint32_t& cost) {
    uint32_t left = last(), right = last();
    while (left != triangle && right != triangle) {
        ++cost;
        if (left != no_index) left = next_about(mesh_, regions_, vertex, left, true);
        if (right != no_index) right = next_about(mesh_, regions_, vertex, right, false);
        if (left == no_index && right == no_index) return false;
    }
    turn(vertex, left == triangle, triangle);
    return true;
}

using Vec2 = Eigen::Vector2d;

inline double cross(const Vec2& a, const Vec2& b) {
    return a.x() * b.y() - a.y() * b.x();
}

// A gate is the edge between two triangles of the sleeve; its right end is the vertex at its corner in the triangle
// before it, its left end the following vertex.
struct SleeveGate {
    Corner corner;     // in the triangle before it
    Vec2 right, left;  // metres, in the plane
};

// Where the path turns: at an end of a gate.
struct PathBend {
    uint32_t gate;  // the first that ends there; of the path's end: their count
    bool at_left;
    Vec2 at;
};

// The shortest path within a sleeve of triangles: the sleeve is unfolded into the plane and a funnel is drawn through
// its gates (Lee, Preparata: Euclidean shortest paths in the presence of rectilinear barriers, 1984; linear time).
class GeodesicFunnel {
public:
    GeodesicFunnel(const Mesh& mesh, Memory* memory)
        : mesh_(mesh), gates_(memory), bends_(memory), left_(memory), right_(memory) {}

    // The sleeve is complete and outlives the run.
    void begin(const GeodesicSleeve& sleeve, const SurfacePlace& from, const SurfacePlace& to);
    // Goes on through a gate; false at the end. `cost` rises by what it looked at.
    bool advance(uint32_t& cost);

    const ReusedDeque<SleeveGate>& gates() const { return gates_; }
    // The last one is the path's end.
    const ReusedDeque<PathBend>& bends() const { return bends_; }
    const Vec2& start() const { return start_; }
    uint32_t end_vertex(uint32_t gate, bool left) const {
        const Corner corner = gates_[gate].corner;
        return mesh_.vertex_at(left ? next_corner(corner) : corner);
    }
    double length() const;

private:
    void unfold_first(uint32_t triangle, Corner exit);
    Vec2 unfold_apex() const;
    Corner exit_of(uint32_t index) const;
    uint32_t add(bool left, const PathBend& point);
    void add_end();

    const Mesh& mesh_;
    const GeodesicSleeve* sleeve_ = nullptr;
    SurfacePlace from_{}, to_{};
    ReusedDeque<SleeveGate> gates_;
    ReusedDeque<PathBend> bends_;
    Vec2 start_{};
    PathBend apex_{};
    std::pmr::deque<PathBend> left_, right_;  // the walls of the funnel, from the apex
};

// The third corner of a triangle, left of the way from `a` to `b`; a_3d, b_3d, c_3d are its corners in space.
Vec2 place_third(const Vec2& a, const Vec2& b, const Vec3& a_3d, const Vec3& b_3d, const Vec3& c_3d) {
    const Vec3 base = b_3d - a_3d, side = c_3d - a_3d;
    const double squared = base.squaredNorm();
    if (!(squared > 0)) return a + Vec2(side.norm(), 0);
    const double along = side.dot(base) / squared, up = side.cross(base).norm() / squared;
    const Vec2 way = b - a;
    return a + along * way + up * Vec2(-way.y(), way.x());
}

// The edge through which the sleeve leaves triangle `index`.
Corner GeodesicFunnel::exit_of(uint32_t index) const {
    const uint32_t triangle = (*sleeve_)[index], next = (*sleeve_)[index + 1];
    const Triple& neighbours = mesh_.neighbours[triangle];
    return 3 * triangle + (neighbours[0] == next ? 0 : neighbours[1] == next ? 1 : 2);
}

void GeodesicFunnel::unfold_first(uint32_t triangle, Corner exit) {
    const Corner corners[3] = {exit, next_corner(exit), previous_corner(exit)};
    Vec3 in_space[3];
    for (uint32_t k = 0; k < 3; ++k) in_space[k] = mesh_.position(mesh_.vertex_at(corners[k]));
    const Vec2 right = Vec2::Zero(), left((in_space[1] - in_space[0]).norm(), 0);
    const Vec2 third = place_third(right, left, in_space[0], in_space[1], in_space[2]);
    gates_.push_back({exit, right, left});
    SurfacePoint point{};
    find_in(mesh_, from_, triangle, point);
    const Weights weights = weights_of(point);
    start_ = weights[corners[0] % 3] * right + weights[corners[1] % 3] * left + weights[corners[2] % 3] * third;
}

// Of the triangle behind the last gate.
Vec2 GeodesicFunnel::unfold_apex() const {
    const SleeveGate& gate = gates_.back();
    const Corner entry = mesh_.opposite(gate.corner);  // from left to right
    return place_third(gate.left, gate.right, mesh_.position(mesh_.vertex_at(entry)),
                       mesh_.position(mesh_.vertex_at(next_corner(entry))),
                       mesh_.position(mesh_.vertex_at(previous_corner(entry))));
}

void GeodesicFunnel::begin(const GeodesicSleeve& sleeve, const SurfacePlace& from, const SurfacePlace& to) {
    sleeve_ = &sleeve;
    from_ = from;
    to_ = to;
    gates_.clear();
    bends_.clear();
    left_.clear();
    right_.clear();
}

// Adds a point to a wall of the funnel, takes from it what the point makes superfluous and, if the point lies beyond
// the other wall, moves the apex along that. Returns how many points it looked at.
uint32_t GeodesicFunnel::add(bool left, const PathBend& point) {
    std::pmr::deque<PathBend>& own = left ? left_ : right_;
    std::pmr::deque<PathBend>& other = left ? right_ : left_;
    const double sign = left ? 1 : -1;
    uint32_t looked = 1;
    for (; !own.empty(); ++looked) {
        const Vec2& before = own.size() > 1 ? own[own.size() - 2].at : apex_.at;
        if (sign * cross(own.back().at - before, point.at - before) > 0) break;
        own.pop_back();
    }
    for (; own.empty() && !other.empty(); ++looked) {
        const Vec2 wall = other.front().at - apex_.at;
        const double side = sign * cross(wall, point.at - apex_.at);
        // Behind a gate without length the unfolded sleeve may come straight back.
        const bool comes_back = side == 0 && wall.dot(point.at - other.front().at) < 0;
        if (side >= 0 && !comes_back) break;
        apex_ = other.front();
        bends_.push_back(apex_);
        other.pop_front();
    }
    own.push_back(point);
    return looked;
}

bool GeodesicFunnel::advance(uint32_t& cost) {
    const uint32_t gates = sleeve_->size() - 1, at = gates_.size();
    if (at == gates) {
        add_end();
        return false;
    }
    const Corner exit = exit_of(at);
    if (at == 0) {
        unfold_first((*sleeve_)[0], exit);
        apex_ = {0, true, start_};
        cost += add(true, {0, true, gates_[0].left});
        cost += add(false, {0, false, gates_[0].right});
    } else {
        const SleeveGate before = gates_.back();
        const Vec2 apex = unfold_apex();
        // One end stays.
        const bool left_is_new = exit == next_corner(mesh_.opposite(before.corner));
        gates_.push_back(left_is_new ? SleeveGate{exit, before.right, apex} : SleeveGate{exit, apex, before.left});
        cost += add(left_is_new, {at, left_is_new, apex});
    }
    return true;
}

// The path's end, as the last gate.
void GeodesicFunnel::add_end() {
    PathBend end{gates_.size(), true, {}};
    const uint32_t triangle = sleeve_->last();
    SurfacePoint point{};
    find_in(mesh_, to_, triangle, point);
    if (gates_.size() == 0) {
        // Both in one triangle.
        start_ = Vec2::Zero();
        SurfacePoint from{};
        find_in(mesh_, from_, triangle, from);
        end.at = Vec2((position_of(mesh_, point) - position_of(mesh_, from)).norm(), 0);
        bends_.push_back(end);
        return;
    }
    const Weights weights = weights_of(point);
    const SleeveGate& gate = gates_.back();
    const Corner entry = mesh_.opposite(gate.corner);
    end.at = weights[entry % 3] * gate.left + weights[next_corner(entry) % 3] * gate.right +
             weights[previous_corner(entry) % 3] * unfold_apex();
    add(true, end);
    for (const PathBend& bend : left_) bends_.push_back(bend);
}

double GeodesicFunnel::length() const {
    double length = 0;
    Vec2 at = start_;
    for (uint32_t i = 0; i < bends_.size(); ++i) {
        length += (bends_[i].at - at).norm();
        at = bends_[i].at;
    }
    return length;
}

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

// A path as it is found, straightened and drawn, one after another in the same memory. What returns a number returns
// what it cost, in units of about 50 ns.
class PathSearch {
public:
    PathSearch(const Mesh& mesh, const RegionSet& regions, Memory* memory)
        : mesh_(mesh),
          regions_(regions),
          sleeves_{{mesh, regions, memory}, {mesh, regions, memory}},
          funnel_(mesh, memory),
          flips_(memory) {}

    void begin(const SurfacePoint& from, const SurfacePoint& to);

    bool has_sleeve() const { return sleeve_->is_complete(); }
    const SurfacePlace& from() const { return from_; }
    const SurfacePlace& to() const { return to_; }

    // The first sleeve, along the way down. It stays incomplete where that does not lead to the end.
    void begin_follow(const SurfaceCurves& way, IntegralCurveStop stop);
    const Mesh& mesh() const { return mesh_; }
    const RegionSet& regions() const { return regions_; }
    bool goes_on_following() const { return way_ != nullptr; }
    uint32_t follow_point();
    // Another first sleeve, triangle by triangle.
    void begin_strip() { sleeve_->clear(); }
    void take(uint32_t triangle) { sleeve_->enter(triangle); }

    void unfold() { funnel_.begin(*sleeve_, from_, to_); }
    bool unfold_gate(uint32_t& cost) { return funnel_.advance(cost); }
    // Which bends are shorter on the other side of their vertex.
    void begin_bends() {
        flips_.clear();
        at_ = 0;
    }
    bool has_bend() const { return at_ + 1 < funnel_.bends().size(); }
    uint32_t test_bend();
    // Ends a round; false if it was the last one.
    bool begin_flips();
    bool goes_on_flipping() const { return !flipped_->is_complete(); }
    uint32_t flip_next();
    void end_flips() { std::swap(sleeve_, flipped_); }

    void begin_draw(SurfaceCurves& out);
    bool goes_on_drawing() const { return !is_drawn_; }
    uint32_t draw_next();
    GeodesicPath result() const { return {true, length_, flips_.size() == 0}; }

private:
    // The sleeve's triangles between `first` and `last`, all about the vertex, are to be those on its other side.
    struct Flip {
        uint32_t first, last;
        uint32_t vertex;
        bool counter_clockwise;
    };

    bool is_open(uint32_t triangle) const { return regions_.contains(mesh_.regions[triangle]); }
    uint32_t follow_to_end(const SurfacePlace& last);
    uint32_t last_gate_at(const PathBend& bend) const;
    double corner_angle(uint32_t triangle, uint32_t vertex) const;
    bool is_shorter_around(uint32_t bend, Flip& flip, uint32_t& cost);
    void pass_through(const SurfacePlace& place, uint32_t triangle);

    const Mesh& mesh_;
    const RegionSet& regions_;
    SurfacePoint start_{};
    SurfacePlace from_{}, to_{};
    SurfaceCurves* out_ = nullptr;
    const SurfaceCurves* way_ = nullptr;  // while it is followed
    IntegralCurveStop way_stop_{};
    GeodesicSleeve sleeves_[2];
    GeodesicSleeve* sleeve_ = &sleeves_[0];
    GeodesicSleeve* flipped_ = &sleeves_[1];
    GeodesicFunnel funnel_;
    ReusedDeque<Flip> flips_;
    uint32_t at_ = 0;       // point, bend, triangle or gate
    uint32_t item_at_ = 0;  // flip, or bend to draw
    Vec2 straight_from_{};
    SurfacePlace drawn_{};  // the place drawn last, and the triangle the path enters from there
    uint32_t drawn_triangle_ = 0;
    bool is_drawn_ = false;
    uint32_t idle_rounds_ = 0;  // without gain
    double length_ = 0;
    double shortest_ = std::numeric_limits<double>::infinity();  // of all rounds
};

void PathSearch::begin(const SurfacePoint& from, const SurfacePoint& to) {
    start_ = from;
    from_ = place_in(mesh_, from);
    to_ = place_in(mesh_, to);
    for (GeodesicSleeve& sleeve : sleeves_) sleeve.begin(from_, to_);
    flips_.clear();
    way_ = nullptr;
    idle_rounds_ = 0;
    shortest_ = std::numeric_limits<double>::infinity();
    // Where both are in one triangle there is nothing to trace.
    if (is_open(from.triangle)) sleeve_->enter(from.triangle);
}

// Every stretch of the way down is in one triangle; what lies between two of them shares their common point.
void PathSearch::begin_follow(const SurfaceCurves& way, IntegralCurveStop stop) {
    way_stop_ = stop;
    sleeve_->clear();
    if (way.curve_count() > 0) {
        sleeve_->enter(way.points[0].triangle);
        way_ = &way;
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
    if (sleeve_->size() > 0) follow_to_end(from_);
}

uint32_t PathSearch::follow_point() {
    const SurfacePoint& point = way_->points[at_];
    const SurfacePlace place = place_in(mesh_, point);
    const bool is_last = at_ + 1 == way_->points.size();
    uint32_t cost = 1;
    if (is_last || sleeve_->is_complete()) {
        cost += follow_to_end(place);
        way_ = nullptr;
    } else if (place.on == SurfacePlace::On::vertex) {
        if (!sleeve_->turn_to(place.index, point.triangle, cost)) way_ = nullptr;
    } else {
        sleeve_->enter(point.triangle);
    }
    ++at_;
    return cost;
}

// The way down ends at a vertex of what the end lies on, or on an edge between two that are equally far.
uint32_t PathSearch::follow_to_end(const SurfacePlace& last) {
    uint32_t cost = 0;
    const auto enter_if_open = [&](Corner corner) {
        if (corner != no_index && is_open(triangle_of(corner))) sleeve_->enter(triangle_of(corner));
    };
    if (last.on == SurfacePlace::On::edge) {
        enter_if_open(last.index);
        enter_if_open(mesh_.opposite(last.index));
    } else if (!sleeve_->is_complete() && way_stop_ == IntegralCurveStop::target) {
        uint32_t triangle = to_.on == SurfacePlace::On::triangle ? to_.index : triangle_of(to_.index);
        if (to_.on == SurfacePlace::On::edge && !is_open(triangle)) triangle = mesh_.neighbour_at(to_.index);
        if (triangle != no_index) sleeve_->turn_to(last.index, triangle, cost);
    }
    return cost;
}

// Of the gates that end at the bend, which follow each other.
uint32_t PathSearch::last_gate_at(const PathBend& bend) const {
    const uint32_t vertex = funnel_.end_vertex(bend.gate, bend.at_left);
    uint32_t last = bend.gate;
    while (last + 1 < funnel_.gates().size() && funnel_.end_vertex(last + 1, bend.at_left) == vertex) ++last;
    return last;
}

double PathSearch::corner_angle(uint32_t triangle, uint32_t vertex) const {
    const Triple& t = mesh_.triangles[triangle];
    const uint32_t k = t[0] == vertex ? 0 : t[1] == vertex ? 1 : 2;
    const Vec3 at = mesh_.position(vertex);
    const Vec3 a = mesh_.position(t[(k + 1) % 3]) - at, b = mesh_.position(t[(k + 2) % 3]) - at;
    return std::atan2(a.cross(b).norm(), a.dot(b));
}

// Whether the path's angle at the bend, on the side that the sleeve does not cover, is less than straight.
bool PathSearch::is_shorter_around(uint32_t index, Flip& flip, uint32_t& cost) {
    const PathBend& bend = funnel_.bends()[index];
    const uint32_t vertex = funnel_.end_vertex(bend.gate, bend.at_left);
    const uint32_t last_gate = last_gate_at(bend);
    // The sleeve turns about a vertex on its left counter-clockwise.
    flip = {bend.gate, last_gate + 1, vertex, !bend.at_left};
    const uint32_t first = (*sleeve_)[flip.first], last = (*sleeve_)[flip.last];
    cost += flip.last - flip.first;
    if (first == last) return true;  // the sleeve goes all the way around

    const Vec2 before = (index == 0 ? funnel_.start() : funnel_.bends()[index - 1].at) - bend.at;
    const Vec2 after = funnel_.bends()[index + 1].at - bend.at;
    const auto along_gate = [&](uint32_t gate) -> Vec2 {
        const SleeveGate& g = funnel_.gates()[gate];
        return (bend.at_left ? g.right : g.left) - bend.at;
    };
    double angle = corner_angle(first, vertex) - angle_between(before, along_gate(bend.gate)) +
                   corner_angle(last, vertex) - angle_between(after, along_gate(last_gate));
    constexpr double straight = std::numbers::pi - path_angle_tolerance;
    uint32_t triangle = next_about(mesh_, regions_, vertex, first, flip.counter_clockwise);
    for (; angle < straight && triangle != last; ++cost) {
        if (triangle == no_index) return false;
        angle += corner_angle(triangle, vertex);
        triangle = next_about(mesh_, regions_, vertex, triangle, flip.counter_clockwise);
    }
    return angle < straight;
}

uint32_t PathSearch::test_bend() {
    uint32_t cost = 1;
    Flip flip{};
    const bool is_free = flips_.size() == 0 || flips_.back().last <= funnel_.bends()[at_].gate;
    if (is_free && is_shorter_around(at_, flip, cost)) flips_.push_back(flip);
    ++at_;
    return cost;
}

bool PathSearch::begin_flips() {
    at_ = item_at_ = 0;
    length_ = funnel_.length();
    idle_rounds_ = length_ < shortest_ ? 0 : idle_rounds_ + 1;
    shortest_ = std::min(shortest_, length_);
    if (flips_.size() == 0 || idle_rounds_ == max_idle_rounds) return false;
    flipped_->clear();
    return true;
}

void PathSearch::begin_draw(SurfaceCurves& out) {
    out_ = &out;
    is_drawn_ = from_ == to_;
    if (is_drawn_) return;
    straight_from_ = funnel_.start();
    drawn_ = from_;
    drawn_triangle_ = (*sleeve_)[0];
    if (out.points.size() > out.offsets.back()) out.points.pop_back();
}

uint32_t PathSearch::flip_next() {
    uint32_t cost = 1;
    flipped_->enter((*sleeve_)[at_]);
    if (!flipped_->is_complete() && item_at_ < flips_.size() && flips_[item_at_].first == at_) {
        const Flip& flip = flips_[item_at_++];
        const uint32_t before = flipped_->size();
        flipped_->turn(flip.vertex, flip.counter_clockwise, (*sleeve_)[flip.last]);
        cost += std::max(flipped_->size(), before) - before;
        at_ = flip.last;
    } else {
        ++at_;
    }
    return cost;
}

// Draws a place a step late: several gates may be crossed at the same vertex.
void PathSearch::pass_through(const SurfacePlace& place, uint32_t triangle) {
    if (place != drawn_) {
        SurfacePoint point{};
        find_in(mesh_, drawn_, drawn_triangle_, point);
        out_->points.push_back(point);
        drawn_ = place;
    }
    drawn_triangle_ = triangle;
}

uint32_t PathSearch::draw_next() {
    uint32_t cost = 1;
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
        cost += next - at_ + 1;
        pass_through(place_at_vertex(funnel_.end_vertex(bend.gate, bend.at_left)), (*sleeve_)[next + 1]);
        straight_from_ = bend.at;
        at_ = std::min(next + 1, funnel_.bends()[++item_at_].gate);
    } else {
        const uint32_t triangle = drawn_triangle_;
        pass_through(to_, triangle);
        SurfacePoint last{};
        find_in(mesh_, to_, triangle, last);
        out_->points.push_back(last);
        is_drawn_ = true;
    }
    return cost;
}

Task<GeodesicPath> straighten(Pace& pace, PathSearch& search, SurfaceCurves& out) {
    Slice slice(Cost::tens_of_ns);
    for (;;) {
        search.unfold();
        for (uint32_t cost = 0; search.unfold_gate(cost); cost = 0)
            if (slice.is_over(cost)) co_await pace;
        search.begin_bends();
        while (search.has_bend())
            if (slice.is_over(search.test_bend())) co_await pace;
        if (!search.begin_flips()) break;
        while (search.goes_on_flipping())
            if (slice.is_over(search.flip_next())) co_await pace;
        search.end_flips();
    }
    search.begin_draw(out);
    while (search.goes_on_drawing())
        if (slice.is_over(search.draw_next())) co_await pace;
    co_return search.result();
}

// The first sleeve along a way, and where that leads nowhere the shortest over centroids. False if there is none.
Task<bool> find_sleeve(Pace& pace, PathSearch& search, const SurfaceCurves* way, IntegralCurveStop stop) {
    Slice slice(Cost::tens_of_ns);
    if (way && !search.has_sleeve()) {
        search.begin_follow(*way, stop);
        while (search.goes_on_following())
            if (slice.is_over(search.follow_point())) co_await pace;
    }
    if (search.has_sleeve()) co_return true;
    const std::pmr::vector<uint32_t> strip =
        co_await find_strip(pace, search.mesh(), search.regions(), search.from(), search.to());
    search.begin_strip();
    for (const uint32_t triangle : strip) {
        search.take(triangle);
        if (slice.is_over()) co_await pace;
    }
    co_return search.has_sleeve();
}

}  // namespace

Task<GeodesicPath> add_geodesic_path(Pace& pace, const Mesh& mesh, SurfacePoint from, SurfacePoint to,
                                     std::span<const float> distances, const RegionSet& regions, SurfaceCurves& out) {
    PathSearch search(mesh, regions, pace.memory());
    search.begin(from, to);
    SurfaceCurves way(pace.memory());
    IntegralCurveStop stop{};
    const bool descends = !search.has_sleeve() && !distances.empty();
    if (descends) {
        std::array<uint32_t, 3> targets{};
        const IntegralCurveOptions options = descent_to(mesh, search.to(), targets);
        const std::span<const SurfacePoint> start(&from, 1);
        const std::pmr::deque<IntegralCurveEnd> ends =
            co_await add_integral_curves(pace, mesh, distances, regions, start, options, way);
        stop = ends.front().stop;
    }
    const bool found = co_await find_sleeve(pace, search, descends ? &way : nullptr, stop);
    if (!found) co_return GeodesicPath{};
    co_return co_await straighten(pace, search, out);
}

PathShortener::PathShortener(const Mesh& mesh, const RegionSet& regions, Memory* memory)
    : search_(std::allocate_shared<PathSearch>(std::pmr::polymorphic_allocator<PathSearch>(memory), mesh, regions,
                                               memory)) {}

Task<GeodesicPath> shorten_way(Pace& pace, PathShortener& shortener, SurfacePoint from, SurfacePoint to,
                               const SurfaceCurves* way, SurfaceCurves& out) {
    PathSearch& search = *static_cast<PathSearch*>(shortener.search_.get());
    search.begin(from, to);
    const bool found = co_await find_sleeve(pace, search, way, IntegralCurveStop::target);
    if (!found) co_return GeodesicPath{};
    co_return co_await straighten(pace, search, out);
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
