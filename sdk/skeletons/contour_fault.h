// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace flg {

// What is wrong with a contour. Numbers are those of its points; an edge has that of the point it begins at.
struct ContourFault {
    enum class Kind {
        none,
        same_point,     // points `first` and `second` are at one place
        point_on_edge,  // point `first` is on the edge `second`
        edges_cross,    // the edges `first` and `second`
        outside,  // the ring of edge `first` is not inside of the first ring, or is the first and turns around nothing
        nested,   // the ring of edge `first` is a hole with a ring in it
        gave_up   // took more flips than it ever should
    };
    Kind kind = Kind::none;
    uint32_t first = 0, second = 0;
};

}  // namespace flg
