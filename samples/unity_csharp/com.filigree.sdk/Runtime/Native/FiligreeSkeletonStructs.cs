// SPDX-License-Identifier: MIT
// Structs of filigree_skeleton.h. Written by tools/abi/generate from sdk/api/abi.json: change the header.

using System;
using System.Runtime.InteropServices;

namespace Filigree
{
    /// <summary>
    /// What is drawn around a shape: ring 0, and around holes in it: the others. Rings may turn either way, and be
    /// closed by a repeated first point or not. The host owns the arrays, for the time of the call.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct FlgContourView
    {
        public uint struct_size;
        /// <summary>3 to 2^24</summary>
        public uint point_count;
        /// <summary>2 a point: x, y; 0 or 1e-150 to 1e150 in size</summary>
        public double* points;
        /// <summary>ring_count + 1 values: where each ring begins, and point_count; null: one ring</summary>
        public uint* ring_offsets;
        /// <summary>at least 1; default 1</summary>
        public uint ring_count;
        public uint reserved;
    }

    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct FlgStraightSkeletonDesc
    {
        public uint struct_size;
        /// <summary>nonzero: the contour may cross and touch itself, see below. Default 0</summary>
        public uint repair;
        public FlgJobOptions job;
        public FlgContourView contour;
    }

    /// <summary>
    /// The first nodes are the contour's points, ring by ring, with time 0. Face i is what the edge sweeps that begins
    /// at point i.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct FlgStraightSkeletonView
    {
        public uint struct_size;
        /// <summary>points of the cleaned contour, and faces</summary>
        public uint contour_count;
        public uint node_count;
        public uint arc_count;
        /// <summary>3 a node: x, y, and when the front comes there: the distance to the lines of its edges</summary>
        public double* nodes;
        /// <summary>4 an arc: nodes from and to, the later one last; faces to its left and to its right</summary>
        public uint* arcs;
        /// <summary>contour_count + 1 values</summary>
        public uint* face_offsets;
        /// <summary>a face's nodes counter-clockwise, its edge's two points first</summary>
        public uint* face_nodes;
        /// <summary>one a point of the cleaned contour: which it was in the input, or FLG_NO_INDEX</summary>
        public uint* input_points;
        /// <summary>
        /// Both in shares of the diagonal of the contour's box. How far a time is off a distance, at most: 1e-13 as a
        /// rule, up to 1e-6 with edges that are nearly parallel.
        /// </summary>
        public double residual;
        /// <summary>
        /// How far points were moved to find it: 0 as a rule; 1e-9 or 1e-7 where changes at nearly one time could not
        /// be told apart. The first nodes are where the contour's points are all the same.
        /// </summary>
        public double perturbation;
    }

    /// <summary>
    /// Where the front of a straight skeleton is at a time. The host owns the arrays; a null one isn't written.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct FlgOffsetPolygons
    {
        public uint struct_size;
        /// <summary>points that `points` and `edges` have room for. Default 0</summary>
        public uint point_capacity;
        /// <summary>rings that `ring_offsets` has room for. Default 0</summary>
        public uint ring_capacity;
        /// <summary>written, whatever there is room for</summary>
        public uint point_count;
        /// <summary>the same</summary>
        public uint ring_count;
        public uint reserved;
        /// <summary>2 a point: x, y</summary>
        public double* points;
        /// <summary>one a point: the contour's edge whose side goes from it to the next one</summary>
        public uint* edges;
        /// <summary>ring_capacity + 1 values: where each ring begins, and point_count</summary>
        public uint* ring_offsets;
    }
}
