// SPDX-License-Identifier: MIT
#include "gallery/drawn_shapes.h"

#include <cmath>

namespace flg::gallery {

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
    workshop.context().run();
    FlgPartView view = flgPartViewDefaults();
    filigree::check(flgPartGetView(workshop.context().get(), part, &view));
    return view;
}

FlgPart make_part(Workshop& workshop, const Line& line) {
    FlgPartDesc desc = flgPartDefaults();
    const FlgContourView drawn = contour_of(line);
    desc.contour = &drawn;
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
    desc.thresholds = &thresholds;
    FlgModel model = {};
    filigree::check(flgModelCreate(workshop.context().get(), &desc, &model, nullptr));
    workshop.context().run();
    FlgModelView view = flgModelViewDefaults();
    filigree::check(flgModelGetView(workshop.context().get(), model, &view));
    return view;
}

FlgStraightSkeletonView straight_skeleton(Workshop& workshop, const FlgContourView& contour) {
    FlgStraightSkeletonDesc desc = flgStraightSkeletonDefaults();
    desc.contour = &contour;
    FlgStraightSkeleton skeleton = {};
    filigree::check(flgStraightSkeletonCreate(workshop.context().get(), &desc, &skeleton, nullptr));
    workshop.context().run();
    FlgStraightSkeletonView view = flgStraightSkeletonViewDefaults();
    filigree::check(flgStraightSkeletonGetView(workshop.context().get(), skeleton, &view));
    return view;
}

FlgPartMeshView body_of(Workshop& workshop, FlgPart part) {
    FlgPartMeshDesc desc = flgPartMeshDefaults();
    desc.part = part;
    FlgPartMesh mesh = {};
    filigree::check(flgPartMeshCreate(workshop.context().get(), &desc, &mesh, nullptr));
    workshop.context().run();
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

}  // namespace flg::gallery
