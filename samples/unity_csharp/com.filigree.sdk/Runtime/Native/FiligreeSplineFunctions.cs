// SPDX-License-Identifier: MIT
// Functions of filigree_spline.h. Written by tools/abi/generate from sdk/api/abi.json: change the header.
//
// Smooth curves that stay on anything: energy-minimizing splines in manifolds (Hofer, Pottmann 2004). Follows the
// grammar of filigree.h and filigree_surface.h. Coordinates are doubles, metres; parameters are lengths unless the host
// provides them.

using System;
using System.Runtime.InteropServices;
using static System.Runtime.InteropServices.CallingConvention;

namespace Filigree
{
    public static unsafe partial class Native
    {
        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgManifoldShapeDescInit(FlgManifoldShapeDesc* desc, uint struct_size);

        /// <summary>Makes a manifold at once. Cost: 0.1 ms at most.</summary>
        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgManifoldCreateShape(
            FlgContext context, FlgManifoldShapeDesc* desc, FlgManifold* out_manifold);

        /// <summary>The names of formulas, from index 0 on; null beyond the last one. Static strings.</summary>
        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern byte* flgFormulaGetName(uint number);

        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgManifoldFromSurfaceDescInit(
            FlgManifoldFromSurfaceDesc* desc, uint struct_size);

        /// <summary>
        /// Starts a job that makes the smooth surface of a mesh: moving least squares over its vertices, with their
        /// normals and curvatures. Its error on smooth parts is quadratic in edge length; creases are rounded off. The
        /// manifold's view gives the deviation of its vertices. Opposite sides of thin solids stay apart; two sheets
        /// that face the same way blend where they are closer than an edge length. Tangents jump across edges sharper
        /// than about 114 degrees, where nodes of curves are held (see FlgSplineView). Curves may go a quarter of an
        /// edge beyond open borders, and run along there where they would go farther. FlgObstacleKind.Border keeps them
        /// within the borders. Cost: about 1 us a triangle.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgManifoldCreateFromSurface(
            FlgContext context, FlgManifoldFromSurfaceDesc* desc, FlgManifold* out_manifold, FlgJob* out_job);

        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgManifoldFromPointsDescInit(FlgManifoldFromPointsDesc* desc, uint struct_size);

