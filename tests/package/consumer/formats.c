/* SPDX-License-Identifier: MIT
 * Formats without the SDK beside them, and a refusal in words. */
#include <filigree/filigree_io.h>
#include <stdio.h>
#include <string.h>

int main(void) {
    const float points[] = {0, 0, 0, 1, 0, 0};
    const uint32_t offsets[] = {0, 2};
    const FlgColumn column = {FLG_ATTRIBUTE_POSITION, 3, points, 0, 0};
    FlgCurveSetView view = {sizeof view, 1, offsets, NULL, &column, 1, 0, {0}};
    FlgCurveFile file = NULL;
    if (flgCurveFileWrite("line.glb", &view, NULL) != FLG_OK || flgCurveFileRead("line.glb", NULL, &file) != FLG_OK ||
        flgCurveFileGetView(file, &view) != FLG_OK || view.curve_offsets[1] != 2) {
        fprintf(stderr, "%s\n", flgIoErrorGetMessage());
        return 1;
    }
    flgCurveFileRelease(file);
    return flgCurveFileRead("none.glb", NULL, &file) != FLG_ERROR_FILE ||
           strstr(flgIoErrorGetMessage(), "none.glb") == NULL;
}
