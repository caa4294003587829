// SPDX-License-Identifier: MIT
#include "curves/segment_block.h"

#include "core/vector_targets.h"

namespace flg {

namespace portable {
#include "curves/segment_block.inl"
}  // namespace portable

#ifdef FLG_DISPATCH_VECTORS
FLG_BEGIN_AVX2
namespace avx2 {
#include "curves/segment_block.inl"
}  // namespace avx2
FLG_END_AVX2
#endif

void SegmentBlock::load(uint32_t first, const float* positions, uint32_t count) {
    FLG_FOR_THIS_MACHINE(load_points(positions, count, points.x + first, points.y + first, points.z + first));
}

void SegmentBlock::make_edges(uint32_t count) {
    FLG_FOR_THIS_MACHINE(make_edges(*this, count));
}

void SegmentBlock::make_vertices(uint32_t count, Vectors& tangents, double* cosines) const {
    FLG_FOR_THIS_MACHINE(make_vertices(*this, count, tangents, cosines));
}

void SegmentBlock::measure(uint32_t count) {
    FLG_FOR_THIS_MACHINE(measure_segments(*this, count));
}

void SegmentBlock::deviate(uint32_t first, uint32_t last, const Vec3& from, const Vec3& tangent,
                           Deviations& out) const {
    FLG_FOR_THIS_MACHINE(
        measure_deviations(*this, first, last, from.data(), tangent.data(), out.moments, out.across_sq));
    out.largest = FLG_FOR_THIS_MACHINE(largest_coordinate(*this, first + 1, last + 1));
}

}  // namespace flg
