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
        /// <summary>
        /// partial_results: every round is visible, of motions without pauses that neither are re-timed nor look
        /// </summary>
        public FlgJobOptions* job;
        /// <summary>one per key, seconds, ascending; see also timing</summary>
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
        /// <summary>
        /// other than GIVEN: `times` is ignored and may be null, the motion begins at 0, and `end_time` is 0. Distances
        /// are root mean squares over the body's points. Default GIVEN
        /// </summary>
        public FlgMotionTiming timing;
        /// <summary>default FlgMotionPacing.Keys</summary>
        public FlgMotionPacing pacing;
        /// <summary>
        /// m/s, at least 0. With a timing: the keys' distances, in straight lines, over the duration; 0: 1. With a
        /// pacing: the speed that is kept; 0: the motion takes as long as before. Default 0
        /// </summary>
        public double speed;
        /// <summary>
        /// two per key, 0 to 1: by how much the motion is slower just before the key, and just after it. 1: comes to
        /// rest, 0: as it is. Times of keys stay. Default null: 0
        /// </summary>
        public double* eases;
        /// <summary>of the barycentre, m/s</summary>
        public double max_speed;
        /// <summary>of the barycentre, in all directions, m/s^2</summary>
        public double max_acceleration;
        /// <summary>rad/s</summary>
        public double max_turn;
        /// <summary>rad/s^2</summary>
        public double max_turn_acceleration;
        /// <summary>
        /// metres, at least 0: comes to that of `obstacles`. For cameras the distance of the near plane's corners; for
        /// bodies their radius. Default 0
        /// </summary>
        public double clearance;
        /// <summary>default FlgMotionLook.Keys</summary>
        public FlgMotionLook look;
        /// <summary>of the target, 1 to FLG_MOTION_MAX_KEYS, with FlgMotionLook.Target</summary>
        public uint look_count;
        /// <summary>
        /// 3 per point, relative to `origin`: one point, or those that the target passes through on a cubic spline;
        /// read during the call
        /// </summary>
        public double* look_points;
        /// <summary>
        /// one per point, ascending, on the clock of the keys' times: before the first and after the last the target
        /// stands. Re-timing moves it along. Default null: evenly over the motion, of closed ones around
        /// </summary>
        public double* look_times;
        /// <summary>not 0. Where the body looks straight along it, it keeps its right side. Default 0, 1, 0</summary>
        public fixed double look_up[3];
        /// <summary>
        /// 0 to 100: leans into curves, by the angle whose tangent is this times the acceleration to the side over
        /// 9.80665 m/s^2. 1: as riders do. Default 0
        /// </summary>
        public double bank;
        /// <summary>seconds, 0 to 1e6: over which that acceleration is smoothed. Default 0.25</summary>
        public double bank_time;
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
        /// <summary>the rest: that of the rotations; 0 of a body that looks. Before re-timing</summary>
        public double rotation_energy;
        /// <summary>of the rotations, see FlgSplineView</summary>
        public double residual;
        /// <summary>as in the descriptor</summary>
        public fixed double origin[3];
        /// <summary>of the barycentre's path, metres</summary>
        public double length;
        /// <summary>of the barycentre, m/s</summary>
        public double greatest_speed;
        /// <summary>of the barycentre, m/s^2; from second differences</summary>
        public double greatest_acceleration;
        /// <summary>rad/s</summary>
        public double greatest_turn;
        /// <summary>rad</summary>
        public double greatest_bank;
    }
}
