// SPDX-License-Identifier: MIT
// Structs of filigree_spline.h. Written by tools/abi/generate from sdk/api/abi.json: change the header.

using System;
using System.Runtime.InteropServices;
using static System.Runtime.InteropServices.CallingConvention;

namespace Filigree
{
    public unsafe partial struct FlgManifoldShapeDesc
    {
        public uint struct_size;
        /// <summary>default FlgManifoldShape.Space</summary>
        public FlgManifoldShape shape;
        /// <summary>for FlgManifoldShape.Space: 2 to 12. Default 3</summary>
        public uint ambient;
        public uint reserved;
        /// <summary>metres, 1e-6 to 1e6. Default 1</summary>
        public double radius;
        /// <summary>metres, 1e-6 to below radius. Default 0.25</summary>
        public double tube_radius;
        /// <summary>
        /// metres, for FlgManifoldShape.Space and FlgManifoldShape.Plane: approximate extent of the scene. Default 1
        /// </summary>
        public double size;
        /// <summary>for FlgManifoldShape.Formula</summary>
        public byte* name;
        /// <summary>
        /// metres, in R^3: where the shape is; its coordinates are relative to this. Must be 0 for
        /// FlgManifoldShape.Space, which is everywhere. Default 0
        /// </summary>
        public fixed double origin[3];
    }

    public unsafe partial struct FlgManifoldFromSurfaceDesc
    {
        public uint struct_size;
        public uint reserved;
        public FlgJobOptions* job;
        /// <summary>kept by the manifold; later cuts do not change the manifold</summary>
        public FlgSurface surface;
        /// <summary>
        /// metres: the surface is seen through this scale; smaller noise, relief and creases are rounded off, as by a
        /// road over rough ground. At most a quarter of the surface's size. Default 0: as the mesh is
        /// </summary>
        public double smoothing_scale;
    }

    public unsafe partial struct FlgManifoldFromPointsDesc
    {
        public uint struct_size;
        /// <summary>4 to 2^24</summary>
        public uint point_count;
        public FlgJobOptions* job;
        /// <summary>3 per point, metres; read during the call</summary>
        public float* points;
        /// <summary>3 per point, not 0; null: computed, and oriented consistently along the cloud</summary>
        public float* normals;
        /// <summary>points in each neighbourhood, 6 to 32: more smooth more. Default 16</summary>
        public uint neighbours;
        public uint reserved;
        /// <summary>metres, see FlgManifoldFromSurfaceDesc. Default 0</summary>
        public double smoothing_scale;
        /// <summary>metres: what points are relative to. Default 0</summary>
        public fixed double origin[3];
    }

    public unsafe partial struct FlgManifoldFromGridDesc
    {
        public uint struct_size;
        /// <summary>samples along x, y, z: 2 to 65536 each, 2^31 in total</summary>
        public fixed uint counts[3];
        public FlgJobOptions* job;
        /// <summary>position of the first sample, metres</summary>
        public fixed double corner[3];
        /// <summary>metres, above 0</summary>
        public double spacing;
        /// <summary>x fastest: a function that is negative inside and nowhere flat at 0; read during the call</summary>
        public float* values;
        /// <summary>metres: what `corner` is relative to. Default 0</summary>
        public fixed double origin[3];
    }

    /// <summary>
    /// Of FlgManifoldFunctions.project. Moves point (n numbers) onto the surface nearby; returns 0 if no point can be
    /// found.
    /// </summary>
    [UnmanagedFunctionPointer(Cdecl)]
    public unsafe delegate int FlgManifoldFunctionsProject(void* user_data, double* point, double* memory);

    /// <summary>
    /// Of FlgManifoldFunctions.tangent_basis. k rows of n numbers: an orthonormal basis of the tangent space at a
    /// projected point.
    /// </summary>
    [UnmanagedFunctionPointer(Cdecl)]
    public unsafe delegate void FlgManifoldFunctionsTangentBasis(
        void* user_data, double* point, double* memory, double* basis);

