// SPDX-License-Identifier: MIT
// What the wavefront takes for zero. Lengths are shares of the contour's diagonal; found by measuring on contours drawn
// by chance on grids, turned and jittered.
#pragma once

namespace flg::wave {

constexpr double coincident = 1e-12;        // vertices nearer than this are at one place
constexpr double closes = 1e-11;            // a diagonal's ends that pass each other nearer than this meet
constexpr double closing_lead = 1e-7;       // before a diagonal closes its triangle seems flat: a double root's error
constexpr double on_line = 4e-15;           // a vertex nearer than this to an edge's line is on it
constexpr double flat_height = 1e-15;       // a triangle less high than this is flat
constexpr double walk_height = 1e-13;       // the same for the neighbour of a flat one
constexpr double rate_noise = 1e-12;        // relative, of the rate at which an area changes
constexpr double far_from_parallel = 1e-2;  // |n1 x n2| above this: two lines give a good point
constexpr double one_place = 1e-6;          // the last two vertices of a loop nearer than this end in one node

}  // namespace flg::wave
