// SPDX-License-Identifier: MIT
// One step of an integral curve: from a place on the mesh straight through one triangle, the way the field rises most.
//
// The gradient is constant in a triangle. Its direction is kept as the rates at which the three weights change: with the
// edge e_i opposite to corner i and w = sum f_j e_j, rate i is e_i . w up to a positive factor, and the field rises at
// w . w. No division by the area: triangles without area are crossed like any other, unless the
// field is linear along their line too: then they have no direction, and a curve that meets one slides along its edge.
#pragma once

#include <span>

#include "surfaces/region_set.h"
#include "surfaces/surface_place.h"

namespace flg {

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

struct IntegralCurveStep {
    bool rises = false;      // false: nothing near the place is higher, or it lies outside of the field
    uint32_t triangle = 0;   // that it goes through
    SurfacePlace to{};       // at the triangle's border; always strictly higher
    bool at_border = false;  // the place is on the border of the mesh, the regions or the finite values
    bool leaves = false;     // the field would rise beyond that border: the step, if any, slides along it
    uint32_t cost = 1;       // triangles looked at
};

// From a vertex: along the steepest of its edges and triangles. From an edge: into the triangle whose field rises away
// from it, the steeper one of two; along the edge where both fall away, or at a border.
IntegralCurveStep next_step(const SlopedField& field, const SurfacePlace& from);

}  // namespace flg
