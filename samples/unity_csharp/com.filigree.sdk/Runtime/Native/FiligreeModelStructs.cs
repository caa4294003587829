// SPDX-License-Identifier: MIT
// Structs of filigree_model.h. Written by tools/abi/generate from sdk/api/abi.json: change the header.

using System;

namespace Filigree
{
    public unsafe partial struct FlgOutlineDesc
    {
        public uint struct_size;
        public uint region_count;
        public FlgJobOptions* job;
        public FlgSurface surface;
        /// <summary>labels of the surface; null: the whole surface. Copied</summary>
        public uint* regions;
        /// <summary>
        /// towards the viewer, of any length; 0 0 0: the average normal of the triangles, which suits flat regions.
        /// Default 0 0 0
        /// </summary>
        public fixed float direction[3];
        public uint reserved;
    }

    /// <summary>Ready to become a part: `contour` for FlgPartDesc, `placement` for FlgModelPart.</summary>
    public unsafe partial struct FlgOutlineView
    {
        public uint struct_size;
        public uint reserved;
        /// <summary>metres, in the plane through the middle of the triangles; y points up as far as possible</summary>
        public FlgContourView* contour;
        /// <summary>maps the contour back to the surface</summary>
        public fixed double placement[12];
        /// <summary>metres: what the placement's positions are relative to: the surface's origin</summary>
        public fixed double origin[3];
    }

    /// <summary>
    /// Fractions are of the part's length: the drawn length of the contour's ring 0, but at most three times its box
    /// diagonal (a frayed line does not make a larger drawing).
    /// </summary>
    public unsafe partial struct FlgPartDesc
    {
        public uint struct_size;
        /// <summary>nonzero: the contour may cross and touch itself, see FlgStraightSkeletonDesc. Default 0</summary>
        public uint repair;
        public FlgJobOptions* job;
        /// <summary>copied</summary>
        public FlgContourView* contour;
        /// <summary>
        /// distance between resampled points of the drawn line, a fraction: 0.0005 to 0.1, default 0.005; 0: as drawn
        /// </summary>
        public double spacing;
        /// <summary>how far the axis' outline may deviate from the line, a fraction: 0 to 0.1, default 0.0015</summary>
        public double tolerance;
        /// <summary>removes axis arcs shorter than this fraction of their mean length: 0 to 10, default 0.5</summary>
        public double collapse;
    }

    /// <summary>A point on a branch's axis, with the slice across it.</summary>
    public unsafe partial struct FlgAxisSample
    {
        /// <summary>on the axis</summary>
        public double x;
        /// <summary>on the axis</summary>
        public double y;
        /// <summary>unit vector to the left of the axis</summary>
        public double left_x;
        /// <summary>unit vector to the left of the axis</summary>
        public double left_y;
        /// <summary>extent of the slice to either side: to the outline, or to twice the axis' clearance</summary>
        public double left;
        /// <summary>extent of the slice to either side: to the outline, or to twice the axis' clearance</summary>
        public double right;
    }

    public unsafe partial struct FlgPartView
    {
        public uint struct_size;
        /// <summary>points</summary>
        public uint outline_count;
        /// <summary>2 per point</summary>
        public double* outline;
        /// <summary>ring_count + 1 values: the start of each ring, then outline_count</summary>
        public uint* outline_rings;
        public uint ring_count;
        /// <summary>of the axis; at least 1</summary>
        public uint node_count;
        /// <summary>3 per node: x, y, and the radius of a disc around it inside the outline</summary>
        public double* nodes;
        /// <summary>2 per arc: nodes; node_count - 1 arcs</summary>
        public uint* arcs;
        /// <summary>of all branches, consecutively</summary>
        public FlgAxisSample* samples;
        /// <summary>4 per branch: its first and last node; its first sample, and one past its last</summary>
        public uint* branches;
        public uint sample_count;
        /// <summary>0 if the axis is one node</summary>
        public uint branch_count;
        /// <summary>the length that fractions refer to</summary>
        public double length;
    }

