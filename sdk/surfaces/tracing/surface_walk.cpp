// SPDX-License-Identifier: MIT
#include "surfaces/tracing/surface_walk.h"

#include <optional>

#include "runtime/each.h"
#include "surfaces/mesh/mesh_measures.h"
#include "surfaces/mesh/surface_place.h"

namespace flg {

namespace {

// A corner of a triangle that the place belongs to; of a vertex, the first of its fan.
Corner corner_at(const Mesh& mesh, const SurfacePlace& place) {
    switch (place.on) {
        case SurfacePlace::On::vertex: return mesh.corner_of_vertex[place.index];
        case SurfacePlace::On::edge: return place.index;
        default: return 3 * place.index;
    }
}

Vec3 where(const Mesh& mesh, const SurfacePlace& place) {
    SurfacePoint point{};
    find_in(mesh, place, triangle_of(corner_at(mesh, place)), point);
    return position_of(mesh, point);
}

class Walker {
public:
    Walker(const Mesh& mesh, const SurfacePoint& from, const SurfacePoint& to, SurfaceCurves& out);

    // One triangle around the start: it holds the end as well, or the way may begin through it. False: it was the last.
    bool look();
    // Through the next triangle.
    void step();
    bool has_ended() const { return ended_; }
    SurfaceWalk result() const { return {found_, length_}; }

private:
    void give_up();
    void arrive(uint32_t triangle, const SurfacePoint& end);
    Corner next_around(Corner corner) const;
    bool is_at_start(Corner edge) const;
    double height(uint32_t vertex) const { return left_.dot(mesh_.position(vertex) - start_); }
    double share(Corner edge) const;
    bool leads_out(Corner edge) const;
    void draw(const SurfacePlace& to, uint32_t triangle);

    const Mesh& mesh_;
    const SurfacePlace from_, to_;
    SurfaceCurves& out_;
    Vec3 start_, along_, left_;          // the plane; `left_` is across it
    Corner corner_ = no_index;           // of the triangle around the start that comes next
    Corner exit_ = no_index;             // the edge that is crossed next
    double ahead_ = 0;                   // how straight ahead it is, at the start
    SurfacePlace drawn_;                 // how far the way has come
    size_t before_ = 0;                  // points of `out` that stay
    std::optional<SurfacePoint> joint_;  // the one behind them, where the way goes on
    uint32_t steps_ = 0;
    bool ended_ = false, found_ = false;
    double length_ = 0;
};

Walker::Walker(const Mesh& mesh, const SurfacePoint& from, const SurfacePoint& to, SurfaceCurves& out)
    : mesh_(mesh), from_(place_in(mesh, from)), to_(place_in(mesh, to)), out_(out), drawn_(from_) {
    start_ = where(mesh_, from_);
    along_ = where(mesh_, to_) - start_;
    left_ = (smooth_normal(mesh_, from) + smooth_normal(mesh_, to)).cross(along_);
    corner_ = corner_at(mesh_, from_);
    if (out_.points.size() > out_.offsets.back()) {
        joint_ = out_.points.back();
        out_.points.pop_back();
    }
    before_ = out_.points.size();
    if (from_ != to_) return;
    give_up();  // there is nothing to append
    found_ = true;
}

void Walker::give_up() {
    out_.points.resize(before_);
    if (joint_) out_.points.push_back(*joint_);
    length_ = 0;
    ended_ = true;
}

// The next corner of those around the start; no_index after the last.
Corner Walker::next_around(Corner corner) const {
    switch (from_.on) {
        case SurfacePlace::On::vertex: {
            const Corner next = mesh_.turn(corner);
            return next == mesh_.corner_of_vertex[from_.index] ? no_index : next;
        }
        case SurfacePlace::On::edge: return corner == from_.index ? mesh_.opposite(corner) : no_index;
        default: return no_index;
    }
}

bool Walker::is_at_start(Corner edge) const {
    switch (from_.on) {
        case SurfacePlace::On::vertex:
            return mesh_.vertex_at(edge) == from_.index || mesh_.vertex_at(next_corner(edge)) == from_.index;
        case SurfacePlace::On::edge: return edge == from_.index || mesh_.opposite(edge) == from_.index;
        default: return false;
    }
}

// Where along an edge the plane meets it.
double Walker::share(Corner edge) const {
    const double from = height(mesh_.vertex_at(edge)), to = height(mesh_.vertex_at(next_corner(edge)));
    const double t = from / (from - to);
    return t < snap_weight ? 0 : t > 1 - snap_weight ? 1 : t;
}

// Seen from within the triangle, ways leave over edges that begin to the right of the plane and end to its left.
bool Walker::leads_out(Corner edge) const {
    return !(height(mesh_.vertex_at(edge)) > 0) && height(mesh_.vertex_at(next_corner(edge))) > 0;
}

bool Walker::look() {
    const uint32_t triangle = triangle_of(corner_);
    SurfacePoint end{};
    if (find_in(mesh_, to_, triangle, end)) {
        arrive(triangle, end);
        return false;
    }
    for (uint32_t k = 0; k < 3; ++k) {
        const Corner edge = 3 * triangle + k;
        if (is_at_start(edge) || !leads_out(edge)) continue;
        const Vec3 from = mesh_.position(mesh_.vertex_at(edge)),
                   to = mesh_.position(mesh_.vertex_at(next_corner(edge)));
        const double ahead = (from + share(edge) * (to - from) - start_).stableNormalized().dot(along_);
        if (exit_ != no_index && !(ahead > ahead_)) continue;
        exit_ = edge;
        ahead_ = ahead;
    }
    corner_ = next_around(corner_);
    if (corner_ != no_index) return true;
    if (exit_ == no_index) give_up();
    return false;
}

void Walker::step() {
    draw(place_on_edge(mesh_, exit_, share(exit_)), triangle_of(exit_));
    const Corner across = mesh_.opposite(exit_);
    if (across == no_index || ++steps_ > mesh_.triangle_count() || length_ > max_walk_detour * along_.norm()) {
        give_up();
        return;
    }
    SurfacePoint end{};
    if (find_in(mesh_, to_, triangle_of(across), end)) {
        arrive(triangle_of(across), end);
        return;
    }
    exit_ = leads_out(next_corner(across)) ? next_corner(across) : previous_corner(across);
}

// A place is drawn only when the way leaves it: several edges may be crossed at the same vertex.
void Walker::draw(const SurfacePlace& to, uint32_t triangle) {
    if (to == drawn_) return;
    SurfacePoint a{}, b{};
    find_in(mesh_, drawn_, triangle, a);
    find_in(mesh_, to, triangle, b);
    out_.points.push_back(a);
    length_ += (position_of(mesh_, b) - position_of(mesh_, a)).norm();
    drawn_ = to;
}

void Walker::arrive(uint32_t triangle, const SurfacePoint& end) {
    draw(to_, triangle);
    out_.points.push_back(end);
    found_ = ended_ = true;
}

}  // namespace

Task<SurfaceWalk> add_surface_walk(Pace& pace, const Mesh& mesh, SurfacePoint from, SurfacePoint to,
                                   SurfaceCurves& out) {
    Walker walker(mesh, from, to, out);
    Slice slice(Cost::hundreds_of_ns);
    for (bool looks = !walker.has_ended(); looks;) {
        looks = walker.look();
        if (slice.is_over()) co_await pace;
    }
    while (!walker.has_ended()) {
        walker.step();
        if (slice.is_over()) co_await pace;
    }
    co_return walker.result();
}

}  // namespace flg
