/* SPDX-License-Identifier: MIT
 * SPDX-FileCopyrightText: 2026 The Filigree authors
 *
 * Debug drawing: what an object holds, as coloured lines and points for the engine's own line drawer. Follows the
 * grammar of filigree.h. The calling thread does the work; there is no job and no allocation.
 *
 *     FlgDebugDrawDesc desc = flgDebugDrawDefaults();
 *     FlgDebugDrawing drawing = flgDebugDrawingDefaults();
 *     flgDebugDrawSurface(context, surface, &desc, &drawing);   counts
 *     ...                                                       room for them: lines, line_capacity, points, ...
 *     flgDebugDrawSurface(context, surface, &desc, &drawing);   writes
 *
 * Parts        `parts` says what to draw; each function lists the parts it knows and those it draws by default. Parts
 *              that an object does not have are left out, so one descriptor serves all objects.
 * Range        A part has elements: curves, triangles, nodes, ... `first` and `count` choose among them. A range beyond
 *              the end is empty. Ranges that follow each other draw everything once: large objects can be drawn over
 *              several frames.
 * Places       In metres, relative to the `origin` of the descriptor: the difference to the object's own origin is
 *              applied in doubles. Drawings in the plane lie at z = 0. Transforms are the host's matter.
 * Results      FLG_NOT_READY until the object's view is ready, its job's error if that failed. FLG_ERROR_LIMIT if an
 *              array is too small; the counts then say how much room it takes, and nothing is written. On all other
 *              failures the counts are 0.
 * Cost         Counting is one pass over the range, writing two. A pass takes about 5 ns for each triangle or point
 *              that is looked at, and for each line 15 ns to count it or 30 ns to write it: the edges of a million
 *              triangles 70 ms, their borders 10 ms.
 */
#ifndef FILIGREE_FILIGREE_DEBUG_H
#define FILIGREE_FILIGREE_DEBUG_H

#include "filigree_live.h"
#include "filigree_model.h"
#include "filigree_motion.h"
#include "filigree_tangle.h"

