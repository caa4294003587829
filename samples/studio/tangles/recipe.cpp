// SPDX-License-Identifier: MIT
#include "tangles/recipe.h"

#include <algorithm>

namespace flg::studio {
namespace {

constexpr ActionInfo kActions[kActionCount] = {
    {"Contour", "Cuts bands at equal distances from borders or points.", 0},
    {"Stream", "Cuts evenly spaced stripes that run away from a border. Needs a border.", 1},
    {"Voronoi", "Cuts cells around scattered points or points you click.", 0},
    {"Polyline", "Cuts along shortest paths between points you click.", 0},
    {"Sunburst", "Cuts rays from the first border to the others. Needs two borders.", 2},
    {"Polka dots", "Cuts evenly scattered round dots.", 0},
    {"Frames", "Cuts nested frames along the borders. Needs a border.", 1},
    {"Flower", "Cuts petals around scattered centres. Needs a border.", 1},
    {"Grid", "Cuts a chequerboard between the first border and the others. Needs two borders.", 2},
    {"Outline", "Cuts a band along every border. Needs a border.", 1},
    {"Lace", "Cuts scallops along the borders. Needs a border.", 1},
    {"Cells", "Cuts a mosaic of cells around scattered points.", 0},
    {"Raise", "Lifts regions from the surface or sinks them: domes, ridges, terraces. Needs a border.", 1},
};

// Points of the seeds, alive while the step is started.
struct SeedArrays {
    std::vector<FlgSurfacePoint> points;
    std::vector<FlgBorderStretch> stretches;
    FlgTangleSeeds view = flgTangleSeedsDefaults();

