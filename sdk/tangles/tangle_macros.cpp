// SPDX-License-Identifier: MIT
#include "tangles/tangle_macros.h"

namespace flg {

namespace {

DivideRequest contours(const MacroRequest& macro, float delta, uint32_t count, Memory* memory) {
    DivideRequest request(memory);
    request.kind = FLG_TANGLE_OPERATOR_CONTOUR;
    request.regions = macro.regions;
    request.delta = delta;
    request.count = count;
    request.a.seed = request.b.seed = macro.seed;
    return request;
}

// From the first border to the others.
DivideRequest between_borders(const MacroRequest& macro, float delta, uint32_t count, Memory* memory) {
    DivideRequest request = contours(macro, delta, count, memory);
    request.a.stretches.push_back({.loop = 0});
    request.b.other_loops = true;
    return request;
}

}  // namespace

std::pmr::vector<DivideRequest> expand_macro(const MacroRequest& macro, Memory* memory) {
    std::pmr::vector<DivideRequest> steps(memory);
    // Of a blend, so many equal bands.
    const float share = 1 / static_cast<float>(macro.count + 1);
    switch (macro.kind) {
        case FLG_TANGLE_MACRO_POLKA_DOTS:
            steps.push_back(contours(macro, macro.size, 1, memory));
            steps[0].a.sample_radius = macro.spacing;
            break;
        case FLG_TANGLE_MACRO_FRAMES:
            steps.push_back(contours(macro, macro.size, macro.count, memory));
            steps[0].a.borders = FLG_TANGLE_BORDERS_OUTER;
            break;
        case FLG_TANGLE_MACRO_FLOWER:
            steps.push_back(contours(macro, share, macro.count, memory));
            steps[0].a.borders = FLG_TANGLE_BORDERS_OUTER;
            steps[0].b.sample_radius = macro.spacing;
            break;
        case FLG_TANGLE_MACRO_OUTLINE:
            steps.push_back(contours(macro, macro.size, 1, memory));
            steps[0].a.borders = FLG_TANGLE_BORDERS_EACH;
            break;
        case FLG_TANGLE_MACRO_LACE:
            steps.push_back(contours(macro, macro.size, 1, memory));
            steps[0].a.border_spacing = macro.spacing;
            break;
        case FLG_TANGLE_MACRO_CELLS:
            steps.push_back(contours(macro, 1, 1, memory));
            steps[0].kind = FLG_TANGLE_OPERATOR_VORONOI;
            steps[0].a.sample_radius = macro.spacing;
            break;
        case FLG_TANGLE_MACRO_GRID:
            if (macro.count > 1) {
                const float row = 1 / static_cast<float>(macro.count);
                steps.push_back(between_borders(macro, row, macro.count - 1, memory));
            }
            [[fallthrough]];
        case FLG_TANGLE_MACRO_SUNBURST:
        default:
            steps.push_back(between_borders(macro, macro.size, 0, memory));
            steps.back().kind = FLG_TANGLE_OPERATOR_STREAM;
            break;
    }
    return steps;
}

}  // namespace flg