    /// <summary>
    /// Of FlgManifoldFunctions.second_form. k x k numbers: the inner products of `force` (n numbers) with the second
    /// fundamental form in the basis. Null: computed from differences of projections.
    /// </summary>
    [UnmanagedFunctionPointer(Cdecl)]
    public unsafe delegate void FlgManifoldFunctionsSecondForm(
        void* user_data, double* point, double* memory, double* basis, double* force, double* form);

    /// <summary>
    /// A manifold defined by the host. Worker threads call the functions, several at a time. They must not throw, call
    /// the SDK or take more than some us, and must give the same numbers for the same arguments.
    /// </summary>
    public unsafe partial struct FlgManifoldFunctions
    {
        public uint struct_size;
        /// <summary>n, 2 to 12</summary>
        public uint ambient;
        /// <summary>k, 1 to n</summary>
        public uint dimension;
        /// <summary>doubles stored with each point, 0 to 256; zeros at first. Default 0</summary>
        public uint memory_size;
        /// <summary>metres: approximate size, above 0. Default 1</summary>
        public double size;
        /// <summary>passed to the functions</summary>
        public void* user_data;
        /// <summary>
        /// A FlgManifoldFunctionsProject, by Marshal.GetFunctionPointerForDelegate. Moves point (n numbers) onto the
        /// surface nearby; returns 0 if no point can be found.
        /// </summary>
        public IntPtr project;
        /// <summary>
        /// A FlgManifoldFunctionsTangentBasis, by Marshal.GetFunctionPointerForDelegate. k rows of n numbers: an
        /// orthonormal basis of the tangent space at a projected point.
        /// </summary>
        public IntPtr tangent_basis;
        /// <summary>
        /// A FlgManifoldFunctionsSecondForm, by Marshal.GetFunctionPointerForDelegate. k x k numbers: the inner
        /// products of `force` (n numbers) with the second fundamental form in the basis. Null: computed from
        /// differences of projections.
        /// </summary>
        public IntPtr second_form;
        /// <summary>metres: what the functions' coordinates are relative to; 0 unless in R^3. Default 0</summary>
        public fixed double origin[3];
    }

    /// <summary>
    /// Of FlgPatchFunctions.evaluate. Writes 18 numbers: the point and its derivatives u, v, uu, uv, vv. u and v must
    /// never be parallel; their cross product points outwards. Called from worker threads, several at a time; must not
    /// throw or call the SDK; 100 ns at most.
    /// </summary>
    [UnmanagedFunctionPointer(Cdecl)]
    public unsafe delegate void FlgPatchFunctionsEvaluate(void* user_data, double u, double v, double* @out);

    /// <summary>A surface in R^3 that the host parametrizes.</summary>
    public unsafe partial struct FlgPatchFunctions
    {
        public uint struct_size;
        /// <summary>nonzero: parameter u or v has the period high - low. Default 0: the domain ends there</summary>
        public fixed uint periodic[2];
        public uint reserved;
        /// <summary>the domain. Default 0 to 1</summary>
        public fixed double low[2];
        /// <summary>the domain. Default 0 to 1</summary>
        public fixed double high[2];
        /// <summary>
        /// extends a domain that ends, as a fraction of it: points this far beyond its ends are still accepted, and the
        /// function is called up to twice as far. 0 to 1. Default 0.05
        /// </summary>
        public double margin;
        /// <summary>metres: approximate size. Default 1</summary>
        public double size;
        /// <summary>passed to the function; lives until the manifold and all splines on it are released</summary>
        public void* user_data;
        /// <summary>
        /// A FlgPatchFunctionsEvaluate, by Marshal.GetFunctionPointerForDelegate. Writes 18 numbers: the point and its
        /// derivatives u, v, uu, uv, vv. u and v must never be parallel; their cross product points outwards. Called
        /// from worker threads, several at a time; must not throw or call the SDK; 100 ns at most.
        /// </summary>
        public IntPtr evaluate;
        /// <summary>metres: what the function's points are relative to. Default 0</summary>
        public fixed double origin[3];
    }

    public unsafe partial struct FlgManifoldView
    {
        public uint struct_size;
        /// <summary>n, the dimension of points given and shown</summary>
        public uint ambient;
        /// <summary>k</summary>
        public uint dimension;
        public uint reserved;
        /// <summary>metres</summary>
        public double size;
        /// <summary>metres: of the source data (vertices, points) from it; 0 where it is exact</summary>
        public double largest_deviation;
        /// <summary>root mean square of the same deviation</summary>
        public double mean_deviation;
        /// <summary>metres: what the manifold's points are relative to</summary>
        public fixed double origin[3];
    }

