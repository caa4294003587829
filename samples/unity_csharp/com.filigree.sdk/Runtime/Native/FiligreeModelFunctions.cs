// SPDX-License-Identifier: MIT
// Functions of filigree_model.h. Written by tools/abi/generate from sdk/api/abi.json: change the header.
//
// Models made from drawn parts (Ma, Wang, Li, Zhang: Real-time skeletonization for sketch-based modeling, 2021).
// Follows the grammar of filigree.h.
//
// Part         A contour with its axis, in its own plane. Made once, when the contour is drawn.
// Model        Parts in their places, with one tree of joints. Moving a part or changing a threshold makes a new model
//              from the same parts in a tenth of a ms, so a dragged part can show its bones in every frame.
// Skin         A model's surface in one piece, bound to its joints.
//
// All three never change once ready, and keep their inputs alive. Lengths in a drawing are in its own unit; a part's
// placement maps them to the model's space, in metres.

using System;
using System.Runtime.InteropServices;
using static System.Runtime.InteropServices.CallingConvention;

namespace Filigree
{
    public static unsafe partial class Native
    {
        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgOutlineDescInit(FlgOutlineDesc* desc, uint struct_size);

        /// <summary>
        /// Starts a job that finds the silhouette of a surface or its regions from afar, or the border of a flat
        /// region; of several pieces the largest, with its holes. Fails if there are no such triangles or nothing is
        /// visible. Without a direction it also fails if the normals cancel out, as on a closed surface. Cost: 40 ns a
        /// triangle and 3 us a side of the borders.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgOutlineCreate(
            FlgContext context, FlgOutlineDesc* desc, FlgOutline* out_outline, FlgJob* out_job);

        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgOutlineViewInit(FlgOutlineView* view, uint struct_size);

