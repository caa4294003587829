// SPDX-License-Identifier: MIT
// What makes a straight skeleton one, checked from nodes and faces alone, in long double. L is the diagonal of the
// contour's box; tolerances are shares of it.
//
// I1 one face an edge, beginning with it, all other nodes later        I6 the faces' areas add up to the contour's
// I2 each arc is of two faces                                          I7 the front at each node goes on as it has to
// I3 as many nodes and arcs as a plane graph with that many holes has  I8 arcs between edges on one line are upright
// I4 nodes are as far from their faces' lines as their time says       I9 no node of a face is on another of its arcs
// I5 faces are monotone along their edges, of positive area, simple
//
// I9 means nearer than 1e-12 L; nearer than 1e-14 L if the tolerance is above 1e-9, for contours with true distances
// between.
#pragma once

#include <string>
#include <vector>

#include "skeletons/contour.h"
#include "skeletons/skeleton_graph.h"

namespace flg::test {

// Sentences that begin with the invariant's name; none if all hold.
std::vector<std::string> broken_invariants(const Contour& contour, const StraightSkeleton& skeleton,
                                           double tolerance = 1e-9);

}  // namespace flg::test
