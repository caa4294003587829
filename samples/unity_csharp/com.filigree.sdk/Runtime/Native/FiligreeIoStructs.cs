// SPDX-License-Identifier: MIT
// Structs of filigree_io.h. Written by tools/abi/generate from sdk/api/abi.json: change the header.

using System;
using System.Runtime.InteropServices;
using static System.Runtime.InteropServices.CallingConvention;

namespace Filigree
{
    /// <summary>Of FlgFileSystem.open. Opens a file; `out_file` is what the other functions get.</summary>
    [UnmanagedFunctionPointer(Cdecl)]
    public unsafe delegate FlgResult FlgFileSystemOpen(
        void* user_data, byte* path, FlgFileAccess access, void** out_file);

    /// <summary>Of FlgFileSystem.size. The size of a file that is read, bytes.</summary>
    [UnmanagedFunctionPointer(Cdecl)]
    public unsafe delegate FlgResult FlgFileSystemSize(void* user_data, void* file, ulong* out_size);

    /// <summary>
    /// Of FlgFileSystem.read. Reads the next bytes, at most `size`; `out_count` is how many. 0 only at the end.
    /// </summary>
    [UnmanagedFunctionPointer(Cdecl)]
    public unsafe delegate FlgResult FlgFileSystemRead(
        void* user_data, void* file, void* out_bytes, UIntPtr size, UIntPtr* out_count);

    /// <summary>Of FlgFileSystem.write. Appends bytes, all of them. Null: no file can be written.</summary>
    [UnmanagedFunctionPointer(Cdecl)]
    public unsafe delegate FlgResult FlgFileSystemWrite(void* user_data, void* file, void* bytes, UIntPtr size);

    /// <summary>
    /// Of FlgFileSystem.close. Called once for each open file. Of one that is written, `complete` tells whether to keep
    /// it: with 0 what was there before must stay.
    /// </summary>
    [UnmanagedFunctionPointer(Cdecl)]
    public unsafe delegate FlgResult FlgFileSystemClose(void* user_data, void* file, uint complete);

    /// <summary>
    /// Of FlgFileSystem.remove. Removes a side file that no document names any more. Where it fails the file stays, and
    /// the call that asked for it succeeds nevertheless. Null: files stay.
    /// </summary>
    [UnmanagedFunctionPointer(Cdecl)]
    public unsafe delegate FlgResult FlgFileSystemRemove(void* user_data, byte* path);

    /// <summary>
    /// Files of the host: archives, assets, consoles. Called only within calls of this library that were given it, on
    /// their threads. Paths are those the host passes, and names beside them that files or this library give, put
    /// together with `/`; UTF-8. This library opens no path with `..` that the host did not pass. One file is open at a
    /// time in a call. Each function returns FlgResult.Ok or an error, such as FlgResult.ErrorFile; the call that needs
    /// the file then fails with it.
    /// </summary>
    public unsafe partial struct FlgFileSystem
    {
        public uint struct_size;
        public uint reserved;
        /// <summary>passed to all</summary>
        public void* user_data;
        /// <summary>
        /// A FlgFileSystemOpen, by Marshal.GetFunctionPointerForDelegate. Opens a file; `out_file` is what the other
        /// functions get.
        /// </summary>
        public IntPtr open;
        /// <summary>
        /// A FlgFileSystemSize, by Marshal.GetFunctionPointerForDelegate. The size of a file that is read, bytes.
        /// </summary>
        public IntPtr size;
        /// <summary>
        /// A FlgFileSystemRead, by Marshal.GetFunctionPointerForDelegate. Reads the next bytes, at most `size`;
        /// `out_count` is how many. 0 only at the end.
        /// </summary>
        public IntPtr read;
        /// <summary>
        /// A FlgFileSystemWrite, by Marshal.GetFunctionPointerForDelegate. Appends bytes, all of them. Null: no file
        /// can be written.
        /// </summary>
        public IntPtr write;
        /// <summary>
        /// A FlgFileSystemClose, by Marshal.GetFunctionPointerForDelegate. Called once for each open file. Of one that
        /// is written, `complete` tells whether to keep it: with 0 what was there before must stay.
        /// </summary>
        public IntPtr close;
        /// <summary>
        /// A FlgFileSystemRemove, by Marshal.GetFunctionPointerForDelegate. Removes a side file that no document names
        /// any more. Where it fails the file stays, and the call that asked for it succeeds nevertheless. Null: files
        /// stay.
        /// </summary>
        public IntPtr remove;
    }

