// SPDX-License-Identifier: MIT
// A step of a tangle as the user sees it: what is done to which regions, from which seeds, by which numbers. It can be
// done again with others as long as it is the last.
#pragma once

#include <glm/glm.hpp>
#include <string>

#include "tangles/region_outline.h"

namespace flg::studio {

enum class Action {
    contour,
    stream,
    voronoi,
    polyline,  // as FlgTangleOperator
    sunburst,
    polka_dots,
    frames,
    flower,
    grid,
    outline,
    lace,
    cells,  // as FlgTangleMacro
    displace
};
constexpr int kActionCount = 13;

bool is_operator(Action action);
bool is_macro(Action action);

struct ActionInfo {
    const char* name;
    const char* what;  // it does, for the tooltip
    uint32_t borders;  // that the regions need
};
const ActionInfo& info_of(Action action);

enum class SeedKind { none, border, each, points, samples, spaced, picked };

struct SeedPoint {
    FlgSurfacePoint on;  // of the surface before the step
    glm::vec3 place;
    bool operator==(const SeedPoint& other) const { return place == other.place; }
};

// A part of one of the outline's loops.
struct SeedStretch {
    uint32_t loop;
    float begin, end;
    bool operator==(const SeedStretch&) const = default;
};

// What of these counts is said by `kind`; the others wait for when it is chosen again.
struct SeedChoice {
    SeedKind kind = SeedKind::none;
    std::vector<SeedPoint> points{};
    std::vector<SeedStretch> stretches{};
    float radius = 0.1f;   // metres, between samples
    float spacing = 0.1f;  // metres, along borders
    bool operator==(const SeedChoice&) const = default;
};

struct Recipe {
    Action action = Action::contour;
    Regions regions{};
    SeedChoice from{}, towards{};
    // Metres, but for shares of a blend.
    float delta = 0.1f, share = 0.25f;
    int count = 1;
    int grouping = FLG_TANGLE_GROUPING_TWO, cycle = 3;
    bool scaffold = false, closed = true;
    float perturbation = 0.0f, frequency = 1.0f;
    int seed = 1;
    float size = 0.1f, spacing = 0.3f;
    float amount = 0.1f, bias = 0.5f, gain = 0.5f, reach = 0.0f;
    bool operator==(const Recipe&) const = default;
};

Recipe default_recipe(Action action, const Regions& regions, const Outline& outline);

// Empty if it can be done; else what is missing, a sentence.
std::string missing(const Recipe& recipe);

// Starts it. Throws filigree::Error.
filigree::Job start(const Recipe& recipe, const filigree::Tangle& tangle);

}  // namespace flg::studio
