// SPDX-License-Identifier: MIT
// Heights of a part: -lap g = 4 inside, g = 0 on the border, height = thickness * sqrt(g) (Dvoroznak et al.: Monster Mash, 2020,
// sec. 4.1, with its constant c = 4 and the thickness apart from it). By linear finite elements and a Cholesky factorization.
// With 4 a disc of radius r gets g = r^2 - x^2 - y^2, which is half a ball; an ellipse gets an ellipsoid. The surface is
// round at the border wherever g leaves it with a slope.
#pragma once

#include <optional>
#include <vector>

#include "inflation/dissection_order.h"
#include "inflation/inflated_part.h"
#include "inflation/sparse_cholesky.h"

namespace flg {

class HeightField {
public:
    // Reads points, on_border and triangles, fills squares and highest. Both outlive the kernel.
    HeightField(InflatedPart& part, Memory* memory);

    // A unit is about 0.3 us.
    bool run(uint32_t count);

private:
    enum class Pass { number, weigh, assemble, order, factor, load, solve, write, done };

    void step();

    InflatedPart& part_;
    Memory* memory_;
    Buffer<uint32_t> row_of_vertex_;
    Buffer<std::array<double, 3>> cotangents_;
    Buffer<double> load_;  // by vertex
    std::pmr::vector<Vec3> places_;
    SymmetricMatrix matrix_;
    Buffer<double> right_;
    std::optional<MeshLaplacian> laplacian_;
    std::optional<DissectionOrder> order_;
    std::optional<SparseCholesky> cholesky_;
    std::optional<CholeskySolve> solve_;
    uint32_t rows_ = 0;
    Pass pass_ = Pass::number;
    uint32_t at_ = 0;
};

}  // namespace flg
