// SPDX-License-Identifier: MIT
// The open borders of a mesh, for curves on its smooth surface, which goes on a little there: how far inside of them a
// point is, and which way is in.
//
// The distance is that from the nearest border edge or vertex, along the surface: what is along the mesh's normal does
// not count. Its sign is that of the edge's or, at a vertex, of both edges' inward directions, which at a corner that
// points out and at one that points in is the right one.
#pragma once

#include <optional>
#include <span>

#include "core/vec.h"
#include "splines/manifolds/point_tree.h"
#include "surfaces/mesh/mesh.h"

namespace flg {

// The border as seen from a point near it.
struct BorderView {
    double inside;     // metres: so far within the border; negative beyond it
    Vec3 inwards;      // the way in which that grows, of unit length
    double curvature;  // of the line of points as far inside, 1 / m; above 0 where it bends inwards, as round a disc
    // At a vertex, to rounding: the two edges there.
    bool at_vertex;
    Vec3 ways[2];  // along them, away from the vertex
    Vec3 inwards_of[2];
    bool points_in;  // the corner has more than 180 degrees of surface around it
};

class MeshBorder {
public:
    // An edge of the border; `before` and `after` share its first and its second vertex.
    struct Edge {
        Vec3 from, to, inwards, normal;
        uint32_t before, after;
    };

    MeshBorder(Buffer<Edge> edges, PointTree tree, double mean_length, double reach)
        : edges_(std::move(edges)), tree_(std::move(tree)), mean_length_(mean_length), reach_(reach) {}

    // False where no border is near. With a normal only edges count whose mesh faces the same way. Below 1 us.
    bool look(const Vec3& x, const Vec3* normal, BorderView& out) const;

    // Harmonic, of the edges' lengths, m.
    double mean_length() const { return mean_length_; }
    std::span<const Edge> edges() const { return {edges_.data(), edges_.size()}; }

private:
    Buffer<Edge> edges_;
    PointTree tree_;
    double mean_length_;
    double reach_;  // m: farther away no border is seen
};

// Of a mesh, which does not change meanwhile; none where it has no borders. `deviation`: how far the smooth surface is
// from it, m. About 10 ns a corner and 1 us a border edge.
Task<std::optional<MeshBorder>> mesh_border(Pace& pace, const Mesh& mesh, double deviation);

}  // namespace flg
