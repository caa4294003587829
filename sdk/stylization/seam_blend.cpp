// SPDX-License-Identifier: MIT
#include "stylization/seam_blend.h"

#include <cmath>

namespace flg {

void SeamBlend::find_attribute_gaps(uint32_t followed, uint32_t to) {
    for (size_t a = 0; a < attributes_.size(); ++a) {
        const StyleAttribute& attribute = attributes_[a];
        for (uint32_t k = 0; k < attribute.components; ++k) {
            double gap = value(a, k, followed) - attribute.values[size_t{to} * attribute.components + k];
            if (const double period = attribute.period(k); period > 0) {
                wound_rad_[a] = period * std::round(gap / period);
                gap -= wound_rad_[a];
            }
            gaps_[a][k] = static_cast<float>(gap);
        }
    }
}

}  // namespace flg
