// SPDX-License-Identifier: MIT
// Functions of filigree_model.h. Written by tools/abi/generate from sdk/api/abi.json: change the header.
//
// Models of drawn parts (Ma, Wang, Li, Zhang: Real-time skeletonization for sketch-based modeling, 2021). It follows
// the grammar
// of filigree.h.
//
// Part         A contour with its axis, in its own plane: made once a contour is drawn.
// Model        Parts put in their places, and one tree of joints for all. Another place for a part, or another
//              threshold, is another
//              model of the same parts, which takes a tenth of a ms; so a part that is dragged shows its bones in each
//              frame.
// Skin         A model's surface in one piece, bound to its joints.
//
// All three never change once ready, and keep what they were made of alive. Lengths of a drawing are in its own unit; a
// part's
// placement takes them to the model's space, in metres.

using System;
using System.Runtime.InteropServices;

namespace Filigree
{
    public static unsafe partial class Native
    {
        [DllImport(Library.Filigree, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgOutlineDescInit(FlgOutlineDesc* desc, uint struct_size);

        /// <summary>
        /// Starts a job that finds what a surface, or regions of it, covers when it is looked at from afar: its
        /// silhouette, or the border of a flat region; of several pieces the largest, with its holes. Fails if there
        /// are no such triangles or nothing is seen, and without a direction if all sides are alike, as those of a
        /// closed surface. Cost: 40 ns a triangle and 3 us a side of the borders.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgOutlineCreate(
            FlgContext context, FlgOutlineDesc* desc, FlgOutline* out_outline, FlgJob* out_job);

        [DllImport(Library.Filigree, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgOutlineViewInit(FlgOutlineView* view, uint struct_size);

        /// <summary>
        /// The arrays live until the outline is released. FlgResult.NotReady before its job is published, its error if
        /// it failed.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgOutlineGetView(
            FlgContext context, FlgOutline outline, FlgOutlineView* out_view);

        [DllImport(Library.Filigree, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgOutlineRelease(FlgContext context, FlgOutline outline);

        [DllImport(Library.Filigree, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgPartDescInit(FlgPartDesc* desc, uint struct_size);

        /// <summary>
        /// Starts a job that finds the axis of a contour, sec. 3.1 of the paper: points at equal distances, those of
        /// them that matter (the outline), its straight skeleton without what ends on the outline and without short
        /// arcs, its branches as smooth curves, and slices across them. Where the outline would cross itself the
        /// tolerance is made smaller, down to the line as it is drawn. What is wrong with a contour is said as by
        /// flgStraightSkeletonCreate; crossings much smaller than the spacing may be smoothed away. Around a hole the
        /// axis goes on one side only: bones can't go in circles. Cost: 0.1 to 0.3 ms for a drawn contour.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgPartCreate(
            FlgContext context, FlgPartDesc* desc, FlgPart* out_part, FlgJob* out_job);

        [DllImport(Library.Filigree, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgPartViewInit(FlgPartView* view, uint struct_size);

        /// <summary>
        /// The arrays live until the part is released. FlgResult.NotReady before its job is published, its error if it
        /// failed.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgPartGetView(FlgContext context, FlgPart part, FlgPartView* out_view);

        [DllImport(Library.Filigree, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgPartRelease(FlgContext context, FlgPart part);

        [DllImport(Library.Filigree, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgPartMeshDescInit(FlgPartMeshDesc* desc, uint struct_size);

        /// <summary>
        /// Starts a job that inflates a part, sec. 4.1: a triangulation of the contour with points inside, the height
        /// over it by a Poisson equation, and both of its sides. The surface is closed and a manifold, around holes
        /// too. Cost: 3 ms for 700 vertices.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgPartMeshCreate(
            FlgContext context, FlgPartMeshDesc* desc, FlgPartMesh* out_mesh, FlgJob* out_job);

        [DllImport(Library.Filigree, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgPartMeshViewInit(FlgPartMeshView* view, uint struct_size);

        /// <summary>
        /// The arrays live until the mesh is released. FlgResult.NotReady before its job is published, its error if it
        /// failed.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgPartMeshGetView(
            FlgContext context, FlgPartMesh mesh, FlgPartMeshView* out_view);

        [DllImport(Library.Filigree, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgPartMeshRelease(FlgContext context, FlgPartMesh mesh);

        [DllImport(Library.Filigree, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgModelPartInit(FlgModelPart* part);

        [DllImport(Library.Filigree, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgModelDescInit(FlgModelDesc* desc, uint struct_size);

        /// <summary>
        /// Starts a job that makes one skeleton of the parts', sec. 3.1 (BoundedDP), 3.2 and 3.3 of the paper: joints
        /// along the branches, parts connected, junctions merged, short branches and bones removed. A part that meets
        /// no earlier one is a root of its own. FlgResult.ErrorLimit with more than 65535 joints. Cost: about 12 us a
        /// part.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgModelCreate(
            FlgContext context, FlgModelDesc* desc, FlgModel* out_model, FlgJob* out_job);

        [DllImport(Library.Filigree, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgModelViewInit(FlgModelView* view, uint struct_size);

        /// <summary>
        /// The arrays live until the model is released. FlgResult.NotReady before its job is published, its error if it
        /// failed.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgModelGetView(FlgContext context, FlgModel model, FlgModelView* out_view);

        [DllImport(Library.Filigree, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgModelRelease(FlgContext context, FlgModel model);

        [DllImport(Library.Filigree, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgSkinDescInit(FlgSkinDesc* desc, uint struct_size);

        /// <summary>
        /// Starts a job that makes one closed surface of all parts of a model, a manifold however they meet, and binds
        /// it to the joints: weights are smooth, 0 to 1, at most 4 a vertex, and a part moves with its own bones. Parts
        /// that meet no other stay pieces of their own. FlgResult.ErrorLimit if the thinnest part would need more than
        /// most_vertices, or if a part lies further from the origin than 1e7 sides of the triangles that vertex_count
        /// asks for. Cost: 15 us a vertex.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgSkinCreate(
            FlgContext context, FlgSkinDesc* desc, FlgSkin* out_skin, FlgJob* out_job);

        /// <summary>
        /// The arrays live until the skin is released. FlgResult.NotReady before its job is published, its error if it
        /// failed.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgSkinGetView(FlgContext context, FlgSkin skin, FlgSkinView* out_view);

        [DllImport(Library.Filigree, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgSkinRelease(FlgContext context, FlgSkin skin);

        [DllImport(Library.Filigree, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgSkinViewInit(FlgSkinView* view, uint struct_size);

        [DllImport(Library.Filigree, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgSkinAnimationInit(FlgSkinAnimation* animation, uint struct_size);

        /// <summary>
        /// Where a pose takes each joint, from rest.
        ///   rotations             4 a joint: x, y, z, w of length 1 within 0.001, within the parent's frame, as in
        ///   FlgSkinAnimation;
        ///                         null: none is turned
        ///   translation           3: how far all roots are moved, metres; null: not at all
        ///   out_matrices          12 a joint, or null: three rows of four. (x, y, z, 1) at rest times the rows is the
        ///   place in the pose
        ///   out_dual_quaternions  8 a joint, or null: x, y, z, w of the rotation r, then those of (t r) / 2, where t
        ///   moves after it
        /// Reads the skin's joints alone. Cost: about 50 ns a joint; takes no memory for up to 256 joints, else 56
        /// bytes a joint of the C++ runtime's.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgSkinPose(
            FlgSkinView* skin, float* rotations, float* translation, float* out_matrices, float* out_dual_quaternions);

        /// <summary>
        /// The pose of an animation at a time, ready for flgSkinPose: between keys rotations turn evenly the short way,
        /// translations go straight; before the first key and after the last they stay.
        ///   joint_count      the skin's
        ///   time             seconds, finite
        ///   out_rotations    4 a joint
        ///   out_translation  3, or null; 0 if the animation moves no roots
        /// Cost: about 80 ns a joint, 1 ns a key: all times are checked, and of the rest the two keys that are used.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgSkinAnimationSample(
            FlgSkinAnimation* animation, uint joint_count, float time, float* out_rotations, float* out_translation);

        /// <summary>
        /// Moves the vertices by the processor: what the graphics card's shader must come to.
        ///   transforms     what flgSkinPose made: 12 a joint (FlgSkinning.Linear) or 8 (FlgSkinning.DualQuaternion)
        ///   out_positions  3 a vertex
        ///   out_normals    3 a vertex, of length 1, turned as their vertices are; null: not wanted
        /// Dual quaternions that mean the same with another sign are told by the joint with a vertex' largest weight.
        /// Weights must come to 1 within 0.0001, the first being the largest. Cost: about 0.1 us a vertex, one pass to
        /// check and one to move.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
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

        public static FlgModelPart flgModelPartDefaults()
        {
            FlgModelPart made;
            flgModelPartInit(&made);
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
