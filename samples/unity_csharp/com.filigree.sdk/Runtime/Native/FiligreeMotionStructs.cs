// SPDX-License-Identifier: MIT
// Structs of filigree_motion.h. Written by tools/abi/generate from sdk/api/abi.json: change the header.

using System;
using System.Runtime.InteropServices;

namespace Filigree
{
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct FlgMotionDesc
    {
        public uint struct_size;
        /// <summary>2 to FLG_MOTION_MAX_KEYS</summary>
        public uint key_count;
        /// <summary>partial_results: every round can be seen</summary>
        public FlgJobOptions job;
        /// <summary>one a key, seconds, ascending</summary>
        public double* times;
        /// <summary>
        /// 12 a key: three rows of four, the rotation and the place. Points p of the body are then at rotation p +
        /// place. Both arrays are read during the call
        /// </summary>
        public double* poses;
        /// <summary>nonzero: from the last key back to the first. Default 0</summary>
        public uint closed;
        /// <summary>
        /// summed over the body's points. E2: smooth throughout; E1: between keys it flies freely, with kicks at keys;
        /// ET: between the two. Default FlgSplineEnergy.E2
        /// </summary>
        public FlgSplineEnergy energy;
        /// <summary>
        /// of closed motions: when the first key comes again, seconds. Default 0: after the last one as long as keys
        /// are apart on the average
        /// </summary>
        public double end_time;
        /// <summary>of FlgSplineEnergy.Et: w, 1 / square second, above 0 to 1e12. Default 1</summary>
        public double tension;
        /// <summary>
        /// 0: through the keys. Above: near them, the energy plus the squares of the distances of the body's points
        /// over this is least; seconds to the third (E1: seconds), to 1e9. Default 0
        /// </summary>
        public double smoothing;
        /// <summary>
        /// 3 a point, in the body's coordinates: a few feature points, or a mesh's vertices; read during the call.
        /// Default null: the box
        /// </summary>
        public double* body_points;
        /// <summary>one a point, at least 0, one above; null: 1 each</summary>
        public double* body_masses;
        /// <summary>
        /// 1 to 2^20, with body_points. Bodies whose points are on a line get a little thickness, 1/100 of their
        /// length, so that turns about the line are told apart; points in one place: see below
        /// </summary>
        public uint body_point_count;
        /// <summary>
        /// of the motion, keys included: key_count to FLG_MOTION_MAX_POSITIONS. Default 0: 32 intervals from key to key
        /// </summary>
        public uint position_count;
        /// <summary>
        /// its sides, about the origin, metres; at least 0. All 0: a point, which turns as a ball of 1 metre. Default
        /// 2, 2, 2: that ball
        /// </summary>
        public fixed double body_box[3];
        /// <summary>of the optimization, 1 to 10000. Default 200</summary>
        public uint max_rounds;
        public uint reserved;
        /// <summary>of the residual, see FlgSplineView; 1e-12 to 1. Default 1e-6</summary>
        public double tolerance;
        /// <summary>
        /// Of space: the barycentre keeps out of these (sec. 5, Fig. 16), see FlgSplineDesc. If their clearance is the
        /// body's radius, the distance of its farthest point from the barycentre, so does all of it. Not with
        /// smoothing. Default none
        /// </summary>
        public FlgObstacles obstacles;
        /// <summary>how the first path passes; default null: the shortest way</summary>
        public FlgObstacleSide* sides;
        /// <summary>default 0</summary>
        public uint side_count;
        public uint reserved2;
        /// <summary>1e-5 to 0.1, see FlgSplineDesc. Default 1e-3</summary>
        public double obstacle_radius;
    }

    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct FlgMotionView
    {
        public uint struct_size;
        public uint position_count;
        public uint key_count;
        /// <summary>as asked for</summary>
        public uint closed;
        /// <summary>one a position, closed: one more, when the first comes again; seconds</summary>
        public double* times;
        /// <summary>12 a position, as given</summary>
        public double* poses;
        /// <summary>4 a position, x, y, z, w: the same rotations, next ones on the same side</summary>
        public double* quaternions;
        /// <summary>one a key: its position</summary>
        public uint* key_positions;
        /// <summary>of the body: its points' number or masses; a box has 6</summary>
        public double mass;
        /// <summary>in the body's coordinates</summary>
        public fixed double barycentre[3];
        /// <summary>principal axes in the body's coordinates, one after another, right-handed</summary>
        public fixed double axes[9];
        /// <summary>the distance of its farthest point from the barycentre, metres</summary>
        public double radius;
        /// <summary>half the axes of its ellipsoid of inertia: sqrt(sum of mass * square along the axis / 2)</summary>
        public fixed double inertia[3];
        /// <summary>of the keys' poses: what was taken off</summary>
        public double greatest_stretch;
        public FlgSplineEnding ending;
        /// <summary>of the optimization of all positions</summary>
        public uint rounds;
        /// <summary>with all weights, summed over the body's points</summary>
        public double energy;
        /// <summary>of that, the barycentre's share: mass times its path's</summary>
        public double barycentre_energy;
        /// <summary>what is left: that of the rotations</summary>
        public double rotation_energy;
        /// <summary>of the rotations, see FlgSplineView</summary>
        public double residual;
    }
}
