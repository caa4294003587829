// SPDX-License-Identifier: MIT
// BoundedDP as the paper writes it (Ma, Wang, Li, Zhang 2021, Algorithms 1 and 2), recursive and from scratch each
// round; with the weight of Eq. 1, and the point marked only if its error is above the threshold, as the text says.
#pragma once

#include <functional>
#include <vector>

#include "bones/axis.h"

namespace flg::reference {

// Which samples stay, first and last among them. `is_inside` says of two samples whether the bone between them is in
// the shape; after 64 rounds all stay.
std::vector<bool> bounded_dp(const std::vector<AxisSample>& samples, double threshold, double shape_weight,
                             const std::function<bool(size_t, size_t)>& is_inside);

}  // namespace flg::reference
