// SPDX-License-Identifier: MIT
// What the entry points that make manifolds share.
#pragma once

#include "api/context.h"
#include "api/inputs.h"
#include "splines/manifolds/manifold_product.h"

namespace flg {

constexpr double smallest_length = 1e-6, largest_length = 1e6;  // m

inline void check_length(double value, const char* argument) {
    check_range(value >= smallest_length && value <= largest_length, argument, value, "1e-6 to 1e6");
}

inline FlgManifold publish_at_once(Context& context, const std::shared_ptr<ManifoldProduct>& held) {
    held->given_ambient = held->manifold->ambient();
    held->publish_complete();
    return {context.manifolds.add(held)};
}

}  // namespace flg
