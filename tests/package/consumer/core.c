/* SPDX-License-Identifier: MIT
 * The SDK from C: a curve, its points back, of the version that the header has. */
#include <filigree/filigree.h>
#include <stdio.h>

static int failed(FlgResult result) {
    if (result != FLG_OK) fprintf(stderr, "%s: %s\n", flgResultGetName(result), flgErrorGetMessage());
    return result != FLG_OK;
}

int main(void) {
    const float points[] = {0, 0, 0, 1, 0, 0, 1, 1, 0};
    const uint32_t offsets[] = {0, 3};
    const FlgColumn column = {FLG_ATTRIBUTE_POSITION, 3, points, 0, 0};
    FlgCurveSetView view = flgCurveSetViewDefaults();
    FlgContext context;
    FlgCurveSet set;
    view.curve_count = 1;
    view.curve_offsets = offsets;
    view.columns = &column;
    view.column_count = 1;
    if (failed(flgContextCreate(NULL, &context)) || failed(flgCurveSetCreate(context, &view, &set)) ||
        failed(flgCurveSetGetView(context, set, &view))) {
        return 1;
    }
    const int same = view.columns[0].data != points && view.columns[0].data[7] == 1 && flgVersionGet() == FLG_VERSION;
    return failed(flgContextDestroy(context)) || !same;
}
