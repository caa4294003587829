// SPDX-License-Identifier: MIT
#include "gallery/workshop.h"

#include <algorithm>

#include "support/curve_arrays.h"

namespace flg::gallery {

filigree::CurveSet Workshop::curves(std::span<const scenes::Curve> list) {
    return context_.curves(samples::CurveArrays(list).view());
}

filigree::Style Workshop::style(const scenes::Curve& example, FlgStyleDesc desc) {
    const filigree::CurveSet drawn = curve(example);
    desc.style = drawn.get();
    filigree::Style made = context_.style(desc);
    context_.finish();
    made.ready();  // throws if it failed
    return made;
}

filigree::CurveSet Workshop::stylize(const filigree::Style& style, const filigree::CurveSet& target,
                                     FlgStylizeDesc desc) {
    desc.style = style.get();
    desc.target = target.get();
    filigree::CurveSet made = context_.stylize(desc);
    context_.finish();
    made.ready();  // throws if it failed
    return made;
}

FlgStylizeDesc sized(const filigree::Style& style, float displacement_m) {
    FlgStylizeDesc desc = flgStylizeDefaults();
    desc.scale = displacement_m / std::max(style.info().displacement_rms, 1e-9f);
    return desc;
}

}  // namespace flg::gallery
