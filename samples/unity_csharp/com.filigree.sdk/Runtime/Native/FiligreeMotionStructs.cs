// SPDX-License-Identifier: MIT
// Structs of filigree_motion.h. Written by tools/abi/generate from sdk/api/abi.json: change the header.

using System;

namespace Filigree
{
    public unsafe partial struct FlgMotionDesc
    {
        public uint struct_size;
        /// <summary>2 to FLG_MOTION_MAX_KEYS</summary>
        public uint key_count;
        /// <summary>partial_results: every round is visible</summary>
        public FlgJobOptions* job;
        /// <summary>one per key, seconds, ascending</summary>
        public double* times;
        /// <summary>
        /// 12 per key: three rows of four, the rotation and the position. Point p of the body is then at rotation p +
        /// position. Both arrays are read during the call
        /// </summary>
        public double* poses;
        /// <summary>nonzero: the last key leads back to the first. Default 0</summary>
        public uint closed;
        /// <summary>
        /// summed over the body's points. E2: smooth throughout; E1: free flight between keys, with kicks at keys; ET:
        /// between the two. Default FlgSplineEnergy.E2
        /// </summary>
        public FlgSplineEnergy energy;
        /// <summary>
        /// for closed motions: when the first key recurs, seconds. Default 0: one average key interval after the last
        /// key
        /// </summary>
        public double end_time;
        /// <summary>for FlgSplineEnergy.Et: w, 1 / square second, above 0 to 1e12. Default 1</summary>
        public double tension;
        /// <summary>
        /// 0: passes through the keys. Above: passes near them, minimizing the energy plus the squared distances of the
        /// body's points over this; seconds to the third (E1: seconds), to 1e9. Default 0
        /// </summary>
        public double smoothing;
        /// <summary>
        /// 3 per point, in the body's coordinates: a few feature points, or a mesh's vertices; read during the call.
        /// Default null: the box
        /// </summary>
        public double* body_points;
        /// <summary>one per point, at least 0, and one above 0; null: 1 each</summary>
        public double* body_masses;
        /// <summary>
        /// 1 to 2^20, with body_points. Collinear points get a small thickness, 1/100 of their length, to define turns
        /// about the line; coincident points: see below
        /// </summary>
        public uint body_point_count;
        /// <summary>
        /// of the motion, including keys: key_count to FLG_MOTION_MAX_POSITIONS. Default 0: 32 intervals between keys
        /// </summary>
        public uint position_count;
        /// <summary>
        /// sides, centred at the origin, metres; at least 0. All 0: a point, which turns like a ball of 1 metre.
        /// Default 2, 2, 2: that ball
        /// </summary>
        public fixed double body_box[3];
        /// <summary>of the optimization, 1 to 10000. Default 200</summary>
        public uint max_rounds;
        public uint reserved;
        /// <summary>for the residual, see FlgSplineView; 1e-12 to 1. Default 1e-6</summary>
        public double tolerance;
        /// <summary>
        /// In space: the barycentre avoids these (sec. 5, Fig. 16), see FlgSplineDesc. The whole body avoids them if
        /// their clearance is its radius, the distance of its farthest point from the barycentre. Not with smoothing.
        /// Default none
        /// </summary>
        public FlgObstacles obstacles;
        /// <summary>how the initial path passes; default null: the shortest way</summary>
        public FlgObstacleSide* sides;
        /// <summary>default 0</summary>
        public uint side_count;
        public uint reserved2;
        /// <summary>1e-5 to 0.1, see FlgSplineDesc. Default 1e-3</summary>
        public double obstacle_radius;
        /// <summary>metres: what the poses' positions are relative to. Default 0</summary>
        public fixed double origin[3];
    }

    public unsafe partial struct FlgMotionView
    {
        public uint struct_size;
        public uint position_count;
        public uint key_count;
        /// <summary>as in the descriptor</summary>
        public uint closed;
        /// <summary>one per position, closed: one more, when the first recurs; seconds</summary>
        public double* times;
        /// <summary>12 per position, laid out as in the descriptor</summary>
        public double* poses;
        /// <summary>4 per position, x, y, z, w: the same rotations, consecutive ones in the same hemisphere</summary>
        public double* quaternions;
        /// <summary>one per key: its position</summary>
        public uint* key_positions;
        /// <summary>of the body: its point count or total mass; a box has 6</summary>
        public double mass;
        /// <summary>in the body's coordinates</summary>
        public fixed double barycentre[3];
        /// <summary>principal axes in the body's coordinates, one after another, right-handed</summary>
        public fixed double axes[9];
        /// <summary>distance of the body's farthest point from the barycentre, metres</summary>
        public double radius;
        /// <summary>half axes of its ellipsoid of inertia: sqrt(sum of mass * square along the axis / 2)</summary>
        public fixed double inertia[3];
        /// <summary>largest stretch removed from the keys' poses</summary>
        public double greatest_stretch;
        public FlgSplineEnding ending;
        /// <summary>of the optimization of all positions</summary>
        public uint rounds;
        /// <summary>with all weights, summed over the body's points</summary>
        public double energy;
        /// <summary>the barycentre's share: mass times its path's energy</summary>
        public double barycentre_energy;
        /// <summary>the rest: that of the rotations</summary>
        public double rotation_energy;
        /// <summary>of the rotations, see FlgSplineView</summary>
        public double residual;
        /// <summary>as in the descriptor</summary>
        public fixed double origin[3];
    }
}
