// SPDX-License-Identifier: MIT
#include "gallery/workshop.h"

#include <algorithm>

#include "support/curve_arrays.h"

namespace flg::gallery {

filigree::CurveSet Workshop::curves(std::span<const scenes::Curve> list) {
    return context_.curve_set(samples::CurveArrays(list).view());
}

filigree::Style Workshop::style(const filigree::CurveSet& example, FlgStyleDesc desc) {
    desc.style = example.get();
    return finished(context_.style(desc));
}

filigree::Style Workshop::style(const filigree::CurveSet& example, std::span<const FlgStyleAttribute> attributes) {
    FlgStyleDesc desc = flgStyleDefaults();
    desc.attributes = attributes.data();
    desc.attribute_count = static_cast<uint32_t>(attributes.size());
    return style(example, desc);
}

filigree::CurveSet Workshop::stylize(const filigree::Style& style, const filigree::CurveSet& target,
                                     FlgCurveSetStylizeDesc desc) {
    desc.style = style.get();
    desc.target = target.get();
    return finished(context_.stylize(desc));
}

FlgCurveSetStylizeDesc sized(const filigree::Style& style, float displacement_m) {
    FlgCurveSetStylizeDesc desc = flgCurveSetStylizeDefaults();
    desc.scale = displacement_m / std::max(style.info().displacement_rms, 1e-9f);
    return desc;
}

}  // namespace flg::gallery
