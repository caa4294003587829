// SPDX-License-Identifier: MIT
// Functions of filigree_io.h. Written by tools/abi/generate from sdk/api/abi.json: change the header.
//
// Filigree's file formats, in a separate library (filigree_io) that hosts may leave out. Follows the grammar of
// filigree.h but needs no context: its functions block on the disk, so call them where your engine loads assets. Memory
// and files may be the host's (FlgFileHooks).
//
// [any thread] All functions here; calls on one FlgCurveFile, FlgMeshFile, FlgSkinFile or FlgTangleFile must not
// overlap.
//
// Curve formats, by extension:
//   .xyz .txt     text: `x y z [radius]` per line, blank line between curves, `# closed` on the line before a closed
//                 one, `# color r g b a` (linear; without a: 1) on the line before the points that have this colour, up
//                 to the next such line; anything else after # is ignored. Points before the first colour are white.
//                 All points of a curve have a radius or none; if only some curves do, the others get 0.005 m. A line
//                 `# columns x y z NAME ...` before the first point instead names the contents of all lines, each
//                 number by a name from the list below
//   .obj          lines (`l`); read and written. Edges (`l a b`) that chain are joined; colours and radii are lost
//   .gltf .glb    LINES (joined where they chain), LINE_STRIP, LINE_LOOP, with COLOR_0 and _RADIUS, and with NORMAL,
//                 _TIME, _PRESSURE, _STYLE_INDEX, _RADII, _ANGLE, _WIDTH, _SPEED, _DISPLACEMENT and _USERN (1 to 4
//                 floats) if all curves have them; node transforms apply to lengths, speeds and directions too. .glb is
//                 written, as lines, ribbons or tubes; colours of these have 16 bits. Buffers only embedded or
//                 below the file's folder
//   .tilt         VR sketches, a file or a directory, read only; converted to metres and to a right-handed system. In
//                 an FlgFileSystem a directory is a path that does not open, with a `data.sketch` below it that does
//   .svg          outlines of shapes and paths, read only; y upwards, one metre per px, curves flattened to 1/1000 of
//                 their size
// Mesh formats, by extension; read and written, .gltf only read:
//   .ply          reads ascii and binary, writes little-endian binary. Vertices: positions, colours (0 to 1 if they are
//                 integers), normals and the columns this library writes, by the names below. Faces: the list
//                 vertex_indices, and integer properties, of which `region` becomes the view's regions; or `tristrips`.
//                 Reads texture coordinates: `s t`, `u v` or `texture_u texture_v` of vertices, lists `texcoord` of
//                 faces, with the textures of comments `TextureFile` below the file's folder, by `texnumber`. Other
//                 elements and properties are skipped
//   .obj          faces (`f`) and positions with colours (`v x y z r g b`). Regions are materials (`usemtl`), numbered
//                 from 0 in order of first use, and written as such. Texture coordinates (`vt`) are read, and materials
//                 of `mtllib` files below the file's folder: Kd, map_Kd, Pr, Pm. Normals are skipped
//   .off          also COFF, NOFF and CNOFF; colours (0 to 255 if one is above 1) but no regions
//   .gltf .glb    TRIANGLES, TRIANGLE_STRIP and TRIANGLE_FAN with COLOR_0, placed by the scene's nodes; regions are
//                 materials, numbered from 0 in order of first use; their factors are read, and their base colour
//                 textures with TEXCOORD_0. Reads KHR_mesh_quantization and KHR_texture_transform. What is left out is
//                 named in warnings. Writes .glb. Limits as for curves
// Large worlds: .obj, .off, .xyz and .ply (doubles and text) are read to all their digits, .gltf and .glb as precisely
// as their nodes place them. Where most edges are shorter than 64 times the spacing of floats there, views get an
// origin: the middle of all, or the first node's place, in whole metres. Boxes in infos are relative to it. Views with
// an origin are written to text with more digits, to .ply in doubles, to .glb below a node at the origin.
// Column names in .ply and .xyz: x y z; nx ny nz; red green blue alpha; radius, time, pressure, style_index, angle,
// width, speed; tangent_0 to _2, orientation_0 to _3, radii_0 to _2, displacement_0 to _2; FlgAttribute.User + N:
// userN, or userN_0, userN_1, ... with several components. For meshes the other formats hold positions, colours (not
// above 1 in .glb) and, in .glb, normals.