    public unsafe partial struct FlgPartMeshDesc
    {
        public uint struct_size;
        /// <summary>
        /// 0.01 to 100, default 1: a disc becomes a ball, a long strip a tube 1.4 times as deep as wide
        /// </summary>
        public float thickness;
        public FlgJobOptions* job;
        public FlgPart part;
        /// <summary>
        /// edge length, in units of the drawing, 1e-4 to 1 of the part's length; 0: automatic, for 500 to 3,000
        /// vertices. Default 0
        /// </summary>
        public double spacing;
    }

    public unsafe partial struct FlgPartMeshView
    {
        public uint struct_size;
        public uint vertex_count;
        public uint triangle_count;
        public uint reserved;
        /// <summary>3 per vertex, units of the drawing; z is the height above its plane</summary>
        public float* positions;
        /// <summary>3 per triangle, counter-clockwise seen from outside</summary>
        public uint* triangles;
    }

    /// <summary>
    /// Resolution of the bones. The four are fractions of the model's size, the largest length among its placed parts:
    /// 0 to 10 each. The defaults give a person some 20 joints. The paper's are 0.0025, 0.015, 0.015 and 0.005, with
    /// detail 0.
    /// </summary>
    public unsafe partial struct FlgBoneThresholds
    {
        public uint struct_size;
        /// <summary>how far joints along a branch may deviate from axis and shape; default 0.01</summary>
        public float simplify;
        /// <summary>merges junctions closer than this along the bones; default 0.03</summary>
        public float merge;
        /// <summary>removes shorter branches that lead to an end; default 0.03</summary>
        public float prune;
        /// <summary>removes bones shorter than this with bones at both ends; default 0.01</summary>
        public float collapse;
        /// <summary>
        /// one number for all: divides the four, and gives limbs more joints the longer they are for their width, in
        /// equal limbs the same number: 2 is finer, 0.5 coarser. 0.05 to 20; 0: the four alone, as they are. Default 1
        /// </summary>
        public float detail;
    }

    /// <summary>A part, its place in a model, and its refinement there.</summary>
    public unsafe partial struct FlgModelPart
    {
        /// <summary>the same of all parts of a model</summary>
        public uint struct_size;
        /// <summary>the part's count, if branch_simplify is given</summary>
        public uint branch_count;
        /// <summary>may be used more than once; its job may still run</summary>
        public FlgPart part;
        /// <summary>UTF-8, 1 to 63 bytes, unique; null: "part" and its number</summary>
        public byte* name;
        /// <summary>
        /// rows of a 3 x 4 matrix that maps (x, y, 0, 1) to the model's space: rotation, uniform scale, translation,
        /// optional mirroring. Default: as drawn
        /// </summary>
        public fixed double placement[12];
        /// <summary>
        /// depth of the part relative to the paper's inflation: 0.01 to 100, default 1; a disc becomes a ball
        /// </summary>
        public float thickness;
        /// <summary>
        /// nonzero: adds a copy mirrored at desc.mirror; names end with .L and .R, .L on the side of the plane's
        /// normal. Default 0
        /// </summary>
        public uint mirrored;
        /// <summary>null: the model's</summary>
        public FlgBoneThresholds* thresholds;
        /// <summary>one per branch of the part; negative: the part's value; null: the part's value for all</summary>
        public float* branch_simplify;
        /// <summary>
        /// index in desc.parts of the part it attaches to, wherever both are; its own index: none; FLG_NO_INDEX: found.
        /// Default FLG_NO_INDEX
        /// </summary>
        public uint parent;
        /// <summary>
        /// Which of two parts passes in front where their skins would cut through each other: that of greater depth,
        /// else the one whose plane is farther in front, else the one drawn later. Front is where the trunk's plane
        /// faces; in a mirror image across it, the back. The skin moves limbs out of their planes, rising from where
        /// they hang, by no more than that takes. Finite, default 0.
        /// </summary>
        public float depth;
        /// <summary>
        /// key of the parent's joint that it attaches to; null, or not there: the nearest place. Default null
        /// </summary>
        public byte* parent_joint;
        /// <summary>
        /// The rectangle of its drawing that a picture covers: left, bottom, right, top, units of the contour. It gives
        /// the skin texture coordinates: the part is projected along the plane of its drawing, front and back alike,
        /// and a mirror image shows the mirrored picture. Right above left and top above bottom, or all 0: none.
        /// Default 0
        /// </summary>
        public fixed double picture[4];
    }

