// SPDX-License-Identifier: MIT
#include "stylization/seam_blend.h"

#include <cmath>

namespace flg {

void SeamBlend::find_attribute_gaps(uint32_t from, uint32_t to, const Shares& shares_at_from) {
    const bool fades = !faded_.empty();
    for (size_t a = 0; a < attributes_.size(); ++a) {
        const StyleAttribute& attribute = attributes_[a];
        for (uint32_t k = 0; k < attribute.components; ++k) {
            const float* copied = attribute.values.data() + size_t{to} * attribute.components + k;
            const double followed = value(a, k, from + 1);
            const double step = followed - value(a, k, from, shares_at_from);
            double gap = followed - copied[0];
            if (const double period = attribute.period(k); period > 0) {
                wound_rad_[a] = period * std::round(gap / period);
                gap -= wound_rad_[a];
            }
            const double step_gap = step - (double{copied[attribute.components]} - copied[0]);
            if (fades) gap -= of_style(a, k, from + 1) - copied[0];
            gaps_[a][k] = {static_cast<float>(gap), static_cast<float>(step_gap)};
        }
    }
}

}  // namespace flg
