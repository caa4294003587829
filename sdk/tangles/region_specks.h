// SPDX-License-Identifier: MIT
// Specks: components of a partition (region_partition.h) that are too small for anyone to have asked for them, as cuts
// leave where lines nearly meet. Each goes to a component of its leaf beside it: that with the longest border between
// them.
#pragma once

#include "tangles/region_partition.h"

namespace flg {

// `leaf_of`: the leaf of each component. Returns the component that each goes to: itself, but for specks, whose area is
// below `least_area` (square metres); none has more than 256 triangles. What has nothing larger beside it stays. Cost:
// tens of ns a component, up to 30 us a speck.
Task<Buffer<uint32_t>> merge_specks(Pace& pace, const RegionPartition& partition, const Buffer<uint32_t>& leaf_of,
                                    double least_area);

}  // namespace flg
