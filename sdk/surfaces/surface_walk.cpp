// SPDX-License-Identifier: MIT
#include "surfaces/surface_walk.h"

#include "surfaces/mesh_measures_normals.h"

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

}  // namespace

SurfaceWalkKernel::SurfaceWalkKernel(const Mesh& mesh, const SurfacePoint& from, const SurfacePoint& to,
                                     SurfaceCurves& out)
    : mesh_(mesh), points_{from, to}, from_(place_in(mesh, from)), to_(place_in(mesh, to)), out_(out), drawn_(from_) {}

void SurfaceWalkKernel::begin() {
    start_ = where(mesh_, from_);
    along_ = where(mesh_, to_) - start_;
    left_ = (smooth_normal(mesh_, points_[0]) + smooth_normal(mesh_, points_[1])).cross(along_);
    corner_ = corner_at(mesh_, from_);
    if (out_.points.size() > out_.offsets.back()) {
        joint_ = out_.points.back();
        out_.points.pop_back();
    }
    before_ = out_.points.size();
    pass_ = Pass::look;
    if (from_ != to_) return;
    give_up();  // there is nothing to append
    found_ = true;
}

void SurfaceWalkKernel::give_up() {
    out_.points.resize(before_);
    if (joint_) out_.points.push_back(*joint_);
    length_ = 0;
    pass_ = Pass::done;
}

// The next corner of those around the start; no_index after the last.
Corner SurfaceWalkKernel::next_around(Corner corner) const {
    switch (from_.on) {
        case SurfacePlace::On::vertex: {
            const Corner next = mesh_.turn(corner);
            return next == mesh_.corner_of_vertex[from_.index] ? no_index : next;
        }
        case SurfacePlace::On::edge: return corner == from_.index ? mesh_.opposite(corner) : no_index;
        default: return no_index;
    }
}

bool SurfaceWalkKernel::is_at_start(Corner edge) const {
    switch (from_.on) {
        case SurfacePlace::On::vertex:
            return mesh_.vertex_at(edge) == from_.index || mesh_.vertex_at(next_corner(edge)) == from_.index;
        case SurfacePlace::On::edge: return edge == from_.index || mesh_.opposite(edge) == from_.index;
        default: return false;
    }
}

// Where along an edge the plane meets it.
double SurfaceWalkKernel::share(Corner edge) const {
    const double from = height(mesh_.vertex_at(edge)), to = height(mesh_.vertex_at(next_corner(edge)));
    const double t = from / (from - to);
    return t < snap_weight ? 0 : t > 1 - snap_weight ? 1 : t;
}

// Seen from within the triangle, ways leave over edges that begin to the right of the plane and end to its left.
bool SurfaceWalkKernel::leads_out(Corner edge) const {
    return !(height(mesh_.vertex_at(edge)) > 0) && height(mesh_.vertex_at(next_corner(edge))) > 0;
}

// One triangle around the start: it holds the end as well, or the way may begin through it.
void SurfaceWalkKernel::look() {
    const uint32_t triangle = triangle_of(corner_);
    SurfacePoint end{};
    if (find_in(mesh_, to_, triangle, end)) {
        arrive(triangle, end);
        return;
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
    if (corner_ != no_index) return;
    if (exit_ == no_index) {
        give_up();
    } else {
        pass_ = Pass::walk;
    }
}

void SurfaceWalkKernel::step() {
    draw(place_on_edge(mesh_, exit_, share(exit_)), triangle_of(exit_));
    const Corner across = mesh_.opposite(exit_);
    if (across == no_index || ++steps_ > mesh_.triangle_count() || length_ > most_detour * along_.norm()) {
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
void SurfaceWalkKernel::draw(const SurfacePlace& to, uint32_t triangle) {
    if (to == drawn_) return;
    SurfacePoint a{}, b{};
    find_in(mesh_, drawn_, triangle, a);
    find_in(mesh_, to, triangle, b);
    out_.points.push_back(a);
    length_ += (position_of(mesh_, b) - position_of(mesh_, a)).norm();
    drawn_ = to;
}

void SurfaceWalkKernel::arrive(uint32_t triangle, const SurfacePoint& end) {
    draw(to_, triangle);
    out_.points.push_back(end);
    found_ = true;
    pass_ = Pass::done;
}

bool SurfaceWalkKernel::run(uint32_t count) {
    for (; count > 0 && pass_ != Pass::done; --count) {
        switch (pass_) {
            case Pass::begin: begin(); break;
            case Pass::look: look(); break;
            case Pass::walk: step(); break;
            case Pass::done: break;
        }
    }
    return pass_ == Pass::done;
}

}  // namespace flg
