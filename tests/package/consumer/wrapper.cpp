// SPDX-License-Identifier: MIT
// The SDK from C++: a line resampled by a job.
#include <cstdio>
#include <filigree/filigree.hpp>

int main() {
    try {
        filigree::Context context = filigree::Context::create();
        const filigree::CurveSet line = context.curve_set_from_points({0, 0, 0, 1, 0, 0});
        filigree::CurveSetResampleDesc desc;
        desc.spacing = 0.25f;
        const filigree::CurveSet even = line.resample(desc);
        context.run();
        return even.view().curve_offsets[1] == 5 ? 0 : 1;
    } catch (const filigree::Error& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
}
