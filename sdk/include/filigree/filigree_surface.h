/* SPDX-License-Identifier: MIT
 * SPDX-FileCopyrightText: 2026 The Filigree authors
 *
 * Surfaces: robust triangle meshes, geodesic distances, tracing, sampling and cutting (Nazzaro, Puppo, Pellacini:
 * geoTangle, 2021, sec. 3 and 4). Follows the grammar of filigree.h.
 *
 * Order        A job sees its surface as it was when the job was started. Jobs that read a surface run side by side. A
 *              job that changes it (a cut) runs after all jobs started before it and before all jobs started later. The
 *              host need not wait.
 * Revisions    A surface counts its changes. Fields and curves belong to the revision they were started on; using them
 *              with another gives FLG_ERROR_INVALID_ARGUMENT. (A change counts when it is started, even if it fails
 *              later.)
 * Regions      Each triangle has a label, 0 to FLG_REGION_MAX. Functions that take `regions` stay on triangles with
 *              these labels, and so do their paths; null means the whole surface.
 */
#ifndef FILIGREE_FILIGREE_SURFACE_H
#define FILIGREE_FILIGREE_SURFACE_H

#include "filigree.h"

#ifdef __cplusplus
extern "C" {
#endif

/* A mesh with its adjacency and data for geodesics. Cutting changes it. */
FLG_HANDLE(FlgSurface);
/* One value per vertex of a surface. Never changes once ready. */
FLG_HANDLE(FlgField);
/* Curves on a surface, straight in each triangle. Never change once ready. */
FLG_HANDLE(FlgSurfaceCurves);

/* The largest triangle label. */
#define FLG_REGION_MAX 0xffffffu

/* ---- Meshes -------------------------------------------------------------------------------------------------- */

/* A triangle mesh in flat arrays. Used for input (the host owns the arrays, which must live for the call) and for
 * results. */
typedef struct FlgMeshView {
    uint32_t struct_size;
    uint32_t vertex_count;
    uint32_t triangle_count;
    uint32_t column_count;      /* 1 to 16, each attribute at most once */
    const FlgColumn* columns;   /* one value per vertex; POSITION is required, others are carried along */
    const uint32_t* triangles;  /* 3 vertices per triangle, counter-clockwise seen from outside */
    const uint32_t* regions;    /* one label per triangle; null: all 0 */
    double origin[3];           /* metres: what positions are relative to. Default 0 */
} FlgMeshView;

FLG_API FlgResult flgMeshViewInit(FlgMeshView* view, uint32_t struct_size);

/* [any thread] The view's column of an attribute, null if there is none. */
FLG_API const FlgColumn* flgMeshViewGetColumn(const FlgMeshView* view, FlgAttribute attribute);

typedef struct FlgSurfaceDesc {
    uint32_t struct_size;
    /* Vertices up to this distance apart are merged, metres, >= 0; 0: only vertices at the same place, to the bit.
     * Below 0: none. Default 0. */
    float weld_distance;
    const FlgJobOptions* job;
    const FlgMeshView* mesh; /* copied */
    /* Nonzero: flgSurfaceGetProvenance can be asked where triangles lie on `mesh`. 20 bytes a vertex, 4 a triangle and
     * 12 a triangle of `mesh`. Default 0. */
    uint32_t provenance;
    uint32_t reserved;
} FlgSurfaceDesc;

FLG_API FlgResult flgSurfaceDescInit(FlgSurfaceDesc* desc, uint32_t struct_size);

/* Starts a job that makes a manifold surface from any triangles; flgSurfaceGetReport reports its repairs. This call
 * copies the arrays: about 10 ms for 2 million triangles. The job fails with FLG_ERROR_INVALID_ARGUMENT if an index is
 * out of range, a position is not finite, or no triangle is left; also if the mesh lies so far from its origin that
 * floats cannot hold its shape: if most edges are shorter than 8 times the spacing of floats at their ends. Cost: about
 * 0.3 us a triangle. */
FLG_API FlgResult flgSurfaceCreate(FlgContext context, const FlgSurfaceDesc* desc, FlgSurface* out_surface,
                                   FlgJob* out_job);

/* The same with all defaults for plain arrays: 3 floats a vertex, metres, and 3 vertices a triangle. Cost: that of
 * flgSurfaceCreate. */
FLG_API FlgResult flgSurfaceCreateFromTriangles(FlgContext context, const float* positions, uint32_t vertex_count,
                                                const uint32_t* triangles, uint32_t triangle_count,
                                                const FlgJobOptions* job, FlgSurface* out_surface, FlgJob* out_job);

/* Defects found in the input, their repairs, and properties of the surface. */
typedef struct FlgSurfaceReport {
    uint32_t struct_size;
    uint32_t welded_vertices;         /* merged into another vertex */
    uint32_t unused_vertices;         /* dropped: no triangle uses them */
    uint32_t degenerate_triangles;    /* dropped: they use a vertex twice */
    uint32_t duplicate_triangles;     /* dropped: the same three vertices as another, in any order */
    uint32_t flipped_triangles;       /* reversed, to match their neighbours' winding */
    uint32_t crowded_edges;           /* had more than two triangles: joined in pairs, the rest separated */
    uint32_t cut_edges;               /* opened because their two sides cannot stay joined (Moebius strips, crowded
                                         edges) */
    uint32_t split_vertices;          /* vertices added where triangles formed several fans */
    uint32_t flat_triangles;          /* kept: height below 1e-6 of the longest edge */
    uint32_t vertex_count;
    uint32_t triangle_count;
    uint32_t component_count;         /* pieces not joined by any edge */
    uint32_t border_count;            /* closed chains of border edges */
    uint32_t border_edges;            /* edges with one triangle */
    uint32_t genus;                   /* handles, over all components */
    int64_t euler_number;             /* vertices - edges + triangles */
    double area;                      /* square metres */
    float box_min[3], box_max[3];     /* of the positions, metres, relative to `origin` */
    const uint32_t* vertex_of_input;  /* one per input vertex: its index in the surface, FLG_NO_INDEX if dropped (for a
                                         split vertex, that of its first fan); null if no index changed. Lives until the
                                         surface is released */
    uint32_t input_vertex_count;
    uint32_t reserved;
    double origin[3];                 /* the input mesh's */
} FlgSurfaceReport;

FLG_API FlgResult flgSurfaceReportInit(FlgSurfaceReport* report, uint32_t struct_size);

/* The report of the job that made the surface; FLG_NOT_READY until it is published, the job's error if it failed. Cuts
 * do not change it. Cost: tens of nanoseconds. */
FLG_API FlgResult flgSurfaceGetReport(FlgContext context, FlgSurface surface, FlgSurfaceReport* out_report);

typedef struct FlgSurfaceView {
    uint32_t struct_size;
    uint32_t revision;          /* changes so far */
    const FlgMeshView* mesh;    /* never null; lives as long as its arrays */
    const uint32_t* neighbours; /* 3 per triangle: across the edges from corner k to corner k + 1; FLG_NO_INDEX at a
                                   border */
} FlgSurfaceView;

FLG_API FlgResult flgSurfaceViewInit(FlgSurfaceView* view, uint32_t struct_size);

/* The surface's arrays, readable until a job that changes the surface is started. FLG_NOT_READY until such a job, or
 * the one that makes the surface, is published. Cost: tens of nanoseconds. */
FLG_API FlgResult flgSurfaceGetView(FlgContext context, FlgSurface surface, FlgSurfaceView* out_view);

/* At weights (1 - u - v, u, v) of the triangle's corners; u, v >= 0 and u + v <= 1 (clipped within 1e-5). */
typedef struct FlgSurfacePoint {
    uint32_t triangle; /* its index */
    float u, v;        /* weights of corners 1 and 2 */
} FlgSurfacePoint;

/* Where a vertex lies on the mesh that its surface was made of: weights of at most three of that mesh's vertices, all
 * of one triangle. */
typedef struct FlgSourceWeights {
    uint32_t vertices[3]; /* of the input, rising, welded: the first at a place; FLG_NO_INDEX behind the last */
    float weights[2];     /* of the second and the third, 0 to 1; the first has what is missing to 1 */
} FlgSourceWeights;

/* Where a surface's triangles and vertices lie on the mesh that it was made of, however often it was cut, refined or
 * displaced since: so that whatever that mesh has at the corners of its triangles (texture coordinates with seams,
 * tangents, joints and weights, morph targets) can be had at the corners of the surface's. Each triangle lies in one
 * triangle of the input. */
typedef struct FlgSurfaceProvenanceView {
    uint32_t struct_size;
    uint32_t revision;               /* of the surface */
    uint32_t vertex_count;           /* the surface's */
    uint32_t triangle_count;
    uint32_t input_triangle_count;
    uint32_t reserved;
    const uint32_t* triangles;       /* one per triangle: the input's triangle it lies in */
    const uint32_t* input_vertices;  /* 3 per triangle of the input, in its order, welded as above */
    const FlgSourceWeights* weights; /* one per vertex */
} FlgSurfaceProvenanceView;

FLG_API FlgResult flgSurfaceProvenanceViewInit(FlgSurfaceProvenanceView* view, uint32_t struct_size);

/* The arrays, readable as those of flgSurfaceGetView. FLG_ERROR_INVALID_ARGUMENT without FlgSurfaceDesc.provenance; a
 * refined surface has it from the one it was refined from. After Loop's scheme a vertex lies where it would lie had its
 * edge been split halfway. Cost: tens of nanoseconds. */
FLG_API FlgResult flgSurfaceGetProvenance(FlgContext context, FlgSurface surface, FlgSurfaceProvenanceView* out_view);

/* [any thread] The place on the input of a vertex of a triangle: `triangle` of the input, and the weights of that
 * triangle's corners 1 and 2 in the input's order. FLG_ERROR_INVALID_ARGUMENT if the vertex is none of the triangle's.
 * Cost: tens of nanoseconds. */
FLG_API FlgResult flgSurfaceProvenanceViewGetPoint(const FlgSurfaceProvenanceView* view, uint32_t triangle,
                                                   uint32_t vertex, FlgSurfacePoint* out_point);

/* Triangles that are new, have moved or have other vertices since an earlier revision (0: its creation): those to
 * upload again or to update in a picking scene. Regions may have changed anywhere. Writes at most `capacity` indices,
 * each once, ascending, and their total number; `out_triangles` may be null when capacity is 0. FLG_NOT_READY while the
 * view is not ready. Cost: about 0.5 ns a triangle of the surface. */
FLG_API FlgResult flgSurfaceGetChanges(FlgContext context, FlgSurface surface, uint32_t since_revision,
                                       uint32_t* out_triangles, uint32_t capacity, uint32_t* out_count);

/* Releases the handle and its views; jobs that use the surface keep its memory until they finish. */
FLG_API FlgResult flgSurfaceRelease(FlgContext context, FlgSurface surface);

/* How triangles are refined. */
typedef enum FlgSubdivision {
    FLG_SUBDIVISION_MIDPOINT = 0, /* splits each triangle into four; the shape does not change */
    FLG_SUBDIVISION_LOOP = 1,     /* Loop's scheme: smooth; borders become cubic splines */
    FLG_SUBDIVISION_FORCE_32BIT = 0x7fffffff
} FlgSubdivision;

typedef struct FlgSurfaceRefineDesc {
    uint32_t struct_size;
    FlgSubdivision scheme; /* default FLG_SUBDIVISION_MIDPOINT */
    const FlgJobOptions* job;
    FlgSurface surface;
    uint32_t levels; /* 1 to 8; default 1 */
    uint32_t reserved;
} FlgSurfaceRefineDesc;

FLG_API FlgResult flgSurfaceRefineDescInit(FlgSurfaceRefineDesc* desc, uint32_t struct_size);

/* Starts a job that makes a finer surface: splits each triangle into four, `levels` times, and keeps regions and
 * columns. Fails with FLG_ERROR_LIMIT above 2^30 triangles. Vertices keep their indices; new ones follow. Cost: about
 * 0.12 us a triangle that is made. */
FLG_API FlgResult flgSurfaceRefine(FlgContext context, const FlgSurfaceRefineDesc* desc, FlgSurface* out_surface,
                                   FlgJob* out_job);

/* ---- Points and curves on a surface ---------------------------------------------------------------------------- */

typedef struct FlgSurfaceCurvesView {
    uint32_t struct_size;
    uint32_t curve_count;          /* may be 0 */
    const uint32_t* curve_offsets; /* curve_count + 1 values */
    const uint8_t* curve_flags;    /* FLG_CURVE_CLOSED */
    const float* curve_values;     /* an isoline's value, a path's length, or the field's value at a stream's end */
    const FlgSurfacePoint* points; /* the segment from each point to the next lies in the triangle that the point
                                      names */
    uint32_t revision;             /* of the surface */
    uint32_t reserved;
} FlgSurfaceCurvesView;

FLG_API FlgResult flgSurfaceCurvesViewInit(FlgSurfaceCurvesView* view, uint32_t struct_size);

/* The arrays live until the curves are released. FLG_NOT_READY until their job is published, the job's error if it
 * failed. */
FLG_API FlgResult flgSurfaceCurvesGetView(FlgContext context, FlgSurfaceCurves curves, FlgSurfaceCurvesView* out_view);

FLG_API FlgResult flgSurfaceCurvesRelease(FlgContext context, FlgSurfaceCurves curves);

typedef struct FlgSurfaceCurvesLiftDesc {
    uint32_t struct_size;
    float height; /* metres above the surface along its normal; any finite number, default 0 */
    const FlgJobOptions* job;
    FlgSurfaceCurves curves;
} FlgSurfaceCurvesLiftDesc;

FLG_API FlgResult flgSurfaceCurvesLiftDescInit(FlgSurfaceCurvesLiftDesc* desc, uint32_t struct_size);

/* Starts a job that lifts surface curves into space, with POSITION and, from the surface's smooth normals, NORMAL:
 * flgCurveSetStylize with FLG_FRAME_METHOD_SUPPLIED then decorates them in the surface's frame. Fails if there are
 * no curves. Cost: about 25 ns a triangle of the surface, for its normals, and 0.1 us a point. */
FLG_API FlgResult flgSurfaceCurvesLift(FlgContext context, const FlgSurfaceCurvesLiftDesc* desc, FlgCurveSet* out_set,
                                       FlgJob* out_job);

/* ---- Geodesic distances ------------------------------------------------------------------------------------------ */

/* How near distances are to those of the triangles. */
typedef enum FlgAccuracy {
    FLG_ACCURACY_REFINED = 0, /* within some 0.2 %, in about 40 ns a triangle */
    FLG_ACCURACY_EXACT = 1,   /* to rounding, by windows: some hundred times the work; up to some 300,000 triangles */
    FLG_ACCURACY_FORCE_32BIT = 0x7fffffff
} FlgAccuracy;

typedef struct FlgFieldGeodesicDesc {
    uint32_t struct_size;
    /* Nonzero: the field has labels, the indices of the nearest sources. Default 0. */
    uint32_t labels;
    const FlgJobOptions* job;
    FlgSurface surface;
    /* Sources: any combination of these, at least one. All arrays are copied. */
    const uint32_t* vertices;
    uint32_t vertex_count;
    uint32_t point_count;
    const FlgSurfacePoint* points;   /* points on triangles */
    FlgSurfaceCurves curves;         /* all points of these curves; null: none */
    const uint32_t* border_regions;  /* the borders of these regions, including surface borders */
    uint32_t border_region_count;
    /* Limits on where distances are computed and paths lead. */
    uint32_t region_count;
    const uint32_t* regions; /* labels; null: the whole surface */
    /* Distances beyond this stay infinite, metres, > 0; default infinity. */
    float max_distance;
    /* Stop once these vertices have their distance; more distant ones may stay infinite or be too large. */
    uint32_t target_count;
    const uint32_t* targets; /* vertices */
    /* Perturbs the metric for an organic look (sec. 3.4, Fig. 10): distances are measured as if Perlin noise moved the
     * vertices along their normals by at most this many metres; 0 (default): none. */
    float perturbation;
    /* Waves of that noise per metre, > 0; default 1. */
    float frequency;
    uint64_t seed; /* of the noise; default 1 */
    FlgAccuracy accuracy; /* default FLG_ACCURACY_REFINED; an exact field has no perturbation */
    uint32_t reserved;
} FlgFieldGeodesicDesc;

FLG_API FlgResult flgFieldGeodesicDescInit(FlgFieldGeodesicDesc* desc, uint32_t struct_size);

/* Starts a job that computes distances along the surface from the nearest source to every vertex. It unfolds fronts
 * over triangles; the error is below 0.2 % (RMS) on natural meshes, and below 0.6 % on them stretched to twenty times
 * their length: where triangles are obtuse, others of the same shape are unfolded (intrinsic edge flips), and the
 * surface is not changed. No distance exceeds that along edges by more than 3e-5 of it. From points and vertices alone,
 * at most 16 or with labels, none is less than the straight line. The first job on a surface also builds the solver's
 * data (about 0.15 us a triangle; kept, and updated by cuts). Cost then: about 40 ns a triangle within the limits and
 * below 1 ns for each other one, as every vertex has a value. If sources lie outside the regions, all distances are
 * infinite. FLG_ERROR_OUT_OF_MEMORY also if memory runs out while building that data. */
FLG_API FlgResult flgFieldCreateGeodesic(FlgContext context, const FlgFieldGeodesicDesc* desc, FlgField* out_field,
                                         FlgJob* out_job);

typedef struct FlgFieldView {
    uint32_t struct_size;
    uint32_t vertex_count;
    const float* values;     /* one per vertex; for distances: metres, infinite where no path leads within the limits */
    const uint32_t* labels;  /* index of the nearest source: vertices, then points, then curves, then border regions,
                                in the descriptor's order; FLG_NO_INDEX where infinite. Null if the field has none */
    const uint32_t* samples; /* for a sampling: its vertices, in the order chosen */
    uint32_t sample_count;
    uint32_t revision;      /* of the surface */
} FlgFieldView;

FLG_API FlgResult flgFieldViewInit(FlgFieldView* view, uint32_t struct_size);

/* The arrays live until the field is released. FLG_NOT_READY until its job is published, the job's error if it
 * failed. */
FLG_API FlgResult flgFieldGetView(FlgContext context, FlgField field, FlgFieldView* out_view);

/* A field from the host, one value per vertex of the current surface (FLG_NOT_READY while it changes); values may be
 * infinite, but not NaN. Cost: a copy. */
FLG_API FlgResult flgFieldCreate(FlgContext context, FlgSurface surface, const float* values, uint32_t value_count,
                                 FlgField* out_field);

FLG_API FlgResult flgFieldRelease(FlgContext context, FlgField field);

typedef struct FlgFieldBlendDesc {
    uint32_t struct_size;
    uint32_t reserved;
    const FlgJobOptions* job;
    FlgField from; /* the blend is 0 there */
    FlgField to;   /* the blend is 1 there */
} FlgFieldBlendDesc;

FLG_API FlgResult flgFieldBlendDescInit(FlgFieldBlendDesc* desc, uint32_t struct_size);

/* Starts a job that blends two distance fields of one surface: from / (from + to), sec. 3.2. 0.5 where both are 0;
 * infinite where both are infinite. Cost: about 5 ns a vertex. */
FLG_API FlgResult flgFieldBlend(FlgContext context, const FlgFieldBlendDesc* desc, FlgField* out_field,
                                FlgJob* out_job);

/* ---- Sampling ---------------------------------------------------------------------------------------------------- */

typedef struct FlgSurfaceSampleDesc {
    uint32_t struct_size;
    uint32_t max_count; /* maximum points; 0 (default): as many as fit */
    const FlgJobOptions* job;
    FlgSurface surface;
    float radius; /* minimum distance between points along the surface, metres, > 0 */
    uint32_t region_count;
    const uint32_t* regions; /* labels; null: the whole surface */
    uint64_t seed;           /* for the first point; default 1 */
} FlgSurfaceSampleDesc;

FLG_API FlgResult flgSurfaceSampleDescInit(FlgSurfaceSampleDesc* desc, uint32_t struct_size);

/* Starts a job that spreads points over the surface, each as far as possible from those before it: Poisson-disk samples
 * in the geodesic metric (sec. 4.2), at vertices. (Above 16,384 vertices, most are chosen by distance in space.) The
 * field: distances to the nearest sample; labels: its cell. Cost: some 3 to 4 fields for 130 points. */
FLG_API FlgResult flgSurfaceSample(FlgContext context, const FlgSurfaceSampleDesc* desc, FlgField* out_field,
                                   FlgJob* out_job);

typedef struct FlgSurfaceSampleBordersDesc {
    uint32_t struct_size;
    float spacing; /* desired distance along the border, metres, > 0; each border gets a whole number of equal steps */
    const FlgJobOptions* job;
    FlgSurface surface;
    uint32_t region; /* the region with the borders, including surface borders */
    uint32_t reserved;
} FlgSurfaceSampleBordersDesc;

FLG_API FlgResult flgSurfaceSampleBordersDescInit(FlgSurfaceSampleBordersDesc* desc, uint32_t struct_size);

/* Starts a job that places points evenly along the borders of a region: one closed curve per border. Such a curve is
 * not straight in triangles between its points and cannot be cut in. Cost: about 8 ns a triangle. */
FLG_API FlgResult flgSurfaceSampleBorders(FlgContext context, const FlgSurfaceSampleBordersDesc* desc,
                                          FlgSurfaceCurves* out_curves, FlgJob* out_job);

/* ---- Tracing ----------------------------------------------------------------------------------------------------- */

typedef struct FlgFieldTraceIsolinesDesc {
    uint32_t struct_size;
    uint32_t region_count;
    const FlgJobOptions* job;
    FlgField field;
    const uint32_t* regions;        /* labels; null: the whole surface */
    const float* levels;            /* values of the field, ascending, copied; null: level_first + k * level_every */
    uint32_t level_count;           /* at most 65534; 0 without `levels`: as many as the field has, starting at the
                                       first k not below its smallest value */
    float level_first, level_every; /* used without `levels`; level_every > 0 */
    uint32_t reserved;
} FlgFieldTraceIsolinesDesc;

FLG_API FlgResult flgFieldTraceIsolinesDescInit(FlgFieldTraceIsolinesDesc* desc, uint32_t struct_size);

/* Starts a job that traces isolines: closed ones, and open ones from border to border. Higher values lie to their left.
 * Open isolines come first, then closed ones, each kind ordered by the triangle it begins in; curve_values are their
 * levels. Cost: about 9 ns a triangle and 0.2 us a point. */
FLG_API FlgResult flgFieldTraceIsolines(FlgContext context, const FlgFieldTraceIsolinesDesc* desc,
                                        FlgSurfaceCurves* out_curves, FlgJob* out_job);

typedef struct FlgFieldTraceStreamsDesc {
    uint32_t struct_size;
    uint32_t downhill; /* nonzero: against the gradient. Default 0 */
    const FlgJobOptions* job;
    FlgField field;
    const FlgSurfacePoint* starts;    /* one curve each; copied */
    uint32_t start_count;
    uint32_t region_count;
    FlgSurfaceCurves border_samples; /* further starts: the points of flgSurfaceSampleBorders, whose job may still
                                        run */
    const uint32_t* regions;         /* the curves end where these regions end */
    float end_value;                 /* they end where the field reaches this; default: infinity, of either sign */
    uint32_t reserved;
} FlgFieldTraceStreamsDesc;

FLG_API FlgResult flgFieldTraceStreamsDescInit(FlgFieldTraceStreamsDesc* desc, uint32_t struct_size);

/* Starts a job that traces integral curves of a field's gradient. The field rises (falls) strictly along them. Each
 * ends at the border, at `end_value` or at an extremum of the field. A start outside the regions gives no curve.
 * Cost: about 0.25 us a point. */
FLG_API FlgResult flgFieldTraceStreams(FlgContext context, const FlgFieldTraceStreamsDesc* desc,
                                       FlgSurfaceCurves* out_curves, FlgJob* out_job);

typedef struct FlgFieldTracePathsDesc {
    uint32_t struct_size;
    uint32_t closed; /* nonzero: each path's last point joins its first. Default 0 */
    const FlgJobOptions* job;
    FlgSurface surface;
    const FlgSurfacePoint* points;  /* the points of all paths, copied */
    const uint32_t* path_offsets;   /* path_count + 1 values: path p passes through points offsets[p] to offsets[p + 1]
                                       - 1 */
    uint32_t path_count;
    uint32_t region_count;
    const uint32_t* regions;        /* the initial guess stays on these */
} FlgFieldTracePathsDesc;

FLG_API FlgResult flgFieldTracePathsDescInit(FlgFieldTracePathsDesc* desc, uint32_t struct_size);

/* Starts a job that joins points by locally shortest paths: straight across edges, and at vertices no shorter on either
 * side (to 1e-6). The job fails if no path joins two points; zero-length paths are omitted. Cost: a field for each two
 * points, up to where they meet, and its copy. */
FLG_API FlgResult flgFieldTracePaths(FlgContext context, const FlgFieldTracePathsDesc* desc,
                                     FlgSurfaceCurves* out_curves, FlgJob* out_job);

/* ---- Cutting ----------------------------------------------------------------------------------------------------- */

typedef struct FlgSurfaceCutIsolinesDesc {
    uint32_t struct_size;
    uint32_t region_count;
    const FlgJobOptions* job;
    FlgField field;                 /* its surface is cut */
    const uint32_t* regions;        /* labels; null: the whole surface */
    const float* levels;            /* as in FlgFieldTraceIsolinesDesc, but at most 256 levels */
    uint32_t level_count;
    float level_first, level_every; /* likewise */
    /* Triangles of regions[i] above k of n levels get the label first_label + i * (n + 1) + k; with `regions` null all
     * get first_label + k. Default FLG_NO_INDEX: labels do not change. */
    uint32_t first_label;
} FlgSurfaceCutIsolinesDesc;

FLG_API FlgResult flgSurfaceCutIsolinesDescInit(FlgSurfaceCutIsolinesDesc* desc, uint32_t struct_size);

/* Starts a job that cuts a surface along isolines, all levels in one pass: they become chains of edges. Crossings
 * nearer to a vertex than 1/100 of their edge move to it, to avoid slivers. Nothing else moves; the surface keeps its
 * area and topology. New vertices and triangles are appended, with interpolated columns. `out_field` (may be null): the
 * field on the cut surface. Cost: about 10 ns a triangle of the surface and 0.5 us a triangle cut. */
FLG_API FlgResult flgSurfaceCutIsolines(FlgContext context, const FlgSurfaceCutIsolinesDesc* desc, FlgField* out_field,
                                 FlgJob* out_job);

typedef struct FlgSurfaceCutCurvesDesc {
    uint32_t struct_size;
    /* If a region falls apart, its parts get labels from here on, in the order in which the curves meet them; other
     * regions keep their labels. Default FLG_NO_INDEX: labels do not change. */
    uint32_t first_label;
    const FlgJobOptions* job;
    FlgSurfaceCurves curves; /* their surface is cut */
} FlgSurfaceCutCurvesDesc;

FLG_API FlgResult flgSurfaceCutCurvesDescInit(FlgSurfaceCutCurvesDesc* desc, uint32_t struct_size);

/* Starts a job that cuts a surface along curves, which may cross, touch, and end anywhere. The job first works out how
 * to divide triangles, which takes longest; until then the surface does not change and the job can be cancelled.
 * Cost: as flgSurfaceCutIsolines; n curves that cross each other in one triangle take about n * n us there. */
FLG_API FlgResult flgSurfaceCutCurves(FlgContext context, const FlgSurfaceCutCurvesDesc* desc, FlgJob* out_job);

/* ---- Defaults by value --------------------------------------------------------------------------------------- */

static inline FlgSurfaceReport flgSurfaceReportDefaults(void) {
    FlgSurfaceReport report;
    flgSurfaceReportInit(&report, (uint32_t)sizeof report);
    return report;
}

static inline FlgMeshView flgMeshViewDefaults(void) {
    FlgMeshView view;
    flgMeshViewInit(&view, (uint32_t)sizeof view);
    return view;
}

static inline FlgSurfaceDesc flgSurfaceDefaults(void) {
    FlgSurfaceDesc desc;
    flgSurfaceDescInit(&desc, (uint32_t)sizeof desc);
    return desc;
}

static inline FlgSurfaceView flgSurfaceViewDefaults(void) {
    FlgSurfaceView view;
    flgSurfaceViewInit(&view, (uint32_t)sizeof view);
    return view;
}

static inline FlgSurfaceProvenanceView flgSurfaceProvenanceViewDefaults(void) {
    FlgSurfaceProvenanceView view;
    flgSurfaceProvenanceViewInit(&view, (uint32_t)sizeof view);
    return view;
}

static inline FlgSurfaceRefineDesc flgSurfaceRefineDefaults(void) {
    FlgSurfaceRefineDesc desc;
    flgSurfaceRefineDescInit(&desc, (uint32_t)sizeof desc);
    return desc;
}

static inline FlgSurfaceCurvesView flgSurfaceCurvesViewDefaults(void) {
    FlgSurfaceCurvesView view;
    flgSurfaceCurvesViewInit(&view, (uint32_t)sizeof view);
    return view;
}

static inline FlgSurfaceCurvesLiftDesc flgSurfaceCurvesLiftDefaults(void) {
    FlgSurfaceCurvesLiftDesc desc;
    flgSurfaceCurvesLiftDescInit(&desc, (uint32_t)sizeof desc);
    return desc;
}

static inline FlgFieldGeodesicDesc flgFieldGeodesicDefaults(void) {
    FlgFieldGeodesicDesc desc;
    flgFieldGeodesicDescInit(&desc, (uint32_t)sizeof desc);
    return desc;
}

static inline FlgFieldView flgFieldViewDefaults(void) {
    FlgFieldView view;
    flgFieldViewInit(&view, (uint32_t)sizeof view);
    return view;
}

static inline FlgFieldBlendDesc flgFieldBlendDefaults(void) {
    FlgFieldBlendDesc desc;
    flgFieldBlendDescInit(&desc, (uint32_t)sizeof desc);
    return desc;
}

static inline FlgSurfaceSampleDesc flgSurfaceSampleDefaults(void) {
    FlgSurfaceSampleDesc desc;
    flgSurfaceSampleDescInit(&desc, (uint32_t)sizeof desc);
    return desc;
}

static inline FlgSurfaceSampleBordersDesc flgSurfaceSampleBordersDefaults(void) {
    FlgSurfaceSampleBordersDesc desc;
    flgSurfaceSampleBordersDescInit(&desc, (uint32_t)sizeof desc);
    return desc;
}

static inline FlgFieldTraceIsolinesDesc flgFieldTraceIsolinesDefaults(void) {
    FlgFieldTraceIsolinesDesc desc;
    flgFieldTraceIsolinesDescInit(&desc, (uint32_t)sizeof desc);
    return desc;
}

static inline FlgFieldTraceStreamsDesc flgFieldTraceStreamsDefaults(void) {
    FlgFieldTraceStreamsDesc desc;
    flgFieldTraceStreamsDescInit(&desc, (uint32_t)sizeof desc);
    return desc;
}

static inline FlgFieldTracePathsDesc flgFieldTracePathsDefaults(void) {
    FlgFieldTracePathsDesc desc;
    flgFieldTracePathsDescInit(&desc, (uint32_t)sizeof desc);
    return desc;
}

static inline FlgSurfaceCutIsolinesDesc flgSurfaceCutIsolinesDefaults(void) {
    FlgSurfaceCutIsolinesDesc desc;
    flgSurfaceCutIsolinesDescInit(&desc, (uint32_t)sizeof desc);
    return desc;
}

static inline FlgSurfaceCutCurvesDesc flgSurfaceCutCurvesDefaults(void) {
    FlgSurfaceCutCurvesDesc desc;
    flgSurfaceCutCurvesDescInit(&desc, (uint32_t)sizeof desc);
    return desc;
}

#ifdef __cplusplus
}
#endif

#endif
