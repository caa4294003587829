// SPDX-License-Identifier: MIT
// All parts of a model in one closed surface: the union of the parts as functions of space (part_union.h), its surface on a
// lattice (surface_grid.h, surface_extraction.h), made even (mesh_improvement.h).
#pragma once

#include <optional>

#include "inflation/merged_mesh.h"
#include "inflation/mesh_improvement.h"
#include "inflation/surface_extraction.h"

namespace flg {

struct MergeOptions {
    uint32_t vertices = 10000;        // about how many the surface gets, if no part is too thin for that; at least 100
    uint32_t most_vertices = 200000;  // what thin parts may make of it
    double blend = -1;                // as PartUnion has it
};

class MergeParts {
public:
    // Of parts that are inflated; at least one. `out` is complete when run() returns true. All outlive the kernel. Throws, with a
    // sentence, for placements and numbers that are out of range.
    MergeParts(std::span<const PlacedPart> parts, const MergeOptions& options, MergedMesh& out, Memory* memory);

    // A unit is about 0.7 us; about 15 units a vertex. Throws if the thinnest part needs more vertices than options.most_vertices.
    bool run(uint32_t count);

private:
    enum class Pass { prepare, measure, begin, grid, extract, release, improve, write, done };

    void step();
    void begin_measure();
    void begin_grid();
    void write();

    MergeOptions options_;
    MergedMesh& out_;
    Memory* memory_;
    PartUnion parts_;
    double spacing_ = 0;
    double counted_ = 0;  // vertices on the coarse lattice
    std::optional<SurfaceGrid> grid_;
    std::pmr::vector<Vec3> positions_;
    std::pmr::vector<TriangleVertices> triangles_;
    std::optional<SurfaceExtraction> extraction_;
    std::optional<MeshImprovement> improvement_;
    Pass pass_ = Pass::prepare;
    uint32_t at_ = 0;
};

}  // namespace flg
