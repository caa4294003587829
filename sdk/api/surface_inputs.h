// SPDX-License-Identifier: MIT
// What the entry points of surfaces share.
#pragma once

#include "api/context.h"
#include "api/error.h"
#include "surfaces/field_levels.h"
#include "surfaces/mesh/region_set.h"
#include "surfaces/traced_curves.h"

namespace flg {

// Whether the surface's arrays can be seen now: FLG_NOT_READY while it is made or changed, its job's error if that
// failed.
inline FlgResult visible_result_now(const Surface& surface) {
    const FlgResult result = surface.visible_result();
    if (result < 0) return set_last_error(result, surface.error());
    return result == FLG_OK && surface.order.is_changing() ? FLG_NOT_READY : result;
}

// Refuses fields and curves of another revision than jobs started now will see.
template <class T>
void check_revision(const T& product, const char* argument) {
    if (product.revision != product.surface->order.revision()) {
        throw Failure(FLG_ERROR_INVALID_ARGUMENT, "%s belongs to revision %u of its surface, which is at %u now",
                      argument, product.revision, product.surface->order.revision());
    }
}

// A field or curves for a job that starts now.
template <class T>
std::shared_ptr<T> read_current(const HandleTable<T>& table, uint64_t id, const char* argument,
                                Submission& submission) {
    const std::shared_ptr<T>& product = table.get(id, argument);
    check_revision(*product, argument);
    submission.read(*product, argument);
    return product;
}

// Two products for one job: of one surface and revision.
template <class T, class U>
void check_same_surface(const T& product, const U& other, const char* argument) {
    if (product.surface != other.surface) {
        throw Failure(FLG_ERROR_INVALID_ARGUMENT, "%s belongs to another surface", argument);
    }
    if (product.revision != other.revision) {
        throw Failure(FLG_ERROR_INVALID_ARGUMENT, "%s belongs to revision %u of the surface, not %u", argument,
                      other.revision, product.revision);
    }
}

// What solvers need on a surface: starts the job that builds it, hidden from the host, once; returns that job, or null
// if it is done. Starts another if it made nothing for want of memory, or if what it made was lost since.
std::shared_ptr<Job> start_blocks(Context& context, const std::shared_ptr<Surface>& surface);

Buffer<uint32_t> read_indices(const uint32_t* indices, uint32_t count, const char* argument, Memory* memory);

Buffer<uint32_t> read_border_regions(const FlgFieldGeodesicDesc& desc, Memory* memory);

// The offsets of desc.path_count paths of two points at least.
Buffer<uint32_t> read_path_offsets(const FlgFieldTracePathsDesc& desc, Memory* memory);

LevelRequest read_levels(const float* levels, uint32_t count, float first, float every, Memory* memory);

// A host's list of labels; null: all regions.
RegionSet read_regions(const uint32_t* regions, uint32_t count, Memory* memory);

// A host's points, checked as far as the surface need not be known, weights clipped.
Buffer<SurfacePoint> read_points(const FlgSurfacePoint* points, uint32_t count, const char* argument, Memory* memory);

// A host's points, copied; coordinates are finite and at most 1e30 in size.
Buffer<Position> read_positions(const float* positions, uint32_t count, const char* argument, Memory* memory);

}  // namespace flg
