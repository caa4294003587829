// SPDX-License-Identifier: MIT
// Structs of filigree_spline.h. Written by tools/abi/generate from sdk/api/abi.json: change the header.

using System;
using System.Runtime.InteropServices;

namespace Filigree
{
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct FlgShapeDesc
    {
        public uint struct_size;
        /// <summary>default FlgShape.Space</summary>
        public FlgShape shape;
        /// <summary>of FlgShape.Space: 2 to 12. Default 3</summary>
        public uint ambient;
        public uint reserved;
        /// <summary>metres, 1e-6 to 1e6. Default 1</summary>
        public double radius;
        /// <summary>metres, 1e-6 to below radius. Default 0.25</summary>
        public double tube_radius;
        /// <summary>
        /// metres, of FlgShape.Space and FlgShape.Plane: about how large what happens there is. Default 1
        /// </summary>
        public double size;
        /// <summary>of FlgShape.Formula</summary>
        public byte* name;
    }

    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct FlgMeshManifoldDesc
    {
        public uint struct_size;
        public uint reserved;
        public FlgJobOptions job;
        /// <summary>kept by the manifold; a later cut of it does not change the manifold</summary>
        public FlgSurface surface;
    }

    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct FlgCloudManifoldDesc
    {
        public uint struct_size;
        /// <summary>4 to 2^24</summary>
        public uint point_count;
        public FlgJobOptions job;
        /// <summary>3 a point, metres; read during the call</summary>
        public float* points;
        /// <summary>3 a point, not 0; or null: found, and turned alike along the cloud</summary>
        public float* normals;
        /// <summary>how many points a point's surroundings are, 6 to 32: more of them smooth more. Default 16</summary>
        public uint neighbours;
        public uint reserved;
    }

    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct FlgGridManifoldDesc
    {
        public uint struct_size;
        /// <summary>samples along x, y, z: 2 to 65536 each, 2^31 in all</summary>
        public fixed uint counts[3];
        public FlgJobOptions job;
        /// <summary>of the first sample, metres</summary>
        public fixed double origin[3];
        /// <summary>metres, above 0</summary>
        public double spacing;
        /// <summary>
        /// x fastest: a function that is negative inside and has no flat place at 0; read during the call
        /// </summary>
        public float* values;
    }

