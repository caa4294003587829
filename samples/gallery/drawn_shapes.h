// SPDX-License-Identifier: MIT
// Contours for pictures, and what the SDK makes of them: parts, bodies, models, straight skeletons. All live as long
// as the workshop.
#pragma once

#include "filigree/filigree_model.h"
#include "gallery/sketch.h"

namespace flg::gallery {

constexpr glm::vec3 kPaper = {0.80f, 0.66f, 0.42f}, kShape = {0.34f, 0.52f, 0.56f};

// A closed Catmull-Rom curve, drawn by a hand that trembles.
Line drawn(const Line& corners, double tremor);
// Lives as long as the line.
FlgContourView contour_of(const Line& line);

FlgPart make_part(Workshop& workshop, const Line& line);
FlgPartView part_view(Workshop& workshop, FlgPart part);
FlgPartMeshView body_of(Workshop& workshop, FlgPart part);
// The parts as they were drawn.
FlgModelView make_model(Workshop& workshop, std::span<const FlgPart> parts, const FlgBoneThresholds& thresholds);
FlgStraightSkeletonView straight_skeleton(Workshop& workshop, const FlgContourView& contour);

glm::dvec2 joint_at(const FlgModelView& model, size_t joint);
glm::dvec2 sample_at(const FlgAxisSample& sample);
void draw_bones(Sketch& sketch, const FlgModelView& model, glm::vec3 color, glm::vec3 joint_color);

}  // namespace flg::gallery
