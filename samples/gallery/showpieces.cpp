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
    studio.take("magnitude", panels, 3, kWidth, 330);
}

void thomas(Workshop& workshop, Studio& studio) {
    constexpr uint32_t kThomasWidth = 720, kThomasHeight = 480;
    const filigree::CurveSet target = workshop.curve(scenes::make_target("thomas"));
    const FlgStyleAttribute angle[] = {{FLG_ATTRIBUTE_ANGLE, FLG_METRIC_CIRCLE, 0.01f, 0}};
    const filigree::Style style = workshop.style(workshop.curve(scenes::make_style("twist")), angle);
    const filigree::CurveSet result = workshop.stylize(style, target, sized(style, 0.012f));
    Panel panel;
    panel.layers = {{Columns(result.view()).without(FLG_ATTRIBUTE_COLOR), ribbon(kRed, kGold, 0.004f)}};
    panel.sight = {-1.0f, -1.0f, 1.0f};
    studio.take("thomas", {&panel, 1}, 1, kThomasWidth, kThomasHeight);
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
    const render::CurveLook band = ribbon(kRed, kGold, 0.016f);
    std::vector<Panel> panels = {panel_of(drawn.view(), tube(kTeal, 0.007f)),
                                 panel_of(result.view(), tube(kInk, 0.0050f), kSight),
                                 panel_of(result.view(), band, kSight)};
    panels[0].layers.push_back(shape_of(guide.view(), tube(kGrey, 0.005f)));
    aim_together(std::span(panels).last(2));
    studio.take("lorenz", panels, 3, kWidth, 360);
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
