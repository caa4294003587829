// SPDX-License-Identifier: MIT
#include "tangles/tangle_macros.h"

namespace flg {

namespace {

DivideRequest contours(const MacroRequest& macro, float delta, uint32_t count, Memory* memory) {
    DivideRequest request(memory);
    request.desc.kind = FLG_TANGLE_OPERATOR_CONTOUR;
    request.desc.delta = delta;
    request.desc.count = count;
    request.regions = macro.regions;
    request.a.seed = request.b.seed = macro.desc.seed;
    return request;
}

// From one border to the others.
DivideRequest between_borders(const MacroRequest& macro, float delta, uint32_t count, Memory* memory) {
    DivideRequest request = contours(macro, delta, count, memory);
    request.a.first_loop = request.b.first_loop = macro.desc.border;
    request.a.loops = TangleSeeds::Loops::leading;
    request.b.loops = TangleSeeds::Loops::others;
    return request;
}

}  // namespace

std::pmr::vector<DivideRequest> expand_macro(const MacroRequest& macro, Memory* memory) {
    const FlgTangleApplyMacroDesc& desc = macro.desc;
    std::pmr::vector<DivideRequest> steps(memory);
    // Of a blend, so many equal bands.
    const float share = 1 / static_cast<float>(desc.count + 1);
    switch (desc.kind) {
        case FLG_TANGLE_MACRO_POLKA_DOTS:
            steps.push_back(contours(macro, desc.size, 1, memory));
            steps[0].a.sample_radius = desc.spacing;
            break;
        case FLG_TANGLE_MACRO_FRAMES:
            steps.push_back(contours(macro, desc.size, desc.count, memory));
            steps[0].a.borders = FLG_TANGLE_BORDERS_OUTER;
            break;
        case FLG_TANGLE_MACRO_FLOWER:
            steps.push_back(contours(macro, share, desc.count, memory));
            steps[0].a.borders = FLG_TANGLE_BORDERS_OUTER;
            steps[0].b.sample_radius = desc.spacing;
            steps[0].b.samples_fit = true;
            break;
        case FLG_TANGLE_MACRO_OUTLINE:
            steps.push_back(contours(macro, desc.size, 1, memory));
            steps[0].a.borders = FLG_TANGLE_BORDERS_EACH;
            break;
        case FLG_TANGLE_MACRO_LACE:
            steps.push_back(contours(macro, desc.size, 1, memory));
            steps[0].a.border_spacing = desc.spacing;
            break;
        case FLG_TANGLE_MACRO_CELLS:
            steps.push_back(contours(macro, 1, 1, memory));
            steps[0].desc.kind = FLG_TANGLE_OPERATOR_VORONOI;
            steps[0].a.sample_radius = desc.spacing;
            break;
        case FLG_TANGLE_MACRO_GRID:
            if (desc.count > 1) {
                const float row = 1 / static_cast<float>(desc.count);
                steps.push_back(between_borders(macro, row, desc.count - 1, memory));
            }
            [[fallthrough]];
        case FLG_TANGLE_MACRO_SUNBURST:
        default:
            steps.push_back(between_borders(macro, desc.size, 0, memory));
            steps.back().desc.kind = FLG_TANGLE_OPERATOR_STREAM;
            break;
    }
    return steps;
}

}  // namespace flg
