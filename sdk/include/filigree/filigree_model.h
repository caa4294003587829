/* SPDX-License-Identifier: MIT
 * SPDX-FileCopyrightText: 2026 The Filigree authors
 *
 * Models of drawn parts: one surface, bound to one tree of joints. It follows the grammar of filigree.h.
 */
#ifndef FILIGREE_FILIGREE_MODEL_H
#define FILIGREE_FILIGREE_MODEL_H

#include "filigree_skeleton.h"
#include "filigree_surface.h"

#ifdef __cplusplus
extern "C" {
#endif

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
    const char* const* joint_names;
} FlgSkinView;

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
 * Reads the skin's joints alone. Cost: about 100 ns a joint; takes no memory for up to 256 joints, else 56 bytes a joint of the
 * C++ runtime's. */
FLG_API FlgResult flgSkinPose(const FlgSkinView* skin, const float* rotations, const float* translation,
                              float* out_matrices, float* out_dual_quaternions);

/* The pose of an animation at a time, ready for flgSkinPose: between keys rotations turn evenly the short way, translations
 * go straight; before the first key and after the last they stay.
 *   joint_count      the skin's
 *   time             seconds, finite
 *   out_rotations    4 a joint
 *   out_translation  3, or null; 0 if the animation moves no roots
 * Cost: about 50 ns a joint, 1 ns a key: all times are checked, and of the rest the two keys that are used. */
FLG_API FlgResult flgSkinAnimationSample(const FlgSkinAnimation* animation, uint32_t joint_count, float time,
                                         float* out_rotations, float* out_translation);

/* Moves the vertices by the processor: what the graphics card's shader must come to.
 *   transforms     what flgSkinPose made: 12 a joint (FLG_SKINNING_LINEAR) or 8 (FLG_SKINNING_DUAL_QUATERNION)
 *   out_positions  3 a vertex
 *   out_normals    3 a vertex, of length 1, turned as their vertices are; null: not wanted
 * Dual quaternions that mean the same with another sign are told by the joint with a vertex' largest weight. Weights must
 * come to 1 within 0.0001, the first being the largest. Cost: about 50 ns a vertex, one pass to check and one to move. */
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

#ifdef __cplusplus
}
#endif

#endif
