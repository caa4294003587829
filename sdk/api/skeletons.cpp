// SPDX-License-Identifier: MIT
// Skeletons: made, shown, released.
#include "api/context.h"
#include "api/contour_inputs.h"
#include "api/descriptors.h"
#include "api/error.h"
#include "skeletons/skeleton_jobs.h"

namespace flg {

namespace {

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
