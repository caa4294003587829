// SPDX-License-Identifier: MIT
// The patch matrix, row by row (Minarcik, Fiser, Sykora, sec. 4.4): distances of patches of one size, or of several sizes
// (sec. 4.5.4: "one can simply sum the similarity matrices for several patch sizes p", weighted),
//   M(i, c) = sum over sizes m of weight_m * rho_(p_m)(i, c).
// Centres of patches are the points that have a patch of the largest size.
#pragma once

#include <vector>

#include "stylization/patch_rows.h"

namespace flg {

// The scene has at least one patch. A unit is up to 256 entries of one size's matrix, about 0.4 us.
class PatchCosts {
public:
    PatchCosts(const StyleScene& scene, Memory* memory);

    // As PatchRows; row() is M squared.
    bool advance(uint32_t& units);
    bool done() const { return size_ == 0 && !adding_ && rows_.front().done(); }
    const double* row() const { return several_ ? costs_.data() + 1 : rows_.front().row(); }
    uint32_t index() const { return rows_.front().index(); }
    uint32_t curve() const { return rows_.front().curve(); }

private:
    void add_block(uint32_t end);

    StyleScene scene_;
    bool several_;
    std::pmr::vector<PatchRows> rows_;  // one a size
    Buffer<double> costs_;              // with one entry more at both ends
    uint32_t size_ = 0;                 // whose row is to come or to be added next
    bool adding_ = false;
    uint32_t column_ = 0;
};

}  // namespace flg
