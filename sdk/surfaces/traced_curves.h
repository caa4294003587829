// SPDX-License-Identifier: MIT
// Curves on a surface as hosts hold them.
#pragma once

#include "runtime/pace.h"
#include "runtime/task.h"
#include "surfaces/mesh/surface_curves.h"
#include "surfaces/surface.h"

namespace flg {

class TracedCurves final : public Product {
public:
    TracedCurves(const std::shared_ptr<Surface>& of_surface, Memory* memory)
        : TracedCurves(of_surface, of_surface->order.revision(), memory) {}
    // For jobs, which must not ask for the revision.
    TracedCurves(std::shared_ptr<Surface> of_surface, uint32_t of_revision, Memory* memory)
        : surface(std::move(of_surface)), revision(of_revision), curves(memory) {}

    std::shared_ptr<Surface> surface;
    uint32_t revision;
    SurfaceCurves curves;
    uint32_t left_out = 0;  // curves of the input that came to a single point

    // The same in flat arrays, for the host.
    struct Flat {
        Buffer<FlgSurfacePoint> points;
        Buffer<uint32_t> offsets;
        Buffer<uint8_t> flags;
        Buffer<float> values;
    } flat;

    const FlgSurfaceCurvesView& view() const { return view_; }
    void warn(const Host& host) const noexcept override {
        host.warn("surface curves", handle, "are not all", {{left_out, "curves left out that came to a single point"}});
    }

private:
    void show() noexcept override {
        view_ = {.struct_size = sizeof view_,
                 .curve_count = curves.curve_count(),
                 .curve_offsets = flat.offsets.data(),
                 .curve_flags = flat.flags.data(),
                 .curve_values = flat.values.data(),
                 .points = flat.points.data(),
                 .revision = revision,
                 .reserved = 0};
    }

    FlgSurfaceCurvesView view_{};
};

// Fills the flat arrays of curves that are complete.
Task<void> flatten_curves(Pace& pace, TracedCurves& traced);

}  // namespace flg
