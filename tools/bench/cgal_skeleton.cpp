// SPDX-License-Identifier: MIT
#include "bench/cgal_skeleton.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_2.h>
#include <CGAL/create_straight_skeleton_2.h>

namespace flg::bench {

bool cgal_skeleton(const double* points, uint32_t count) {
    using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
    CGAL::Polygon_2<Kernel> ring;
    for (uint32_t i = 0; i < count; ++i) ring.push_back({points[2 * i], points[2 * i + 1]});
    return CGAL::create_interior_straight_skeleton_2(ring.vertices_begin(), ring.vertices_end()) != nullptr;
}

}  // namespace flg::bench
