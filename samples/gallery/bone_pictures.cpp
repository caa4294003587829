// SPDX-License-Identifier: MIT
// How joints are chosen along a branch, and how parts are hung on each other (Ma et al. 2021).
#include <algorithm>
#include <cmath>
#include <deque>
#include <iterator>
#include <numbers>
#include <stdexcept>

#include "gallery/drawn_shapes.h"
#include "gallery/pictures.h"

namespace flg::gallery {
namespace {

// A band of these half widths around an axis, an arc of a sine.
Line limb() {
    static constexpr double kHalfWidths[] = {0.35, 0.80, 1.00, 0.85, 0.55, 0.42, 0.55, 0.72, 0.62, 0.45, 0.36, 0.25};
    const auto at = [](int i, double side) {
        const double x = 0.75 * i, slope = 1.3 * 0.62 * std::cos(0.62 * x);
        const glm::dvec2 left = glm::dvec2(-slope, 1.0) / std::hypot(slope, 1.0);
        return glm::dvec2(x, 1.3 * std::sin(0.62 * x)) + side * kHalfWidths[i] * left;
    };
    Line line;
    constexpr int kCount = static_cast<int>(std::size(kHalfWidths));
    for (int i = 0; i < kCount; ++i) line.push_back(at(i, -1.0));
    for (int i = kCount; i-- > 0;) line.push_back(at(i, 1.0));
    return drawn(line, 0.0);
}

// Fig. 7: axis and slices; the first three steps of BoundedDP. Below, the slices side by side, and the trapezoids for them.
void bounded_dp(Workshop& workshop, Studio& studio) {
    constexpr double kUnit = 0.055;
    constexpr uint32_t kSliceEvery = 3;
    const Line line = limb();
    const FlgPart part = make_part(workshop, line);
    const FlgPartView view = part_view(workshop, part);
    const FlgPartMeshView body = body_of(workshop, part);
    std::vector<FlgAxisSample> samples(view.samples + view.branches[2], view.samples + view.branches[3]);
    if (samples.front().x > samples.back().x) {  // from left to right
        std::reverse(samples.begin(), samples.end());
        for (FlgAxisSample& s : samples) s.left_x = -s.left_x, s.left_y = -s.left_y, std::swap(s.left, s.right);
    }
    Line axis;
    std::vector<Line> slices, upright;
    std::vector<double> lengths;
    for (const FlgAxisSample& s : samples) {
        lengths.push_back(axis.empty() ? 0.0 : lengths.back() + glm::distance(axis.back(), sample_at(s)));
        axis.push_back(sample_at(s));
        if (axis.size() % kSliceEvery != 1) continue;
        const glm::dvec2 left(s.left_x, s.left_y);
        slices.push_back({axis.back() + s.left * left, axis.back() - s.right * left});
        upright.push_back({{lengths.back(), s.left}, {lengths.back(), -s.right}});
    }
    std::deque<Sketch> above, below;
    FlgBoneThresholds thresholds = {.simplify = 0.5f, .merge = 0.0f, .prune = 0.0f, .collapse = 0.0f};
    uint32_t joints = 0;
    while (above.size() < 4) {
        const FlgModelView model = make_model(workshop, {&part, 1}, thresholds);
        thresholds.simplify *= 0.95f;
        if (model.joint_count == joints) continue;
        Sketch &whole = above.emplace_back(workshop, kUnit), &apart = below.emplace_back(workshop, kUnit);
        whole.fill(body, kPaper);
        whole.ring(line, kInk, 1.6);
        if (above.size() == 1) {
            whole.lines(slices, kTeal, 1.4);
            whole.line(axis, kRed, 2.6);
            apart.lines(upright, kTeal, 1.8);
            apart.line({{0.0, 0.0}, {lengths.back(), 0.0}}, kRed, 2.6);
            continue;
        }
        joints = model.joint_count;
        whole.line(axis, kRed, 2.0);
        draw_bones(whole, model, kInk, kRed);
        std::vector<size_t> chosen;
        for (size_t j = 0; j < joints; ++j) {
            const auto nearer = [&](const glm::dvec2& a, const glm::dvec2& b) {
                return glm::distance(a, joint_at(model, j)) < glm::distance(b, joint_at(model, j));
            };
            chosen.push_back(static_cast<size_t>(std::min_element(axis.begin(), axis.end(), nearer) - axis.begin()));
        }
        std::sort(chosen.begin(), chosen.end());
        apart.lines(upright, kTeal, 1.8);
        for (size_t k = 0; k + 1 < chosen.size(); ++k) {
            const FlgAxisSample &a = samples[chosen[k]], &b = samples[chosen[k + 1]];
            const double from = lengths[chosen[k]], to = lengths[chosen[k + 1]];
            apart.ring({{from, a.left}, {to, b.left}, {to, -b.right}, {from, -a.right}}, kRed, 2.6);
        }
    }
    std::vector<Panel> panels;
    for (const Sketch& sketch : above) panels.push_back(sketch.panel());
    for (const Sketch& sketch : below) panels.push_back(sketch.panel());
    studio.take("skeleton_bounded_dp", panels, 4, kWidth, 284);
}

// A strip with round ends.
Line strip(glm::dvec2 from, glm::dvec2 to, double half_width) {
    const glm::dvec2 along = half_width * glm::normalize(to - from), left(-along.y, along.x);
    Line line;
    constexpr int kSteps = 8;
    for (const auto& [end, turn] : {std::pair{to, -0.5}, std::pair{from, 0.5}}) {
        for (int i = 0; i <= kSteps; ++i) {
            const double a = (turn + static_cast<double>(i) / kSteps) * std::numbers::pi;
            line.push_back(end + std::cos(a) * along + std::sin(a) * left);
        }
    }
    return line;
}

// Fig. 9: a leg on a torso. Balls and cones are what tells whether they meet.
void connection(Workshop& workshop, Studio& studio) {
    constexpr double kUnit = 0.04;
    constexpr FlgBoneThresholds kKeepAll = {.simplify = 0.01f, .merge = 0.0f, .prune = 0.0f, .collapse = 0.0f};
    const Line torso = strip({-2.4, 0.0}, {2.2, 0.3}, 1.0);
    std::deque<Sketch> sketches;
    std::vector<Panel> panels;
    for (const FlgPartEvent event : {FLG_PART_BONE_SPLIT, FLG_PART_JOINT_CONNECT}) {
        const double x = event == FLG_PART_BONE_SPLIT ? 0.3 : 2.65;
        const Line leg = strip({x, -0.25}, {x + 0.35, -2.9}, 0.42);
        const FlgPart parts[] = {make_part(workshop, torso), make_part(workshop, leg)};
        const FlgModelView model = make_model(workshop, parts, kKeepAll);
        if (model.parts[1].event != event) throw std::runtime_error("connection: another event than the picture's");
        Sketch& sketch = sketches.emplace_back(workshop, kUnit);
        std::vector<Line> bones[2], joined;
        std::vector<glm::dvec2> joints[2], met;
        for (size_t j = 0; j < model.joint_count; ++j) {
            const uint32_t of = model.joint_parts[j], parent = model.joint_parents[j];
            joints[of].push_back(joint_at(model, j));
            if (parent == FLG_NO_INDEX) continue;
            const Line bone = {joint_at(model, parent), joint_at(model, j)};
            if (of != model.joint_parts[parent]) {
                joined.push_back(bone), met.push_back(bone[0]);
                continue;
            }
            bones[of].push_back(bone);
            sketch.cone(bone[0], double{model.joint_radii[parent]}, bone[1], double{model.joint_radii[j]},
                        of == 0 ? kPaper : kShape);
        }
        sketch.ring(torso, kInk, 1.4), sketch.ring(leg, kInk, 1.4);
        for (int of = 0; of < 2; ++of) {
            sketch.lines(bones[of], of == 0 ? kInk : kTeal, 3.0);
            sketch.dots(joints[of], of == 0 ? kInk : kTeal, 6.5);
        }
        sketch.lines(joined, kRed, 4.0);
        sketch.dots(met, kRed, 8.0);
        panels.push_back(sketch.panel());
    }
    aim_together(panels);
    studio.take("skeleton_connection", panels, 2, kWidth, 360);
}

constexpr Picture kPictures[] = {
    {"skeleton_bounded_dp", "Fig. 7: BoundedDP's first three steps, for the axis and for the slices", true, bounded_dp},
    {"skeleton_connection", "Fig. 9: bone split and joint connect", true, connection},
};

}  // namespace

std::span<const Picture> bone_pictures() {
    return kPictures;
}

}  // namespace flg::gallery
