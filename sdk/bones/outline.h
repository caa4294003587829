// SPDX-License-Identifier: MIT
// Outlines as hosts hold them, and the job that makes them.
#pragma once

#include "bones/mesh_outline.h"
#include "filigree/filigree_model.h"
#include "runtime/pace.h"
#include "runtime/product.h"
#include "runtime/task.h"
#include "surfaces/surface.h"

namespace flg {

class HeldOutline final : public Product {
public:
    explicit HeldOutline(Memory* memory) : regions(memory), contour(memory) {}

    std::shared_ptr<Surface> surface;
    std::pmr::vector<bool> regions;  // by label; none: all
    Vec3 towards = Vec3::Zero();

    Contour contour;
    OutlinePlane plane;

    const FlgOutlineView& view() const { return view_; }

private:
    void show() noexcept override;

    FlgOutlineView view_{};
};

// The whole of flgOutlineCreate.
Task<void> make_outline(Pace& pace, std::shared_ptr<HeldOutline> outline);

}  // namespace flg
