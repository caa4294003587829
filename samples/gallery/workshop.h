// SPDX-License-Identifier: MIT
// The SDK as the gallery uses it: everything at once and to the end. How a host spreads the same calls over its
// frames is what samples/strokes shows.
#pragma once

#include <span>

#include "filigree/filigree.hpp"
#include "scenes/scenes.h"

namespace flg::gallery {

class Workshop {
public:
    filigree::CurveSet curves(std::span<const scenes::Curve> list);
    filigree::CurveSet curve(const scenes::Curve& one) { return curves({&one, 1}); }

    // Sets desc.style; waits.
    filigree::Style style(const filigree::CurveSet& example, FlgStyleDesc desc = flgStyleDefaults());
    filigree::Style style(const scenes::Curve& example, const FlgStyleDesc& desc = flgStyleDefaults()) {
        return style(curve(example), desc);
    }
    // With attributes, at the weights given.
    filigree::Style style(const filigree::CurveSet& example, std::span<const FlgStyleAttribute> attributes);
    // Sets desc.style and desc.target; waits.
    filigree::CurveSet stylize(const filigree::Style& style, const filigree::CurveSet& target,
                               FlgCurveSetStylizeDesc desc = flgCurveSetStylizeDefaults());
    // Waits for what the context makes; throws what it failed with.
    template <class Made>
    Made finished(Made made) {
        context_.run();
        made.ready();
        return made;
    }

    filigree::Context& context() { return context_; }

private:
    filigree::Context context_ = filigree::Context::create();
};

// The style in a size at which its displacement is about so many metres.
FlgCurveSetStylizeDesc sized(const filigree::Style& style, float displacement_m);

}  // namespace flg::gallery
