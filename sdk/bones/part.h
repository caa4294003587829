// SPDX-License-Identifier: MIT
// Drawn parts as hosts hold them, and the job that makes them.
#pragma once

#include <memory>
#include <optional>

#include "bones/axis.h"
#include "bones/contour_mirror.h"
#include "filigree/filigree_model.h"
#include "runtime/pace.h"
#include "runtime/product.h"
#include "runtime/task.h"
#include "skeletons/contour_repair.h"

namespace flg {

// Samples of the axis are so far apart where the line is taken as drawn; a share of its length.
inline constexpr double default_spacing = 0.005;

class HeldPart final : public Product {
public:
    HeldPart(Contour of_drawn, Memory* memory)
        : drawn(std::move(of_drawn)), even(memory), outline(memory), skeleton(memory) {}

    double spacing = 0, tolerance = 0;  // shares of the length
    bool repair = false;                // the drawn contour is from gather_contour, and made simple first
    double collapse = 0;                // a share of the mean arc's length
    Contour drawn;                      // cleaned
    ContourChange change;               // of the drawn contour; `input` is set before the job
    Contour even;                       // the same with points at equal distances, if that was asked for
    Contour outline;                    // what the axis was made of
    PartSkeleton skeleton;
    std::optional<MirrorAxis> mirror;  // of the drawn line; the skeleton is its own mirror image then
    double length = 0;                 // of ring 0, drawn, but three times the diagonal of its box at most
    double area = 0;                   // within the outline
    double widest = 0;                 // clearance of the axis
    Point2 centroid{};                 // of the area

    const Contour& line() const { return spacing > 0 ? even : drawn; }
    void warn(const Host& host) const noexcept override { change.warn(host, "part", handle); }
    const FlgPartView& view() const { return view_; }

private:
    void show() noexcept override;

    FlgPartView view_{};
};

// The whole of flgPartCreate.
Task<void> make_part(Pace& pace, std::shared_ptr<HeldPart> part);

}  // namespace flg
