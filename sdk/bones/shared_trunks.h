// SPDX-License-Identifier: MIT
// Where the axis of a trunk forks long before its limbs part. Between two legs the straight skeleton's front comes up
// into the body, so the axis forks as high as the chest and both its branches run down inside of the trunk. Animators
// expect one spine there, and a pelvis that the legs hang on.
//
// At a junction, two branches that run side by side become one trunk while they are nearer to each other than half
// of the trunk's width: its joints lie in the middle between them. That counts if the trunk becomes long for the room
// around the junction, 0.6 of it; where others than one trunk come together, as in a star, all of it. Two branches at
// right angles never do. Mirror images do the same.
//
// This is none of the paper's (Ma, Wang, Li, Zhang 2021), and only done where `detail` is not 0.
#pragma once

#include <array>
#include <vector>

#include "bones/part.h"
#include "runtime/task.h"

namespace flg {

struct SharedTrunk {
    struct Joint {
        Point2 at;
        double radius;
    };

    uint32_t node;  // that the axis forks at
    std::array<uint32_t, 2> branches;
    std::array<uint32_t, 2> samples;  // of these: where the branches part, counted from their beginnings
    std::pmr::vector<Joint> joints;   // from the node on; the last one is between both samples
};

// Of a part, at most one a node, in the nodes' order. Takes about 0.1 us a sample beside the trunk, and a look at the
// outline a joint.
Task<std::pmr::vector<SharedTrunk>> find_shared_trunks(Pace& pace, const HeldPart& part, double detail);

// How many bones a stretch becomes, by its length over its width.
uint32_t pieces_of(double length, double width, double detail);

}  // namespace flg
