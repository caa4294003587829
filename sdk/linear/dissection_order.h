// SPDX-License-Identifier: MIT
// In which order to eliminate the unknowns of a matrix whose rows have places: nested dissection (George: Nested
// dissection of a regular finite element mesh, 1973), cut geometrically. A set is cut across one of the axes where few
// entries of the matrix cross, as around a neck; a small one across the longest axis, at the mean. Points of one side
// that touch the other come after both. Sets of at most 64 are ordered by minimum degree, as sets of bits; the degrees
// count what a row touches outside of its set, too. On meshes of surfaces the factor has about as many entries as with
// minimum degree on the whole.
#pragma once

#include <span>

#include "core/vec.h"
#include "linear/symmetric_matrix.h"
#include "runtime/task.h"

namespace flg {

// The row at each place of the order. `places`: one a row. Takes 28 bytes and about 0.09 log2(n / 8) us a row.
Task<Buffer<uint32_t>> dissection_order(Pace& pace, const SymmetricMatrix& matrix, std::span<const Vec3> places);

}  // namespace flg
