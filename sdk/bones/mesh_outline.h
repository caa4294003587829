// SPDX-License-Identifier: MIT
// What a mesh, or some of its regions, covers when it is looked at from afar: a drawing for parts that nobody drew.
//
// Triangles seen from the front and, turned over, those seen from behind cover the outline's inside; so it is where the
// borders of both sets wind around. They are put together to one ring, from loop to loop and back again by the same
// ways, which counts for nothing; the repair of contours (contour_repair.h) takes what it winds around, and of that the
// largest piece with its holes.
#pragma once

#include <span>
#include <vector>

#include "skeletons/contour.h"
#include "surfaces/mesh.h"

namespace flg {

// Where an outline is in space: (x, y) of it is at origin + x right + y up. It looks against `right` x `up`.
struct OutlinePlane {
    Vec3 origin = Vec3::Zero(), right = Vec3::UnitX(), up = Vec3::UnitY(), towards = Vec3::UnitZ();
};

class MeshOutlineKernel {
public:
    // `regions`: by label whether it counts, missing ones do not; empty: all. `towards`: from where it is looked at; of
    // no length: from where the triangles together look to. All outlive the kernel. Fills `plane`, and `out` with one
    // ring, not cleaned.
    MeshOutlineKernel(const Mesh& mesh, const std::pmr::vector<bool>& regions, const Vec3& towards, OutlinePlane& plane,
                      Contour& out, Memory* memory);

    // A unit is a triangle or a side, about 20 ns. Throws if there are no triangles, or none that is seen.
    bool run(uint32_t count);

private:
    enum class Pass { look, clear, sides, chain, back, done };
    struct Side {
        uint32_t to;
        uint32_t next;  // from the same vertex; no_index: none
    };

    void step();
    void enter(Pass pass) {
        pass_ = pass;
        at_ = 0;
    }
    bool counts(uint32_t triangle) const;
    bool is_front(uint32_t triangle) const;
    void set_plane();
    void add_sides(uint32_t triangle);
    void chain();
    void add_point(uint32_t vertex);

    const Mesh& mesh_;
    const std::pmr::vector<bool>& regions_;
    Vec3 towards_;
    OutlinePlane& plane_;
    Contour& out_;
    Vec3 sum_ = Vec3::Zero(), middle_ = Vec3::Zero();  // of area vectors; of positions
    uint32_t counted_ = 0;
    Buffer<uint32_t> first_side_;  // by vertex
    std::pmr::vector<Side> sides_;
    uint32_t here_ = no_index;  // on the loop that is followed
    std::pmr::vector<uint32_t> loop_begins_;
    Pass pass_ = Pass::look;
    uint32_t at_ = 0;
};

}  // namespace flg
