// SPDX-License-Identifier: MIT
// How joints are chosen along a branch, and how parts are hung on each other (Ma et al. 2021).
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <deque>
#include <iterator>
#include <numbers>
#include <stdexcept>

#include "gallery/drawn_shapes.h"
#include "gallery/pictures.h"

namespace flg::gallery {
namespace {

// A band of these half widths around an axis, an arc of a sine of this height.
Line limb(double bend) {
    static constexpr double kHalfWidths[] = {0.35, 0.80, 1.00, 0.85, 0.55, 0.42, 0.55, 0.72, 0.62, 0.45, 0.36, 0.25};
    const auto at = [bend](int i, double side) {
        const double x = 0.75 * i, slope = bend * 0.62 * std::cos(0.62 * x);
        const glm::dvec2 left = glm::dvec2(-slope, 1.0) / std::hypot(slope, 1.0);
        return glm::dvec2(x, bend * std::sin(0.62 * x)) + side * kHalfWidths[i] * left;
    };
    Line line;
    constexpr int kCount = static_cast<int>(std::size(kHalfWidths));
    for (int i = 0; i < kCount; ++i) line.push_back(at(i, -1.0));
    for (int i = kCount; i-- > 0;) line.push_back(at(i, 1.0));
    return drawn(line, 0.0);
}

// The axis of a limb's longest branch with its slices, from left to right.
std::vector<FlgAxisSample> axis_of(const FlgPartView& view) {
    std::vector<FlgAxisSample> samples(view.samples + view.branches[2], view.samples + view.branches[3]);
    if (samples.front().x > samples.back().x) {
        std::reverse(samples.begin(), samples.end());
        for (FlgAxisSample& s : samples) s.left_x = -s.left_x, s.left_y = -s.left_y, std::swap(s.left, s.right);
    }
    return samples;
}

// Fig. 7: axis and slices; the first three steps of BoundedDP. Below, the slices side by side, and the trapezoids for
// them.
void bounded_dp(Workshop& workshop, Studio& studio) {
    constexpr double kUnit = 0.055;
    constexpr uint32_t kSliceEvery = 3;
    const Line line = limb(1.3);
    const FlgPart part = make_part(workshop, line);
    const FlgPartView view = part_view(workshop, part);
    const FlgPartMeshView body = body_of(workshop, part);
    const std::vector<FlgAxisSample> samples = axis_of(view);
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
    FlgBoneThresholds thresholds = {.struct_size = sizeof(FlgBoneThresholds),
                                    .simplify = 0.5f,
                                    .merge = 0.0f,
                                    .prune = 0.0f,
                                    .collapse = 0.0f,
                                    .detail = 0};
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
    entitle(panels, {"Axis and slices", "Step 1", "Step 2", "Step 3", "Slices side by side", "as bones see them"});
    studio.take("skeleton_bounded_dp", panels, 4, kWidth, 284);
}

// Douglas-Peucker: marks the places between two that lie further than this off the straight line, the furthest first.
void simplify(const Line& axis, size_t first, size_t last, double threshold, std::vector<bool>& kept) {
    const glm::dvec2 along = glm::normalize(axis[last] - axis[first]);
    size_t furthest = first;
    double most = threshold;
    for (size_t i = first + 1; i < last; ++i) {
        const glm::dvec2 from = axis[i] - axis[first];
        const double off = std::abs(along.x * from.y - along.y * from.x);
        if (off > most) most = off, furthest = i;
    }
    kept[first] = kept[last] = true;
    if (furthest == first) return;
    simplify(axis, first, furthest, threshold, kept);
    simplify(axis, furthest, last, threshold, kept);
}

// How far slices are from straight lines between those that are kept, at most, metres.
double max_off(const std::vector<FlgAxisSample>& samples, const std::vector<bool>& kept) {
    double most = 0.0;
    size_t from = 0;
    for (size_t to = 1; to < kept.size(); ++to) {
        if (!kept[to]) continue;
        for (size_t i = from; i <= to; ++i) {
            const double t = static_cast<double>(i - from) / static_cast<double>(to - from);
            most = std::max({most, std::abs(samples[i].left - glm::mix(samples[from].left, samples[to].left, t)),
                             std::abs(samples[i].right - glm::mix(samples[from].right, samples[to].right, t))});
        }
        from = to;
    }
    return most;
}

// Fig. 5: as many joints by the axis alone, and by axis and shape. What bones make of the shape is red.
void over_simplification(Workshop& workshop, Studio& studio) {
    constexpr double kUnit = 0.035;
    constexpr float kThreshold = 0.006f;  // of the part's size
    const Line line = limb(0.15);
    const FlgPart part = make_part(workshop, line);
    const std::vector<FlgAxisSample> samples = axis_of(part_view(workshop, part));
    const FlgPartMeshView body = body_of(workshop, part);
    const FlgModelView model = make_model(workshop, {&part, 1},
                                          {.struct_size = sizeof(FlgBoneThresholds),
                                           .simplify = kThreshold,
                                           .merge = 0.0f,
                                           .prune = 0.0f,
                                           .collapse = 0.0f,
                                           .detail = 0});
    Line axis;
    for (const FlgAxisSample& s : samples) axis.push_back(sample_at(s));
    std::vector<bool> by_axis, by_shape(axis.size());
    for (size_t j = 0; j < model.joint_count; ++j) {
        const auto nearer = [&](const glm::dvec2& a, const glm::dvec2& b) {
            return glm::distance(a, joint_at(model, j)) < glm::distance(b, joint_at(model, j));
        };
        by_shape[static_cast<size_t>(std::min_element(axis.begin(), axis.end(), nearer) - axis.begin())] = true;
    }
    const auto joints_of = [](const std::vector<bool>& kept) { return std::count(kept.begin(), kept.end(), true); };
    for (double threshold = 0.002; by_axis.empty() || joints_of(by_axis) > joints_of(by_shape); threshold *= 1.05) {
        by_axis.assign(axis.size(), false);
        simplify(axis, 0, axis.size() - 1, threshold, by_axis);
    }
    std::deque<Sketch> sketches;
    std::vector<Panel> panels;
    for (const std::vector<bool>& kept : {by_axis, by_shape}) {
        Sketch& sketch = sketches.emplace_back(workshop, kUnit);
        sketch.fill(body, kPaper);
        sketch.ring(line, kInk, 1.6);
        Line joints, left, right;
        for (size_t i = 0; i < kept.size(); ++i) {
            if (!kept[i]) continue;
            const glm::dvec2 aside(samples[i].left_x, samples[i].left_y);
            joints.push_back(axis[i]);
            left.push_back(axis[i] + samples[i].left * aside), right.push_back(axis[i] - samples[i].right * aside);
        }
        for (size_t i = 0; i < joints.size(); ++i) sketch.line({left[i], right[i]}, kRed, 1.2);
        sketch.line(left, kRed, 2.2), sketch.line(right, kRed, 2.2);
        sketch.line(joints, kInk, 2.6);
        sketch.dots(joints, kTeal, 6.5);
        Panel& panel = panels.emplace_back(sketch.panel());
        char words[120];
        std::snprintf(words, sizeof words, "%s: %zu joints, off the shape by up to %.1f %% of its length",
                      panels.size() == 1 ? "Douglas-Peucker on the axis alone" : "BoundedDP, on axis and shape",
                      joints.size(), 100.0 * max_off(samples, kept) / glm::distance(axis.front(), axis.back()));
        panel.title = words;
    }
    panels[0].keys = {{kInk, "drawn shape and bones"}, {kRed, "the shape that the bones stand for"}};
    aim_together(panels);
    for (Panel& panel : panels) panel.aim.emplace_back(4.0f, 1.9f, 0.0f);  // room for the keys
    studio.take("skeleton_over_simplification", panels, 1, kWidth, 480);
}

// Fig. 8: to the line where the joint is beside the bone, to the nearer end where it is beyond.
void distance(Workshop& workshop, Studio& studio) {
    constexpr double kUnit = 0.016;
    constexpr glm::vec3 kBone = {0.20f, 0.03f, 0.30f};
    const glm::dvec2 begin(-0.75, 0.0), end(0.75, 0.0);
    std::deque<Sketch> sketches;
    std::vector<Panel> panels;
    for (const glm::dvec2 child : {glm::dvec2(0.2, 0.62), glm::dvec2(1.35, 0.5)}) {
        const bool beside = child.x < end.x;
        const glm::dvec2 nearest(std::clamp(child.x, begin.x, end.x), 0.0);
        Sketch& sketch = sketches.emplace_back(workshop, kUnit);
        std::vector<Line> hatch;
        for (int i = 0; i <= 30; ++i) {
            const double x = glm::mix(begin.x, end.x, i / 30.0);
            hatch.push_back({{x, -0.35}, {x, 0.85}});
        }
        sketch.lines(hatch, {0.55f, 0.52f, 0.60f}, 0.6);
        sketch.lines(std::vector<Line>{{{begin.x, -0.35}, {begin.x, 0.85}}, {{end.x, -0.35}, {end.x, 0.85}}}, kGrey,
                     1.4);
        sketch.lines(std::vector<Line>{{begin, child}, {end, child}}, kGrey, 1.2);
        sketch.line({begin, end}, kBone, 4.0);
        sketch.line({nearest, child}, kRed, 2.6);
        sketch.dots(Line{begin, end}, kBone, 7.0);
        sketch.dots(Line{child}, kGold, 8.0);
        Panel& panel = panels.emplace_back(sketch.panel());
        panel.title =
            beside ? "Beside the bone: to its line, |v\u1d62v\u2096| sin \u03b8" : "Beyond the bone: to its nearer end";
        const auto name = [&](const glm::dvec2& at, const char* text, glm::vec2 by, glm::vec3 color) {
            panel.notes.push_back({glm::vec3(at, 0.0f), text, by, color, 18.0f});
        };
        name(begin, "v\u1d62", {-4.0f, 22.0f}, kBone);
        name(end, "v\u2c7c", {4.0f, 22.0f}, kBone);
        name(child, "v\u2096", {14.0f, -16.0f}, kInk);
        name(0.5 * (child + nearest), "d", {beside ? 14.0f : 20.0f, 6.0f}, kRed);
        if (beside) name(begin, "\u03b8", {38.0f, -12.0f}, kInk);
        panel.aim = {{-0.95f, -0.42f, 0.0f}, {1.6f, 1.20f, 0.0f}};
    }
    panels[0].keys = {{kBone, "bone of the parent part"}, {kGold, "joint of the new part"}};
    studio.take("skeleton_distance", panels, 2, kWidth, 320);
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
    constexpr FlgBoneThresholds kKeepAll = {.struct_size = sizeof(FlgBoneThresholds),
                                            .simplify = 0.01f,
                                            .merge = 0.0f,
                                            .prune = 0.0f,
                                            .collapse = 0.0f,
                                            .detail = 0};
    const Line torso = strip({-2.4, 0.0}, {2.2, 0.3}, 1.0);
    std::deque<Sketch> sketches;
    std::vector<Panel> panels;
    for (const FlgPartEvent event : {FLG_PART_EVENT_BONE_SPLIT, FLG_PART_EVENT_JOINT_CONNECT}) {
        const double x = event == FLG_PART_EVENT_BONE_SPLIT ? 0.3 : 2.65;
        const Line leg = strip({x, -0.25}, {x + 0.35, -2.9}, 0.42);
        const FlgPart parts[] = {make_part(workshop, torso), make_part(workshop, leg)};
        const FlgModelView model = make_model(workshop, parts, kKeepAll);
        if (model.part_events[1] != event) throw std::runtime_error("connection: another event than the picture's");
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
    entitle(panels, {"Bone split: beside a bone", "Joint connect: beyond its end"});
    studio.take("skeleton_connection", panels, 2, kWidth, 360);
}

constexpr Picture kPictures[] = {
    {"skeleton_bounded_dp", "Fig. 7: BoundedDP's first three steps, for the axis and for the slices", true, bounded_dp},
    {"skeleton_over_simplification", "Fig. 5: as many joints by the axis alone, and by axis and shape", true,
     over_simplification},
    {"skeleton_distance", "Fig. 8: how far a joint is from a bone, beside it and beyond", true, distance},
    {"skeleton_connection", "Fig. 9: bone split and joint connect", true, connection},
};

}  // namespace

std::span<const Picture> bone_pictures() {
    return kPictures;
}

}  // namespace flg::gallery
