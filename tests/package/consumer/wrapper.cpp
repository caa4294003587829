// SPDX-License-Identifier: MIT
// The SDK from C++: a line resampled by a job.
#include <cstdio>
#include <filigree/filigree.hpp>

int main() {
    try {
        filigree::Context context;
        const float points[] = {0, 0, 0, 1, 0, 0};
        const uint32_t offsets[] = {0, 2};
        const FlgColumn column{FLG_ATTRIBUTE_POSITION, 3, points, 0, 0};
        FlgCurveSetView view = flgCurveSetViewDefaults();
        view.curve_count = 1;
        view.curve_offsets = offsets;
        view.columns = &column;
        view.column_count = 1;
        const filigree::CurveSet line = context.curves(view);
        FlgResampleDesc desc = flgResampleDefaults();
        desc.curves = line.get();
        desc.spacing = 0.25f;
        const filigree::CurveSet even = context.resample(desc);
        context.finish();
        return even.view().curve_offsets[1] == 5 ? 0 : 1;
    } catch (const filigree::Error& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
}
