/* SPDX-License-Identifier: MIT
 * SPDX-FileCopyrightText: 2026 The Filigree authors
 *
 * Models of drawn parts (Ma, Wang, Li, Zhang: Real-time skeletonization for sketch-based modeling, 2021). It follows the grammar
 * of filigree.h.
 *
 * Part         A contour with its axis, in its own plane: made once a contour is drawn.
 * Model        Parts put in their places, and one tree of joints for all. Another place for a part, or another threshold, is another
 *              model of the same parts, which takes a tenth of a ms; so a part that is dragged shows its bones in each frame.
 * Skin         A model's surface in one piece, bound to its joints.
 *
 * All three never change once ready, and keep what they were made of alive. Lengths of a drawing are in its own unit; a part's
 * placement takes them to the model's space, in metres.
 */
#ifndef FILIGREE_FILIGREE_MODEL_H
#define FILIGREE_FILIGREE_MODEL_H

#include "filigree_skeleton.h"
#include "filigree_surface.h"

#ifdef __cplusplus
extern "C" {
#endif

/* What a surface covers as seen from afar, as a contour. Never changes once ready. */
FLG_HANDLE(FlgOutline);
/* A drawn contour with its axis. Never changes once ready. */
FLG_HANDLE(FlgPart);
/* A part's own inflated surface. Never changes once ready. */
FLG_HANDLE(FlgPartMesh);
/* Parts in their places and one tree of joints. Never changes once ready. */
FLG_HANDLE(FlgModel);
/* A model's surface, bound to its joints. Never changes once ready. */
FLG_HANDLE(FlgSkin);

/* ---- Outlines of what nobody drew ------------------------------------------------------------------------------ */

typedef struct FlgOutlineDesc {
    uint32_t struct_size;
    uint32_t region_count;
    FlgJobOptions job;
    FlgSurface surface;
    const uint32_t* regions; /* labels of the surface; null: all of it. Copied */
    float direction[3];      /* to where it is looked at from, of any length; 0 0 0: to where its triangles look on the average,
                                which suits flat regions. Default 0 0 0 */
    uint32_t reserved;
} FlgOutlineDesc;

FLG_API FlgResult flgOutlineDescInit(FlgOutlineDesc* desc, uint32_t struct_size);

/* Starts a job that finds what a surface, or regions of it, covers when it is looked at from afar: its silhouette, or the border
 * of a flat region; of several pieces the largest, with its holes. Fails if there are no such triangles or nothing is seen, and
 * without a direction if all sides are alike, as those of a closed surface. Cost: 40 ns a triangle and 3 us a side of the borders. */
FLG_API FlgResult flgOutlineCreate(FlgContext context, const FlgOutlineDesc* desc, FlgOutline* out_outline, FlgJob* out_job);

/* Ready to be a part: `contour` for FlgPartDesc, `placement` for FlgModelPart. */
typedef struct FlgOutlineView {
    uint32_t struct_size;
    uint32_t reserved;
    FlgContourView contour; /* metres, in the plane through the middle of the triangles; y is up as far as it can be */
    double placement[12];   /* takes it back to where the surface is */
} FlgOutlineView;

FLG_API FlgResult flgOutlineViewInit(FlgOutlineView* view, uint32_t struct_size);

/* The arrays live until the outline is released. FLG_NOT_READY before its job is published, its error if it failed. */
FLG_API FlgResult flgOutlineGetView(FlgContext context, FlgOutline outline, FlgOutlineView* out_view);

FLG_API FlgResult flgOutlineRelease(FlgContext context, FlgOutline outline);

/* ---- Parts ----------------------------------------------------------------------------------------------------- */

/* Shares are of the part's length: that of the contour's ring 0 as it is drawn, but three times the diagonal of its box at most
 * (a frayed line is not a larger drawing). */
typedef struct FlgPartDesc {
    uint32_t struct_size;
    uint32_t repair;  /* nonzero: the contour may cross and touch itself, as FlgStraightSkeletonDesc has it. Default 0 */
    FlgJobOptions job;
    FlgContourView contour;
    double spacing;   /* the drawn line gets points so far apart, a share: 0.0005 to 0.1, default 0.005; 0: as drawn */
    double tolerance; /* the axis is that of an outline within this of the line, a share: 0 to 0.1, default 0.0015 */
    double collapse;  /* arcs of the axis shorter than this share of their mean length vanish: 0 to 10, default 0.5 */
} FlgPartDesc;

FLG_API FlgResult flgPartDescInit(FlgPartDesc* desc, uint32_t struct_size);

/* Starts a job that finds the axis of a contour, sec. 3.1 of the paper: points at equal distances, those of them that matter (the
 * outline), its straight skeleton without what ends on the outline and without short arcs, its branches as smooth curves, and
 * slices across them. Where the outline would cross itself the tolerance is made smaller, down to the line as it is drawn.
 * What is wrong with a contour is said as by flgStraightSkeletonCreate; crossings much smaller than the spacing may be
 * smoothed away. Around a hole the axis goes on one side only: bones can't
 * go in circles. Cost: 0.1 to 0.3 ms for a drawn contour. */
FLG_API FlgResult flgPartCreate(FlgContext context, const FlgPartDesc* desc, FlgPart* out_part, FlgJob* out_job);

/* A point of a branch's axis, with the slice across it. */
typedef struct FlgAxisSample {
    double x, y;           /* on the axis */
    double left_x, left_y; /* the unit vector to the left of the axis */
    double left, right;    /* how far the slice goes to either side: to the outline, or to twice the room around the axis */
} FlgAxisSample;

typedef struct FlgPartView {
    uint32_t struct_size;
    uint32_t outline_count;         /* points */
    const double* outline;          /* 2 a point */
    const uint32_t* outline_rings;  /* ring_count + 1 values: where each ring begins, and outline_count */
    uint32_t ring_count;
    uint32_t node_count;            /* of the axis: at least 1 */
    const double* nodes;            /* 3 a node: x, y, and the radius of a disc around it that is inside of the outline */
    const uint32_t* arcs;           /* 2 an arc: nodes; node_count - 1 arcs */
    const FlgAxisSample* samples;   /* of all branches, one behind the other */
    const uint32_t* branches;       /* 4 a branch: nodes where it begins and ends; its first sample, and one beyond its last */
    uint32_t sample_count;
    uint32_t branch_count;          /* 0 if the axis is one node */
    double length;                  /* what shares are of */
} FlgPartView;

FLG_API FlgResult flgPartViewInit(FlgPartView* view, uint32_t struct_size);

/* The arrays live until the part is released. FLG_NOT_READY before its job is published, its error if it failed. */
FLG_API FlgResult flgPartGetView(FlgContext context, FlgPart part, FlgPartView* out_view);

FLG_API FlgResult flgPartRelease(FlgContext context, FlgPart part);

/* ---- Bodies of parts --------------------------------------------------------------------------------------------- */

typedef struct FlgPartMeshDesc {
    uint32_t struct_size;
    float thickness; /* 0.01 to 100, default 1: a disc becomes a ball, a long strip a tube 1.4 times as deep as it is wide */
    FlgJobOptions job;
    FlgPart part;
    double spacing;  /* length of edges, in units of the drawing, 1e-4 to 1 of the part's length; 0: by itself, for 500 to 3,000
                        vertices. Default 0 */
} FlgPartMeshDesc;

FLG_API FlgResult flgPartMeshDescInit(FlgPartMeshDesc* desc, uint32_t struct_size);

/* Starts a job that inflates a part, sec. 4.1: a triangulation of the contour with points inside, the height over it by a Poisson
 * equation, and both of its sides. The surface is closed and a manifold, around holes too. Cost: 3 ms for 700 vertices. */
FLG_API FlgResult flgPartMeshCreate(FlgContext context, const FlgPartMeshDesc* desc, FlgPartMesh* out_mesh, FlgJob* out_job);

typedef struct FlgPartMeshView {
    uint32_t struct_size;
    uint32_t vertex_count;
    uint32_t triangle_count;
    uint32_t reserved;
    const float* positions;    /* 3 a vertex, units of the drawing; z is the height above its plane */
    const uint32_t* triangles; /* 3 a triangle, counter-clockwise as seen from outside */
} FlgPartMeshView;

FLG_API FlgResult flgPartMeshViewInit(FlgPartMeshView* view, uint32_t struct_size);

/* The arrays live until the mesh is released. FLG_NOT_READY before its job is published, its error if it failed. */
FLG_API FlgResult flgPartMeshGetView(FlgContext context, FlgPartMesh mesh, FlgPartMeshView* out_view);

FLG_API FlgResult flgPartMeshRelease(FlgContext context, FlgPartMesh mesh);

/* ---- Models ---------------------------------------------------------------------------------------------------- */

/* How fine the bones are. Shares are of the model's size, the largest length of its parts as placed; the defaults are
 * the paper's pixels where that is 2,000 pixels. 0 to 10 each. */
typedef struct FlgBoneThresholds {
    float simplify; /* joints along a branch keep axis and shape to within this; default 0.0025 */
    float merge;    /* junctions nearer to each other along the bones become one; default 0.015 */
    float prune;    /* branches to an end that are shorter are removed; default 0.015 */
    float collapse; /* bones shorter than this, with bones at both ends, vanish; default 0.005 */
} FlgBoneThresholds;

/* A part, where it is in a model, and how it is refined there. */
typedef struct FlgModelPart {
    FlgPart part;       /* may be used more than once, and be in the making */
    const char* name;   /* UTF-8, 1 to 63 bytes, each part another; null: "part" and its number */
    double placement[12]; /* rows of a 3 x 4 matrix that takes (x, y, 0, 1) to the model's space: rotation, one scale, translation,
                             mirrored or not. Default: as drawn */
    float thickness;    /* how deep the part is against the paper's inflation: 0.01 to 100, default 1; a disc becomes a ball */
    /* Parts that overlap become one piece, whose weights blend: keep legs that should move apart, apart. */
    uint32_t mirrored;  /* nonzero: the part is there a second time, mirrored at desc.mirror; names end with .L and .R, .L
                           for the one on the side of the plane's normal. Default 0 */
    const FlgBoneThresholds* thresholds; /* null: the model's */
    const float* branch_simplify;        /* one a branch of the part, negative: the part's; null: all the part's */
    uint32_t branch_count;               /* the part's, where branch_simplify is given */
    uint32_t reserved;
} FlgModelPart;

typedef struct FlgModelDesc {
    uint32_t struct_size;
    uint32_t part_count;       /* 1 to 4096 */
    FlgJobOptions job;
    const FlgModelPart* parts; /* in the order they were modelled: a part hangs on an earlier one */
    FlgBoneThresholds thresholds;
    float shape_weight;        /* how much the shape counts in `simplify`, alpha_s of Eq. 1 (the paper gives
                                  no number): 0 to 100, default 0.25 */
    /* A plane a x + b y + c z = d, its normal of any length above 0, pointing to the model's left (of one that looks along +x, y up:
     0 0 -1). A part across it is doubled where it is. Default 1 0 0 0 */
    float mirror[4];
    uint32_t reserved;
} FlgModelDesc;

FLG_API FlgResult flgModelPartInit(FlgModelPart* part);
FLG_API FlgResult flgModelDescInit(FlgModelDesc* desc, uint32_t struct_size);

/* Starts a job that makes one skeleton of the parts', sec. 3.1 (BoundedDP), 3.2 and 3.3 of the paper: joints along the branches,
 * parts connected, junctions merged, short branches and bones removed. A part that meets no earlier one is a root of its own.
 * FLG_ERROR_LIMIT with more than 65535 joints. Cost: about 12 us a part. */
FLG_API FlgResult flgModelCreate(FlgContext context, const FlgModelDesc* desc, FlgModel* out_model, FlgJob* out_job);

/* How a part came to the model. */
typedef enum FlgPartEvent {
    FLG_PART_ROOT = 0,          /* it meets no earlier part */
    FLG_PART_BONE_SPLIT = 1,    /* a new joint on a bone of the part it hangs on */
    FLG_PART_JOINT_CONNECT = 2, /* a bone from one of that part's joints */
    FLG_PART_EVENT_FORCE_32BIT = 0x7fffffff
} FlgPartEvent;

/* Where a part came to hang. */
typedef struct FlgModelPartInfo {
    FlgPartEvent event;    /* how it was connected, before bones were refined */
    uint32_t parent;       /* the part it hangs on; FLG_NO_INDEX: none */
    uint32_t joint;        /* its own nearest to the root, which swings it; if it has none left, the one that moves it */
    uint32_t source;       /* which of the host's parts it is */
    uint32_t twin;         /* the part that is its mirror image; FLG_NO_INDEX: none */
    uint32_t is_mirrored;  /* 1: it is the image, not what was drawn */
} FlgModelPartInfo;

/* Joints with their parents first. The bone to a joint turns with its parent. */
typedef struct FlgModelView {
    uint32_t struct_size;
    uint32_t joint_count;          /* at least 1 */
    const float* joint_positions;  /* 3 a joint, metres */
    const float* joint_radii;      /* of the shape around the joint, metres */
    const uint32_t* joint_parents; /* FLG_NO_INDEX: a root */
    const uint32_t* joint_parts;   /* the part that each lies in */
    const char* const* joint_names; /* of the part, then a number: tail_0, tail_1, ..., arm_0.L, ... */
    const FlgModelPartInfo* parts; /* with mirror images, each after its original */
    uint32_t part_count;
    float size;                    /* what thresholds are shares of, metres */
} FlgModelView;

FLG_API FlgResult flgModelViewInit(FlgModelView* view, uint32_t struct_size);

/* The arrays live until the model is released. FLG_NOT_READY before its job is published, its error if it failed. */
FLG_API FlgResult flgModelGetView(FlgContext context, FlgModel model, FlgModelView* out_view);

FLG_API FlgResult flgModelRelease(FlgContext context, FlgModel model);

/* ---- Skins ----------------------------------------------------------------------------------------------------- */

/* A surface in one piece and the joints that move it, in the pose of rest: joints are not turned. */
typedef struct FlgSkinView {
    uint32_t struct_size;
    uint32_t vertex_count;
    uint32_t triangle_count;
    uint32_t joint_count;          /* 1 to 65535 */
    const float* positions;        /* 3 a vertex, metres */
    const float* normals;          /* 3 a vertex, of length 1 */
    const uint32_t* triangles;     /* 3 a triangle, counter-clockwise as seen from outside */
    const uint16_t* vertex_joints; /* 4 a vertex: what moves it, the largest weight first; unused ones are 0 */
    const float* vertex_weights;   /* 4 a vertex: 0 to 1, their sum is 1; unused ones are 0 */
    const uint32_t* vertex_parts;  /* one a vertex: the part it lies on */
    const float* joint_positions;  /* 3 a joint, metres, in the model's space */
    const uint32_t* joint_parents; /* one a joint, lower than its own number; FLG_NO_INDEX: a root */
    const char* const* joint_names; /* one a joint, UTF-8, each another; null in input: none */
} FlgSkinView;

typedef struct FlgSkinDesc {
    uint32_t struct_size;
    uint32_t vertex_count;      /* about so many, within 15 %, if no part is too thin for that: 100 to most_vertices, default 10000 */
    FlgJobOptions job;
    FlgModel model;
    uint32_t most_vertices;     /* what thin parts may make of it: 100 to 4194304, default 200000 */
    float blend;                /* where parts cross the edge is rounded over this length: metres, up to 1e30; below 0: by itself,
                                   0.15 of the smaller part's radius; 0: not. Default -1 */
} FlgSkinDesc;

FLG_API FlgResult flgSkinDescInit(FlgSkinDesc* desc, uint32_t struct_size);

/* Starts a job that makes one closed surface of all parts of a model, a manifold however they meet, and binds it to the joints:
 * weights are smooth, 0 to 1, at most 4 a vertex, and a part moves with its own bones. Parts that meet no other stay pieces
 * of their own. FLG_ERROR_LIMIT if the thinnest part would need more than most_vertices, or if a part lies further from the
 * origin than 1e7 sides of the triangles that vertex_count asks for. Cost: 15 us a vertex. */
FLG_API FlgResult flgSkinCreate(FlgContext context, const FlgSkinDesc* desc, FlgSkin* out_skin, FlgJob* out_job);

/* The arrays live until the skin is released. FLG_NOT_READY before its job is published, its error if it failed. */
FLG_API FlgResult flgSkinGetView(FlgContext context, FlgSkin skin, FlgSkinView* out_view);

FLG_API FlgResult flgSkinRelease(FlgContext context, FlgSkin skin);

/* A motion of a skin's joints. */
typedef struct FlgSkinAnimation {
    uint32_t struct_size;
    uint32_t key_count;        /* at least 1 */
    const char* name;          /* UTF-8 */
    const float* times;        /* one a key, seconds, rising from 0 or later */
    const float* rotations;    /* 4 a joint, joint by joint, key by key: x, y, z, w of length 1, within the parent's frame */
    const float* translations; /* 3 a key: how far all roots are moved, metres; null: not at all */
} FlgSkinAnimation;

/* ---- Poses of skins ---------------------------------------------------------------------------------------------
 * [any thread] All functions here: they need no context and keep nothing. They refuse what can't be used before they write
 * anything: arrays are then as they were. A joint that is turned turns all that hangs on it, about its own place:
 * bones keep their lengths. */

FLG_API FlgResult flgSkinViewInit(FlgSkinView* view, uint32_t struct_size);

FLG_API FlgResult flgSkinAnimationInit(FlgSkinAnimation* animation, uint32_t struct_size);

/* How a vertex follows several joints. */
typedef enum FlgSkinning {
    FLG_SKINNING_LINEAR = 0,          /* the mean of where each takes it: thin where joints are twisted */
    FLG_SKINNING_DUAL_QUATERNION = 1, /* one rigid motion between theirs: keeps its girth, bulges a little in sharp bends */
    FLG_SKINNING_FORCE_32BIT = 0x7fffffff
} FlgSkinning;

/* Where a pose takes each joint, from rest.
 *   rotations             4 a joint: x, y, z, w of length 1 within 0.001, within the parent's frame, as in FlgSkinAnimation;
 *                         null: none is turned
 *   translation           3: how far all roots are moved, metres; null: not at all
 *   out_matrices          12 a joint, or null: three rows of four. (x, y, z, 1) at rest times the rows is the place in the pose
 *   out_dual_quaternions  8 a joint, or null: x, y, z, w of the rotation r, then those of (t r) / 2, where t moves after it
 * Reads the skin's joints alone. Cost: about 50 ns a joint; takes no memory for up to 256 joints, else 56 bytes a joint of the
 * C++ runtime's. */
FLG_API FlgResult flgSkinPose(const FlgSkinView* skin, const float* rotations, const float* translation,
                              float* out_matrices, float* out_dual_quaternions);

/* The pose of an animation at a time, ready for flgSkinPose: between keys rotations turn evenly the short way, translations
 * go straight; before the first key and after the last they stay.
 *   joint_count      the skin's
 *   time             seconds, finite
 *   out_rotations    4 a joint
 *   out_translation  3, or null; 0 if the animation moves no roots
 * Cost: about 80 ns a joint, 1 ns a key: all times are checked, and of the rest the two keys that are used. */
FLG_API FlgResult flgSkinAnimationSample(const FlgSkinAnimation* animation, uint32_t joint_count, float time,
                                         float* out_rotations, float* out_translation);

/* Moves the vertices by the processor: what the graphics card's shader must come to.
 *   transforms     what flgSkinPose made: 12 a joint (FLG_SKINNING_LINEAR) or 8 (FLG_SKINNING_DUAL_QUATERNION)
 *   out_positions  3 a vertex
 *   out_normals    3 a vertex, of length 1, turned as their vertices are; null: not wanted
 * Dual quaternions that mean the same with another sign are told by the joint with a vertex' largest weight. Weights must
 * come to 1 within 0.0001, the first being the largest. Cost: about 0.1 us a vertex, one pass to check and one to move. */
FLG_API FlgResult flgSkinDeform(const FlgSkinView* skin, FlgSkinning skinning, const float* transforms,
                                float* out_positions, float* out_normals);

static inline FlgSkinView flgSkinViewDefaults(void) {
    FlgSkinView view;
    flgSkinViewInit(&view, (uint32_t)sizeof view);
    return view;
}

static inline FlgSkinAnimation flgSkinAnimationDefaults(void) {
    FlgSkinAnimation animation;
    flgSkinAnimationInit(&animation, (uint32_t)sizeof animation);
    return animation;
}

/* ---- Defaults by value, parts and models --------------------------------------------------------------------------- */

static inline FlgOutlineDesc flgOutlineDefaults(void) {
    FlgOutlineDesc desc;
    flgOutlineDescInit(&desc, (uint32_t)sizeof desc);
    return desc;
}

static inline FlgOutlineView flgOutlineViewDefaults(void) {
    FlgOutlineView view;
    flgOutlineViewInit(&view, (uint32_t)sizeof view);
    return view;
}

static inline FlgPartDesc flgPartDefaults(void) {
    FlgPartDesc desc;
    flgPartDescInit(&desc, (uint32_t)sizeof desc);
    return desc;
}

static inline FlgPartView flgPartViewDefaults(void) {
    FlgPartView view;
    flgPartViewInit(&view, (uint32_t)sizeof view);
    return view;
}

static inline FlgPartMeshDesc flgPartMeshDefaults(void) {
    FlgPartMeshDesc desc;
    flgPartMeshDescInit(&desc, (uint32_t)sizeof desc);
    return desc;
}

static inline FlgPartMeshView flgPartMeshViewDefaults(void) {
    FlgPartMeshView view;
    flgPartMeshViewInit(&view, (uint32_t)sizeof view);
    return view;
}

static inline FlgSkinDesc flgSkinDefaults(void) {
    FlgSkinDesc desc;
    flgSkinDescInit(&desc, (uint32_t)sizeof desc);
    return desc;
}

static inline FlgModelPart flgModelPartDefaults(void) {
    FlgModelPart part;
    flgModelPartInit(&part);
    return part;
}

static inline FlgModelDesc flgModelDefaults(void) {
    FlgModelDesc desc;
    flgModelDescInit(&desc, (uint32_t)sizeof desc);
    return desc;
}

static inline FlgModelView flgModelViewDefaults(void) {
    FlgModelView view;
    flgModelViewInit(&view, (uint32_t)sizeof view);
    return view;
}

#ifdef __cplusplus
}
#endif

#endif
