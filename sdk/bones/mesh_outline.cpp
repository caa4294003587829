// SPDX-License-Identifier: MIT
#include "bones/mesh_outline.h"

namespace flg {
namespace {

constexpr size_t most_points = 1 << 24;

}  // namespace

MeshOutlineKernel::MeshOutlineKernel(const Mesh& mesh, const std::pmr::vector<bool>& regions, const Vec3& towards,
                                     OutlinePlane& plane, Contour& out, Memory* memory)
    : mesh_(mesh),
      regions_(regions),
      towards_(towards),
      plane_(plane),
      out_(out),
      first_side_(mesh.vertex_count(), memory),
      sides_(memory),
      loop_begins_(memory) {}

bool MeshOutlineKernel::run(uint32_t count) {
    for (; count > 0 && pass_ != Pass::done; --count) step();
    return pass_ == Pass::done;
}

void MeshOutlineKernel::step() {
    switch (pass_) {
        case Pass::look: {
            if (at_ == mesh_.triangle_count()) {
                set_plane();
                return enter(Pass::clear);
            }
            const uint32_t triangle = at_++;
            if (!counts(triangle)) return;
            const Triple& t = mesh_.triangles[triangle];
            const Vec3 a = mesh_.position(t[0]), b = mesh_.position(t[1]), c = mesh_.position(t[2]);
            sum_ += (b - a).cross(c - a);
            middle_ += (a + b + c) / 3;
            ++counted_;
            return;
        }
        case Pass::clear:
            if (at_ == mesh_.vertex_count()) return enter(Pass::sides);
            first_side_[at_++] = no_index;
            return;
        case Pass::sides:
            if (at_ == mesh_.triangle_count()) return enter(Pass::chain);
            return add_sides(at_++);
        case Pass::chain: return chain();
        case Pass::back:  // by the ways between the loops; the last one's own beginning is there already
            if (loop_begins_.size() > 1) {
                loop_begins_.pop_back();
                return add_point(loop_begins_.back());
            }
            // The ring is closed by itself.
            if (out_.size() > 1) {
                out_.points.pop_back();
                out_.input_points.pop_back();
            }
            out_.offsets.push_back(out_.size());
            return enter(Pass::done);
        case Pass::done: return;
    }
}

bool MeshOutlineKernel::counts(uint32_t triangle) const {
    const uint32_t region = mesh_.regions[triangle];
    return regions_.empty() || (region < regions_.size() && regions_[region]);
}

bool MeshOutlineKernel::is_front(uint32_t triangle) const {
    const Triple& t = mesh_.triangles[triangle];
    const Vec3 a = mesh_.position(t[0]);
    return (mesh_.position(t[1]) - a).cross(mesh_.position(t[2]) - a).dot(plane_.towards) > 0;
}

void MeshOutlineKernel::set_plane() {
    if (counted_ == 0) throw Failure(FLG_ERROR_INVALID_ARGUMENT, "desc.regions have no triangles");
    if (towards_.squaredNorm() == 0) towards_ = sum_;
    if (!(towards_.squaredNorm() > 0))
        throw Failure(FLG_ERROR_INVALID_ARGUMENT,
                      "desc.direction is 0, and the triangles look in all directions alike: say from where");
    plane_.towards = towards_.normalized();
    // Up is up, or where it is looked at from above or below, away from the viewer.
    const Vec3 world_up = std::abs(plane_.towards.y()) < 0.99 ? Vec3::UnitY() : Vec3(-Vec3::UnitZ());
    plane_.right = world_up.cross(plane_.towards).normalized();
    plane_.up = plane_.towards.cross(plane_.right);
    plane_.origin = middle_ / counted_;
    out_.offsets.push_back(0);
}

// Sides to what is not seen from the same side, in the order that keeps the covered inside to the left.
void MeshOutlineKernel::add_sides(uint32_t triangle) {
    if (!counts(triangle)) return;
    const bool front = is_front(triangle);
    for (uint32_t k = 0; k < 3; ++k) {
        const uint32_t other = mesh_.neighbours[triangle][k];
        if (other != no_index && counts(other) && is_front(other) == front) continue;
        const uint32_t a = mesh_.triangles[triangle][k], b = mesh_.triangles[triangle][(k + 1) % 3];
        const uint32_t from = front ? a : b, to = front ? b : a;
        if (sides_.size() == most_points)
            throw Failure(FLG_ERROR_LIMIT, "the outline has more than %zu sides", most_points);
        sides_.push_back({to, first_side_[from]});
        first_side_[from] = static_cast<uint32_t>(sides_.size()) - 1;
    }
}

void MeshOutlineKernel::add_point(uint32_t vertex) {
    const Vec3 p = mesh_.position(vertex) - plane_.origin;
    out_.points.push_back({p.dot(plane_.right), p.dot(plane_.up)});
    out_.input_points.push_back(vertex);
}

// Follows sides until there are none: as many end at a vertex as begin there, so a way ends where it began.
void MeshOutlineKernel::chain() {
    if (here_ != no_index) {
        const uint32_t side = first_side_[here_];
        if (side != no_index) {
            first_side_[here_] = sides_[side].next;
            here_ = sides_[side].to;
            return add_point(here_);
        }
        here_ = no_index;
        ++at_;
    }
    if (at_ == mesh_.vertex_count()) return enter(Pass::back);
    if (first_side_[at_] == no_index) {
        ++at_;
        return;
    }
    here_ = at_;
    loop_begins_.push_back(at_);
    add_point(at_);
}

}  // namespace flg