    /// <summary>
    /// Of FlgObstacle.value. For FlgObstacleKind.Function, called from any thread. Returns a value that is positive
    /// outside and never exceeds the distance, and writes its gradient, which must not be 0 within half a `half` of the
    /// zero set. centre and half: a box that contains the whole solid.
    /// </summary>
    [UnmanagedFunctionPointer(Cdecl)]
    public unsafe delegate double FlgObstacleValue(void* user_data, double* x, double* gradient);

    /// <summary>In the plane only x and y are used. Metres.</summary>
    public unsafe partial struct FlgObstacle
    {
        /// <summary>the same of all obstacles of a set</summary>
        public uint struct_size;
        public FlgObstacleKind kind;
        public FlgSurface surface;
        /// <summary>
        /// grid cells along the longest side, 8 to 192: through them the curve is found. A layer is at least 4 of them
        /// thick. Default 64
        /// </summary>
        public uint cells;
        /// <summary>3 to 256</summary>
        public uint point_count;
        /// <summary>
        /// of balls, boxes, capsules, half-spaces, and the box around a function; in space what a polygon's points are
        /// relative to
        /// </summary>
        public fixed double centre[3];
        /// <summary>half the box's sides, above 0; of a prism the last: half its height</summary>
        public fixed double half[3];
        /// <summary>
        /// rows: the box's axes, orthonormal to 1e-6; in the plane the first two numbers of the first two rows. A
        /// prism's polygon lies along the first two, its height along the third
        /// </summary>
        public fixed double axes[9];
        /// <summary>a capsule's other end; of a half-space, any length but 0</summary>
        public fixed double to[3];
        /// <summary>above 0</summary>
        public double radius;
        /// <summary>2 per point: a simple polygon, in either orientation; read during the call</summary>
        public double* points;
        /// <summary>
        /// A FlgObstacleValue, by Marshal.GetFunctionPointerForDelegate. For FlgObstacleKind.Function, called from any
        /// thread. Returns a value that is positive outside and never exceeds the distance, and writes its gradient,
        /// which must not be 0 within half a `half` of the zero set. centre and half: a box that contains the whole
        /// solid.
        /// </summary>
        public IntPtr value;
        /// <summary>must live until the obstacles and all splines among them are released</summary>
        public void* user_data;
    }

    public unsafe partial struct FlgObstaclesDesc
    {
        public uint struct_size;
        /// <summary>2 or 3. Default 3</summary>
        public uint dimension;
        public FlgJobOptions* job;
        /// <summary>copied, except the data at user_data</summary>
        public FlgObstacle* obstacles;
        /// <summary>1 to 256</summary>
        public uint obstacle_count;
        public uint reserved;
        /// <summary>
        /// metres, at least 0: distance that curves keep, such as the radius of a body whose centre they carry. Default
        /// 0
        /// </summary>
        public double clearance;
        /// <summary>
        /// metres: what the obstacles' places are relative to; surfaces keep their own. 0 in the plane. Default 0
        /// </summary>
        public fixed double origin[3];
    }

    /// <summary>
    /// The side on which a curve passes an obstacle: while the initial curve is found, the obstacle extends without end
    /// against the direction: in the plane and in space straight, on a surface along it, as far as the surface is large
    /// (where that leads back to the obstacle, half way around). In the plane and on surfaces the optimized curve stays
    /// on that side. In space a ball has no other side, and the curve may slide over it to where it bends less. On a
    /// surface the job fails for obstacles that do not cut it near their middle, and for directions across it.
    /// </summary>
    public unsafe partial struct FlgObstacleSide
    {
        /// <summary>its index in FlgObstaclesDesc</summary>
        public uint obstacle;
        public uint reserved;
        /// <summary>from the obstacle towards the curve; any length but 0</summary>
        public fixed double direction[3];
    }

