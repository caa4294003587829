/* SPDX-License-Identifier: MIT
 * SPDX-FileCopyrightText: 2026 The Filigree authors
 *
 * Smooth curves that stay on anything: energy-minimizing splines in manifolds (Hofer, Pottmann 2004). It follows the
 * grammar of filigree.h and filigree_surface.h. Coordinates are doubles, metres; parameters are lengths unless the host
 * gives them.
 */
#ifndef FILIGREE_FILIGREE_SPLINE_H
#define FILIGREE_FILIGREE_SPLINE_H

#include "filigree_surface.h"

#ifdef __cplusplus
extern "C" {
#endif

/* What curves stay on: a surface of dimension k in R^n. Never changes once ready. */
FLG_HANDLE(FlgManifold);
/* A curve through points of a manifold. Never changes once ready. */
FLG_HANDLE(FlgSpline);

/* Dimensions of the space that a manifold lies in, at most. */
#define FLG_MANIFOLD_MAX_AMBIENT 12u
/* Nodes of a spline, at most. */
#define FLG_SPLINE_MAX_NODES (1u << 20)

/* ---- Manifolds --------------------------------------------------------------------------------------------------- */

/* Manifolds that need no data. */
typedef enum FlgShape {
    FLG_SHAPE_SPACE = 0,  /* R^ambient itself: nothing restricts a curve */
    FLG_SHAPE_PLANE = 1,  /* z = 0 in R^3 */
    FLG_SHAPE_SPHERE = 2, /* about the origin of R^3, of `radius` */
    FLG_SHAPE_TORUS = 3,  /* about the z-axis: the circle of `radius` in the plane z = 0, of thickness `tube_radius` */
    FLG_SHAPE_FORMULA = 4, /* the zero set of a smooth formula, by `name`: see flgFormulaName */
    FLG_SHAPE_FORCE_32BIT = 0x7fffffff
} FlgShape;

typedef struct FlgShapeDesc {
    uint32_t struct_size;
    FlgShape shape;     /* default FLG_SHAPE_SPACE */
    uint32_t ambient;   /* of FLG_SHAPE_SPACE: 2 to 12. Default 3 */
    uint32_t reserved;
    double radius;      /* metres, 1e-6 to 1e6. Default 1 */
    double tube_radius; /* metres, 1e-6 to below radius. Default 0.25 */
    double size;        /* metres, of FLG_SHAPE_SPACE and FLG_SHAPE_PLANE: about how large what happens there is.
                         * Default 1 */
    const char* name;   /* of FLG_SHAPE_FORMULA */
} FlgShapeDesc;

FLG_API FlgResult flgShapeDescInit(FlgShapeDesc* desc, uint32_t struct_size);

/* Makes a manifold at once. Cost: 0.1 ms at most. */
FLG_API FlgResult flgManifoldCreateShape(FlgContext context, const FlgShapeDesc* desc, FlgManifold* out_manifold);

/* The names of formulas, from number 0 on; null beyond the last one. They live for ever. */
FLG_API const char* flgFormulaName(uint32_t number);

typedef struct FlgMeshManifoldDesc {
    uint32_t struct_size;
    uint32_t reserved;
    FlgJobOptions job;
    FlgSurface surface; /* kept by the manifold; a later cut of it does not change the manifold */
} FlgMeshManifoldDesc;

FLG_API FlgResult flgMeshManifoldDescInit(FlgMeshManifoldDesc* desc, uint32_t struct_size);

/* Starts a job that makes the smooth surface of a mesh: moving least squares over its vertices, with their normals and
 * curvatures. It follows smooth parts to the square of the edges' lengths and rounds creases off; how far its vertices
 * are from it is in the manifold's view. Thin solids keep their sides apart; two sheets that face the same way blend
 * where they are nearer than an edge is long. Across edges sharper than some 114 degrees tangents jump, and curves may
 * stall there. At open borders it goes on a little: FLG_OBSTACLE_BORDER keeps curves from there. Cost: about 1 us a
 * triangle. */
FLG_API FlgResult flgManifoldCreateFromSurface(FlgContext context, const FlgMeshManifoldDesc* desc,
                                               FlgManifold* out_manifold, FlgJob* out_job);

typedef struct FlgCloudManifoldDesc {
    uint32_t struct_size;
    uint32_t point_count; /* 4 to 2^24 */
    FlgJobOptions job;
    const float* points;  /* 3 a point, metres; read during the call */
    const float* normals; /* 3 a point, not 0; or null: found, and turned alike along the cloud */
    uint32_t neighbours;  /* how many points a point's surroundings are, 6 to 32: more of them smooth more. Default
                           * 16 */
    uint32_t reserved;
} FlgCloudManifoldDesc;

FLG_API FlgResult flgCloudManifoldDescInit(FlgCloudManifoldDesc* desc, uint32_t struct_size);

/* Starts a job that makes the smooth surface of a cloud of points by moving least squares (sec. 3.2). Cost: some us a
 * point. */
FLG_API FlgResult flgManifoldCreateFromPoints(FlgContext context, const FlgCloudManifoldDesc* desc,
                                              FlgManifold* out_manifold, FlgJob* out_job);

typedef struct FlgGridManifoldDesc {
    uint32_t struct_size;
    uint32_t counts[3];  /* samples along x, y, z: 2 to 65536 each, 2^31 in all */
    FlgJobOptions job;
    double origin[3];    /* of the first sample, metres */
    double spacing;      /* metres, above 0 */
    const float* values; /* x fastest: a function that is negative inside and has no flat place at 0; read during the
                          * call */
} FlgGridManifoldDesc;

FLG_API FlgResult flgGridManifoldDescInit(FlgGridManifoldDesc* desc, uint32_t struct_size);

/* Starts a job that makes the zero set of a sampled function, such as signed distances. Cost: about 20 ns a sample. */
FLG_API FlgResult flgManifoldCreateFromGrid(FlgContext context, const FlgGridManifoldDesc* desc,
                                            FlgManifold* out_manifold, FlgJob* out_job);

/* The image manifold of a surface's normals (sec. 6, Fig. 17): (x, weight * normal) in R^6. Curves on it avoid crossing
 * creases, the more the larger the weight (metres, above 0) is. `base`: a surface in R^3, ready. Points are given and
 * shown in R^3: the normals are added and left out. Cost: 0.1 ms at most. */
FLG_API FlgResult flgManifoldCreateImage(FlgContext context, FlgManifold base, double weight,
                                         FlgManifold* out_manifold);

/* A manifold of the host's own. Functions are called from worker threads, several at a time; they must not throw, call
 * the SDK or take more than some us, and give the same numbers for the same arguments. */
typedef struct FlgManifoldFunctions {
    uint32_t struct_size;
    uint32_t ambient;     /* n, 2 to 12 */
    uint32_t dimension;   /* k, 1 to n */
    uint32_t memory_size; /* doubles that are kept with each point, 0 to 256; zeros at first. Default 0 */
    double size;          /* metres: about how large it is, above 0. Default 1 */
    void* user_data;      /* passed to the functions */
    /* Moves point (n numbers) onto the surface, near it; 0 if there is no point to be found. */
    int32_t (*project)(void* user_data, double* point, double* memory);
    /* k rows of n numbers: an orthonormal basis of the tangent space at a projected point. */
    void (*tangent_basis)(void* user_data, const double* point, double* memory, double* basis);
    /* k x k numbers: the inner products of `force` (n numbers) with the second fundamental form in the basis. Null:
     * from differences of projections. */
    void (*second_form)(void* user_data, const double* point, double* memory, const double* basis, const double* force,
                        double* form);
} FlgManifoldFunctions;

FLG_API FlgResult flgManifoldFunctionsInit(FlgManifoldFunctions* functions, uint32_t struct_size);

/* Makes a manifold of a copy of the functions; user_data must live until it and all splines on it are released. Tries
 * them at one point and refuses what is not orthonormal or not finite there. Cost: some calls of the functions. */
FLG_API FlgResult flgManifoldCreateHost(FlgContext context, const FlgManifoldFunctions* functions,
                                        const double* point_near, FlgManifold* out_manifold);

/* A surface in R^3 that the host knows by two parameters. */
typedef struct FlgPatchFunctions {
    uint32_t struct_size;
    uint32_t periodic[2]; /* nonzero: the parameter u, v has the period high - low. Default 0: the domain ends there */
    uint32_t reserved;
    double low[2], high[2]; /* the domain. Default 0 to 1 */
    double margin;          /* of a domain that ends, in shares of it: so far beyond its ends points are still taken,
                             * twice as far the function is asked. 0 to 1. Default 0.05 */
    double size;            /* metres: about how large it is. Default 1 */
    void* user_data;        /* passed to the function; lives until the manifold and all splines on it are released */
    /* Writes 18 numbers: the point and its derivatives u, v, uu, uv, vv; u and v are nowhere parallel, their cross
     * product points outwards. From worker threads, several at a time; must not throw or call the SDK, 100 ns at
     * most. */
    void (*evaluate)(void* user_data, double u, double v, double* out);
} FlgPatchFunctions;

FLG_API FlgResult flgPatchFunctionsInit(FlgPatchFunctions* functions, uint32_t struct_size);

/* Makes a manifold of a copy of these at once; asks for 1089 points of it. Refuses what is not finite there, and
 * derivatives that are parallel. Fixed points such as poles are to be left out of the domain.
 * Cost: 1089 calls of the function. */
FLG_API FlgResult flgManifoldCreatePatch(FlgContext context, const FlgPatchFunctions* functions,
                                         FlgManifold* out_manifold);

typedef struct FlgManifoldView {
    uint32_t struct_size;
    uint32_t ambient;         /* n, that points are given and shown in */
    uint32_t dimension;       /* k */
    uint32_t reserved;
    double size;              /* metres */
    double largest_deviation; /* metres: of what it was made of (vertices, points) from it; 0 where it is exact */
    double mean_deviation;    /* root mean square of the same */
} FlgManifoldView;

FLG_API FlgResult flgManifoldViewInit(FlgManifoldView* view, uint32_t struct_size);
/* FLG_NOT_READY before the manifold's job is published, its error if it failed. */
FLG_API FlgResult flgManifoldGetView(FlgContext context, FlgManifold manifold, FlgManifoldView* out_view);

/* Moves up to 64 points onto a manifold, at once: a cursor's, some us each. out_distances, metres, may be null; a point
 * that can't be projected stays and gets HUGE_VAL. FLG_NOT_READY before the manifold's job is published.
 * Cost: some us a point. */
FLG_API FlgResult flgManifoldProject(FlgContext context, FlgManifold manifold, double* points, uint32_t point_count,
                                     double* out_distances);

FLG_API FlgResult flgManifoldRelease(FlgContext context, FlgManifold manifold);

/* ---- Obstacles
 * ---------------------------------------------------------------------------------------------------- */

/* Solids that curves of the plane or of space keep out of. Never change once ready. */
FLG_HANDLE(FlgObstacles);

/* What an obstacle is, and which of its fields count. */
typedef enum FlgObstacleKind {
    FLG_OBSTACLE_BALL = 0,     /* centre, radius */
    FLG_OBSTACLE_BOX = 1,      /* centre, half, axes */
    FLG_OBSTACLE_CAPSULE = 2,  /* all within `radius` of the segment from centre to `to` */
    FLG_OBSTACLE_POLYGON = 3,  /* of the plane: points */
    FLG_OBSTACLE_FUNCTION = 4, /* the host's */
    FLG_OBSTACLE_MESH = 5,     /* of space: surface, a closed one, to half a cell of a grid of `cells` */
    FLG_OBSTACLE_LAYER = 6,    /* of space: all that is farther than `radius` from surface, an open one: curves stay in
                                * a thin layer around it, and so between its borders (sec. 5) */
    FLG_OBSTACLE_BORDER = 7,   /* of space: what is beyond the open borders of surface, for curves on its manifold;
                                * takes no grid and so is quicker and nearer than a layer. Corners of borders are
                                * rounded by about an edge */
    FLG_OBSTACLE_KIND_FORCE_32BIT = 0x7fffffff
} FlgObstacleKind;

/* Of the plane only x and y count. Metres. */
typedef struct FlgObstacle {
    FlgObstacleKind kind;
    uint32_t point_count; /* 3 to 256 */
    FlgSurface surface;
    uint32_t cells;       /* of the grid along the longest side, 8 to 192; a layer is 4 of them thick at least. Default
                           * 64 */
    uint32_t reserved;
    double centre[3];     /* of balls, boxes, capsules, and of the box around a function */
    double half[3];       /* half the box's sides, above 0 */
    double axes[9];       /* rows: the box's axes, orthonormal to 1e-6; in the plane the first two numbers of the first
                           * two */
    double to[3];         /* a capsule's other end */
    double radius;        /* above 0 */
    const double* points; /* 2 a point: a simple polygon, either way around; read during the call */
    /* Of FUNCTION, called from any thread; a value that is positive outside and nowhere more than the distance, and its
     * gradient, which is not 0 within half a `half` of where it is 0. centre and half: a box with all of the solid in
     * it. */
    double (*value)(void* user_data, const double* x, double* gradient);
    void* user_data;      /* lives until the obstacles and all splines among them are released */
} FlgObstacle;

/* A ball of radius 1 about the origin; a box of sides of 2. */
FLG_API void flgObstacleInit(FlgObstacle* obstacle);

typedef struct FlgObstaclesDesc {
    uint32_t struct_size;
    uint32_t dimension;      /* 2 or 3. Default 3 */
    FlgJobOptions job;
    const FlgObstacle* obstacles; /* copied, but for what their user_data points to */
    uint32_t obstacle_count; /* 1 to 256 */
    uint32_t reserved;
    double clearance;        /* metres, at least 0: how far curves stay away, such as the radius of a body whose centre
                              * they are. Default 0 */
} FlgObstaclesDesc;

FLG_API FlgResult flgObstaclesDescInit(FlgObstaclesDesc* desc, uint32_t struct_size);

/* Starts a job that makes obstacles (sec. 5); splines may be asked for before it is done. Refuses, and names the
 * obstacle, sizes that are not positive, polygons that cross themselves, axes that are not orthonormal; the job fails
 * for meshes that hold nothing, layers thinner than 4 cells, surfaces without borders. Cost: of meshes 100 to 500 ns a
 * cell of their grid. */
FLG_API FlgResult flgObstaclesCreate(FlgContext context, const FlgObstaclesDesc* desc, FlgObstacles* out_obstacles,
                                     FlgJob* out_job);
FLG_API FlgResult flgObstaclesRelease(FlgContext context, FlgObstacles obstacles);

/* On which side a curve passes an obstacle: while its first curve is found the obstacle goes on without end against the
 * direction. In the plane what the optimization does later keeps to it; in space there is no other side of a ball, and
 * the curve may slide over it to where it bends less. */
typedef struct FlgObstacleSide {
    uint32_t obstacle; /* its number in FlgObstaclesDesc */
    uint32_t reserved;
    double direction[3]; /* from the obstacle to where the curve passes; any length but 0 */
} FlgObstacleSide;

/* ---- Splines
 * ------------------------------------------------------------------------------------------------------ */

/* What a curve has as little of as it can. */
typedef enum FlgSplineEnergy {
    FLG_SPLINE_E2 = 0, /* the square of the second derivative: cubic splines. Wide, even turns */
    FLG_SPLINE_E1 = 1, /* the square of the first one: geodesics, with corners at the points */
    FLG_SPLINE_ET = 2, /* E2 + tension * E1: between the two */
    FLG_SPLINE_ENERGY_FORCE_32BIT = 0x7fffffff
} FlgSplineEnergy;

/* The first curve, which is then optimized. */
typedef enum FlgSplineStart {
    FLG_SPLINE_START_GEODESIC = 0,  /* about the shortest ways from point to point */
    FLG_SPLINE_START_PROJECTED = 1, /* the spline that nothing restricts, projected; for points that are near to each
                                     * other */
    FLG_SPLINE_START_FORCE_32BIT = 0x7fffffff
} FlgSplineStart;

/* How a round steps. */
typedef enum FlgSplineMethod {
    FLG_SPLINE_NEWTON = 0,        /* a few rounds */
    FLG_SPLINE_FOOTPOINT_CONE = 1, /* the paper's stepsize (Algorithm 1); for comparison, and where a manifold has no
                                    * second derivatives */
    FLG_SPLINE_METHOD_FORCE_32BIT = 0x7fffffff
} FlgSplineMethod;

typedef struct FlgSplineDesc {
    uint32_t struct_size;
    uint32_t point_count;      /* 2 to 65536, closed: 3 at least (1 and 2 less where a `curve` is given) */
    FlgJobOptions job;         /* partial_results: every round can be seen */
    FlgManifold manifold;
    const double* points;      /* ambient numbers a point: to be passed through in this order, read during the call.
                                * Points off the manifold are projected, how far is in the view; two in a row must not
                                * come to one place */
    const double* parameters;  /* one a point, closed: one more, of the first point again; ascending. Null: lengths of
                                * the curve */
    uint32_t closed;           /* nonzero: from the last point back to the first. Default 0 */
    FlgSplineEnergy energy;    /* default FLG_SPLINE_E2 */
    double tension;            /* of FLG_SPLINE_ET: w, 1 / square metre, above 0 to 1e12. Default 1 */
    double smoothing;          /* 0: through the points. Above: the energy plus the squares of the distances to the
                                * points over this is least; metres to the third with E2 and lengths. Default 0 */
    double first_tension;      /* begins with this tension, which falls by 4 a round (sec. 3.2, homotopy). Default 0: it
                                * does not */
    const double* begin_slope; /* ambient numbers: the derivative by the parameter at the first point, its tangent part
                                * is taken; open curves only. Null: natural, no bending at the end */
    const double* end_slope;   /* the same at the last point */
    FlgSplineStart start;      /* default FLG_SPLINE_START_GEODESIC */
    FlgSplineMethod method;    /* default FLG_SPLINE_NEWTON */
    uint32_t node_count;       /* points of the chain that stands for the curve, given ones included: up to 2^20, at
                                * least two intervals from one given point to the next. Default 0: 32 intervals each */
    uint32_t max_rounds;       /* of the optimization, 1 to 10000; a few smooth a curve a little (Remark 5). Default
                                * 200 */
    double tolerance;          /* of the residual, see the view; 1e-12 to 1. Default 1e-6 */
    FlgSpline warm_start;      /* begin at this one, of as many points on the same manifold, moved along: for points
                                * that are dragged. If that failed or does not fit it is not used. Of several curves of
                                * little energy it stays with the one it comes from, which a cold start may not find.
                                * Default none */
    /* A curve to be made fair or to be refined, instead of points in space: its points are the nodes, in order, and
     * points[i] is what node curve_knots[i] is held at (ascending; of open curves the first and the last node are among
     * them). node_count, start and warm_start do not count then. Default null */
    const double* curve;
    const uint32_t* curve_knots; /* one a given point: its node */
    uint32_t curve_count;      /* nodes of `curve`, 2 (closed: 3) to 2^20 */
    uint32_t subdivisions;     /* rounds of variational subdivision (Remark 6) afterwards: each puts one node between
                                * two, and optimizes all but the given points again. 0 to 8. Default 0 */
    uint32_t side_count;       /* of `sides`. Default 0 */
    /* The curve stays out of these (sec. 5): the manifold is a FLG_SHAPE_SPACE of as many dimensions, or a surface
     * in R^3. It is what splines on barriers around them become whose radius shrinks to `obstacle_radius` of the
     * scene's size; it may touch them along a stretch. A given point in an obstacle is refused. Nodes keep out of
     * obstacles, and pieces between them do but for their sagitta; there are up to 16 times as many nodes where
     * pieces would go through. In space the first curve goes around them, on a surface the start is without them,
     * and sides do not count. `start`, `warm_start`, slopes and subdivisions do not count, `curve` is refused.
     * Default none */
    FlgObstacles obstacles;
    const FlgObstacleSide* sides; /* how the first curve passes; default null: the shortest way */
    double obstacle_radius;    /* 1e-5 to 0.1. Default 1e-3 */
} FlgSplineDesc;

FLG_API FlgResult flgSplineDescInit(FlgSplineDesc* desc, uint32_t struct_size);

/* Starts a job that makes the curve of least energy through points of a manifold, among those that the first curve can
 * be moved to: a chain of nodes on the manifold such that what is tangent to it of the curve's fourth derivative (E1:
 * second) vanishes between the given points. Fails with FLG_ERROR_INVALID_ARGUMENT, and a sentence, where a point can't
 * be projected, two in a row coincide, or no way leads from one to the next (put points between). Antipodal points of a
 * sphere: a half circle, always the same one. Two points: a geodesic, with E2 as well. If rounds are used up or
 * rounding lets it get no nearer the curve is there, and the view says so. Cost: 1 us a node and round on a mesh, and 3
 * to 8 rounds. */
FLG_API FlgResult flgSplineCreate(FlgContext context, const FlgSplineDesc* desc, FlgSpline* out_spline,
                                  FlgJob* out_job);

/* Why the optimization ended. There is a curve in each case. */
typedef enum FlgSplineEnding {
    FLG_SPLINE_RUNNING = 0,   /* what is shown is a round's result */
    FLG_SPLINE_CONVERGED = 1, /* the residual is at most the tolerance */
    FLG_SPLINE_ROUNDING = 2,  /* as near as rounding allows: with thousands of nodes between points differences vanish
                               * */
    FLG_SPLINE_ROUNDS = 3,    /* max_rounds are used up */
    FLG_SPLINE_STALLED = 4,   /* no step leads down: the surface is not smooth where the curve wants to be (sharp
                               * creases, rims), or obstacles leave no way there. The curve is what it got to; see the
                               * residual */
    FLG_SPLINE_ENDING_FORCE_32BIT = 0x7fffffff
} FlgSplineEnding;

typedef struct FlgSplineView {
    uint32_t struct_size;
    uint32_t ambient;         /* n */
    uint32_t node_count;
    uint32_t point_count;
    uint32_t closed; /* as asked for */
    FlgSplineEnding ending;
    const double* nodes;      /* n a node */
    const double* parameters; /* one a node, closed: one more */
    const float* normals;     /* 3 a node, unit: the surface's, outwards; null if it isn't one in R^3, and while it is
                               * running */
    const uint32_t* point_nodes; /* one a given point: its node */
    const double* offsets;    /* one a given point, metres: how far it was from the manifold */
    double largest_offset;    /* of these, metres */
    uint32_t rounds;          /* of the optimization */
    uint32_t projections;     /* of all nodes onto the manifold */
    double energy;            /* with all weights */
    double bending;           /* E2: exact for the spline of R^n through the nodes */
    double stretching;        /* E1 of the chain */
    double length;            /* metres, of the chain */
    /* Tangential part of the fourth derivative (with tension less w times the second, of E1 the second) at nodes that
     * are free, root mean square, over the mean of all elastic forces along the curve, those at the given points
     * included. */
    double residual;
} FlgSplineView;

FLG_API FlgResult flgSplineViewInit(FlgSplineView* view, uint32_t struct_size);

/* The arrays live until the spline is released; of running ones until the next flgTick. FLG_NOT_READY before its job is
 * published (with partial_results: before its first round), its error if it failed. */
FLG_API FlgResult flgSplineGetView(FlgContext context, FlgSpline spline, FlgSplineView* out_view);

typedef struct FlgSplineCurvesDesc {
    uint32_t struct_size;
    float height;      /* metres above the surface, along its normals. Default 0 */
    FlgJobOptions job;
    FlgSpline spline;  /* of R^3 */
} FlgSplineCurvesDesc;

FLG_API FlgResult flgSplineCurvesDescInit(FlgSplineCurvesDesc* desc, uint32_t struct_size);

/* Starts a job that copies a spline into a curve set with POSITION, TIME (its parameter) and, on a surface in R^3,
 * NORMAL: to be stylized in the surface's frame (FLG_FRAME_SUPPLIED), drawn, projected, cut in.
 * Cost: about 3 ns a node. */
FLG_API FlgResult flgSplineCurves(FlgContext context, const FlgSplineCurvesDesc* desc, FlgCurveSet* out_set,
                                  FlgJob* out_job);

FLG_API FlgResult flgSplineRelease(FlgContext context, FlgSpline spline);

/* ---- Defaults by value ------------------------------------------------------------------------------------------- */

static inline FlgShapeDesc flgShapeDefaults(void) {
    FlgShapeDesc desc;
    flgShapeDescInit(&desc, (uint32_t)sizeof desc);
    return desc;
}

static inline FlgMeshManifoldDesc flgMeshManifoldDefaults(void) {
    FlgMeshManifoldDesc desc;
    flgMeshManifoldDescInit(&desc, (uint32_t)sizeof desc);
    return desc;
}

static inline FlgCloudManifoldDesc flgCloudManifoldDefaults(void) {
    FlgCloudManifoldDesc desc;
    flgCloudManifoldDescInit(&desc, (uint32_t)sizeof desc);
    return desc;
}

static inline FlgGridManifoldDesc flgGridManifoldDefaults(void) {
    FlgGridManifoldDesc desc;
    flgGridManifoldDescInit(&desc, (uint32_t)sizeof desc);
    return desc;
}

static inline FlgManifoldFunctions flgManifoldFunctionsDefaults(void) {
    FlgManifoldFunctions functions;
    flgManifoldFunctionsInit(&functions, (uint32_t)sizeof functions);
    return functions;
}

static inline FlgPatchFunctions flgPatchFunctionsDefaults(void) {
    FlgPatchFunctions functions;
    flgPatchFunctionsInit(&functions, (uint32_t)sizeof functions);
    return functions;
}

static inline FlgManifoldView flgManifoldViewDefaults(void) {
    FlgManifoldView view;
    flgManifoldViewInit(&view, (uint32_t)sizeof view);
    return view;
}

static inline FlgObstaclesDesc flgObstaclesDefaults(void) {
    FlgObstaclesDesc desc;
    flgObstaclesDescInit(&desc, (uint32_t)sizeof desc);
    return desc;
}

static inline FlgSplineDesc flgSplineDefaults(void) {
    FlgSplineDesc desc;
    flgSplineDescInit(&desc, (uint32_t)sizeof desc);
    return desc;
}

static inline FlgSplineView flgSplineViewDefaults(void) {
    FlgSplineView view;
    flgSplineViewInit(&view, (uint32_t)sizeof view);
    return view;
}

static inline FlgSplineCurvesDesc flgSplineCurvesDefaults(void) {
    FlgSplineCurvesDesc desc;
    flgSplineCurvesDescInit(&desc, (uint32_t)sizeof desc);
    return desc;
}

static inline FlgObstacle flgObstacleDefaults(void) {
    FlgObstacle obstacle;
    flgObstacleInit(&obstacle);
    return obstacle;
}

#ifdef __cplusplus
}
#endif

#endif
