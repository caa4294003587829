// SPDX-License-Identifier: MIT
// What a step of the method does, and what happens without it.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iterator>
#include <span>

#include "gallery/looks.h"
#include "gallery/marks.h"
#include "gallery/pictures.h"
#if defined(FLG_WITH_REFERENCE)
#include "reference/literal_guide_flow.h"
#endif

namespace flg::gallery {
namespace {

using scenes::make_style;
using scenes::make_target;

#if defined(FLG_WITH_REFERENCE)
std::vector<Vec3> evenly_spaced(const scenes::Curve& curve, size_t count) {
    std::vector<Vec3> points, even;
    std::vector<double> lengths;
    for (const scenes::Point& p : curve.points) {
        points.emplace_back(p.x, p.y, p.z);
        lengths.push_back(lengths.empty() ? 0.0 : lengths.back() + (points.back() - points[points.size() - 2]).norm());
    }
    for (size_t i = 0, at = 0; i < count; ++i) {
        const double length = lengths.back() * static_cast<double>(i) / static_cast<double>(count - 1);
        while (at + 2 < points.size() && lengths[at + 1] < length) ++at;
        const double along = (length - lengths[at]) / (lengths[at + 1] - lengths[at]);
        even.push_back(points[at] + along * (points[at + 1] - points[at]));
    }
    return even;
}

// Fig. 13: the literal flow, as it does not respace its points otherwise.
void redistribution(Workshop& workshop, Studio& studio) {
    constexpr size_t kPoints = 160;
    constexpr double kAlpha = 0.25, kStepTime = 1e-5;
    constexpr uint32_t kSteps = 160;
    const scenes::Curve example = make_style("curls");
    const std::vector<Vec3> start = evenly_spaced(example, kPoints);
    std::vector<filigree::CurveSet> sets;
    std::vector<Panel> panels;
    for (const bool redistributed : {true, false}) {
        const auto flow = reference::literal_guide_flow(start, kAlpha, kStepTime, kSteps, redistributed);
        scenes::Curve line;
        std::vector<scenes::Curve> dots;
        for (const Vec3& p : flow.points) {
            line.points.push_back({static_cast<float>(p.x()), static_cast<float>(p.y()), static_cast<float>(p.z())});
            dots.push_back(dot({p.x(), p.y(), p.z()}));
        }
        const glm::vec3 color = redistributed ? kTeal : kRed;
        Panel& panel = panels.emplace_back();
        sets.push_back(workshop.curve(line));
        panel.layers.push_back({Columns(sets.back().view()).without(FLG_ATTRIBUTE_COLOR), tube(kGrey, 0.0015f)});
        sets.push_back(workshop.curves(dots));
        panel.layers.push_back({Columns(sets.back().view()).without(FLG_ATTRIBUTE_COLOR), tube(color, 0.0055f)});
        panel.sight = {0.0f, -0.1f, -1.0f};
        panel.ground = false;
    }
    studio.take("redistribution", panels, 1, kWidth, kHeight);
}
#endif

// Fig. 14: the guide's points, each joined to its place on the style: at one of its points only (grey dots), or anywhere.
void matching(Workshop& workshop, Studio& studio) {
    constexpr uint32_t kPoints = 44;
    scenes::Curve example = make_style("loops");
    example.points.resize(200), example.radii.resize(200);
    const filigree::CurveSet drawn = workshop.curve(example);
    std::vector<filigree::CurveSet> sets;
    std::vector<Panel> panels;
    for (FlgMatching kind : {FLG_MATCHING_DISCRETE, FLG_MATCHING_SEMI_DISCRETE}) {
        FlgStyleDesc prepare = flgStyleDefaults();
        prepare.matching = kind;
        prepare.point_count = kPoints;
        const filigree::Style style = workshop.style(example, prepare);
        const FlgStyleInfo info = style.info();
        std::printf("%s matching: E' = %.4g mm^2\n", kind == FLG_MATCHING_DISCRETE ? "discrete" : "semi-discrete",
                    1e6 * static_cast<double>(info.matching_energy));
        const filigree::CurveSet guide = style.guide();
        const std::vector<glm::vec3> from = vectors_of(guide.view()),
                                     to = places_on(drawn.view(), {info.matching, kPoints});
        std::vector<float> even;
        std::vector<scenes::Curve> links, dots, own;
        for (uint32_t i = 0; i < kPoints; ++i) {
            links.emplace_back().points = {to_point(from[i]), to_point(to[i])};
            dots.push_back(dot(from[i])), dots.push_back(dot(to[i]));
            even.push_back(info.style_length * static_cast<float>(i) / (kPoints - 1));
        }
        for (const glm::vec3& p : places_on(drawn.view(), even)) own.push_back(dot(p));
        const glm::vec3 color = kind == FLG_MATCHING_DISCRETE ? kRed : kTeal;
        Panel panel = panel_of(drawn.view(), tube(kGrey, 0.0009f), {0.0f, 0.0f, -1.0f});
        const auto add = [&](const std::vector<scenes::Curve>& curves, const render::CurveLook& look) {
            sets.push_back(workshop.curves(curves));
            panel.layers.push_back({Columns(sets.back().view()).without(FLG_ATTRIBUTE_COLOR), look});
        };
        add(links, tube(color, 0.0006f));
        add(dots, tube(color, 0.0030f));
        add(own, tube(kGrey, 0.0026f));
        panel.ground = false;
        panels.push_back(panel);
    }
    studio.take("matching", panels, 1, kWidth, kHeight);
}

// Fig. 15, without length preservation. Above: the style, itself a bent curve with curls, and its guide; below: the result.
void length_preservation(Workshop& workshop, Studio& studio) {
    const filigree::CurveSet bend = workshop.curve(make_target("s_curve"));
    const filigree::Style curls = workshop.style(make_style("curls"));
    const filigree::CurveSet bent = workshop.stylize(curls, bend, sized(curls, 0.045f));
    scenes::Curve arch;
    for (int i = -50; i <= 50; ++i) {
        const float x = 0.016f * static_cast<float>(i);
        arch.points.push_back({x, -0.4f * x * x, 0.0f});
    }
    const filigree::CurveSet target = workshop.curve(arch);
    std::vector<filigree::CurveSet> sets;
    std::vector<Panel> above, below;
    FlgStyleDesc prepare = flgStyleDefaults();
    for (const float alpha : {prepare.alpha, 0.0f}) {
        const glm::vec3 color = alpha > 0.0f ? kTeal : kRed;
        prepare.alpha = alpha;
        const filigree::Style style = workshop.style(bent, prepare);
        sets.push_back(style.guide());
        above.push_back(panel_of(bent.view(), tube(kGrey, 0.004f)));
        above.back().layers.push_back({Columns(sets.back().view()), tube(color, 0.010f)});
        sets.push_back(workshop.stylize(style, target));
        below.push_back(panel_of(sets.back().view(), tube(color, 0.007f)));
    }
    above.insert(above.end(), below.begin(), below.end());
    studio.take("length_preservation", above, 2, kWidth, kHeight);
}

// A line with spikes.
scenes::Curve spikes() {
    constexpr float kSpacing = 0.10f, kHalfWidth = 0.014f, kStep = 0.002f;
    constexpr float kHeights[] = {0.10f, 0.13f, 0.09f, 0.14f, 0.11f, 0.12f, 0.09f, 0.13f};
    std::vector<glm::vec3> corners = {glm::vec3(0.0f)};
    for (size_t i = 0; i < std::size(kHeights); ++i) {
        const float x = kSpacing * (static_cast<float>(i) + 0.5f);
        corners.insert(corners.end(),
                       {{x - kHalfWidth, 0.0f, 0.0f}, {x, kHeights[i], 0.0f}, {x + kHalfWidth, 0.0f, 0.0f}});
    }
    corners.emplace_back(kSpacing * std::size(kHeights), 0.0f, 0.0f);
    scenes::Curve curve;
    for (size_t i = 0; i + 1 < corners.size(); ++i) {
        const auto steps = static_cast<uint32_t>(std::ceil(glm::distance(corners[i], corners[i + 1]) / kStep));
        for (uint32_t k = 0; k < steps; ++k) {
            const float along = static_cast<float>(k) / static_cast<float>(steps);
            curve.points.push_back(to_point(glm::mix(corners[i], corners[i + 1], along)));
        }
    }
    return curve;
}

// Fig. 15, without matching: at the right evenness alone, each point of the guide has its equal share of the style.
void evenness(Workshop& workshop, Studio& studio) {
    constexpr float kClose = 0.9f, kEvennessAlone = 1e-4f, kRadius = 0.12f;
    scenes::Curve arc;
    for (int i = 0; i <= 200; ++i) {
        const float a = 0.028f * static_cast<float>(i);
        arc.points.push_back({kRadius * std::cos(a), kRadius * std::sin(a), 0.0f});
    }
    const filigree::CurveSet target = workshop.curve(arc);
    std::vector<filigree::CurveSet> sets;
    std::vector<Panel> panels;
    FlgStyleDesc prepare = flgStyleDefaults();
    for (const float beta : {kClose, prepare.beta, kEvennessAlone}) {
        prepare.beta = beta;
        const filigree::Style style = workshop.style(spikes(), prepare);
        sets.push_back(workshop.stylize(style, target));
        Panel& panel =
            panels.emplace_back(panel_of(sets.back().view(), tube(beta > kEvennessAlone ? kTeal : kRed, 0.0035f)));
        panel.layers.push_back(shape_of(target.view(), tube(kGrey, 0.0015f)));
        panel.sight = {0.0f, -0.1f, -1.0f};
        panel.ground = false;
    }
    aim_together(panels);
    studio.take("evenness", panels, 3, kWidth, 330);
}

constexpr Picture kPictures[] = {
#if defined(FLG_WITH_REFERENCE)
    {"redistribution", "Fig. 13: the guide's flow with and without tangential redistribution", true, redistribution},
#endif
    {"matching", "Fig. 14: discrete and semi-discrete matching", true, matching},
    {"length_preservation", "Fig. 15: with and without length preservation", true, length_preservation},
    {"evenness", "Fig. 15: matching by closeness, as usual, and by evenness alone", true, evenness},
};

}  // namespace

std::span<const Picture> steps() {
    return kPictures;
}

}  // namespace flg::gallery
