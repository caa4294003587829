// SPDX-License-Identifier: MIT
// The steps of a tangle as the user sees them in a list: what each does, whether it does, and its numbers.
#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <string>

#include "tangles/coloring.h"

namespace flg::studio {

// Metres, but for shares of a blend. What of these counts is said by the kind of step.
struct StepNumbers {
    float delta = 0.0f, size = 0.0f, spacing = 0.0f;
    float amount = 0.0f, bias = 0.5f, gain = 0.5f, reach = 0.0f;
    int count = 0, seed = 1;
    bool operator==(const StepNumbers&) const = default;
};

struct HistoryStep {
    FlgTangleStepKind kind = FLG_TANGLE_STEP_KIND_DIVIDE;
    FlgTangleStepState state = FLG_TANGLE_STEP_STATE_MADE;
    int which = 0;  // operator or macro
    bool blends = false;
    std::string name, why;
    StepNumbers numbers;
    uint32_t first_region = 0;
    std::vector<glm::vec3> places;  // in the regions it made
};

// Those that are not undone.
std::vector<HistoryStep> list_steps(const filigree::Tangle& tangle);

// Starts to make a step with other numbers.
filigree::Job change_step(const filigree::Tangle& tangle, uint32_t step, const StepNumbers& numbers);

// Paints by what made the regions, to find these again after an edit.
class CarriedPaints {
public:
    CarriedPaints(const std::vector<HistoryStep>& steps, const RegionList& regions, const Paints& paints);
    // `moved`: where a step is now, or none.
    Paints on(const std::vector<HistoryStep>& steps, const RegionList& regions,
              std::optional<uint32_t> (*moved)(uint32_t step, uint32_t edited, uint32_t to), uint32_t edited,
              uint32_t to) const;

private:
    struct Carried {
        std::optional<uint32_t> step;  // none: the whole surface
        uint32_t part;
        glm::vec3 place;
        uint32_t material;
    };
    std::vector<Carried> carried_;
};

}  // namespace flg::studio
