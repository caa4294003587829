// SPDX-License-Identifier: MIT
// Structs of filigree_skeleton.h. Written by tools/abi/generate from sdk/api/abi.json: change the header.

using System;

namespace Filigree
{
    /// <summary>
    /// A drawn shape: ring 0 is its outer contour, the other rings are its holes. Rings may have either orientation and
    /// may repeat their first point at the end. The host owns the arrays, which must live for the call.
    /// </summary>
    public unsafe partial struct FlgContourView
    {
        public uint struct_size;
        /// <summary>3 to 2^24</summary>
        public uint point_count;
        /// <summary>2 per point: x, y; magnitude 0 or 1e-150 to 1e150</summary>
        public double* points;
        /// <summary>ring_count + 1 values: the start of each ring, then point_count; null: one ring</summary>
        public uint* ring_offsets;
        /// <summary>at least 1; default 1</summary>
        public uint ring_count;
        public uint reserved;
    }

    public unsafe partial struct FlgStraightSkeletonDesc
    {
        public uint struct_size;
        /// <summary>nonzero: the contour may cross and touch itself, see below. Default 0</summary>
        public uint repair;
        public FlgJobOptions* job;
        /// <summary>copied</summary>
        public FlgContourView* contour;
    }

    /// <summary>
    /// The first nodes are the contour's points, ring by ring, at time 0. Face i is the area swept by the edge that
    /// starts at point i.
    /// </summary>
    public unsafe partial struct FlgStraightSkeletonView
    {
        public uint struct_size;
        /// <summary>points of the cleaned contour; also the number of faces</summary>
        public uint contour_count;
        public uint node_count;
        public uint arc_count;
        /// <summary>
        /// 3 per node: x, y, and the time at which the front arrives: the distance to the lines of its edges
        /// </summary>
        public double* nodes;
        /// <summary>4 per arc: nodes from and to, the later one last; faces to its left and right</summary>
        public uint* arcs;
        /// <summary>contour_count + 1 values</summary>
        public uint* face_offsets;
        /// <summary>each face's nodes counter-clockwise, starting with its edge's two points</summary>
        public uint* face_nodes;
        /// <summary>one per point of the cleaned contour: its index in the input, or FLG_NO_INDEX</summary>
        public uint* input_points;
        /// <summary>
        /// Both as fractions of the contour's box diagonal. Largest difference between a time and the distance: usually
        /// 1e-13, up to 1e-6 with nearly parallel edges.
        /// </summary>
        public double residual;
        /// <summary>
        /// How far points were moved to find the skeleton: usually 0; 1e-9 or 1e-7 where events at nearly the same time
        /// could not be told apart. The first nodes remain at the contour's points.
        /// </summary>
        public double perturbation;
    }

    /// <summary>
    /// The front of a straight skeleton at a time. The host owns the arrays; null arrays are not written.
    /// </summary>
    public unsafe partial struct FlgOffsetPolygons
    {
        public uint struct_size;
        /// <summary>capacity of `points` and `edges`, in points. Default 0</summary>
        public uint point_capacity;
        /// <summary>capacity of `ring_offsets`, in rings. Default 0</summary>
        public uint ring_capacity;
        /// <summary>always written, whatever the capacity</summary>
        public uint point_count;
        /// <summary>likewise</summary>
        public uint ring_count;
        public uint reserved;
        /// <summary>2 per point: x, y</summary>
        public double* points;
        /// <summary>one per point: the contour edge that made the side from it to the next point</summary>
        public uint* edges;
        /// <summary>ring_capacity + 1 values: the start of each ring, then point_count</summary>
        public uint* ring_offsets;
    }
}