    /// <summary>
    /// What a call uses of the host. The structs are copied; what they point to must live as long as what the call
    /// makes.
    /// </summary>
    public unsafe partial struct FlgFileHooks
    {
        public uint struct_size;
        public uint reserved;
        /// <summary>
        /// All memory of the call and of what it makes. Where it returns null, the call fails with
        /// FlgResult.ErrorOutOfMemory. Null: the C++ runtime's. Not included: what the C++ runtime takes for the
        /// exceptions that stop a failing call, and for names and buffers of the operating system's files. Called on
        /// the threads that use this library.
        /// </summary>
        public FlgAllocator* allocator;
        /// <summary>null: the operating system's</summary>
        public FlgFileSystem* files;
    }

    /// <summary>How a curve file is read.</summary>
    public unsafe partial struct FlgCurveFileReadDesc
    {
        public uint struct_size;
        public uint reserved;
        /// <summary>null: all defaults. Default null</summary>
        public FlgFileHooks* hooks;
    }

    public unsafe partial struct FlgCurveFileInfo
    {
        public uint struct_size;
        public uint curve_count;
        public ulong point_count;
        /// <summary>"tilt", "xyz", "obj", "gltf", "svg"</summary>
        public byte* format;
        /// <summary>of the file, before conversion: "decimetres, left-handed", "metres", "as given"</summary>
        public byte* units;
        /// <summary>of the positions, metres</summary>
        public fixed float box_min[3];
        /// <summary>of the positions, metres</summary>
        public fixed float box_max[3];
        /// <summary>of all curves as polylines, metres</summary>
        public float total_length;
        public uint warning_count;
        /// <summary>that of the curves for .tilt files, else 0</summary>
        public uint stroke_count;
        /// <summary>sentences; live until the file is released</summary>
        public byte** warnings;
    }

    /// <summary>Data of one stroke in a .tilt file, besides its points.</summary>
    public unsafe partial struct FlgStroke
    {
        public uint struct_size;
        /// <summary>selection group, 0 = none</summary>
        public uint group;
        /// <summary>the brush's name if known, else its GUID</summary>
        public fixed byte brush[40];
        /// <summary>width at full pressure, metres</summary>
        public float size;
        /// <summary>as stored: 2 = continues the undo group of the previous stroke</summary>
        public uint flags;
        /// <summary>timestamp of its first point, milliseconds of sketching time</summary>
        public ulong start_ms;
    }

    public unsafe partial struct FlgCurveFileWriteDesc
    {
        public uint struct_size;
        /// <summary>for .glb; the text formats hold lines. Default FlgCurveGeometry.Lines</summary>
        public FlgCurveGeometry geometry;
        /// <summary>metres, &gt; 0, for curves without a RADIUS column. Default 0.005</summary>
        public float default_radius;
        /// <summary>3 to 64. Default 8</summary>
        public uint tube_sides;
        /// <summary>
        /// nonzero: .xyz and lines in .glb hold all columns of the view (.glb except TANGENT and ORIENTATION), else
        /// positions, radii and colours. Default 0
        /// </summary>
        public uint all_columns;
        public uint reserved;
        /// <summary>
        /// metres, &gt;= 0: how far ribbons and tubes may deviate from those with all points and `tube_sides` sides.
        /// Makes the file smaller. Default 0: every point, every side
        /// </summary>
        public float tolerance;
        /// <summary>
        /// nonzero: ribbons and tubes use integers (KHR_mesh_quantization): positions in 65535ths of their piece's
        /// extent, if that is within the tolerance, normals and colours in 8 bits. Halves the size. Not all programs
        /// read it. Default 0
        /// </summary>
        public uint quantize;
        /// <summary>
        /// for .glb: FlgCurveGeometry.Ribbon or FlgCurveGeometry.Tube for each curve, in place of `geometry`. Default
        /// null
        /// </summary>
        public byte* geometries;
        /// <summary>null: all defaults. Default null</summary>
        public FlgFileHooks* hooks;
    }

    /// <summary>How a mesh file is read.</summary>
    public unsafe partial struct FlgMeshFileReadDesc
    {
        public uint struct_size;
        public uint reserved;
        /// <summary>null: all defaults. Default null</summary>
        public FlgFileHooks* hooks;
    }

