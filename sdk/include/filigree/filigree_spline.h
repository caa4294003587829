/* SPDX-License-Identifier: MIT
 * SPDX-FileCopyrightText: 2026 The Filigree authors
 *
 * Smooth curves that stay on anything: energy-minimizing splines in manifolds (Hofer, Pottmann 2004). Follows the
 * grammar of filigree.h and filigree_surface.h. Coordinates are doubles, metres; parameters are lengths unless the host
 * provides them.
 */
#ifndef FILIGREE_FILIGREE_SPLINE_H
#define FILIGREE_FILIGREE_SPLINE_H

#include "filigree_surface.h"

#ifdef __cplusplus
extern "C" {
#endif

/* A surface of dimension k in R^n that curves stay on. Never changes once ready. */
FLG_HANDLE(FlgManifold);
/* A curve through points of a manifold. Never changes once ready. */
FLG_HANDLE(FlgSpline);

/* Maximum dimension of the space around a manifold. */
#define FLG_MANIFOLD_MAX_AMBIENT 12u
/* Maximum nodes of a spline. */
#define FLG_SPLINE_MAX_NODES (1u << 20)

/* ---- Manifolds --------------------------------------------------------------------------------------------------- */

/* Manifolds that need no data. */
typedef enum FlgManifoldShape {
    FLG_MANIFOLD_SHAPE_SPACE = 0,   /* R^ambient itself: no restriction */
    FLG_MANIFOLD_SHAPE_PLANE = 1,   /* z = 0 in R^3 */
    FLG_MANIFOLD_SHAPE_SPHERE = 2,  /* centred at the origin of R^3, of `radius` */
    FLG_MANIFOLD_SHAPE_TORUS = 3,   /* around the z-axis: the circle of `radius` in the plane z = 0, thickened by
                                       `tube_radius` */
    FLG_MANIFOLD_SHAPE_FORMULA = 4, /* the zero set of a smooth formula, by `name`: see flgFormulaGetName */
    FLG_MANIFOLD_SHAPE_FORCE_32BIT = 0x7fffffff
} FlgManifoldShape;

typedef struct FlgManifoldShapeDesc {
    uint32_t struct_size;
    FlgManifoldShape shape; /* default FLG_MANIFOLD_SHAPE_SPACE */
    uint32_t ambient;       /* for FLG_MANIFOLD_SHAPE_SPACE: 2 to 12. Default 3 */
    uint32_t reserved;
    double radius;      /* metres, 1e-6 to 1e6. Default 1 */
    double tube_radius; /* metres, 1e-6 to below radius. Default 0.25 */
    double size;        /* metres, for FLG_MANIFOLD_SHAPE_SPACE and FLG_MANIFOLD_SHAPE_PLANE: approximate extent of
                           the scene. Default 1 */
    const char* name;   /* for FLG_MANIFOLD_SHAPE_FORMULA */
    double origin[3];   /* metres, in R^3: where the shape is; its coordinates are relative to this. Must be 0 for
                           FLG_MANIFOLD_SHAPE_SPACE, which is everywhere. Default 0 */
} FlgManifoldShapeDesc;

FLG_API FlgResult flgManifoldShapeDescInit(FlgManifoldShapeDesc* desc, uint32_t struct_size);

/* Makes a manifold at once. Cost: 0.1 ms at most. */
FLG_API FlgResult flgManifoldCreateShape(FlgContext context, const FlgManifoldShapeDesc* desc,
                                         FlgManifold* out_manifold);

/* The names of formulas, from index 0 on; null beyond the last one. Static strings. */
FLG_API const char* flgFormulaGetName(uint32_t number);

typedef struct FlgManifoldFromSurfaceDesc {
    uint32_t struct_size;
    uint32_t reserved;
    const FlgJobOptions* job;
    FlgSurface surface; /* kept by the manifold; later cuts do not change the manifold */
    double smoothing_scale; /* metres: the surface is seen through this scale; smaller noise, relief and creases are
                               rounded off, as by a road over rough ground. At most a quarter of the surface's size.
                               Default 0: as the mesh is */
} FlgManifoldFromSurfaceDesc;

FLG_API FlgResult flgManifoldFromSurfaceDescInit(FlgManifoldFromSurfaceDesc* desc, uint32_t struct_size);

/* Starts a job that makes the smooth surface of a mesh: moving least squares over its vertices, with their normals and
 * curvatures. Its error on smooth parts is quadratic in edge length; creases are rounded off. The manifold's view gives
 * the deviation of its vertices. Opposite sides of thin solids stay apart; two sheets that face the same way blend
 * where they are closer than an edge length. Tangents jump across edges sharper than about 114 degrees, where nodes of
 * curves are held (see FlgSplineView). Curves may go a quarter of an edge beyond open borders, and run along
 * there where they would go farther. FLG_OBSTACLE_KIND_BORDER keeps them within the borders.
 * Cost: about 1 us a triangle. */
FLG_API FlgResult flgManifoldCreateFromSurface(FlgContext context, const FlgManifoldFromSurfaceDesc* desc,
                                               FlgManifold* out_manifold, FlgJob* out_job);

typedef struct FlgManifoldFromPointsDesc {
    uint32_t struct_size;
    uint32_t point_count; /* 4 to 2^24 */
    const FlgJobOptions* job;
    const float* points;  /* 3 per point, metres; read during the call */
    const float* normals; /* 3 per point, not 0; null: computed, and oriented consistently along the cloud */
    uint32_t neighbours;  /* points in each neighbourhood, 6 to 32: more smooth more. Default 16 */
    uint32_t reserved;
    double smoothing_scale; /* metres, see FlgManifoldFromSurfaceDesc. Default 0 */
    double origin[3];     /* metres: what points are relative to. Default 0 */
} FlgManifoldFromPointsDesc;

FLG_API FlgResult flgManifoldFromPointsDescInit(FlgManifoldFromPointsDesc* desc, uint32_t struct_size);

/* Starts a job that makes the smooth surface of a point cloud by moving least squares (sec. 3.2). Cost: some us a
 * point. */
FLG_API FlgResult flgManifoldCreateFromPoints(FlgContext context, const FlgManifoldFromPointsDesc* desc,
                                              FlgManifold* out_manifold, FlgJob* out_job);

typedef struct FlgManifoldFromGridDesc {
    uint32_t struct_size;
    uint32_t counts[3];  /* samples along x, y, z: 2 to 65536 each, 2^31 in total */
    const FlgJobOptions* job;
    double corner[3];    /* position of the first sample, metres */
    double spacing;      /* metres, above 0 */
    const float* values; /* x fastest: a function that is negative inside and nowhere flat at 0; read during the call */
    double origin[3];    /* metres: what `corner` is relative to. Default 0 */
} FlgManifoldFromGridDesc;

FLG_API FlgResult flgManifoldFromGridDescInit(FlgManifoldFromGridDesc* desc, uint32_t struct_size);

/* Starts a job that makes the zero set of a sampled function, such as signed distances. Cost: about 20 ns a sample. */
FLG_API FlgResult flgManifoldCreateFromGrid(FlgContext context, const FlgManifoldFromGridDesc* desc,
                                            FlgManifold* out_manifold, FlgJob* out_job);

/* The image manifold of a surface's normals (sec. 6, Fig. 17): (x, weight * normal) in R^6. Curves on it avoid crossing
 * creases; the larger the weight (metres, above 0), the more. `base`: a surface in R^3, ready. Points are given and
 * shown in R^3; the normals are added and dropped internally. Cost: 0.1 ms at most. */
FLG_API FlgResult flgManifoldCreateImage(FlgContext context, FlgManifold base, double weight,
                                         FlgManifold* out_manifold);

/* A manifold defined by the host. Worker threads call the functions, several at a time. They must not throw, call the
 * SDK or take more than some us, and must give the same numbers for the same arguments. */
typedef struct FlgManifoldFunctions {
    uint32_t struct_size;
    uint32_t ambient;     /* n, 2 to 12 */
    uint32_t dimension;   /* k, 1 to n */
    uint32_t memory_size; /* doubles stored with each point, 0 to 256; zeros at first. Default 0 */
    double size;          /* metres: approximate size, above 0. Default 1 */
    void* user_data;      /* passed to the functions */
    /* Moves point (n numbers) onto the surface nearby; returns 0 if no point can be found. */
    int32_t (*project)(void* user_data, double* point, double* memory);
    /* k rows of n numbers: an orthonormal basis of the tangent space at a projected point. */
    void (*tangent_basis)(void* user_data, const double* point, double* memory, double* basis);
    /* k x k numbers: the inner products of `force` (n numbers) with the second fundamental form in the basis. Null:
     * computed from differences of projections. */
    void (*second_form)(void* user_data, const double* point, double* memory, const double* basis, const double* force,
                        double* form);
    double origin[3]; /* metres: what the functions' coordinates are relative to; 0 unless in R^3. Default 0 */
} FlgManifoldFunctions;

FLG_API FlgResult flgManifoldFunctionsInit(FlgManifoldFunctions* functions, uint32_t struct_size);

/* Makes a manifold from a copy of the functions; user_data must live until the manifold and all splines on it are
 * released. Tests the functions at one point, and refuses results that are not orthonormal or not finite. Cost: some
 * calls of the functions. */
FLG_API FlgResult flgManifoldCreateHost(FlgContext context, const FlgManifoldFunctions* functions,
                                        const double* point_near, FlgManifold* out_manifold);

/* A surface in R^3 that the host parametrizes. */
typedef struct FlgPatchFunctions {
    uint32_t struct_size;
    uint32_t periodic[2]; /* nonzero: parameter u or v has the period high - low. Default 0: the domain ends there */
    uint32_t reserved;
    double low[2], high[2]; /* the domain. Default 0 to 1 */
    double margin;          /* extends a domain that ends, as a fraction of it: points this far beyond its ends are
                               still accepted, and the function is called up to twice as far. 0 to 1. Default 0.05 */
    double size;            /* metres: approximate size. Default 1 */
    void* user_data;        /* passed to the function; lives until the manifold and all splines on it are released */
    /* Writes 18 numbers: the point and its derivatives u, v, uu, uv, vv. u and v must never be parallel; their cross
     * product points outwards. Called from worker threads, several at a time; must not throw or call the SDK; 100 ns at
     * most. */
    void (*evaluate)(void* user_data, double u, double v, double* out);
    double origin[3]; /* metres: what the function's points are relative to. Default 0 */
} FlgPatchFunctions;

FLG_API FlgResult flgPatchFunctionsInit(FlgPatchFunctions* functions, uint32_t struct_size);

/* Makes a manifold from a copy of the functions at once, evaluating 1089 points. Refuses results that are not finite,
 * and parallel derivatives. Exclude fixed points such as poles from the domain. Cost: 1089 calls of the function. */
FLG_API FlgResult flgManifoldCreatePatch(FlgContext context, const FlgPatchFunctions* functions,
                                         FlgManifold* out_manifold);

typedef struct FlgManifoldView {
    uint32_t struct_size;
    uint32_t ambient;         /* n, the dimension of points given and shown */
    uint32_t dimension;       /* k */
    uint32_t reserved;
    double size;              /* metres */
    double largest_deviation; /* metres: of the source data (vertices, points) from it; 0 where it is exact */
    double mean_deviation;    /* root mean square of the same deviation */
    double origin[3];         /* metres: what the manifold's points are relative to */
} FlgManifoldView;

FLG_API FlgResult flgManifoldViewInit(FlgManifoldView* view, uint32_t struct_size);
/* FLG_NOT_READY until the manifold's job is published, the job's error if it failed. */
FLG_API FlgResult flgManifoldGetView(FlgContext context, FlgManifold manifold, FlgManifoldView* out_view);

/* Projects up to 64 points, relative to the manifold's origin, onto it at once, such as a cursor's. out_distances
 * (metres) may be null; a point that cannot be projected stays unchanged and gets HUGE_VAL. FLG_NOT_READY until the
 * manifold's job is published. Cost: some us a point. */
FLG_API FlgResult flgManifoldProject(FlgContext context, FlgManifold manifold, double* points, uint32_t point_count,
                                     double* out_distances);

FLG_API FlgResult flgManifoldRelease(FlgContext context, FlgManifold manifold);

/* ---- Obstacles --------------------------------------------------------------------------------------------------- */

/* Solids that curves in the plane or in space avoid. Never change once ready. */
FLG_HANDLE(FlgObstacles);

/* The kind of an obstacle; it determines which fields apply. */
typedef enum FlgObstacleKind {
    FLG_OBSTACLE_KIND_BALL = 0,     /* centre, radius */
    FLG_OBSTACLE_KIND_BOX = 1,      /* centre, half, axes */
    FLG_OBSTACLE_KIND_CAPSULE = 2,  /* everything within `radius` of the segment from centre to `to` */
    FLG_OBSTACLE_KIND_POLYGON = 3,  /* points; in space the prism over it: centre, axes, half[2] */
    FLG_OBSTACLE_KIND_FUNCTION = 4, /* defined by the host */
    FLG_OBSTACLE_KIND_MESH = 5,     /* space only: a closed surface, kept clear of exactly; `cells` as below */
    FLG_OBSTACLE_KIND_LAYER = 6,    /* space only: everything farther than `radius` from an open surface: curves stay
                                       in a thin layer around it, and so between its borders (sec. 5) */
    FLG_OBSTACLE_KIND_BORDER = 7,   /* space only: the region beyond a surface's open borders, for curves on its
                                       manifold. Alone, without other obstacles, nodes keep within exactly, by the
                                       clearance, and the curve may run along the border: between two nodes it may cut
                                       off a corner that points in, a right one by half their distance at most. Beside
                                       others it is a wall like them, which rounds corners by about an edge */
    FLG_OBSTACLE_KIND_HALF_SPACE = 8, /* all on one side of a plane (in the plane, of a line): centre, on the boundary,
                                         and `to`, the direction out of the solid */
    FLG_OBSTACLE_KIND_FORCE_32BIT = 0x7fffffff
} FlgObstacleKind;

/* In the plane only x and y are used. Metres. */
typedef struct FlgObstacle {
    uint32_t struct_size; /* the same of all obstacles of a set */
    FlgObstacleKind kind;
    FlgSurface surface;
    uint32_t cells;       /* grid cells along the longest side, 8 to 192: through them the curve is found. A layer is at
                             least 4 of them thick. Default 64 */
    uint32_t point_count; /* 3 to 256 */
    double centre[3];     /* of balls, boxes, capsules, half-spaces, and the box around a function; in space what a
                             polygon's points are relative to */
    double half[3];       /* half the box's sides, above 0; of a prism the last: half its height */
    double axes[9];       /* rows: the box's axes, orthonormal to 1e-6; in the plane the first two numbers of the first
                             two rows. A prism's polygon lies along the first two, its height along the third */
    double to[3];         /* a capsule's other end; of a half-space, any length but 0 */
    double radius;        /* above 0 */
    const double* points; /* 2 per point: a simple polygon, in either orientation; read during the call */
    /* For FLG_OBSTACLE_KIND_FUNCTION, called from any thread. Returns a value that is positive outside and never
     * exceeds the distance, and writes its gradient, which must not be 0 within half a `half` of the zero set.
     * centre and half: a box that contains the whole solid. */
    double (*value)(void* user_data, const double* x, double* gradient);
    void* user_data;      /* must live until the obstacles and all splines among them are released */
} FlgObstacle;

/* A ball of radius 1 at the origin; a box with sides of 2. */
FLG_API FlgResult flgObstacleInit(FlgObstacle* obstacle, uint32_t struct_size);

typedef struct FlgObstaclesDesc {
    uint32_t struct_size;
    uint32_t dimension;      /* 2 or 3. Default 3 */
    const FlgJobOptions* job;
    const FlgObstacle* obstacles; /* copied, except the data at user_data */
    uint32_t obstacle_count;      /* 1 to 256 */
    uint32_t reserved;
    double clearance;        /* metres, at least 0: distance that curves keep, such as the radius of a body whose centre
                                they carry. Default 0 */
    double origin[3];        /* metres: what the obstacles' places are relative to; surfaces keep their own. 0 in the
                                plane. Default 0 */
} FlgObstaclesDesc;

FLG_API FlgResult flgObstaclesDescInit(FlgObstaclesDesc* desc, uint32_t struct_size);

/* Starts a job that makes obstacles (sec. 5); splines may be requested before it is done. Refuses sizes that are not
 * positive, polygons that cross themselves, and axes that are not orthonormal; the message names the obstacle. The job
 * fails for meshes that contain nothing, layers thinner than 4 cells, and surfaces without borders. Cost: of meshes 100
 * to 500 ns a cell of their grid, and of closed ones 200 ns a triangle. */
FLG_API FlgResult flgObstaclesCreate(FlgContext context, const FlgObstaclesDesc* desc, FlgObstacles* out_obstacles,
                                     FlgJob* out_job);
FLG_API FlgResult flgObstaclesRelease(FlgContext context, FlgObstacles obstacles);

/* The side on which a curve passes an obstacle: while the initial curve is found, the obstacle extends without end
 * against the direction: in the plane and in space straight, on a surface along it, as far as the surface is large
 * (where that leads back to the obstacle, half way around). In the plane and on surfaces the optimized curve stays on
 * that side. In space a ball has no other side, and the curve may slide over it to where it bends less. On a surface
 * the job fails for obstacles that do not cut it near their middle, and for directions across it. */
typedef struct FlgObstacleSide {
    uint32_t obstacle; /* its index in FlgObstaclesDesc */
    uint32_t reserved;
    double direction[3]; /* from the obstacle towards the curve; any length but 0 */
} FlgObstacleSide;

/* ---- Splines ----------------------------------------------------------------------------------------------------- */

/* The energy a curve minimizes. */
typedef enum FlgSplineEnergy {
    FLG_SPLINE_ENERGY_E2 = 0, /* squared second derivative: cubic splines. Wide, even turns */
    FLG_SPLINE_ENERGY_E1 = 1, /* squared first derivative: geodesics, with corners at the points */
    FLG_SPLINE_ENERGY_ET = 2, /* E2 + tension * E1: between the two */
    FLG_SPLINE_ENERGY_FORCE_32BIT = 0x7fffffff
} FlgSplineEnergy;

/* The initial curve, before optimization. */
typedef enum FlgSplineStart {
    FLG_SPLINE_START_GEODESIC = 0,  /* approximately the shortest paths from point to point */
    FLG_SPLINE_START_PROJECTED = 1, /* the unrestricted spline, projected; for points near each other */
    FLG_SPLINE_START_FORCE_32BIT = 0x7fffffff
} FlgSplineStart;

/* What a curve does at one of its given points besides passing through: leave in a direction, or turn a corner. */
typedef struct FlgSplineHandle {
    uint32_t struct_size; /* the same of all handles of a spline */
    uint32_t point;       /* the given point's index */
    const double* slope;  /* ambient numbers, not all 0: the derivative by the parameter there, of which the part
                             tangent to the manifold counts. Null: the curve may have a corner there, as two splines
                             that share the point. Default null */
} FlgSplineHandle;

FLG_API FlgResult flgSplineHandleInit(FlgSplineHandle* handle, uint32_t struct_size);

typedef struct FlgSplineDesc {
    uint32_t struct_size;
    uint32_t point_count;     /* 2 to 65536, closed: at least 3 (1 and 2 less with a `curve`) */
    const FlgJobOptions* job; /* partial_results: every round is visible */
    FlgManifold manifold;
    const double* points;      /* ambient numbers per point: interpolated in this order, read during the call. Points
                                  off the manifold are projected (the view has the distances); two consecutive points
                                  must not project to the same place */
    const double* parameters;  /* one per point, closed: one more, for the return to the first point; ascending. Null:
                                  lengths of the curve */
    uint32_t closed;           /* nonzero: the last point connects back to the first. Default 0 */
    FlgSplineEnergy energy;    /* default FLG_SPLINE_ENERGY_E2 */
    double tension;            /* for FLG_SPLINE_ENERGY_ET: w, 1 / square metre, above 0 to 1e12. Default 1 */
    double smoothing;          /* 0: interpolates the points. Above: minimizes the energy plus the squared distances to
                                  the points over this; metres to the third with E2 and lengths. Default 0 */
    double first_tension;      /* initial tension, divided by 4 each round (sec. 3.2, homotopy). Default 0: none */
    const double* begin_slope; /* ambient numbers: the derivative by the parameter at the first point, projected to its
                                  tangent part; open curves only. Null: natural, no bending at the end */
    const double* end_slope;   /* likewise at the last point */
    FlgSplineStart start;      /* default FLG_SPLINE_START_GEODESIC */
    uint32_t node_count;       /* nodes of the chain that represents the curve, given points included: up to 2^20, at
                                  least two intervals between given points. Default 0: 32 intervals each */
    uint32_t max_rounds;       /* of the optimization, 1 to 10000; a few smooth a curve slightly (Remark 5).
                                  Default 200 */
    uint32_t side_count;       /* number of `sides`, below. Default 0 */
    double tolerance;          /* for the residual, see the view; 1e-12 to 1. Default 1e-6 */
    FlgSpline warm_start;      /* start from this spline, moved along; for dragged points. It needs as many points on
                                  the same manifold. Ignored if it failed or does not fit. Where several curves have low
                                  energy, the result stays with the previous one, which a cold start may not find.
                                  Default none */
    /* A curve to fair or refine, instead of points in space: its points are the nodes, in order. points[i] fixes node
     * curve_knots[i] (ascending; for open curves they include the first and last node). node_count, start and
     * warm_start are then ignored. Default null */
    const double* curve;
    const uint32_t* curve_knots; /* one per given point: its node */
    uint32_t curve_count;        /* nodes of `curve`, 2 (closed: 3) to 2^20 */
    uint32_t subdivisions;       /* rounds of variational subdivision (Remark 6) afterwards: each inserts a node
                                    between every two, and optimizes all but the given points again. 0 to 8. Default
                                    0 */
    /* The curve avoids these (sec. 5). The manifold must be a FLG_MANIFOLD_SHAPE_SPACE of the same dimension, or a
     * surface in R^3. The result is the limit of splines on barriers around them, as the barriers' radius shrinks to
     * `obstacle_radius` of the scene's size; nodes keep a tenth of that radius away, up to a half where they must.
     * The chain and the cubic spline through its nodes keep their clearance everywhere, to 2e-7 of the scene's size:
     * there are more nodes where that needs them. A mesh is its triangles, not a grid of them. The job fails
     * where it can't be had, and says near which obstacle and where. A given point inside an obstacle is refused; one
     * that touches is not, and beside it the curve may come nearer by a tenth of the barriers' radius. The initial
     * curve goes around the obstacles. `start`, `warm_start`, slopes and subdivisions are ignored, but where there is
     * only the border of the manifold's own mesh, beyond which given points are passed too; `curve` is refused. Default
     * none */
    FlgObstacles obstacles;
    const FlgObstacleSide* sides; /* how the initial curve passes; default null: the shortest way */
    double obstacle_radius;       /* 1e-5 to 0.1. Default 1e-3 */
    double origin[3];             /* metres: what `points` and `curve` are relative to; 0 unless in R^3. Default 0 */
    uint32_t on_triangles;   /* nonzero: on the manifold of a mesh, the result is the curve over its triangles that is
                                else only shown first (see flgSplineCreate): some ms, whatever the mesh. `energy` and
                                what belongs to it count for nothing. Refused together with obstacles. Default 0 */
    uint32_t surface_points; /* nonzero: the view gives, for each node, the nearest point of the mesh's triangles. The
                                manifold must be that of a mesh. Default 0 */
    const FlgSplineHandle* handles; /* in any order, one at most per point. Between them the spline is minimized piece
                                       by piece, and its rounds are not shown; points with a handle are passed exactly,
                                       whatever the smoothing. Refused together with obstacles or `curve`. Default
                                       null */
    uint32_t handle_count;
    uint32_t seek_lower;    /* nonzero, with a warm_start: also minimizes from a new initial curve, and takes that where
                               its energy is more than 5 % lower; the view says so. Takes as long as without the
                               warm_start besides. Refused together with obstacles or `curve`. Default 0 */
    const double* softness; /* one per point: its own `smoothing`, from 0 (passes through) to 1e30. Refused together
                               with obstacles. Default null: `smoothing` for all */
    const double* tensions; /* one per segment from a given point to the next, closed: also for the return: factors of
                               `tension`, 0 to 1e12; for FLG_SPLINE_ENERGY_ET. Refused together with obstacles. Default
                               null: 1 */
    double key_tolerance;   /* metres; above 0: the view also gives the curve as few cubic pieces, at most so far from
                               it. Default 0: none */
    uint64_t max_evaluations; /* among obstacles: how often, at most, nodes are put onto barriers or take part in a
                                 round; the first way around the obstacles and the looks that prove the clearance are
                                 counted in proportion. 0.5 to 1 us each, half as long again for each 16 obstacles: it
                                 bounds the time, and is the same on every machine. Used up, the result is the best
                                 curve so far that keeps clear (FLG_SPLINE_ENDING_EVALUATIONS), perhaps of fewer nodes
                                 than node_count; the job fails if there is none. Fewer than some 40 a node leave none.
                                 0: no bound. Default 2000000, 1 to 2 s at most; it stands for 800 a node (of
                                 node_count) where that is less, but for 600000 at least */
} FlgSplineDesc;

FLG_API FlgResult flgSplineDescInit(FlgSplineDesc* desc, uint32_t struct_size);

/* Starts a job that makes the curve of least energy through points of a manifold, among those that the initial curve
 * can be moved to: a chain of nodes on the manifold whose fourth derivative (E1: second) has no tangential part between
 * the given points. Fails with FLG_ERROR_INVALID_ARGUMENT if a point cannot be projected, two consecutive points
 * coincide, or no path leads from one to the next (add points between them). Antipodal points of a sphere give a half
 * circle, always the same one. Two points give a geodesic, also with E2. If rounds run out or rounding stops progress,
 * the curve is still available, and the view says so.
 * On a mesh there is a curve through any points of one connected part: where the smooth surface can't be reached the
 * result is a curve of Bezier segments over the triangles (FLG_SPLINE_ENDING_TRIANGLES), with a tangent everywhere but
 * not of least energy. With partial_results that is also what is seen first, unless there is a warm_start.
 * Cost: 1 us a node and round on a mesh, and 3 to 8 rounds; the curve over triangles, 10 us a node. */
FLG_API FlgResult flgSplineCreate(FlgContext context, const FlgSplineDesc* desc, FlgSpline* out_spline,
                                  FlgJob* out_job);

/* Why the optimization ended. A curve is available in each case. */
typedef enum FlgSplineEnding {
    FLG_SPLINE_ENDING_RUNNING = 0,   /* still running: the view shows one round's result */
    FLG_SPLINE_ENDING_CONVERGED = 1, /* the residual is at most the tolerance, at all nodes that are not held */
    FLG_SPLINE_ENDING_ROUNDING = 2,  /* as close as rounding allows: with thousands of nodes between points,
                                        differences cancel */
    FLG_SPLINE_ENDING_ROUNDS = 3,    /* max_rounds was reached */
    FLG_SPLINE_ENDING_STALLED = 4,   /* no step lowers the energy: more than a 16th of the nodes and 3 would be held.
                                        The curve is the best found; see the residual. Among obstacles also: only a
                                        barrier wider than the last one gave a curve that keeps clear */
    FLG_SPLINE_ENDING_TRIANGLES = 5, /* the curve over the triangles of a mesh: it was asked for, or the smooth surface
                                        can't be reached somewhere. Nodes lie on triangles, given points at the nearest
                                        points of these */
    FLG_SPLINE_ENDING_EVALUATIONS = 7, /* max_evaluations were used up: the best curve so far that keeps clear of all
                                          obstacles, perhaps farther away than it has to */
    FLG_SPLINE_ENDING_FORCE_32BIT = 0x7fffffff
} FlgSplineEnding;

typedef struct FlgSplineView {
    uint32_t struct_size;
    uint32_t ambient;         /* n */
    uint32_t node_count;
    uint32_t point_count;
    uint32_t closed; /* as in the descriptor */
    FlgSplineEnding ending;
    const double* nodes;         /* n per node */
    const double* parameters;    /* one per node, closed: one more */
    const float* normals;        /* 3 per node, unit: the surface's, outwards; null if it is not a surface in R^3,
                                    and while running */
    const uint32_t* point_nodes; /* one per given point: its node */
    const uint32_t* held_nodes;  /* nodes that stay at an edge or a gap of the surface, ascending; the curve is
                                    optimized as if they were given points. Null if there are none */
    const double* offsets;       /* one per given point, metres: its distance from the manifold */
    double largest_offset;       /* the largest of these, metres */
    uint32_t rounds;             /* of the optimization */
    uint32_t projections;        /* projections of all nodes onto the manifold */
    uint32_t held_count;         /* number of held_nodes; 0 while running */
    uint32_t on_triangles;       /* nonzero: the curve over triangles, for now or in the end */
    double energy;               /* with all weights */
    double bending;              /* E2: exact for the spline of R^n through the nodes */
    double stretching;           /* E1 of the chain */
    double length;               /* metres, of the chain */
    /* Tangential part of the fourth derivative (with tension minus w times the second; for E1 the second) at free
     * nodes, root mean square, divided by the mean of all elastic forces along the curve, including those at the given
     * points. */
    double residual;
    double origin[3]; /* metres: what the nodes are relative to: the manifold's origin; on FLG_MANIFOLD_SHAPE_SPACE the
                         descriptor's */
    const FlgSurfacePoint* surface_points; /* one per node, where asked for: the nearest point of the mesh's triangles,
                                              as they were when the spline was made. Null else, and while running */
    double largest_moved; /* metres: of these, the largest distance from its node */
    /* The curve as cubic pieces from key to key, where asked for; null and 0 else, and while running. As glTF's
     * CUBICSPLINE has it: an animation's output is arriving, point, leaving for each key. Bezier's points from a key to
     * the next, h later in parameter: point, point + h / 3 leaving, next point - h / 3 next arriving, next point. There
     * is a key at each given point; a closed curve's last key is its first again. */
    uint32_t key_count;
    uint32_t jumped;              /* nonzero: with seek_lower, the curve is not that which goes on from the warm_start,
                                     but another one of lower energy */
    const double* key_parameters; /* ascending; a closed curve's with handles begin at the first one */
    const double* key_points;     /* n per key */
    const double* key_arriving;   /* n per key: the derivative by the parameter before it */
    const double* key_leaving;    /* likewise after it: the same but at handles and, with E1, at given points */
    double largest_key_error;     /* metres: the pieces' largest distance from the cubic spline through the nodes */
} FlgSplineView;

FLG_API FlgResult flgSplineViewInit(FlgSplineView* view, uint32_t struct_size);

/* The arrays live until the spline is released; while it runs, until the next flgContextTick. FLG_NOT_READY until
 * its job is published (with partial_results: until its first round), the job's error if it failed. */
FLG_API FlgResult flgSplineGetView(FlgContext context, FlgSpline spline, FlgSplineView* out_view);

typedef struct FlgSplineTraceDesc {
    uint32_t struct_size;
    uint32_t reserved;
    const FlgJobOptions* job;
    FlgSpline spline; /* on the manifold of a mesh */
    double offset;    /* metres to the left of the curve, seen from outside: all places of the triangles so far from it
                         on that side, within a thousandth, in one curve or more; none fails. Default 0 */
} FlgSplineTraceDesc;

FLG_API FlgResult flgSplineTraceDescInit(FlgSplineTraceDesc* desc, uint32_t struct_size);

/* Starts a job that lays a spline onto the triangles of its mesh, as that is by then: a curve to cut along
 * (flgSurfaceCutCurves) or to grow from. Its nodes go to the nearest points of triangles; from one to the next it
 * follows the plane through both and the surface's normal and, where no such way leads there, a shortest path. Cost:
 * about 2 us a node and 100 ns a triangle. */
FLG_API FlgResult flgSplineTrace(FlgContext context, const FlgSplineTraceDesc* desc, FlgSurfaceCurves* out_curves,
                                 FlgJob* out_job);

typedef struct FlgSplineSampleDesc {
    uint32_t struct_size;
    float height;      /* metres above the surface, along its normals. Default 0 */
    const FlgJobOptions* job;
    FlgSpline spline;  /* in R^3 */
    double spacing;    /* metres between points, evenly along the curve: rounded so that it fits the length a whole
                          number of times. 0: points are nodes. Default 0 */
} FlgSplineSampleDesc;

FLG_API FlgResult flgSplineSampleDescInit(FlgSplineSampleDesc* desc, uint32_t struct_size);

/* Starts a job that copies a spline into a curve set with POSITION, TIME (its parameter) and, on a surface in R^3,
 * NORMAL. Stylize it in the surface's frame (FLG_FRAME_METHOD_SUPPLIED), draw it, project it, or cut along it. Cost:
 * about 3 ns a node; with a spacing 300 ns a point. */
FLG_API FlgResult flgSplineSample(FlgContext context, const FlgSplineSampleDesc* desc, FlgCurveSet* out_set,
                                  FlgJob* out_job);

typedef struct FlgSplineSweepDesc {
    uint32_t struct_size;
    uint32_t columns;   /* quads across, 1 to 256. Default 4 */
    const FlgJobOptions* job;
    FlgSpline spline;   /* in R^3 */
    double width;       /* metres, 1e-30 to 1e30; where it conforms, it is twice the diagonal of the mesh's box at most.
                           Default 1 */
    double spacing;     /* metres between rows, as of FlgSplineSampleDesc; a closed one has at least 3. 0: a row at each
                           node. Default 0 */
    double height;      /* metres above where it lies, along its own normals. Default 0 */
    double bank;        /* metres: it leans into bends by the angle whose tangent is the curvature times this, which is
                           the square of a speed over 9.81. For ribbons that do not conform. Default 0: none */
    double texture_length; /* metres of the curve for a texture once; rounded so that it fits around a closed one.
                              1e-30 to 1e30; 0: the width. Default 0 */
    double up[3];       /* rows are level, across this direction; 0: across the surface's normals. Needed by curves in
                           free space. For ribbons that do not conform. Default 0 */
    uint32_t conforms;  /* nonzero: rows lie on the triangles of the spline's mesh, and end at its border. Between its
                           vertices the ribbon is straight, so the mesh may stand above it a little: `height` lifts it.
                           Only the curve's bends limit how wide rows are: where the mesh itself bends, those of a wide
                           ribbon may cross. Default 0: rows are straight */
    uint32_t reserved;
} FlgSplineSweepDesc;

FLG_API FlgResult flgSplineSweepDescInit(FlgSplineSweepDesc* desc, uint32_t struct_size);

/* Starts a job that makes a ribbon or road along a spline: a new surface with the spline's origin and columns POSITION,
 * NORMAL, UV (u across from left to right, v along) and WIDTH (of the row, metres). On the inner side of a bend tighter
 * than it is wide rows end before they would cross their neighbours, so WIDTH is less there. A closed ribbon's last row
 * repeats the first, for the texture. Cost: about 0.5 us a vertex; 3 us a row that conforms. Fails with FLG_ERROR_LIMIT
 * above 2^26 vertices or 2^20 rows. */
FLG_API FlgResult flgSplineSweep(FlgContext context, const FlgSplineSweepDesc* desc, FlgSurface* out_surface,
                                  FlgJob* out_job);

typedef struct FlgSplineOffsetDesc {
    uint32_t struct_size;
    uint32_t keeps_loops; /* nonzero: a curve that is farther away than a bend is wide keeps the loop it makes there.
                             Default 0: loops are cut off */
    const FlgJobOptions* job;
    FlgSpline spline;     /* in R^3 */
    double left;          /* metres to the left of the curve, seen from above; below 0: to the right. Default 0 */
    double above;         /* metres upwards; below 0: downwards. Default 0 */
    double spacing;       /* metres between the points of `spline` that it is made of, as of FlgSplineSampleDesc.
                             Default 0 */
    double up[3];         /* what is upwards: left is across this direction. 0: the surface's normals, and the way to
                             the left goes straight over the surface; in free space as with turns_least. Default 0 */
    uint32_t turns_least; /* nonzero: `up` counts at the beginning only (0: the surface's normal there; in free space
                             +z, or +y where the curve begins along z). From there left and up turn about the curve as
                             little as may be; around a closed one they are turned back evenly. Default 0 */
    uint32_t reserved;
} FlgSplineOffsetDesc;

FLG_API FlgResult flgSplineOffsetDescInit(FlgSplineOffsetDesc* desc, uint32_t struct_size);

/* Starts a job that makes the curve beside a spline, `left` and `above`: a curve set with the spline's origin and
 * POSITION, TIME (the spline's parameter beside it) and NORMAL (upwards). On a surface, without an `up`, it lies on the
 * surface, as the manifold has it, `above` it where asked for; where the surface ends before it is `left` metres away
 * it lies at its end. Farther away than the radius of a bend it would run back in a loop: loops are cut off where the
 * curve crosses itself (in space, half way between where its ends are nearest), which leaves a corner, and TIME jumps
 * there. At corners of the spline its outer side is cut straight. Fails where nothing is left without loops, and with
 * FLG_ERROR_LIMIT above 2^20 points. Cost: about 0.5 us a point; over a surface 3 us a point and each 256th of the
 * surface's size. */
FLG_API FlgResult flgSplineOffset(FlgContext context, const FlgSplineOffsetDesc* desc, FlgCurveSet* out_set,
                                  FlgJob* out_job);

FLG_API FlgResult flgSplineRelease(FlgContext context, FlgSpline spline);

/* ---- Cables ------------------------------------------------------------------------------------------------------ */

typedef struct FlgCableHangDesc {
    uint32_t struct_size;
    uint32_t point_count;    /* of all cables, 2 to 65536 */
    const FlgJobOptions* job;
    const double* points;    /* 3 per point, metres: a cable is fixed at each, and hangs from one to the next; read
                                during the call */
    const uint32_t* cable_offsets; /* cable_count + 1, from 0 to point_count: where each cable's points begin, at least
                                2 each. Null: one cable */
    uint32_t cable_count;    /* 1 to 65536, with cable_offsets. Default 0 */
    uint32_t segments;       /* straight pieces from a point to the next, 4 to 4096. Default 64 */
    const double* lengths;   /* one per span from a point of a cable to its next one, metres: at least their distance,
                                at most 1000 times it. Null: by slack */
    double slack;            /* by how much spans are longer than the distance of their points, over it: 0 to 999.
                                Default 0.02 */
    double gravity[3];       /* the direction in which they hang, any length but 0. Default 0, 0, -1 */
    FlgObstacles obstacles;  /* of 3 dimensions: what they rest on, without friction. Default none */
    double origin[3];        /* metres: what `points` are relative to, and the result. Default 0 */
} FlgCableHangDesc;

FLG_API FlgResult flgCableHangDescInit(FlgCableHangDesc* desc, uint32_t struct_size);

/* Starts a job that hangs cables between points: a curve set with the descriptor's origin, POSITION and TIME (metres
 * along the cable), a curve per cable. They do not stretch, and bend without resistance. A span that meets nothing as
 * it falls from the straight way between its points is a catenary, in closed form: its points are evenly along that.
 * Others come to rest on the obstacles, where their potential energy is least, on the side they fall from: the straight
 * way or, where that is blocked, the shortest way over the obstacles. Their segments are straight, as TIME says to
 * 1e-8, and keep the obstacles' clearance to 1e-6 of the scene's size: of balls, boxes, capsules, half-spaces
 * and, without a clearance, meshes everywhere; of others at places a 32nd of a segment apart. What is longer than has
 * room lies on the ground in folds. Points may touch obstacles.
 * Fails with FLG_ERROR_INVALID_ARGUMENT where a point is inside an obstacle, where a span is too short for the ways
 * around the obstacles, and where it does not come to rest; with FLG_ERROR_LIMIT above 2^22 segments. Cost: about 0.1
 * us a segment of a free span; 5 to 50 ms for a span of 64 that rests on something, up to a second on a mesh or where
 * the straight way is blocked. */
FLG_API FlgResult flgCableHang(FlgContext context, const FlgCableHangDesc* desc, FlgCurveSet* out_set,
                               FlgJob* out_job);

/* ---- Defaults by value ------------------------------------------------------------------------------------------- */

static inline FlgManifoldShapeDesc flgManifoldShapeDefaults(void) {
    FlgManifoldShapeDesc desc;
    flgManifoldShapeDescInit(&desc, (uint32_t)sizeof desc);
    return desc;
}

static inline FlgManifoldFromSurfaceDesc flgManifoldFromSurfaceDefaults(void) {
    FlgManifoldFromSurfaceDesc desc;
    flgManifoldFromSurfaceDescInit(&desc, (uint32_t)sizeof desc);
    return desc;
}

static inline FlgManifoldFromPointsDesc flgManifoldFromPointsDefaults(void) {
    FlgManifoldFromPointsDesc desc;
    flgManifoldFromPointsDescInit(&desc, (uint32_t)sizeof desc);
    return desc;
}

static inline FlgManifoldFromGridDesc flgManifoldFromGridDefaults(void) {
    FlgManifoldFromGridDesc desc;
    flgManifoldFromGridDescInit(&desc, (uint32_t)sizeof desc);
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

static inline FlgSplineTraceDesc flgSplineTraceDefaults(void) {
    FlgSplineTraceDesc desc;
    flgSplineTraceDescInit(&desc, (uint32_t)sizeof desc);
    return desc;
}

static inline FlgSplineHandle flgSplineHandleDefaults(void) {
    FlgSplineHandle handle;
    flgSplineHandleInit(&handle, (uint32_t)sizeof handle);
    return handle;
}

static inline FlgSplineSampleDesc flgSplineSampleDefaults(void) {
    FlgSplineSampleDesc desc;
    flgSplineSampleDescInit(&desc, (uint32_t)sizeof desc);
    return desc;
}

static inline FlgSplineSweepDesc flgSplineSweepDefaults(void) {
    FlgSplineSweepDesc desc;
    flgSplineSweepDescInit(&desc, (uint32_t)sizeof desc);
    return desc;
}

static inline FlgSplineOffsetDesc flgSplineOffsetDefaults(void) {
    FlgSplineOffsetDesc desc;
    flgSplineOffsetDescInit(&desc, (uint32_t)sizeof desc);
    return desc;
}

static inline FlgCableHangDesc flgCableHangDefaults(void) {
    FlgCableHangDesc desc;
    flgCableHangDescInit(&desc, (uint32_t)sizeof desc);
    return desc;
}

static inline FlgObstacle flgObstacleDefaults(void) {
    FlgObstacle obstacle;
    flgObstacleInit(&obstacle, (uint32_t)sizeof obstacle);
    return obstacle;
}

#ifdef __cplusplus
}
#endif

#endif
