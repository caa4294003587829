// SPDX-License-Identifier: MIT
// What loaded styles must fulfil before any job may use them. Each check throws FLG_ERROR_FORMAT.
#pragma once

#include "stylization/style.h"

namespace flg {

// The counts that all else is sized by.
struct StyleCounts {
    uint32_t nodes = 0, curves = 0, patch = 0, jumps = 0, attributes = 0, flow_steps = 0;
};
void check_counts(const StyleCounts& counts);

// From 0, at least two points a curve, `nodes` in the end.
void check_offsets(const Buffer<uint32_t>& offsets, uint32_t nodes);

// All numbers but the graph's; guide and matching curve by curve.
void check_values(const PreparedStyle& style);
// An attribute's kind and metric are ones that there are.
void check_attribute(const PreparedStyle& style, size_t index);

// Fills in what follows from the jumps, the curves and the patch, and checks the jumps: sorted, between centres of patches,
// and every destination within reach.
void complete_graph(PatchGraph& graph, const Buffer<uint32_t>& offsets, Memory* memory);

}  // namespace flg
