// SPDX-License-Identifier: MIT
// Each built-in scene, stylized.
#include <algorithm>
#include <cmath>

#include "gallery/looks.h"
#include "gallery/pictures.h"
#include "gallery/ramp.h"
#include "scenes/noise.h"
#include "support/curve_source.h"

namespace flg::gallery {
namespace {

using scenes::make_scene;
using scenes::make_style;
using scenes::make_target;

FlgStylizeDesc pinned(const filigree::Style& style, float displacement_m) {
    FlgStylizeDesc desc = sized(style, displacement_m);
    desc.pin_ends = 1;
    desc.keep_displacement = 1;
    return desc;
}

void hair(Workshop& workshop, Studio& studio) {
    constexpr uint32_t kHairWidth = 580, kHairHeight = 326;  // small: hair packs badly
    const filigree::CurveSet target = workshop.curves(make_scene("hair").curves),
                             head = workshop.curve(scenes::make_head());
    FlgStyleDesc prepare = flgStyleDefaults();
    prepare.point_count = 200;
    const filigree::Style style = workshop.style(make_style("curls"), prepare);
    const filigree::CurveSet result = workshop.stylize(style, target, sized(style, 0.006f));
    render::CurveLook strand = tube();
    strand.sides = 5;
    Panel before, after;
    before.layers = {{head.view(), body()}, {target.view(), strand}};
    after.layers = {{head.view(), body()}, {result.view(), strand}};
    before.sight = after.sight = {-0.55f, -0.15f, -1.0f};
    before.nearer = after.nearer = 0.86f;
    before.shift = after.shift = {0.0f, -0.05f};
    studio.take("hair", {before, after}, 2, kHairWidth, kHairHeight);
}

void tree(Workshop& workshop, Studio& studio) {
    const filigree::CurveSet target = workshop.curves(make_scene("tree").curves);
    const filigree::Style style = workshop.style(make_style("knots"));
    const filigree::CurveSet result = workshop.stylize(style, target, pinned(style, 0.012f));
    Panel before, after;
    before.layers = {{target.view(), tube()}};
    after.layers = {{result.view(), tube()}};
    before.sight = after.sight = {-0.6f, -0.12f, -1.0f};
    before.nearer = after.nearer = 0.78f;
    studio.take("tree", {before, after}, 2, kWidth, kHeight);
}

void icosahedron(Workshop& workshop, Studio& studio) {
    const filigree::CurveSet target = workshop.curves(make_scene("icosahedron").curves);
    const filigree::Style style = workshop.style(make_style("curls"));
    FlgStylizeDesc desc = pinned(style, 0.020f);
    const filigree::CurveSet pinned_result = workshop.stylize(style, target, desc);
    desc.pin_ends = 0;
    const filigree::CurveSet loose = workshop.stylize(style, target, desc);
    std::vector<Panel> panels(3);
    panels[0].layers = {{target.view(), tube(kTeal)}};
    panels[1].layers = {{loose.view(), tube(kTeal, 0.005f, 0.7f)}};
    panels[2].layers = {{pinned_result.view(), tube(kTeal, 0.005f, 0.7f)}};
    for (Panel& panel : panels) panel.sight = {-0.2f, -0.35f, -1.0f}, panel.nearer = 0.90f;
    studio.take("icosahedron", panels, 3, kWidth, 360);
}

void tower(Workshop& workshop, Studio& studio) {
    const filigree::CurveSet target = workshop.curves(make_scene("tower").curves);
    const filigree::Style style = workshop.style(make_style("tremor"));
    const filigree::CurveSet result = workshop.stylize(style, target, pinned(style, 0.012f));
    constexpr float kFrom = 1.2f, kTo = -0.1f;  // x, metres
    const Ramp ramp(result.view(), [](const float* p) {
        return static_cast<float>(1.5 * scenes::smooth_step((p[0] - kFrom) / (kTo - kFrom)));
    });
    Panel panel;
    panel.layers = {{ramp.columns(), tube()}};
    panel.sight = {0.62f, -0.22f, -1.0f};
    panel.nearer = 0.98f;
    studio.take("tower", {panel}, 1, kWidth, kHeight);
}

void flow(Workshop& workshop, Studio& studio) {
    constexpr uint32_t kLines = 70, kFlowWidth = 640, kFlowHeight = 264;
    const filigree::CurveSet target = workshop.curves(make_scene("flow", kLines).curves),
                             ball = workshop.curve(scenes::make_ball());
    const filigree::Style style = workshop.style(make_style("curls"));
    FlgStylizeDesc desc = sized(style, 0.034f);
    desc.keep_displacement = 1;
    desc.temperature = 0.5f;
    const filigree::CurveSet result = workshop.stylize(style, target, desc);
    // Behind the ball, more the further on and the nearer to its axis.
    const Ramp ramp(result.view(), [](const float* p) {
        const double axis = std::hypot(p[1], p[2]), wake = 0.10 + 0.28 * std::max(0.0, double{p[0]});
        const double inside = scenes::smooth_step((1.6 * wake - axis) / wake);
        return static_cast<float>(inside * scenes::smooth_step((p[0] + 0.02) / 0.9) * (0.5 + 0.5 * p[0]));
    });
    Panel panel;
    panel.layers = {{ball.view(), body()}, {ramp.columns(), tube()}};
    panel.sight = {-0.15f, -0.22f, -1.0f};
    panel.nearer = 0.66f;
    panel.ground = false;
    studio.take("flow", {panel}, 1, kFlowWidth, kFlowHeight);
}

void vine(Workshop& workshop, Studio& studio) {
    constexpr uint32_t kStrokes = 5;
    constexpr glm::vec3 kShades[kStrokes] = {{0.060f, 0.190f, 0.020f},
                                             {0.12f, 0.26f, 0.02f},
                                             {0.16f, 0.085f, 0.03f},
                                             {0.09f, 0.05f, 0.02f},
                                             {0.03f, 0.11f, 0.03f}};
    const filigree::CurveSet target = workshop.curve(make_target("vine"));
    FlgStyleDesc prepare = flgStyleDefaults();
    prepare.point_count = 1500;
    const filigree::Style style = workshop.style(make_style("braid"), prepare);
    FlgStylizeDesc desc = sized(style, 0.042f);
    desc.strokes = kStrokes;
    const filigree::CurveSet result = workshop.stylize(style, target, desc);
    Panel before, after;
    before.layers = {{Columns(target.view()).without(FLG_ATTRIBUTE_COLOR), tube(kLeaf, 0.010f)}};
    for (uint32_t k = 0; k < kStrokes; ++k) {
        after.layers.push_back(
            {Columns(result.view()).without(FLG_ATTRIBUTE_COLOR).range(k, 1), tube(kShades[k], 0.011f)});
    }
    before.sight = after.sight = {-0.25f, -0.2f, -1.0f};
    before.nearer = after.nearer = 0.98f;
    studio.take("vine", {before, after}, 2, kWidth, kHeight);
}

// Posts from a track down to the ground.
std::vector<scenes::Curve> posts(const FlgCurveSetView& track) {
    constexpr uint32_t kEvery = 26;
    const FlgColumn& positions = *samples::find_column(track, FLG_ATTRIBUTE_POSITION);
    std::vector<scenes::Curve> list;
    for (uint32_t i = 0; i < track.curve_offsets[1]; i += kEvery) {
        const float* p = samples::value_at(positions, i);
        scenes::Curve& post = list.emplace_back();
        post.points = {{p[0], -0.05f, p[2]}, {p[0], p[1], p[2]}};
    }
    return list;
}

void coaster(Workshop& workshop, Studio& studio) {
    const filigree::CurveSet target = workshop.curve(make_target("coaster"));
    const scenes::Curve example = make_style("twist");
    const FlgStyleAttribute angle = {FLG_ATTRIBUTE_ANGLE, FLG_METRIC_CIRCLE, 0.01f, 0};
    FlgStyleDesc prepare = flgStyleDefaults();
    prepare.attributes = &angle;
    prepare.attribute_count = 1;
    const filigree::Style style = workshop.style(example, prepare);
    FlgStylizeDesc desc = sized(style, 0.035f);
    desc.frame = FLG_FRAME_SUPPLIED;
    const filigree::CurveSet result = workshop.stylize(style, target, desc);
    const filigree::CurveSet below = workshop.curves(posts(target.view())),
                             below_result = workshop.curves(posts(result.view()));
    const auto panel_of = [](const filigree::CurveSet& track, const filigree::CurveSet& stands) {
        Panel panel;
        panel.layers = {{Columns(track.view()).without(FLG_ATTRIBUTE_COLOR).without(FLG_ATTRIBUTE_RADIUS),
                         ribbon(kRed, kGold, 0.030f)},
                        {Columns(stands.view()).without(FLG_ATTRIBUTE_COLOR), tube(kGrey, 0.004f)}};
        panel.sight = {-0.5f, -0.42f, -1.0f};
        panel.nearer = 0.90f;
        return panel;
    };
    studio.take("coaster", {panel_of(target, below), panel_of(result, below_result)}, 2, kWidth, 400);
}

constexpr Picture kPictures[] = {
    {"hair", "2,000 hairs, combed and curled", true, hair},
    {"tree", "A network: an L-system's tree with its branches in knots, joints unmoved", true, tree},
    {"icosahedron", "A network: bare, without and with its ends pinned", true, icosahedron},
    {"tower", "An architect's wireframe, drawn with a hand less and less steady from right to left", true, tower},
    {"flow", "Laminar to turbulent: magnitude grows in the wake of a ball, after stylization", true, flow},
    {"vine", "Multistroke: a closed curve stylized five times", true, vine},
    {"coaster", "A camera path whose ribbon rolls as its example does", true, coaster},
};

}  // namespace

std::span<const Picture> scene_pictures() {
    return kPictures;
}

}  // namespace flg::gallery