    /// <summary>
    /// Joints are told by their keys (FlgModelView::joint_keys), which survive edits of the drawing: pass the same list
    /// with every model. A key without its .L or .R means both. Edits of joints that are not there wait until they are.
    /// </summary>
    public unsafe partial struct FlgJointEdit
    {
        /// <summary>the same of all edits of a model</summary>
        public uint struct_size;
        /// <summary>default FlgJointEditKind.Pin</summary>
        public FlgJointEditKind kind;
        /// <summary>its key</summary>
        public byte* joint;
        /// <summary>for SPLIT and RENAME: UTF-8, 1 to 127 bytes, unique in the model; default null</summary>
        public byte* name;
        /// <summary>
        /// for PIN: in the drawing of the joint's part, z at right angles to it; inside of the part. Default 0
        /// </summary>
        public fixed double at[3];
        /// <summary>for SPLIT: 0 at the parent, 1 at the joint, exclusive; default 0.5</summary>
        public double share;
    }

    /// <summary>
    /// Joints, parents first. The bone to a joint turns with its parent. Parts include mirror images, each after its
    /// original.
    /// </summary>
    public unsafe partial struct FlgModelView
    {
        public uint struct_size;
        /// <summary>at least 1</summary>
        public uint joint_count;
        /// <summary>3 per joint, metres</summary>
        public float* joint_positions;
        /// <summary>radius of the shape around the joint, metres</summary>
        public float* joint_radii;
        /// <summary>FLG_NO_INDEX: a root</summary>
        public uint* joint_parents;
        /// <summary>the part each joint lies in</summary>
        public uint* joint_parts;
        /// <summary>the joint's key, unless it was renamed</summary>
        public byte** joint_names;
        public uint part_count;
        /// <summary>the size that thresholds are fractions of, metres</summary>
        public float size;
        /// <summary>one per part: how it was connected, before refinement of bones</summary>
        public FlgPartEvent* part_events;
        /// <summary>one per part: its parent part; FLG_NO_INDEX: none</summary>
        public uint* part_parents;
        /// <summary>
        /// one per part: its own joint nearest to the root, which swings it; if it has none left, the joint that moves
        /// it
        /// </summary>
        public uint* part_joints;
        /// <summary>one per part: index of the host's part</summary>
        public uint* part_sources;
        /// <summary>one per part: its mirror image; FLG_NO_INDEX: none</summary>
        public uint* part_twins;
        /// <summary>one per part: 1 for a mirror image, 0 for a drawn part</summary>
        public byte* part_mirrored;
        /// <summary>metres: what positions are relative to</summary>
        public fixed double origin[3];
        /// <summary>
        /// what edits know a joint by: the part's name, then a number: tail_0, tail_1, ..., arm_0.L, ...; where a part
        /// attaches: torso_at_arm; the middle of a trunk: torso_root
        /// </summary>
        public byte** joint_keys;
        /// <summary>3 per joint: where it is in the drawing of its part, as FlgJointEdit::at</summary>
        public double* joint_places;
        /// <summary>one per joint: 1 if an edit pins it</summary>
        public byte* joint_pinned;
    }

