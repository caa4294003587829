// SPDX-License-Identifier: MIT
// All parts of a model in one closed surface: the union of the parts as functions of space (implicit_parts.h), its
// surface on a lattice (surface_extraction.h), made even, with its corners (sharp_corners.h), and cut where it goes
// from part to part (part_borders.h).
#pragma once

#include <array>
#include <span>

#include "core/vec.h"
#include "inflation/implicit_parts.h"
#include "inflation/mesh_laplacian.h"
#include "inflation/part_borders.h"
#include "runtime/task.h"

namespace flg {

// Closed: each side belongs to two triangles, which go along it in opposite directions; and a manifold: the triangles
// of a vertex form one ring. As many components as there are groups of parts that meet.
struct MergedMesh {
    Buffer<Vec3> positions;
    Buffer<Vec3> normals;                // outwards, of length 1
    Buffer<TriangleVertices> triangles;  // counter-clockwise seen from outside
    Buffer<uint32_t> parts;              // by vertex, the one whose surface it is on; at borders one of those
    Buffer<uint32_t> triangle_parts;     // by triangle; they change only at edges that follow the parts' border
    Buffer<uint8_t> is_fixed;            // by vertex: a sharp corner, which stays where it is
    double spacing = 0;                  // about the length of edges
    uint32_t even_vertices = 0;          // what it had before borders were cut
};

struct MergeOptions {
    uint32_t vertices = 10000;       // the surface gets so many or some more, if no part is too thin; at least 100
    uint32_t max_vertices = 200000;  // what thin parts may make of it
    double blend = -1;               // as PartUnion has it
    double corner_angle = 0;         // contours that turn by more keep their corners, radians; 0: all are rounded
};

// About how long edges get, from the areas of the parts: longer than they are, as parts overlap.
double expected_spacing(std::span<const PlacedPart> parts, uint32_t vertices);

struct ManyWeights;

// The surface before it is cut where it goes from part to part: of even triangles, so weights are best found here.
struct EvenMesh {
    PartUnion parts;
    MergedMesh mesh;  // without triangle_parts
    Buffer<PartUnion::Sample> samples;
    Buffer<Across> across;
};

// As merge_parts does, up to the cuts.
Task<EvenMesh> merge_evenly(Pace& pace, std::span<const PlacedPart> parts, MergeOptions options);

// The cuts. `even` is done with then. Weights, if there are some, are carried along: in between, those in between.
Task<MergedMesh> cut_merged(Pace& pace, EvenMesh& even, ManyWeights* weights);

// Of parts that are inflated; at least one. `parts` and what they point to outlive the task. Takes about 8 us a vertex.
// Throws, with a sentence, for placements and numbers that are out of range, and if the thinnest part needs more
// vertices than options.max_vertices.
Task<MergedMesh> merge_parts(Pace& pace, std::span<const PlacedPart> parts, MergeOptions options);

}  // namespace flg
