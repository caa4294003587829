// SPDX-License-Identifier: MIT
// Types of filigree_tangle.h. Written by tools/abi/generate from sdk/api/abi.json: change the header.

using System;

namespace Filigree
{
    /// <summary>The borders an operator starts from.</summary>
    public enum FlgTangleBorders
    {
        /// <summary>FLG_TANGLE_BORDERS_NONE: no borders</summary>
        None = 0,
        /// <summary>FLG_TANGLE_BORDERS_OUTER: of all regions together</summary>
        Outer = 1,
        /// <summary>FLG_TANGLE_BORDERS_EACH: of each leaf separately</summary>
        Each = 2,
    }

    /// <summary>How an operator divides regions, sec. 3.3 of the paper.</summary>
    public enum FlgTangleOperator
    {
        /// <summary>
        /// FLG_TANGLE_OPERATOR_CONTOUR: cuts along isolines of the field of a, or of the blend between a and b
        /// </summary>
        Contour = 0,
        /// <summary>
        /// FLG_TANGLE_OPERATOR_STREAM: cuts along integral curves that start evenly spaced on a, which must be lines or
        /// borders; without b also along the ridge where those of borders meet
        /// </summary>
        Stream = 1,
        /// <summary>FLG_TANGLE_OPERATOR_VORONOI: cells of the points and samples of a</summary>
        Voronoi = 2,
        /// <summary>
        /// FLG_TANGLE_OPERATOR_POLYLINE: cuts along shortest paths between consecutive points of a, and along its
        /// curves
        /// </summary>
        Polyline = 3,
    }

    /// <summary>How an operator groups the regions it makes.</summary>
    public enum FlgTangleGrouping
    {
        /// <summary>FLG_TANGLE_GROUPING_TWO: foreground (even parts) and background (odd parts)</summary>
        Two = 0,
        /// <summary>FLG_TANGLE_GROUPING_ONE: all in one group</summary>
        One = 1,
        /// <summary>FLG_TANGLE_GROUPING_EACH: each region in its own group</summary>
        Each = 2,
        /// <summary>FLG_TANGLE_GROUPING_CYCLE: by part modulo `cycle`</summary>
        Cycle = 3,
    }

    /// <summary>Common combinations of operators.</summary>
    public enum FlgTangleMacro
    {
        /// <summary>FLG_TANGLE_MACRO_SUNBURST: strips from one border to the others: a stream of the blend</summary>
        Sunburst = 0,
        /// <summary>FLG_TANGLE_MACRO_POLKA_DOTS: discs around samples: a contour</summary>
        PolkaDots = 1,
        /// <summary>FLG_TANGLE_MACRO_FRAMES: bands along the outer borders: contours</summary>
        Frames = 2,
        /// <summary>
        /// FLG_TANGLE_MACRO_FLOWER: petals between the outer borders and samples: contours of the blend
        /// </summary>
        Flower = 3,
        /// <summary>
        /// FLG_TANGLE_MACRO_GRID: a chequerboard between one border and the others: contours of the blend, then a
        /// stream
        /// </summary>
        Grid = 4,
        /// <summary>FLG_TANGLE_MACRO_OUTLINE: a band along every border: a contour</summary>
        Outline = 5,
        /// <summary>FLG_TANGLE_MACRO_LACE: scallops: a contour of points along the outer borders</summary>
        Lace = 6,
        /// <summary>FLG_TANGLE_MACRO_CELLS: Voronoi cells of samples</summary>
        Cells = 7,
    }

    /// <summary>The function that made a step.</summary>
    public enum FlgTangleStepKind
    {
        /// <summary>FLG_TANGLE_STEP_KIND_DIVIDE: flgTangleDivide</summary>
        Divide = 0,
        /// <summary>FLG_TANGLE_STEP_KIND_MACRO: flgTangleApplyMacro</summary>
        Macro = 1,
        /// <summary>FLG_TANGLE_STEP_KIND_DISPLACE: flgTangleDisplace</summary>
        Displace = 2,
        /// <summary>FLG_TANGLE_STEP_KIND_GROUP: flgTangleGroup</summary>
        Group = 3,
        /// <summary>FLG_TANGLE_STEP_KIND_UNGROUP: flgTangleUngroup</summary>
        Ungroup = 4,
        /// <summary>FLG_TANGLE_STEP_KIND_JOIN: flgTangleJoin</summary>
        Join = 5,
    }

    /// <summary>What a step does.</summary>
    public enum FlgTangleStepState
    {
        /// <summary>FLG_TANGLE_STEP_STATE_MADE: what it says</summary>
        Made = 0,
        /// <summary>FLG_TANGLE_STEP_STATE_MUTED: nothing, by flgTangleMuteStep</summary>
        Muted = 1,
        /// <summary>
        /// FLG_TANGLE_STEP_STATE_LOST: nothing: an edit of an earlier step took away what it needs. It is tried again
        /// by every edit before it
        /// </summary>
        Lost = 2,
    }

    /// <summary>A surface, the tree of its regions, and the steps that made them.</summary>
    public partial struct FlgTangle : IEquatable<FlgTangle>
    {
        public ulong id;
        public bool IsNull => id == 0;
        public bool Equals(FlgTangle other) => id == other.id;
        public override bool Equals(object other) => other is FlgTangle handle && Equals(handle);
        public override int GetHashCode() => id.GetHashCode();
    }
}
