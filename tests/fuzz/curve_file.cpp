// SPDX-License-Identifier: MIT
// Files of curves, of the format FLG_EXTENSION: refused, or curves as views promise them; text that is written again is
// read as the same bits.
#include <algorithm>
#include <cmath>
#include <cstring>

#include "filigree/filigree_io.h"
#include "fuzz/fuzz.h"

namespace {

using flg::fuzz::InputFile;

void demand_sound(const FlgCurveSetView& view) {
    FLG_DEMAND(view.curve_offsets[0] == 0);
    for (uint32_t c = 0; c < view.curve_count; ++c) FLG_DEMAND(view.curve_offsets[c] < view.curve_offsets[c + 1]);
    const size_t points = view.curve_offsets[view.curve_count];
    FLG_DEMAND(view.column_count > 0 && view.columns[0].attribute == FLG_ATTRIBUTE_POSITION);
    for (uint32_t k = 0; k < view.column_count; ++k) {
        const FlgColumn& column = view.columns[k];
        for (size_t i = 0; i < points * column.components; ++i) FLG_DEMAND(std::isfinite(column.data[i]));
    }
}

// A closed curve whose last point is its first again: .xyz leaves the repetition out.
bool repeats_ends(const FlgCurveSetView& view) {
    for (uint32_t c = 0; c < view.curve_count; ++c) {
        const float* const first = view.columns[0].data + size_t{3} * view.curve_offsets[c];
        const float* const last = view.columns[0].data + size_t{3} * (view.curve_offsets[c + 1] - 1);
        const bool closed = view.curve_flags && (view.curve_flags[c] & FLG_CURVE_CLOSED) != 0;
        if (closed && std::equal(first, first + 3, last)) return true;
    }
    return false;
}

void demand_same_when_written(const FlgCurveSetView& view) {
    static const InputFile copy(".copy.xyz");
    const char* const path = copy.holding(nullptr, 0);
    FLG_DEMAND(flgCurveFileWrite(path, &view, nullptr) == FLG_OK);
    FlgCurveFile again = nullptr;
    FlgCurveSetView same = view;
    FLG_DEMAND(flgCurveFileRead(path, nullptr, &again) == FLG_OK && flgCurveFileGetView(again, &same) == FLG_OK);
    FLG_DEMAND(same.curve_count == view.curve_count);
    const size_t points = view.curve_offsets[view.curve_count];
    FLG_DEMAND(same.curve_offsets[same.curve_count] == points);
    FLG_DEMAND(std::memcmp(same.columns[0].data, view.columns[0].data, points * 3 * sizeof(float)) == 0);
    flgCurveFileRelease(again);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
    static const InputFile input(FLG_EXTENSION);
    FlgCurveFile file = nullptr;
    const FlgResult result = flgCurveFileRead(input.holding(data, size), nullptr, &file);
    if (result != FLG_OK) {
        FLG_DEMAND(file == nullptr);
        flg::fuzz::demand_refusal(result, flgIoErrorGetMessage());
        return 0;
    }
    FlgCurveSetView view = {};
    view.struct_size = sizeof view;
    FlgCurveFileInfo info = {};
    info.struct_size = sizeof info;
    FLG_DEMAND(flgCurveFileGetView(file, &view) == FLG_OK && flgCurveFileGetInfo(file, &info) == FLG_OK);
    for (uint32_t i = 0; i < info.stroke_count; ++i) {
        FlgStroke stroke = flgStrokeDefaults();
        FLG_DEMAND(flgCurveFileGetStroke(file, i, &stroke) == FLG_OK);
    }
    for (uint32_t i = 0; i < info.warning_count; ++i) FLG_DEMAND(std::strlen(info.warnings[i]) > 0);
    if (view.curve_count > 0) {
        demand_sound(view);
        if (!repeats_ends(view)) demand_same_when_written(view);
    }
    flgCurveFileRelease(file);
    return 0;
}
