// SPDX-License-Identifier: MIT
// Types of filigree_debug.h. Written by tools/abi/generate from sdk/api/abi.json: change the header.

using System;

namespace Filigree
{
    /// <summary>What to draw of an object; combined with |.</summary>
    public enum FlgDebugPart
    {
        /// <summary>FLG_DEBUG_PART_LINES: its own lines: curves, arcs, bones, wireframes</summary>
        Lines = 1,
        /// <summary>FLG_DEBUG_PART_POINTS: its points, vertices, nodes, joints or keys</summary>
        Points = 2,
        /// <summary>FLG_DEBUG_PART_FRAMES: axes at its points: tangent red, normal green, second normal blue</summary>
        Frames = 4,
        /// <summary>FLG_DEBUG_PART_EDGES: the edges of its triangles, each once</summary>
        Edges = 8,
        /// <summary>FLG_DEBUG_PART_BORDERS: its borders: of surfaces, regions and contours</summary>
        Borders = 16,
        /// <summary>FLG_DEBUG_PART_SEAMS: points where a result stops copying one run of its style</summary>
        Seams = 32,
        /// <summary>FLG_DEBUG_PART_GUIDE: a style's guide</summary>
        Guide = 64,
        /// <summary>FLG_DEBUG_PART_DISPLACEMENT: lines from a style's guide to the style</summary>
        Displacement = 128,
        /// <summary>FLG_DEBUG_PART_SEEDS: where a tangle's operators start</summary>
        Seeds = 256,
        /// <summary>FLG_DEBUG_PART_CLEARANCE: how far curves keep from obstacles</summary>
        Clearance = 512,
    }
}
