// SPDX-License-Identifier: MIT
// The columns beside a mesh, and what is done with all its arrays together: they are copied, given back, and grown for
// what a cut adds, in slices.
#pragma once

#include <algorithm>
#include <vector>

#include "runtime/each.h"
#include "surfaces/mesh/mesh.h"

namespace flg {

// An attribute of the vertices, carried along when the mesh is cut: new vertices get the linear interpolation, or what
// says of which vertices that would be.
struct MeshColumn {
    uint32_t components;          // floats a vertex
    GrowingBuffer<float> values;  // components * vertices
    bool of_sources = false;      // SourceWeights (source_weights.h), as the words that they are
};
using MeshColumns = std::pmr::vector<MeshColumn>;

// Values in an array that can grow, to be carried along.
template <template <class> class Array, class T>
Task<GrowingBuffer<T>> copy_values(Pace& pace, const Array<T>& from) {
    GrowingBuffer<T> copy(from.size(), pace.memory());
    Slice slice(Cost::some_ns);
    for (Portion part(slice, 0, static_cast<uint32_t>(from.size())); part.next();) {
        std::copy(from.data() + part.begin, from.data() + part.end, copy.data() + part.begin);
        if (part.is_over()) co_await pace;
    }
    co_return copy;
}

// Frees array by array: all at once that would take longer than a slice may.
Task<void> give_back(Pace& pace, Mesh& mesh, MeshColumns& columns);

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
    size_t array_ = 0;  // the six of the mesh, then the columns
    bool growing_ = false;
};

}  // namespace flg