        /// <summary>
        /// The arrays live until the outline is released. FlgResult.NotReady until its job is published, the job's
        /// error if it failed.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgOutlineGetView(
            FlgContext context, FlgOutline outline, FlgOutlineView* out_view);

        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgOutlineRelease(FlgContext context, FlgOutline outline);

        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgPartDescInit(FlgPartDesc* desc, uint struct_size);

        /// <summary>
        /// Starts a job that finds the axis of a contour, sec. 3.1 of the paper. It resamples the contour at equal
        /// distances, keeps the points that matter (the outline), and makes their straight skeleton. It drops arcs that
        /// end on the outline and short arcs, then fits smooth curves to the branches and cuts slices across them.
        /// Where the outline would cross itself, the job reduces the tolerance, down to the line as drawn. Reports
        /// invalid contours as flgStraightSkeletonCreate does; it may smooth away crossings much smaller than the
        /// spacing. Around a hole the axis passes on one side only: bones cannot form cycles. Cost: 0.1 to 0.3 ms for a
        /// drawn contour.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgPartCreate(
            FlgContext context, FlgPartDesc* desc, FlgPart* out_part, FlgJob* out_job);

        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgPartViewInit(FlgPartView* view, uint struct_size);

        /// <summary>
        /// The arrays live until the part is released. FlgResult.NotReady until its job is published, the job's error
        /// if it failed.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgPartGetView(FlgContext context, FlgPart part, FlgPartView* out_view);

        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgPartRelease(FlgContext context, FlgPart part);

        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgPartMeshDescInit(FlgPartMeshDesc* desc, uint struct_size);

        /// <summary>
        /// Starts a job that inflates a part, sec. 4.1: it triangulates the contour with interior points, solves a
        /// Poisson equation for the height, and joins both sides. The surface is closed and manifold, also around
        /// holes. Cost: 3 ms for 700 vertices.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgPartMeshCreate(
            FlgContext context, FlgPartMeshDesc* desc, FlgPartMesh* out_mesh, FlgJob* out_job);

        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgPartMeshViewInit(FlgPartMeshView* view, uint struct_size);

        /// <summary>
        /// The arrays live until the mesh is released. FlgResult.NotReady until its job is published, the job's error
        /// if it failed.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgPartMeshGetView(
            FlgContext context, FlgPartMesh mesh, FlgPartMeshView* out_view);

        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgPartMeshRelease(FlgContext context, FlgPartMesh mesh);

        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgBoneThresholdsInit(FlgBoneThresholds* thresholds, uint struct_size);

        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgJointEditInit(FlgJointEdit* edit, uint struct_size);

        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgModelPartInit(FlgModelPart* part, uint struct_size);

        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgModelDescInit(FlgModelDesc* desc, uint struct_size);

        /// <summary>
        /// Starts a job that makes one skeleton from the parts, sec. 3.1 (BoundedDP), 3.2 and 3.3 of the paper: it
        /// places joints along the branches, connects parts, merges junctions, and removes short branches and bones.
        /// The hierarchy begins in the middle of the trunk; a part that meets no other is another root. Joints of one
        /// contour that is its own mirror image are mirror images too. The job fails if an edit pins a joint outside of
        /// its part, merges a root or gives two joints one name; the model before it stays as it was.
        /// FlgResult.ErrorLimit above 65535 joints. Cost: 20 us a part.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgModelCreate(
            FlgContext context, FlgModelDesc* desc, FlgModel* out_model, FlgJob* out_job);

        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgModelViewInit(FlgModelView* view, uint struct_size);

        /// <summary>
        /// The arrays live until the model is released. FlgResult.NotReady until its job is published, the job's error
        /// if it failed.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgModelGetView(FlgContext context, FlgModel model, FlgModelView* out_view);

        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgModelRelease(FlgContext context, FlgModel model);

        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgSkinDescInit(FlgSkinDesc* desc, uint struct_size);

        /// <summary>
        /// Starts a job that makes one closed surface from all parts of a model, manifold however they meet, and binds
        /// it to the joints: weights are smooth, 0 to 1, at most 4 per vertex. Limbs that cross other parts pass in
        /// front or behind (FlgModelPart::depth). Parts that meet no other stay separate pieces. FlgResult.ErrorLimit
        /// if the thinnest part needs more than max_vertices, or if a part lies further from the origin than 1e7 sides
        /// of a triangle. Cost: 20 us a vertex.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgSkinCreate(
            FlgContext context, FlgSkinDesc* desc, FlgSkin* out_skin, FlgJob* out_job);

        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgSkinFromMeshDescInit(FlgSkinFromMeshDesc* desc, uint struct_size);

        /// <summary>
        /// Starts a job that gives a mesh joints and weights. The skin has the mesh's own vertices and triangles in
        /// their order, so all that belongs to them (texture coordinates, colours, morph targets) still fits; its
        /// normals are the mesh's, or found if it has none. The mesh should be closed: past holes what is inside is
        /// guessed, and what is thinner than a cell counts as inside. Pieces that do not touch hang on the nearest one.
        /// The hierarchy begins in the middle of the trunk. Limbs that stand out get bones; sheets and bulges don't. A
        /// mesh that is its own mirror image within 3 % gets joints that are mirror images too. Joints have names as
        /// drawn ones: body_0, head_0, arm_1.L; flgRigFind takes them with `joint_radii` and `mirror`. The lattice
        /// turns with the mesh. Fails for meshes without triangles. FlgResult.ErrorLimit above 65535 joints. Cost: 0.25
        /// s, and 15 us a vertex.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgSkinCreateFromMesh(
            FlgContext context, FlgSkinFromMeshDesc* desc, FlgSkin* out_skin, FlgJob* out_job);

        /// <summary>
        /// The arrays live until the skin is released. FlgResult.NotReady until its job is published, the job's error
        /// if it failed.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgSkinGetView(FlgContext context, FlgSkin skin, FlgSkinView* out_view);

        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgSkinRelease(FlgContext context, FlgSkin skin);

        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgSkinSimplifyDescInit(FlgSkinSimplifyDesc* desc, uint struct_size);

        /// <summary>
        /// Starts a job that makes a level of detail: the same surface, parts and joints with fewer vertices. Edges are
        /// collapsed, those first that change the shape least; where weights change more stay. Borders of parts and
        /// sharp corners stay where they are, pieces and holes remain, and a vertex has the weights of its place on the
        /// surface. So few vertices may not be reachable: then the result has the fewest that are. With as many as the
        /// skin has, or more, it is a copy. Cost: about 2 us a vertex of the skin and 20 us for each that goes.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgSkinSimplify(
            FlgContext context, FlgSkinSimplifyDesc* desc, FlgSkin* out_skin, FlgJob* out_job);

        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgSkinSetWeightsDescInit(FlgSkinSetWeightsDesc* desc, uint struct_size);

        /// <summary>
        /// Starts a job that makes the same skin with other weights, as painted ones: all else is the source's, which
        /// stays as it is. Weights get the sum 1 and the largest first; a joint that a vertex has twice gets both
        /// weights. Weights out of range are refused at once; another vertex_count than the skin's, or a joint that it
        /// does not have, makes the job fail with FlgResult.ErrorInvalidArgument. Cost: 20 ns a vertex in the call, 0.1
        /// us in the job.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgSkinSetWeights(
            FlgContext context, FlgSkinSetWeightsDesc* desc, FlgSkin* out_skin, FlgJob* out_job);

        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgSkinViewInit(FlgSkinView* view, uint struct_size);

        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgSkinAnimationInit(FlgSkinAnimation* animation, uint struct_size);

        /// <summary>
        /// The transform of each joint from rest to a pose.
        ///   rotations             4 per joint: x, y, z, w of length 1 within 0.001, in the parent's frame, as in
        ///                         FlgSkinAnimation; null: no rotations
        ///   translation           3: translation of all roots, metres; null: none
        ///   out_matrices          12 per joint, or null: three rows of four. The rows times (x, y, z, 1) at rest give
        ///   the
        ///                         position in the pose
        ///   out_dual_quaternions  8 per joint, or null: x, y, z, w of the rotation r, then those of (t r) / 2, where t
        ///                         translates after it
        /// Reads only the skin's joints. Cost: about 50 ns a joint; takes no memory for up to 256 joints, else 56 bytes
        /// a joint of the C++ runtime's.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgSkinPose(
            FlgSkinView* skin, float* rotations, float* translation, float* out_matrices, float* out_dual_quaternions);

        /// <summary>
        /// The pose of an animation at a time, ready for flgSkinPose. Between keys rotations turn evenly the shorter
        /// way, and translations are linear. Before the first key and after the last, the pose is constant.
        ///   joint_count      the skin's
        ///   time             seconds, finite
        ///   out_rotations    4 per joint
        ///   out_translation  3, or null; 0 if the animation moves no roots
        /// Cost: about 80 ns a joint, 1 ns a key: all times are checked, and of the rest the two keys that are used.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgSkinAnimationSample(
            FlgSkinAnimation* animation, uint joint_count, float time, float* out_rotations, float* out_translation);

        /// <summary>
        /// Deforms the vertices on the CPU: the reference for a vertex shader.
        ///   transforms     from flgSkinPose: 12 per joint (FlgSkinning.Linear) or 8 (FlgSkinning.DualQuaternion)
        ///   out_positions  3 per vertex
        ///   out_normals    3 per vertex, of length 1, rotated as their vertices are; null: not needed
        /// The joint with a vertex' largest weight decides the sign of equivalent dual quaternions. Weights must sum to
        /// 1 within 0.0001, the largest first. Cost: about 0.1 us a vertex, one pass to check and one to move.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgSkinDeform(
            FlgSkinView* skin, FlgSkinning skinning, float* transforms, float* out_positions, float* out_normals);

        public static FlgSkinView flgSkinViewDefaults()
        {
            FlgSkinView made;
            flgSkinViewInit(&made, (uint)sizeof(FlgSkinView));
            return made;
        }

        public static FlgSkinAnimation flgSkinAnimationDefaults()
        {
            FlgSkinAnimation made;
            flgSkinAnimationInit(&made, (uint)sizeof(FlgSkinAnimation));
            return made;
        }

        public static FlgOutlineDesc flgOutlineDefaults()
        {
            FlgOutlineDesc made;
            flgOutlineDescInit(&made, (uint)sizeof(FlgOutlineDesc));
            return made;
        }

        public static FlgOutlineView flgOutlineViewDefaults()
        {
            FlgOutlineView made;
            flgOutlineViewInit(&made, (uint)sizeof(FlgOutlineView));
            return made;
        }

        public static FlgPartDesc flgPartDefaults()
        {
            FlgPartDesc made;
            flgPartDescInit(&made, (uint)sizeof(FlgPartDesc));
            return made;
        }

        public static FlgPartView flgPartViewDefaults()
        {
            FlgPartView made;
            flgPartViewInit(&made, (uint)sizeof(FlgPartView));
            return made;
        }

        public static FlgPartMeshDesc flgPartMeshDefaults()
        {
            FlgPartMeshDesc made;
            flgPartMeshDescInit(&made, (uint)sizeof(FlgPartMeshDesc));
            return made;
        }

        public static FlgPartMeshView flgPartMeshViewDefaults()
        {
            FlgPartMeshView made;
            flgPartMeshViewInit(&made, (uint)sizeof(FlgPartMeshView));
            return made;
        }

        public static FlgSkinDesc flgSkinDefaults()
        {
            FlgSkinDesc made;
            flgSkinDescInit(&made, (uint)sizeof(FlgSkinDesc));
            return made;
        }

        public static FlgSkinFromMeshDesc flgSkinFromMeshDefaults()
        {
            FlgSkinFromMeshDesc made;
            flgSkinFromMeshDescInit(&made, (uint)sizeof(FlgSkinFromMeshDesc));
            return made;
        }

        public static FlgSkinSimplifyDesc flgSkinSimplifyDefaults()
        {
            FlgSkinSimplifyDesc made;
            flgSkinSimplifyDescInit(&made, (uint)sizeof(FlgSkinSimplifyDesc));
            return made;
        }

        public static FlgSkinSetWeightsDesc flgSkinSetWeightsDefaults()
        {
            FlgSkinSetWeightsDesc made;
            flgSkinSetWeightsDescInit(&made, (uint)sizeof(FlgSkinSetWeightsDesc));
            return made;
        }

        public static FlgModelPart flgModelPartDefaults()
        {
            FlgModelPart made;
            flgModelPartInit(&made, (uint)sizeof(FlgModelPart));
            return made;
        }

        public static FlgBoneThresholds flgBoneThresholdsDefaults()
        {
            FlgBoneThresholds made;
            flgBoneThresholdsInit(&made, (uint)sizeof(FlgBoneThresholds));
            return made;
        }

        public static FlgJointEdit flgJointEditDefaults()
        {
            FlgJointEdit made;
            flgJointEditInit(&made, (uint)sizeof(FlgJointEdit));
            return made;
        }

        public static FlgModelDesc flgModelDefaults()
        {
            FlgModelDesc made;
            flgModelDescInit(&made, (uint)sizeof(FlgModelDesc));
            return made;
        }

        public static FlgModelView flgModelViewDefaults()
        {
            FlgModelView made;
            flgModelViewInit(&made, (uint)sizeof(FlgModelView));
            return made;
        }
    }
}
