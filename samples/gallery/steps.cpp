// SPDX-License-Identifier: MIT
// What a step of the method does, and what happens without it.
#include <algorithm>
#include <cstdio>
#include <span>

#include "gallery/looks.h"
#include "gallery/pictures.h"
#include "support/curve_source.h"
#if defined(FLG_WITH_REFERENCE)
#include "reference/literal_guide_flow.h"
#endif

namespace flg::gallery {
namespace {

using scenes::make_style;
using scenes::make_target;

scenes::Point point_of(const float* p) {
    return {p[0], p[1], p[2]};
}

// A ball: a tube without length, round at its ends.
scenes::Curve dot(scenes::Point p) {
    constexpr float kLength = 1e-5f;
    scenes::Curve ball;
    ball.points = {p, {p.x + kLength, p.y, p.z}};
    return ball;
}

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
            dots.push_back(dot(line.points.back()));
        }
        const glm::vec3 color = redistributed ? kTeal : kRed;
        Panel& panel = panels.emplace_back();
        sets.push_back(workshop.curve(line));
        panel.layers.push_back({Columns(sets.back().view()).without(FLG_ATTRIBUTE_COLOR), tube(kGrey, 0.0015f)});
        sets.push_back(workshop.curves(dots));
        panel.layers.push_back({Columns(sets.back().view()).without(FLG_ATTRIBUTE_COLOR), tube(color, 0.0055f)});
        panel.sight = {0.0f, -0.1f, -1.0f};
        panel.nearer = 0.93f;
        panel.ground = false;
    }
    studio.take("redistribution", panels, 1, kWidth, kHeight);
}
#endif

// Where these lengths along a curve lead, which must not fall.
std::vector<scenes::Point> places_on(const FlgCurveSetView& curve, std::span<const float> lengths) {
    const FlgColumn& positions = *samples::find_column(curve, FLG_ATTRIBUTE_POSITION);
    const auto at = [&](uint32_t i) {
        const float* p = samples::value_at(positions, i);
        return glm::vec3(p[0], p[1], p[2]);
    };
    std::vector<scenes::Point> places;
    uint32_t i = 0;
    float before = 0.0f;  // length up to point i
    for (const float length : lengths) {
        float step = glm::distance(at(i), at(i + 1));
        for (; i + 2 < curve.curve_offsets[1] && before + step < length; step = glm::distance(at(i), at(i + 1))) {
            before += step;
            ++i;
        }
        const glm::vec3 p = glm::mix(at(i), at(i + 1), std::clamp((length - before) / step, 0.0f, 1.0f));
        places.push_back({p.x, p.y, p.z});
    }
    return places;
}

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
        const FlgColumn& from = *samples::find_column(guide.view(), FLG_ATTRIBUTE_POSITION);
        const std::vector<scenes::Point> to = places_on(drawn.view(), {info.matching, kPoints});
        std::vector<float> even;
        std::vector<scenes::Curve> links, dots, own;
        for (uint32_t i = 0; i < kPoints; ++i) {
            const scenes::Point on_guide = point_of(samples::value_at(from, i));
            links.emplace_back().points = {on_guide, to[i]};
            dots.push_back(dot(on_guide)), dots.push_back(dot(to[i]));
            even.push_back(info.style_length * static_cast<float>(i) / (kPoints - 1));
        }
        for (const scenes::Point& p : places_on(drawn.view(), even)) own.push_back(dot(p));
        const glm::vec3 color = kind == FLG_MATCHING_DISCRETE ? kRed : kTeal;
        Panel panel = panel_of(drawn.view(), tube(kGrey, 0.0009f), {0.0f, 0.0f, -1.0f});
        const auto add = [&](const std::vector<scenes::Curve>& curves, const render::CurveLook& look) {
            sets.push_back(workshop.curves(curves));
            panel.layers.push_back({Columns(sets.back().view()).without(FLG_ATTRIBUTE_COLOR), look});
        };
        add(links, tube(color, 0.0006f));
        add(dots, tube(color, 0.0030f));
        add(own, tube(kGrey, 0.0026f));
        panel.nearer = 0.98f;
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
    const FlgColumn& positions = *samples::find_column(bent.view(), FLG_ATTRIBUTE_POSITION);
    scenes::Curve example, arch;
    for (uint32_t i = 0; i < bent.view().curve_offsets[1]; ++i)
        example.points.push_back(point_of(samples::value_at(positions, i)));
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
        const filigree::Style style = workshop.style(example, prepare);
        sets.push_back(style.guide());
        above.push_back(panel_of(bent.view(), tube(kGrey, 0.004f)));
        above.back().layers.push_back({Columns(sets.back().view()), tube(color, 0.010f)});
        sets.push_back(workshop.stylize(style, target));
        below.push_back(panel_of(sets.back().view(), tube(color, 0.007f)));
        above.back().nearer = below.back().nearer = 1.0f;
    }
    above.insert(above.end(), below.begin(), below.end());
    studio.take("length_preservation", above, 2, kWidth, kHeight);
}

// Fig. 15, without matching: evenness alone, each point of the guide has its equal share of the style.
void evenness(Workshop& workshop, Studio& studio) {
    constexpr float kEvennessAlone = 1e-4f;
    const filigree::CurveSet target = workshop.curve(make_target("s_curve"));
    std::vector<filigree::CurveSet> sets;
    std::vector<Panel> panels;
    FlgStyleDesc prepare = flgStyleDefaults();
    for (const float beta : {prepare.beta, kEvennessAlone}) {
        prepare.beta = beta;
        const filigree::Style style = workshop.style(make_style("zigzag"), prepare);
        sets.push_back(workshop.stylize(style, target, sized(style, 0.050f)));
        panels.push_back(panel_of(sets.back().view(), tube(beta > kEvennessAlone ? kTeal : kRed, 0.008f)));
        panels.back().nearer = 0.97f;
    }
    studio.take("evenness", panels, 2, kWidth, kHeight);
}

constexpr Picture kPictures[] = {
#if defined(FLG_WITH_REFERENCE)
    {"redistribution", "Fig. 13: the guide's flow with and without tangential redistribution", true, redistribution},
#endif
    {"matching", "Fig. 14: discrete and semi-discrete matching", true, matching},
    {"length_preservation", "Fig. 15: with and without length preservation", true, length_preservation},
    {"evenness", "Fig. 15: with matching, and with evenness alone", true, evenness},
};

}  // namespace

std::span<const Picture> steps() {
    return kPictures;
}

}  // namespace flg::gallery