    /// <summary>
    /// Of FlgManifoldFunctions.project. Moves point (n numbers) onto the surface, near it; 0 if there is no point to be
    /// found.
    /// </summary>
    [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
    public unsafe delegate int FlgManifoldFunctionsProject(void* user_data, double* point, double* memory);

    /// <summary>
    /// Of FlgManifoldFunctions.tangent_basis. k rows of n numbers: an orthonormal basis of the tangent space at a
    /// projected point.
    /// </summary>
    [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
    public unsafe delegate void FlgManifoldFunctionsTangentBasis(
        void* user_data, double* point, double* memory, double* basis);

    /// <summary>
    /// Of FlgManifoldFunctions.second_form. k x k numbers: the inner products of `force` (n numbers) with the second
    /// fundamental form in the basis. Null: from differences of projections.
    /// </summary>
    [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
    public unsafe delegate void FlgManifoldFunctionsSecondForm(
        void* user_data, double* point, double* memory, double* basis, double* force, double* form);

    /// <summary>
    /// A manifold of the host's own. Functions are called from worker threads, several at a time; they must not throw,
    /// call the SDK or take more than some us, and give the same numbers for the same arguments.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct FlgManifoldFunctions
    {
        public uint struct_size;
        /// <summary>n, 2 to 12</summary>
        public uint ambient;
        /// <summary>k, 1 to n</summary>
        public uint dimension;
        /// <summary>doubles that are kept with each point, 0 to 256; zeros at first. Default 0</summary>
        public uint memory_size;
        /// <summary>metres: about how large it is, above 0. Default 1</summary>
        public double size;
        /// <summary>passed to the functions</summary>
        public void* user_data;
        /// <summary>
        /// A FlgManifoldFunctionsProject, by Marshal.GetFunctionPointerForDelegate. Moves point (n numbers) onto the
        /// surface, near it; 0 if there is no point to be found.
        /// </summary>
        public IntPtr project;
        /// <summary>
        /// A FlgManifoldFunctionsTangentBasis, by Marshal.GetFunctionPointerForDelegate. k rows of n numbers: an
        /// orthonormal basis of the tangent space at a projected point.
        /// </summary>
        public IntPtr tangent_basis;
        /// <summary>
        /// A FlgManifoldFunctionsSecondForm, by Marshal.GetFunctionPointerForDelegate. k x k numbers: the inner
        /// products of `force` (n numbers) with the second fundamental form in the basis. Null: from differences of
        /// projections.
        /// </summary>
        public IntPtr second_form;
    }

    /// <summary>
    /// Of FlgPatchFunctions.evaluate. Writes 18 numbers: the point and its derivatives u, v, uu, uv, vv; u and v are
    /// nowhere parallel, their cross product points outwards. From worker threads, several at a time; must not throw or
    /// call the SDK, 100 ns at most.
    /// </summary>
    [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
    public unsafe delegate void FlgPatchFunctionsEvaluate(void* user_data, double u, double v, double* @out);

    /// <summary>A surface in R^3 that the host knows by two parameters.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct FlgPatchFunctions
    {
        public uint struct_size;
        /// <summary>nonzero: the parameter u, v has the period high - low. Default 0: the domain ends there</summary>
        public fixed uint periodic[2];
        public uint reserved;
        /// <summary>the domain. Default 0 to 1</summary>
        public fixed double low[2];
        /// <summary>the domain. Default 0 to 1</summary>
        public fixed double high[2];
        /// <summary>
        /// of a domain that ends, in shares of it: so far beyond its ends points are still taken, twice as far the
        /// function is asked. 0 to 1. Default 0.05
        /// </summary>
        public double margin;
        /// <summary>metres: about how large it is. Default 1</summary>
        public double size;
        /// <summary>passed to the function; lives until the manifold and all splines on it are released</summary>
        public void* user_data;
        /// <summary>
        /// A FlgPatchFunctionsEvaluate, by Marshal.GetFunctionPointerForDelegate. Writes 18 numbers: the point and its
        /// derivatives u, v, uu, uv, vv; u and v are nowhere parallel, their cross product points outwards. From worker
        /// threads, several at a time; must not throw or call the SDK, 100 ns at most.
        /// </summary>
        public IntPtr evaluate;
    }

    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct FlgManifoldView
    {
        public uint struct_size;
        /// <summary>n, that points are given and shown in</summary>
        public uint ambient;
        /// <summary>k</summary>
        public uint dimension;
        public uint reserved;
        /// <summary>metres</summary>
        public double size;
        /// <summary>metres: of what it was made of (vertices, points) from it; 0 where it is exact</summary>
        public double largest_deviation;
        /// <summary>root mean square of the same</summary>
        public double mean_deviation;
    }

    /// <summary>
    /// Of FlgObstacle.value. Of FUNCTION, called from any thread; a value that is positive outside and nowhere more
    /// than the distance, and its gradient, which is not 0 within half a `half` of where it is 0. centre and half: a
    /// box with all of the solid in it.
    /// </summary>
    [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
    public unsafe delegate double FlgObstacleValue(void* user_data, double* x, double* gradient);

    /// <summary>Of the plane only x and y count. Metres.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct FlgObstacle
    {
        public FlgObstacleKind kind;
        /// <summary>3 to 256</summary>
        public uint point_count;
        public FlgSurface surface;
        /// <summary>
        /// of the grid along the longest side, 8 to 192; a layer is 4 of them thick at least. Default 64
        /// </summary>
        public uint cells;
        public uint reserved;
        /// <summary>of balls, boxes, capsules, and of the box around a function</summary>
        public fixed double centre[3];
        /// <summary>half the box's sides, above 0</summary>
        public fixed double half[3];
        /// <summary>
        /// rows: the box's axes, orthonormal to 1e-6; in the plane the first two numbers of the first two
        /// </summary>
        public fixed double axes[9];
        /// <summary>a capsule's other end</summary>
        public fixed double to[3];
        /// <summary>above 0</summary>
        public double radius;
        /// <summary>2 a point: a simple polygon, either way around; read during the call</summary>
        public double* points;
        /// <summary>
        /// A FlgObstacleValue, by Marshal.GetFunctionPointerForDelegate. Of FUNCTION, called from any thread; a value
        /// that is positive outside and nowhere more than the distance, and its gradient, which is not 0 within half a
        /// `half` of where it is 0. centre and half: a box with all of the solid in it.
        /// </summary>
        public IntPtr value;
        /// <summary>lives until the obstacles and all splines among them are released</summary>
        public void* user_data;
    }

    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct FlgObstaclesDesc
    {
        public uint struct_size;
        /// <summary>2 or 3. Default 3</summary>
        public uint dimension;
        public FlgJobOptions job;
        /// <summary>copied, but for what their user_data points to</summary>
        public FlgObstacle* obstacles;
        /// <summary>1 to 256</summary>
        public uint obstacle_count;
        public uint reserved;
        /// <summary>
        /// metres, at least 0: how far curves stay away, such as the radius of a body whose centre they are. Default 0
        /// </summary>
        public double clearance;
    }

    /// <summary>
    /// On which side a curve passes an obstacle: while its first curve is found the obstacle goes on without end
    /// against the direction. In the plane what the optimization does later keeps to it; in space there is no other
    /// side of a ball, and the curve may slide over it to where it bends less.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct FlgObstacleSide
    {
        /// <summary>its number in FlgObstaclesDesc</summary>
        public uint obstacle;
        public uint reserved;
        /// <summary>from the obstacle to where the curve passes; any length but 0</summary>
        public fixed double direction[3];
    }

    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct FlgSplineDesc
    {
        public uint struct_size;
        /// <summary>2 to 65536, closed: 3 at least (1 and 2 less where a `curve` is given)</summary>
        public uint point_count;
        /// <summary>partial_results: every round can be seen</summary>
        public FlgJobOptions job;
        public FlgManifold manifold;
        /// <summary>
        /// ambient numbers a point: to be passed through in this order, read during the call. Points off the manifold
        /// are projected, how far is in the view; two in a row must not come to one place
        /// </summary>
        public double* points;
        /// <summary>
        /// one a point, closed: one more, of the first point again; ascending. Null: lengths of the curve
        /// </summary>
        public double* parameters;
        /// <summary>nonzero: from the last point back to the first. Default 0</summary>
        public uint closed;
        /// <summary>default FlgSplineEnergy.E2</summary>
        public FlgSplineEnergy energy;
        /// <summary>of FlgSplineEnergy.Et: w, 1 / square metre, above 0 to 1e12. Default 1</summary>
        public double tension;
        /// <summary>
        /// 0: through the points. Above: the energy plus the squares of the distances to the points over this is least;
        /// metres to the third with E2 and lengths. Default 0
        /// </summary>
        public double smoothing;
        /// <summary>
        /// begins with this tension, which falls by 4 a round (sec. 3.2, homotopy). Default 0: it does not
        /// </summary>
        public double first_tension;
        /// <summary>
        /// ambient numbers: the derivative by the parameter at the first point, its tangent part is taken; open curves
        /// only. Null: natural, no bending at the end
        /// </summary>
        public double* begin_slope;
        /// <summary>the same at the last point</summary>
        public double* end_slope;
        /// <summary>default FlgSplineStart.Geodesic</summary>
        public FlgSplineStart start;
        /// <summary>default FlgSplineMethod.Newton</summary>
        public FlgSplineMethod method;
        /// <summary>
        /// points of the chain that stands for the curve, given ones included: up to 2^20, at least two intervals from
        /// one given point to the next. Default 0: 32 intervals each
        /// </summary>
        public uint node_count;
        /// <summary>of the optimization, 1 to 10000; a few smooth a curve a little (Remark 5). Default 200</summary>
        public uint max_rounds;
        /// <summary>of the residual, see the view; 1e-12 to 1. Default 1e-6</summary>
        public double tolerance;
        /// <summary>
        /// begin at this one, of as many points on the same manifold, moved along: for points that are dragged. If that
        /// failed or does not fit it is not used. Of several curves of little energy it stays with the one it comes
        /// from, which a cold start may not find. Default none
        /// </summary>
        public FlgSpline warm_start;
        /// <summary>
        /// A curve to be made fair or to be refined, instead of points in space: its points are the nodes, in order,
        /// and points[i] is what node curve_knots[i] is held at (ascending; of open curves the first and the last node
        /// are among them). node_count, start and warm_start do not count then. Default null
        /// </summary>
        public double* curve;
        /// <summary>one a given point: its node</summary>
        public uint* curve_knots;
        /// <summary>nodes of `curve`, 2 (closed: 3) to 2^20</summary>
        public uint curve_count;
        /// <summary>
        /// rounds of variational subdivision (Remark 6) afterwards: each puts one node between two, and optimizes all
        /// but the given points again. 0 to 8. Default 0
        /// </summary>
        public uint subdivisions;
        /// <summary>of `sides`. Default 0</summary>
        public uint side_count;
        /// <summary>
        /// The curve stays out of these (sec. 5): the manifold is a FlgShape.Space of as many dimensions, or a surface
        /// in R^3. It is what splines on barriers around them become whose radius shrinks to `obstacle_radius` of the
        /// scene's size; it may touch them along a stretch. A given point in an obstacle is refused. Nodes keep out of
        /// obstacles, and pieces between them do but for their sagitta; there are up to 16 times as many nodes where
        /// pieces would go through. In space the first curve goes around them, on a surface the start is without them,
        /// and sides do not count. `start`, `warm_start`, slopes and subdivisions do not count, `curve` is refused.
        /// Default none
        /// </summary>
        public FlgObstacles obstacles;
        /// <summary>how the first curve passes; default null: the shortest way</summary>
        public FlgObstacleSide* sides;
        /// <summary>1e-5 to 0.1. Default 1e-3</summary>
        public double obstacle_radius;
    }

    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct FlgSplineView
    {
        public uint struct_size;
        /// <summary>n</summary>
        public uint ambient;
        public uint node_count;
        public uint point_count;
        /// <summary>as asked for</summary>
        public uint closed;
        public FlgSplineEnding ending;
        /// <summary>n a node</summary>
        public double* nodes;
        /// <summary>one a node, closed: one more</summary>
        public double* parameters;
        /// <summary>
        /// 3 a node, unit: the surface's, outwards; null if it isn't one in R^3, and while it is running
        /// </summary>
        public float* normals;
        /// <summary>one a given point: its node</summary>
        public uint* point_nodes;
        /// <summary>one a given point, metres: how far it was from the manifold</summary>
        public double* offsets;
        /// <summary>of these, metres</summary>
        public double largest_offset;
        /// <summary>of the optimization</summary>
        public uint rounds;
        /// <summary>of all nodes onto the manifold</summary>
        public uint projections;
        /// <summary>with all weights</summary>
        public double energy;
        /// <summary>E2: exact for the spline of R^n through the nodes</summary>
        public double bending;
        /// <summary>E1 of the chain</summary>
        public double stretching;
        /// <summary>metres, of the chain</summary>
        public double length;
        /// <summary>
        /// Tangential part of the fourth derivative (with tension less w times the second, of E1 the second) at nodes
        /// that are free, root mean square, over the mean of all elastic forces along the curve, those at the given
        /// points included.
        /// </summary>
        public double residual;
    }

    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct FlgSplineCurvesDesc
    {
        public uint struct_size;
        /// <summary>metres above the surface, along its normals. Default 0</summary>
        public float height;
        public FlgJobOptions job;
        /// <summary>of R^3</summary>
        public FlgSpline spline;
    }
}