        /// <summary>
        /// Starts a job that makes the smooth surface of a point cloud by moving least squares (sec. 3.2). Cost: some
        /// us a point.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgManifoldCreateFromPoints(
            FlgContext context, FlgManifoldFromPointsDesc* desc, FlgManifold* out_manifold, FlgJob* out_job);

        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgManifoldFromGridDescInit(FlgManifoldFromGridDesc* desc, uint struct_size);

        /// <summary>
        /// Starts a job that makes the zero set of a sampled function, such as signed distances. Cost: about 20 ns a
        /// sample.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgManifoldCreateFromGrid(
            FlgContext context, FlgManifoldFromGridDesc* desc, FlgManifold* out_manifold, FlgJob* out_job);

        /// <summary>
        /// The image manifold of a surface's normals (sec. 6, Fig. 17): (x, weight * normal) in R^6. Curves on it avoid
        /// crossing creases; the larger the weight (metres, above 0), the more. `base`: a surface in R^3, ready. Points
        /// are given and shown in R^3; the normals are added and dropped internally. Cost: 0.1 ms at most.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgManifoldCreateImage(
            FlgContext context, FlgManifold @base, double weight, FlgManifold* out_manifold);

        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgManifoldFunctionsInit(FlgManifoldFunctions* functions, uint struct_size);

        /// <summary>
        /// Makes a manifold from a copy of the functions; user_data must live until the manifold and all splines on it
        /// are released. Tests the functions at one point, and refuses results that are not orthonormal or not finite.
        /// Cost: some calls of the functions.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgManifoldCreateHost(
            FlgContext context, FlgManifoldFunctions* functions, double* point_near, FlgManifold* out_manifold);

        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgPatchFunctionsInit(FlgPatchFunctions* functions, uint struct_size);

        /// <summary>
        /// Makes a manifold from a copy of the functions at once, evaluating 1089 points. Refuses results that are not
        /// finite, and parallel derivatives. Exclude fixed points such as poles from the domain. Cost: 1089 calls of
        /// the function.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgManifoldCreatePatch(
            FlgContext context, FlgPatchFunctions* functions, FlgManifold* out_manifold);

        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgManifoldViewInit(FlgManifoldView* view, uint struct_size);

        /// <summary>FlgResult.NotReady until the manifold's job is published, the job's error if it failed.</summary>
        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgManifoldGetView(
            FlgContext context, FlgManifold manifold, FlgManifoldView* out_view);

        /// <summary>
        /// Projects up to 64 points, relative to the manifold's origin, onto it at once, such as a cursor's.
        /// out_distances (metres) may be null; a point that cannot be projected stays unchanged and gets HUGE_VAL.
        /// FlgResult.NotReady until the manifold's job is published. Cost: some us a point.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgManifoldProject(
            FlgContext context, FlgManifold manifold, double* points, uint point_count, double* out_distances);

        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgManifoldRelease(FlgContext context, FlgManifold manifold);

        /// <summary>A ball of radius 1 at the origin; a box with sides of 2.</summary>
        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgObstacleInit(FlgObstacle* obstacle, uint struct_size);

        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgObstaclesDescInit(FlgObstaclesDesc* desc, uint struct_size);

        /// <summary>
        /// Starts a job that makes obstacles (sec. 5); splines may be requested before it is done. Refuses sizes that
        /// are not positive, polygons that cross themselves, and axes that are not orthonormal; the message names the
        /// obstacle. The job fails for meshes that contain nothing, layers thinner than 4 cells, and surfaces without
        /// borders. Cost: of meshes 100 to 500 ns a cell of their grid, and of closed ones 200 ns a triangle.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgObstaclesCreate(
            FlgContext context, FlgObstaclesDesc* desc, FlgObstacles* out_obstacles, FlgJob* out_job);

        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgObstaclesRelease(FlgContext context, FlgObstacles obstacles);

        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgSplineHandleInit(FlgSplineHandle* handle, uint struct_size);

        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgSplineDescInit(FlgSplineDesc* desc, uint struct_size);

        /// <summary>
        /// Starts a job that makes the curve of least energy through points of a manifold, among those that the initial
        /// curve can be moved to: a chain of nodes on the manifold whose fourth derivative (E1: second) has no
        /// tangential part between the given points. Fails with FlgResult.ErrorInvalidArgument if a point cannot be
        /// projected, two consecutive points coincide, or no path leads from one to the next (add points between them).
        /// Antipodal points of a sphere give a half circle, always the same one. Two points give a geodesic, also with
        /// E2. If rounds run out or rounding stops progress, the curve is still available, and the view says so. On a
        /// mesh there is a curve through any points of one connected part: where the smooth surface can't be reached
        /// the result is a curve of Bezier segments over the triangles (FlgSplineEnding.Triangles), with a tangent
        /// everywhere but not of least energy. With partial_results that is also what is seen first, unless there is a
        /// warm_start. Cost: 1 us a node and round on a mesh, and 3 to 8 rounds; the curve over triangles, 10 us a
        /// node.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgSplineCreate(
            FlgContext context, FlgSplineDesc* desc, FlgSpline* out_spline, FlgJob* out_job);

        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgSplineViewInit(FlgSplineView* view, uint struct_size);

        /// <summary>
        /// The arrays live until the spline is released; while it runs, until the next flgContextTick.
        /// FlgResult.NotReady until its job is published (with partial_results: until its first round), the job's error
        /// if it failed.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgSplineGetView(FlgContext context, FlgSpline spline, FlgSplineView* out_view);

        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgSplineTraceDescInit(FlgSplineTraceDesc* desc, uint struct_size);

        /// <summary>
        /// Starts a job that lays a spline onto the triangles of its mesh, as that is by then: a curve to cut along
        /// (flgSurfaceCutCurves) or to grow from. Its nodes go to the nearest points of triangles; from one to the next
        /// it follows the plane through both and the surface's normal and, where no such way leads there, a shortest
        /// path. Cost: about 2 us a node and 100 ns a triangle.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgSplineTrace(
            FlgContext context, FlgSplineTraceDesc* desc, FlgSurfaceCurves* out_curves, FlgJob* out_job);

        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgSplineSampleDescInit(FlgSplineSampleDesc* desc, uint struct_size);

        /// <summary>
        /// Starts a job that copies a spline into a curve set with POSITION, TIME (its parameter) and, on a surface in
        /// R^3, NORMAL. Stylize it in the surface's frame (FlgFrameMethod.Supplied), draw it, project it, or cut along
        /// it. Cost: about 3 ns a node; with a spacing 300 ns a point.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgSplineSample(
            FlgContext context, FlgSplineSampleDesc* desc, FlgCurveSet* out_set, FlgJob* out_job);

        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgSplineSweepDescInit(FlgSplineSweepDesc* desc, uint struct_size);

        /// <summary>
        /// Starts a job that makes a ribbon or road along a spline: a new surface with the spline's origin and columns
        /// POSITION, NORMAL, UV (u across from left to right, v along) and WIDTH (of the row, metres). On the inner
        /// side of a bend tighter than it is wide rows end before they would cross their neighbours, so WIDTH is less
        /// there. A closed ribbon's last row repeats the first, for the texture. Cost: about 0.5 us a vertex; 3 us a
        /// row that conforms. Fails with FlgResult.ErrorLimit above 2^26 vertices or 2^20 rows.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgSplineSweep(
            FlgContext context, FlgSplineSweepDesc* desc, FlgSurface* out_surface, FlgJob* out_job);

        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgSplineOffsetDescInit(FlgSplineOffsetDesc* desc, uint struct_size);

        /// <summary>
        /// Starts a job that makes the curve beside a spline, `left` and `above`: a curve set with the spline's origin
        /// and POSITION, TIME (the spline's parameter beside it) and NORMAL (upwards). On a surface, without an `up`,
        /// it lies on the surface, as the manifold has it, `above` it where asked for; where the surface ends before it
        /// is `left` metres away it lies at its end. Farther away than the radius of a bend it would run back in a
        /// loop: loops are cut off where the curve crosses itself (in space, half way between where its ends are
        /// nearest), which leaves a corner, and TIME jumps there. At corners of the spline its outer side is cut
        /// straight. Fails where nothing is left without loops, and with FlgResult.ErrorLimit above 2^20 points. Cost:
        /// about 0.5 us a point; over a surface 3 us a point and each 256th of the surface's size.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgSplineOffset(
            FlgContext context, FlgSplineOffsetDesc* desc, FlgCurveSet* out_set, FlgJob* out_job);

        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgSplineRelease(FlgContext context, FlgSpline spline);

        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgCableHangDescInit(FlgCableHangDesc* desc, uint struct_size);

        /// <summary>
        /// Starts a job that hangs cables between points: a curve set with the descriptor's origin, POSITION and TIME
        /// (metres along the cable), a curve per cable. They do not stretch, and bend without resistance. A span that
        /// meets nothing as it falls from the straight way between its points is a catenary, in closed form: its points
        /// are evenly along that. Others come to rest on the obstacles, where their potential energy is least, on the
        /// side they fall from: the straight way or, where that is blocked, the shortest way over the obstacles. Their
        /// segments are straight, as TIME says to 1e-8, and keep the obstacles' clearance to 1e-6 of the scene's size:
        /// of balls, boxes, capsules, half-spaces and, without a clearance, meshes everywhere; of others at places a
        /// 32nd of a segment apart. What is longer than has room lies on the ground in folds. Points may touch
        /// obstacles. Fails with FlgResult.ErrorInvalidArgument where a point is inside an obstacle, where a span is
        /// too short for the ways around the obstacles, and where it does not come to rest; with FlgResult.ErrorLimit
        /// above 2^22 segments. Cost: about 0.1 us a segment of a free span; 5 to 50 ms for a span of 64 that rests on
        /// something, up to a second on a mesh or where the straight way is blocked.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgCableHang(
            FlgContext context, FlgCableHangDesc* desc, FlgCurveSet* out_set, FlgJob* out_job);

        public static FlgManifoldShapeDesc flgManifoldShapeDefaults()
        {
            FlgManifoldShapeDesc made;
            flgManifoldShapeDescInit(&made, (uint)sizeof(FlgManifoldShapeDesc));
            return made;
        }

        public static FlgManifoldFromSurfaceDesc flgManifoldFromSurfaceDefaults()
        {
            FlgManifoldFromSurfaceDesc made;
            flgManifoldFromSurfaceDescInit(&made, (uint)sizeof(FlgManifoldFromSurfaceDesc));
            return made;
        }

        public static FlgManifoldFromPointsDesc flgManifoldFromPointsDefaults()
        {
            FlgManifoldFromPointsDesc made;
            flgManifoldFromPointsDescInit(&made, (uint)sizeof(FlgManifoldFromPointsDesc));
            return made;
        }

        public static FlgManifoldFromGridDesc flgManifoldFromGridDefaults()
        {
            FlgManifoldFromGridDesc made;
            flgManifoldFromGridDescInit(&made, (uint)sizeof(FlgManifoldFromGridDesc));
            return made;
        }

        public static FlgManifoldFunctions flgManifoldFunctionsDefaults()
        {
            FlgManifoldFunctions made;
            flgManifoldFunctionsInit(&made, (uint)sizeof(FlgManifoldFunctions));
            return made;
        }

        public static FlgPatchFunctions flgPatchFunctionsDefaults()
        {
            FlgPatchFunctions made;
            flgPatchFunctionsInit(&made, (uint)sizeof(FlgPatchFunctions));
            return made;
        }

        public static FlgManifoldView flgManifoldViewDefaults()
        {
            FlgManifoldView made;
            flgManifoldViewInit(&made, (uint)sizeof(FlgManifoldView));
            return made;
        }

        public static FlgObstaclesDesc flgObstaclesDefaults()
        {
            FlgObstaclesDesc made;
            flgObstaclesDescInit(&made, (uint)sizeof(FlgObstaclesDesc));
            return made;
        }

        public static FlgSplineDesc flgSplineDefaults()
        {
            FlgSplineDesc made;
            flgSplineDescInit(&made, (uint)sizeof(FlgSplineDesc));
            return made;
        }

        public static FlgSplineView flgSplineViewDefaults()
        {
            FlgSplineView made;
            flgSplineViewInit(&made, (uint)sizeof(FlgSplineView));
            return made;
        }

        public static FlgSplineTraceDesc flgSplineTraceDefaults()
        {
            FlgSplineTraceDesc made;
            flgSplineTraceDescInit(&made, (uint)sizeof(FlgSplineTraceDesc));
            return made;
        }

        public static FlgSplineHandle flgSplineHandleDefaults()
        {
            FlgSplineHandle made;
            flgSplineHandleInit(&made, (uint)sizeof(FlgSplineHandle));
            return made;
        }

        public static FlgSplineSampleDesc flgSplineSampleDefaults()
        {
            FlgSplineSampleDesc made;
            flgSplineSampleDescInit(&made, (uint)sizeof(FlgSplineSampleDesc));
            return made;
        }

        public static FlgSplineSweepDesc flgSplineSweepDefaults()
        {
            FlgSplineSweepDesc made;
            flgSplineSweepDescInit(&made, (uint)sizeof(FlgSplineSweepDesc));
            return made;
        }

        public static FlgSplineOffsetDesc flgSplineOffsetDefaults()
        {
            FlgSplineOffsetDesc made;
            flgSplineOffsetDescInit(&made, (uint)sizeof(FlgSplineOffsetDesc));
            return made;
        }

        public static FlgCableHangDesc flgCableHangDefaults()
        {
            FlgCableHangDesc made;
            flgCableHangDescInit(&made, (uint)sizeof(FlgCableHangDesc));
            return made;
        }

        public static FlgObstacle flgObstacleDefaults()
        {
            FlgObstacle made;
            flgObstacleInit(&made, (uint)sizeof(FlgObstacle));
            return made;
        }
    }
}
