// SPDX-License-Identifier: MIT
// A sampled surface seen through a coarser scale: samples about so far apart, fitted to all finer ones within some
// spacings, by scales that double. What is smaller (noise, creases, relief) is rounded off or gone.
//
// Samples are chosen greedily, in the order of the finer ones, such that none is nearer to another one that faces the
// same way than the scale. Where finer ones lie farther apart than that each stays as it is.
#pragma once

#include "splines/manifolds/oriented_samples.h"

namespace flg {

// `scale`: metres, above 0. Fails where it is more than a quarter of the surface's size. About 5 us a sample.
Task<OrientedSamples> smoothed_samples(Pace& pace, OrientedSamples surface, double scale);

}  // namespace flg
