// SPDX-License-Identifier: MIT
// Functions of filigree_spline.h. Written by tools/abi/generate from sdk/api/abi.json: change the header.
//
// Smooth curves that stay on anything: energy-minimizing splines in manifolds (Hofer, Pottmann 2004). It follows the
// grammar of filigree.h and filigree_surface.h. Coordinates are doubles, metres; parameters are lengths unless the host
// gives them.

using System;
using System.Runtime.InteropServices;

namespace Filigree
{
    public static unsafe partial class Native
    {
        [DllImport(Library.Filigree, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgShapeDescInit(FlgShapeDesc* desc, uint struct_size);

        /// <summary>Makes a manifold at once. Cost: 0.1 ms at most.</summary>
        [DllImport(Library.Filigree, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgManifoldCreateShape(
            FlgContext context, FlgShapeDesc* desc, FlgManifold* out_manifold);

        /// <summary>The names of formulas, from number 0 on; null beyond the last one. They live for ever.</summary>
        [DllImport(Library.Filigree, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern byte* flgFormulaName(uint number);

        [DllImport(Library.Filigree, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgMeshManifoldDescInit(FlgMeshManifoldDesc* desc, uint struct_size);

        /// <summary>
        /// Starts a job that makes the smooth surface of a mesh: moving least squares over its vertices, with their
        /// normals and curvatures. It follows smooth parts to the square of the edges' lengths and rounds creases off;
        /// how far its vertices are from it is in the manifold's view. Thin solids keep their sides apart; two sheets
        /// that face the same way blend where they are nearer than an edge is long. Across edges sharper than some 114
        /// degrees tangents jump, and curves may stall there. At open borders it goes on a little:
        /// FlgObstacleKind.Border keeps curves from there. Cost: about 1 us a triangle.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgManifoldCreateFromSurface(
            FlgContext context, FlgMeshManifoldDesc* desc, FlgManifold* out_manifold, FlgJob* out_job);

        [DllImport(Library.Filigree, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgCloudManifoldDescInit(FlgCloudManifoldDesc* desc, uint struct_size);

        /// <summary>
        /// Starts a job that makes the smooth surface of a cloud of points by moving least squares (sec. 3.2). Cost:
        /// some us a point.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgManifoldCreateFromPoints(
            FlgContext context, FlgCloudManifoldDesc* desc, FlgManifold* out_manifold, FlgJob* out_job);

        [DllImport(Library.Filigree, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgGridManifoldDescInit(FlgGridManifoldDesc* desc, uint struct_size);

        /// <summary>
        /// Starts a job that makes the zero set of a sampled function, such as signed distances. Cost: about 20 ns a
        /// sample.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgManifoldCreateFromGrid(
            FlgContext context, FlgGridManifoldDesc* desc, FlgManifold* out_manifold, FlgJob* out_job);

        /// <summary>
        /// The image manifold of a surface's normals (sec. 6, Fig. 17): (x, weight * normal) in R^6. Curves on it avoid
        /// crossing creases, the more the larger the weight (metres, above 0) is. `base`: a surface in R^3, ready.
        /// Points are given and shown in R^3: the normals are added and left out. Cost: 0.1 ms at most.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgManifoldCreateImage(
            FlgContext context, FlgManifold @base, double weight, FlgManifold* out_manifold);

        [DllImport(Library.Filigree, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgManifoldFunctionsInit(FlgManifoldFunctions* functions, uint struct_size);

        /// <summary>
        /// Makes a manifold of a copy of the functions; user_data must live until it and all splines on it are
        /// released. Tries them at one point and refuses what is not orthonormal or not finite there. Cost: some calls
        /// of the functions.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgManifoldCreateHost(
            FlgContext context, FlgManifoldFunctions* functions, double* point_near, FlgManifold* out_manifold);

        [DllImport(Library.Filigree, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgPatchFunctionsInit(FlgPatchFunctions* functions, uint struct_size);

        /// <summary>
        /// Makes a manifold of a copy of these at once; asks for 1089 points of it. Refuses what is not finite there,
        /// and derivatives that are parallel. Fixed points such as poles are to be left out of the domain. Cost: 1089
        /// calls of the function.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgManifoldCreatePatch(
            FlgContext context, FlgPatchFunctions* functions, FlgManifold* out_manifold);

        [DllImport(Library.Filigree, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgManifoldViewInit(FlgManifoldView* view, uint struct_size);

        /// <summary>FlgResult.NotReady before the manifold's job is published, its error if it failed.</summary>
        [DllImport(Library.Filigree, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgManifoldGetView(
            FlgContext context, FlgManifold manifold, FlgManifoldView* out_view);

        /// <summary>
        /// Moves up to 64 points onto a manifold, at once: a cursor's, some us each. out_distances, metres, may be
        /// null; a point that can't be projected stays and gets HUGE_VAL. FlgResult.NotReady before the manifold's job
        /// is published. Cost: some us a point.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgManifoldProject(
            FlgContext context, FlgManifold manifold, double* points, uint point_count, double* out_distances);

        [DllImport(Library.Filigree, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgManifoldRelease(FlgContext context, FlgManifold manifold);

        /// <summary>A ball of radius 1 about the origin; a box of sides of 2.</summary>
        [DllImport(Library.Filigree, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern void flgObstacleInit(FlgObstacle* obstacle);

        [DllImport(Library.Filigree, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgObstaclesDescInit(FlgObstaclesDesc* desc, uint struct_size);

        /// <summary>
        /// Starts a job that makes obstacles (sec. 5); splines may be asked for before it is done. Refuses, and names
        /// the obstacle, sizes that are not positive, polygons that cross themselves, axes that are not orthonormal;
        /// the job fails for meshes that hold nothing, layers thinner than 4 cells, surfaces without borders. Cost: of
        /// meshes 100 to 500 ns a cell of their grid.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgObstaclesCreate(
            FlgContext context, FlgObstaclesDesc* desc, FlgObstacles* out_obstacles, FlgJob* out_job);

        [DllImport(Library.Filigree, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgObstaclesRelease(FlgContext context, FlgObstacles obstacles);

        [DllImport(Library.Filigree, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgSplineDescInit(FlgSplineDesc* desc, uint struct_size);

        /// <summary>
        /// Starts a job that makes the curve of least energy through points of a manifold, among those that the first
        /// curve can be moved to: a chain of nodes on the manifold such that what is tangent to it of the curve's
        /// fourth derivative (E1: second) vanishes between the given points. Fails with FlgResult.ErrorInvalidArgument,
        /// and a sentence, where a point can't be projected, two in a row coincide, or no way leads from one to the
        /// next (put points between). Antipodal points of a sphere: a half circle, always the same one. Two points: a
        /// geodesic, with E2 as well. If rounds are used up or rounding lets it get no nearer the curve is there, and
        /// the view says so. Cost: 1 us a node and round on a mesh, and 3 to 8 rounds.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgSplineCreate(
            FlgContext context, FlgSplineDesc* desc, FlgSpline* out_spline, FlgJob* out_job);

        [DllImport(Library.Filigree, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgSplineViewInit(FlgSplineView* view, uint struct_size);

        /// <summary>
        /// The arrays live until the spline is released; of running ones until the next flgTick. FlgResult.NotReady
        /// before its job is published (with partial_results: before its first round), its error if it failed.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgSplineGetView(FlgContext context, FlgSpline spline, FlgSplineView* out_view);

        [DllImport(Library.Filigree, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgSplineCurvesDescInit(FlgSplineCurvesDesc* desc, uint struct_size);

        /// <summary>
        /// Starts a job that copies a spline into a curve set with POSITION, TIME (its parameter) and, on a surface in
        /// R^3, NORMAL: to be stylized in the surface's frame (FlgFrameMethod.Supplied), drawn, projected, cut in.
        /// Cost: about 3 ns a node.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgSplineCurves(
            FlgContext context, FlgSplineCurvesDesc* desc, FlgCurveSet* out_set, FlgJob* out_job);

        [DllImport(Library.Filigree, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgSplineRelease(FlgContext context, FlgSpline spline);

        public static FlgShapeDesc flgShapeDefaults()
        {
            FlgShapeDesc made;
            flgShapeDescInit(&made, (uint)sizeof(FlgShapeDesc));
            return made;
        }

        public static FlgMeshManifoldDesc flgMeshManifoldDefaults()
        {
            FlgMeshManifoldDesc made;
            flgMeshManifoldDescInit(&made, (uint)sizeof(FlgMeshManifoldDesc));
            return made;
        }

        public static FlgCloudManifoldDesc flgCloudManifoldDefaults()
        {
            FlgCloudManifoldDesc made;
            flgCloudManifoldDescInit(&made, (uint)sizeof(FlgCloudManifoldDesc));
            return made;
        }

        public static FlgGridManifoldDesc flgGridManifoldDefaults()
        {
            FlgGridManifoldDesc made;
            flgGridManifoldDescInit(&made, (uint)sizeof(FlgGridManifoldDesc));
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

        public static FlgSplineCurvesDesc flgSplineCurvesDefaults()
        {
            FlgSplineCurvesDesc made;
            flgSplineCurvesDescInit(&made, (uint)sizeof(FlgSplineCurvesDesc));
            return made;
        }

        public static FlgObstacle flgObstacleDefaults()
        {
            FlgObstacle made;
            flgObstacleInit(&made);
            return made;
        }
    }
}
