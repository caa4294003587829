// SPDX-License-Identifier: MIT
// Skeletons: made, shown, released.
#include "api/context.h"
#include "api/descriptors.h"
#include "api/error.h"
#include "api/inputs.h"
#include "skeletons/skeleton_jobs.h"

namespace flg {

namespace {

constexpr uint32_t most_points = 1u << 24;

FlgContourView default_contour_view() {
    FlgContourView view{};
    view.struct_size = sizeof view;
    view.ring_count = 1;
    return view;
}

FlgStraightSkeletonDesc default_straight_skeleton_desc() {
    FlgStraightSkeletonDesc desc{};
    desc.struct_size = sizeof desc;
    desc.job = default_job_options();
    desc.contour = default_contour_view();
    return desc;
}

FlgStraightSkeletonView default_straight_skeleton_view() {
    FlgStraightSkeletonView view{};
    view.struct_size = sizeof view;
    return view;
}

Contour read_contour(const FlgContourView& view, Memory* memory) {
    if (view.point_count > most_points)
        throw Failure(FLG_ERROR_LIMIT, "desc.contour.point_count is %u, at most %u", view.point_count, most_points);
    check_range(view.point_count >= 3, "desc.contour.point_count", view.point_count, "at least 3");
    check_range(view.ring_count >= 1 && view.ring_count <= view.point_count, "desc.contour.ring_count", view.ring_count,
                "at least 1, and at most the number of points");
    require(view.points, "desc.contour.points");
    if (!view.ring_offsets)
        check_range(view.ring_count == 1, "desc.contour.ring_count", view.ring_count, "1 without ring_offsets");
    std::pmr::vector<uint32_t> offsets({0, view.point_count}, memory);
    if (view.ring_offsets) offsets.assign(view.ring_offsets, view.ring_offsets + view.ring_count + 1);
    for (size_t r = 0; r < offsets.size(); ++r) {
        const bool is_end = r + 1 == offsets.size();
        if ((r == 0 && offsets[r] != 0) || (r > 0 && offsets[r] < offsets[r - 1]) || offsets[r] > view.point_count ||
            (is_end && offsets[r] != view.point_count))
            throw Failure(FLG_ERROR_INVALID_ARGUMENT,
                          "desc.contour.ring_offsets[%zu] is %u; offsets rise from 0 to point_count, %u", r, offsets[r],
                          view.point_count);
    }
    std::pmr::vector<Point2> points(memory);
    points.reserve(view.point_count);
    for (size_t i = 0; i < view.point_count; ++i) points.push_back({view.points[2 * i], view.points[2 * i + 1]});
    return clean_contour(points, offsets, memory);
}

}  // namespace

}  // namespace flg

using namespace flg;

extern "C" {

FlgResult flgContourViewInit(FlgContourView* view, uint32_t struct_size) {
    return guarded([&] {
        init_struct(view, struct_size, default_contour_view(), "view");
        return FLG_OK;
    });
}

FlgResult flgStraightSkeletonDescInit(FlgStraightSkeletonDesc* desc, uint32_t struct_size) {
    return guarded([&] {
        init_struct(desc, struct_size, default_straight_skeleton_desc(), "desc");
        return FLG_OK;
    });
}

FlgResult flgStraightSkeletonCreate(FlgContext context, const FlgStraightSkeletonDesc* desc,
                                    FlgStraightSkeleton* out_skeleton, FlgJob* out_job) {
    return guarded([&] {
        require(out_skeleton, "out_skeleton") = {};
        if (out_job) *out_job = {};
        Context& self = get_context(context);
        const FlgStraightSkeletonDesc read = read_struct(desc, default_straight_skeleton_desc(), "desc");
        check_struct_size<FlgContourView>(read.contour.struct_size, "desc.contour");
        Submission submission(self, read.job);
        const auto out =
            make_object<HeldStraightSkeleton>(self, read_contour(read.contour, &self.memory), &self.memory);
        submission.job().strand.start(make_straight_skeleton(submission.pace(), out));
        *out_skeleton = {submission.commit(self.straight_skeletons, out, out_job)};
        return FLG_OK;
    });
}

FlgResult flgStraightSkeletonViewInit(FlgStraightSkeletonView* view, uint32_t struct_size) {
    return guarded([&] {
        init_struct(view, struct_size, default_straight_skeleton_view(), "view");
        return FLG_OK;
    });
}

FlgResult flgStraightSkeletonGetView(FlgContext context, FlgStraightSkeleton skeleton,
                                     FlgStraightSkeletonView* out_view) {
    return guarded([&] {
        write_struct(out_view, default_straight_skeleton_view(), "out_view");
        const HeldStraightSkeleton& self = *get_context(context).straight_skeletons.get(skeleton.id, "skeleton");
        const FlgResult result = self.visible_result();
        if (result == FLG_OK) write_struct(out_view, self.view(), "out_view");
        return result < 0 ? set_last_error(result, self.error()) : result;
    });
}

FlgResult flgStraightSkeletonRelease(FlgContext context, FlgStraightSkeleton skeleton) {
    return guarded([&] {
        get_context(context).straight_skeletons.remove(skeleton.id, "skeleton");
        return FLG_OK;
    });
}

}  // extern "C"
