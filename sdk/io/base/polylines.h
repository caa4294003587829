// SPDX-License-Identifier: MIT
// Polylines of vertex indices, as OBJ and glTF have them, and how single edges become some.
#pragma once

#include <cstdint>

#include "io/base/memory.h"

namespace flg::io {

struct Polylines {
    Vector<uint32_t> indices;
    Vector<uint32_t> offsets{0};
    Vector<bool> closed;

    size_t count() const { return closed.size(); }
    bool open() const { return indices.size() > offsets.back(); }

    // Ends the polyline that began at the last end. One whose last index equals its first is closed and loses the
    // repeat; of two equal indices one is left: a curve of one point.
    void end(bool loop) {
        const size_t length = indices.size() - offsets.back();
        const bool repeats = length > 1 && indices.back() == indices[offsets.back()];
        if (repeats) indices.pop_back();
        closed.push_back(loop || (repeats && length > 2));
        offsets.push_back(static_cast<uint32_t>(indices.size()));
    }
};

// Joins edges that go on where the one before them ended; one that comes back to the start closes its polyline. `same`
// says whether two vertices are one.
template <class Edge, class Same>
void join_edges(size_t edge_count, const Edge& edge, const Same& same, Polylines& out) {
    for (size_t e = 0; e < edge_count; ++e) {
        const auto [from, to] = edge(e);
        if (out.open() && !same(out.indices.back(), from)) out.end(false);
        if (!out.open()) out.indices.push_back(from);
        const uint32_t start = out.indices[out.offsets.back()];
        const bool comes_back = out.indices.size() - out.offsets.back() > 2 && same(start, to);
        out.indices.push_back(comes_back ? start : to);
        if (comes_back) out.end(false);
    }
    if (out.open()) out.end(false);
}

}  // namespace flg::io
