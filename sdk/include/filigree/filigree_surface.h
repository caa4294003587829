/* SPDX-License-Identifier: MIT
 * SPDX-FileCopyrightText: 2026 The Filigree authors
 *
 * Surfaces: triangle meshes that hold up, geodesic distances, tracing, sampling and cutting (Nazzaro, Puppo, Pellacini:
 * geoTangle, 2021, sec. 3 and 4). It follows the grammar of filigree.h.
 *
 * Order        Jobs on one surface see it as it was when they were started: those that read it run side by side, one that
 *              changes it (a cut) runs after all that were started before it and before all that are started later. No
 *              host has to wait for that.
 * Revisions    A surface counts its changes. Fields and curves belong to the revision they were started on; with another
 *              they are FLG_ERROR_INVALID_ARGUMENT. (A change counts when it is started, also if it fails later.)
 * Regions      Each triangle has a label, 0 to FLG_REGION_MAX. Functions that take `regions` keep to triangles with these
 *              labels, paths included; null means the whole surface.
 */
#ifndef FILIGREE_FILIGREE_SURFACE_H
#define FILIGREE_FILIGREE_SURFACE_H

#include "filigree.h"

#ifdef __cplusplus
extern "C" {
#endif

/* A mesh with its adjacency and what geodesics need. Cutting changes it. */
FLG_HANDLE(FlgSurface);
/* A value a vertex of a surface. Never changes once ready. */
FLG_HANDLE(FlgField);
/* Curves on a surface, straight in each triangle. Never change once ready. */
FLG_HANDLE(FlgSurfaceCurves);

/* Instead of an index: there is none. */
#define FLG_NO_INDEX 0xffffffffu
/* The largest label that a triangle may have. */
#define FLG_REGION_MAX 0xffffffu

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

FLG_API FlgResult flgMeshViewInit(FlgMeshView* view, uint32_t struct_size);

typedef struct FlgSurfaceDesc {
    uint32_t struct_size;
    /* Vertices at most so far apart become one, metres, >= 0; 0: those at the same place, to the bit. Below 0: none. Default
     * 0. */
    float weld_distance;
    FlgJobOptions job;
    FlgMeshView mesh;
} FlgSurfaceDesc;

FLG_API FlgResult flgSurfaceDescInit(FlgSurfaceDesc* desc, uint32_t struct_size);

/* Starts a job that makes a manifold surface of any triangles, and reports what it had to do (flgSurfaceGetReport). The
 * arrays are copied in this call: about 10 ms for 2 million triangles. The job fails with FLG_ERROR_INVALID_ARGUMENT if an
 * index is out of range, a position isn't finite, or no triangle is left. Cost: about 0.3 us a triangle. */
FLG_API FlgResult flgSurfaceCreate(FlgContext context, const FlgSurfaceDesc* desc, FlgSurface* out_surface,
                                   FlgJob* out_job);

/* What was found in the input and done about it, and what the surface is like. */
typedef struct FlgSurfaceReport {
    uint32_t struct_size;
    uint32_t welded_vertices;         /* became one with another */
    uint32_t unused_vertices;         /* dropped: no triangle names them */
    uint32_t degenerate_triangles;    /* dropped: they name a vertex twice */
    uint32_t duplicate_triangles;     /* dropped: the same three vertices as another, in any order */
    uint32_t flipped_triangles;       /* turned over, to be of one winding with their neighbours */
    uint32_t crowded_edges;           /* had more than two triangles: joined in pairs, the rest apart */
    uint32_t cut_edges;               /* opened because both sides could not be kept (Moebius strips, crowded edges) */
    uint32_t split_vertices;          /* vertices added for those whose triangles formed several fans */
    uint32_t flat_triangles;          /* kept: lower than 1e-6 of their longest edge */
    uint32_t vertex_count;
    uint32_t triangle_count;
    uint32_t component_count;         /* pieces that no edge joins */
    uint32_t border_count;            /* closed chains of border edges */
    uint32_t border_edges;            /* edges with one triangle */
    uint32_t genus;                   /* handles, of all components together */
    int64_t euler_number;             /* vertices - edges + triangles */
    double area;                      /* square metres */
    float box_min[3], box_max[3];     /* of the positions, metres */
    const uint32_t* vertex_of_input;  /* one a vertex of the input: where it is now, FLG_NO_INDEX if dropped (one that was
                                         split is named where its first fan is); null if all are where they were. Lives
                                         until the surface is released */
    uint32_t input_vertex_count;
    uint32_t reserved;
} FlgSurfaceReport;

/* The report of the job that made the surface; FLG_NOT_READY before it is published, its error if it failed. Cuts don't
 * change it. Cost: tens of nanoseconds. */
FLG_API FlgResult flgSurfaceGetReport(FlgContext context, FlgSurface surface, FlgSurfaceReport* out_report);

typedef struct FlgSurfaceView {
    uint32_t struct_size;
    uint32_t revision;          /* changes so far */
    FlgMeshView mesh;
    const uint32_t* neighbours; /* 3 a triangle: across the edges from corner k to corner k + 1; FLG_NO_INDEX at a border */
} FlgSurfaceView;

FLG_API FlgResult flgSurfaceViewInit(FlgSurfaceView* view, uint32_t struct_size);

/* The surface's arrays; they may be read until a job that changes the surface is started. FLG_NOT_READY while such a job,
 * or the one that makes the surface, isn't published. Cost: tens of nanoseconds. */
FLG_API FlgResult flgSurfaceGetView(FlgContext context, FlgSurface surface, FlgSurfaceView* out_view);

/* Triangles that are new, have moved or have other vertices than at an earlier revision (0: when it was made): those to
 * upload again, or to put into a picking scene. Regions may have changed anywhere. Writes at most `capacity` indices, each
 * once, rising, and their whole number; `out_triangles` may be null when capacity is 0. Not ready when the view isn't.
 * Cost: about 0.5 ns a triangle of the surface. */
FLG_API FlgResult flgSurfaceGetChanges(FlgContext context, FlgSurface surface, uint32_t since_revision,
                                       uint32_t* out_triangles, uint32_t capacity, uint32_t* out_count);

/* Gives the handle and its views back; jobs that use the surface keep its memory until they are done. */
FLG_API FlgResult flgSurfaceRelease(FlgContext context, FlgSurface surface);

/* How triangles are made finer. */
typedef enum FlgSubdivision {
    FLG_SUBDIVISION_MIDPOINT = 0, /* each triangle in four, the surface stays as it is */
    FLG_SUBDIVISION_LOOP = 1,     /* Loop's scheme: smooth; borders become cubic splines */
    FLG_SUBDIVISION_FORCE_32BIT = 0x7fffffff
} FlgSubdivision;

typedef struct FlgRefineDesc {
    uint32_t struct_size;
    FlgSubdivision scheme; /* default FLG_SUBDIVISION_MIDPOINT */
    FlgJobOptions job;
    FlgSurface surface;
    uint32_t levels; /* 1 to 8; default 1 */
    uint32_t reserved;
} FlgRefineDesc;

FLG_API FlgResult flgRefineDescInit(FlgRefineDesc* desc, uint32_t struct_size);

/* Starts a job that makes a finer surface: four triangles of each, `levels` times, with its regions and columns. Fails with
 * FLG_ERROR_LIMIT above 2^30 triangles. Vertices keep their numbers, new ones follow.
 * Cost: about 0.12 us a triangle that is made. */
FLG_API FlgResult flgSurfaceRefine(FlgContext context, const FlgRefineDesc* desc, FlgSurface* out_surface,
                                   FlgJob* out_job);

/* ---- Points and curves on a surface ---------------------------------------------------------------------------- */

/* At weights (1 - u - v, u, v) of the triangle's corners; u, v >= 0 and u + v <= 1 (up to 1e-5, which is clipped). */
typedef struct FlgSurfacePoint {
    uint32_t triangle; /* its number */
    float u, v;        /* weights of corners 1 and 2 */
} FlgSurfacePoint;

typedef struct FlgSurfaceCurvesView {
    uint32_t struct_size;
    uint32_t curve_count;          /* may be 0 */
    const uint32_t* curve_offsets; /* curve_count + 1 values */
    const uint8_t* curve_flags;    /* FLG_CURVE_CLOSED */
    const float* curve_values;     /* of an isoline its value, of a path its length, of a stream the field's value at its end */
    const FlgSurfacePoint* points; /* the stretch from a point to the next lies in the triangle that the point names */
    uint32_t revision;             /* of the surface */
    uint32_t reserved;
} FlgSurfaceCurvesView;

FLG_API FlgResult flgSurfaceCurvesViewInit(FlgSurfaceCurvesView* view, uint32_t struct_size);

/* The arrays live until the curves are released. FLG_NOT_READY before their job is published, its error if it failed. */
FLG_API FlgResult flgSurfaceCurvesGetView(FlgContext context, FlgSurfaceCurves curves, FlgSurfaceCurvesView* out_view);

FLG_API FlgResult flgSurfaceCurvesRelease(FlgContext context, FlgSurfaceCurves curves);

typedef struct FlgLiftDesc {
    uint32_t struct_size;
    float height; /* metres above the surface along its normal; any finite number, default 0 */
    FlgJobOptions job;
    FlgSurfaceCurves curves;
} FlgLiftDesc;

FLG_API FlgResult flgLiftDescInit(FlgLiftDesc* desc, uint32_t struct_size);

/* Starts a job that makes curves in space of curves on a surface: POSITION and, from the surface's smooth normals, NORMAL, so
 * that flgStylize with FLG_FRAME_SUPPLIED decorates them in the surface's frame. Fails if there are no curves.
 * Cost: about 25 ns a triangle of the surface, for its normals, and 0.1 us a point. */
FLG_API FlgResult flgLiftCurves(FlgContext context, const FlgLiftDesc* desc, FlgCurveSet* out_set, FlgJob* out_job);

/* ---- Geodesic distances ------------------------------------------------------------------------------------------ */

/* Which solver measures distances. */
typedef enum FlgAccuracy {
    FLG_ACCURACY_REFINED = 0, /* unfolding: below 0.2 % of error (RMS) on natural meshes, and the faster one */
    FLG_ACCURACY_GRAPH = 1,   /* sec. 4.2: shortest paths along edges and dual arcs; 1 to 3 % too long */
    FLG_ACCURACY_FORCE_32BIT = 0x7fffffff
} FlgAccuracy;

typedef struct FlgGeodesicDesc {
    uint32_t struct_size;
    FlgAccuracy accuracy; /* default FLG_ACCURACY_REFINED */
    FlgJobOptions job;
    FlgSurface surface;
    /* Sources: any of these together, at least one. All arrays are copied. */
    const uint32_t* vertices;
    uint32_t vertex_count;
    uint32_t point_count;
    const FlgSurfacePoint* points;   /* places on triangles */
    FlgSurfaceCurves curves;         /* every point of these curves; null: none */
    const uint32_t* border_regions;  /* the borders of these regions, also where the surface ends */
    uint32_t border_region_count;
    /* Where distances are computed and paths may lead. */
    uint32_t region_count;
    const uint32_t* regions; /* labels; null: the whole surface */
    /* Distances beyond this are left infinite, metres, > 0; default infinity. */
    float max_distance;
    /* Stop once these vertices have their distance; further ones may be left infinite or too far. */
    uint32_t target_count;
    const uint32_t* targets; /* vertices */
    /* The metric may be perturbed for an organic look (sec. 3.4, Fig. 10): distances are measured as if the vertices were moved
     * along their normals by Perlin noise of at most so many metres; 0 (default): not. */
    float perturbation;
    /* Waves a metre of that noise, > 0; default 1. */
    float frequency;
    uint64_t seed; /* of the noise; default 1 */
    /* Nonzero: the field has labels, the numbers of the nearest sources. Default 0. */
    uint32_t labels;
    uint32_t reserved;
} FlgGeodesicDesc;

FLG_API FlgResult flgGeodesicDescInit(FlgGeodesicDesc* desc, uint32_t struct_size);

/* Starts a job that computes distances along the surface from the nearest source to every vertex. The first on a surface
 * also builds what the solver needs (about 0.15 us a triangle, kept and updated by cuts). Cost then: about 40 ns a triangle
 * within the limits and below 1 ns for each other one (FLG_ACCURACY_GRAPH: a few ns), as every vertex has a value. With sources
 * outside the regions all distances are infinite. FLG_ERROR_OUT_OF_MEMORY also if memory runs out in what is built first. */
FLG_API FlgResult flgGeodesic(FlgContext context, const FlgGeodesicDesc* desc, FlgField* out_field, FlgJob* out_job);

typedef struct FlgFieldView {
    uint32_t struct_size;
    uint32_t vertex_count;
    const float* values;    /* one a vertex; of distances: metres, infinite where no path leads or none within the limits */
    const uint32_t* labels; /* the nearest source's number: vertices, then points, then curves, then border regions, in the
                               order of the descriptor; FLG_NO_INDEX where infinite. Null if the field has none */
    const uint32_t* samples; /* of a sampling: its vertices, in the order they were chosen */
    uint32_t sample_count;
    uint32_t revision;      /* of the surface */
} FlgFieldView;

FLG_API FlgResult flgFieldViewInit(FlgFieldView* view, uint32_t struct_size);

/* The arrays live until the field is released. FLG_NOT_READY before its job is published, its error if it failed. */
FLG_API FlgResult flgFieldGetView(FlgContext context, FlgField field, FlgFieldView* out_view);

/* A field of the host's own, one value a vertex of the surface as it is now (FLG_NOT_READY while it changes); infinite
 * values are allowed, NaN is not. Cost: a copy. */
FLG_API FlgResult flgFieldCreate(FlgContext context, FlgSurface surface, const float* values, uint32_t value_count,
                                 FlgField* out_field);

FLG_API FlgResult flgFieldRelease(FlgContext context, FlgField field);

typedef struct FlgBlendDesc {
    uint32_t struct_size;
    uint32_t reserved;
    FlgJobOptions job;
    FlgField from; /* 0 there */
    FlgField to;   /* 1 there */
} FlgBlendDesc;

FLG_API FlgResult flgBlendDescInit(FlgBlendDesc* desc, uint32_t struct_size);

/* Starts a job that blends two distance fields of one surface: from / (from + to), sec. 3.2. Where both are 0: 0.5; infinite
 * where both are. Cost: about 5 ns a vertex. */
FLG_API FlgResult flgFieldBlend(FlgContext context, const FlgBlendDesc* desc, FlgField* out_field, FlgJob* out_job);

/* ---- Sampling ---------------------------------------------------------------------------------------------------- */

typedef struct FlgSamplingDesc {
    uint32_t struct_size;
    uint32_t max_count; /* points at most; 0 (default): as many as fit */
    FlgJobOptions job;
    FlgSurface surface;
    float radius; /* no two points are nearer to each other along the surface, metres, > 0 */
    uint32_t region_count;
    const uint32_t* regions; /* labels; null: the whole surface */
    uint64_t seed; /* of the first point; default 1 */
} FlgSamplingDesc;

FLG_API FlgResult flgSamplingDescInit(FlgSamplingDesc* desc, uint32_t struct_size);

/* Starts a job that spreads points over the surface, each as far as possible from those before it (of more than 16,384 vertices most in
 * space): Poisson-disk samples in the geodesic metric (sec. 4.2), at vertices. The field: distances to the nearest one; labels: its cell.
 * Cost: some 3 to 4 fields for 130 points. */
FLG_API FlgResult flgSurfaceSample(FlgContext context, const FlgSamplingDesc* desc, FlgField* out_field,
                                   FlgJob* out_job);

typedef struct FlgBorderSamplingDesc {
    uint32_t struct_size;
    float spacing; /* wanted distance along the border, metres, > 0; each border gets a whole number of equal steps */
    FlgJobOptions job;
    FlgSurface surface;
    uint32_t region; /* whose borders, also where the surface ends */
    uint32_t reserved;
} FlgBorderSamplingDesc;

FLG_API FlgResult flgBorderSamplingDescInit(FlgBorderSamplingDesc* desc, uint32_t struct_size);

/* Starts a job that places points evenly along the borders of a region: one closed curve a border, which is not straight in
 * triangles between its points and can't be cut in. Cost: about 8 ns a triangle. */
FLG_API FlgResult flgBorderSample(FlgContext context, const FlgBorderSamplingDesc* desc, FlgSurfaceCurves* out_curves,
                                  FlgJob* out_job);

/* ---- Tracing ----------------------------------------------------------------------------------------------------- */

/* Which values of a field: either `values`, or first + k * every for k = 0 to count - 1. */
typedef struct FlgLevels {
    const float* values; /* rising, at most 65534; null: evenly spaced ones */
    uint32_t count;      /* 0 with every > 0: as many as the field has, k from the first that is not below
                            its smallest value; at most 65534 */
    float first, every;  /* used without `values`; `every` > 0 */
} FlgLevels;

typedef struct FlgIsolinesDesc {
    uint32_t struct_size;
    uint32_t region_count;
    FlgJobOptions job;
    FlgField field;
    const uint32_t* regions; /* labels; null: the whole surface */
    FlgLevels levels;
} FlgIsolinesDesc;

FLG_API FlgResult flgIsolinesDescInit(FlgIsolinesDesc* desc, uint32_t struct_size);

/* Starts a job that traces isolines: closed ones, and open ones from border to border. Higher values lie to their left.
 * First the open ones, then the closed ones, each kind by the triangle it begins in; curve_values are their levels.
 * Cost: about 9 ns a triangle and 0.2 us a point. */
FLG_API FlgResult flgTraceIsolines(FlgContext context, const FlgIsolinesDesc* desc, FlgSurfaceCurves* out_curves,
                                   FlgJob* out_job);

typedef struct FlgStreamsDesc {
    uint32_t struct_size;
    uint32_t downhill; /* nonzero: against the gradient. Default 0 */
    FlgJobOptions job;
    FlgField field;
    const FlgSurfacePoint* starts;    /* a curve each; copied */
    uint32_t start_count;
    uint32_t region_count;
    FlgSurfaceCurves border_samples;  /* further starts: the points of flgBorderSample, which may still be in the making */
    const uint32_t* regions;          /* the curves end where these do */
    float end_value;                  /* they end where the field reaches this; default: infinity, its sign doesn't matter */
    uint32_t reserved;
} FlgStreamsDesc;

FLG_API FlgResult flgStreamsDescInit(FlgStreamsDesc* desc, uint32_t struct_size);

/* Starts a job that traces integral curves of a field's gradient. The field rises (falls) strictly along them; each ends at the
 * border, at `end_value` or where the field has an extremum. A start outside the regions gives no curve.
 * Cost: about 0.25 us a point. */
FLG_API FlgResult flgTraceStreams(FlgContext context, const FlgStreamsDesc* desc, FlgSurfaceCurves* out_curves,
                                  FlgJob* out_job);

typedef struct FlgPathsDesc {
    uint32_t struct_size;
    uint32_t closed; /* nonzero: the last point of each path is joined to its first. Default 0 */
    FlgJobOptions job;
    FlgSurface surface;
    const FlgSurfacePoint* points;  /* all paths' points, copied */
    const uint32_t* path_offsets;   /* path_count + 1 values: path p goes through points offsets[p] to offsets[p + 1] - 1 */
    uint32_t path_count;
    uint32_t region_count;
    const uint32_t* regions;        /* the first guess keeps to these */
} FlgPathsDesc;

FLG_API FlgResult flgPathsDescInit(FlgPathsDesc* desc, uint32_t struct_size);

/* Starts a job that joins points by locally shortest paths: straight over edges, and at vertices no shorter on either side
 * (to 1e-6). Points that no path joins make the job fail; a path without length
 * is left out. Cost: a field for each two points, up to where they meet, and its copy. */
FLG_API FlgResult flgTracePaths(FlgContext context, const FlgPathsDesc* desc, FlgSurfaceCurves* out_curves,
                                FlgJob* out_job);

/* ---- Cutting ----------------------------------------------------------------------------------------------------- */

typedef struct FlgCutIsolinesDesc {
    uint32_t struct_size;
    uint32_t region_count;
    FlgJobOptions job;
    FlgField field; /* its surface is cut */
    const uint32_t* regions; /* labels; null: the whole surface */
    FlgLevels levels;
    /* Triangles of regions[i] above k of n levels get the label first_label + i * (n + 1) + k; with `regions` null all get
     * first_label + k. Default FLG_NO_INDEX: labels stay as they are. At most 256 levels. */
    uint32_t first_label;
    uint32_t reserved;
} FlgCutIsolinesDesc;

FLG_API FlgResult flgCutIsolinesDescInit(FlgCutIsolinesDesc* desc, uint32_t struct_size);

/* Starts a job that cuts a surface along isolines, all levels in one pass: they become chains of edges. Crossings nearer to a vertex
 * than 1/100 of their edge move to it, so that no slivers come about; else nothing moves, the surface keeps its area and its topology.
 * New vertices and triangles are appended, the columns interpolated. `out_field`, which may be null, is the field on the cut surface.
 * Cost: about 10 ns a triangle of the surface and 0.5 us a triangle cut. */
FLG_API FlgResult flgCutIsolines(FlgContext context, const FlgCutIsolinesDesc* desc, FlgField* out_field,
                                 FlgJob* out_job);

typedef struct FlgCutCurvesDesc {
    uint32_t struct_size;
    /* The parts of a region that falls apart get labels from here on, in the order in which the curves meet them; a region
     * that doesn't keeps its own. Default FLG_NO_INDEX: labels stay as they are. */
    uint32_t first_label;
    FlgJobOptions job;
    FlgSurfaceCurves curves; /* their surface is cut */
} FlgCutCurvesDesc;

FLG_API FlgResult flgCutCurvesDescInit(FlgCutCurvesDesc* desc, uint32_t struct_size);

/* Starts a job that cuts a surface along curves, which may cross, touch, and end anywhere. Finding out
 * how to divide triangles comes first and takes longest; until then the surface is as it was and the job can be cancelled.
 * Cost: as flgCutIsolines; n curves that cross each other in one triangle take about n * n us there. */
FLG_API FlgResult flgCutCurves(FlgContext context, const FlgCutCurvesDesc* desc, FlgJob* out_job);

/* ---- Defaults by value --------------------------------------------------------------------------------------- */

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

static inline FlgRefineDesc flgRefineDefaults(void) {
    FlgRefineDesc desc;
    flgRefineDescInit(&desc, (uint32_t)sizeof desc);
    return desc;
}

static inline FlgSurfaceCurvesView flgSurfaceCurvesViewDefaults(void) {
    FlgSurfaceCurvesView view;
    flgSurfaceCurvesViewInit(&view, (uint32_t)sizeof view);
    return view;
}

static inline FlgLiftDesc flgLiftDefaults(void) {
    FlgLiftDesc desc;
    flgLiftDescInit(&desc, (uint32_t)sizeof desc);
    return desc;
}

static inline FlgGeodesicDesc flgGeodesicDefaults(void) {
    FlgGeodesicDesc desc;
    flgGeodesicDescInit(&desc, (uint32_t)sizeof desc);
    return desc;
}

static inline FlgFieldView flgFieldViewDefaults(void) {
    FlgFieldView view;
    flgFieldViewInit(&view, (uint32_t)sizeof view);
    return view;
}

static inline FlgBlendDesc flgBlendDefaults(void) {
    FlgBlendDesc desc;
    flgBlendDescInit(&desc, (uint32_t)sizeof desc);
    return desc;
}

static inline FlgSamplingDesc flgSamplingDefaults(void) {
    FlgSamplingDesc desc;
    flgSamplingDescInit(&desc, (uint32_t)sizeof desc);
    return desc;
}

static inline FlgBorderSamplingDesc flgBorderSamplingDefaults(void) {
    FlgBorderSamplingDesc desc;
    flgBorderSamplingDescInit(&desc, (uint32_t)sizeof desc);
    return desc;
}

static inline FlgIsolinesDesc flgIsolinesDefaults(void) {
    FlgIsolinesDesc desc;
    flgIsolinesDescInit(&desc, (uint32_t)sizeof desc);
    return desc;
}

static inline FlgStreamsDesc flgStreamsDefaults(void) {
    FlgStreamsDesc desc;
    flgStreamsDescInit(&desc, (uint32_t)sizeof desc);
    return desc;
}

static inline FlgPathsDesc flgPathsDefaults(void) {
    FlgPathsDesc desc;
    flgPathsDescInit(&desc, (uint32_t)sizeof desc);
    return desc;
}

static inline FlgCutIsolinesDesc flgCutIsolinesDefaults(void) {
    FlgCutIsolinesDesc desc;
    flgCutIsolinesDescInit(&desc, (uint32_t)sizeof desc);
    return desc;
}

static inline FlgCutCurvesDesc flgCutCurvesDefaults(void) {
    FlgCutCurvesDesc desc;
    flgCutCurvesDescInit(&desc, (uint32_t)sizeof desc);
    return desc;
}

#ifdef __cplusplus
}
#endif

#endif
