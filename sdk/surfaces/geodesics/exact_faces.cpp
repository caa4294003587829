// SPDX-License-Identifier: MIT
#include "surfaces/geodesics/exact_faces.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "runtime/each.h"

namespace flg {

namespace {

constexpr double full_turn = 2 * std::numbers::pi;
// Beyond a full turn, radians: what rounding of double makes of a flat fan.
constexpr double turn_rounding = 1e-12;

ExactFace lay_out(const Mesh& mesh, const RegionSet& within, uint32_t triangle) {
    ExactFace face{};
    face.vertices = mesh.triangles[triangle];
    for (uint32_t k = 0; k < 3; ++k) {
        const Corner corner = 3 * triangle + k, across = mesh.opposite(corner);
        const bool goes_on = across != no_index && within.contains(mesh.regions[triangle_of(across)]);
        face.across[k] = goes_on ? across : no_index;
        const Vec3 start = mesh.position(mesh.vertex_at(corner));
        const Vec3 edge = mesh.position(mesh.vertex_at(next_corner(corner))) - start;
        const Vec3 side = mesh.position(mesh.vertex_at(previous_corner(corner))) - start;
        const double length = edge.norm();
        face.lengths[k] = length;
        face.along[k] = length > 0 ? edge.dot(side) / length : side.norm();
        face.above[k] = length > 0 ? edge.cross(side).norm() / length : 0;
    }
    return face;
}

}  // namespace

Task<void> lay_out_faces(Pace& pace, const Mesh& mesh, const RegionSet& within, ExactFaces& out) {
    Buffer<double> angles(mesh.vertex_count(), pace.memory());
    co_await each(pace, mesh.vertex_count(), Cost::some_ns, [&](uint32_t v) {
        angles[v] = 0;
        out.bends[v] = Bend::none;
    });
    double sum = 0;
    uint64_t edges = 0;
    co_await each(pace, mesh.triangle_count(), Cost::hundreds_of_ns, [&](uint32_t t) {
        ExactFace& face = out.faces[t];
        if (!within.contains(mesh.regions[t])) {
            face.vertices = {no_index, no_index, no_index};
            return;
        }
        face = lay_out(mesh, within, t);
        bool narrow = false;
        for (uint32_t k = 0; k < 3; ++k) {
            narrow = narrow || is_narrow(face, k);
            out.longest = std::max(out.longest, face.lengths[k]);
            sum += face.lengths[k];
            ++edges;
            angles[face.vertices[k]] += std::atan2(face.above[k], face.along[k]);
            if (face.across[k] != no_index && face.lengths[k] > 0) continue;
            const Bend bend = face.lengths[k] > 0 ? Bend::half_turns : Bend::any;
            for (const uint32_t vertex : {face.vertices[k], face.vertices[(k + 1) % 3]})
                out.bends[vertex] = std::max(out.bends[vertex], bend);
        }
        out.narrow_count += narrow ? 1 : 0;
    });
    out.mean = edges == 0 ? 0 : sum / static_cast<double>(edges);
    co_await each(pace, mesh.vertex_count(), Cost::some_ns, [&](uint32_t v) {
        if (angles[v] > full_turn + turn_rounding) out.bends[v] = std::max(out.bends[v], Bend::half_turns);
    });
}

}  // namespace flg
