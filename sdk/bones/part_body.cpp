// SPDX-License-Identifier: MIT
#include "bones/part_body.h"

#include <cmath>

#include "runtime/each.h"

namespace flg {
namespace {

static_assert(sizeof(TriangleVertices) == 3 * sizeof(uint32_t));

constexpr double finest = 1e-4;  // edges of a mesh that is asked for, by the part's length

// By a power of two, so that nothing is rounded that was not before.
void set_scale(const HeldPart& part, PartBody& out) {
    out.origin = part.drawn.points[0];
    out.scale = std::exp2(std::ceil(std::log2(part.length)));
}

Task<void> copy_contour(Pace& pace, const Contour& from, PartBody& out) {
    Contour& to = out.inflated.contour;
    to = Contour(pace.memory());
    to.points.reserve(from.size());
    to.input_points.reserve(from.size());
    to.offsets.reserve(from.offsets.size());
    co_await each(pace, from.size(), Cost::tens_of_ns, [&](uint32_t i) {
        if (i == from.offsets[to.offsets.size()]) to.offsets.push_back(i);
        const Point2& at = from.points[i];
        to.points.push_back({(at.x - out.origin.x) / out.scale, (at.y - out.origin.y) / out.scale});
        to.input_points.push_back(from.input_points[i]);
    });
    to.offsets.push_back(from.size());
}

}  // namespace

void HeldPartMesh::show_vertex(const Vec3& at) {
    if (positions_.empty()) positions_.reserve(3 * surface.positions.size());
    for (int i = 0; i < 3; ++i) positions_.push_back(static_cast<float>(at[i]));
}

void HeldPartMesh::show() noexcept {
    view_ = {.struct_size = sizeof view_,
             .vertex_count = static_cast<uint32_t>(surface.positions.size()),
             .triangle_count = static_cast<uint32_t>(surface.triangles.size()),
             .reserved = 0,
             .positions = positions_.data(),
             .triangles = surface.triangles.data()->data()};
}

Task<void> inflate(Pace& pace, const HeldPart& part, InflationOptions options, PartBody& out) {
    set_scale(part, out);
    options.spacing /= out.scale;
    bool is_simple = true;
    co_await copy_contour(pace, part.line(), out);
    try {
        co_await inflate_part(pace, options, out.inflated);
    } catch (const Failure& failure) {
        if (failure.result() != FLG_ERROR_INVALID_ARGUMENT) throw;
        is_simple = false;
    }
    if (is_simple) co_return;
    out.inflated = InflatedPart(pace.memory());
    co_await copy_contour(pace, part.outline, out);
    co_await inflate_part(pace, options, out.inflated);
}

Task<void> make_part_mesh(Pace& pace, std::shared_ptr<HeldPartMesh> mesh) {
    const double length = mesh->part->length, share = mesh->options.spacing / length;
    if (share != 0 && !(share >= finest && share <= 1))
        throw Failure(FLG_ERROR_INVALID_ARGUMENT, "desc.spacing is %g, must be 0, or %g to 1 of the part's length, %g",
                      mesh->options.spacing, finest, length);
    PartBody body(pace.memory());
    co_await inflate(pace, *mesh->part, mesh->options, body);
    mesh->surface = co_await two_sided_mesh(pace, body.inflated);
    co_await each(pace, mesh->surface.positions.size(), Cost::tens_of_ns, [&](uint32_t v) {
        mesh->show_vertex(body.scale * mesh->surface.positions[v] + Vec3(body.origin.x, body.origin.y, 0));
    });
}

}  // namespace flg
