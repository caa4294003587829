// SPDX-License-Identifier: MIT
// Types of filigree_spline.h. Written by tools/abi/generate from sdk/api/abi.json: change the header.

using System;

namespace Filigree
{
    public static unsafe partial class Native
    {
        /// <summary>Maximum dimension of the space around a manifold.</summary>
        public const uint FLG_MANIFOLD_MAX_AMBIENT = 12;
        /// <summary>Maximum nodes of a spline.</summary>
        public const uint FLG_SPLINE_MAX_NODES = 1048576;
    }

    /// <summary>Manifolds that need no data.</summary>
    public enum FlgManifoldShape
    {
        /// <summary>FLG_MANIFOLD_SHAPE_SPACE: R^ambient itself: no restriction</summary>
        Space = 0,
        /// <summary>FLG_MANIFOLD_SHAPE_PLANE: z = 0 in R^3</summary>
        Plane = 1,
        /// <summary>FLG_MANIFOLD_SHAPE_SPHERE: centred at the origin of R^3, of `radius`</summary>
        Sphere = 2,
        /// <summary>
        /// FLG_MANIFOLD_SHAPE_TORUS: around the z-axis: the circle of `radius` in the plane z = 0, thickened by
        /// `tube_radius`
        /// </summary>
        Torus = 3,
        /// <summary>
        /// FLG_MANIFOLD_SHAPE_FORMULA: the zero set of a smooth formula, by `name`: see flgFormulaGetName
        /// </summary>
        Formula = 4,
    }

    /// <summary>The kind of an obstacle; it determines which fields apply.</summary>
    public enum FlgObstacleKind
    {
        /// <summary>FLG_OBSTACLE_KIND_BALL: centre, radius</summary>
        Ball = 0,
        /// <summary>FLG_OBSTACLE_KIND_BOX: centre, half, axes</summary>
        Box = 1,
        /// <summary>FLG_OBSTACLE_KIND_CAPSULE: everything within `radius` of the segment from centre to `to`</summary>
        Capsule = 2,
        /// <summary>FLG_OBSTACLE_KIND_POLYGON: points; in space the prism over it: centre, axes, half[2]</summary>
        Polygon = 3,
        /// <summary>FLG_OBSTACLE_KIND_FUNCTION: defined by the host</summary>
        Function = 4,
        /// <summary>
        /// FLG_OBSTACLE_KIND_MESH: space only: a closed surface, kept clear of exactly; `cells` as below
        /// </summary>
        Mesh = 5,
        /// <summary>
        /// FLG_OBSTACLE_KIND_LAYER: space only: everything farther than `radius` from an open surface: curves stay in a
        /// thin layer around it, and so between its borders (sec. 5)
        /// </summary>
        Layer = 6,
        /// <summary>
        /// FLG_OBSTACLE_KIND_BORDER: space only: the region beyond a surface's open borders, for curves on its
        /// manifold. Alone, without other obstacles, nodes keep within exactly, by the clearance, and the curve may run
        /// along the border: between two nodes it may cut off a corner that points in, a right one by half their
        /// distance at most. Beside others it is a wall like them, which rounds corners by about an edge
        /// </summary>
        Border = 7,
        /// <summary>
        /// FLG_OBSTACLE_KIND_HALF_SPACE: all on one side of a plane (in the plane, of a line): centre, on the boundary,
        /// and `to`, the direction out of the solid
        /// </summary>
        HalfSpace = 8,
    }

    /// <summary>The energy a curve minimizes.</summary>
    public enum FlgSplineEnergy
    {
        /// <summary>FLG_SPLINE_ENERGY_E2: squared second derivative: cubic splines. Wide, even turns</summary>
        E2 = 0,
        /// <summary>FLG_SPLINE_ENERGY_E1: squared first derivative: geodesics, with corners at the points</summary>
        E1 = 1,
        /// <summary>FLG_SPLINE_ENERGY_ET: E2 + tension * E1: between the two</summary>
        Et = 2,
    }

    /// <summary>The initial curve, before optimization.</summary>
    public enum FlgSplineStart
    {
        /// <summary>FLG_SPLINE_START_GEODESIC: approximately the shortest paths from point to point</summary>
        Geodesic = 0,
        /// <summary>
        /// FLG_SPLINE_START_PROJECTED: the unrestricted spline, projected; for points near each other
        /// </summary>
        Projected = 1,
    }

    /// <summary>Why the optimization ended. A curve is available in each case.</summary>
    public enum FlgSplineEnding
    {
        /// <summary>FLG_SPLINE_ENDING_RUNNING: still running: the view shows one round's result</summary>
        Running = 0,
        /// <summary>
        /// FLG_SPLINE_ENDING_CONVERGED: the residual is at most the tolerance, at all nodes that are not held
        /// </summary>
        Converged = 1,
        /// <summary>
        /// FLG_SPLINE_ENDING_ROUNDING: as close as rounding allows: with thousands of nodes between points, differences
        /// cancel
        /// </summary>
        Rounding = 2,
        /// <summary>FLG_SPLINE_ENDING_ROUNDS: max_rounds was reached</summary>
        Rounds = 3,
        /// <summary>
        /// FLG_SPLINE_ENDING_STALLED: no step lowers the energy: more than a 16th of the nodes and 3 would be held. The
        /// curve is the best found; see the residual. Among obstacles also: only a barrier wider than the last one gave
        /// a curve that keeps clear
        /// </summary>
        Stalled = 4,
        /// <summary>
        /// FLG_SPLINE_ENDING_TRIANGLES: the curve over the triangles of a mesh: it was asked for, or the smooth surface
        /// can't be reached somewhere. Nodes lie on triangles, given points at the nearest points of these
        /// </summary>
        Triangles = 5,
        /// <summary>
        /// FLG_SPLINE_ENDING_EVALUATIONS: max_evaluations were used up: the best curve so far that keeps clear of all
        /// obstacles, perhaps farther away than it has to
        /// </summary>
        Evaluations = 7,
    }

    /// <summary>A surface of dimension k in R^n that curves stay on. Never changes once ready.</summary>
    public partial struct FlgManifold : IEquatable<FlgManifold>
    {
        public ulong id;
        public bool IsNull => id == 0;
        public bool Equals(FlgManifold other) => id == other.id;
        public override bool Equals(object other) => other is FlgManifold handle && Equals(handle);
        public override int GetHashCode() => id.GetHashCode();
    }

    /// <summary>A curve through points of a manifold. Never changes once ready.</summary>
    public partial struct FlgSpline : IEquatable<FlgSpline>
    {
        public ulong id;
        public bool IsNull => id == 0;
        public bool Equals(FlgSpline other) => id == other.id;
        public override bool Equals(object other) => other is FlgSpline handle && Equals(handle);
        public override int GetHashCode() => id.GetHashCode();
    }

    /// <summary>Solids that curves in the plane or in space avoid. Never change once ready.</summary>
    public partial struct FlgObstacles : IEquatable<FlgObstacles>
    {
        public ulong id;
        public bool IsNull => id == 0;
        public bool Equals(FlgObstacles other) => id == other.id;
        public override bool Equals(object other) => other is FlgObstacles handle && Equals(handle);
        public override int GetHashCode() => id.GetHashCode();
    }
}