    /// <summary>Integers per triangle, with a name.</summary>
    public unsafe partial struct FlgMeshFaceColumn
    {
        /// <summary>the same of all columns of a mesh</summary>
        public uint struct_size;
        public uint reserved;
        /// <summary>letters, digits and _, at most 63; not `region` nor `vertex_indices`</summary>
        public byte* name;
        /// <summary>one per triangle</summary>
        public uint* values;
    }

    /// <summary>
    /// A picture that colours triangles, by the texture coordinates of their corners: 0 0 is its upper left, 1 1 its
    /// lower right.
    /// </summary>
    public unsafe partial struct FlgTexture
    {
        /// <summary>the same of all textures of a file</summary>
        public uint struct_size;
        /// <summary>nonzero: texels are not blended. Default 0</summary>
        public uint nearest;
        /// <summary>Default FlgTextureWrap.Repeat</summary>
        public FlgTextureWrap wrap_u;
        public FlgTextureWrap wrap_v;
        /// <summary>a PNG or JPEG file, picture_size bytes; sRGB</summary>
        public byte* picture;
        /// <summary>bytes</summary>
        public ulong picture_size;
        /// <summary>UTF-8, at most 255 bytes; null: none. Default null</summary>
        public byte* name;
    }

    /// <summary>
    /// A region's material: glTF's metallic-roughness model, and a line where it meets another region. Colours are
    /// linear RGB.
    /// </summary>
    public unsafe partial struct FlgMeshMaterial
    {
        /// <summary>the same of all materials of a mesh</summary>
        public uint struct_size;
        public uint reserved;
        /// <summary>UTF-8, at most 255 bytes. Default null: `region N`</summary>
        public byte* name;
        /// <summary>0 to 1 each. Default 1 1 1</summary>
        public fixed float color[3];
        /// <summary>0 = paint, clay, wood to 1 = bare metal. Default 0</summary>
        public float metallic;
        /// <summary>0 = polished to 1 = matte. Default 0.6</summary>
        public float roughness;
        /// <summary>of the lines to regions earlier in the table, 0 to 1 each. Default 0 0 0</summary>
        public fixed float border_color[3];
        /// <summary>of these lines, 0 to 64 pixels. Default 0: none</summary>
        public float border_width_px;
        public uint reserved2;
        /// <summary>of the file's textures: its colour, times the material's. Default FLG_NO_INDEX: none</summary>
        public uint texture;
        /// <summary>nonzero: seen from behind too. Default 0</summary>
        public uint two_sided;
    }

    public unsafe partial struct FlgMeshFileInfo
    {
        public uint struct_size;
        /// <summary>as stored: formats that keep normals or texture with vertices repeat positions</summary>
        public uint vertex_count;
        /// <summary>after splitting polygons</summary>
        public uint triangle_count;
        /// <summary>distinct labels; 1 if the file has none</summary>
        public uint region_count;
        /// <summary>faces as stored; for strips and fans their triangles</summary>
        public ulong polygon_count;
        /// <summary>"ply", "obj", "off", "gltf"</summary>
        public byte* format;
        /// <summary>of the positions, metres; units are taken as given</summary>
        public fixed float box_min[3];
        /// <summary>of the positions, metres; units are taken as given</summary>
        public fixed float box_max[3];
        public uint warning_count;
        /// <summary>
        /// one per region of the view (one alone if that has no regions), if at least one has a colour or a texture;
        /// else 0
        /// </summary>
        public uint material_count;
        /// <summary>sentences; live until the file is released</summary>
        public byte** warnings;
        /// <summary>at most 16; 0 for other formats than .ply</summary>
        public uint face_column_count;
        public uint texture_count;
        /// <summary>
        /// 6 per triangle: texture coordinates of its corners, 0 0 where some have none; live until the file is
        /// released. Null: the file has none
        /// </summary>
        public float* corner_uvs;
    }

