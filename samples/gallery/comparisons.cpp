// SPDX-License-Identifier: MIT
// What an option does, side by side.
#include <cmath>
#include <deque>
#include <tuple>

#include "gallery/looks.h"
#include "gallery/marks.h"
#include "gallery/pictures.h"
#include "support/curve_source.h"
#if defined(FLG_WITH_BASELINE)
#include "bench/analogies_scene.h"
#endif

namespace flg::gallery {
namespace {

using scenes::make_style;
using scenes::make_target;

constexpr uint32_t kLowHeight = 360;

// One piece for each run of the style that the result copies: to the right the place on the result, upwards that on the
// style, in a square of one metre.
std::vector<scenes::Curve> runs_of(const FlgCurveSetView& result, uint32_t style_points) {
    const FlgColumn& index = *samples::find_column(result, FLG_ATTRIBUTE_STYLE_INDEX);
    const uint32_t count = result.curve_offsets[1];
    std::vector<scenes::Curve> runs;
    for (uint32_t i = 0; i < count; ++i) {
        const float here = *samples::value_at(index, i);
        if (i == 0 || here != *samples::value_at(index, i - 1) + 1.0f) runs.emplace_back();
        const float x = static_cast<float>(i) / static_cast<float>(count), y = here / static_cast<float>(style_points);
        scenes::Curve& run = runs.back();
        if (run.points.empty()) run.points.push_back({x - 1e-4f, y, 0.0f});
        run.points.push_back({x, y, 0.0f});
    }
    return runs;
}

// Fig. 5; below, as there, which point of the style each point copies.
void temperature(Workshop& workshop, Studio& studio) {
    const filigree::CurveSet target = workshop.curve(make_target("s_curve"));
    scenes::Curve axes;
    axes.points = {{0.0f, 1.0f, 0.0f}, {0.0f, 0.0f, 0.0f}, {1.0f, 0.0f, 0.0f}};
    const filigree::CurveSet corner = workshop.curve(axes);
    const filigree::Style style = workshop.style(make_style("knots"));
    std::deque<filigree::CurveSet> sets;
    std::vector<Panel> above, below;
    for (const auto& [tau, title, runs] : {std::tuple{0.0f, "Temperature 0", "copies long runs of the example"},
                                           std::tuple{1.0f, "Temperature 1", "shorter runs: more variation"},
                                           std::tuple{10.0f, "Temperature 10", "single points: noise"}}) {
        FlgStylizeDesc desc = sized(style, 0.040f);
        desc.temperature = tau;
        const filigree::CurveSet& result = sets.emplace_back(workshop.stylize(style, target, desc));
        above.push_back(panel_of(result.view(), tube(kRed, 0.010f)));
        above.back().title = title;
        sets.push_back(workshop.curves(runs_of(result.view(), style.info().point_count)));
        Panel& panel = below.emplace_back(panel_of(sets.back().view(), tube(kInk, 0.007f), {0.0f, 0.0f, -1.0f}));
        panel.layers.push_back(shape_of(corner.view(), tube(kGrey, 0.003f)));
        panel.title = runs;
        panel.notes = {{{0.5f, 0.0f, 0.0f}, "along the result \u2192", {0.0f, 16.0f}, kInk, 14.0f},
                       {{0.0f, 1.0f, 0.0f}, "along the example \u2191", {0.0f, -14.0f}, kInk, 14.0f, Align::left}};
        panel.ground = false;
        panel.aim = {{-0.02f, -0.12f, 0.0f}, {1.02f, 1.22f, 0.0f}};
    }
    aim_together(above);
    above.insert(above.end(), below.begin(), below.end());
    studio.take("temperature", above, 3, kWidth, 720);
}

// Fig. 12: an arc that turns the other way in its middle.
void frames(Workshop& workshop, Studio& studio) {
    constexpr glm::vec3 kFromAbove = {-0.15f, -0.85f, -1.0f};
    const filigree::CurveSet target = workshop.curve(wave());
    const filigree::Style style = workshop.style(make_style("loops"));
    std::vector<filigree::CurveSet> results;
    std::vector<Panel> panels;
    for (FlgFrameMethod frame : {FLG_FRAME_FRENET, FLG_FRAME_ROTATION_MINIMIZING}) {
        FlgStylizeDesc desc = sized(style, 0.055f);
        desc.frame = frame;
        results.push_back(workshop.stylize(style, target, desc));
        Panel panel =
            panel_of(results.back().view(), tube(frame == FLG_FRAME_FRENET ? kRed : kTeal, 0.008f), kFromAbove);
        panel.layers.push_back({target.view(), tube(kGrey, 0.003f)});
        panel.layers.back().curves = panel.layers.back().curves.without(FLG_ATTRIBUTE_COLOR);
        panels.push_back(panel);
    }
    entitle(panels, {"Frenet frames flip", "Rotation-minimizing frames do not"});
    constexpr float kInflection = 0.5585f;  // of the wave, and of its mirror image, metres from its middle
    panels[0].notes = {{{-kInflection, 0.0f, 0.0f}, "flip", {34.0f, -20.0f}},
                       {{0.0f, 0.0f, 0.0f}, "flip", {-34.0f, -18.0f}},
                       {{kInflection, 0.0f, 0.0f}, "flip", {38.0f, -18.0f}}};
    studio.take("frames", panels, 2, kWidth, kLowHeight);
}

// Fig. 16: a style drawn in a plane, with its plane turned about the target's tangent.
void planes(Workshop& workshop, Studio& studio) {
    constexpr glm::vec3 kColors[] = {kRed, kGold, kTeal};
    const filigree::CurveSet target = workshop.curve(make_target("s_curve"));
    const filigree::Style style = workshop.style(make_style("knit"));
    std::vector<filigree::CurveSet> results;
    std::vector<Panel> panels;
    Panel all;
    for (int k = 0; k < 3; ++k) {
        FlgStylizeDesc desc = sized(style, 0.065f);
        const double turn = k * 2.0943951023931953;  // a third of a turn
        const auto c = static_cast<float>(std::cos(turn)), s = static_cast<float>(std::sin(turn));
        const float basis[9] = {1.0f, 0.0f, 0.0f, 0.0f, c, -s, 0.0f, s, c};
        std::copy(basis, basis + 9, desc.basis);
        results.push_back(workshop.stylize(style, target, desc));
        panels.push_back(panel_of(results.back().view(), tube(kColors[k], 0.010f)));
        all.layers.push_back(panels.back().layers[0]);
    }
    all.sight = panels[0].sight;
    panels.push_back(all);
    aim_together(panels);
    entitle(panels, {"A style in a plane", "turned by a third", "by two thirds", "all three"});
    studio.take("planes", panels, 4, kWidth, kLowHeight);
}

// Sec. 7: frames that the host supplies. A spiral on a ball, with loops.
void supplied(Workshop& workshop, Studio& studio) {
    constexpr float kRadius = 0.129f;
    scenes::Curve spiral;
    for (int i = 0; i < 600; ++i) {
        const double u = (i + 0.5) / 600.0, latitude = 2.6 * (u - 0.5), a = 38.0 * u;
        const scenes::Point n = {static_cast<float>(std::cos(latitude) * std::cos(a)),
                                 static_cast<float>(-std::sin(latitude)),
                                 static_cast<float>(std::cos(latitude) * std::sin(a))};
        spiral.points.push_back({kRadius * n.x, kRadius * n.y, kRadius * n.z});
        spiral.normals.push_back(n);
    }
    const filigree::CurveSet target = workshop.curve(spiral), ball = workshop.curve(scenes::make_ball());
    const filigree::Style style = workshop.style(make_style("loops"));
    std::vector<filigree::CurveSet> results;
    std::vector<Panel> panels;
    for (const FlgFrameMethod frame : {FLG_FRAME_ROTATION_MINIMIZING, FLG_FRAME_SUPPLIED}) {
        FlgStylizeDesc desc = sized(style, 0.012f);
        desc.frame = frame;
        results.push_back(workshop.stylize(style, target, desc));
        panels.push_back(panel_of(results.back().view(), tube(frame == FLG_FRAME_SUPPLIED ? kTeal : kRed, 0.0016f),
                                  {-0.2f, -0.9f, -1.0f}));
        panels.back().layers.push_back({ball.view(), body()});
    }
    aim_together(panels);
    entitle(panels, {"Rotation-minimizing frames: loops lean", "The normals of the ball: loops stand"});
    studio.take("supplied", panels, 2, kWidth, 480);
}

#if defined(FLG_WITH_BASELINE)
// Fig. 11, with the same predefined guide: left Curve Analogies, right Filigree.
void analogies(Workshop& workshop, Studio& studio) {
    constexpr struct {
        const char *style, *target;
        float scale, radius;
        glm::vec3 sight;
    } kPairs[] = {{"loops", "s_curve", 0.8f, 0.006f, {-0.1f, -0.12f, -1.0f}},
                  {"zigzag", "flourish", 0.7f, 0.006f, {-0.1f, -0.70f, -1.0f}}};
    std::deque<filigree::CurveSet> sets;
    std::vector<Panel> panels;
    for (const auto& pair : kPairs) {
        const bench::AnalogiesScene scene = bench::make_analogies_scene(pair.style, pair.target, pair.scale, 1);
        const auto line = [&](const std::vector<Vec3>& points) -> const filigree::CurveSet& {
            scenes::Curve curve;
            for (const Vec3& p : points) curve.points.push_back(to_point(glm::vec3(p.x(), p.y(), p.z())));
            return sets.emplace_back(workshop.curve(curve));
        };
        for (const auto* points : {&scene.theirs.points, &scene.ours.points}) {
            const bool ours = points == &scene.ours.points;
            panels.push_back(panel_of(line(*points).view(), tube(ours ? kTeal : kRed, pair.radius), pair.sight));
            panels.back().layers.push_back(shape_of(line(scene.target).view(), tube(kGrey, 0.0022f)));
        }
        aim_together(std::span(panels).last(2));
    }
    entitle(panels, {"Curve Analogies: loops lean over", "Filigree: loops keep to their plane",
                     "Curve Analogies: the zigzag flattens where the line rises", "Filigree: it does not"});
    studio.take("analogies", panels, 2, kWidth, 720);
}
#endif

constexpr Picture kPictures[] = {
    {"temperature", "Fig. 5: temperature 0, 1 and 10", true, temperature},
    {"frames", "Fig. 12: Frenet frames flip at inflections, rotation-minimizing ones don't", true, frames},
    {"planes", "Fig. 16: a style drawn in a plane, in three planes, and all at once", true, planes},
    {"supplied", "Rotation-minimizing frames, and frames supplied by the host", true, supplied},
#if defined(FLG_WITH_BASELINE)
    {"analogies", "Fig. 11: Curve Analogies and Filigree with the same guide", true, analogies},
#endif
};

}  // namespace

std::span<const Picture> comparisons() {
    return kPictures;
}

}  // namespace flg::gallery
