// SPDX-License-Identifier: MIT
// Structs of filigree_model.h. Written by tools/abi/generate from sdk/api/abi.json: change the header.

using System;
using System.Runtime.InteropServices;

namespace Filigree
{
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct FlgOutlineDesc
    {
        public uint struct_size;
        public uint region_count;
        public FlgJobOptions job;
        public FlgSurface surface;
        /// <summary>labels of the surface; null: all of it. Copied</summary>
        public uint* regions;
        /// <summary>
        /// to where it is looked at from, of any length; 0 0 0: to where its triangles look on the average, which suits
        /// flat regions. Default 0 0 0
        /// </summary>
        public fixed float direction[3];
        public uint reserved;
    }

    /// <summary>Ready to be a part: `contour` for FlgPartDesc, `placement` for FlgModelPart.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct FlgOutlineView
    {
        public uint struct_size;
        public uint reserved;
        /// <summary>metres, in the plane through the middle of the triangles; y is up as far as it can be</summary>
        public FlgContourView contour;
        /// <summary>takes it back to where the surface is</summary>
        public fixed double placement[12];
    }

    /// <summary>
    /// Shares are of the part's length: that of the contour's ring 0 as it is drawn, but three times the diagonal of
    /// its box at most (a frayed line is not a larger drawing).
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct FlgPartDesc
    {
        public uint struct_size;
        /// <summary>
        /// nonzero: the contour may cross and touch itself, as FlgStraightSkeletonDesc has it. Default 0
        /// </summary>
        public uint repair;
        public FlgJobOptions job;
        public FlgContourView contour;
        /// <summary>
        /// the drawn line gets points so far apart, a share: 0.0005 to 0.1, default 0.005; 0: as drawn
        /// </summary>
        public double spacing;
        /// <summary>the axis is that of an outline within this of the line, a share: 0 to 0.1, default 0.0015</summary>
        public double tolerance;
        /// <summary>
        /// arcs of the axis shorter than this share of their mean length vanish: 0 to 10, default 0.5
        /// </summary>
        public double collapse;
    }

    /// <summary>A point of a branch's axis, with the slice across it.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct FlgAxisSample
    {
        /// <summary>on the axis</summary>
        public double x;
        /// <summary>on the axis</summary>
        public double y;
        /// <summary>the unit vector to the left of the axis</summary>
        public double left_x;
        /// <summary>the unit vector to the left of the axis</summary>
        public double left_y;
        /// <summary>
        /// how far the slice goes to either side: to the outline, or to twice the room around the axis
        /// </summary>
        public double left;
        /// <summary>
        /// how far the slice goes to either side: to the outline, or to twice the room around the axis
        /// </summary>
        public double right;
    }

    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct FlgPartView
    {
        public uint struct_size;
        /// <summary>points</summary>
        public uint outline_count;
        /// <summary>2 a point</summary>
        public double* outline;
        /// <summary>ring_count + 1 values: where each ring begins, and outline_count</summary>
        public uint* outline_rings;
        public uint ring_count;
        /// <summary>of the axis: at least 1</summary>
        public uint node_count;
        /// <summary>3 a node: x, y, and the radius of a disc around it that is inside of the outline</summary>
        public double* nodes;
        /// <summary>2 an arc: nodes; node_count - 1 arcs</summary>
        public uint* arcs;
        /// <summary>of all branches, one behind the other</summary>
        public FlgAxisSample* samples;
        /// <summary>4 a branch: nodes where it begins and ends; its first sample, and one beyond its last</summary>
        public uint* branches;
        public uint sample_count;
        /// <summary>0 if the axis is one node</summary>
        public uint branch_count;
        /// <summary>what shares are of</summary>
        public double length;
    }

    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct FlgPartMeshDesc
    {
        public uint struct_size;
        /// <summary>
        /// 0.01 to 100, default 1: a disc becomes a ball, a long strip a tube 1.4 times as deep as it is wide
        /// </summary>
        public float thickness;
        public FlgJobOptions job;
        public FlgPart part;
        /// <summary>
        /// length of edges, in units of the drawing, 1e-4 to 1 of the part's length; 0: by itself, for 500 to 3,000
        /// vertices. Default 0
        /// </summary>
        public double spacing;
    }

    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct FlgPartMeshView
    {
        public uint struct_size;
        public uint vertex_count;
        public uint triangle_count;
        public uint reserved;
        /// <summary>3 a vertex, units of the drawing; z is the height above its plane</summary>
        public float* positions;
        /// <summary>3 a triangle, counter-clockwise as seen from outside</summary>
        public uint* triangles;
    }

    /// <summary>
    /// How fine the bones are. Shares are of the model's size, the largest length of its parts as placed; the defaults
    /// are the paper's pixels where that is 2,000 pixels. 0 to 10 each.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct FlgBoneThresholds
    {
        /// <summary>joints along a branch keep axis and shape to within this; default 0.0025</summary>
        public float simplify;
        /// <summary>junctions nearer to each other along the bones become one; default 0.015</summary>
        public float merge;
        /// <summary>branches to an end that are shorter are removed; default 0.015</summary>
        public float prune;
        /// <summary>bones shorter than this, with bones at both ends, vanish; default 0.005</summary>
        public float collapse;
    }