    public unsafe partial struct FlgMeshFileWriteDesc
    {
        public uint struct_size;
        /// <summary>0 to 16. Default 0</summary>
        public uint face_column_count;
        /// <summary>written to .ply, under distinct names; the other formats cannot hold them</summary>
        public FlgMeshFaceColumn* face_columns;
        /// <summary>nonzero: one primitive and material per region in .glb. Default 0</summary>
        public uint split_regions;
        /// <summary>with split_regions: above all regions' labels. Default 0: named, without colour</summary>
        public uint material_count;
        /// <summary>for .glb, by label; materials without a region are omitted</summary>
        public FlgMeshMaterial* materials;
        /// <summary>null: all defaults. Default null</summary>
        public FlgFileHooks* hooks;
        /// <summary>
        /// For .glb: the path of the .gltf or .glb file whose mesh, as flgMeshFileRead gives it, became the surface
        /// that `view` shows. What that file holds is written too: nodes, other meshes, materials, pictures, skins,
        /// animations and what this library does not know keep their content. Triangles are the view's, with all that
        /// the file's vertices have: texture coordinates, colours, tangents, joints and weights, morph targets. Those
        /// whose label is material_count or more keep their material. Needs `provenance`. Default null: none.
        /// </summary>
        public byte* asset;
        /// <summary>of that surface, as it is in `view`. Default null</summary>
        public FlgSurfaceProvenanceView* provenance;
    }

    /// <summary>How a skin file is read.</summary>
    public unsafe partial struct FlgSkinFileReadDesc
    {
        public uint struct_size;
        public uint reserved;
        /// <summary>null: all defaults. Default null</summary>
        public FlgFileHooks* hooks;
    }

    /// <summary>
    /// A shape that a mesh takes as far as its weight says: vertices move by `moves`, times the weight, before joints
    /// move them.
    /// </summary>
    public unsafe partial struct FlgMorphTarget
    {
        /// <summary>the same of all targets of a mesh</summary>
        public uint struct_size;
        public uint reserved;
        /// <summary>UTF-8, at most 255 bytes; null: `target N`. Default null</summary>
        public byte* name;
        /// <summary>3 per vertex, metres</summary>
        public float* moves;
        /// <summary>3 per vertex: what is added to normals. Null: found from how triangles turn. Default null</summary>
        public float* normal_moves;
    }

    /// <summary>
    /// Weights of all morph targets over time. Between keys they change evenly; before the first and after the last key
    /// they hold.
    /// </summary>
    public unsafe partial struct FlgMorphAnimation
    {
        /// <summary>the same of all of a mesh</summary>
        public uint struct_size;
        /// <summary>at least 1</summary>
        public uint key_count;
        /// <summary>UTF-8; null: "morph". Of one that belongs to a skin's animation that one's name counts</summary>
        public byte* name;
        /// <summary>seconds, starting at 0 or later; strictly ascending</summary>
        public float* times;
        /// <summary>for each key one per target; finite</summary>
        public float* weights;
        /// <summary>
        /// of the skin's animations: joints and shapes move together, as one animation. Default FLG_NO_INDEX: by itself
        /// </summary>
        public uint animation;
        public uint reserved;
    }

    public unsafe partial struct FlgSkinFileInfo
    {
        public uint struct_size;
        /// <summary>the view's highest part index plus one</summary>
        public uint part_count;
        /// <summary>of the positions at rest, metres</summary>
        public fixed float box_min[3];
        /// <summary>of the positions at rest, metres</summary>
        public fixed float box_max[3];
        public uint warning_count;
        public uint animation_count;
        /// <summary>sentences; live until the file is released</summary>
        public byte** warnings;
        /// <summary>one per part, or one for all, if at least one has a colour or a texture; else 0</summary>
        public uint material_count;
        public uint texture_count;
        /// <summary>4 per vertex, linear RGBA; live until the file is released. Null: none</summary>
        public float* vertex_colors;
        public uint morph_count;
        public uint morph_animation_count;
    }

    /// <summary>
    /// The extension VRMC_vrm of VRM 1.0: who made an avatar, and which of its joints are which bones. Its other fields
    /// are left at the extension's defaults: only the author may use the avatar, and nobody may change it.
    /// </summary>
    public unsafe partial struct FlgVrm
    {
        public uint struct_size;
        /// <summary>at least 1</summary>
        public uint author_count;
        /// <summary>UTF-8</summary>
        public byte** authors;
        /// <summary>of the avatar, UTF-8; null: the model's. Default null</summary>
        public byte* name;
        /// <summary>UTF-8; null: https://vrm.dev/licenses/1.0/, the only one VRM 1.0 allows. Default null</summary>
        public byte* license_url;
        /// <summary>
        /// one per joint of the skin: from flgRigGetNames with FlgRigStandard.Vrm; null: the joint is no bone of VRM
        /// </summary>
        public byte** bones;
    }

