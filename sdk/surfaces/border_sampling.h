// SPDX-License-Identifier: MIT
// Points evenly along the borders of regions, by arc length: where operators of tangles begin, sec. 3.3 and 4.2 of Nazzaro,
// Puppo, Pellacini: geoTangle (2021).
#pragma once

#include "surfaces/region_set.h"
#include "surfaces/surface_curves.h"

namespace flg {

// Borders run with the regions to their left, also where the surface ends; at a vertex where borders touch each keeps to its
// own triangles. Each becomes a closed curve whose value is its length; the first point is at a vertex, at the border's least
// corner, and curves are in the order of these.
class BorderSamplingKernel {
public:
    // Each border gets a whole number of equal steps: as near to `spacing` (metres, > 0) as can be, three at least. Fails
    // with FLG_ERROR_LIMIT if a border would get more than 2^24. All outlive the kernel.
    BorderSamplingKernel(const Mesh& mesh, const RegionSet& regions, float spacing, SurfaceCurves& curves,
                         Memory* memory);

    // A unit is an edge, a corner or a point: 10 to 30 ns.
    bool run(uint32_t count);

private:
    enum class Pass { clear, find, measure, place, done };

    bool is_border(Corner edge) const;
    bool walk();
    void begin_places();
    void place();

    const Mesh& mesh_;
    const RegionSet& regions_;
    const float spacing_;
    SurfaceCurves& curves_;
    Buffer<uint64_t> visited_;  // a bit an edge
    Pass pass_ = Pass::clear;
    Corner at_ = 0;              // the first edge of the border
    Corner edge_ = 0;            // that is being walked along
    Corner turning_ = no_index;  // on the way to the next one: an edge that starts at its end
    double walked_ = 0;          // metres, up to the edge
    double length_ = 0;          // of the border
    uint32_t placed_ = 0, count_ = 0;
};

}  // namespace flg
