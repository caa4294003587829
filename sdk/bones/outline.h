// SPDX-License-Identifier: MIT
// Outlines as hosts hold them, and the job that makes them: what a mesh, or some of its regions, covers when it is
// looked at from afar is a drawing for parts that nobody drew.
#pragma once

#include <vector>

#include "filigree/filigree_model.h"
#include "runtime/pace.h"
#include "runtime/product.h"
#include "runtime/task.h"
#include "skeletons/contour.h"
#include "surfaces/surface.h"

namespace flg {

// Where an outline is in space: (x, y) of it is at origin + x right + y up. It looks against `right` x `up`.
struct OutlinePlane {
    Vec3 origin = Vec3::Zero(), right = Vec3::UnitX(), up = Vec3::UnitY(), towards = Vec3::UnitZ();
};

class HeldOutline final : public Product {
public:
    explicit HeldOutline(Memory* memory) : regions(memory), contour(memory) {}

    std::shared_ptr<Surface> surface;
    std::pmr::vector<bool> regions;  // by label whether it counts, missing ones do not; none: all
    // From where it is looked at; of no length: from where the triangles together look to.
    Vec3 towards = Vec3::Zero();

    Contour contour;
    OutlinePlane plane;

    void warn(const Host& host) const noexcept override {
        host.warn("outline", handle, "is not all that is seen", {{contour.pieces_left_out, "smaller pieces left out"}});
    }
    const FlgOutlineView& view() const { return view_; }

private:
    void show() noexcept override;

    FlgContourView view_contour_{};
    FlgOutlineView view_{};
};

// The whole of flgOutlineCreate. Throws if there are no triangles, or none that is seen.
Task<void> make_outline(Pace& pace, std::shared_ptr<HeldOutline> outline);

}  // namespace flg