    public unsafe partial struct FlgSkinFileWriteDesc
    {
        public uint struct_size;
        /// <summary>default 0</summary>
        public uint animation_count;
        public FlgSkinView* skin;
        /// <summary>animation_count entries, each for all of the skin's joints</summary>
        public FlgSkinAnimation* animations;
        /// <summary>of the model, UTF-8, at most 255 bytes; null: "model"</summary>
        public byte* name;
        /// <summary>0: one without colour; 1: one for all; else above all part indices. Default 0</summary>
        public uint material_count;
        public uint reserved;
        /// <summary>
        /// by part. Without triangle_parts a triangle belongs to the part of two of its corners, else of its first
        /// corner
        /// </summary>
        public FlgMeshMaterial* materials;
        /// <summary>null: all defaults. Default null</summary>
        public FlgFileHooks* hooks;
        /// <summary>of the skin's joints: written as `extras` of their nodes, see docs/rigs.md. Default null</summary>
        public FlgRig* rig;
        /// <summary>makes the file a VRM 1.0 avatar. Default null</summary>
        public FlgVrm* vrm;
        /// <summary>
        /// a PNG or JPEG file, texture_size bytes: the colour of all materials, times theirs; the skin needs
        /// corner_uvs. Default null
        /// </summary>
        public byte* texture;
        /// <summary>bytes; 0 without one. Default 0</summary>
        public ulong texture_size;
        /// <summary>
        /// levels of detail after the skin itself, from fine to coarse, with its joints: flgSkinSimplify. Default null
        /// </summary>
        public FlgSkinView* levels;
        /// <summary>up to 16. Default 0</summary>
        public uint level_count;
        /// <summary>default 0</summary>
        public uint texture_count;
        /// <summary>
        /// what materials refer to, in place of `texture`; the skin and its levels need corner_uvs. Default null
        /// </summary>
        public FlgTexture* textures;
        /// <summary>
        /// 4 per vertex of the skin, linear RGBA, 0 to 1: times the materials' colour. Levels of detail have none.
        /// Default null
        /// </summary>
        public float* vertex_colors;
        /// <summary>shapes of the skin. Default null</summary>
        public FlgMorphTarget* morphs;
        /// <summary>default null</summary>
        public FlgMorphAnimation* morph_animations;
        /// <summary>up to 65535. Default 0</summary>
        public uint morph_count;
        /// <summary>default 0</summary>
        public uint morph_animation_count;
        /// <summary>
        /// the same shapes of the levels of detail: morph_count of each, level by level; their names are not read.
        /// Null: levels have none. Default null
        /// </summary>
        public FlgMorphTarget* level_morphs;
    }

    public unsafe partial struct FlgMotionFileWriteDesc
    {
        public uint struct_size;
        /// <summary>at least 1</summary>
        public uint position_count;
        /// <summary>seconds, starting at 0 or later; strictly ascending as floats</summary>
        public double* times;
        /// <summary>
        /// 12 per position: three rows of four, the rotation and the position, metres. Point p of the body is at
        /// rotation p + position
        /// </summary>
        public double* poses;
        /// <summary>when the first pose recurs, after the last time; 0: never. Default 0</summary>
        public double end_time;
        /// <summary>moves with the body; null: none</summary>
        public FlgMeshView* mesh;
        /// <summary>its materials, as for flgMeshFileWrite; its hooks are not used; null: defaults</summary>
        public FlgMeshFileWriteDesc* mesh_desc;
        /// <summary>
        /// above 0 and below pi: the vertical field of view of a camera that looks along the body's -z, with y up.
        /// Default 0: no camera
        /// </summary>
        public float camera_fov_rad;
        public uint reserved;
        /// <summary>of the body, UTF-8, at most 255 bytes; null: "motion"</summary>
        public byte* name;
        /// <summary>metres: what the poses are relative to: a node above the body's is there. Default 0</summary>
        public fixed double origin[3];
        /// <summary>null: all defaults. Default null</summary>
        public FlgFileHooks* hooks;
    }

    public unsafe partial struct FlgTangleFileWriteDesc
    {
        public uint struct_size;
        public uint reserved;
        /// <summary>null: all defaults. Default null</summary>
        public FlgFileHooks* hooks;
    }

    /// <summary>How a tangle's file is read.</summary>
    public unsafe partial struct FlgTangleFileReadDesc
    {
        public uint struct_size;
        public uint reserved;
        /// <summary>null: all defaults. Default null</summary>
        public FlgFileHooks* hooks;
    }
}