    /// <summary>
    /// What a curve does at one of its given points besides passing through: leave in a direction, or turn a corner.
    /// </summary>
    public unsafe partial struct FlgSplineHandle
    {
        /// <summary>the same of all handles of a spline</summary>
        public uint struct_size;
        /// <summary>the given point's index</summary>
        public uint point;
        /// <summary>
        /// ambient numbers, not all 0: the derivative by the parameter there, of which the part tangent to the manifold
        /// counts. Null: the curve may have a corner there, as two splines that share the point. Default null
        /// </summary>
        public double* slope;
    }

    public unsafe partial struct FlgSplineDesc
    {
        public uint struct_size;
        /// <summary>2 to 65536, closed: at least 3 (1 and 2 less with a `curve`)</summary>
        public uint point_count;
        /// <summary>partial_results: every round is visible</summary>
        public FlgJobOptions* job;
        public FlgManifold manifold;
        /// <summary>
        /// ambient numbers per point: interpolated in this order, read during the call. Points off the manifold are
        /// projected (the view has the distances); two consecutive points must not project to the same place
        /// </summary>
        public double* points;
        /// <summary>
        /// one per point, closed: one more, for the return to the first point; ascending. Null: lengths of the curve
        /// </summary>
        public double* parameters;
        /// <summary>nonzero: the last point connects back to the first. Default 0</summary>
        public uint closed;
        /// <summary>default FlgSplineEnergy.E2</summary>
        public FlgSplineEnergy energy;
        /// <summary>for FlgSplineEnergy.Et: w, 1 / square metre, above 0 to 1e12. Default 1</summary>
        public double tension;
        /// <summary>
        /// 0: interpolates the points. Above: minimizes the energy plus the squared distances to the points over this;
        /// metres to the third with E2 and lengths. Default 0
        /// </summary>
        public double smoothing;
        /// <summary>initial tension, divided by 4 each round (sec. 3.2, homotopy). Default 0: none</summary>
        public double first_tension;
        /// <summary>
        /// ambient numbers: the derivative by the parameter at the first point, projected to its tangent part; open
        /// curves only. Null: natural, no bending at the end
        /// </summary>
        public double* begin_slope;
        /// <summary>likewise at the last point</summary>
        public double* end_slope;
        /// <summary>default FlgSplineStart.Geodesic</summary>
        public FlgSplineStart start;
        /// <summary>
        /// nodes of the chain that represents the curve, given points included: up to 2^20, at least two intervals
        /// between given points. Default 0: 32 intervals each
        /// </summary>
        public uint node_count;
        /// <summary>of the optimization, 1 to 10000; a few smooth a curve slightly (Remark 5). Default 200</summary>
        public uint max_rounds;
        /// <summary>number of `sides`, below. Default 0</summary>
        public uint side_count;
        /// <summary>for the residual, see the view; 1e-12 to 1. Default 1e-6</summary>
        public double tolerance;
        /// <summary>
        /// start from this spline, moved along; for dragged points. It needs as many points on the same manifold.
        /// Ignored if it failed or does not fit. Where several curves have low energy, the result stays with the
        /// previous one, which a cold start may not find. Default none
        /// </summary>
        public FlgSpline warm_start;
        /// <summary>
        /// A curve to fair or refine, instead of points in space: its points are the nodes, in order. points[i] fixes
        /// node curve_knots[i] (ascending; for open curves they include the first and last node). node_count, start and
        /// warm_start are then ignored. Default null
        /// </summary>
        public double* curve;
        /// <summary>one per given point: its node</summary>
        public uint* curve_knots;
        /// <summary>nodes of `curve`, 2 (closed: 3) to 2^20</summary>
        public uint curve_count;
        /// <summary>
        /// rounds of variational subdivision (Remark 6) afterwards: each inserts a node between every two, and
        /// optimizes all but the given points again. 0 to 8. Default 0
        /// </summary>
        public uint subdivisions;
        /// <summary>
        /// The curve avoids these (sec. 5). The manifold must be a FlgManifoldShape.Space of the same dimension, or a
        /// surface in R^3. The result is the limit of splines on barriers around them, as the barriers' radius shrinks
        /// to `obstacle_radius` of the scene's size; nodes keep a tenth of that radius away, up to a half where they
        /// must. The chain and the cubic spline through its nodes keep their clearance everywhere, to 2e-7 of the
        /// scene's size: there are more nodes where that needs them. A mesh is its triangles, not a grid of them. The
        /// job fails where it can't be had, and says near which obstacle and where. A given point inside an obstacle is
        /// refused; one that touches is not, and beside it the curve may come nearer by a tenth of the barriers'
        /// radius. The initial curve goes around the obstacles. `start`, `warm_start`, slopes and subdivisions are
        /// ignored, but where there is only the border of the manifold's own mesh, beyond which given points are passed
        /// too; `curve` is refused. Default none
        /// </summary>
        public FlgObstacles obstacles;
        /// <summary>how the initial curve passes; default null: the shortest way</summary>
        public FlgObstacleSide* sides;
        /// <summary>1e-5 to 0.1. Default 1e-3</summary>
        public double obstacle_radius;
        /// <summary>metres: what `points` and `curve` are relative to; 0 unless in R^3. Default 0</summary>
        public fixed double origin[3];
        /// <summary>
        /// nonzero: on the manifold of a mesh, the result is the curve over its triangles that is else only shown first
        /// (see flgSplineCreate): some ms, whatever the mesh. `energy` and what belongs to it count for nothing.
        /// Refused together with obstacles. Default 0
        /// </summary>
        public uint on_triangles;
        /// <summary>
        /// nonzero: the view gives, for each node, the nearest point of the mesh's triangles. The manifold must be that
        /// of a mesh. Default 0
        /// </summary>
        public uint surface_points;
        /// <summary>
        /// in any order, one at most per point. Between them the spline is minimized piece by piece, and its rounds are
        /// not shown; points with a handle are passed exactly, whatever the smoothing. Refused together with obstacles
        /// or `curve`. Default null
        /// </summary>
        public FlgSplineHandle* handles;
        public uint handle_count;
        /// <summary>
        /// nonzero, with a warm_start: also minimizes from a new initial curve, and takes that where its energy is more
        /// than 5 % lower; the view says so. Takes as long as without the warm_start besides. Refused together with
        /// obstacles or `curve`. Default 0
        /// </summary>
        public uint seek_lower;
        /// <summary>
        /// one per point: its own `smoothing`, from 0 (passes through) to 1e30. Refused together with obstacles.
        /// Default null: `smoothing` for all
        /// </summary>
        public double* softness;
        /// <summary>
        /// one per segment from a given point to the next, closed: also for the return: factors of `tension`, 0 to
        /// 1e12; for FlgSplineEnergy.Et. Refused together with obstacles. Default null: 1
        /// </summary>
        public double* tensions;
        /// <summary>
        /// metres; above 0: the view also gives the curve as few cubic pieces, at most so far from it. Default 0: none
        /// </summary>
        public double key_tolerance;
        /// <summary>
        /// among obstacles: how often, at most, nodes are put onto barriers or take part in a round; the first way
        /// around the obstacles and the looks that prove the clearance are counted in proportion. 0.5 to 1 us each,
        /// half as long again for each 16 obstacles: it bounds the time, and is the same on every machine. Used up, the
        /// result is the best curve so far that keeps clear (FlgSplineEnding.Evaluations), perhaps of fewer nodes than
        /// node_count; the job fails if there is none. Fewer than some 40 a node leave none. 0: no bound. Default
        /// 2000000, 1 to 2 s at most; it stands for 800 a node (of node_count) where that is less, but for 600000 at
        /// least
        /// </summary>
        public ulong max_evaluations;
    }

