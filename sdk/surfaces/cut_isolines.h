// SPDX-License-Identifier: MIT
// Embeds the isolines of a field at many levels into the mesh, in one pass and without ordering them: sec. 4.2 (Mesh
// slicing) of Nazzaro, Puppo, Pellacini: geoTangle (2021), for many levels at once and with bounded slivers.
//
// Invariants
// - The field is linear in each triangle. A triangle that levels cross is cut into the strips between them; a vertex that
//   comes in at a level has the level's value exactly, and each piece lies between two levels.
// - Snapping: where the level next to a vertex's value differs from it by at most cut_tolerance of the steepest edge that
//   leaves the vertex within a crossed triangle, the vertex's value becomes that level. This is decided for all vertices
//   before any value moves, so all triangles see the same. With a single level, no new point is nearer to an end of its
//   edge than that fraction of the edge; points of different levels are as near to each other as the levels are.
// - Only triangles of the listed regions are cut, and only if all their values are finite. Others that share an edge with
//   a cut one are split to stay joined to it, and keep their label; but those of listed regions with a value that is not
//   finite count as above all levels.
#pragma once

#include <optional>

#include "surfaces/cut_levels.h"
#include "surfaces/cut_strip.h"

namespace flg {

class IsolineCutter {
public:
    // So that no triangle takes longer than a chunk may.
    static constexpr uint32_t max_levels = 256;

    // `field`: the column (of one component) whose isolines these are; its values move by snapping. All must outlive the
    // run. `edit` is a new one; if the cutter throws for want of memory, it takes back what was changed.
    // Memory while it runs: 16 bytes for 64 triangles, 56 bytes a crossed triangle.
    IsolineCutter(Mesh& mesh, MeshColumns& columns, uint32_t field, const CutLevels& levels, MeshEdit& edit,
                  Memory* memory);

    // Spends `count` units of about 0.2 us; true when done. 64 triangles take one in each of four passes, each crossed triangle
    // one in each of four more.
    bool run(uint32_t count);

private:
    enum class Pass { clear, scan, sum, collect, snap, move, number, grow, place, split, done };
    struct Snap {
        uint32_t vertex;
        float level;
    };

    float value(uint32_t vertex) const { return field_[vertex]; }
    uint32_t size_of(Pass pass) const;
    void enter(Pass pass);
    void scan(uint32_t word);
    bool scan_doubtful(uint32_t triangle);
    void insert_crossed(uint32_t triangle);
    void collect(uint32_t word);
    void find_snaps(uint32_t triangle);
    bool may_cut(uint32_t triangle) const;
    void number(uint32_t slot);
    void place(const CutTriangle& slot);
    void split(CutTriangle& slot);
    uint32_t label_of(uint32_t triangle, const Triple& vertices) const;
    void strip_between_levels(const CutTriangle& slot);
    void strip_beside_cuts(const CutTriangle& slot);
    void climb(const CutTriangle& slot, uint32_t from, uint32_t to, std::pmr::vector<Strip::Point>& chain) const;

    Mesh& mesh_;
    MeshColumns& columns_;
    GrowingBuffer<float>& field_;
    const uint32_t field_column_;
    const CutLevels levels_;
    MeshEdit& edit_;
    Memory* memory_;
    TriangleSet crossed_;
    Buffer<CutTriangle> slots_;
    std::pmr::deque<Snap> snaps_;
    std::optional<MeshGrowth> growth_;
    PieceWriter writer_;
    Strip strip_;
    Pieces pieces_;
    // Between these levels the last triangle lay, above interval_ levels; its region, and what is listed for it.
    float low_, high_;
    uint32_t interval_ = 0;
    uint32_t region_ = no_index;
    const RegionLevels* listed_ = nullptr;
    uint64_t vertices_, triangles_;  // numbered so far
    uint32_t filled_ = 0;            // slots
    Pass pass_ = Pass::clear;
    uint32_t at_ = 0;
};

}  // namespace flg
