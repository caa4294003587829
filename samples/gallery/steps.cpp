// SPDX-License-Identifier: MIT
// What a step of the method does, and what happens without it.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <deque>
#include <span>

#include "gallery/looks.h"
#include "gallery/marks.h"
#include "gallery/pictures.h"
#include "reference/literal_guide_flow.h"
#include "reference/literal_matching.h"

namespace flg::gallery {
namespace {

using scenes::make_style;

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

// Dots of the points, coloured by how far each is from its neighbours, against the mean: blue where they are close,
// white as usual, red where they leave a gap.
glm::vec3 spacing_color(double share) {
    const auto close = static_cast<float>(std::clamp((1.0 - share) / 0.7, 0.0, 1.0)),
               far = static_cast<float>(std::clamp((share - 1.0) / 0.9, 0.0, 1.0));
    return close > 0.0f ? glm::mix(glm::vec3(0.75f), glm::vec3(0.01f, 0.10f, 0.55f), close)
                        : glm::mix(glm::vec3(0.75f), kRed, far);
}

// Fig. 13: the literal flow, as it does not respace its points otherwise.
void redistribution(Workshop& workshop, Studio& studio) {
    constexpr size_t kPoints = 160;
    constexpr double kAlpha = 0.25, kStepTime = 1e-5;
    constexpr uint32_t kSteps = 160;
    const scenes::Curve example = make_style("curls");
    const std::vector<Vec3> start = evenly_spaced(example, kPoints);
    std::deque<filigree::CurveSet> sets;
    std::vector<Panel> panels;
    for (const bool redistributed : {true, false}) {
        const auto flow = reference::literal_guide_flow(start, kAlpha, kStepTime, kSteps, redistributed);
        std::vector<glm::dvec3> points;
        for (const Vec3& p : flow.points) points.emplace_back(p.x(), p.y(), p.z());
        const auto gap = [&](size_t i) { return glm::distance(points[i], points[i + 1]); };
        double mean = 0.0, least = gap(0), most = gap(0);
        for (size_t i = 0; i + 1 < points.size(); ++i) {
            mean += gap(i) / static_cast<double>(points.size() - 1);
            least = std::min(least, gap(i)), most = std::max(most, gap(i));
        }
        scenes::Curve line;
        for (const glm::dvec3& p : points) line.points.push_back(to_point(p));
        Panel& panel = panels.emplace_back();
        sets.push_back(workshop.curve(line));
        panel.layers.push_back(shape_of(sets.back().view(), tube(kGrey, 0.0015f)));
        for (size_t i = 0; i < points.size(); ++i) {
            const double around = i == 0 ? gap(0) : i + 1 == points.size() ? gap(i - 1) : 0.5 * (gap(i - 1) + gap(i));
            sets.push_back(workshop.curve(dot(points[i])));
            panel.layers.push_back(shape_of(sets.back().view(), tube(spacing_color(around / mean), 0.0062f)));
        }
        char words[120];
        std::snprintf(words, sizeof words, "%s: the longest gap is %.1f times the shortest",
                      redistributed ? "With redistribution" : "Without", most / least);
        panel.title = words;
        if (!redistributed) {
            panel.keys = {{spacing_color(0.0), "points crowd together"}, {kRed, "points leave gaps"}};
        }
        panel.sight = {0.0f, -0.1f, -1.0f};
        panel.ground = false;
    }
    studio.take("redistribution", panels, 1, kWidth, kHeight);
}

std::vector<Vec3> vectors(const std::vector<glm::vec3>& points) {
    std::vector<Vec3> copies;
    for (const glm::vec3& p : points) copies.emplace_back(p.x, p.y, p.z);
    return copies;
}

// Fig. 14: the guide's points, each joined to its place on the style: at one of its points only (grey dots), by the
// literal matching, or anywhere.
void matching(Workshop& workshop, Studio& studio) {
    constexpr uint32_t kPoints = 26;
    scenes::Curve example = make_style("loops");
    example.points.resize(150), example.radii.resize(150);
    const filigree::CurveSet drawn = workshop.curve(example);
    std::deque<filigree::CurveSet> sets;
    std::vector<Panel> panels;
    FlgStyleDesc prepare = flgStyleDefaults();
    prepare.point_count = kPoints;
    const filigree::Style style = workshop.style(example, prepare);
    const FlgStyleInfo info = style.info();
    const filigree::CurveSet guide = style.guide();
    const std::vector<glm::vec3> from = vectors_of(guide.view());
    std::vector<float> even;
    for (uint32_t i = 0; i < kPoints; ++i) even.push_back(info.style_length * static_cast<float>(i) / (kPoints - 1));
    const std::vector<glm::vec3> own_points = places_on(drawn.view(), even);
    const auto literal = reference::match_discrete(vectors(own_points), static_cast<double>(info.style_length),
                                                   vectors(from), static_cast<double>(prepare.beta), false);
    const std::vector<float> literal_places(literal.delta.begin(), literal.delta.end());
    for (const bool discrete : {true, false}) {
        const std::span<const float> places =
            discrete ? std::span<const float>(literal_places) : std::span(info.matching, kPoints);
        const double energy = discrete ? literal.energy / kPoints : static_cast<double>(info.matching_energy);
        const std::vector<glm::vec3> to = places_on(drawn.view(), places);
        std::vector<scenes::Curve> links, ends, own, beads;
        for (uint32_t i = 0; i < kPoints; ++i) {
            links.emplace_back().points = {to_point(from[i]), to_point(to[i])};
            beads.push_back(dot(from[i])), ends.push_back(dot(to[i]));
            own.push_back(dot(own_points[i]));
        }
        Panel panel = panel_of(drawn.view(), tube(kGrey, 0.0013f), {0.0f, 0.0f, -1.0f});
        const auto add = [&](const std::vector<scenes::Curve>& curves, const render::CurveLook& look) {
            sets.push_back(workshop.curves(curves));
            panel.layers.push_back(shape_of(sets.back().view(), look));
        };
        add(links, tube(kGold, 0.0007f));
        add(own, tube(kGrey, 0.0026f));
        add(beads, tube(kTeal, 0.0030f));
        add(ends, tube(kRed, 0.0034f));
        char words[100];
        std::snprintf(words, sizeof words, "%s: energy %.2f mm\u00b2", discrete ? "Discrete" : "Semi-discrete",
                      1e6 * energy);
        panel.title = words;
        if (discrete) {
            panel.keys = {
                {kTeal, "points of the guide"}, {kRed, "where each is matched"}, {kGrey, "points of the style"}};
        } else {
            panel.keys = {{kRed, "matched anywhere on the style"}};
        }
        panel.margin = 1.04f;
        panel.ground = false;
        panels.push_back(panel);
    }
    aim_together(panels);
    studio.take("matching", panels, 2, kWidth, 400);
}

constexpr Picture kPictures[] = {
    {"redistribution", "Fig. 13: the guide's flow with and without tangential redistribution", true, redistribution},
    {"matching", "Fig. 14: discrete and semi-discrete matching", true, matching},
};

}  // namespace

std::span<const Picture> steps() {
    return kPictures;
}

}  // namespace flg::gallery
