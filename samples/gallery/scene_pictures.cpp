// SPDX-License-Identifier: MIT
// Each built-in scene, stylized.
#include <algorithm>
#include <cmath>

#include "gallery/looks.h"
#include "gallery/marks.h"
#include "gallery/painted.h"
#include "gallery/pictures.h"
#include "gallery/sweep.h"
#include "scenes/noise.h"

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

// Fig. 8.
void hair(Workshop& workshop, Studio& studio) {
    constexpr float kMagnitudes[] = {0.0f, 0.5f, 1.0f};
    const filigree::CurveSet target = workshop.curves(make_scene("hair").curves),
                             head = workshop.curve(scenes::make_head());
    FlgStyleDesc prepare = flgStyleDefaults();
    prepare.point_count = 200;
    const filigree::Style style = workshop.style(make_style("curls"), prepare);
    FlgStylizeDesc desc = sized(style, 0.006f);
    render::CurveLook strand = tube();
    strand.sides = 5;
    std::vector<filigree::CurveSet> results;
    std::vector<Panel> panels;
    for (const float sigma : kMagnitudes) {
        desc.magnitude = sigma;
        results.push_back(workshop.stylize(style, target, desc));
        Panel& panel = panels.emplace_back();
        panel.layers = {{head.view(), body()}, {results.back().view(), strand}};
        panel.sight = {-0.55f, -0.15f, -1.0f};
        panel.margin = 1.03f;
    }
    aim_together(panels);
    entitle(panels, {"Magnitude 0: combed", "Magnitude 0.5", "Magnitude 1"});
    studio.take("hair", panels, 3, kWidth, 400);
}

void tree(Workshop& workshop, Studio& studio) {
    const filigree::CurveSet target = workshop.curves(make_scene("tree").curves);
    const filigree::Style style = workshop.style(make_style("knots"));
    const filigree::CurveSet result = workshop.stylize(style, target, pinned(style, 0.012f));
    Panel panels[2];
    panels[0].layers = {{target.view(), tube()}};
    panels[1].layers = {{result.view(), tube()}};
    for (Panel& panel : panels) panel.sight = {-0.6f, -0.12f, -1.0f}, panel.margin = 1.06f;
    aim_together(panels);
    entitle(panels, {"Straight branches", "Knots along each; forks stay where they were"});
    studio.take("tree", panels, 2, kWidth, 500);
}

// Fig. 4. Below, one joint from nearby.
void icosahedron(Workshop& workshop, Studio& studio) {
    constexpr glm::vec3 kSight = {-0.2f, -0.35f, -1.0f};
    constexpr float kReach = 0.075f;
    const std::vector<scenes::Curve> arcs = make_scene("icosahedron").curves;
    const filigree::CurveSet target = workshop.curves(arcs);
    const filigree::Style style = workshop.style(make_style("braid"));
    FlgStylizeDesc desc = pinned(style, 0.026f);
    const filigree::CurveSet held = workshop.stylize(style, target, desc);
    desc.pin_ends = 0;
    const filigree::CurveSet loose = workshop.stylize(style, target, desc);
    // Two ends an arc; the joint nearest to the eye.
    std::vector<glm::vec3> ends;
    std::vector<scenes::Curve> balls;
    for (const scenes::Curve& arc : arcs) {
        for (const scenes::Point& p : {arc.points.front(), arc.points.back()}) {
            ends.emplace_back(p.x, p.y, p.z);
            balls.push_back(dot(ends.back()));
        }
    }
    const glm::vec3 joint = *std::min_element(ends.begin(), ends.end(), [&](const glm::vec3& a, const glm::vec3& b) {
        return glm::dot(a, kSight) < glm::dot(b, kSight);
    });
    const filigree::CurveSet joints = workshop.curves(balls), one = workshop.curve(dot(joint));
    std::vector<Panel> panels(6);
    for (size_t i = 0; i < 3; ++i) {
        const filigree::CurveSet* const shown[] = {&target, &loose, &held};
        Panel &whole = panels[i], &detail = panels[i + 3];
        whole = panel_of(shown[i]->view(), tube(i == 1 ? kRed : kTeal, 0.0045f), kSight);
        detail = whole;
        detail.layers = {shape_of(one.view(), tube(kGold, 0.008f))};
        for (uint32_t c = 0; c < arcs.size(); ++c) {
            if (ends[2 * c] != joint && ends[2 * c + 1] != joint) continue;
            detail.layers.push_back({whole.layers[0].curves.range(c, 1), tube(whole.layers[0].look.color, 0.003f)});
        }
        detail.aim = around(joint, kReach);
        detail.ground = false;
        whole.layers.push_back(shape_of(joints.view(), tube(kGold, 0.011f)));
    }
    aim_together({&panels[0], 3});
    entitle(panels, {"A network", "Loose ends miss the joints", "Pinned ends meet in them"});
    studio.take("icosahedron", panels, 3, kWidth, 600);
}

