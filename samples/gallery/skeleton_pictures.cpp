// SPDX-License-Identifier: MIT
// From a drawn line to bones: pictures of the steps, as the paper has them (Ma et al. 2021), of shapes made here.
#include <algorithm>
#include <cmath>
#include <deque>
#include <iterator>
#include <numbers>
#include <stdexcept>

#include "filigree/filigree_model.h"
#include "gallery/pictures.h"
#include "gallery/sketch.h"

namespace flg::gallery {
namespace {

constexpr glm::vec3 kPaper = {0.80f, 0.66f, 0.42f}, kShape = {0.34f, 0.52f, 0.56f};

// A closed Catmull-Rom curve, drawn by a hand that trembles.
Line drawn(const Line& corners, double tremor) {
    constexpr int kSteps = 24;
    Line line;
    const size_t n = corners.size();
    for (size_t i = 0; i < n * kSteps; ++i) {
        const glm::dvec2 &a = corners[(i / kSteps + n - 1) % n], &b = corners[i / kSteps],
                         &c = corners[(i / kSteps + 1) % n], &d = corners[(i / kSteps + 2) % n];
        const double t = static_cast<double>(i % kSteps) / kSteps, w = static_cast<double>(i);
        const glm::dvec2 p =
            b + 0.5 * t * (c - a + t * (2.0 * a - 5.0 * b + 4.0 * c - d + t * (3.0 * (b - c) + d - a)));
        line.push_back(p + tremor * glm::dvec2(std::sin(0.61 * w) + std::sin(0.29 * w), std::cos(0.53 * w)));
    }
    return line;
}

FlgContourView contour_of(const Line& line) {
    FlgContourView contour = flgContourViewDefaults();
    contour.points = &line[0].x;
    contour.point_count = static_cast<uint32_t>(line.size());
    return contour;
}

FlgPartView part_view(Workshop& workshop, FlgPart part) {
    workshop.context().finish();
    FlgPartView view = flgPartViewDefaults();
    filigree::check(flgPartGetView(workshop.context().get(), part, &view));
    return view;
}

FlgPart make_part(Workshop& workshop, const Line& line) {
    FlgPartDesc desc = flgPartDefaults();
    desc.contour = contour_of(line);
    FlgPart part = {};
    filigree::check(flgPartCreate(workshop.context().get(), &desc, &part, nullptr));
    return part;
}

FlgModelView make_model(Workshop& workshop, std::span<const FlgPart> parts, const FlgBoneThresholds& thresholds) {
    std::vector<FlgModelPart> list;
    for (const FlgPart part : parts) list.push_back(flgModelPartDefaults()), list.back().part = part;
    FlgModelDesc desc = flgModelDefaults();
    desc.parts = list.data();
    desc.part_count = static_cast<uint32_t>(list.size());
    desc.thresholds = thresholds;
    FlgModel model = {};
    filigree::check(flgModelCreate(workshop.context().get(), &desc, &model, nullptr));
    workshop.context().finish();
    FlgModelView view = flgModelViewDefaults();
    filigree::check(flgModelGetView(workshop.context().get(), model, &view));
    return view;
}

FlgStraightSkeletonView straight_skeleton(Workshop& workshop, const FlgContourView& contour) {
    FlgStraightSkeletonDesc desc = flgStraightSkeletonDefaults();
    desc.contour = contour;
    FlgStraightSkeleton skeleton = {};
    filigree::check(flgStraightSkeletonCreate(workshop.context().get(), &desc, &skeleton, nullptr));
    workshop.context().finish();
    FlgStraightSkeletonView view = flgStraightSkeletonViewDefaults();
    filigree::check(flgStraightSkeletonGetView(workshop.context().get(), skeleton, &view));
    return view;
}

FlgPartMeshView body_of(Workshop& workshop, FlgPart part) {
    FlgPartMeshDesc desc = flgPartMeshDefaults();
    desc.part = part;
    FlgPartMesh mesh = {};
    filigree::check(flgPartMeshCreate(workshop.context().get(), &desc, &mesh, nullptr));
    workshop.context().finish();
    FlgPartMeshView view = flgPartMeshViewDefaults();
    filigree::check(flgPartMeshGetView(workshop.context().get(), mesh, &view));
    return view;
}

glm::dvec2 joint_at(const FlgModelView& model, size_t joint) {
    return {model.joint_positions[3 * joint], model.joint_positions[3 * joint + 1]};
}

void draw_bones(Sketch& sketch, const FlgModelView& model, glm::vec3 color, glm::vec3 joint_color) {
    std::vector<Line> bones;
    std::vector<glm::dvec2> joints;
    for (size_t j = 0; j < model.joint_count; ++j) {
        joints.push_back(joint_at(model, j));
        const uint32_t parent = model.joint_parents[j];
        if (parent != FLG_NO_INDEX) bones.push_back({joint_at(model, parent), joints.back()});
    }
    sketch.lines(bones, color, 2.4);
    sketch.dots(joints, joint_color, 6.0);
}

glm::dvec2 sample_at(const FlgAxisSample& s) {
    return {s.x, s.y};
}

// A gecko from above.
Line gecko() {
    const Line side = {{-0.62, 3.95}, {-0.78, 3.35}, {-0.42, 2.75}, {-0.72, 2.30}, {-1.70, 2.60}, {-2.15, 3.40},
                       {-2.70, 3.75}, {-2.85, 3.20}, {-2.40, 2.25}, {-1.70, 1.80}, {-0.85, 1.60}, {-0.90, 0.70},
                       {-0.75, 0.05}, {-1.60, 0.35}, {-2.60, -0.2}, {-2.90, -1.3}, {-2.65, -1.9}, {-2.20, -1.5},
                       {-2.05, -0.7}, {-1.40, -0.5}, {-0.75, -0.75}};
    const Line tail = {{-0.50, -1.5}, {-0.42, -2.4}, {0.10, -3.4}, {0.90, -3.95}, {1.85, -3.85},
                       {1.90, -3.6},  {1.15, -3.4},  {0.62, -2.9}, {0.42, -2.2},  {0.50, -1.5}};
    Line all = {{0.0, 4.35}};
    all.insert(all.end(), side.begin(), side.end());
    all.insert(all.end(), tail.begin(), tail.end());
    for (size_t i = side.size(); i-- > 0;) all.emplace_back(-side[i].x, side[i].y);
    for (glm::dvec2& p : all) p.x += 0.22 * std::sin(0.9 * p.y);
    return all;
}

// Fig. 2, and the body that comes of it.
void steps_to_bones(Workshop& workshop, Studio& studio) {
    constexpr double kUnit = 0.05;
    constexpr size_t kSliceEvery = 3;
    const Line line = drawn(gecko(), 0.012);
    const FlgPart part = make_part(workshop, line);
    const FlgPartView view = part_view(workshop, part);
    Line outline;
    for (size_t i = 0; i < view.outline_count; ++i) outline.emplace_back(view.outline[2 * i], view.outline[2 * i + 1]);
    const FlgStraightSkeletonView skeleton = straight_skeleton(workshop, contour_of(outline));
    const FlgModelView model = make_model(workshop, {&part, 1}, flgModelDefaults().thresholds);
    const FlgPartMeshView body = body_of(workshop, part);
    std::vector<Line> arcs, axis, branches, slices;
    for (size_t a = 0; a < skeleton.arc_count; ++a) {
        const double *from = skeleton.nodes + 3 * skeleton.arcs[4 * a],
                     *to = skeleton.nodes + 3 * skeleton.arcs[4 * a + 1];
        arcs.push_back({{from[0], from[1]}, {to[0], to[1]}});
    }
    for (size_t a = 0; a + 1 < view.node_count; ++a) {
        const double *from = view.nodes + 3 * view.arcs[2 * a], *to = view.nodes + 3 * view.arcs[2 * a + 1];
        axis.push_back({{from[0], from[1]}, {to[0], to[1]}});
    }
    for (size_t b = 0; b < view.branch_count; ++b) {
        Line& branch = branches.emplace_back();
        for (size_t i = view.branches[4 * b + 2]; i < view.branches[4 * b + 3]; ++i) {
            const FlgAxisSample& s = view.samples[i];
            const glm::dvec2 left(s.left_x, s.left_y);
            branch.push_back(sample_at(s));
            if (branch.size() % kSliceEvery == 0)
                slices.push_back({branch.back() + s.left * left, branch.back() - s.right * left});
        }
    }
    std::deque<Sketch> sketches;
    for (int step = 0; step < 8; ++step) {
        Sketch& sketch = sketches.emplace_back(workshop, kUnit);
        if (step == 7) {
            sketch.stand(body, kShape);
        } else {
            if (step > 0) sketch.fill(body, kPaper);
            sketch.ring(step == 0 ? line : outline, kInk, step < 2 ? 2.2 : 1.4);
        }
        if (step == 1) sketch.dots(outline, kRed, 4.4);
        if (step == 2) sketch.lines(arcs, kRed, 1.6);
        if (step == 3) sketch.lines(axis, kRed, 2.2);
        if (step == 5) sketch.lines(slices, kTeal, 1.4);
        if (step == 4 || step == 5) sketch.lines(branches, kRed, 2.6);
        if (step >= 6) draw_bones(sketch, model, kInk, kRed);
    }
    std::vector<Panel> panels;
    for (const Sketch& sketch : sketches) panels.push_back(sketch.panel());
    studio.take("skeleton_steps", panels, 4, kWidth, 700);
}

// What is left of a polygon whose edges moved inwards for this long: a piece of it in each face.
std::vector<Line> offset_lines(const FlgStraightSkeletonView& skeleton, double time) {
    std::vector<Line> lines;
    for (size_t face = 0; face < skeleton.contour_count; ++face) {
        const uint32_t first = skeleton.face_offsets[face], count = skeleton.face_offsets[face + 1] - first;
        const auto node = [&](uint32_t i) { return skeleton.nodes + 3 * skeleton.face_nodes[first + i % count]; };
        const glm::dvec2 along(node(1)[0] - node(0)[0], node(1)[1] - node(0)[1]);
        Line crossings;
        for (uint32_t i = 0; i < count; ++i) {
            const double *a = node(i), *b = node(i + 1);
            if ((a[2] < time) == (b[2] < time)) continue;
            const double t = (time - a[2]) / (b[2] - a[2]);
            crossings.emplace_back(a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]));
        }
        std::sort(crossings.begin(), crossings.end(),
                  [&](const glm::dvec2& a, const glm::dvec2& b) { return glm::dot(a, along) < glm::dot(b, along); });
        for (size_t i = 0; i + 1 < crossings.size(); i += 2) lines.push_back({crossings[i], crossings[i + 1]});
    }
    return lines;
}

