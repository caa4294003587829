/* SPDX-License-Identifier: MIT
 * SPDX-FileCopyrightText: 2026 The Filigree authors
 *
 * Picking on surfaces and curves, with Embree, in a separate library (filigree_pick) that hosts may leave out. Follows
 * the grammar of filigree.h but needs no context: a scene copies its input.
 *
 * Threads   A function that changes a scene must not overlap with any other call on it, and no query may run between a
 *           change and the commit after it; queries may run in parallel on any threads.
 * Brushes   The area within a geodesic radius of a hit is a field: flgFieldCreateGeodesic from the hit's triangle, u
 *           and v, with max_distance.
 * Waiting   Setting up a surface of 2 million triangles takes seconds: do it where your engine loads assets. Updating
 *           after a cut adds only the changes: well below a millisecond per thousand changed triangles.
 */
#ifndef FILIGREE_FILIGREE_PICK_H
#define FILIGREE_FILIGREE_PICK_H

#include "filigree_surface.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Embree's acceleration structures over copies of surfaces and curves. */
typedef struct FlgPickSceneT* FlgPickScene;

/* [any thread] As flgErrorGetMessage, for the functions of this header. */
FLG_API const char* flgPickErrorGetMessage(void);

typedef struct FlgPickSceneDesc {
    uint32_t struct_size;
    uint32_t threads; /* for Embree's builds; 0: one per core. Default 1: the calling thread */
    /* Metres: what rays, points and hits are relative to. Objects near it are picked most precisely. Default 0 */
    double origin[3];
    /* The scene's memory: copies of positions, triangles and curves, and what queries need. Called from any thread.
     * Null: the C++ runtime's. Not included: Embree's structures and buffers, which are half of the whole and more. */
    const FlgAllocator* allocator;
    /* Told of Embree's memory, which no hook provides: of `bytes` that it is about to take (above 0) or gave back
     * (below 0: the return value is not used). 0 refuses: what needed the memory returns FLG_ERROR_OUT_OF_MEMORY; set
     * that object and commit again. Called from Embree's threads, too. Null: all is granted. */
    uint32_t (*embree_memory)(void* user_data, int64_t bytes);
    void* user_data; /* passed to embree_memory */
} FlgPickSceneDesc;

FLG_API FlgResult flgPickSceneDescInit(FlgPickSceneDesc* desc, uint32_t struct_size);

/* `desc` may be null: all defaults. Cost: 0.2 to 1 ms. */
FLG_API FlgResult flgPickSceneCreate(const FlgPickSceneDesc* desc, FlgPickScene* out_scene);

/* Null is allowed. */
FLG_API void flgPickSceneDestroy(FlgPickScene scene);

/* Adds a surface to the scene under an index of the host's choice, or updates the one there; anything else under that
 * index is removed. With `changed` (flgSurfaceGetChanges since the revision last set in the scene; triangles beyond
 * those set count as changed) only these triangles are added beside the existing structure. The structure is rebuilt
 * once a quarter of the triangles has changed, or with `changed` null. Takes effect with flgPickSceneCommit.
 * Cost: about 1 us a triangle that is new, with flgPickSceneCommit. */
FLG_API FlgResult flgPickSceneSetSurface(FlgPickScene scene, uint32_t object, const FlgSurfaceView* surface,
                                         const uint32_t* changed, uint32_t changed_count);

/* Likewise for curves, as round tubes: with their RADIUS, or half their WIDTH, but at least `min_radius` (metres, >
 * 0), so that thin lines can be hit. Cost: about 1.6 us a point that is new, with flgPickSceneCommit. */
FLG_API FlgResult flgPickSceneSetCurves(FlgPickScene scene, uint32_t object, const FlgCurveSetView* curves,
                                        float min_radius);

/* FLG_ERROR_INVALID_ARGUMENT if nothing is under that index. */
FLG_API FlgResult flgPickSceneRemove(FlgPickScene scene, uint32_t object);

/* Builds what was set since the last commit. Queries before the first commit hit nothing. Cost: with
 * flgPickSceneSetSurface, see there. */
FLG_API FlgResult flgPickSceneCommit(FlgPickScene scene);

/* A ray. */
typedef struct FlgRay {
    float origin[3];    /* magnitude at most 1e18; likewise for positions of surfaces, and points below */
    float nearest;      /* ignores hits before this, in lengths of the direction, >= 0 */
    float direction[3]; /* of any length but 0 */
    float furthest;     /* ignores hits after this, likewise; may be infinite */
} FlgRay;

/* The hit of a ray or a point. */
typedef struct FlgHit {
    uint32_t object;   /* the host's index; FLG_NO_INDEX: nothing was hit */
    uint32_t element;  /* the triangle; for curves the point at which the segment begins */
    float u, v;        /* as in FlgSurfacePoint; for curves u is the fraction along the segment, 0 to 1, and v is 0 */
    float position[3]; /* metres */
    float distance;    /* for rays, in lengths of their direction; for the nearest point, metres (0 inside a curve's
                          tube) */
    float normal[3];   /* of the flat triangle, or away from the curve; unit length */
    uint32_t region;   /* the triangle's label; for curves the curve's index */
} FlgHit;

/* [any thread] The first hit of each ray, on both sides of surfaces. FLG_ERROR_INVALID_ARGUMENT names the first invalid
 * ray; no ray is then shot. Cost, with 2 million triangles: about a microsecond a ray, half of that for 10,000 rays or
 * more at a time. */
FLG_API FlgResult flgPickSceneCastRays(FlgPickScene scene, const FlgRay* rays, uint32_t ray_count, FlgHit* out_hits);

/* [any thread] The nearest point within `max_distance` (metres, > 0, may be infinite). Cost: some us, tens if it is
 * far. */
FLG_API FlgResult flgPickSceneFindNearest(FlgPickScene scene, const float point[3], float max_distance,
                                          FlgHit* out_hit);

/* ---- Defaults by value ------------------------------------------------------------------------------------------- */

static inline FlgPickSceneDesc flgPickSceneDefaults(void) {
    FlgPickSceneDesc desc;
    flgPickSceneDescInit(&desc, (uint32_t)sizeof desc);
    return desc;
}

#ifdef __cplusplus
}
#endif

#endif