// Fig. 9.
void tower(Workshop& workshop, Studio& studio) {
    const filigree::CurveSet target = workshop.curves(make_scene("tower").curves);
    const filigree::Style style = workshop.style(make_style("tremor"));
    const filigree::CurveSet result = workshop.stylize(style, target, pinned(style, 0.012f));
    constexpr float kFrom = 1.2f, kTo = -0.1f;  // x, metres
    const Ramp ramp(result.view(), [](const glm::vec3& p) {
        return static_cast<float>(1.5 * scenes::smooth_step((p.x - kFrom) / (kTo - kFrom)));
    });
    Panel panel;
    panel.layers = {{ramp.columns(), tube()}};
    panel.sight = {0.62f, -0.22f, -1.0f};
    studio.take("tower", {&panel, 1}, 1, 720, 720);
}

// Fig. 10.
void flow(Workshop& workshop, Studio& studio) {
    constexpr uint32_t kLines = 48;
    const filigree::CurveSet target = workshop.curves(make_scene("flow", kLines).curves),
                             ball = workshop.curve(scenes::make_ball());
    const filigree::Style style = workshop.style(make_style("curls"));
    FlgStylizeDesc desc = sized(style, 0.022f);
    desc.keep_displacement = 1;
    desc.temperature = 0.5f;
    const filigree::CurveSet result = workshop.stylize(style, target, desc);
    // Behind the ball, more the further on and the nearer to its axis.
    const Ramp ramp(result.view(), [](const glm::vec3& p) {
        const double axis = std::hypot(p.y, p.z), wake = 0.10 + 0.28 * std::max(0.0, double{p.x});
        const double inside = scenes::smooth_step((1.6 * wake - axis) / wake);
        return static_cast<float>(inside * scenes::smooth_step((p.x + 0.02) / 0.9) * (0.5 + 0.5 * double{p.x}));
    });
    Panel panels[2];
    panels[0].layers = {{ball.view(), body()}, {target.view(), tube(kInk, 0.005f, 1.8f)}};
    panels[1].layers = {{ball.view(), body()}, {ramp.columns(), tube(kInk, 0.005f, 1.8f)}};
    for (Panel& panel : panels) {
        panel.sight = {-0.15f, -0.22f, -1.0f};
        panel.aim = {{-0.5f, -0.36f, 0.0f}, {1.35f, -0.36f, 0.0f}, {-0.5f, 0.36f, 0.0f}, {1.35f, 0.36f, 0.0f}};
        panel.margin = 1.04f;
        panel.ground = false;
    }
    panels[0].title = "Flow lines around a ball, red near its axis";
    panels[1].title = "Stylized: magnitude grows in the ball's wake";
    studio.take("flow", panels, 1, kWidth, 600);
}

