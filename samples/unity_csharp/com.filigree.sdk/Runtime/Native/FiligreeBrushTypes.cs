// SPDX-License-Identifier: MIT
// Types of filigree_brush.h. Written by tools/abi/generate from sdk/api/abi.json: change the header.

using System;

namespace Filigree
{
    /// <summary>The cross-section of a brush mesh.</summary>
    public enum FlgBrushShape
    {
        /// <summary>
        /// FLG_BRUSH_SHAPE_RIBBON: flat, along the frame's second normal (tangent x normal), facing the first
        /// </summary>
        Ribbon = 0,
        /// <summary>FLG_BRUSH_SHAPE_TUBE: round, with `sides` sides</summary>
        Tube = 1,
    }

    /// <summary>The end of an open curve. An end of radius 0 gets none.</summary>
    public enum FlgBrushCap
    {
        /// <summary>FLG_BRUSH_CAP_NONE: tubes are open</summary>
        None = 0,
        /// <summary>FLG_BRUSH_CAP_FLAT: a disc; ribbons end flat without one</summary>
        Flat = 1,
        /// <summary>FLG_BRUSH_CAP_ROUND: half a sphere, of ribbons half a disc, beyond the curve's end</summary>
        Round = 2,
        /// <summary>FLG_BRUSH_CAP_TAPERED: a tip beyond the curve's end: `cap_length` radii long</summary>
        Tapered = 3,
    }

    /// <summary>How the segments on both sides of a corner meet. Smaller turns are always mitered.</summary>
    public enum FlgBrushJoin
    {
        /// <summary>
        /// FLG_BRUSH_JOIN_MITER: extended until they meet; bevelled where that takes more than 4 radii (turns above 151
        /// degrees)
        /// </summary>
        Miter = 0,
        /// <summary>FLG_BRUSH_JOIN_BEVEL: cut straight</summary>
        Bevel = 1,
        /// <summary>FLG_BRUSH_JOIN_ROUND: turned about the point, in steps as fine as the tube's sides</summary>
        Round = 2,
        /// <summary>
        /// FLG_BRUSH_JOIN_NARROW: not extended: the mesh gets thinner, also in turns that are no corner. Cheapest
        /// </summary>
        Narrow = 3,
    }

    /// <summary>In what texture coordinates are measured.</summary>
    public enum FlgBrushUv
    {
        /// <summary>FLG_BRUSH_UV_UNIT: 0 to 1</summary>
        Unit = 0,
        /// <summary>FLG_BRUSH_UV_METRES: metres</summary>
        Metres = 1,
    }
}
