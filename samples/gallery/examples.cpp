// SPDX-License-Identifier: MIT
// What a style may be made of, and put on.
#include <cmath>
#include <deque>
#include <functional>
#include <initializer_list>
#include <numbers>
#include <span>

#include "gallery/looks.h"
#include "gallery/marks.h"
#include "gallery/painted.h"
#include "gallery/pictures.h"

namespace flg::gallery {
namespace {

using scenes::make_style;
using scenes::make_target;

// Fig. 3: three strokes, one style, one patch graph. The result has the colours of the strokes that it copies.
void several(Workshop& workshop, Studio& studio) {
    constexpr glm::vec3 kColors[] = {kRed, kGold, kTeal};
    const scenes::Curve strokes[] = {moved(make_style("zigzag"), {0.0f, 0.26f, 0.0f}), make_style("knots"),
                                     moved(make_style("curls"), {0.0f, -0.26f, 0.0f})};
    const filigree::CurveSet drawn = workshop.curves(strokes);
    const filigree::Style style = workshop.style(drawn);
    const filigree::CurveSet guide = style.guide();
    const uint32_t* const ends = guide.view().curve_offsets + 1;
    const filigree::CurveSet target = workshop.curve(make_target("spiral"));
    FlgStylizeDesc desc = sized(style, 0.035f);
    const filigree::CurveSet result = workshop.stylize(style, target, desc);
    const Painted painted(result.view(), FLG_ATTRIBUTE_STYLE_INDEX, [&](const float* index) {
        return kColors[(*index >= static_cast<float>(ends[0])) + (*index >= static_cast<float>(ends[1]))];
    });
    Panel panels[2];
    for (uint32_t k = 0; k < 3; ++k) {
        panels[0].layers.push_back(
            {Columns(drawn.view()).without(FLG_ATTRIBUTE_COLOR).without(FLG_ATTRIBUTE_RADIUS).range(k, 1),
             tube(kColors[k], 0.007f)});
    }
    panels[0].sight = {-0.1f, -0.1f, -1.0f};
    panels[1].layers = {{painted.columns(), tube(kInk, 0.007f)}};
    panels[1].sight = {-0.3f, -0.55f, -1.0f};
    entitle(panels, {"Three strokes, one style", "The result, in the colours of what it copies"});
    studio.take("several", panels, 2, kWidth, 420);
}

// `axis` of a place from 0 to 1 along it.
scenes::Curve line(const std::function<scenes::Point(float u)>& axis) {
    scenes::Curve curve;
    for (int i = 0; i <= 300; ++i) curve.points.push_back(axis(static_cast<float>(i) / 300.0f));
    return curve;
}

constexpr float kWavesLength = 1.6f;  // metres

// Three waves, and curls along them.
scenes::Curve waves() {
    return line([](float u) { return scenes::Point{kWavesLength * u, 0.10f * std::sin(18.85f * u), 0.0f}; });
}

filigree::CurveSet curly_waves(Workshop& workshop) {
    const filigree::Style curls = workshop.style(make_style("curls"));
    return workshop.stylize(curls, workshop.curve(waves()), sized(curls, 0.022f));
}

// Sec. 4.5.4: small patches, large ones, both. The colour says where on the style a point comes from.
void multiresolution(Workshop& workshop, Studio& studio) {
    constexpr FlgPatchSize kSmall[] = {{3, 1.0f}}, kLarge[] = {{60, 1.0f}}, kBoth[] = {{3, 1.0f}, {60, 0.3f}};
    const struct {
        std::span<const FlgPatchSize> sizes;
        const char* title;
    } kResults[] = {{kSmall, "Small patches: curls go on, waves break off"},
                    {kLarge, "Large patches: waves go on"},
                    {kBoth, "Both sizes: waves and curls go on"}};
    const filigree::CurveSet drawn = curly_waves(workshop), target = workshop.curve(line([](float u) {
        return scenes::Point{2.0f * kWavesLength * u, 0.0f, 0.0f};
    }));
    std::deque<filigree::CurveSet> results;
    std::deque<Painted> painted;
    std::vector<Panel> panels;
    const auto show = [&](const filigree::Style& style, filigree::CurveSet curves, const char* title) {
        results.push_back(std::move(curves));
        const auto count = static_cast<float>(style.info().point_count);
        painted.emplace_back(results.back().view(), FLG_ATTRIBUTE_STYLE_INDEX,
                             [=](const float* index) { return render::field_color(*index / count); });
        Panel& panel = panels.emplace_back();
        panel.layers = {{painted.back().columns().without(FLG_ATTRIBUTE_RADIUS), tube(kInk, 0.0085f)}};
        panel.sight = {0.0f, -0.1f, -1.0f};
        panel.ground = false;
        panel.title = title;
    };
    for (const auto& result : kResults) {
        FlgStyleDesc prepare = flgStyleDefaults();
        prepare.patch_sizes = result.sizes.data();
        prepare.patch_size_count = static_cast<uint32_t>(result.sizes.size());
        const filigree::Style style = workshop.style(drawn, prepare);
        if (panels.empty()) {
            show(style, workshop.stylize(style, style.guide()), "The example: curls along waves");
        }
        FlgStylizeDesc desc = flgStylizeDefaults();
        desc.start = FLG_START_RANDOM;
        desc.temperature = 0.5f;
        show(style, workshop.stylize(style, target, desc), result.title);
    }
    aim_together(panels);
    panels[0].notes = {{{2.5f, 0.0f, 0.0f}, "Colours below say which part of it is copied", {}, kInk, 14.0f}};
    studio.take("multiresolution", panels, 1, kWidth, 560);
}

// Algorithm 1: a guide of the user's own says what belongs to the style.
void guide(Workshop& workshop, Studio& studio) {
    const filigree::CurveSet drawn = curly_waves(workshop), own = workshop.curve(waves()),
                             target = workshop.curve(line([](float u) {
                                 const float x = 1.9f * (u - 0.5f);
                                 return scenes::Point{x, -0.35f * x * x, 0.0f};
                             }));
    std::deque<filigree::CurveSet> sets;
    std::vector<Panel> above, below;
    for (const bool given : {false, true}) {
        const glm::vec3 color = given ? kRed : kTeal;
        FlgStyleDesc prepare = flgStyleDefaults();
        if (given) prepare.guide = own.get();
        const filigree::Style style = workshop.style(drawn, prepare);
        sets.push_back(style.guide());
        above.push_back(panel_of(drawn.view(), tube(kGrey, 0.007f), {-0.05f, -0.1f, -1.0f}));
        above.back().layers.push_back(shape_of(sets.back().view(), tube(color, 0.011f)));
        above.back().layers.back().look.in_front = true;
        above.back().aim = points_of(above.back());
        above.back().aim.emplace_back(0.5f * kWavesLength, 0.40f, 0.0f);  // room for the key
        above.back().title = given ? "A guide that you draw" : "The guide that is found";
        above.back().keys = {{kGrey, "example"}, {color, given ? "guide, along the waves" : "guide, straight"}};
        sets.push_back(workshop.stylize(style, target));
        below.push_back(panel_of(sets.back().view(), tube(color, 0.009f), {-0.05f, -0.1f, -1.0f}));
        below.back().title = given ? "Its result on an arch: curls alone" : "Its result on an arch: waves and curls";
    }
    aim_together(below);
    above.insert(above.end(), below.begin(), below.end());
    for (Panel& panel : above) panel.ground = false, panel.margin = 1.04f;
    studio.take("guide", above, 2, kWidth, 460);
}

// Sec. 4.5.1, the inset: a closed curve, its result stylized again and that once more stays closed.
void fractal(Workshop& workshop, Studio& studio) {
    constexpr float kSizes[] = {0.080f, 0.020f};
    constexpr float kRadii[] = {0.014f, 0.009f, 0.0040f};
    constexpr glm::vec3 kColors[] = {kInk, kTeal, kRed};
    const filigree::Style style = workshop.style(make_style("loops"));
    std::deque<filigree::CurveSet> rings;
    scenes::Curve circle = line([](float u) {
        const float a = 2.0f * std::numbers::pi_v<float> * u;
        return scenes::Point{0.6f * std::sin(a), 0.0f, -0.6f * std::cos(a)};
    });
    circle.points.pop_back();
    circle.closed = true;
    rings.push_back(workshop.curve(circle));
    for (const float size : kSizes) rings.push_back(workshop.stylize(style, rings.back(), sized(style, size)));
    std::vector<Panel> panels;
    for (size_t i = 0; i < rings.size(); ++i) {
        panels.push_back(panel_of(rings[i].view(), tube(kColors[i], kRadii[i]), {-0.1f, -1.4f, -1.0f}));
    }
    aim_together(panels);
    entitle(panels, {"A closed curve", "in a style", "and in it once more"});
    studio.take("fractal", panels, 3, kWidth, 320);
}

constexpr Picture kPictures[] = {
    {"several", "Fig. 3: three strokes in one style; colours say which is copied", true, several},
    {"multiresolution", "Sec. 4.5.4: small patches, large ones, both; colours say where on the style", true,
     multiresolution},
    {"guide", "Algorithm 1: the guide of the flow, and one of the user's own", true, guide},
    {"fractal", "Sec. 4.5.1: a closed curve, stylized, and stylized again", true, fractal},
};

}  // namespace

std::span<const Picture> examples() {
    return kPictures;
}

}  // namespace flg::gallery
