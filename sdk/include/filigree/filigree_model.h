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

#ifdef __cplusplus
}
#endif

#endif
