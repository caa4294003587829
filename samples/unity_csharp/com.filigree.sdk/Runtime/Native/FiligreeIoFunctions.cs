// SPDX-License-Identifier: MIT
// Functions of filigree_io.h. Written by tools/abi/generate from sdk/api/abi.json: change the header.
//
// Filigree's file formats, in a library of its own (filigree_io) that hosts may leave out. It follows the grammar of
// filigree.h but needs no context: its functions block on the disk, so call them where your engine loads assets.
//
// [any thread] All functions here; calls on one FlgCurveFile, FlgMeshFile or FlgSkinFile must not overlap.
//
// Formats of curves, by extension:
//   .xyz .txt     text: `x y z [radius]` a line, blank line between curves, `# closed` on the line before a closed
//                 one; anything else behind a # is ignored. All points of a curve have a radius or none; where only
//                 some curves do, the others get 0.005 m. A line `# columns x y z NAME ...` before the first point
//                 names
//                 what all lines hold instead, each number by a name of the list below
//   .obj          lines (`l`); read and written. Edges (`l a b`) that chain are joined; colours and radii are lost
//   .gltf .glb    LINES (joined where they chain), LINE_STRIP, LINE_LOOP, with COLOR_0 and _RADIUS, and with NORMAL,
//                 _TIME, _PRESSURE, _STYLE_INDEX, _RADII, _ANGLE, _WIDTH, _SPEED, _DISPLACEMENT and _USERN (1 to 4
//                 floats)
//                 where all curves have them; lengths, speeds and directions go with their nodes. .glb is written, as
//                 lines, ribbons or tubes. No sparse accessors; buffers only embedded or below the file's folder
//   .tilt         VR sketches, a file or a directory, read only; converted to metres and to a right-handed system
//   .svg          shapes' and paths' outlines, read only; y upwards, a metre a px, curves flattened to 1/1000 of their
//   size
// Formats of meshes, by extension; read and written, .gltf only read:
//   .ply          ascii and binary are read, little-endian binary is written. Vertices: positions, colours (0 to 1 if
//                 they are integers), normals and the columns this library writes, by the names below. Faces: the list
//                 vertex_indices, and integer properties, of which `region` is the view's regions; or `tristrips`.
//                 Other elements and properties are passed over
//   .obj          faces (`f`) and positions with colours (`v x y z r g b`). Regions are materials (`usemtl`), numbered
//                 from 0 in the order of first use, and written as such. Texture coordinates and normals are passed
//   over
//   .off          also COFF, NOFF and CNOFF; colours (0 to 255 if one is above 1) but no regions
//   .gltf .glb    TRIANGLES, TRIANGLE_STRIP and TRIANGLE_FAN with COLOR_0, placed by the scene's nodes; regions are
//                 materials, numbered from 0 in the order of first use; their factors are read, textures passed over.
//                 .glb is written. Limits as for curves
// Columns have these names in .ply and .xyz: x y z; nx ny nz; red green blue alpha; radius, time, pressure,
// style_index, angle, width, speed; tangent_0 to _2, orientation_0 to _3, radii_0 to _2, displacement_0 to _2;
// FlgAttribute.User + N: userN, or userN_0, userN_1, ... of several components. Of meshes the other formats hold
// positions, colours (not above 1 in .glb) and, in .glb, normals.

using System;
using System.Runtime.InteropServices;

