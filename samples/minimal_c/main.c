/* SPDX-License-Identifier: MIT
 * All that a host does, in C: one zigzag is the style, a straight line gets it, while frames go by. */
#include <filigree/filigree.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

/* Every call of the SDK says whether it worked; FLG_NOT_READY, above zero, is no failure. */
static FlgResult check(FlgResult result) {
    if (result >= 0) return result;
    fprintf(stderr, "%s: %s\n", flgResultGetName(result), flgErrorGetMessage());
    exit(1);
}

int main(void) {
    static const float zigzag[7][3] = {{0, 0, 0}, {1, 1, 0}, {2, -1, 0}, {3, 1, 0}, {4, -1, 0}, {5, 1, 0}, {6, 0, 0}};
    static const float line[2][3] = {{0, 0, 0}, {30, 0, 0}};
    FlgContext context;
    check(flgContextCreate(NULL, &context)); /* all defaults: one worker thread */

    /* Both calls start a job and return at once. The second needs what the first makes, and waits for it by itself. */
    FlgStyleDesc style = flgStyleDefaults();
    FlgCurveSetStylizeDesc stylize = flgCurveSetStylizeDefaults();
    FlgCurveSet result;
    check(flgCurveSetCreateFromPoints(context, zigzag[0], 7, 0, &style.style)); /* the SDK copies points */
    check(flgCurveSetCreateFromPoints(context, line[0], 2, 0, &stylize.target));
    check(flgStyleCreate(context, &style, &stylize.style, NULL));
    check(flgCurveSetStylize(context, &stylize, &result, NULL));

    /* The game's loop: results appear in flgContextTick alone, which takes no longer than it may, here 2 ms. */
    FlgCurveSetView view = flgCurveSetViewDefaults();
    while (check(flgCurveSetGetView(context, result, &view)) == FLG_NOT_READY) {
        check(flgContextTick(context, 2000, NULL));
        check(flgContextWait(context, 11000)); /* a game draws its frame here */
    }

    /* The view shows the SDK's own arrays: draw from them, or upload them. */
    const uint32_t points = view.curve_offsets[1];
    float farthest = 0;
    for (uint32_t point = 0; point < points; ++point)
        farthest = fmaxf(farthest, fabsf(view.columns[0].data[3 * point + 1]));
    printf("a line of 2 points became a zigzag of %u, up to %.2f m off the line\n", points, farthest);
    check(flgContextDestroy(context)); /* and all that it owns with it */
    return 0;
}