    public unsafe partial struct FlgSplineView
    {
        public uint struct_size;
        /// <summary>n</summary>
        public uint ambient;
        public uint node_count;
        public uint point_count;
        /// <summary>as in the descriptor</summary>
        public uint closed;
        public FlgSplineEnding ending;
        /// <summary>n per node</summary>
        public double* nodes;
        /// <summary>one per node, closed: one more</summary>
        public double* parameters;
        /// <summary>
        /// 3 per node, unit: the surface's, outwards; null if it is not a surface in R^3, and while running
        /// </summary>
        public float* normals;
        /// <summary>one per given point: its node</summary>
        public uint* point_nodes;
        /// <summary>
        /// nodes that stay at an edge or a gap of the surface, ascending; the curve is optimized as if they were given
        /// points. Null if there are none
        /// </summary>
        public uint* held_nodes;
        /// <summary>one per given point, metres: its distance from the manifold</summary>
        public double* offsets;
        /// <summary>the largest of these, metres</summary>
        public double largest_offset;
        /// <summary>of the optimization</summary>
        public uint rounds;
        /// <summary>projections of all nodes onto the manifold</summary>
        public uint projections;
        /// <summary>number of held_nodes; 0 while running</summary>
        public uint held_count;
        /// <summary>nonzero: the curve over triangles, for now or in the end</summary>
        public uint on_triangles;
        /// <summary>with all weights</summary>
        public double energy;
        /// <summary>E2: exact for the spline of R^n through the nodes</summary>
        public double bending;
        /// <summary>E1 of the chain</summary>
        public double stretching;
        /// <summary>metres, of the chain</summary>
        public double length;
        /// <summary>
        /// Tangential part of the fourth derivative (with tension minus w times the second; for E1 the second) at free
        /// nodes, root mean square, divided by the mean of all elastic forces along the curve, including those at the
        /// given points.
        /// </summary>
        public double residual;
        /// <summary>
        /// metres: what the nodes are relative to: the manifold's origin; on FlgManifoldShape.Space the descriptor's
        /// </summary>
        public fixed double origin[3];
        /// <summary>
        /// one per node, where asked for: the nearest point of the mesh's triangles, as they were when the spline was
        /// made. Null else, and while running
        /// </summary>
        public FlgSurfacePoint* surface_points;
        /// <summary>metres: of these, the largest distance from its node</summary>
        public double largest_moved;
        /// <summary>
        /// The curve as cubic pieces from key to key, where asked for; null and 0 else, and while running. As glTF's
        /// CUBICSPLINE has it: an animation's output is arriving, point, leaving for each key. Bezier's points from a
        /// key to the next, h later in parameter: point, point + h / 3 leaving, next point - h / 3 next arriving, next
        /// point. There is a key at each given point; a closed curve's last key is its first again.
        /// </summary>
        public uint key_count;
        /// <summary>
        /// nonzero: with seek_lower, the curve is not that which goes on from the warm_start, but another one of lower
        /// energy
        /// </summary>
        public uint jumped;
        /// <summary>ascending; a closed curve's with handles begin at the first one</summary>
        public double* key_parameters;
        /// <summary>n per key</summary>
        public double* key_points;
        /// <summary>n per key: the derivative by the parameter before it</summary>
        public double* key_arriving;
        /// <summary>likewise after it: the same but at handles and, with E1, at given points</summary>
        public double* key_leaving;
        /// <summary>metres: the pieces' largest distance from the cubic spline through the nodes</summary>
        public double largest_key_error;
    }

