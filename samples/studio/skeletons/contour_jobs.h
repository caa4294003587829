// SPDX-License-Identifier: MIT
// Contours that jobs make: of one that crosses itself a simple one, and of a mesh its silhouette.
#pragma once

#include <functional>
#include <list>

#include "filigree/filigree.hpp"
#include "filigree/filigree_model.h"
#include "shell/jobs.h"
#include "skeletons/drawing.h"

namespace flg::studio {

class ContourJobs {
public:
    ContourJobs(filigree::Context& context, Jobs& jobs) : context_(context), jobs_(jobs) {}

    // What ring 0 winds around, its largest piece; the job says it if nothing is left.
    void repair(const ContourPtr& contour, std::function<void(ContourPtr)> done);
    // What is seen of a surface by who looks along -z, and where it is.
    void trace(const filigree::Surface& surface, std::function<void(ContourPtr, const std::array<double, 12>&)> done);

    // Once a frame: calls `done` for what is ready.
    void update();
    void clear() { repairs_.clear(), outlines_.clear(); }
    bool busy() const { return !repairs_.empty() || !outlines_.empty(); }

private:
    using OutlineOwner = filigree::detail::Owner<FlgOutline, flgOutlineRelease>;
    struct Repair {
        filigree::StraightSkeleton skeleton;
        std::function<void(ContourPtr)> done;
    };
    struct Outline {
        OutlineOwner outline;
        std::function<void(ContourPtr, const std::array<double, 12>&)> done;
    };
    filigree::Context& context_;
    Jobs& jobs_;
    std::list<Repair> repairs_;
    std::list<Outline> outlines_;
};

}  // namespace flg::studio