    /// <summary>A part, where it is in a model, and how it is refined there.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct FlgModelPart
    {
        /// <summary>may be used more than once, and be in the making</summary>
        public FlgPart part;
        /// <summary>UTF-8, 1 to 63 bytes, each part another; null: "part" and its number</summary>
        public byte* name;
        /// <summary>
        /// rows of a 3 x 4 matrix that takes (x, y, 0, 1) to the model's space: rotation, one scale, translation,
        /// mirrored or not. Default: as drawn
        /// </summary>
        public fixed double placement[12];
        /// <summary>
        /// how deep the part is against the paper's inflation: 0.01 to 100, default 1; a disc becomes a ball
        /// </summary>
        public float thickness;
        /// <summary>
        /// nonzero: the part is there a second time, mirrored at desc.mirror; names end with .L and .R, .L for the one
        /// on the side of the plane's normal. Default 0
        /// </summary>
        public uint mirrored;
        /// <summary>null: the model's</summary>
        public FlgBoneThresholds* thresholds;
        /// <summary>one a branch of the part, negative: the part's; null: all the part's</summary>
        public float* branch_simplify;
        /// <summary>the part's, where branch_simplify is given</summary>
        public uint branch_count;
        public uint reserved;
    }

    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct FlgModelDesc
    {
        public uint struct_size;
        /// <summary>1 to 4096</summary>
        public uint part_count;
        public FlgJobOptions job;
        /// <summary>in the order they were modelled: a part hangs on an earlier one</summary>
        public FlgModelPart* parts;
        public FlgBoneThresholds thresholds;
        /// <summary>
        /// how much the shape counts in `simplify`, alpha_s of Eq. 1 (the paper gives no number): 0 to 100, default
        /// 0.25
        /// </summary>
        public float shape_weight;
        /// <summary>
        /// A plane a x + b y + c z = d, its normal of any length above 0, pointing to the model's left (of one that
        /// looks along +x, y up: 0 0 -1). A part across it is doubled where it is. Default 1 0 0 0
        /// </summary>
        public fixed float mirror[4];
        public uint reserved;
    }

    /// <summary>Where a part came to hang.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct FlgModelPartInfo
    {
        /// <summary>how it was connected, before bones were refined</summary>
        public FlgPartEvent @event;
        /// <summary>the part it hangs on; FLG_NO_INDEX: none</summary>
        public uint parent;
        /// <summary>its own nearest to the root, which swings it; if it has none left, the one that moves it</summary>
        public uint joint;
        /// <summary>which of the host's parts it is</summary>
        public uint source;
        /// <summary>the part that is its mirror image; FLG_NO_INDEX: none</summary>
        public uint twin;
        /// <summary>1: it is the image, not what was drawn</summary>
        public uint is_mirrored;
    }

    /// <summary>Joints with their parents first. The bone to a joint turns with its parent.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct FlgModelView
    {
        public uint struct_size;
        /// <summary>at least 1</summary>
        public uint joint_count;
        /// <summary>3 a joint, metres</summary>
        public float* joint_positions;
        /// <summary>of the shape around the joint, metres</summary>
        public float* joint_radii;
        /// <summary>FLG_NO_INDEX: a root</summary>
        public uint* joint_parents;
        /// <summary>the part that each lies in</summary>
        public uint* joint_parts;
        /// <summary>of the part, then a number: tail_0, tail_1, ..., arm_0.L, ...</summary>
        public byte** joint_names;
        /// <summary>with mirror images, each after its original</summary>
        public FlgModelPartInfo* parts;
        public uint part_count;
        /// <summary>what thresholds are shares of, metres</summary>
        public float size;
    }

    /// <summary>
    /// A surface in one piece and the joints that move it, in the pose of rest: joints are not turned.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct FlgSkinView
    {
        public uint struct_size;
        public uint vertex_count;
        public uint triangle_count;
        /// <summary>1 to 65535</summary>
        public uint joint_count;
        /// <summary>3 a vertex, metres</summary>
        public float* positions;
        /// <summary>3 a vertex, of length 1</summary>
        public float* normals;
        /// <summary>3 a triangle, counter-clockwise as seen from outside</summary>
        public uint* triangles;
        /// <summary>4 a vertex: what moves it, the largest weight first; unused ones are 0</summary>
        public ushort* vertex_joints;
        /// <summary>4 a vertex: 0 to 1, their sum is 1; unused ones are 0</summary>
        public float* vertex_weights;
        /// <summary>one a vertex: the part it lies on</summary>
        public uint* vertex_parts;
        /// <summary>3 a joint, metres, in the model's space</summary>
        public float* joint_positions;
        /// <summary>one a joint, lower than its own number; FLG_NO_INDEX: a root</summary>
        public uint* joint_parents;
        /// <summary>one a joint, UTF-8, each another; null in input: none</summary>
        public byte** joint_names;
    }

    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct FlgSkinDesc
    {
        public uint struct_size;
        /// <summary>
        /// about so many, within 15 %, if no part is too thin for that: 100 to most_vertices, default 10000
        /// </summary>
        public uint vertex_count;
        public FlgJobOptions job;
        public FlgModel model;
        /// <summary>what thin parts may make of it: 100 to 4194304, default 200000</summary>
        public uint most_vertices;
        /// <summary>
        /// where parts cross the edge is rounded over this length: metres, up to 1e30; below 0: by itself, 0.15 of the
        /// smaller part's radius; 0: not. Default -1
        /// </summary>
        public float blend;
    }

    /// <summary>A motion of a skin's joints.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct FlgSkinAnimation
    {
        public uint struct_size;
        /// <summary>at least 1</summary>
        public uint key_count;
        /// <summary>UTF-8</summary>
        public byte* name;
        /// <summary>one a key, seconds, rising from 0 or later</summary>
        public float* times;
        /// <summary>4 a joint, joint by joint, key by key: x, y, z, w of length 1, within the parent's frame</summary>
        public float* rotations;
        /// <summary>3 a key: how far all roots are moved, metres; null: not at all</summary>
        public float* translations;
    }
}
