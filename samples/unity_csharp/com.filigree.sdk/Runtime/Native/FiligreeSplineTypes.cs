// SPDX-License-Identifier: MIT
// Types of filigree_spline.h. Written by tools/abi/generate from sdk/api/abi.json: change the header.

using System;
using System.Runtime.InteropServices;

namespace Filigree
{
    public static unsafe partial class Native
    {
        /// <summary>Dimensions of the space that a manifold lies in, at most.</summary>
        public const uint FLG_MANIFOLD_MAX_AMBIENT = 12;
        /// <summary>Nodes of a spline, at most.</summary>
        public const uint FLG_SPLINE_MAX_NODES = 1048576;
    }

    /// <summary>Manifolds that need no data.</summary>
    public enum FlgShape
    {
        /// <summary>FLG_SHAPE_SPACE: R^ambient itself: nothing restricts a curve</summary>
        Space = 0,
        /// <summary>FLG_SHAPE_PLANE: z = 0 in R^3</summary>
        Plane = 1,
        /// <summary>FLG_SHAPE_SPHERE: about the origin of R^3, of `radius`</summary>
        Sphere = 2,
        /// <summary>
        /// FLG_SHAPE_TORUS: about the z-axis: the circle of `radius` in the plane z = 0, of thickness `tube_radius`
        /// </summary>
        Torus = 3,
        /// <summary>FLG_SHAPE_FORMULA: the zero set of a smooth formula, by `name`: see flgFormulaName</summary>
        Formula = 4,
    }

    /// <summary>What an obstacle is, and which of its fields count.</summary>
    public enum FlgObstacleKind
    {
        /// <summary>FLG_OBSTACLE_BALL: centre, radius</summary>
        Ball = 0,
        /// <summary>FLG_OBSTACLE_BOX: centre, half, axes</summary>
        Box = 1,
        /// <summary>FLG_OBSTACLE_CAPSULE: all within `radius` of the segment from centre to `to`</summary>
        Capsule = 2,
        /// <summary>FLG_OBSTACLE_POLYGON: of the plane: points</summary>
        Polygon = 3,
        /// <summary>FLG_OBSTACLE_FUNCTION: the host's</summary>
        Function = 4,
        /// <summary>FLG_OBSTACLE_MESH: of space: surface, a closed one, to half a cell of a grid of `cells`</summary>
        Mesh = 5,
        /// <summary>
        /// FLG_OBSTACLE_LAYER: of space: all that is farther than `radius` from surface, an open one: curves stay in a
        /// thin layer around it, and so between its borders (sec. 5)
        /// </summary>
        Layer = 6,
        /// <summary>
        /// FLG_OBSTACLE_BORDER: of space: what is beyond the open borders of surface, for curves on its manifold; takes
        /// no grid and so is quicker and nearer than a layer. Corners of borders are rounded by about an edge
        /// </summary>
        Border = 7,
    }

    /// <summary>What a curve has as little of as it can.</summary>
    public enum FlgSplineEnergy
    {
        /// <summary>FLG_SPLINE_E2: the square of the second derivative: cubic splines. Wide, even turns</summary>
        E2 = 0,
        /// <summary>FLG_SPLINE_E1: the square of the first one: geodesics, with corners at the points</summary>
        E1 = 1,
        /// <summary>FLG_SPLINE_ET: E2 + tension * E1: between the two</summary>
        Et = 2,
    }

    /// <summary>The first curve, which is then optimized.</summary>
    public enum FlgSplineStart
    {
        /// <summary>FLG_SPLINE_START_GEODESIC: about the shortest ways from point to point</summary>
        Geodesic = 0,
        /// <summary>
        /// FLG_SPLINE_START_PROJECTED: the spline that nothing restricts, projected; for points that are near to each
        /// other
        /// </summary>
        Projected = 1,
    }

    /// <summary>How a round steps.</summary>
    public enum FlgSplineMethod
    {
        /// <summary>FLG_SPLINE_NEWTON: a few rounds</summary>
        Newton = 0,
        /// <summary>
        /// FLG_SPLINE_FOOTPOINT_CONE: the paper's stepsize (Algorithm 1); for comparison, and where a manifold has no
        /// second derivatives
        /// </summary>
        FootpointCone = 1,
    }

    /// <summary>Why the optimization ended. There is a curve in each case.</summary>
    public enum FlgSplineEnding
    {
        /// <summary>FLG_SPLINE_RUNNING: what is shown is a round's result</summary>
        Running = 0,
        /// <summary>FLG_SPLINE_CONVERGED: the residual is at most the tolerance</summary>
        Converged = 1,
        /// <summary>
        /// FLG_SPLINE_ROUNDING: as near as rounding allows: with thousands of nodes between points differences vanish
        /// </summary>
        Rounding = 2,
        /// <summary>FLG_SPLINE_ROUNDS: max_rounds are used up</summary>
        Rounds = 3,
        /// <summary>
        /// FLG_SPLINE_STALLED: no step leads down: the surface is not smooth where the curve wants to be (sharp
        /// creases, rims), or obstacles leave no way there. The curve is what it got to; see the residual
        /// </summary>
        Stalled = 4,
    }

    /// <summary>What curves stay on: a surface of dimension k in R^n. Never changes once ready.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public partial struct FlgManifold : IEquatable<FlgManifold>
    {
        public ulong id;
        public bool IsNull => id == 0;
        public bool Equals(FlgManifold other) => id == other.id;
        public override bool Equals(object other) => other is FlgManifold handle && Equals(handle);
        public override int GetHashCode() => id.GetHashCode();
    }

    /// <summary>A curve through points of a manifold. Never changes once ready.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public partial struct FlgSpline : IEquatable<FlgSpline>
    {
        public ulong id;
        public bool IsNull => id == 0;
        public bool Equals(FlgSpline other) => id == other.id;
        public override bool Equals(object other) => other is FlgSpline handle && Equals(handle);
        public override int GetHashCode() => id.GetHashCode();
    }

    /// <summary>Solids that curves of the plane or of space keep out of. Never change once ready.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public partial struct FlgObstacles : IEquatable<FlgObstacles>
    {
        public ulong id;
        public bool IsNull => id == 0;
        public bool Equals(FlgObstacles other) => id == other.id;
        public override bool Equals(object other) => other is FlgObstacles handle && Equals(handle);
        public override int GetHashCode() => id.GetHashCode();
    }
}
