/* SPDX-License-Identifier: MIT
 * SPDX-FileCopyrightText: 2026 The Filigree authors
 *
 * Picking on surfaces and curves, with Embree, in a library of its own (filigree_pick) that hosts may leave out. It
 * follows the grammar of filigree.h but needs no context: a scene copies what it is shown.
 *
 * Threads   Functions that change a scene must not overlap with any other on it, and no query may run from a change to the
 *           commit after it; queries may run side by side on any threads.
 * Brushes   What lies within a geodesic radius of a hit is a field: flgGeodesic from the hit's triangle, u and v, with
 *           max_distance.
 * Waiting   Setting up a surface of 2 million triangles takes seconds: call it where your engine loads assets. After a
 *           cut only what changed is taken in: well below a millisecond for each thousand changed triangles.
 */
#ifndef FILIGREE_FILIGREE_PICK_H
#define FILIGREE_FILIGREE_PICK_H

#include "filigree_surface.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Embree's structures over copies of surfaces and curves. */
typedef struct FlgPickSceneT* FlgPickScene;

/* [any thread] As flgLastError, for the functions of this header. */
FLG_API const char* flgPickLastError(void);

typedef struct FlgPickSceneDesc {
    uint32_t struct_size;
    uint32_t threads; /* that Embree may build with; 0: one a core. Default 1: the calling one */
} FlgPickSceneDesc;

FLG_API FlgResult flgPickSceneDescInit(FlgPickSceneDesc* desc, uint32_t struct_size);

/* `desc` may be null: all defaults. Cost: 0.2 to 1 ms. */
FLG_API FlgResult flgPickSceneCreate(const FlgPickSceneDesc* desc, FlgPickScene* out_scene);

/* Null is allowed. */
FLG_API void flgPickSceneDestroy(FlgPickScene scene);

/* Puts a surface into the scene under a number of the host's choice, or brings the one there up to date; what was there under
 * that number before and isn't this surface goes. With `changed` (flgSurfaceGetChanges since the revision that the scene has seen;
 * triangles beyond those seen count as changed) only these are taken in, beside the structure that is there; it is
 * built anew once a quarter of the triangles changed, or with `changed` null. Takes effect with flgPickSceneCommit.
 * Cost: about 1 us a triangle that is new, with flgPickSceneCommit. */
FLG_API FlgResult flgPickSceneSetSurface(FlgPickScene scene, uint32_t object, const FlgSurfaceView* surface,
                                         const uint32_t* changed, uint32_t changed_count);

/* Likewise curves, as round tubes: of their RADIUS, or half the WIDTH, but at least `least_radius` (metres, > 0), so that thin
 * lines can be hit. Cost: about 1.6 us a point that is new, with flgPickSceneCommit. */
FLG_API FlgResult flgPickSceneSetCurves(FlgPickScene scene, uint32_t object, const FlgCurveSetView* curves,
                                        float least_radius);

/* FLG_ERROR_INVALID_ARGUMENT if there is nothing under that number. */
FLG_API FlgResult flgPickSceneRemove(FlgPickScene scene, uint32_t object);

/* Builds what was set since the last time. Queries before the first commit hit nothing.
 * Cost: with flgPickSceneSetSurface, see there. */
FLG_API FlgResult flgPickSceneCommit(FlgPickScene scene);

/* Where a ray begins and goes. */
typedef struct FlgRay {
    float origin[3];    /* at most 1e18 in size; so are the positions of surfaces, and points below */
    float nearest;      /* hits before this are not seen, in lengths of the direction, >= 0 */
    float direction[3]; /* of any length but 0 */
    float furthest;     /* likewise hits after this; may be infinite */
} FlgRay;

/* What a ray or a point met. */
typedef struct FlgHit {
    uint32_t object;   /* the host's number; FLG_NO_INDEX: nothing was hit */
    uint32_t element;  /* the triangle; of curves the point at which the segment begins */
    float u, v;        /* as in FlgSurfacePoint; of curves u is the way along the segment, 0 to 1, and v is 0 */
    float position[3]; /* metres */
    float distance;    /* of rays, in lengths of their direction; of the nearest point, metres (0 inside a curve's tube) */
    float normal[3];   /* of the flat triangle, or away from the curve; unit length */
    uint32_t region;   /* the triangle's label; of curves the curve's number */
} FlgHit;

/* [any thread] The first hit of each ray, on both sides of surfaces. FLG_ERROR_INVALID_ARGUMENT names the first ray
 * that isn't one; no ray is then shot. Cost, with 2 million triangles: about a
 * microsecond a ray, half of that for 10,000 rays or more at a time. */
FLG_API FlgResult flgPickRays(FlgPickScene scene, const FlgRay* rays, uint32_t ray_count, FlgHit* out_hits);

/* [any thread] The nearest point within `max_distance` (metres, > 0, may be infinite).
 * Cost: some us, tens where it is far. */
FLG_API FlgResult flgPickNearest(FlgPickScene scene, const float point[3], float max_distance, FlgHit* out_hit);

#ifdef __cplusplus
}
#endif

#endif
