// SPDX-License-Identifier: MIT
// Skeletons: made, shown, released.
#include <algorithm>
#include <cmath>

#include "api/contour_inputs.h"
#include "api/descriptors.h"
#include "api/inputs.h"
#include "skeletons/offset_polygons.h"
#include "skeletons/skeleton_jobs.h"

namespace flg {

namespace {

FlgStraightSkeletonDesc default_straight_skeleton_desc() {
    auto desc = sized<FlgStraightSkeletonDesc>();
    return desc;
}

// The counts, and the arrays there are if there is room.
void write_offset(const OffsetRings& rings, FlgOffsetPolygons& out) {
    out.point_count = static_cast<uint32_t>(rings.points.size());
    out.ring_count = static_cast<uint32_t>(rings.offsets.size()) - 1;
    if (out.point_count > out.point_capacity || out.ring_count > out.ring_capacity) return;
    for (size_t i = 0; out.points && i < rings.points.size(); ++i) {
        out.points[2 * i] = rings.points[i].x;
        out.points[2 * i + 1] = rings.points[i].y;
    }
    if (out.edges) std::copy(rings.edges.begin(), rings.edges.end(), out.edges);
    if (out.ring_offsets) std::copy(rings.offsets.begin(), rings.offsets.end(), out.ring_offsets);
}

}  // namespace

}  // namespace flg

using namespace flg;

extern "C" {

FlgResult flgContourViewInit(FlgContourView* view, uint32_t struct_size) {
    return init(view, struct_size, default_contour_view(), "view");
}

FlgResult flgStraightSkeletonDescInit(FlgStraightSkeletonDesc* desc, uint32_t struct_size) {
    return init(desc, struct_size, default_straight_skeleton_desc());
}

FlgResult flgStraightSkeletonCreate(FlgContext context, const FlgStraightSkeletonDesc* desc,
                                    FlgStraightSkeleton* out_skeleton, FlgJob* out_job) {
    return guarded([&] {
        Context& self = clear_outputs(context, out_skeleton, "out_skeleton", out_job);
        Memory* const memory = self.memory[MemoryKind::models];
        const FlgStraightSkeletonDesc read = read_struct(desc, default_straight_skeleton_desc(), "desc");
        Submission submission(self, read.job);
        const bool repair = read.repair != 0;
        const auto out = self.make(self.straight_skeletons, read_contour(read.contour, memory, repair));
        out->change.input = read.contour->point_count;
        submission.job().strand.start(make_straight_skeleton(submission.pace(), out, repair));
        *out_skeleton = {submission.commit(self.straight_skeletons, out, out_job)};
    });
}

FlgResult flgStraightSkeletonViewInit(FlgStraightSkeletonView* view, uint32_t struct_size) {
    return init_view(view, struct_size);
}

FlgResult flgStraightSkeletonGetView(FlgContext context, FlgStraightSkeleton skeleton,
                                     FlgStraightSkeletonView* out_view) {
    return get_view(out_view, [&] { return get_context(context).straight_skeletons.get(skeleton.id, "skeleton"); });
}

FlgResult flgOffsetPolygonsInit(FlgOffsetPolygons* polygons, uint32_t struct_size) {
    return init(polygons, struct_size, sized<FlgOffsetPolygons>(), "polygons");
}

FlgResult flgStraightSkeletonOffset(FlgContext context, FlgStraightSkeleton skeleton, double distance,
                                    FlgOffsetPolygons* polygons) {
    return guarded([&] {
        FlgOffsetPolygons out = read_struct(polygons, sized<FlgOffsetPolygons>(), "polygons");
        out.point_count = out.ring_count = 0;
        write_struct(polygons, out, "polygons");
        Context& self = get_context(context);
        Memory* const memory = self.memory[MemoryKind::models];
        const HeldStraightSkeleton& held = *self.straight_skeletons.get(skeleton.id, "skeleton");
        const FlgResult result = visible_result_now(held);
        if (result != FLG_OK) return result;
        check_range(distance >= 0 && std::isfinite(distance), "distance", distance, "finite and at least 0");
        OffsetRings rings(memory);
        offset_polygons(held.skeleton, distance, rings, memory);
        write_offset(rings, out);
        write_struct(polygons, out, "polygons");
        return FLG_OK;
    });
}

FlgResult flgStraightSkeletonRelease(FlgContext context, FlgStraightSkeleton skeleton) {
    return release(context, &Context::straight_skeletons, skeleton, "skeleton");
}

}  // extern "C"
