/* SPDX-License-Identifier: MIT
 * Picking without the SDK beside it: a ray hits a curve. */
#include <filigree/filigree_pick.h>
#include <stdio.h>

int main(void) {
    const float points[] = {-1, 0, 0, 1, 0, 0};
    const uint32_t offsets[] = {0, 2};
    const FlgColumn column = {FLG_ATTRIBUTE_POSITION, 3, points, 0, 0};
    const FlgCurveSetView view = {sizeof view, 1, offsets, NULL, &column, 1, 0, {0}};
    const FlgRay ray = {{0, 0, 5}, 0, {0, 0, -1}, 100};
    FlgPickScene scene = NULL;
    FlgHit hit;
    if (flgPickSceneCreate(NULL, &scene) != FLG_OK || flgPickSceneSetCurves(scene, 7, &view, 0.5f) != FLG_OK ||
        flgPickSceneCommit(scene) != FLG_OK || flgPickSceneCastRays(scene, &ray, 1, &hit) != FLG_OK) {
        fprintf(stderr, "%s\n", flgPickErrorGetMessage());
        return 1;
    }
    flgPickSceneDestroy(scene);
    return hit.object != 7 || hit.distance < 4.4f || hit.distance > 4.6f;
}
