/* SPDX-License-Identifier: MIT
 * The C ABI from C11, against the shared library: a coil becomes a style, a line becomes a coil; a square becomes a
 * surface and is measured along. */
#include <math.h>
#include <stdio.h>

#include "filigree/filigree.h"
#include "filigree/filigree_surface.h"

enum { EXAMPLE_POINTS = 300, TARGET_POINTS = 2 };

static int failed(const char* call, FlgResult result) {
    if (result == FLG_OK) return 0;
    fprintf(stderr, "%s: %s: %s\n", call, flgResultGetName(result), flgErrorGetMessage());
    return 1;
}

static FlgResult create(FlgContext context, const float* positions, uint32_t count, FlgCurveSet* out) {
    const uint32_t offsets[2] = {0, count};
    const FlgColumn column = {FLG_ATTRIBUTE_POSITION, 3, positions, 0, 0};
    FlgCurveSetView view = flgCurveSetViewDefaults();
    view.curve_count = 1;
    view.curve_offsets = offsets;
    view.columns = &column;
    view.column_count = 1;
    return flgCurveSetCreate(context, &view, out);
}

/* The distance between two corners of the unit square, across it; below 0 if something failed. */
static float measure_square(FlgContext context) {
    const float corners[12] = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0};
    const uint32_t triangles[6] = {0, 1, 2, 0, 2, 3}, source = 1;
    const FlgColumn column = {FLG_ATTRIBUTE_POSITION, 3, corners, 0, 0};
    FlgSurfaceDesc desc = flgSurfaceDefaults();
    FlgFieldGeodesicDesc geodesic = flgFieldGeodesicDefaults();
    FlgFieldView view = flgFieldViewDefaults();
    FlgField field;
    FlgMeshView input = flgMeshViewDefaults();
    input.vertex_count = 4;
    input.triangle_count = 2;
    input.columns = &column;
    input.column_count = 1;
    input.triangles = triangles;
    desc.mesh = &input;
    if (failed("flgSurfaceCreate", flgSurfaceCreate(context, &desc, &geodesic.surface, NULL))) return -1;
    geodesic.vertices = &source;
    geodesic.vertex_count = 1;
    if (failed("flgFieldCreateGeodesic", flgFieldCreateGeodesic(context, &geodesic, &field, NULL))) return -1;
    while (flgFieldGetView(context, field, &view) == FLG_NOT_READY) {
        if (failed("flgContextTick", flgContextTick(context, 2000, NULL))) return -1;
        flgContextWait(context, 1000);
    }
    if (failed("flgFieldGetView", flgFieldGetView(context, field, &view))) return -1;
    return view.values[3];
}

int main(void) {
    float example[EXAMPLE_POINTS * 3];
    const float target[TARGET_POINTS * 3] = {0, 0, 0, 10, 0, 0};
    for (int i = 0; i < EXAMPLE_POINTS; ++i) {
        example[3 * i] = 0.01f * (float)i;
        example[3 * i + 1] = 0.2f * cosf(0.2f * (float)i);
        example[3 * i + 2] = 0.2f * sinf(0.2f * (float)i);
    }
    FlgContext context = {0};
    if (failed("flgContextCreate", flgContextCreate(NULL, &context))) return 1;

    FlgStyleDesc style = flgStyleDefaults();
    FlgCurveSetStylizeDesc stylize = flgCurveSetStylizeDefaults();
    FlgCurveSet result;
    if (failed("flgCurveSetCreate", create(context, example, EXAMPLE_POINTS, &style.style))) return 1;
    if (failed("flgCurveSetCreate", create(context, target, TARGET_POINTS, &stylize.target))) return 1;
    if (failed("flgStyleCreate", flgStyleCreate(context, &style, &stylize.style, NULL))) return 1;
    if (failed("flgCurveSetStylize", flgCurveSetStylize(context, &stylize, &result, NULL))) return 1;

    FlgCurveSetView view = flgCurveSetViewDefaults();
    FlgFrameReport report = {0};
    report.struct_size = sizeof report;
    do {
        if (failed("flgContextTick", flgContextTick(context, 2000, &report))) return 1;
        flgContextWait(context, 1000);
    } while (report.jobs_pending > 0);
    if (failed("flgCurveSetGetView", flgCurveSetGetView(context, result, &view))) return 1;

    float farthest = 0;
    for (uint32_t i = 0; i < view.curve_offsets[1]; ++i) {
        const float* p = view.columns[0].data + 3 * (size_t)i;
        const float distance = hypotf(p[1], p[2]);
        if (distance > farthest) farthest = distance;
    }
    printf("%u points, at most %g m from the line\n", view.curve_offsets[1], (double)farthest);
    const float across = measure_square(context);
    printf("%g m across the unit square\n", (double)across);
    if (failed("flgContextDestroy", flgContextDestroy(context))) return 1;
    return farthest > 0.1f && farthest < 0.5f && fabsf(across - 1.41421356f) < 1e-5f ? 0 : 1;
}