    public unsafe partial struct FlgSplineTraceDesc
    {
        public uint struct_size;
        public uint reserved;
        public FlgJobOptions* job;
        /// <summary>on the manifold of a mesh</summary>
        public FlgSpline spline;
        /// <summary>
        /// metres to the left of the curve, seen from outside: all places of the triangles so far from it on that side,
        /// within a thousandth, in one curve or more; none fails. Default 0
        /// </summary>
        public double offset;
    }

    public unsafe partial struct FlgSplineSampleDesc
    {
        public uint struct_size;
        /// <summary>metres above the surface, along its normals. Default 0</summary>
        public float height;
        public FlgJobOptions* job;
        /// <summary>in R^3</summary>
        public FlgSpline spline;
        /// <summary>
        /// metres between points, evenly along the curve: rounded so that it fits the length a whole number of times.
        /// 0: points are nodes. Default 0
        /// </summary>
        public double spacing;
    }

    public unsafe partial struct FlgSplineSweepDesc
    {
        public uint struct_size;
        /// <summary>quads across, 1 to 256. Default 4</summary>
        public uint columns;
        public FlgJobOptions* job;
        /// <summary>in R^3</summary>
        public FlgSpline spline;
        /// <summary>
        /// metres, 1e-30 to 1e30; where it conforms, it is twice the diagonal of the mesh's box at most. Default 1
        /// </summary>
        public double width;
        /// <summary>
        /// metres between rows, as of FlgSplineSampleDesc; a closed one has at least 3. 0: a row at each node. Default
        /// 0
        /// </summary>
        public double spacing;
        /// <summary>metres above where it lies, along its own normals. Default 0</summary>
        public double height;
        /// <summary>
        /// metres: it leans into bends by the angle whose tangent is the curvature times this, which is the square of a
        /// speed over 9.81. For ribbons that do not conform. Default 0: none
        /// </summary>
        public double bank;
        /// <summary>
        /// metres of the curve for a texture once; rounded so that it fits around a closed one. 1e-30 to 1e30; 0: the
        /// width. Default 0
        /// </summary>
        public double texture_length;
        /// <summary>
        /// rows are level, across this direction; 0: across the surface's normals. Needed by curves in free space. For
        /// ribbons that do not conform. Default 0
        /// </summary>
        public fixed double up[3];
        /// <summary>
        /// nonzero: rows lie on the triangles of the spline's mesh, and end at its border. Between its vertices the
        /// ribbon is straight, so the mesh may stand above it a little: `height` lifts it. Only the curve's bends limit
        /// how wide rows are: where the mesh itself bends, those of a wide ribbon may cross. Default 0: rows are
        /// straight
        /// </summary>
        public uint conforms;
        public uint reserved;
    }

