// SPDX-License-Identifier: MIT
// Structs of filigree_pull.h. Written by tools/abi/generate from sdk/api/abi.json: change the header.

using System;

namespace Filigree
{
    public unsafe partial struct FlgPullDesc
    {
        public uint struct_size;
        /// <summary>metres: nearer vertices stay together; below 0: none do. Default 0: of one place</summary>
        public float weld_distance;
        public FlgJobOptions* job;
        /// <summary>at rest, up to 1048576 vertices; copied</summary>
        public FlgMeshView* mesh;
    }

    /// <summary>A point of the surface, and where it is to be.</summary>
    public unsafe partial struct FlgPullHandle
    {
        /// <summary>the same of all handles of a mesh</summary>
        public uint struct_size;
        /// <summary>of the mesh; the three may be the same. Default 0</summary>
        public fixed uint vertices[3];
        /// <summary>of these: 0 to 1, with sum 1 within 0.001. Default 1 0 0</summary>
        public fixed float shares[3];
        /// <summary>metres. Default 0</summary>
        public fixed float position[3];
        /// <summary>
        /// how far it gives way to a unit of force: that on an edge of weight 1 a metre too long; 0: it is there
        /// exactly. Finite, 0 or above. Default 0
        /// </summary>
        public float compliance;
        /// <summary>
        /// metres, at rest: it pulls at the surface within this of its point, hardest in the middle, so that no spike
        /// is pulled out. At most half way to the next handle. 0: at the point alone. Below 0: 0.04 of the mesh's
        /// diagonal, at least two edges. Finite. Default -1
        /// </summary>
        public float radius;
    }

    public unsafe partial struct FlgPulledDesc
    {
        public uint struct_size;
        /// <summary>up to FLG_PULL_MAX_HANDLES</summary>
        public uint handle_count;
        public FlgJobOptions* job;
        /// <summary>its job may still run</summary>
        public FlgPull pull;
        /// <summary>
        /// pins are handles that stay; copied. Two of compliance 0 with the same vertices and shares but other
        /// positions are refused
        /// </summary>
        public FlgPullHandle* handles;
        /// <summary>
        /// 3 per vertex, metres: the pose that pulling adds to, as flgSkinDeform gives it; copied. Null: the mesh at
        /// rest. Default null
        /// </summary>
        public float* positions;
        /// <summary>of the same pull, where this one begins; its job may still run. Default null: at the pose</summary>
        public FlgPulled previous;
        /// <summary>
        /// 1 to 1000: of the method's two steps; few are enough if each frame goes on from the one before. Default 2
        /// </summary>
        public uint rounds;
        public uint reserved;
    }

    public unsafe partial struct FlgPulledView
    {
        public uint struct_size;
        public uint vertex_count;
        /// <summary>3 per vertex, metres</summary>
        public float* positions;
        /// <summary>
        /// of the last round, before positions were found: square metres. It does not rise from round to round, if pose
        /// and handles stay
        /// </summary>
        public double energy;
        /// <summary>metres: what positions are relative to: the mesh's origin</summary>
        public fixed double origin[3];
    }

    /// <summary>Positions of handles over time: a record of what somebody dragged, or keyframes.</summary>
    public unsafe partial struct FlgPullKeys
    {
        public uint struct_size;
        /// <summary>1 to FLG_PULL_MAX_HANDLES</summary>
        public uint handle_count;
        /// <summary>
        /// handle_count + 1, from 0: the keys of handle h are offsets[h] to offsets[h + 1] - 1, at least one
        /// </summary>
        public uint* offsets;
        /// <summary>seconds, one per key, rising for each handle</summary>
        public double* times;
        /// <summary>3 per key, metres</summary>
        public float* positions;
    }
}