void vine(Workshop& workshop, Studio& studio) {
    constexpr glm::vec3 kShades[] = {{0.10f, 0.30f, 0.03f},
                                     {0.22f, 0.40f, 0.05f},
                                     {0.28f, 0.13f, 0.04f},
                                     {0.16f, 0.08f, 0.03f},
                                     {0.05f, 0.20f, 0.06f}};
    constexpr float kRadii[] = {0.012f, 0.008f, 0.015f, 0.010f, 0.007f};
    const filigree::CurveSet target = workshop.curve(make_target("vine"));
    FlgStyleDesc prepare = flgStyleDefaults();
    prepare.point_count = 1500;
    const filigree::Style style = workshop.style(make_style("braid"), prepare);
    FlgStylizeDesc desc = sized(style, 0.075f);
    desc.magnitude = 0.6f;
    desc.strokes = static_cast<uint32_t>(std::size(kShades));
    const filigree::CurveSet result = workshop.stylize(style, target, desc);
    Panel panels[2];
    panels[0].layers = {shape_of(target.view(), tube(kShades[0], 0.012f))};
    for (uint32_t k = 0; k < desc.strokes; ++k) {
        panels[1].layers.push_back(
            {Columns(result.view()).without(FLG_ATTRIBUTE_COLOR).range(k, 1), tube(kShades[k], kRadii[k])});
    }
    for (Panel& panel : panels) panel.sight = {-0.25f, -0.2f, -1.0f}, panel.margin = 1.06f;
    aim_together(panels);
    entitle(panels, {"One closed curve", "Stylized five times"});
    studio.take("vine", panels, 2, kWidth, 480);
}

// Posts from a track down to the ground.
std::vector<scenes::Curve> posts(const FlgCurveSetView& track, uint32_t count) {
    const std::vector<glm::vec3> points = vectors_of(track);
    std::vector<scenes::Curve> list;
    for (uint32_t k = 0; k < count; ++k) {
        const glm::vec3 p = points[points.size() * k / count];
        list.emplace_back().points = {{p.x, -0.05f, p.z}, {p.x, p.y - 0.01f, p.z}};
    }
    return list;
}

// The track is a slab, red above and gold below.
Panel track_of(const Sweep& sweep, const filigree::CurveSet& stands) {
    Panel panel;
    panel.layers = {shape_of(stands.view(), tube(kGrey, 0.005f))};
    render::SurfaceLook look;
    look.regions = {{kRed, 0.0f, 0.4f}, {kGold, 0.0f, 0.4f}, {kInk, 0.0f, 0.5f}};
    panel.surfaces = {{sweep.view(), look}};
    panel.sight = {-0.35f, -0.45f, -1.0f};
    panel.margin = 1.05f;
    return panel;
}

void coaster(Workshop& workshop, Studio& studio) {
    constexpr float kHalfWidth = 0.055f, kThickness = 0.012f;
    constexpr uint32_t kPosts = 30;
    const filigree::CurveSet target = workshop.curve(make_target("coaster"));
    const FlgStyleAttribute angle[] = {{FLG_ATTRIBUTE_ANGLE, FLG_METRIC_CIRCLE, 0.01f, 0}};
    const filigree::Style style = workshop.style(workshop.curve(make_style("twist")), angle);
    FlgStylizeDesc desc = sized(style, 0.075f);
    desc.frame = FLG_FRAME_SUPPLIED;
    const filigree::CurveSet result = workshop.stylize(style, target, desc);
    const filigree::CurveSet below = workshop.curves(posts(target.view(), kPosts)),
                             below_result = workshop.curves(posts(result.view(), kPosts));
    const auto width = [](uint32_t) { return kHalfWidth; };
    const Sweep bare = Sweep::bands(target.view(), kThickness, width),
                rolled = Sweep::bands(result.view(), kThickness, width);
    Panel panels[] = {track_of(bare, below), track_of(rolled, below_result)};
    aim_together(panels);
    entitle(panels, {"Banked, as the camera path is", "Rolling over, as the style does"});
    studio.take("coaster", panels, 1, 720, 720);
}

constexpr Picture kPictures[] = {
    {"hair", "Fig. 8: 2,000 hairs at three magnitudes", true, hair},
    {"tree", "Fig. 6: an L-system's tree with its branches in knots, joints unmoved", true, tree},
    {"icosahedron", "Fig. 4: a network, without and with its ends pinned", true, icosahedron},
    {"tower", "Fig. 9: an architect's wireframe, drawn with a hand less and less steady from right to left", true,
     tower},
    {"flow", "Fig. 10: laminar to turbulent: magnitude grows in the wake of a ball, after stylization", true, flow},
    {"vine", "Sec. 4.5.5, multistroke: a closed curve stylized five times", true, vine},
    {"coaster", "Sec. 5.2: a camera path whose ribbon rolls as its example does", true, coaster},
};

}  // namespace

std::span<const Picture> scene_pictures() {
    return kPictures;
}

}  // namespace flg::gallery
