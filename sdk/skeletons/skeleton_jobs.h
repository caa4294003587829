// SPDX-License-Identifier: MIT
// Skeletons as hosts hold them, and the jobs that make them.
#pragma once

#include <memory>

#include "filigree/filigree_skeleton.h"
#include "runtime/pace.h"
#include "runtime/product.h"
#include "skeletons/contour.h"
#include "skeletons/contour_repair.h"
#include "skeletons/skeleton_graph.h"

namespace flg {

class HeldStraightSkeleton final : public Product {
public:
    HeldStraightSkeleton(Contour of_contour, Memory* memory) : contour(std::move(of_contour)), skeleton(memory) {}

    Contour contour;
    ContourChange change;  // of the contour; `input` is set before the job
    StraightSkeleton skeleton;

    void warn(const Host& host) const noexcept override { change.warn(host, "straight skeleton", handle); }

    const FlgStraightSkeletonView& view() const { return view_; }

private:
    void show() noexcept override;

    FlgStraightSkeletonView view_{};
};

// The whole of flgStraightSkeletonCreate. With `repair` the contour is from gather_contour, and made simple first.
Task<void> make_straight_skeleton(Pace& pace, std::shared_ptr<HeldStraightSkeleton> out, bool repair);

}  // namespace flg
