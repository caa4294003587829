// SPDX-License-Identifier: MIT
// Sec. 5: what a style may carry besides its shape.
#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <functional>
#include <numbers>
#include <span>

#include "gallery/looks.h"
#include "gallery/marks.h"
#include "gallery/pictures.h"
#include "gallery/sweep.h"
#include "support/curve_arrays.h"
#include "support/curve_source.h"

namespace flg::gallery {
namespace {

using scenes::make_style;
using scenes::make_target;

constexpr uint32_t kTallWidth = 760, kTallHeight = 560;
constexpr float kTau = 2.0f * std::numbers::pi_v<float>;

// An example with a column of its own; `value` of the place on the stroke, 0 to 1.
template <uint32_t components>
filigree::CurveSet example(Workshop& workshop, const scenes::Curve& stroke, FlgAttribute attribute,
                           const std::function<std::array<float, components>(float u)>& value) {
    const samples::CurveArrays arrays({&stroke, 1});
    std::vector<std::array<float, components>> values;
    for (size_t i = 0; i < stroke.points.size(); ++i) {
        values.push_back(value(static_cast<float>(i) / static_cast<float>(stroke.points.size() - 1)));
    }
    const Columns columns = Columns(arrays.view()).with({attribute, components, values[0].data(), 0, 0});
    return workshop.context().curve_set(columns.view());
}

// 1, and 0 towards the ends.
float tapered(float u) {
    return std::clamp(std::min(u, 1.0f - u) / 0.15f, 0.0f, 1.0f);
}

// The style as it was drawn, which is what its own guide gets, and on a target.
struct Shown {
    Shown(Workshop& workshop, const filigree::Style& style)
        : drawn(workshop.stylize(style, style.guide())), result(workshop.stylize(style, workshop.curve(wave()))) {}
    filigree::CurveSet drawn, result;
};

// Sec. 5.1: the thickness belongs to the style.
void attributes(Workshop& workshop, Studio& studio) {
    scenes::Curve flat = wave();  // fills the width of the picture
    for (scenes::Point& p : flat.points) p.y *= 0.6f;
    const filigree::CurveSet target = workshop.curve(flat);
    const FlgStyleAttribute kept[] = {{FLG_ATTRIBUTE_RADIUS, FLG_METRIC_AUTO, 1.0f, 0},
                                      {FLG_ATTRIBUTE_COLOR, FLG_METRIC_AUTO, 0.0f, 0}};
    const filigree::CurveSet drawn = workshop.curve(make_style("beads"));
    FlgStyleDesc prepare = flgStyleDefaults();
    prepare.point_count = 600;
    const filigree::Style plain = workshop.style(drawn, prepare);
    prepare.attributes = kept;
    prepare.attribute_count = 2;
    const filigree::Style beads = workshop.style(drawn, prepare);
    FlgCurveSetStylizeDesc desc = flgCurveSetStylizeDefaults();
    desc.scale = 1.5f;
    const filigree::CurveSet shape = workshop.stylize(plain, target, desc), all = workshop.stylize(beads, target, desc);
    Panel panels[3];
    panels[0].layers = {{drawn.view().get(), tube(kInk, 0.0f, 1.5f)}};
    panels[0].title = "The example: a thread with beads";
    panels[1] = panel_of(shape.view(), tube(kLeaf, 0.008f));
    panels[1].title = "A result that takes its shape alone";
    panels[2].layers = {{all.view().get(), tube(kInk, 0.0f, 1.5f)}};
    panels[2].title = "A result that takes radius and colour as well";
    for (Panel& panel : panels) {
        panel.sight = {0.0f, -0.1f, -1.0f};
        panel.ground = false;
        panel.layers[0].look.sides = 32;  // round beads
    }
    aim_together(std::span(panels).last(2));
    panels[0].aim = {{-0.02f, -0.08f, 0.0f}, {1.02f, 0.12f, 0.0f}};
    studio.take("attributes", panels, 1, kWidth, 720);
}

Panel solid(const Sweep& sweep, glm::vec3 color) {
    Panel panel;
    render::SurfaceLook look;
    look.material = {color, 0.0f, 0.35f};
    panel.surfaces = {{sweep.view(), look}};
    panel.sight = {-0.2f, -0.25f, -1.0f};
    return panel;
}

// Sec. 5.1: elliptic cross-sections, R+ x R+ x RP1: leaves on a stem, which turn.
void ellipses(Workshop& workshop, Studio& studio) {
    const filigree::CurveSet stem =
        example<3>(workshop, make_style("beads"), FLG_ATTRIBUTE_RADII, [](float u) -> std::array<float, 3> {
            const float leaf =
                tapered(u) * std::pow(std::sin(0.5f * kTau * (9.0f * u + 0.15f * std::sin(11.0f * u))), 2.0f);
            return {0.006f + 0.040f * leaf * (0.75f + 0.25f * std::sin(17.0f * u)), 0.006f + 0.003f * leaf,
                    1.1f * kTau * u};
        });
    const FlgStyleAttribute radii[] = {{FLG_ATTRIBUTE_RADII, FLG_METRIC_PROJECTIVE, 0.3f, 0}};
    const filigree::Style style = workshop.style(stem, radii);
    const Shown shown(workshop, style);
    const Sweep drawn = Sweep::ellipses(shown.drawn.view()), made = Sweep::ellipses(shown.result.view());
    Panel panels[] = {solid(drawn, kGrey), solid(made, kLeaf)};
    entitle(panels, {"The example: leaves that turn", "Its result"});
    studio.take("ellipses", panels, 1, kTallWidth, kTallHeight);
}

// Sec. 5.2: two sides are two colours; where the one-sided style is joined, they may change places.
void ribbons(Workshop& workshop, Studio& studio) {
    constexpr float kHalfWidth = 0.028f, kThickness = 0.003f;
    const filigree::CurveSet drawn = workshop.curve(make_style("twist"));
    const filigree::CurveSet target = workshop.curve(wave());
    std::deque<filigree::CurveSet> results;
    std::deque<Sweep> bands;
    std::vector<Panel> panels;
    for (const FlgMetric metric : {FLG_METRIC_CIRCLE, FLG_METRIC_PROJECTIVE}) {
        const FlgStyleAttribute angle[] = {{FLG_ATTRIBUTE_ANGLE, metric, 0.05f, 0}};
        const filigree::Style style = workshop.style(drawn, angle);
        FlgCurveSetStylizeDesc desc = sized(style, 0.030f);
        const filigree::CurveSet& result = results.emplace_back(workshop.stylize(style, target, desc));
        bands.push_back(Sweep::bands(result.view(), kThickness, [](uint32_t) { return kHalfWidth; }));
        Panel& panel = panels.emplace_back(solid(bands.back(), kRed));
        panel.surfaces[0].look.regions = {{kRed, 0.0f, 0.4f}, {kGold, 0.0f, 0.4f}, {kInk, 0.0f, 0.5f}};
    }
    aim_together(panels);
    entitle(panels, {"Two sides: red is joined to red", "One side: a piece may come turned over"});
    panels[1].notes = {{{-0.28f, -0.25f, 0.0f}, "turned over here", {0.0f, 30.0f}}};
    studio.take("ribbons", panels, 1, kTallWidth, kTallHeight);
}

// With its corners cut, thrice (Chaikin): a broad pen shows them.
scenes::Curve rounded(scenes::Curve curve) {
    for (int pass = 0; pass < 3; ++pass) {
        scenes::Curve finer;
        for (size_t i = 0; i + 1 < curve.points.size(); ++i) {
            const scenes::Point &p = curve.points[i], &q = curve.points[i + 1];
            for (const float t : {0.25f, 0.75f}) {
                finer.points.push_back({std::lerp(p.x, q.x, t), std::lerp(p.y, q.y, t), std::lerp(p.z, q.z, t)});
            }
        }
        curve = std::move(finer);
    }
    return curve;
}

// Sec. 5.2: width, S1 x R+: a broad pen, its edge across the stroke.
void width(Workshop& workshop, Studio& studio) {
    constexpr float kThickness = 0.003f;
    scenes::Curve stroke = rounded(make_style("loops"));
    stroke.angles.assign(stroke.points.size(), 0.25f * kTau);
    const filigree::CurveSet drawn =
        example<1>(workshop, stroke, FLG_ATTRIBUTE_WIDTH, [](float u) -> std::array<float, 1> {
            return {0.003f + 0.026f * tapered(u) * std::pow(std::sin(0.5f * kTau * (11.0f * u + 0.1f)), 2.0f)};
        });
    const FlgStyleAttribute pen[] = {{FLG_ATTRIBUTE_WIDTH, FLG_METRIC_AUTO, 1.0f, 0},
                                     {FLG_ATTRIBUTE_ANGLE, FLG_METRIC_CIRCLE, 0.0f, 0}};
    const filigree::Style style = workshop.style(drawn, pen);
    const Shown shown(workshop, style);
    std::deque<Sweep> bands;
    std::vector<Panel> panels;
    for (const filigree::CurveSet* set : {&shown.drawn, &shown.result}) {
        const FlgColumn& column = *samples::find_column(set->view(), FLG_ATTRIBUTE_WIDTH);
        bands.push_back(Sweep::bands(set->view(), kThickness,
                                     [&](uint32_t point) { return 0.5f * *samples::value_at(column, point); }));
        panels.push_back(solid(bands.back(), set == &shown.drawn ? kGrey : kTeal));
    }
    entitle(panels, {"The example: a broad pen", "Its result"});
    studio.take("width", panels, 1, kTallWidth, kTallHeight);
}

// Where a motion is at even times.
std::vector<glm::vec3> flashes(const FlgCurveSetView& motion, float every_s) {
    const std::vector<glm::vec3> points = vectors_of(motion);
    const FlgColumn& times = *samples::find_column(motion, FLG_ATTRIBUTE_TIME);
    std::vector<glm::vec3> places;
    float next = 0.0f;
    for (uint32_t i = 0; i + 1 < points.size(); ++i) {
        const float from = *samples::value_at(times, i), to = *samples::value_at(times, i + 1);
        for (; next <= to; next += every_s)
            places.push_back(glm::mix(points[i], points[i + 1], (next - from) / (to - from)));
    }
    return places;
}

// Sec. 5: speed, trajectories in 4D: flashes of light at even times.
void speed(Workshop& workshop, Studio& studio) {
    const scenes::Curve stroke = make_style("loops");
    const filigree::CurveSet drawn =
        example<1>(workshop, stroke, FLG_ATTRIBUTE_SPEED, [&](float u) -> std::array<float, 1> {
            // As if thrown: slow where it is high above the stroke's lowest points.
            const auto i = static_cast<size_t>(u * static_cast<float>(stroke.points.size() - 1) + 0.5f);
            return {std::sqrt(std::max(0.010f, 1.2f * (0.17f - stroke.points[i].y)))};
        });
    const FlgStyleAttribute speeds[] = {{FLG_ATTRIBUTE_SPEED, FLG_METRIC_AUTO, 0.05f, 0}};
    const filigree::Style style = workshop.style(drawn, speeds);
    const Shown shown(workshop, style);
    std::deque<filigree::CurveSet> dots;
    std::vector<Panel> panels;
    for (const filigree::CurveSet* set : {&shown.drawn, &shown.result}) {
        std::vector<scenes::Curve> balls;
        for (const glm::vec3& p : flashes(set->view(), 0.08f)) balls.push_back(dot(p));
        dots.push_back(workshop.curves(balls));
        Panel& panel = panels.emplace_back(panel_of(set->view(), tube(kGrey, 0.0018f)));
        panel.layers.push_back(shape_of(dots.back().view(), tube(set == &shown.drawn ? kInk : kRed, 0.0065f)));
    }
    entitle(panels, {"The example: dots at equal times", "Its result"});
    studio.take("speed", panels, 1, kTallWidth, kTallHeight);
}

constexpr Picture kPictures[] = {
    {"attributes", "Sec. 5.1: the shape alone; with radius and colour", true, attributes},
    {"ellipses", "Sec. 5.1: elliptic cross-sections: a style, and its result", true, ellipses},
    {"ribbons", "Sec. 5.2: a ribbon with two sides, and with one", true, ribbons},
    {"width", "Sec. 5.2: width: a style, and its result", true, width},
    {"speed", "Sec. 5: speed: dots at even times on a style, and on its result", true, speed},
};

}  // namespace

std::span<const Picture> attribute_pictures() {
    return kPictures;
}

}  // namespace flg::gallery
