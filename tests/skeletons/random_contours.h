// SPDX-License-Identifier: MIT
// Contours drawn by chance, of the kinds that skeletons are lost on: each a function of its seed.
#pragma once

#include <cstdint>

#include "skeletons/skeletons.h"

namespace flg::test {

// No two edges of one ring touch but at the points that follow each other: by trying all pairs.
bool is_simple(const std::vector<Point2>& ring);

// A point for each of n directions from the middle.
Rings random_star(uint64_t seed, uint32_t n);
// A closed way through n points anywhere, without crossings.
Rings random_tour(uint64_t seed, uint32_t n);
// The same through points of a grid that is `cells` wide: many on one line, many changes at one time. Fewer points
// where edges would touch others.
Rings grid_tour(uint64_t seed, uint32_t n, uint32_t cells);
// What is drawn around a connected set of the pixels of a square picture, with its holes. `points_at_all`: also
// points between pixels on one line.
Rings pixel_shape(uint64_t seed, uint32_t width, bool points_at_all);
// A star with stars for holes on a grid.
Rings star_with_holes(uint64_t seed, uint32_t n, uint32_t holes_wide, uint32_t hole_points);
// Teeth alike; with a tilt they are no longer.
Rings comb(uint32_t teeth, double tilt);
Rings gear(uint32_t teeth);
Rings even_star(uint32_t tips, double inner);
Rings spiral(uint32_t n);
Rings staircase(uint32_t steps);

Rings rotated(Rings rings, double angle, double scale = 1, Point2 move = {0, 0});
// Each point moved by up to `reach`.
Rings jittered(Rings rings, uint64_t seed, double reach);

}  // namespace flg::test
