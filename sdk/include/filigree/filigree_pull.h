/* SPDX-License-Identifier: MIT
 * SPDX-FileCopyrightText: 2026 The Filigree authors
 *
 * Surfaces pulled at any of their points (Sorkine, Alexa: As-rigid-as-possible surface modeling, 2007). Follows the
 * grammar of filigree.h. Metres.
 *
 * Pull         What pulling needs of a mesh alone. Made once.
 * Pulled       The mesh as handles pull it. Made again for each frame, from the one before.
 * Keys         Positions of handles over time, recorded or made: a function of plain structs, no object.
 *
 * Neither Pull nor Pulled changes once ready. Both keep their inputs alive.
 */
#ifndef FILIGREE_FILIGREE_PULL_H
#define FILIGREE_FILIGREE_PULL_H

#include "filigree_surface.h"

#ifdef __cplusplus
extern "C" {
#endif

/* What pulling needs of a mesh. Never changes once ready. */
FLG_HANDLE(FlgPull);
/* A mesh as handles pull it. Never changes once ready. */
FLG_HANDLE(FlgPulled);

/* Maximum handles of a pulled mesh. */
#define FLG_PULL_MAX_HANDLES 256u

typedef struct FlgPullDesc {
    uint32_t struct_size;
    float weld_distance;     /* metres: nearer vertices stay together; below 0: none do. Default 0: of one place */
    const FlgJobOptions* job;
    const FlgMeshView* mesh; /* at rest, up to 1048576 vertices; copied */
} FlgPullDesc;

FLG_API FlgResult flgPullDescInit(FlgPullDesc* desc, uint32_t struct_size);

/* Starts a job that makes and factors the mesh's matrix. Any triangles will do. Fails for meshes without triangles.
 * Cost: 3 us and 0.5 KB a vertex. */
FLG_API FlgResult flgPullCreate(FlgContext context, const FlgPullDesc* desc, FlgPull* out_pull, FlgJob* out_job);

FLG_API FlgResult flgPullRelease(FlgContext context, FlgPull pull);

/* A point of the surface, and where it is to be. */
typedef struct FlgPullHandle {
    uint32_t struct_size; /* the same of all handles of a mesh */
    uint32_t vertices[3]; /* of the mesh; the three may be the same. Default 0 */
    float shares[3];      /* of these: 0 to 1, with sum 1 within 0.001. Default 1 0 0 */
    float position[3];    /* metres. Default 0 */
    float compliance;     /* how far it gives way to a unit of force: that on an edge of weight 1 a metre too long; 0:
                             it is there exactly. Finite, 0 or above. Default 0 */
    float radius;         /* metres, at rest: it pulls at the surface within this of its point, hardest in the middle,
                             so that no spike is pulled out. At most half way to the next handle. 0: at the point
                             alone. Below 0: 0.04 of the mesh's diagonal, at least two edges. Finite. Default -1 */
} FlgPullHandle;

FLG_API FlgResult flgPullHandleInit(FlgPullHandle* handle, uint32_t struct_size);

typedef struct FlgPulledDesc {
    uint32_t struct_size;
    uint32_t handle_count;        /* up to FLG_PULL_MAX_HANDLES */
    const FlgJobOptions* job;
    FlgPull pull;                 /* its job may still run */
    const FlgPullHandle* handles; /* pins are handles that stay; copied. Two of compliance 0 with the same vertices and
                                     shares but other positions are refused */
    const float* positions;       /* 3 per vertex, metres: the pose that pulling adds to, as flgSkinDeform gives it;
                                     copied. Null: the mesh at rest. Default null */
    FlgPulled previous;           /* of the same pull, where this one begins; its job may still run. Default null: at
                                     the pose */
    uint32_t rounds;              /* 1 to 1000: of the method's two steps; few are enough if each frame goes on from the
                                     one before. Default 2 */
    uint32_t reserved;
} FlgPulledDesc;

FLG_API FlgResult flgPulledDescInit(FlgPulledDesc* desc, uint32_t struct_size);

/* Starts a job that pulls a mesh. Handles are met after the first round; the rest follows, round by round, until each
 * piece of the surface is turned against the pose but hardly stretched. Without handles the mesh is as the pose has it;
 * handles that move as one body move all so. Pieces without handles stay. Of two handles at one place the first counts.
 * Cost: 0.3 us a vertex and round, and 0.2 us a vertex for each handle that the previous one did not have: 3 ms for
 * 10,000 vertices. */
FLG_API FlgResult flgPulledCreate(FlgContext context, const FlgPulledDesc* desc, FlgPulled* out_pulled,
                                  FlgJob* out_job);

typedef struct FlgPulledView {
    uint32_t struct_size;
    uint32_t vertex_count;
    const float* positions; /* 3 per vertex, metres */
    double energy;          /* of the last round, before positions were found: square metres. It does not rise from
                               round to round, if pose and handles stay */
    double origin[3];       /* metres: what positions are relative to: the mesh's origin */
} FlgPulledView;

FLG_API FlgResult flgPulledViewInit(FlgPulledView* view, uint32_t struct_size);

/* The arrays live until the mesh is released. FLG_NOT_READY until its job is published, the job's error if it
 * failed. */
FLG_API FlgResult flgPulledGetView(FlgContext context, FlgPulled pulled, FlgPulledView* out_view);

FLG_API FlgResult flgPulledRelease(FlgContext context, FlgPulled pulled);

/* Positions of handles over time: a record of what somebody dragged, or keyframes. */
typedef struct FlgPullKeys {
    uint32_t struct_size;
    uint32_t handle_count;   /* 1 to FLG_PULL_MAX_HANDLES */
    const uint32_t* offsets; /* handle_count + 1, from 0: the keys of handle h are offsets[h] to offsets[h + 1] - 1, at
                                least one */
    const double* times;     /* seconds, one per key, rising for each handle */
    const float* positions;  /* 3 per key, metres */
} FlgPullKeys;

FLG_API FlgResult flgPullKeysInit(FlgPullKeys* keys, uint32_t struct_size);

/* [any thread] Where handles are at a time, for FlgPullHandle::position: at their keys exactly, smooth in between
 * (velocities are continuous), at rest where two keys are at one place; before the first key and after the last where
 * these are. `out_positions`: 3 per handle, metres. The same for the same keys, so a record can be played again, at any
 * rate: the mesh too is the same if its frames are at the same times. Cost: 0.1 us a handle, and checking all keys. */
FLG_API FlgResult flgPullKeysSample(const FlgPullKeys* keys, double time, float* out_positions);

/* ---- Defaults by value ------------------------------------------------------------------------------------------- */

static inline FlgPullDesc flgPullDefaults(void) {
    FlgPullDesc desc;
    flgPullDescInit(&desc, (uint32_t)sizeof desc);
    return desc;
}

static inline FlgPullHandle flgPullHandleDefaults(void) {
    FlgPullHandle handle;
    flgPullHandleInit(&handle, (uint32_t)sizeof handle);
    return handle;
}

static inline FlgPulledDesc flgPulledDefaults(void) {
    FlgPulledDesc desc;
    flgPulledDescInit(&desc, (uint32_t)sizeof desc);
    return desc;
}

static inline FlgPulledView flgPulledViewDefaults(void) {
    FlgPulledView view;
    flgPulledViewInit(&view, (uint32_t)sizeof view);
    return view;
}

static inline FlgPullKeys flgPullKeysDefaults(void) {
    FlgPullKeys keys;
    flgPullKeysInit(&keys, (uint32_t)sizeof keys);
    return keys;
}

#ifdef __cplusplus
}
#endif

#endif