    public unsafe partial struct FlgModelDesc
    {
        public uint struct_size;
        /// <summary>1 to 4096</summary>
        public uint part_count;
        public FlgJobOptions* job;
        /// <summary>
        /// in modelling order: the trunk comes first wherever it is, then a part attaches to an earlier one
        /// </summary>
        public FlgModelPart* parts;
        /// <summary>null: the defaults</summary>
        public FlgBoneThresholds* thresholds;
        /// <summary>
        /// weight of the shape in `simplify`, alpha_s of Eq. 1 (the paper gives no number): 0 to 100, default 0.25
        /// </summary>
        public float shape_weight;
        /// <summary>
        /// A plane a x + b y + c z = d. Its normal may have any length above 0 and points to the model's left (0 0 -1
        /// for a model that looks along +x, y up). A part across the plane is doubled in place. Default 1 0 0 0
        /// </summary>
        public fixed float mirror[4];
        /// <summary>up to 65535. Default 0</summary>
        public uint apart_pair_count;
        /// <summary>metres: what placements and `mirror` are relative to. Default 0</summary>
        public fixed double origin[3];
        /// <summary>
        /// the trunk, an index of parts: the hierarchy begins there. FLG_NO_INDEX: the part of the largest area that is
        /// not mirrored. Default FLG_NO_INDEX
        /// </summary>
        public uint root;
        /// <summary>up to 65535. Default 0</summary>
        public uint joint_edit_count;
        /// <summary>key of the root part's joint; null, or not there: its middle. Default null</summary>
        public byte* root_joint;
        /// <summary>applied in order; copied. Default null</summary>
        public FlgJointEdit* joint_edits;
        /// <summary>
        /// what this model was before its parts changed: joints keep the keys they have in it, by part and place. Its
        /// job may still run. Default null: keys are new
        /// </summary>
        public FlgModel previous;
        /// <summary>
        /// 2 per pair: indices of parts that a skin does not weld where they touch, images included; twice the same: a
        /// part and its mirror image. A part and what it hangs on are joined there all the same. Copied. Default null
        /// </summary>
        public uint* apart_pairs;
        /// <summary>
        /// in place of `previous`, what a file kept of that model: joint_count, joint_keys, joint_places and
        /// joint_parents; the rest is not read. Copied, 0.1 us a joint. Default null
        /// </summary>
        public FlgModelView* previous_view;
    }

    /// <summary>A surface in one piece and the joints that move it, in the rest pose: no joint is rotated.</summary>
    public unsafe partial struct FlgSkinView
    {
        public uint struct_size;
        public uint vertex_count;
        public uint triangle_count;
        /// <summary>1 to 65535</summary>
        public uint joint_count;
        /// <summary>3 per vertex, metres</summary>
        public float* positions;
        /// <summary>3 per vertex, of length 1</summary>
        public float* normals;
        /// <summary>3 per triangle, counter-clockwise seen from outside</summary>
        public uint* triangles;
        /// <summary>4 per vertex: joints that move it, largest weight first; unused ones are 0</summary>
        public ushort* vertex_joints;
        /// <summary>4 per vertex: 0 to 1, with sum 1; unused ones are 0</summary>
        public float* vertex_weights;
        /// <summary>one per vertex: the part it lies on</summary>
        public uint* vertex_parts;
        /// <summary>
        /// 3 per joint, metres, in the model's space: the model's, moved with limbs that pass in front of others or
        /// behind (FlgModelPart::depth)
        /// </summary>
        public float* joint_positions;
        /// <summary>one per joint, lower than its own index; FLG_NO_INDEX: a root</summary>
        public uint* joint_parents;
        /// <summary>one per joint, UTF-8, unique; null in input: none</summary>
        public byte** joint_names;
        /// <summary>metres: what positions are relative to. Default 0</summary>
        public fixed double origin[3];
        /// <summary>one per joint: radius of the shape around it, metres; null in input: not known</summary>
        public float* joint_radii;
        /// <summary>
        /// a x + b y + c z = d: the plane of its mirror image, whose normal points to its left; 0: none. Ignored in
        /// input
        /// </summary>
        public fixed float mirror[4];
        /// <summary>
        /// one per triangle: the part it lies on. These meet at edges that follow the parts' border. Null in input:
        /// that of two corners, else of the first
        /// </summary>
        public uint* triangle_parts;
        /// <summary>
        /// 6 per triangle: u, v of its corners, 0 0 at the picture's upper left, 1 1 at its lower right; parts without
        /// a picture: 0. Corners of a vertex differ only where parts with different projections meet. Null: no part has
        /// a picture
        /// </summary>
        public float* corner_uvs;
    }

