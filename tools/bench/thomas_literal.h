// SPDX-License-Identifier: MIT
// Synthesis as the paper writes it, on the same style and the same target: what the fast one is compared with.
#pragma once

#include "bench/host.h"

namespace flg::bench {

struct LiteralTimes {
    double paths_ms;  // a search in the whole graph for each destination
    double all_ms;    // with resampling, frames and displacement
};

// `style` must be prepared from the built-in style `name`. The graph is not part of the time: it is prepared, as for
// the fast one.
LiteralTimes literal_stylize(Host& host, FlgStyle style, const char* name, const scenes::Curve& target, uint32_t count);

}  // namespace flg::bench
