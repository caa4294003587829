// SPDX-License-Identifier: MIT
// The corners of a mesh, gathered around each vertex between sharp edges: a sector is a place of the surface that has
// one normal. A vertex of a smooth part has one sector, one on a crease has two, the corner of a cube has three.
#pragma once

#include "surfaces/mesh.h"

namespace flg {

struct MeshSector {
    Position normal;   // the mean of its triangles' normals by their angles there; 0 if they have no area
    uint32_t corners;  // so many, counter-clockwise from the first
    Corner first;
    float shortest, longest, mean;  // metres, of the edges there
    bool creased;                   // there is a sharp edge at its side
    bool closed;                    // all around
};

class MeshSectorsKernel {
public:
    // Edges across which normals turn by more than 40 degrees are sharp.
    static constexpr double sharp_cosine = 0.766;

    // Outlives the kernel.
    MeshSectorsKernel(const Mesh& mesh, Memory* memory);
    // A unit is a corner in one of three passes: 10 to 80 ns.
    bool run(uint32_t count);

    // After run() returned true, until the kernel goes.
    bool sharp(Corner edge) const;  // not so at a border
    uint32_t sector_of(Corner corner) const { return sector_of_[corner]; }
    uint32_t sector_count() const { return static_cast<uint32_t>(sectors_.size()); }
    const MeshSector& sector(uint32_t i) const { return sectors_[i]; }
    const Vec3& lower() const { return lower_; }
    const Vec3& upper() const { return upper_; }

private:
    enum class Pass { faces, edges, sectors, done };
    void step();
    void collect();
    void begin_sector();
    void finish_sector(bool closed);

    const Mesh& mesh_;
    Memory* memory_;
    Buffer<Position> face_normals_;
    Buffer<uint32_t> sector_of_;
    GrowingBuffer<MeshSector> sectors_;
    Pass pass_ = Pass::faces;
    uint32_t at_ = 0, sharp_edges_ = 0;
    Vec3 lower_ = Vec3::Zero(), upper_ = Vec3::Zero();
    // Around the vertex at_:
    Corner corner_ = no_index, start_ = no_index;
    bool searching_ = false;  // for where a sector begins
    MeshSector sector_{};
    Vec3 normals_ = Vec3::Zero();  // sums
    double lengths_ = 0;
    uint32_t edges_ = 0;
};

}  // namespace flg
