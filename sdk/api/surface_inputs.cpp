// SPDX-License-Identifier: MIT
#include "api/surface_inputs.h"

#include <algorithm>
#include <cmath>

#include "api/descriptors.h"
#include "api/inputs.h"
#include "surfaces/geodesic_jobs.h"

namespace flg {

namespace {

constexpr float weight_slack = 1e-5f;  // rounding of weights that is clipped

void check_labels(const uint32_t* labels, uint32_t count, const char* argument) {
    for (uint32_t i = 0; i < count; ++i) {
        if (labels[i] > FLG_REGION_MAX) {
            throw Failure(FLG_ERROR_INVALID_ARGUMENT, "%s[%u] is %u, the largest label is %u", argument, i, labels[i],
                          FLG_REGION_MAX);
        }
    }
}

}  // namespace

std::shared_ptr<Job> start_blocks(Context& context, const std::shared_ptr<Surface>& surface) {
    GeodesicSolvers& solvers = surface->solvers;
    const SolverBuild* last = solvers.blocks_build.get();
    if (last && last->visible_result() == FLG_OK && solvers.has_blocks) return nullptr;
    if (last && last->visible_result() == FLG_NOT_READY) return last->producer.lock();
    auto build = make_object<SolverBuild>(context.memory[MemoryKind::caches]);
    Submission submission(context, nullptr);
    submission.read_surface(surface, "desc.surface");
    submission.job().priority = FLG_PRIORITY_HIGH;
    submission.job().strand.start(build_blocks(submission.pace(), surface));
    build->producer = submission.job().shared_from_this();
    submission.commit(build, MemoryKind::caches, nullptr);
    solvers.blocks_build = build;
    return build->producer.lock();
}

Buffer<uint32_t> read_border_regions(const FlgFieldGeodesicDesc& desc, Memory* memory) {
    Buffer<uint32_t> regions =
        read_indices(desc.border_regions, desc.border_region_count, "desc.border_regions", memory);
    check_labels(regions.data(), desc.border_region_count, "desc.border_regions");
    return regions;
}

Buffer<uint32_t> read_indices(const uint32_t* indices, uint32_t count, const char* argument, Memory* memory) {
    if (count > 0) require(indices, argument);
    Buffer<uint32_t> copy(count, memory);
    std::copy_n(indices, count, copy.data());
    return copy;
}

Buffer<uint32_t> read_path_offsets(const FlgFieldTracePathsDesc& desc, Memory* memory) {
    check_range(desc.path_count > 0, "desc.path_count", desc.path_count, "at least 1");
    const uint32_t* offsets = &require(desc.path_offsets, "desc.path_offsets");
    Buffer<uint32_t> copy(size_t{desc.path_count} + 1, memory);
    if (offsets[0] != 0) throw Failure(FLG_ERROR_INVALID_ARGUMENT, "desc.path_offsets[0] is %u, must be 0", offsets[0]);
    copy[0] = 0;
    for (uint32_t p = 0; p < desc.path_count; ++p) {
        if (offsets[p + 1] < uint64_t{offsets[p]} + 2) {
            throw Failure(FLG_ERROR_INVALID_ARGUMENT,
                          "desc.path_offsets[%u] is %u after %u; every path needs at least two points", p + 1,
                          offsets[p + 1], offsets[p]);
        }
        copy[p + 1] = offsets[p + 1];
    }
    return copy;
}

LevelRequest read_levels(const float* levels, uint32_t count, float first, float every, Memory* memory) {
    constexpr uint32_t max_count = 65534;
    check_range(count <= max_count, "desc.level_count", count, "at most 65534");
    LevelRequest request;
    request.count = count;
    if (levels) {
        check_range(count >= 1, "desc.level_count", count, "at least 1 with levels");
        request.values = Buffer<float>(count, memory);
        for (uint32_t k = 0; k < count; ++k) {
            const bool rises = k == 0 || levels[k] > levels[k - 1];
            if (!std::isfinite(levels[k]) || !rises) {
                throw Failure(FLG_ERROR_INVALID_ARGUMENT, "desc.levels[%u] is %g, must be finite and rise", k,
                              static_cast<double>(levels[k]));
            }
            request.values[k] = levels[k];
        }
        return request;
    }
    check_range(std::isfinite(first), "desc.level_first", first, "finite");
    check_range(every > 0 && std::isfinite(every), "desc.level_every", every, "finite and above 0");
    request.first = first;
    request.every = every;
    return request;
}

RegionSet read_regions(const uint32_t* regions, uint32_t count, Memory* memory) {
    if (!regions) {
        if (count > 0) {
            throw Failure(FLG_ERROR_INVALID_ARGUMENT, "desc.regions is null, but region_count is %u", count);
        }
        return RegionSet(memory);
    }
    check_labels(regions, count, "desc.regions");
    return RegionSet(regions, count, memory);
}

Buffer<SurfacePoint> read_points(const FlgSurfacePoint* points, uint32_t count, const char* argument, Memory* memory) {
    if (count > 0) require(points, argument);
    Buffer<SurfacePoint> copy(count, memory);
    for (uint32_t i = 0; i < count; ++i) {
        const auto [triangle, u, v] = points[i];
        if (!(u >= -weight_slack && v >= -weight_slack && u + v <= 1 + weight_slack)) {
            throw Failure(FLG_ERROR_INVALID_ARGUMENT, "%s[%u] has the weights u = %g, v = %g, outside its triangle",
                          argument, i, static_cast<double>(u), static_cast<double>(v));
        }
        const float clipped_u = std::clamp(u, 0.0f, 1.0f);
        copy[i] = {triangle, clipped_u, std::clamp(v, 0.0f, 1 - clipped_u)};
    }
    return copy;
}

Buffer<Position> read_positions(const float* positions, uint32_t count, const char* argument, Memory* memory) {
    if (count > 0) require(positions, argument);
    Buffer<Position> copy(count, memory);
    for (size_t i = 0; i < count; ++i) {
        for (size_t k = 0; k < 3; ++k) {
            copy[i][k] = positions[3 * i + k];
            if (is_coordinate(copy[i][k])) continue;
            throw Failure(FLG_ERROR_INVALID_ARGUMENT, "%s[%zu] is %g, must be finite and at most 1e30 in size",
                          argument, 3 * i + k, static_cast<double>(copy[i][k]));
        }
    }
    return copy;
}

}  // namespace flg