    public unsafe partial struct FlgSkinDesc
    {
        public uint struct_size;
        /// <summary>within 2 %, or more if a part is too thin for so few: 100 to max_vertices, default 10000</summary>
        public uint vertex_count;
        public FlgJobOptions* job;
        public FlgModel model;
        /// <summary>
        /// upper limit where thin parts need more, without borders between parts: 100 to 4194304, default 200000
        /// </summary>
        public uint max_vertices;
        /// <summary>
        /// rounds edges where parts cross over this length: metres, up to 1e30; below 0: automatic, 0.15 of the smaller
        /// part's radius; 0: none. Default -1
        /// </summary>
        public float blend;
        /// <summary>
        /// corners of contours that turn by more than this, within 1.5 edges of the surface, stay corners: radians, 0
        /// to pi; 0: all are rounded to about an edge's length. Default 0
        /// </summary>
        public float corner_angle;
        public uint reserved;
    }

    public unsafe partial struct FlgSkinFromMeshDesc
    {
        public uint struct_size;
        /// <summary>
        /// of the lattice that the inside is looked at in: 1000 to 16777216, default 600000. Limbs of less than two
        /// cells get no bones of their own
        /// </summary>
        public uint cell_count;
        public FlgJobOptions* job;
        /// <summary>up to 1048576 vertices; copied. Columns other than position and normal are not read</summary>
        public FlgMeshView* mesh;
        /// <summary>metres: nearer vertices move alike; below 0: none do. Default 0: those at one place</summary>
        public float weld_distance;
        /// <summary>of any length above 0. Default 0 1 0</summary>
        public fixed float up[3];
        /// <summary>
        /// to the model's left, if it is its own mirror image. 0 0 0: found; the model looks where its head is if it
        /// stands on four legs, else where its feet point. Default 0 0 0
        /// </summary>
        public fixed float left[3];
        public uint reserved;
        /// <summary>shares of three times the mesh's diagonal; null: the defaults</summary>
        public FlgBoneThresholds* thresholds;
    }

    public unsafe partial struct FlgSkinSimplifyDesc
    {
        public uint struct_size;
        /// <summary>at least 4. No default</summary>
        public uint vertex_count;
        public FlgJobOptions* job;
        public FlgSkin skin;
    }

    public unsafe partial struct FlgSkinSetWeightsDesc
    {
        public uint struct_size;
        /// <summary>the skin's, as in FlgSkinView. No default</summary>
        public uint vertex_count;
        public FlgJobOptions* job;
        /// <summary>its job may still run</summary>
        public FlgSkin skin;
        /// <summary>4 per vertex, below the skin's joint_count; those of weight 0 are not read. Copied</summary>
        public ushort* vertex_joints;
        /// <summary>4 per vertex, in any order: 0 to 1, with sum 1 within 0.001. Copied</summary>
        public float* vertex_weights;
    }

    /// <summary>A motion of a skin's joints.</summary>
    public unsafe partial struct FlgSkinAnimation
    {
        public uint struct_size;
        /// <summary>at least 1</summary>
        public uint key_count;
        /// <summary>UTF-8</summary>
        public byte* name;
        /// <summary>one per key, seconds, ascending, from 0 or later</summary>
        public float* times;
        /// <summary>4 per joint, joint by joint, key by key: x, y, z, w of length 1, in the parent's frame</summary>
        public float* rotations;
        /// <summary>3 per key: translation of all roots, metres; null: none</summary>
        public float* translations;
    }
}
