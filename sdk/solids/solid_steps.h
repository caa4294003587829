// SPDX-License-Identifier: MIT
// The 26 cells around one of a solid's lattice.
#pragma once

#include <array>
#include <cmath>

#include "solids/solid_grid.h"

namespace flg {

struct SolidSteps {
    explicit SolidSteps(const SolidGrid& grid) {
        uint32_t n = 0;
        for (int z = -1; z <= 1; ++z)
            for (int y = -1; y <= 1; ++y)
                for (int x = -1; x <= 1; ++x) {
                    if (x == 0 && y == 0 && z == 0) continue;
                    lengths[n] = std::sqrt(static_cast<float>(x * x + y * y + z * z));
                    cells[n++] = (z * static_cast<int32_t>(grid.size[1]) + y) * static_cast<int32_t>(grid.size[0]) + x;
                }
    }

    std::array<int32_t, 26> cells{};  // to be added to a cell's number
    std::array<float, 26> lengths{};  // in cells
};

}  // namespace flg
