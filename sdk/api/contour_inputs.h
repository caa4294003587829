// SPDX-License-Identifier: MIT
// Contours as hosts give them, checked and cleaned.
#pragma once

#include "filigree/filigree_skeleton.h"
#include "skeletons/contour.h"

namespace flg {

FlgContourView default_contour_view();

// Of desc.contour. Throws, with a sentence that names what is wrong. What is to be repaired is not cleaned.
Contour read_contour(const FlgContourView* contour, Memory* memory, bool to_repair = false);

}  // namespace flg
