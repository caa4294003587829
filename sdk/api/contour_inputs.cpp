// SPDX-License-Identifier: MIT
#include "api/contour_inputs.h"

#include "api/descriptors.h"
#include "api/inputs.h"

namespace flg {
namespace {

constexpr uint32_t max_points = 1u << 24;

}  // namespace

FlgContourView default_contour_view() {
    auto view = sized<FlgContourView>();
    view.ring_count = 1;
    return view;
}

Contour read_contour(const FlgContourView* contour, Memory* memory, bool to_repair) {
    const FlgContourView view = read_struct(contour, default_contour_view(), "desc.contour");
    if (view.point_count > max_points)
        throw Failure(FLG_ERROR_LIMIT, "desc.contour.point_count is %u, at most %u", view.point_count, max_points);
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
    return to_repair ? gather_contour(points, offsets, memory) : clean_contour(points, offsets, memory);
}

}  // namespace flg
