/* SPDX-License-Identifier: MIT
 * SPDX-FileCopyrightText: 2026 The Filigree authors
 *
 * Projects curves in space onto surfaces: strokes drawn near a surface, stylized borders, outlines. Follows the grammar
 * of filigree.h and filigree_surface.h.
 */
#ifndef FILIGREE_FILIGREE_PROJECT_H
#define FILIGREE_FILIGREE_PROJECT_H

#include "filigree_surface.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct FlgCurveSetProjectDesc {
    uint32_t struct_size;
    uint32_t reserved;
    const FlgJobOptions* job;
    FlgSurface surface;
    FlgCurveSet curves; /* open and closed; only their POSITION is used */
} FlgCurveSetProjectDesc;

FLG_API FlgResult flgCurveSetProjectDescInit(FlgCurveSetProjectDesc* desc, uint32_t struct_size);

/* Starts a job that projects curves in space onto a surface, ready to be cut along: each point snaps to the nearest
 * point of the surface. Between two points the curve follows the plane through both and the surface's normal there or,
 * if that leads nowhere, a shortest path. curve_values are lengths. Curves that collapse to a single point are omitted.
 * Fails if consecutive points fall on disconnected parts of the surface. Cost: 0.1 us a triangle of the surface, some
 * us a point near it (more the farther off) and 0.1 us a triangle passed. */
FLG_API FlgResult flgCurveSetProject(FlgContext context, const FlgCurveSetProjectDesc* desc,
                                     FlgSurfaceCurves* out_curves, FlgJob* out_job);

static inline FlgCurveSetProjectDesc flgCurveSetProjectDefaults(void) {
    FlgCurveSetProjectDesc desc;
    flgCurveSetProjectDescInit(&desc, (uint32_t)sizeof desc);
    return desc;
}

#ifdef __cplusplus
}
#endif

#endif