    explicit SeedArrays(const SeedChoice& choice) {
        switch (choice.kind) {
            case SeedKind::none: break;
            case SeedKind::border: view.borders = FLG_TANGLE_BORDERS_OUTER; break;
            case SeedKind::each: view.borders = FLG_TANGLE_BORDERS_EACH; break;
            case SeedKind::points:
                for (const SeedPoint& point : choice.points) points.push_back(point.on);
                view.points = points.data();
                view.point_count = static_cast<uint32_t>(points.size());
                break;
            case SeedKind::samples: view.sample_radius = choice.radius; break;
            case SeedKind::spaced: view.border_spacing = choice.spacing; break;
            case SeedKind::picked:
                for (const SeedStretch& s : choice.stretches) stretches.push_back({s.loop, s.begin, s.end});
                view.stretches = stretches.data();
                view.stretch_count = static_cast<uint32_t>(stretches.size());
                break;
        }
    }
};

filigree::Job start_operator(const Recipe& recipe, const filigree::Tangle& tangle) {
    const SeedArrays from(recipe.from), towards(recipe.towards);
    FlgTangleDivideDesc desc = flgTangleDivideDefaults();
    desc.kind = static_cast<FlgTangleOperator>(recipe.action);
    desc.regions = recipe.regions.data();
    desc.region_count = static_cast<uint32_t>(recipe.regions.size());
    desc.count = static_cast<uint32_t>(recipe.count);
    desc.a = &from.view;
    if (recipe.action == Action::contour || recipe.action == Action::stream) desc.b = &towards.view;
    const bool blends = recipe.action == Action::contour && recipe.towards.kind != SeedKind::none;
    desc.delta = blends ? recipe.share : recipe.delta;
    desc.grouping = static_cast<FlgTangleGrouping>(recipe.grouping);
    desc.cycle = static_cast<uint32_t>(recipe.cycle);
    desc.scaffold = recipe.scaffold ? 1 : 0;
    desc.closed = recipe.closed && recipe.from.points.size() > 2 ? 1 : 0;
    desc.perturbation = recipe.perturbation;
    desc.frequency = recipe.frequency;
    desc.seed = static_cast<uint64_t>(recipe.seed);
    return tangle.divide(desc);
}

}  // namespace

bool is_operator(Action action) {
    return action <= Action::polyline;
}

bool is_macro(Action action) {
    return action >= Action::sunburst && action <= Action::cells;
}

const ActionInfo& info_of(Action action) {
    return kActions[static_cast<int>(action)];
}

Recipe default_recipe(Action action, const Regions& regions, const Outline& outline) {
    Recipe recipe{.action = action, .regions = regions};
    const float breadth = outline.breadth(), size = outline.size();
    const bool has_border = !outline.loops.empty();
    recipe.from.radius = recipe.towards.radius = 0.45f * size;
    recipe.from.spacing = recipe.towards.spacing = 0.35f * size;
    recipe.frequency = 2.0f / size;
    recipe.delta = has_border ? 0.2f * breadth : 0.09f * size;
    recipe.from.points = {{outline.top, outline.top_place}};
    recipe.from.kind = has_border ? SeedKind::border : SeedKind::points;
    recipe.size = 0.2f * breadth;
    recipe.spacing = 0.9f * breadth;
    recipe.amount = 0.25f * breadth;
    recipe.bias = 0.7f;
    switch (action) {
        case Action::contour: recipe.count = has_border ? 3 : 0; break;
        case Action::stream: recipe.delta = 0.25f * size; break;
        case Action::voronoi:
            recipe.from.kind = SeedKind::samples;
            recipe.from.radius = std::min(0.6f * breadth, 0.16f * size);
            recipe.grouping = FLG_TANGLE_GROUPING_CYCLE;
            recipe.cycle = 4;
            break;
        case Action::polyline:
            recipe.from.kind = SeedKind::points;
            recipe.from.points.clear();
            break;
        case Action::sunburst: recipe.size = 0.18f * size; break;
        case Action::polka_dots:
            recipe.spacing = std::min(0.7f * breadth, 0.22f * size);
            recipe.size = 0.3f * recipe.spacing;
            break;
        case Action::frames:
            recipe.count = 4;
            recipe.size = 0.16f * breadth;
            break;
        case Action::flower:
            recipe.count = 4;
            recipe.spacing = 0.6f * breadth;
            break;
        case Action::grid:
            recipe.count = 6;
            recipe.size = 0.18f * size;
            break;
        case Action::outline: recipe.size = 0.16f * breadth; break;
        case Action::lace:
            recipe.spacing = 0.4f * breadth;
            recipe.size = 0.6f * recipe.spacing;
            break;
        case Action::cells: recipe.spacing = std::min(0.5f * breadth, 0.13f * size); break;
        case Action::displace: break;
    }
    return recipe;
}

std::string missing(const Recipe& recipe) {
    const SeedChoice& from = recipe.from;
    if (!is_operator(recipe.action)) return {};
    const bool blends = recipe.action == Action::contour || recipe.action == Action::stream;
    if (recipe.action == Action::polyline && from.points.size() < 2)
        return "Click two or more points on the mesh. Enter ends the line.";
    if (from.kind == SeedKind::points && from.points.empty()) return "Click points on the mesh to start at.";
    if (from.kind == SeedKind::picked && from.stretches.empty())
        return "Click a border of the selected regions, or drag along it.";
    if (!blends) return {};
    if (recipe.towards.kind == SeedKind::points && recipe.towards.points.empty())
        return "Click points on the mesh to end at.";
    if (recipe.towards.kind == SeedKind::picked && recipe.towards.stretches.empty()) return "Click a border to end at.";
    return {};
}

filigree::Job start(const Recipe& recipe, const filigree::Tangle& tangle) {
    if (is_operator(recipe.action)) return start_operator(recipe, tangle);
    if (recipe.action == Action::displace) {
        FlgTangleDisplaceDesc desc = flgTangleDisplaceDefaults();
        desc.regions = recipe.regions.data();
        desc.region_count = static_cast<uint32_t>(recipe.regions.size());
        desc.amount = recipe.amount;
        desc.bias = recipe.bias;
        desc.gain = recipe.gain;
        desc.reach = recipe.reach;
        return tangle.displace(desc);
    }
    filigree::TangleApplyMacroDesc desc;
    desc.kind = static_cast<FlgTangleMacro>(static_cast<int>(recipe.action) - static_cast<int>(Action::sunburst));
    desc.regions = recipe.regions.data();
    desc.region_count = static_cast<uint32_t>(recipe.regions.size());
    desc.count = static_cast<uint32_t>(std::max(recipe.count, 1));
    desc.size = recipe.size;
    desc.spacing = recipe.spacing;
    desc.seed = static_cast<uint64_t>(recipe.seed);
    return tangle.apply_macro(desc);
}

}  // namespace flg::studio
