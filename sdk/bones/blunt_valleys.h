// SPDX-License-Identifier: MIT
// Valleys of an outline made blunt. Where an outline turns inwards sharply, as between two fingers, the front of its
// straight skeleton runs into the shape many times as fast as its distance grows, and the axis forks as far down as the
// wrist. A tiny edge across such a point makes two of it, each with half of the turn, whose fronts go about as fast as
// those of a medial axis (Tanase, Veltkamp: Straight skeleton approximating the medial axis, 2004).
#pragma once

#include <optional>

#include "bones/contour_mirror.h"

namespace flg {

// `reach`: how far the edges' ends are from the point, or less where edges are short. A mirror image stays one to the
// last bit.
Task<Contour> with_blunt_valleys(Pace& pace, Contour contour, std::optional<MirrorAxis> mirror, double reach);

}  // namespace flg
