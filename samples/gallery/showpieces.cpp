// SPDX-License-Identifier: MIT
// What a README opens with: strokes before and after, one style at three magnitudes, a large target.
#include "gallery/looks.h"
#include "gallery/pictures.h"

namespace flg::gallery {
namespace {

void strokes(Workshop& workshop, Studio& studio) {
    const filigree::CurveSet target = workshop.curves(scenes::make_bouquet());
    const filigree::Style style = workshop.style(scenes::make_style("loops"));
    const filigree::CurveSet result = workshop.stylize(style, target, sized(style, 0.020f));
    Panel before, after;
    before.layers = {{target.view(), tube()}};
    after.layers = {{result.view(), tube(kInk, 0.0f, 0.25f)}};
    Panel panels[] = {before, after};
    aim_together(panels);
    entitle(panels, {"Plain strokes", "The same strokes in one style"});
    studio.take("strokes", panels, 2, kWidth, kHeight);
}

// Stylized once; the magnitude is changed on the device.
void magnitude(Workshop& workshop, Studio& studio) {
    constexpr float kMagnitudes[] = {0.0f, 0.5f, 1.0f};
    const filigree::CurveSet target = workshop.curve(scenes::make_target("spiral"));
    const filigree::Style style = workshop.style(scenes::make_style("curls"));
    FlgStylizeDesc desc = sized(style, 0.040f);
    desc.keep_displacement = 1;
    const filigree::CurveSet result = workshop.stylize(style, target, desc);
    std::vector<Panel> panels;
    for (float sigma : kMagnitudes) {
        Panel& panel = panels.emplace_back();
        panel.layers = {
            {Columns(result.view()).without(FLG_ATTRIBUTE_COLOR), tube(kTeal, 0.009f), sigma - desc.magnitude}};
        panel.sight = {-0.3f, -0.45f, -1.0f};
    }
    aim_together(panels);
    entitle(panels, {"Magnitude 0", "Magnitude 0.5", "Magnitude 1"});
    studio.take("magnitude", panels, 3, kWidth, 330);
}

void thomas(Workshop& workshop, Studio& studio) {
    constexpr struct {
        uint32_t points;  // 0: as many as the paper has
        float size, radius;
        const char* title;
    } kParts[] = {{2600, 0.030f, 0.026f, "The first 2,600 points"}, {0, 0.012f, 0.004f, "All of it: 369,400 points"}};
    const FlgStyleAttribute angle[] = {{FLG_ATTRIBUTE_ANGLE, FLG_METRIC_CIRCLE, 0.01f, 0}};
    const filigree::Style style = workshop.style(workshop.curve(scenes::make_style("twist")), angle);
    std::vector<filigree::CurveSet> results;
    std::vector<Panel> panels;
    for (const auto& part : kParts) {
        const filigree::CurveSet target = workshop.curve(scenes::make_target("thomas", part.points));
        results.push_back(workshop.stylize(style, target, sized(style, part.size)));
        Panel& panel = panels.emplace_back();
        panel.layers = {
            {Columns(results.back().view()).without(FLG_ATTRIBUTE_COLOR), ribbon(kRed, kGold, part.radius)}};
        panel.sight = {-1.0f, -1.0f, 1.0f};
        panel.title = part.title;
    }
    studio.take("thomas", panels, 2, kWidth, 440);
}

// Fig. 1: the style with its guide, the centre line that it makes of the Lorenz attractor, and the ribbon.
void lorenz(Workshop& workshop, Studio& studio) {
    constexpr uint32_t kPoints = 2800;
    constexpr glm::vec3 kSight = {-0.35f, -0.12f, -1.0f};
    const filigree::CurveSet drawn = workshop.curve(scenes::make_style("twist")),
                             target = workshop.curve(scenes::make_target("lorenz", kPoints));
    const FlgStyleAttribute angle[] = {{FLG_ATTRIBUTE_ANGLE, FLG_METRIC_CIRCLE, 0.01f, 0}};
    const filigree::Style style = workshop.style(drawn, angle);
    const filigree::CurveSet guide = style.guide(), result = workshop.stylize(style, target, sized(style, 0.026f));
    const render::CurveLook band = ribbon(kRed, kGold, 0.018f);
    Panel example = panel_of(drawn.view(), tube(kTeal, 0.010f));
    example.layers.push_back(shape_of(guide.view(), tube(kGrey, 0.007f)));
    example.title = "The example";
    example.keys = {{kTeal, "as drawn"}, {kGrey, "the guide found in it"}};
    std::vector<Panel> panels = {example, panel_of(target.view(), tube(kInk, 0.006f), kSight),
                                 panel_of(result.view(), tube(kInk, 0.0060f), kSight),
                                 panel_of(result.view(), band, kSight)};
    panels[1].title = "The Lorenz attractor";
    panels[2].title = "in the example's shape";
    panels[3].title = "and turning as the example does";
    aim_together(std::span(panels).last(3));
    studio.take("lorenz", panels, 2, kWidth, 760);
}

constexpr Picture kPictures[] = {
    {"strokes", "Strokes before and after", true, strokes},
    {"magnitude", "One style, uploaded once and shown at three magnitudes", true, magnitude},
    {"lorenz", "Fig. 1: a style and its guide; the Lorenz attractor's centre line, stylized; its ribbon", true, lorenz},
    {"thomas", "Fig. 7: a style on the Thomas attractor", true, thomas},
};

}  // namespace

std::span<const Picture> showpieces() {
    return kPictures;
}

}  // namespace flg::gallery
