// SPDX-License-Identifier: MIT
#include "baking/bake_tangle.h"

#include <exception>

#include "baking/texel_padding.h"
#include "baking/texel_painter.h"
#include "core/failure.h"
#include "runtime/fork.h"
#include "surfaces/mesh/source_weights.h"

namespace flg {

namespace {

constexpr float uv_slack = 1e-5f;  // beyond 0 and 1: rounding

void check_uvs(const BakeRequest& request, uint32_t triangle) {
    if (!request.draws(triangle)) return;
    for (uint32_t i = 6 * triangle; i < 6 * triangle + 6; ++i) {
        const float value = request.corner_uvs[i];
        if (value >= -uv_slack && value <= 1 + uv_slack) continue;
        const char* const what = std::isfinite(value) ? "outside 0 to 1, where the map is: move the charts into it"
                                                      : "no number: the mesh has no usable texture coordinates";
        throw Failure(FLG_ERROR_INVALID_ARGUMENT, "desc.corner_uvs[%u] is %g (corner %u of triangle %u), %s", i,
                      static_cast<double>(value), i % 6 / 2, triangle, what);
    }
}

// Where the corners of a triangle of the surface lie in the map.
TexelTriangle texel_triangle(const Surface& surface, const BakeRequest& request, uint32_t triangle) {
    const Mesh& mesh = surface.mesh();
    const uint32_t source = mesh.source_triangles[triangle];
    const Triple& inputs = (*surface.input_triangles)[source];
    const float* const uvs = &request.corner_uvs[6 * size_t{source}];
    TexelTriangle corners;
    for (size_t k = 0; k < 3; ++k) {
        const SourceWeights lies = load_sources(surface.columns.back(), mesh.triangles[triangle][k]);
        const std::array<double, 3> weights = {1 - double{lies.weights[0]} - double{lies.weights[1]},
                                               double{lies.weights[0]}, double{lies.weights[1]}};
        std::array<double, 2> place = {};
        for (size_t i = 0; i < 3 && lies.vertices[i] != no_index; ++i) {
            const auto at =
                static_cast<size_t>(std::find(inputs.begin(), inputs.end(), lies.vertices[i]) - inputs.begin());
            for (size_t c = 0; c < 2 && at < 3; ++c) place[c] += weights[i] * double{uvs[2 * at + c]};
        }
        for (size_t c = 0; c < 2; ++c) corners[k][c] = static_cast<float>(place[c] * request.size);
    }
    return corners;
}

TexelTriangle texel_triangle(const BakeRequest& request, uint32_t triangle) {
    TexelTriangle corners;
    const auto size = static_cast<float>(request.size);
    for (size_t i = 0; i < 6; ++i) corners[i / 2][i % 2] = size * request.corner_uvs[6 * size_t{triangle} + i];
    return corners;
}

void check_regions(const Tangle& tangle, const BakeRequest& request) {
    if (!request.maps.blends || request.region_count >= tangle.tree.size()) return;
    throw Failure(FLG_ERROR_INVALID_ARGUMENT, "desc.region_count is %u, but the tangle has %u regions",
                  request.region_count, tangle.tree.size());
}

// Covered texels are marked, the others get the background.
void finish_word(Canvas& canvas, const TexelOwners& owners, uint32_t word) {
    const auto words = static_cast<uint32_t>(canvas.words());
    const uint32_t y = owners.first_row + word / words, begin = word % words * 64;
    const uint32_t end = std::min(begin + 64, canvas.request.size);
    uint64_t bits = 0;
    for (uint32_t x = begin; x < end; ++x) {
        if (owners.is_taken(x, y)) {
            bits |= uint64_t{1} << (x - begin);
        } else {
            paint_background(canvas.request, size_t{y} * canvas.request.size + x);
        }
    }
    canvas.covered[size_t{y} * words + word % words] = bits;
}

Task<void> draw_band(Pace& pace, Canvas& canvas, uint32_t band) {
    TexelOwners owners(canvas.request, canvas.bands, band, pace.memory());
    co_await each(pace, owners.size(), Cost::some_ns, [&](uint32_t i) { owners.clear(i); });
    Slice looks(Cost::some_ns);
    for (const uint32_t t : canvas.mesh_triangles.of(band)) {
        owners.begin(t);
        uint32_t looked = 16;
        do {
            if (looks.is_over(looked)) co_await pace;
        } while ((looked = owners.run()) != 0);
    }
    TexelPainter painter(canvas, owners, pace.memory());
    Slice units(Cost::tens_of_ns);
    for (const uint32_t t : canvas.in_band.of(band)) {
        uint32_t done = painter.begin(t);
        do {
            if (units.is_over(done)) co_await pace;
        } while ((done = painter.run(units.left())) != 0);
    }
    const auto words = static_cast<uint32_t>(canvas.words());
    co_await each(pace, (owners.end_row - owners.first_row) * words, Cost::hundreds_of_ns,
                  [&](uint32_t word) { finish_word(canvas, owners, word); });
    canvas.overlaps[band] = owners.overlaps;
}

// Charts of triangles that are smaller than texels overlap nowhere deeply, but everywhere.
void check_overlaps(const Canvas& canvas) {
    constexpr uint64_t few = 64;  // of so many texels one may be where charts touch
    Overlaps all;
    uint64_t count = 0, texels = 0;
    for (const Overlaps& overlaps : canvas.overlaps) {
        if (count == 0) all = overlaps;
        count += overlaps.count;
        texels += overlaps.texels;
    }
    if (texels == 0) {
        throw Failure(FLG_ERROR_INVALID_ARGUMENT,
                      "desc.corner_uvs: no triangle covers a texel: the mesh has no usable texture coordinates, unwrap "
                      "it first");
    }
    if (few * count > texels) refuse_overlap(all, canvas.request.size);
}

Task<void> draw_maps(Pace& pace, Canvas& canvas) {
    const BakeRequest& request = canvas.request;
    const Surface& surface = canvas.surface;
    const Mesh& mesh = surface.mesh();
    pace.stage("shape");
    canvas.shape = co_await find_shape(pace, surface, request);
    co_await each(pace, request.triangle_count(), Cost::tens_of_ns, [&](uint32_t t) { check_uvs(request, t); });
    if (request.wants_distances()) {
        pace.stage("borders");
        canvas.borders = co_await find_border_pieces(pace, mesh, canvas.tree, canvas.shape.places);
    }
    pace.stage("bands");
    canvas.triangles = Buffer<TexelTriangle>(mesh.triangle_count(), pace.memory());
    co_await each(pace, mesh.triangle_count(), Cost::tens_of_ns,
                  [&](uint32_t t) { canvas.triangles[t] = texel_triangle(surface, request, t); });
    canvas.mesh_triangles = co_await group_by_band(pace, request.triangle_count(), canvas.bands.count, [&](uint32_t t) {
        return request.draws(t) ? canvas.bands.of(texel_triangle(request, t)) : Bands::Range{};
    });
    canvas.in_band = co_await group_by_band(pace, mesh.triangle_count(), canvas.bands.count, [&](uint32_t t) {
        return request.draws(mesh.source_triangles[t]) ? canvas.bands.of(canvas.triangles[t]) : Bands::Range{};
    });
    pace.stage("texels");
    canvas.covered = Buffer<uint64_t>(canvas.words() * request.size, pace.memory());
    canvas.overlaps.resize(canvas.bands.count);
    co_await fork(pace, canvas.bands.count, &draw_band, canvas);
    check_overlaps(canvas);
    pace.stage("padding");
    co_await pad_charts(pace, canvas);
}

template <class... T>
Task<void> release(Pace& pace, Buffer<T>&... buffers) {
    ((buffers = {}, co_await pace), ...);
}

}  // namespace

Task<void> bake_tangle(Pace& pace, std::shared_ptr<const Tangle> tangle, BakeRequest request) {
    check_regions(*tangle, request);
    Canvas canvas(request, *tangle->surface, tangle->tree, pace.memory());
    std::exception_ptr failure;
    try {
        co_await draw_maps(pace, canvas);
    } catch (...) {
        failure = std::current_exception();
    }
    // Large buffers go back one at a time.
    co_await release(pace, canvas.shape.places, canvas.shape.heights, canvas.shape.slopes, canvas.borders.pieces,
                     canvas.borders.at_vertex.offsets, canvas.borders.at_vertex.items, canvas.borders.nearest,
                     canvas.triangles, canvas.mesh_triangles.offsets, canvas.mesh_triangles.items,
                     canvas.in_band.offsets, canvas.in_band.items, canvas.covered, request.positions,
                     request.corner_uvs, request.labels);
    if (failure) std::rethrow_exception(failure);
}

}  // namespace flg
