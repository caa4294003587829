/* SPDX-License-Identifier: MIT
 * SPDX-FileCopyrightText: 2026 The Filigree authors
 *
 * Surfaces: triangle meshes that hold up, geodesic distances, tracing and cutting. It follows the grammar of filigree.h.
 */
#ifndef FILIGREE_FILIGREE_SURFACE_H
#define FILIGREE_FILIGREE_SURFACE_H

#include "filigree.h"

#ifdef __cplusplus
extern "C" {
#endif

/* ---- Meshes -------------------------------------------------------------------------------------------------- */

/* A triangle mesh in flat arrays. Used for input (the host owns the arrays, for the time of the call) and for results. */
typedef struct FlgMeshView {
    uint32_t struct_size;
    uint32_t vertex_count;
    uint32_t triangle_count;
    uint32_t column_count;      /* 1 to 16, each attribute at most once */
    const FlgColumn* columns;   /* one value a vertex; POSITION is needed, the others are carried along */
    const uint32_t* triangles;  /* 3 vertices a triangle, counter-clockwise seen from outside */
    const uint32_t* regions;    /* a label a triangle; null: all 0 */
} FlgMeshView;

#ifdef __cplusplus
}
#endif

#endif