using System;
using System.Runtime.InteropServices;
using static System.Runtime.InteropServices.CallingConvention;

namespace Filigree
{
    public static unsafe partial class Native
    {
        [DllImport(Library.Io, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgFileSystemInit(FlgFileSystem* files, uint struct_size);

        [DllImport(Library.Io, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgFileHooksInit(FlgFileHooks* hooks, uint struct_size);

        /// <summary>
        /// [any thread] As flgErrorGetMessage, for the functions of this header. Sentences start with FILE:PLACE, where
        /// PLACE is a line number, a byte offset (`@1234`), a part of the file's structure or an argument; with FILE
        /// alone if the whole file is meant, such as when it cannot be opened.
        /// </summary>
        [DllImport(Library.Io, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern byte* flgIoErrorGetMessage();

        [DllImport(Library.Io, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgCurveFileReadDescInit(FlgCurveFileReadDesc* desc, uint struct_size);

        /// <summary>
        /// Reads all curves of a file. Reads the whole file, checks it, and refuses it at the first error; mere
        /// oddities become warnings (flgCurveFileGetInfo). `desc` may be null: all defaults. Limits: 2 GiB a file
        /// (unpacked too), 2^31 points. Errors: FlgResult.ErrorFile, FlgResult.ErrorFormat, FlgResult.ErrorLimit,
        /// FlgResult.ErrorOutOfMemory. Cost: 0.1 to 0.2 us a point.
        /// </summary>
        [DllImport(Library.Io, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgCurveFileRead(byte* path, FlgCurveFileReadDesc* desc, FlgCurveFile* out_file);

        /// <summary>The curves, ready for flgCurveSetCreate; lives until the file is released.</summary>
        [DllImport(Library.Io, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgCurveFileGetView(FlgCurveFile file, FlgCurveSetView* out_view);

        [DllImport(Library.Io, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgCurveFileInfoInit(FlgCurveFileInfo* info, uint struct_size);

        /// <summary>The file's contents and warnings. Set struct_size.</summary>
        [DllImport(Library.Io, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgCurveFileGetInfo(FlgCurveFile file, FlgCurveFileInfo* out_info);

        [DllImport(Library.Io, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgStrokeInit(FlgStroke* stroke, uint struct_size);

        /// <summary>The stroke of a curve, 0 to the info's stroke_count - 1. Set struct_size.</summary>
        [DllImport(Library.Io, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgCurveFileGetStroke(FlgCurveFile file, uint curve, FlgStroke* out_stroke);

        /// <summary>Null is allowed.</summary>
        [DllImport(Library.Io, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern void flgCurveFileRelease(FlgCurveFile file);

        [DllImport(Library.Io, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgCurveFileWriteDescInit(FlgCurveFileWriteDesc* desc, uint struct_size);

        /// <summary>
        /// Writes curves to .xyz, .obj or .glb, completely or not at all, also when the power goes: a temporary file
        /// beside it is flushed to the disk and renamed when complete (for an FlgFileSystem its `close` does so). The
        /// mode and owner of a file that it replaces stay. So do all functions that write files. `desc` may be null.
        /// Curves without a NORMAL column get frames by double reflection. Colours in .glb are clamped to 0 to 1; .glb
        /// cannot hold USER columns of more than 4 floats. Lines of one point are written with that point twice;
        /// ribbons and tubes omit zero-length curves. Errors: FlgResult.ErrorInvalidArgument (also for no curves at
        /// all), FlgResult.ErrorFormat for another extension, FlgResult.ErrorFile, FlgResult.ErrorLimit (.glb: 2 GiB).
        /// Text leaves while it is made, in parts of 64 KiB, and may be of any size; above 2 GiB it can't be read
        /// again. Cost: .glb 0.1 us a point, text 0.5 to 0.8.
        /// </summary>
        [DllImport(Library.Io, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgCurveFileWrite(
            byte* path, FlgCurveSetView* view, FlgCurveFileWriteDesc* desc);

        [DllImport(Library.Io, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgMeshFileReadDescInit(FlgMeshFileReadDesc* desc, uint struct_size);

        /// <summary>
        /// Reads the mesh of a file as stored: nothing is welded, reversed or dropped, except triangles of strips and
        /// fans that use a vertex twice. Splits faces of more than three corners into triangles: convex ones as fans
        /// from their first corner, others of at most 1024 corners by ear clipping. Like flgCurveFileRead, refuses
        /// errors (indices out of range, faces of fewer than three corners, values that are not finite, counts too
        /// large for the file, no faces at all) and warns of oddities. Cost: one core, some 400 MB/s of binary and 250
        /// MB/s of text (2 M triangles: 0.1 s and 0.3 s). `desc` may be null: all defaults. Limits: 2 GiB a file, and 2
        /// GiB for the result. Errors: FlgResult.ErrorFile, FlgResult.ErrorFormat, FlgResult.ErrorLimit.
        /// </summary>
        [DllImport(Library.Io, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgMeshFileRead(byte* path, FlgMeshFileReadDesc* desc, FlgMeshFile* out_file);

        /// <summary>The mesh; lives until the file is released. `regions` is null if the file has none.</summary>
        [DllImport(Library.Io, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgMeshFileGetView(FlgMeshFile file, FlgMeshView* out_view);

        [DllImport(Library.Io, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgMeshFaceColumnInit(FlgMeshFaceColumn* column, uint struct_size);

        /// <summary>
        /// An integer property of a .ply file's faces besides `region`, 0 to the info's face_column_count - 1. All
        /// triangles of a face have its values; negative values are stored plus 2^32. Its arrays live until the file is
        /// released.
        /// </summary>
        [DllImport(Library.Io, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgMeshFileGetFaceColumn(
            FlgMeshFile file, uint column, FlgMeshFaceColumn* out_column);

        [DllImport(Library.Io, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgTextureInit(FlgTexture* texture, uint struct_size);

        [DllImport(Library.Io, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgMeshMaterialInit(FlgMeshMaterial* material, uint struct_size);

        /// <summary>
        /// The material of a region in a .gltf or .glb file, in an .obj file's `mtllib`, of a .ply file's textures, 0
        /// to the info's material_count - 1. Missing factors get glTF's defaults: white, metallic 1, roughness 1; in
        /// .obj and .ply files metallic 0. Lines are read only from this library's files: glTF has none. Its name lives
        /// until the file is released.
        /// </summary>
        [DllImport(Library.Io, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgMeshFileGetMaterial(
            FlgMeshFile file, uint material, FlgMeshMaterial* out_material);

        /// <summary>
        /// A texture of a material, 0 to the info's texture_count - 1. Its picture is not decoded; it lives until the
        /// file is released.
        /// </summary>
        [DllImport(Library.Io, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgMeshFileGetTexture(FlgMeshFile file, uint texture, FlgTexture* out_texture);

        [DllImport(Library.Io, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgMeshFileInfoInit(FlgMeshFileInfo* info, uint struct_size);

        /// <summary>The file's contents and warnings. Set struct_size.</summary>
        [DllImport(Library.Io, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgMeshFileGetInfo(FlgMeshFile file, FlgMeshFileInfo* out_info);

        /// <summary>Null is allowed.</summary>
        [DllImport(Library.Io, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern void flgMeshFileRelease(FlgMeshFile file);

        [DllImport(Library.Io, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgMeshFileWriteDescInit(FlgMeshFileWriteDesc* desc, uint struct_size);

        /// <summary>
        /// Writes a mesh to .ply, .obj, .off or .glb, completely or not at all, as flgCurveFileWrite. `desc` may be
        /// null. .ply and .glb keep every bit of positions; text has 9 digits. A column FlgAttribute.Uv, with v
        /// downwards, becomes TEXCOORD_0 in .glb, `vt` in .obj, `s` and `t` in .ply; .off has none. .glb gets normals:
        /// the column's, else area-weighted ones. Errors: FlgResult.ErrorInvalidArgument (also for no triangles, and
        /// for indices out of range), FlgResult.ErrorFormat for another extension, FlgResult.ErrorFile,
        /// FlgResult.ErrorLimit (.ply, .glb: 2 GiB). Cost: 0.2 to 0.5 us a triangle.
        /// </summary>
        [DllImport(Library.Io, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgMeshFileWrite(byte* path, FlgMeshView* view, FlgMeshFileWriteDesc* desc);

        [DllImport(Library.Io, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgSkinFileReadDescInit(FlgSkinFileReadDesc* desc, uint struct_size);

        /// <summary>
        /// Reads the skinned mesh in a file's scene: all nodes with a mesh and the first skin found; other meshes are
        /// skipped, with a warning. The rest pose is that of the skin's inverseBindMatrices, whatever the nodes say.
        /// Joints rotated in that pose are read without the rotation; animation rotations change so that each vertex
        /// moves as before. The keys of all channels of an animation are merged. Joints come parents first; joints
        /// below other nodes attach to the nearest joint above. Weights are sorted and normalized to sum 1; only the
        /// first four joints of a vertex are read. Missing normals are computed. Parts come from the column _PART, else
        /// from the materials. TEXCOORD_0 becomes the view's corner_uvs. Morph targets are read if all primitives have
        /// as many; their animations must be LINEAR. Refused, as FlgSkinAnimation cannot represent them: scaled joints,
        /// joints that an animation moves away from their parents, roots that move differently, keys that are not
        /// LINEAR. Also refused: missing, out-of-range or non-finite joints or weights, cycles of nodes, inconsistent
        /// counts. If the scene has no skin the result is FlgResult.Ok and `out_file` null. `desc` may be null: all
        /// defaults. Cost: one core, about 0.4 us a vertex. Errors: FlgResult.ErrorFile, FlgResult.ErrorFormat,
        /// FlgResult.ErrorLimit (2 GiB a file and for the result; 65535 joints).
        /// </summary>
        [DllImport(Library.Io, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgSkinFileRead(byte* path, FlgSkinFileReadDesc* desc, FlgSkinFile* out_file);

        /// <summary>The skin; lives until the file is released.</summary>
        [DllImport(Library.Io, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgSkinFileGetView(FlgSkinFile file, FlgSkinView* out_view);

        /// <summary>
        /// An animation, 0 to the info's animation_count - 1, in the file's order. Its arrays live until the file is
        /// released.
        /// </summary>
        [DllImport(Library.Io, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgSkinFileGetAnimation(
            FlgSkinFile file, uint animation, FlgSkinAnimation* out_animation);

        /// <summary>The material of a part, 0 to the info's material_count - 1. As flgMeshFileGetMaterial.</summary>
        [DllImport(Library.Io, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgSkinFileGetMaterial(
            FlgSkinFile file, uint material, FlgMeshMaterial* out_material);

        /// <summary>A texture of a material, 0 to the info's texture_count - 1. As flgMeshFileGetTexture.</summary>
        [DllImport(Library.Io, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgSkinFileGetTexture(FlgSkinFile file, uint texture, FlgTexture* out_texture);

        [DllImport(Library.Io, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgMorphTargetInit(FlgMorphTarget* target, uint struct_size);

        [DllImport(Library.Io, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgMorphAnimationInit(FlgMorphAnimation* animation, uint struct_size);

        /// <summary>
        /// A morph target, 0 to the info's morph_count - 1. Its arrays live until the file is released; `normal_moves`
        /// are 0 where the file has none.
        /// </summary>
        [DllImport(Library.Io, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgSkinFileGetMorphTarget(
            FlgSkinFile file, uint target, FlgMorphTarget* out_target);

        /// <summary>
        /// What animates morph targets, 0 to the info's morph_animation_count - 1. Its arrays live until the file is
        /// released.
        /// </summary>
        [DllImport(Library.Io, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgSkinFileGetMorphAnimation(
            FlgSkinFile file, uint animation, FlgMorphAnimation* out_animation);

        [DllImport(Library.Io, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgSkinFileInfoInit(FlgSkinFileInfo* info, uint struct_size);

        /// <summary>The file's contents and warnings. Set struct_size.</summary>
        [DllImport(Library.Io, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgSkinFileGetInfo(FlgSkinFile file, FlgSkinFileInfo* out_info);

        /// <summary>Null is allowed.</summary>
        [DllImport(Library.Io, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern void flgSkinFileRelease(FlgSkinFile file);

        [DllImport(Library.Io, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgVrmInit(FlgVrm* vrm, uint struct_size);

        [DllImport(Library.Io, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgSkinFileWriteDescInit(FlgSkinFileWriteDesc* desc, uint struct_size);

        /// <summary>
        /// Writes a skin with its animations to .glb, completely or not at all, as flgCurveFileWrite: a node with the
        /// mesh, a node above all roots, which the skin names as its skeleton, and one node per joint. Vertices have
        /// POSITION, NORMAL, JOINTS_0 (16 bits), WEIGHTS_0 (float), _PART, with corner_uvs TEXCOORD_0, with
        /// vertex_colors COLOR_0. They keep their order; of those whose corners differ in texture coordinates, copies
        /// follow after all. Morph targets have POSITION and NORMAL, sparse where few vertices move; their weights are
        /// animated at the mesh's node, and at those of levels that have them. Levels of detail are meshes of the same
        /// skin, named NAME_LOD0, NAME_LOD1, ...; the first is in the scene and refers to the others by MSFT_lod, so
        /// programs that do not know it show the finest alone. Rotations that stay at identity are omitted. Refuses
        /// what glTF forbids: joints out of range or twice at a vertex, weights that do not sum to 1 within 0.0001,
        /// quaternions that are not of length 1 within 0.001, times that do not rise, values that are not finite,
        /// parents that do not come first. Cost: about 0.8 us a vertex. Errors: FlgResult.ErrorInvalidArgument,
        /// FlgResult.ErrorFormat for another extension, FlgResult.ErrorFile, FlgResult.ErrorLimit (2 GiB).
        /// </summary>
        [DllImport(Library.Io, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgSkinFileWrite(byte* path, FlgSkinFileWriteDesc* desc);

        [DllImport(Library.Io, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgMotionFileWriteDescInit(FlgMotionFileWriteDesc* desc, uint struct_size);

        /// <summary>
        /// Writes a motion to .glb, completely or not at all, as flgCurveFileWrite: one node, with the mesh and the
        /// camera if given, and an animation with one translation and rotation per position; both interpolate linearly
        /// in between (LINEAR). Without an animation the node stands at the first pose. Rotations of poses may be off
        /// by 0.001; quaternions have length 1, to float precision, and consecutive ones are in the same hemisphere.
        /// Cost: about 1 us a position, and what the mesh takes. Errors: FlgResult.ErrorInvalidArgument (also for poses
        /// that are no rotations), FlgResult.ErrorFormat for another extension, FlgResult.ErrorFile,
        /// FlgResult.ErrorLimit (2 GiB).
        /// </summary>
        [DllImport(Library.Io, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgMotionFileWrite(byte* path, FlgMotionFileWriteDesc* desc);

        /// <summary>
        /// [any thread] The name of a tangle operator in documents and scripts, such as "contour", by FlgTangleOperator
        /// value. Null beyond the last one. A static string. Cost: nanoseconds.
        /// </summary>
        [DllImport(Library.Io, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern byte* flgTangleOperatorGetName(uint number);

        /// <summary>
        /// [any thread] Likewise for a macro, such as "sunburst", by FlgTangleMacro value. Cost: nanoseconds.
        /// </summary>
        [DllImport(Library.Io, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern byte* flgTangleMacroGetName(uint number);

        [DllImport(Library.Io, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgTangleFileWriteDescInit(FlgTangleFileWriteDesc* desc, uint struct_size);

        /// <summary>
        /// Writes a tangle's history (flgTangleGetHistory) as readable JSON, with arrays of more than twelve numbers in
        /// a side file beside it: `PATH.CHECKSUM.bin`. The JSON is put in place last; then the previous document's side
        /// file is removed: an interrupted save leaves the previous document intact. No side file is written if none is
        /// needed. The same history gives the same bytes. `desc` may be null: all defaults. An FlgFileSystem opens and
        /// closes one file after the other. Errors: FlgResult.ErrorInvalidArgument (null, values that are not finite),
        /// FlgResult.ErrorFile, FlgResult.ErrorLimit (8 MiB of JSON, 2 GiB of arrays). Cost: some us a step and what
        /// the disk takes.
        /// </summary>
        [DllImport(Library.Io, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgTangleFileWrite(
            byte* path, FlgTangleHistory* history, FlgTangleFileWriteDesc* desc);

        [DllImport(Library.Io, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgTangleFileReadDescInit(FlgTangleFileReadDesc* desc, uint struct_size);

        /// <summary>
        /// Reads a document and checks what can be checked without its mesh: version, keys, types, sizes, the side
        /// file's size and checksum, finite numbers. flgTangleReplay checks the values' ranges. Nothing is read twice,
        /// so the result is at most some multiple of the file's size. `desc` may be null: all defaults. Errors:
        /// FlgResult.ErrorFile, FlgResult.ErrorFormat, FlgResult.ErrorLimit. Cost: some us a step and what the disk
        /// takes.
        /// </summary>
        [DllImport(Library.Io, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgTangleFileRead(
            byte* path, FlgTangleFileReadDesc* desc, FlgTangleFile* out_file);

        /// <summary>The history, ready for flgTangleReplay; lives until the file is released.</summary>
        [DllImport(Library.Io, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgTangleFileGetHistory(FlgTangleFile file, FlgTangleHistory* out_history);

        /// <summary>Null is allowed.</summary>
        [DllImport(Library.Io, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern void flgTangleFileRelease(FlgTangleFile file);

        public static FlgFileSystem flgFileSystemDefaults()
        {
            FlgFileSystem made;
            flgFileSystemInit(&made, (uint)sizeof(FlgFileSystem));
            return made;
        }

        public static FlgFileHooks flgFileHooksDefaults()
        {
            FlgFileHooks made;
            flgFileHooksInit(&made, (uint)sizeof(FlgFileHooks));
            return made;
        }

        public static FlgCurveFileReadDesc flgCurveFileReadDefaults()
        {
            FlgCurveFileReadDesc made;
            flgCurveFileReadDescInit(&made, (uint)sizeof(FlgCurveFileReadDesc));
            return made;
        }

        public static FlgMeshFileReadDesc flgMeshFileReadDefaults()
        {
            FlgMeshFileReadDesc made;
            flgMeshFileReadDescInit(&made, (uint)sizeof(FlgMeshFileReadDesc));
            return made;
        }

        public static FlgSkinFileReadDesc flgSkinFileReadDefaults()
        {
            FlgSkinFileReadDesc made;
            flgSkinFileReadDescInit(&made, (uint)sizeof(FlgSkinFileReadDesc));
            return made;
        }

        public static FlgTangleFileReadDesc flgTangleFileReadDefaults()
        {
            FlgTangleFileReadDesc made;
            flgTangleFileReadDescInit(&made, (uint)sizeof(FlgTangleFileReadDesc));
            return made;
        }

        public static FlgTangleFileWriteDesc flgTangleFileWriteDefaults()
        {
            FlgTangleFileWriteDesc made;
            flgTangleFileWriteDescInit(&made, (uint)sizeof(FlgTangleFileWriteDesc));
            return made;
        }

        public static FlgStroke flgStrokeDefaults()
        {
            FlgStroke made;
            flgStrokeInit(&made, (uint)sizeof(FlgStroke));
            return made;
        }

        public static FlgMeshFaceColumn flgMeshFaceColumnDefaults()
        {
            FlgMeshFaceColumn made;
            flgMeshFaceColumnInit(&made, (uint)sizeof(FlgMeshFaceColumn));
            return made;
        }

        public static FlgTexture flgTextureDefaults()
        {
            FlgTexture made;
            flgTextureInit(&made, (uint)sizeof(FlgTexture));
            return made;
        }

        public static FlgMorphTarget flgMorphTargetDefaults()
        {
            FlgMorphTarget made;
            flgMorphTargetInit(&made, (uint)sizeof(FlgMorphTarget));
            return made;
        }

        public static FlgMorphAnimation flgMorphAnimationDefaults()
        {
            FlgMorphAnimation made;
            flgMorphAnimationInit(&made, (uint)sizeof(FlgMorphAnimation));
            return made;
        }

        public static FlgMeshMaterial flgMeshMaterialDefaults()
        {
            FlgMeshMaterial made;
            flgMeshMaterialInit(&made, (uint)sizeof(FlgMeshMaterial));
            return made;
        }

        public static FlgCurveFileInfo flgCurveFileInfoDefaults()
        {
            FlgCurveFileInfo made;
            flgCurveFileInfoInit(&made, (uint)sizeof(FlgCurveFileInfo));
            return made;
        }

        public static FlgCurveFileWriteDesc flgCurveFileWriteDefaults()
        {
            FlgCurveFileWriteDesc made;
            flgCurveFileWriteDescInit(&made, (uint)sizeof(FlgCurveFileWriteDesc));
            return made;
        }

        public static FlgMeshFileInfo flgMeshFileInfoDefaults()
        {
            FlgMeshFileInfo made;
            flgMeshFileInfoInit(&made, (uint)sizeof(FlgMeshFileInfo));
            return made;
        }

        public static FlgMeshFileWriteDesc flgMeshFileWriteDefaults()
        {
            FlgMeshFileWriteDesc made;
            flgMeshFileWriteDescInit(&made, (uint)sizeof(FlgMeshFileWriteDesc));
            return made;
        }

        public static FlgSkinFileInfo flgSkinFileInfoDefaults()
        {
            FlgSkinFileInfo made;
            flgSkinFileInfoInit(&made, (uint)sizeof(FlgSkinFileInfo));
            return made;
        }

        public static FlgVrm flgVrmDefaults()
        {
            FlgVrm made;
            flgVrmInit(&made, (uint)sizeof(FlgVrm));
            return made;
        }

        public static FlgSkinFileWriteDesc flgSkinFileWriteDefaults()
        {
            FlgSkinFileWriteDesc made;
            flgSkinFileWriteDescInit(&made, (uint)sizeof(FlgSkinFileWriteDesc));
            return made;
        }

        public static FlgMotionFileWriteDesc flgMotionFileWriteDefaults()
        {
            FlgMotionFileWriteDesc made;
            flgMotionFileWriteDescInit(&made, (uint)sizeof(FlgMotionFileWriteDesc));
            return made;
        }
    }
}
