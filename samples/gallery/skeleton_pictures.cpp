// SPDX-License-Identifier: MIT
// From a drawn line to bones: pictures of the steps, as the paper has them (Ma et al. 2021), of shapes made here.
#include <algorithm>
#include <cmath>
#include <deque>

#include "gallery/drawn_shapes.h"
#include "gallery/pictures.h"

namespace flg::gallery {
namespace {

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
    const FlgModelView model = make_model(workshop, {&part, 1}, flgBoneThresholdsDefaults());
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
    entitle(panels, {"A drawn line", "Its outline", "Straight skeleton", "Inner arcs", "Branches", "Slices", "Bones",
                     "A body"});
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
    panels[0].keys = {{kTeal, "edges move inwards"}, {kGold, "an edge vanishes"}, {kRed, "a corner splits the front"}};
    for (Panel& panel : panels) panel.aim = {{-3.3f, -2.1f, 0.0f}, {3.4f, 2.9f, 0.0f}};
    studio.take("skeleton_events", panels, 2, kWidth, 330);
}

// ---- Fig. 3

// The border of a repaired contour, ring by ring as nodes of its skeleton come.
Line repaired(Workshop& workshop, const Line& line) {
    FlgStraightSkeletonDesc desc = flgStraightSkeletonDefaults();
    const FlgContourView drawn = contour_of(line);
    desc.contour = &drawn;
    desc.repair = 1;
    FlgStraightSkeleton skeleton = {};
    filigree::check(flgStraightSkeletonCreate(workshop.context().get(), &desc, &skeleton, nullptr));
    workshop.context().run();
    FlgStraightSkeletonView view = flgStraightSkeletonViewDefaults();
    filigree::check(flgStraightSkeletonGetView(workshop.context().get(), skeleton, &view));
    Line border;
    for (uint32_t i = 0; i < view.contour_count; ++i) border.emplace_back(view.nodes[3 * i], view.nodes[3 * i + 1]);
    return border;
}

void polygons(Workshop& workshop, Studio& studio) {
    constexpr double kUnit = 0.03;
    const Line simple = {{-1.6, -0.9}, {-0.6, -1.2}, {0.1, -0.5}, {0.9, -1.25}, {1.7, -0.6}, {1.3, 0.2},
                         {1.7, 1.0},   {0.5, 1.2},   {0.1, 0.6},  {-0.9, 1.2},  {-1.8, 0.5}, {-1.1, 0.0}},
               crossing = {{-1.7, -0.8}, {-0.5, -1.2}, {0.6, -0.7}, {1.6, 0.9},  {0.9, 1.25}, {0.7, 0.3},
                           {1.75, -0.9}, {1.1, -1.2},  {0.1, 0.3},  {-0.5, 1.1}, {-1.6, 0.9}, {-1.2, 0.1}};
    const Line mended = repaired(workshop, crossing);
    const struct {
        const Line& line;
        glm::vec3 color;
        const char* title;
    } kShapes[] = {{simple, kTeal, "Simple: no side meets another"},
                   {crossing, kRed, "Not simple: sides cross"},
                   {mended, kTeal, "Repaired: simple again"}};
    std::deque<Sketch> sketches;
    std::vector<Panel> panels;
    for (const auto& shape : kShapes) {
        Sketch& sketch = sketches.emplace_back(workshop, kUnit);
        if (shape.color == kTeal) sketch.fill(body_of(workshop, make_part(workshop, shape.line)), kPaper);
        sketch.ring(shape.line, kInk, 2.2);
        sketch.dots(shape.line, shape.color, 5.5);
        panels.push_back(sketch.panel());
        panels.back().title = shape.title;
        panels.back().aim = {{-1.85f, -1.35f, 0.0f}, {1.85f, 1.35f, 0.0f}};
    }
    studio.take("skeleton_polygon", panels, 3, kWidth, 290);
}

// ---- Fig. 6

void anatomy(Workshop& workshop, Studio& studio) {
    constexpr double kUnit = 0.03;
    constexpr glm::vec3 kBlue = {0.012f, 0.085f, 0.42f};
    const Line shape = {{-3.4, -0.3}, {-2.6, -1.0}, {-1.0, -1.2}, {0.4, -0.9}, {1.5, -1.7}, {2.5, -2.0},
                        {2.9, -1.5},  {2.1, -0.7},  {1.9, 0.0},   {3.2, 0.7},  {3.3, 1.4},  {2.4, 1.5},
                        {1.0, 0.9},   {-0.6, 1.3},  {-1.6, 2.0},  {-2.3, 1.9}, {-2.2, 1.1}, {-3.2, 0.5}};
    const FlgStraightSkeletonView skeleton = straight_skeleton(workshop, contour_of(shape));
    std::vector<Line> outer, inner;
    for (size_t a = 0; a < skeleton.arc_count; ++a) {
        const uint32_t from = skeleton.arcs[4 * a], to = skeleton.arcs[4 * a + 1];
        const double *p = skeleton.nodes + 3 * from, *q = skeleton.nodes + 3 * to;
        (from < skeleton.contour_count ? outer : inner).push_back({{p[0], p[1]}, {q[0], q[1]}});
    }
    Line border, within;
    for (size_t n = 0; n < skeleton.node_count; ++n) {
        (n < skeleton.contour_count ? border : within).emplace_back(skeleton.nodes[3 * n], skeleton.nodes[3 * n + 1]);
    }
    Sketch sketch(workshop, kUnit);
    sketch.ring(shape, kInk, 2.4);
    sketch.lines(outer, kLeaf, 1.8);
    sketch.lines(inner, kRed, 3.0);
    sketch.dots(border, kRed, 6.0);
    sketch.dots(within, kBlue, 6.0);
    Panel panel = sketch.panel();
    panel.title = "The parts of a straight skeleton";
    panel.keys = {{kRed, "vertices of the border; edges of the skeleton"},
                  {kBlue, "vertices of the skeleton"},
                  {kInk, "edges of the border"},
                  {kLeaf, "edges between them, left out of the bones"}};
    panel.aim = {{-5.2f, -2.2f, 0.0f}, {3.5f, 2.6f, 0.0f}};
    studio.take("skeleton_anatomy", {&panel, 1}, 1, kWidth, 420);
}

constexpr Picture kPictures[] = {
    {"skeleton_steps", "Fig. 2: from a drawn line to bones, and to a body", true, steps_to_bones},
    {"skeleton_polygon", "Fig. 3: a simple polygon, one that isn't, and what repair makes of it", true, polygons},
    {"skeleton_anatomy", "Fig. 6: vertices and edges of a straight skeleton", true, anatomy},
    {"skeleton_events", "Fig. 4: the straight skeletons of two polygons, with the front at several times", true,
     events},
};

}  // namespace

std::span<const Picture> skeleton_pictures() {
    return kPictures;
}

}  // namespace flg::gallery
