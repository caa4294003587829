// SPDX-License-Identifier: MIT
#include "bones/outline.h"

#include "skeletons/contour_repair.h"

namespace flg {
namespace {

constexpr uint32_t chunk = 200, repair_chunk = 20;  // about 10 us

}  // namespace

void HeldOutline::show() noexcept {
    view_ = {};
    view_.struct_size = sizeof view_;
    view_.contour = {.struct_size = sizeof view_.contour,
                     .point_count = contour.size(),
                     .points = &contour.points.data()->x,
                     .ring_offsets = contour.offsets.data(),
                     .ring_count = contour.ring_count(),
                     .reserved = 0};
    for (int row = 0; row < 3; ++row) {
        view_.placement[4 * row] = plane.right[row];
        view_.placement[4 * row + 1] = plane.up[row];
        view_.placement[4 * row + 2] = plane.towards[row];
        view_.placement[4 * row + 3] = plane.origin[row];
    }
}

Task<void> make_outline(Pace& pace, std::shared_ptr<HeldOutline> outline) {
    pace.stage("outline");
    Contour borders(pace.memory());
    MeshOutlineKernel kernel(outline->surface->mesh(), outline->regions, outline->towards, outline->plane, borders,
                             pace.memory());
    while (!kernel.run(chunk)) co_await pace;
    ContourRepair repair(borders, pace.memory());
    while (!repair.run(repair_chunk)) co_await pace;
    outline->contour = repair.take_contour();
}

}  // namespace flg
