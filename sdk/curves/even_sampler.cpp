// SPDX-License-Identifier: MIT
#include "curves/even_sampler.h"

namespace flg {

EvenSampler::EvenSampler(const CurveView& curve, double length, uint32_t steps, const float* scales)
    : stream_(curve), curve_(curve), steps_(steps), step_(steps > 0 ? length / steps : 0), scales_(scales) {}

EvenSampler::EvenSampler(const CurveView& curve, double step, const float* scales)
    : stream_(curve), curve_(curve), steps_(UINT32_MAX), step_(step), scales_(scales) {}

void EvenSampler::make_last(CurveSample& out) const {
    out.position = curve_.point(curve_.closed ? 0 : curve_.count - 1);
    if (steps_ == 0) {
        // A curve without length has no direction; any will do.
        out.tangent = Vec3::UnitX();
        out.segment = 0;
        out.t = 0;
        return;
    }
    out.tangent = stream_.segment().tangent_end();
    out.segment = stream_.index();
    out.t = 1;
}

}  // namespace flg