// Fig. 4: the front at several times, what its corners draw, and where edges vanish (gold) or it is split (red).
void events(Workshop& workshop, Studio& studio) {
    constexpr double kUnit = 0.035;
    constexpr int kFronts = 9;
    const Line shapes[] = {
        {{-3.0, -1.6}, {-0.9, -1.9}, {0.15, -0.35}, {1.2, -1.9}, {3.2, -1.5}, {2.9, 1.3}, {1.5, 1.75}, {-2.4, 1.55}},
        {{-2.9, 1.2},
         {-2.6, -1.9},
         {-1.3, -1.6},
         {-0.9, 0.25},
         {0.5, -0.1},
         {0.7, -1.8},
         {2.9, -1.9},
         {2.6, 0.2},
         {3.0, 1.7},
         {0.3, 1.45},
         {-0.4, 1.9}}};
    std::deque<Sketch> sketches;
    std::vector<Panel> panels;
    for (const Line& shape : shapes) {
        const FlgStraightSkeletonView skeleton = straight_skeleton(workshop, contour_of(shape));
        Sketch& sketch = sketches.emplace_back(workshop, kUnit);
        double latest = 0.0;
        std::vector<uint32_t> before(skeleton.node_count), after(skeleton.node_count);
        std::vector<Line> arcs;
        for (size_t a = 0; a < skeleton.arc_count; ++a) {
            const uint32_t from = skeleton.arcs[4 * a], to = skeleton.arcs[4 * a + 1];
            const double *p = skeleton.nodes + 3 * from, *q = skeleton.nodes + 3 * to;
            ++after[from], ++before[to];
            latest = std::max(latest, q[2]);
            arcs.push_back({{p[0], p[1]}, {q[0], q[1]}});
        }
        Line vanished, split;
        for (size_t n = skeleton.contour_count; n < skeleton.node_count; ++n) {
            (after[n] > 1 ? split : vanished).emplace_back(skeleton.nodes[3 * n], skeleton.nodes[3 * n + 1]);
        }
        for (int i = 1; i < kFronts; ++i) sketch.lines(offset_lines(skeleton, latest * i / kFronts), kTeal, 1.2);
        sketch.ring(shape, kInk, 2.4);
        sketch.lines(arcs, kInk, 1.6);
        sketch.dots(vanished, kGold, 5.5);
        sketch.dots(split, kRed, 6.5);
        panels.push_back(sketch.panel());
    }
    studio.take("skeleton_events", panels, 2, kWidth, 330);
}

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
    constexpr int kSteps = 16;
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
    {"skeleton_steps", "Fig. 2: from a drawn line to bones, and to a body", true, steps_to_bones},
    {"skeleton_events", "Fig. 4: the straight skeletons of two polygons, with the front at several times", true,
     events},
    {"skeleton_bounded_dp", "Fig. 7: BoundedDP's first three steps, for the axis and for the slices", true, bounded_dp},
    {"skeleton_connection", "Fig. 9: bone split and joint connect", true, connection},
};

}  // namespace

std::span<const Picture> skeleton_pictures() {
    return kPictures;
}

}  // namespace flg::gallery
