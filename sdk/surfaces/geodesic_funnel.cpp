// SPDX-License-Identifier: MIT
#include "surfaces/geodesic_funnel.h"

namespace flg {

namespace {

// The third corner of a triangle, left of the way from `a` to `b`; a_3d, b_3d, c_3d are its corners in space.
Vec2 place_third(const Vec2& a, const Vec2& b, const Vec3& a_3d, const Vec3& b_3d, const Vec3& c_3d) {
    const Vec3 base = b_3d - a_3d, side = c_3d - a_3d;
    const double squared = base.squaredNorm();
    if (!(squared > 0)) return a + Vec2(side.norm(), 0);
    const double along = side.dot(base) / squared, up = side.cross(base).norm() / squared;
    const Vec2 way = b - a;
    return a + along * way + up * Vec2(-way.y(), way.x());
}

}  // namespace

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

// Adds a point to a wall of the funnel, takes from it what the point makes superfluous and, if the point lies beyond the
// other wall, moves the apex along that. Returns how many points it looked at.
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

bool GeodesicFunnel::run(uint32_t& units) {
    const uint32_t gates = sleeve_->size() - 1;
    while (units > 0) {
        const uint32_t at = gates_.size();
        uint32_t spent = 1;
        if (at == gates) {
            // The end, as the last gate.
            PathBend end{gates, true, {}};
            const uint32_t triangle = sleeve_->last();
            SurfacePoint point{};
            find_in(mesh_, to_, triangle, point);
            const Weights weights = weights_of(point);
            if (gates == 0) {
                // Both in one triangle.
                start_ = Vec2::Zero();
                SurfacePoint from{};
                find_in(mesh_, from_, triangle, from);
                end.at = Vec2((position_of(mesh_, point) - position_of(mesh_, from)).norm(), 0);
                bends_.push_back(end);
                return true;
            }
            const SleeveGate& gate = gates_.back();
            const Corner entry = mesh_.opposite(gate.corner);
            end.at = weights[entry % 3] * gate.left + weights[next_corner(entry) % 3] * gate.right +
                     weights[previous_corner(entry) % 3] * unfold_apex();
            add(true, end);
            for (const PathBend& bend : left_) bends_.push_back(bend);
            return true;
        }
        const Corner exit = exit_of(at);
        if (at == 0) {
            unfold_first((*sleeve_)[0], exit);
            apex_ = {0, true, start_};
            add(true, {0, true, gates_[0].left});
            add(false, {0, false, gates_[0].right});
        } else {
            const SleeveGate before = gates_.back();
            const Vec2 apex = unfold_apex();
            // One end stays.
            const bool left_is_new = exit == next_corner(mesh_.opposite(before.corner));
            gates_.push_back(left_is_new ? SleeveGate{exit, before.right, apex} : SleeveGate{exit, apex, before.left});
            spent = add(left_is_new, {at, left_is_new, apex});
        }
        units -= std::min(units, spent);
    }
    return false;
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

}  // namespace flg
