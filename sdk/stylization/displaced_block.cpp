// SPDX-License-Identifier: MIT
#include "stylization/displaced_block.h"

#include "core/vector_targets.h"

namespace flg {

namespace portable {
#include "stylization/displaced_block.inl"
}  // namespace portable

#ifdef FLG_DISPATCH_VECTORS
FLG_BEGIN_AVX2
namespace avx2 {
#include "stylization/displaced_block.inl"
}  // namespace avx2
FLG_END_AVX2
#endif

bool displace_samples(const SampleBlock& samples, DisplacedBlock& block) {
    FLG_FOR_THIS_MACHINE(displace(samples, block));
    return portable::count_too_large(block, samples.count) == 0;
}

void turn_normals(const DisplacedBlock& block, SampleBlock& samples) {
    FLG_FOR_THIS_MACHINE(turn(block, samples));
}

}  // namespace flg
