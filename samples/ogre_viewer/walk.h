// SPDX-License-Identifier: MIT
// A walk for the skeletons of drawn animals, by the names of their bones: what an animator would make.
#pragma once

#include <OgreSkeleton.h>

namespace viewer {

constexpr const char* kWalk = "walk";

// Bones that a walk does not know stay still.
void add_walk(Ogre::Skeleton& skeleton);

}  // namespace viewer
