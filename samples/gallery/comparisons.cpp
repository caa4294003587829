// SPDX-License-Identifier: MIT
// What an option does, side by side.
#include <cmath>

#include "gallery/looks.h"
#include "gallery/pictures.h"

namespace flg::gallery {
namespace {

using scenes::make_style;
using scenes::make_target;

constexpr uint32_t kLowHeight = 360;

// Fig. 5.
void temperature(Workshop& workshop, Studio& studio) {
    const filigree::CurveSet target = workshop.curve(make_target("s_curve"));
    const filigree::Style style = workshop.style(make_style("knots"));
    std::vector<filigree::CurveSet> results;
    std::vector<Panel> panels;
    for (float tau : {0.0f, 1.0f, 10.0f}) {
        FlgStylizeDesc desc = sized(style, 0.040f);
        desc.temperature = tau;
        results.push_back(workshop.stylize(style, target, desc));
        panels.push_back(panel_of(results.back().view(), tube(kRed, 0.008f)));
        panels.back().nearer = 1.0f;
        panels.back().shift = {0.02f, 0.0f};
    }
    studio.take("temperature", panels, 3, kWidth, kHeight);
}

// Fig. 12: an arc that turns the other way in its middle.
void frames(Workshop& workshop, Studio& studio) {
    constexpr glm::vec3 kFromAbove = {-0.15f, -0.85f, -1.0f};
    scenes::Curve wave;
    for (int i = 0; i < 200; ++i) {
        const double u = i / 199.0 - 0.5;
        wave.points.push_back({static_cast<float>(1.6 * u), static_cast<float>(0.25 * std::sin(9.0 * u)),
                               static_cast<float>(0.05 * std::sin(5.0 * u))});
    }
    const filigree::CurveSet target = workshop.curve(wave);
    const filigree::Style style = workshop.style(make_style("loops"));
    std::vector<filigree::CurveSet> results;
    std::vector<Panel> panels;
    for (FlgFrameMethod frame : {FLG_FRAME_FRENET, FLG_FRAME_ROTATION_MINIMIZING}) {
        FlgStylizeDesc desc = sized(style, 0.055f);
        desc.frame = frame;
        results.push_back(workshop.stylize(style, target, desc));
        Panel panel =
            panel_of(results.back().view(), tube(frame == FLG_FRAME_FRENET ? kRed : kTeal, 0.008f), kFromAbove);
        panel.nearer = 0.95f;
        panel.layers.push_back({target.view(), tube(kGrey, 0.003f)});
        panel.layers.back().curves = panel.layers.back().curves.without(FLG_ATTRIBUTE_COLOR);
        panels.push_back(panel);
    }
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
        panels.back().nearer = 0.98f;
        all.layers.push_back(panels.back().layers[0]);
    }
    all.sight = panels[0].sight, all.nearer = panels[0].nearer;
    studio.take("planes", {panels[0], panels[1], panels[2], all}, 4, kWidth, kLowHeight);
}

// Sec. 5.1: the thickness belongs to the style.
void attributes(Workshop& workshop, Studio& studio) {
    const filigree::CurveSet target = workshop.curve(make_target("flourish"));
    const FlgStyleAttribute kept[] = {{FLG_ATTRIBUTE_RADIUS, FLG_METRIC_AUTO, 1.0f, 0},
                                      {FLG_ATTRIBUTE_COLOR, FLG_METRIC_AUTO, 0.0f, 0}};
    FlgStyleDesc prepare = flgStyleDefaults();
    const filigree::Style plain = workshop.style(make_style("beads"), prepare);
    prepare.attributes = kept;
    prepare.attribute_count = 2;
    const filigree::Style beads = workshop.style(make_style("beads"), prepare);
    const filigree::CurveSet shape = workshop.stylize(plain, target), all = workshop.stylize(beads, target);
    Panel before = panel_of(shape.view(), tube(kLeaf, 0.006f)), after = before;
    after.layers = {{all.view(), tube()}};
    studio.take("attributes", {before, after}, 2, kWidth, kLowHeight);
}

constexpr Picture kPictures[] = {
    {"temperature", "Fig. 5: temperature 0, 1 and 10", true, temperature},
    {"frames", "Fig. 12: Frenet frames flip at inflections, rotation-minimizing ones don't", true, frames},
    {"planes", "Fig. 16: a style drawn in a plane, in three planes, and all at once", true, planes},
    {"attributes", "Sec. 5: the shape alone; with radius and colour", true, attributes},
};

}  // namespace

std::span<const Picture> comparisons() {
    return kPictures;
}

}  // namespace flg::gallery
