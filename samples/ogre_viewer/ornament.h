// SPDX-License-Identifier: MIT
// The ornament of a vase: which regions are divided how, and which colours their parts get. Steps on regions that are
// known are started together; those on what they make are started once they are published.
#pragma once

#include <vector>

#include "filigree/filigree.hpp"

namespace viewer {

enum class Colour : uint32_t { kCream, kBlue, kRust, kGold, kSage };
constexpr size_t kColourCount = 5;

class Ornament {
public:
    // Of a vase with its lower border as loop 0 and its upper one as loop 1.
    Ornament(filigree::Context& context, const filigree::Surface& surface);

    // Whether all steps that were started are published: the surface can be looked at.
    bool published();
    // Then: starts the next steps. False when there are none left.
    bool start_next();
    // One a region, as of the last time that it was published.
    const std::vector<Colour>& colours() const { return colours_; }
    const filigree::Tangle& tangle() const { return tangle_; }

private:
    using Regions = std::vector<uint32_t>;
    using Palette = std::vector<Colour>;  // by part of the operator, and round again
    using Division = size_t;              // regions that were divided alike, each by itself

    // Leaves of a colour that a division made.
    Regions leaves(Division made_by, Colour colour) const;
    Division divide(const Regions& each, FlgTangleDivideDesc desc, const Palette& palette);
    Division bands_inwards(const Regions& each, float width, uint32_t count, const Palette& palette);
    Division strips(const Regions& each, float width, bool scaffold, const Palette& palette);

    filigree::Tangle tangle_;
    uint32_t stage_ = 0;
    std::vector<FlgTangleRegion> regions_;  // while steps are under way the tangle can't be asked
    std::vector<Colour> colours_;
    std::vector<Division> divided_by_;  // one a region
    std::vector<Palette> palettes_;     // one a division
    Division bands_ = 0, hems_ = 0, dots_ = 0, field_ = 0, tiles_ = 0, flutes_ = 0, panels_ = 0;
};

}  // namespace viewer