#ifdef __cplusplus
extern "C" {
#endif

/* What to draw of an object; combined with |. */
typedef enum FlgDebugPart {
    FLG_DEBUG_PART_LINES = 1,         /* its own lines: curves, arcs, bones, wireframes */
    FLG_DEBUG_PART_POINTS = 2,        /* its points, vertices, nodes, joints or keys */
    FLG_DEBUG_PART_FRAMES = 4,        /* axes at its points: tangent red, normal green, second normal blue */
    FLG_DEBUG_PART_EDGES = 8,         /* the edges of its triangles, each once */
    FLG_DEBUG_PART_BORDERS = 16,      /* its borders: of surfaces, regions and contours */
    FLG_DEBUG_PART_SEAMS = 32,        /* points where a result stops copying one run of its style */
    FLG_DEBUG_PART_GUIDE = 64,        /* a style's guide */
    FLG_DEBUG_PART_DISPLACEMENT = 128, /* lines from a style's guide to the style */
    FLG_DEBUG_PART_SEEDS = 256,       /* where a tangle's operators start */
    FLG_DEBUG_PART_CLEARANCE = 512,   /* how far curves keep from obstacles */
    FLG_DEBUG_PART_FORCE_32BIT = 0x7fffffff
} FlgDebugPart;

/* An end of a line, or a point. */
typedef struct FlgDebugVertex {
    float position[3]; /* metres */
    uint32_t color;    /* linear RGBA, 8 bits each, red lowest: on little-endian machines the bytes R, G, B, A */
} FlgDebugVertex;

/* What to draw, and how. */
typedef struct FlgDebugDrawDesc {
    uint32_t struct_size;
    uint32_t parts; /* of FlgDebugPart; 0: those that the function draws by default. Default 0 */
    uint32_t first; /* first element of each part. Default 0 */
    uint32_t count; /* elements of each part, as far as there are so many. Default FLG_UNLIMITED */
    uint32_t every; /* draws frames, displacements, slices and normals of manifolds at every n-th point only; at least
                       1. Default 1 */
    float size;     /* length of the axes of frames and of normals, metres, above 0 and at most 1e30. Default 0.05 */
    uint32_t color; /* of what has no colour of its own, as in FlgDebugVertex. Default 0xffffffff: white */
    uint32_t reserved;
    double origin[3]; /* metres: what the drawing is relative to. Default 0 */
} FlgDebugDrawDesc;

FLG_API FlgResult flgDebugDrawDescInit(FlgDebugDrawDesc* desc, uint32_t struct_size);

/* A drawing. The host owns the arrays; an array that is null is counted, but not written. */
typedef struct FlgDebugDrawing {
    uint32_t struct_size;
    uint32_t line_capacity;  /* lines that `lines` has room for. Default 0 */
    uint32_t point_capacity; /* points that `points` has room for. Default 0 */
    uint32_t line_count;     /* always written */
    uint32_t point_count;    /* likewise */
    uint32_t reserved;
    FlgDebugVertex* lines;  /* 2 per line */
    FlgDebugVertex* points; /* one per point */
} FlgDebugDrawing;

FLG_API FlgResult flgDebugDrawingInit(FlgDebugDrawing* drawing, uint32_t struct_size);

/* Curves. LINES and POINTS; FRAMES, where the set has a NORMAL column; SEAMS, where it has STYLE_INDEX. Tangents are
 * those of the TANGENT column, or between neighbours. Default LINES, FRAMES and SEAMS. Elements: curves. With
 * partial_results the leading curves are drawn. Cost: a pass over the points. */
FLG_API FlgResult flgDebugDrawCurveSet(FlgContext context, FlgCurveSet set, const FlgDebugDrawDesc* desc,
                                       FlgDebugDrawing* drawing);

/* [any thread, one per stroke] A live stroke's points so far, as of a curve set; its tip is not drawn. Default LINES,
 * FRAMES and SEAMS. Elements: curves, of which there is one. As a call of flgLiveStrokeGetPoints, it ends the life of
 * the view before. Cost: a pass over the points. */
FLG_API FlgResult flgDebugDrawLiveStroke(FlgContext context, FlgLiveStroke stroke, const FlgDebugDrawDesc* desc,
                                         FlgDebugDrawing* drawing);

/* A style: LINES, the example as matched to the guide; GUIDE, green; DISPLACEMENT, grey, from guide to example;
 * FRAMES of the guide. Default LINES, GUIDE and DISPLACEMENT. Elements: curves. Cost: a pass over the points. */
FLG_API FlgResult flgDebugDrawStyle(FlgContext context, FlgStyle style, const FlgDebugDrawDesc* desc,
                                    FlgDebugDrawing* drawing);

/* A surface: EDGES, coloured by label; BORDERS, red where there is only one triangle, and coloured by the greater
 * label between labels; POINTS, the vertices. Default BORDERS. Elements: triangles, of POINTS vertices. Cost: a pass
 * over the triangles. */
FLG_API FlgResult flgDebugDrawSurface(FlgContext context, FlgSurface surface, const FlgDebugDrawDesc* desc,
                                      FlgDebugDrawing* drawing);

/* A field: POINTS, the vertices of its surface, from blue (its least value) to red (its greatest); grey where it is
 * infinite. Default POINTS. Elements: vertices. Refuses a field of an earlier revision of its surface. Cost: a pass
 * over the vertices, and 1 ns a vertex of the surface for the least and greatest value. */
FLG_API FlgResult flgDebugDrawField(FlgContext context, FlgField field, const FlgDebugDrawDesc* desc,
                                    FlgDebugDrawing* drawing);

/* Curves on a surface, lifted into space: LINES and POINTS. Default LINES. Elements: curves. Refuses curves of an
 * earlier revision of their surface. Cost: a pass over the points. */
FLG_API FlgResult flgDebugDrawSurfaceCurves(FlgContext context, FlgSurfaceCurves curves, const FlgDebugDrawDesc* desc,
                                            FlgDebugDrawing* drawing);

/* A tangle: BORDERS between regions, coloured by the greater look, grey where none is seen (looks are the same), red
 * where the surface ends; EDGES, coloured by region; SEEDS, the points, samples, lines and first border vertices that
 * the operators started from, coloured by operator. Default BORDERS and SEEDS. Elements: triangles, of SEEDS
 * operators. Places of seeds are those when the operator was applied. Cost: a pass over the triangles, and the
 * operators' seeds. */
FLG_API FlgResult flgDebugDrawTangle(FlgContext context, FlgTangle tangle, const FlgDebugDrawDesc* desc,
                                     FlgDebugDrawing* drawing);

/* A straight skeleton, in the drawing's unit: BORDERS, the contour; LINES, the arcs, and POINTS, their inner nodes,
 * from blue (time 0) to red (the latest). Default all of these. Elements: points of the contour, arcs, nodes. Cost: a
 * pass over points, arcs and nodes, and 1 ns a node for the latest time. */
FLG_API FlgResult flgDebugDrawStraightSkeleton(FlgContext context, FlgStraightSkeleton skeleton,
                                               const FlgDebugDrawDesc* desc, FlgDebugDrawing* drawing);

/* An outline in its place: BORDERS, the contour. Default BORDERS. Elements: rings. Cost: a pass over the points. */
FLG_API FlgResult flgDebugDrawOutline(FlgContext context, FlgOutline outline, const FlgDebugDrawDesc* desc,
                                      FlgDebugDrawing* drawing);

/* A part, in the drawing's unit: BORDERS, the outline; LINES, the axis, green; POINTS, its nodes; FRAMES, the slices
 * across its branches, grey. Default BORDERS and LINES. Elements: rings, arcs, nodes, samples. Cost: a pass over the
 * points. */
FLG_API FlgResult flgDebugDrawPart(FlgContext context, FlgPart part, const FlgDebugDrawDesc* desc,
                                   FlgDebugDrawing* drawing);

/* A part's surface, in the drawing's unit: EDGES. Default EDGES. Elements: triangles. Cost: a pass over the
 * triangles. */
FLG_API FlgResult flgDebugDrawPartMesh(FlgContext context, FlgPartMesh mesh, const FlgDebugDrawDesc* desc,
                                       FlgDebugDrawing* drawing);

/* A model: LINES, a bone from each joint's parent to it, as an octahedron; POINTS, the joints. Both coloured by part.
 * Default both. Elements: joints. Cost: a pass over the joints. */
FLG_API FlgResult flgDebugDrawModel(FlgContext context, FlgModel model, const FlgDebugDrawDesc* desc,
                                    FlgDebugDrawing* drawing);

/* A skin at rest: LINES and POINTS of its joints, as of a model, in one colour; EDGES, coloured by part. Default
 * LINES and POINTS. Elements: joints, of EDGES triangles. Cost: a pass over the joints or triangles. */
FLG_API FlgResult flgDebugDrawSkin(FlgContext context, FlgSkin skin, const FlgDebugDrawDesc* desc,
                                   FlgDebugDrawing* drawing);

/* Obstacles: LINES, their wireframes; CLEARANCE, grey, the same moved outwards by the clearance, without rounding
 * corners. Functions are drawn as their boxes; meshes, layers and borders as the edges of their surface as it is now,
 * and as its box while it changes. The clearance of a mesh is that of its box; layers and borders show none. Default
 * both. Elements: obstacles. Cost: a pass over the obstacles, and over the triangles of meshes. */
FLG_API FlgResult flgDebugDrawObstacles(FlgContext context, FlgObstacles obstacles, const FlgDebugDrawDesc* desc,
                                        FlgDebugDrawing* drawing);

/* A manifold: POINTS on it, and LINES, their outward normals, green. Default both. Meshes and clouds are drawn at their
 * samples; shapes, formulas and grids next to the middles of 16 x 16 x 16 cells, of the grid's box or of a cube of the
 * shape's size around its origin; images of surfaces as those. There is nothing to draw of space itself and of the
 * host's own functions. Elements: samples or cells. Cost: a pass over the samples; 1 to 3 us a cell. */
FLG_API FlgResult flgDebugDrawManifold(FlgContext context, FlgManifold manifold, const FlgDebugDrawDesc* desc,
                                       FlgDebugDrawing* drawing);

/* A spline: LINES, orange if rounds ran out or it stalled (FlgSplineEnding); POINTS, the nodes of the given points,
 * yellow; FRAMES, where the spline has normals. Default LINES and POINTS. Elements: nodes, of POINTS given points. Of
 * more than three coordinates the first three are drawn; of two, z is 0. With partial_results the last round is
 * drawn. Cost: a pass over the nodes. */
FLG_API FlgResult flgDebugDrawSpline(FlgContext context, FlgSpline spline, const FlgDebugDrawDesc* desc,
                                     FlgDebugDrawing* drawing);

/* A motion: LINES, the barycentre's path; FRAMES, the body's axes x, y, z at it in red, green, blue; POINTS, the
 * keys, yellow. Default all of these. Elements: positions, of POINTS keys. With partial_results the last round is
 * drawn. Cost: a pass over the positions. */
FLG_API FlgResult flgDebugDrawMotion(FlgContext context, FlgMotion motion, const FlgDebugDrawDesc* desc,
                                     FlgDebugDrawing* drawing);

/* ---- Defaults by value ------------------------------------------------------------------------------------------- */

static inline FlgDebugDrawDesc flgDebugDrawDefaults(void) {
    FlgDebugDrawDesc desc;
    flgDebugDrawDescInit(&desc, (uint32_t)sizeof desc);
    return desc;
}

static inline FlgDebugDrawing flgDebugDrawingDefaults(void) {
    FlgDebugDrawing drawing;
    flgDebugDrawingInit(&drawing, (uint32_t)sizeof drawing);
    return drawing;
}

#ifdef __cplusplus
}
#endif

#endif
