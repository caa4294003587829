// SPDX-License-Identifier: MIT
#include "skeletons/skeleton_jobs.h"

#include "skeletons/contour_repair.h"
#include "skeletons/straight_skeleton.h"

namespace flg {

namespace {

// Hosts see nodes and arcs as plain numbers.
static_assert(sizeof(SkeletonNode) == 3 * sizeof(double) && sizeof(SkeletonArc) == 4 * sizeof(uint32_t));

}  // namespace

void HeldStraightSkeleton::show() noexcept {
    view_ = {.struct_size = sizeof view_,
             .contour_count = contour.size(),
             .node_count = static_cast<uint32_t>(skeleton.nodes.size()),
             .arc_count = static_cast<uint32_t>(skeleton.arcs.size()),
             .nodes = &skeleton.nodes.data()->at.x,
             .arcs = &skeleton.arcs.data()->a,
             .face_offsets = skeleton.face_offsets.data(),
             .face_nodes = skeleton.face_nodes.data(),
             .input_points = contour.input_points.data(),
             .residual = skeleton.residual,
             .perturbation = skeleton.perturbation};
}

Task<void> make_straight_skeleton(Pace& pace, std::shared_ptr<HeldStraightSkeleton> out, bool repair) {
    if (repair) {
        pace.stage("contour_repair");
        out->contour = co_await repair_contour(pace, out->contour);
        co_await pace;
    }
    out->change = co_await find_change(pace, out->contour, out->change.input);
    pace.stage("straight_skeleton");
    co_await straight_skeleton(pace, out->contour, out->skeleton);
}

}  // namespace flg
