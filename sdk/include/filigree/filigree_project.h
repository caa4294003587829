/* SPDX-License-Identifier: MIT
 * SPDX-FileCopyrightText: 2026 The Filigree authors
 *
 * Curves in space laid onto surfaces: strokes drawn near a surface, stylized borders, outlines. It follows the grammar of filigree.h
 * and filigree_surface.h.
 */
#ifndef FILIGREE_FILIGREE_PROJECT_H
#define FILIGREE_FILIGREE_PROJECT_H

#include "filigree_surface.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct FlgProjectDesc {
    uint32_t struct_size;
    uint32_t reserved;
    FlgJobOptions job;
    FlgSurface surface;
    FlgCurveSet curves; /* open and closed ones; only their POSITION is used */
} FlgProjectDesc;

FLG_API FlgResult flgProjectDescInit(FlgProjectDesc* desc, uint32_t struct_size);

/* Starts a job that lays curves in space onto a surface, to be cut in: each point goes to the surface's point nearest to it,
 * and between two points the curve follows the plane through both and the surface's normal there, or, where no such way leads
 * from one to the other, a shortest path. curve_values are lengths. Curves that come to a single point are left out. Fails if
 * consecutive points come to parts of the surface that do not hang together. Cost: 0.1 us a triangle of the surface, some us a
 * point near it (more the farther off) and 0.1 us a triangle passed. */
FLG_API FlgResult flgProjectCurves(FlgContext context, const FlgProjectDesc* desc, FlgSurfaceCurves* out_curves,
                                   FlgJob* out_job);

static inline FlgProjectDesc flgProjectDefaults(void) {
    FlgProjectDesc desc;
    flgProjectDescInit(&desc, (uint32_t)sizeof desc);
    return desc;
}

#ifdef __cplusplus
}
#endif

#endif
