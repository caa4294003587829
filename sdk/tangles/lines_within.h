// SPDX-License-Identifier: MIT
// The parts of lines that run within regions: what an operator cuts along.
#pragma once

#include "surfaces/region_set.h"
#include "surfaces/surface_curves.h"

namespace flg {

class LinesWithinKernel {
public:
    // Appends to `out`. A closed line that stays within stays closed; others begin and end where they come in and go out. All
    // must outlive the run.
    LinesWithinKernel(const Mesh& mesh, const RegionSet& regions, const SurfaceCurves& lines, SurfaceCurves& out)
        : mesh_(mesh), regions_(regions), lines_(lines), out_(out) {}

    // Spends `count` units of about 30 ns, a point each; true when done.
    bool run(uint32_t count);

private:
    void look();
    void end_piece(uint32_t last);
    void end_line();

    const Mesh& mesh_;
    const RegionSet& regions_;
    const SurfaceCurves& lines_;
    SurfaceCurves& out_;
    uint32_t line_ = 0;
    uint32_t point_ = 0;      // whose stretch comes next
    bool all_within_ = true;  // of the line's stretches so far
    uint32_t triangle_ = 0;   // of the last one within
};

}  // namespace flg