    public unsafe partial struct FlgSplineOffsetDesc
    {
        public uint struct_size;
        /// <summary>
        /// nonzero: a curve that is farther away than a bend is wide keeps the loop it makes there. Default 0: loops
        /// are cut off
        /// </summary>
        public uint keeps_loops;
        public FlgJobOptions* job;
        /// <summary>in R^3</summary>
        public FlgSpline spline;
        /// <summary>metres to the left of the curve, seen from above; below 0: to the right. Default 0</summary>
        public double left;
        /// <summary>metres upwards; below 0: downwards. Default 0</summary>
        public double above;
        /// <summary>
        /// metres between the points of `spline` that it is made of, as of FlgSplineSampleDesc. Default 0
        /// </summary>
        public double spacing;
        /// <summary>
        /// what is upwards: left is across this direction. 0: the surface's normals, and the way to the left goes
        /// straight over the surface; in free space as with turns_least. Default 0
        /// </summary>
        public fixed double up[3];
        /// <summary>
        /// nonzero: `up` counts at the beginning only (0: the surface's normal there; in free space +z, or +y where the
        /// curve begins along z). From there left and up turn about the curve as little as may be; around a closed one
        /// they are turned back evenly. Default 0
        /// </summary>
        public uint turns_least;
        public uint reserved;
    }

    public unsafe partial struct FlgCableHangDesc
    {
        public uint struct_size;
        /// <summary>of all cables, 2 to 65536</summary>
        public uint point_count;
        public FlgJobOptions* job;
        /// <summary>
        /// 3 per point, metres: a cable is fixed at each, and hangs from one to the next; read during the call
        /// </summary>
        public double* points;
        /// <summary>
        /// cable_count + 1, from 0 to point_count: where each cable's points begin, at least 2 each. Null: one cable
        /// </summary>
        public uint* cable_offsets;
        /// <summary>1 to 65536, with cable_offsets. Default 0</summary>
        public uint cable_count;
        /// <summary>straight pieces from a point to the next, 4 to 4096. Default 64</summary>
        public uint segments;
        /// <summary>
        /// one per span from a point of a cable to its next one, metres: at least their distance, at most 1000 times
        /// it. Null: by slack
        /// </summary>
        public double* lengths;
        /// <summary>
        /// by how much spans are longer than the distance of their points, over it: 0 to 999. Default 0.02
        /// </summary>
        public double slack;
        /// <summary>the direction in which they hang, any length but 0. Default 0, 0, -1</summary>
        public fixed double gravity[3];
        /// <summary>of 3 dimensions: what they rest on, without friction. Default none</summary>
        public FlgObstacles obstacles;
        /// <summary>metres: what `points` are relative to, and the result. Default 0</summary>
        public fixed double origin[3];
    }
}