namespace Filigree
{
    public static unsafe partial class Native
    {
        /// <summary>
        /// [any thread] As flgLastError, for the functions of this header. Sentences start with FILE:PLACE, where PLACE
        /// is a line number, a byte offset (`@1234`), a part of the file's structure or an argument; with FILE alone
        /// when the file as a whole is meant, as when it can't be opened.
        /// </summary>
        [DllImport(Library.Io, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern byte* flgIoLastError();

        /// <summary>
        /// Reads all curves of a file. The file is read whole, checked, and refused at the first thing that can't be
        /// right; what is merely odd becomes a warning (flgCurveFileGetInfo). Limits: 2 GiB a file (unpacked too), 2^31
        /// points. Errors: FlgResult.ErrorFile, FlgResult.ErrorFormat, FlgResult.ErrorLimit. Cost: 0.1 to 0.2 us a
        /// point.
        /// </summary>
        [DllImport(Library.Io, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgCurveFileRead(byte* path, FlgCurveFile* out_file);

        /// <summary>The curves, ready for flgCurveSetCreate; lives until the file is released.</summary>
        [DllImport(Library.Io, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgCurveFileGetView(FlgCurveFile file, FlgCurveSetView* out_view);

        /// <summary>What the file holds, and what is odd about it. Set its struct_size.</summary>
        [DllImport(Library.Io, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgCurveFileGetInfo(FlgCurveFile file, FlgCurveFileInfo* out_info);

        /// <summary>One a curve, for .tilt files; null and 0 for other formats.</summary>
        [DllImport(Library.Io, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgCurveFileGetStrokes(
            FlgCurveFile file, FlgStroke** out_strokes, uint* out_count);

        /// <summary>Null is allowed.</summary>
        [DllImport(Library.Io, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern void flgCurveFileRelease(FlgCurveFile file);

        [DllImport(Library.Io, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgCurveWriteDescInit(FlgCurveWriteDesc* desc, uint struct_size);

        /// <summary>
        /// Writes curves to .xyz, .obj or .glb, whole or not at all: a temporary file beside it is renamed when
        /// complete. `desc` may be null. Curves without NORMAL column get frames by double reflection. Colours go into
        /// .glb, clamped to 0 to 1; a USER column of more than 4 floats has no place there. Lines of one point are
        /// written with their point twice; ribbons and tubes leave out curves without length. Errors:
        /// FlgResult.ErrorInvalidArgument (also for no curves at all), FlgResult.ErrorFormat for another extension,
        /// FlgResult.ErrorFile, FlgResult.ErrorLimit (2 GiB). Cost: .glb 0.1 us a point, text 0.5 to 0.8.
        /// </summary>
        [DllImport(Library.Io, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgCurveFileWrite(byte* path, FlgCurveSetView* view, FlgCurveWriteDesc* desc);

        /// <summary>
        /// Reads the mesh of a file as it is stored: nothing is welded, turned or dropped, but for triangles of strips
        /// and fans that name a vertex twice. Faces of more than three corners are split into triangles: convex ones as
        /// fans from their first corner, others of at most 1024 corners by clipping ears. As flgCurveFileRead it
        /// refuses what can't be right (indices out of range, faces of fewer than three corners, values that aren't
        /// finite, counts the file has no room for, no faces at all) and warns of what is odd. Cost: one core, some 400
        /// MB/s of binary and 250 MB/s of text (2 M triangles: 0.1 s and 0.3 s). Limits: 2 GiB a file, and what is made
        /// of it. Errors: FlgResult.ErrorFile, FlgResult.ErrorFormat, FlgResult.ErrorLimit.
        /// </summary>
        [DllImport(Library.Io, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgMeshFileRead(byte* path, FlgMeshFile* out_file);

        /// <summary>The mesh; lives until the file is released. `regions` is null where the file has none.</summary>
        [DllImport(Library.Io, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgMeshFileGetView(FlgMeshFile file, FlgMeshView* out_view);

        /// <summary>
        /// The integer properties of a .ply file's faces besides `region`, at most the first 16; all triangles of a
        /// face have its values, negative ones 2^32 more. Null and 0 for other formats. Lives until the file is
        /// released.
        /// </summary>
        [DllImport(Library.Io, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgMeshFileGetFaceColumns(
            FlgMeshFile file, FlgMeshFaceColumn** out_columns, uint* out_count);

        /// <summary>
        /// The materials of a .gltf or .glb file, one a region of the view (the only one where that has no regions), if
        /// at least one says a colour; else null and 0. Factors that a material leaves out are glTF's: white, metallic
        /// 1, roughness 1. Lines are read from this library's files: glTF has none. Lives until the file is released.
        /// </summary>
        [DllImport(Library.Io, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgMeshFileGetMaterials(
            FlgMeshFile file, FlgMeshMaterial** out_materials, uint* out_count);

        /// <summary>What the file holds, and what is odd about it. Set its struct_size.</summary>
        [DllImport(Library.Io, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgMeshFileGetInfo(FlgMeshFile file, FlgMeshFileInfo* out_info);

        /// <summary>Null is allowed.</summary>
        [DllImport(Library.Io, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern void flgMeshFileRelease(FlgMeshFile file);

        [DllImport(Library.Io, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgMeshWriteDescInit(FlgMeshWriteDesc* desc, uint struct_size);

        /// <summary>
        /// Writes a mesh to .ply, .obj, .off or .glb, whole or not at all as flgCurveFileWrite. `desc` may be null.
        /// .ply and .glb keep every bit of positions, text has 9 digits. .glb gets normals: the column's, else the
        /// area-weighted ones. Errors: FlgResult.ErrorInvalidArgument (also for no triangles, and for indices out of
        /// range), FlgResult.ErrorFormat for another extension, FlgResult.ErrorFile, FlgResult.ErrorLimit (2 GiB).
        /// Cost: 0.2 to 0.5 us a triangle.
        /// </summary>
        [DllImport(Library.Io, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgMeshFileWrite(byte* path, FlgMeshView* view, FlgMeshWriteDesc* desc);

        /// <summary>
        /// Reads the skinned mesh that a file's scene shows: all nodes with a mesh and the first skin that is met;
        /// other meshes are left out, with a warning. Rest is the pose of the skin's inverseBindMatrices, whatever the
        /// nodes say. Joints that are turned in that pose are read as if they were not: rotations of animations are
        /// changed so that each vertex moves as it did. Keys of all of an animation's channels are brought together.
        /// Joints come parents first; those below nodes that are no joints hang on the nearest joint above. Weights are
        /// sorted and brought to the sum 1, of a vertex' joints the first four are read. Normals that the file lacks
        /// are made. Parts are the column _PART, else the materials. Refused, for no FlgSkinAnimation can say it:
        /// scaled joints, joints that an animation moves apart from their parents, roots that move differently, keys
        /// that are not LINEAR; and what can't be right: joints or weights missing, out of range, not finite, nodes in
        /// circles, counts that don't fit. If the scene shows no skin the result is FlgResult.Ok and `out_file` null.
        /// Cost: one core, about 0.4 us a vertex. Errors: FlgResult.ErrorFile, FlgResult.ErrorFormat,
        /// FlgResult.ErrorLimit (2 GiB a file and what is made of it; 65535 joints).
        /// </summary>
        [DllImport(Library.Io, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgSkinFileRead(byte* path, FlgSkinFile* out_file);

        /// <summary>The skin; lives until the file is released.</summary>
        [DllImport(Library.Io, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgSkinFileGetView(FlgSkinFile file, FlgSkinView* out_view);

        /// <summary>
        /// The animations in the file's order, null and 0 if it has none. They live until the file is released.
        /// </summary>
        [DllImport(Library.Io, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgSkinFileGetAnimations(
            FlgSkinFile file, FlgSkinAnimation** out_animations, uint* out_count);

        /// <summary>
        /// The materials, one a part, or one for all; if at least one says a colour, else null and 0. As
        /// flgMeshFileGetMaterials.
        /// </summary>
        [DllImport(Library.Io, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgSkinFileGetMaterials(
            FlgSkinFile file, FlgMeshMaterial** out_materials, uint* out_count);

        /// <summary>What the file holds, and what is odd about it. Set its struct_size.</summary>
        [DllImport(Library.Io, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgSkinFileGetInfo(FlgSkinFile file, FlgSkinFileInfo* out_info);

        /// <summary>Null is allowed.</summary>
        [DllImport(Library.Io, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern void flgSkinFileRelease(FlgSkinFile file);

        [DllImport(Library.Io, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgSkinFileDescInit(FlgSkinFileDesc* desc, uint struct_size);

        /// <summary>
        /// Writes a skin with its animations to .glb, whole or not at all as flgCurveFileWrite: a node with the mesh; a
        /// node with all roots below it, which the skin names as its skeleton; a node a joint. Vertices have POSITION,
        /// NORMAL, JOINTS_0 (16 bits), WEIGHTS_0 (float) and _PART. Rotations that stay at none are left out. It
        /// refuses what glTF forbids: joints out of range or twice at a vertex, weights that don't come to 1 within
        /// 0.0001, quaternions that aren't of length 1 within 0.001, times that don't rise, values that aren't finite,
        /// parents that don't come first. Cost: about 0.8 us a vertex. Errors: FlgResult.ErrorInvalidArgument,
        /// FlgResult.ErrorFormat for another extension, FlgResult.ErrorFile, FlgResult.ErrorLimit (2 GiB).
        /// </summary>
        [DllImport(Library.Io, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgSkinFileWrite(byte* path, FlgSkinFileDesc* desc);

        [DllImport(Library.Io, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgMotionFileDescInit(FlgMotionFileDesc* desc, uint struct_size);

        /// <summary>
        /// Writes a motion to .glb, whole or not at all as flgCurveFileWrite: one node, with the mesh and the camera
        /// where given, and an animation that moves it by a translation and a rotation a position; between positions
        /// both go evenly (LINEAR). Without an animation it stands at the first one. Rotations of poses may be off by
        /// 0.001; quaternions are, to the bits of a float, of length 1, and next ones on the same side. Cost: about 1
        /// us a position, and what the mesh takes. Errors: FlgResult.ErrorInvalidArgument (also for poses that are no
        /// rotations), FlgResult.ErrorFormat for another extension, FlgResult.ErrorFile, FlgResult.ErrorLimit (2 GiB).
        /// </summary>
        [DllImport(Library.Io, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgMotionFileWrite(byte* path, FlgMotionFileDesc* desc);

        /// <summary>
        /// Writes the history of a tangle (flgTangleGetHistory) as JSON that can be read, with a side file for arrays
        /// of more than twelve numbers: `PATH.CHECKSUM.bin`, beside it. The JSON is put into its place last, and then
        /// the side file of the document that was there is removed: a save that is cut short leaves the document as it
        /// was. Where the history needs no side file none is written. The same history gives the same bytes. Errors:
        /// FlgResult.ErrorInvalidArgument (null, values that aren't finite), FlgResult.ErrorFile, FlgResult.ErrorLimit
        /// (8 MiB of JSON, 2 GiB of arrays). Cost: some us a step and what the disk takes.
        /// </summary>
        [DllImport(Library.Io, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgTangleFileWrite(byte* path, FlgTangleHistory* history);

        /// <summary>
        /// Reads a document, and checks it as far as that can be done without its mesh: version, keys, types, sizes,
        /// the side file's size and checksum, finite numbers. What the numbers may not be flgTangleReplay finds out.
        /// Nothing is read twice, so that what is made of a file is no larger than some multiple of it. Errors:
        /// FlgResult.ErrorFile, FlgResult.ErrorFormat, FlgResult.ErrorLimit. Cost: some us a step and what the disk
        /// takes.
        /// </summary>
        [DllImport(Library.Io, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgTangleFileRead(byte* path, FlgTangleFile* out_file);

        /// <summary>The history, ready for flgTangleReplay; lives until the file is released.</summary>
        [DllImport(Library.Io, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgTangleFileGetHistory(FlgTangleFile file, FlgTangleHistory* out_history);

        /// <summary>Null is allowed.</summary>
        [DllImport(Library.Io, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern void flgTangleFileRelease(FlgTangleFile file);
    }
}
