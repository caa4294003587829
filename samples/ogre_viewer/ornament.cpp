// SPDX-License-Identifier: MIT
#include "ornament.h"

namespace viewer {
namespace {

using enum Colour;

// Borders of the whole vase, or of a region around it: below and above.
constexpr FlgBorderStretch kLower = {0, 0, 1}, kUpper = {1, 0, 1};

FlgTangleSeeds at(const FlgBorderStretch& stretch) {
    FlgTangleSeeds seeds = flgTangleSeedsDefaults();
    seeds.stretches = &stretch;
    seeds.stretch_count = 1;
    return seeds;
}

}  // namespace

Ornament::Ornament(filigree::Context& context, const filigree::Surface& surface)
    : tangle_(context.tangle(surface)), colours_(1, kCream) {}

bool Ornament::published() {
    const uint32_t count = tangle_.info().region_count;
    if (count == 0) return false;
    regions_.clear();
    for (uint32_t r = 0; r < count; ++r) {
        const FlgTangleRegion& region = regions_.emplace_back(tangle_.region(r));
        if (r < colours_.size()) continue;
        const Palette& palette = palettes_[divided_by_[region.parent]];
        colours_.push_back(palette[region.part % palette.size()]);
    }
    divided_by_.resize(count);
    return true;
}

bool Ornament::start_next() {
    switch (stage_++) {
        case 0: {  // rings around the vase, from its foot to its lip
            const FlgTangleSeeds below = at(kLower), above = at(kUpper);
            FlgTangleDivideDesc desc = flgTangleDivideDefaults();
            desc.a = &below;
            desc.b = &above;
            desc.delta = 1.0f / 14;
            desc.count = 0;
            bands_ = divide(
                {0}, desc,
                {kRust, kSage, kSage, kGold, kCream, kCream, kBlue, kBlue, kBlue, kBlue, kGold, kCream, kSage, kRust});
            break;
        }
        case 1:  // neighbours of a colour become one
            for (const Colour colour : {kSage, kCream, kBlue}) {
                Regions same = leaves(bands_, colour);
                if (colour != kBlue) same.pop_back();  // the one nearer to the lip stays by itself
                tangle_.join(same);
            }
            break;
        case 2: {
            const Regions sage = leaves(bands_, kSage), cream = leaves(bands_, kCream);
            flutes_ = strips(sage, 0.052f, false, {kSage, kBlue});
            tiles_ = strips({cream[1]}, 0.075f, false, {kCream, kRust});
            strips(leaves(bands_, kRust), 0.04f, false, {kRust, kCream});
            FlgTangleDivideDesc hems = flgTangleDivideDefaults();  // scallops
            FlgTangleSeeds spaced = flgTangleSeedsDefaults();
            spaced.border_spacing = 0.04f;
            hems.a = &spaced;
            hems.delta = 0.024f;
            hems_ = divide(leaves(bands_, kGold), hems, {kBlue, kGold});
            FlgTangleDivideDesc dots = flgTangleDivideDefaults();
            FlgTangleSeeds samples = flgTangleSeedsDefaults();
            samples.sample_radius = 0.085f;
            dots.a = &samples;
            dots.delta = 0.027f;
            dots.seed = 5;
            dots_ = divide({cream[0]}, dots, {kGold, kCream});
            field_ = bands_inwards(leaves(bands_, kBlue), 0.012f, 1, {kGold, kBlue});
            break;
        }
        case 3: {
            panels_ = strips(leaves(field_, kBlue), 0.27f, true, {kBlue});
            bands_inwards(leaves(tiles_, kCream), 0.011f, 2, {kCream, kBlue, kGold});
            bands_inwards(leaves(tiles_, kRust), 0.011f, 2, {kRust, kCream, kBlue});
            bands_inwards(leaves(flutes_, kBlue), 0.009f, 1, {kCream, kBlue});
            bands_inwards(leaves(hems_, kBlue), 0.008f, 1, {kBlue, kSage});
            const Regions dots = leaves(dots_, kGold);
            bands_inwards(dots, 0.008f, 1, {kRust, kGold});
            FlgTangleDisplaceDesc raised = flgTangleDisplaceDefaults();
            raised.regions = dots.data();
            raised.region_count = static_cast<uint32_t>(dots.size());
            raised.amount = 0.012f;
            raised.bias = 0.75f;
            tangle_.displace(raised);
            break;
        }
        case 4: {  // a flower in each panel: from its border to a point in its middle
            FlgTangleDivideDesc flower = flgTangleDivideDefaults();
            FlgTangleSeeds borders = flgTangleSeedsDefaults(), middle = flgTangleSeedsDefaults();
            borders.borders = FLG_TANGLE_BORDERS_OUTER;
            middle.sample_radius = 0.2f;
            middle.sample_count = 1;
            flower.a = &borders;
            flower.b = &middle;
            flower.delta = 0.16f;
            flower.count = 0;
            divide(leaves(panels_, kBlue), flower, {kBlue, kCream, kRust, kGold, kCream, kBlue, kGold});
            break;
        }
        default: return false;
    }
    return true;
}

Ornament::Regions Ornament::leaves(Division made_by, Colour colour) const {
    Regions found;
    for (uint32_t r = 1; r < regions_.size(); ++r) {
        const FlgTangleRegion& region = regions_[r];
        if (divided_by_[region.parent] == made_by && colours_[r] == colour && region.child_count == 0 &&
            region.joined_into == FLG_NO_INDEX)
            found.push_back(r);
    }
    return found;
}

Ornament::Division Ornament::divide(const Regions& each, FlgTangleDivideDesc desc, const Palette& palette) {
    palettes_.push_back(palette);
    for (const uint32_t region : each) {
        desc.regions = &region;
        desc.region_count = 1;
        tangle_.divide(desc);
        divided_by_[region] = palettes_.size() - 1;
    }
    return palettes_.size() - 1;
}

Ornament::Division Ornament::bands_inwards(const Regions& each, float width, uint32_t count, const Palette& palette) {
    FlgTangleDivideDesc desc = flgTangleDivideDefaults();
    FlgTangleSeeds borders = flgTangleSeedsDefaults();
    borders.borders = FLG_TANGLE_BORDERS_OUTER;
    desc.a = &borders;
    desc.delta = width;
    desc.count = count;
    return divide(each, desc, palette);
}

Ornament::Division Ornament::strips(const Regions& each, float width, bool scaffold, const Palette& palette) {
    const FlgTangleSeeds below = at(kLower), above = at(kUpper);
    FlgTangleDivideDesc desc = flgTangleDivideDefaults();
    desc.a = &below;
    desc.b = &above;
    desc.kind = FLG_TANGLE_OPERATOR_STREAM;
    desc.delta = width;
    desc.scaffold = scaffold;
    return divide(each, desc, palette);
}

}  // namespace viewer
