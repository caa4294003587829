// SPDX-License-Identifier: MIT
// Room for what a cut adds: all arrays of a mesh and the columns carried along grow together, in slices.
#pragma once

#include <vector>

#include "surfaces/mesh.h"

namespace flg {

// An attribute of the vertices, carried along when the mesh is cut: new vertices get the linear interpolation.
struct MeshColumn {
    uint32_t components;          // floats a vertex
    GrowingBuffer<float> values;  // components * vertices
};
using MeshColumns = std::pmr::vector<MeshColumn>;

// Within the capacity; what is added is not initialized.
void resize_mesh(Mesh& mesh, MeshColumns& columns, uint32_t vertices, uint32_t triangles);

// Arrays that are large enough stay where they are; others get a quarter more than asked for, so that many small cuts
// move each element a few times only. Sizes do not change.
class MeshGrowth {
public:
    // Room for so many vertices and triangles, those there are included.
    MeshGrowth(Mesh& mesh, MeshColumns& columns, uint32_t vertices, uint32_t triangles)
        : mesh_(mesh), columns_(columns), vertices_(vertices), triangles_(triangles) {}

    // Moves at most `count` elements (4 to 12 bytes each); true when done.
    bool run(uint32_t count);

private:
    template <class T>
    bool grow(GrowingBuffer<T>& buffer, size_t needed, uint32_t count);

    Mesh& mesh_;
    MeshColumns& columns_;
    uint32_t vertices_, triangles_;
    size_t array_ = 0;  // the five of the mesh, then the columns
    bool growing_ = false;
};

}  // namespace flg
