/* SPDX-License-Identifier: MIT
 * SPDX-FileCopyrightText: 2026 The Filigree authors
 *
 * Ornament as maps: what a tangle divided, drawn into the texture coordinates of the mesh that its surface was made of,
 * for assets whose triangles must stay as they are. Follows the grammar of filigree.h and filigree_tangle.h.
 *
 * Maps         Square, `size` texels a side, rows from the top, tightly packed, in the host's memory. Texture
 *              coordinates 0 0 are the upper left corner of the first texel, 1 1 the lower right one of the last. A
 *              texel shows what is at its centre.
 * Charts       What triangles cover. Each texel is covered once: overlapping triangles are refused.
 * Padding      Texels up to `padding` texels from a chart are copies of the chart's nearest texel (of equally near
 *              ones, that in the nearest column), so that filters and mip levels meet no background: level k needs
 *              2^k texels. Texels farther away are background.
 * Shape        Maps are for the mesh as it was before displacement: lengths are measured on it.
 */
#ifndef FILIGREE_FILIGREE_BAKE_H
#define FILIGREE_FILIGREE_BAKE_H

#include "filigree_tangle.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The most texels a side. */
#define FLG_BAKE_MAX_SIZE 16384u
/* The most texels of padding. */
#define FLG_BAKE_MAX_PADDING 256u

/* What is drawn, and where to: null maps are not wanted, one at least is. */
typedef struct FlgTangleBakeDesc {
    uint32_t struct_size;
    uint32_t size; /* texels a side: 1 to FLG_BAKE_MAX_SIZE. Default 1024 */
    const FlgJobOptions* job;
    FlgTangle tangle;         /* of a surface with FlgSurfaceDesc.provenance */
    const FlgMeshView* mesh;  /* what the surface was made of; copied */
    const float* corner_uvs;  /* 6 per triangle of `mesh`: texture coordinates of its corners, 0 to 1; copied */
    uint32_t mesh_region;     /* draws only triangles of `mesh` with this label: of a mesh whose materials have textures
                                 of their own, each has maps of its own. Default FLG_NO_INDEX: all */
    uint32_t padding;         /* texels, 0 to FLG_BAKE_MAX_PADDING. Default 16 */
    float border_width;       /* of the lines in `borders`, metres, >= 0 and finite. Default 0.01 */
    uint32_t component_count; /* of `blends`, 1 to 16 where that is wanted. Default 0 */
    const float* blend_values; /* by region of the tangle, component_count each, finite: colours, roughness; copied */
    uint32_t region_count;    /* that have values; at least the tangle's */
    uint32_t reserved;
    uint32_t* ids;      /* 1 per texel: the leaf there, the label of its triangles. Background: FLG_NO_INDEX */
    float* distances;   /* 1: metres to the nearest border that is seen, by the straight line to one of the pieces that
                           are nearest to the corners of the cut triangle there. That is never less than the distance
                           to the border; inside triangles much larger than the pattern it may be more, by at most
                           about twice the way to the nearest corner. Infinite where there is no border, and in the
                           background */
    uint8_t* borders;   /* 1: how much of the texel a line along the borders that are seen covers, 0 to 255.
                           Background: 0 */
    float* heights;     /* 1: how far displacement raised the surface along the mesh's smooth normals, metres; below
                           0: sunk. Background: 0 */
    float* normals;     /* 3: the displaced surface's, of length 1, relative to the mesh's: x along rising u, y along
                           falling v (up in the picture, as in glTF), z outwards. Background: 0 0 1 */
    float* blends;      /* component_count: blend_values of the leaf; across borders that are seen, the mean of both
                           sides by how much of the texel they cover. Background: 0 */
} FlgTangleBakeDesc;

FLG_API FlgResult flgTangleBakeDescInit(FlgTangleBakeDesc* desc, uint32_t struct_size);

/* Starts a job that draws maps of a tangle as it is after the changes that were started before; later changes wait for
 * the job. It writes the maps and, for the padding, reads them back, on a worker or inside flgContextTick: they must
 * live until it is published, and must not overlap. A job that fails or is cancelled may have written a part.
 * Fails with FLG_ERROR_INVALID_ARGUMENT if a texture coordinate is not finite or outside 0 to 1, if triangles overlap,
 * if none covers a texel, or if `mesh` is not what the surface was made of. Cost: about 60 ns a texel that is covered,
 * and 0.5 us a triangle of the surface. */
FLG_API FlgResult flgTangleBake(FlgContext context, const FlgTangleBakeDesc* desc, FlgJob* out_job);

static inline FlgTangleBakeDesc flgTangleBakeDefaults(void) {
    FlgTangleBakeDesc desc;
    flgTangleBakeDescInit(&desc, (uint32_t)sizeof desc);
    return desc;
}

#ifdef __cplusplus
}
#endif

#endif
