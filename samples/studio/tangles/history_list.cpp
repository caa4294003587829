// SPDX-License-Identifier: MIT
#include "tangles/history_list.h"

#include <limits>

#include "tangles/recipe.h"

namespace flg::studio {
namespace {

constexpr const char* kChanges[] = {"", "", "Raise", "Group", "Ungroup", "Join"};  // by FlgTangleStepKind

HistoryStep shown(const FlgTangleStep& step) {
    HistoryStep row;
    row.kind = step.kind;
    row.state = step.state;
    row.why = step.why != nullptr ? step.why : "";
    row.first_region = step.first_region;
    for (uint32_t i = 0; i < step.made_count; ++i)
        row.places.push_back({step.made[3 * i], step.made[3 * i + 1], step.made[3 * i + 2]});
    StepNumbers& n = row.numbers;
    if (step.kind == FLG_TANGLE_STEP_KIND_DIVIDE) {
        const FlgTangleDivideDesc& desc = *step.divide;
        row.which = desc.kind;
        row.name = info_of(static_cast<Action>(desc.kind)).name;
        const FlgTangleSeeds& b = *desc.b;
        row.blends = b.borders != 0 || b.stretch_count > 0 || b.point_count > 0 || b.sample_radius > 0;
        n.delta = desc.delta;
        n.count = static_cast<int>(desc.count);
        n.seed = static_cast<int>(desc.seed);
    } else if (step.kind == FLG_TANGLE_STEP_KIND_MACRO) {
        const FlgTangleApplyMacroDesc& desc = *step.macro;
        row.which = desc.kind;
        row.name = info_of(static_cast<Action>(static_cast<int>(Action::sunburst) + desc.kind)).name;
        n.size = desc.size;
        n.spacing = desc.spacing;
        n.count = static_cast<int>(desc.count);
        n.seed = static_cast<int>(desc.seed);
    } else {
        row.name = kChanges[step.kind];
        if (step.kind == FLG_TANGLE_STEP_KIND_DISPLACE) {
            const FlgTangleDisplaceDesc& desc = *step.displace;
            n.amount = desc.amount;
            n.bias = desc.bias;
            n.gain = desc.gain;
            n.reach = desc.reach;
        }
    }
    return row;
}

}  // namespace

std::vector<HistoryStep> list_steps(const filigree::Tangle& tangle) {
    const FlgTangleHistory history = tangle.history();
    std::vector<HistoryStep> steps;
    for (uint32_t i = 0; i < history.made_count; ++i) steps.push_back(shown(*history.steps[i]));
    return steps;
}

filigree::Job change_step(const filigree::Tangle& tangle, uint32_t step, const StepNumbers& numbers) {
    const FlgTangleHistory history = tangle.history();
    FlgTangleStep changed = *history.steps[step];
    FlgTangleDivideDesc divide{};
    FlgTangleApplyMacroDesc macro{};
    FlgTangleDisplaceDesc displace{};
    if (changed.divide != nullptr) {
        divide = *changed.divide;
        divide.delta = numbers.delta;
        divide.count = static_cast<uint32_t>(numbers.count);
        divide.seed = static_cast<uint64_t>(numbers.seed);
        changed.divide = &divide;
    } else if (changed.macro != nullptr) {
        macro = *changed.macro;
        macro.size = numbers.size;
        macro.spacing = numbers.spacing;
        macro.count = static_cast<uint32_t>(numbers.count);
        macro.seed = static_cast<uint64_t>(numbers.seed);
        changed.macro = &macro;
    } else if (changed.displace != nullptr) {
        displace = *changed.displace;
        displace.amount = numbers.amount;
        displace.bias = numbers.bias;
        displace.gain = numbers.gain;
        displace.reach = numbers.reach;
        changed.displace = &displace;
    }
    return tangle.edit_step(step, changed);
}

CarriedPaints::CarriedPaints(const std::vector<HistoryStep>& steps, const RegionList& regions, const Paints& paints) {
    for (const auto& [region, material] : paints) {
        if (region == 0) carried_.push_back({std::nullopt, 0, glm::vec3(0.0f), material});
        for (uint32_t s = 0; s < steps.size(); ++s) {
            const HistoryStep& step = steps[s];
            if (region < step.first_region || region - step.first_region >= step.places.size()) continue;
            carried_.push_back({s, regions[region].part, step.places[region - step.first_region], material});
            break;
        }
    }
}

Paints CarriedPaints::on(const std::vector<HistoryStep>& steps, const RegionList& regions,
                         std::optional<uint32_t> (*moved)(uint32_t step, uint32_t edited, uint32_t to), uint32_t edited,
                         uint32_t to) const {
    Paints paints;
    for (const Carried& carried : carried_) {
        if (!carried.step) {
            paints.insert_or_assign(0, carried.material);
            continue;
        }
        const std::optional<uint32_t> at = moved(*carried.step, edited, to);
        if (!at || *at >= steps.size()) continue;
        const HistoryStep& step = steps[*at];
        uint32_t best = FLG_NO_INDEX;
        float least = std::numeric_limits<float>::infinity();
        for (uint32_t i = 0; i < step.places.size(); ++i) {
            const glm::vec3 apart = step.places[i] - carried.place;
            const float square = glm::dot(apart, apart);
            if (regions[step.first_region + i].part != carried.part || !(square < least)) continue;
            least = square;
            best = step.first_region + i;
        }
        if (best != FLG_NO_INDEX) paints.insert_or_assign(best, carried.material);
    }
    return paints;
}

}  // namespace flg::studio
