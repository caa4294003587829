// SPDX-License-Identifier: MIT
// Arguments at the ends of their ranges.
#include <cfloat>

#include "api/host.h"

namespace flg::test {
namespace {

TEST(StylizeApi, AnyTemperatureGivesAWalkOnTheStyle) {
    for (float size : {1.0f, 1e6f}) {
        for (uint32_t patch : {1u, 100u}) {
            for (float temperature : {1e30f, FLT_MAX}) {
                Host host;
                Curves example = coil(), target = arcs(1);
                for (float& v : example.positions) v *= size;
                for (float& v : target.positions) v *= size;
                FlgStyleDesc style = flgStyleDefaults();
                style.style = host.create(example);
                style.patch = patch;
                FlgStylizeDesc desc = flgStylizeDefaults();
                ASSERT_EQ(flgStyleCreate(host.context, &style, &desc.style, nullptr), FLG_OK);
                desc.target = host.create(target);
                desc.temperature = temperature;
                FlgCurveSet out{};
                FlgJob job{};
                ASSERT_EQ(flgStylize(host.context, &desc, &out, &job), FLG_OK) << flgLastError();
                host.finish();
                ASSERT_EQ(host.result_of(job), FLG_OK) << host.status_of(job).error;
                FlgStyleInfo info{};
                info.struct_size = sizeof info;
                ASSERT_EQ(flgStyleGetInfo(host.context, desc.style, &info), FLG_OK);
                const FlgCurveSetView view = host.view_of(out);
                const float* indices = find_column(view, FLG_ATTRIBUTE_STYLE_INDEX)->data;
                for (uint32_t i = 0; i < view.curve_offsets[1]; ++i) {
                    ASSERT_GE(indices[i], 0.0f);
                    ASSERT_LT(indices[i], static_cast<float>(info.point_count));
                }
            }
        }
    }
}

}  // namespace
}  // namespace flg::test
