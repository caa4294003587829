// SPDX-License-Identifier: MIT
// Structs of filigree_io.h. Written by tools/abi/generate from sdk/api/abi.json: change the header.

using System;
using System.Runtime.InteropServices;

namespace Filigree
{
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct FlgCurveFileInfo
    {
        public uint struct_size;
        public uint curve_count;
        public ulong point_count;
        /// <summary>"tilt", "xyz", "obj", "gltf"</summary>
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
        public uint reserved;
        /// <summary>sentences; live until the file is released</summary>
        public byte** warnings;
    }

    /// <summary>What a .tilt file says of one stroke besides its points.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct FlgStroke
    {
        /// <summary>the brush's name where known, else its GUID</summary>
        public fixed byte brush[40];
        /// <summary>width at full pressure, metres</summary>
        public float size;
        /// <summary>selection group, 0 = none</summary>
        public uint group;
        /// <summary>as stored: 2 = continues the undo group of the stroke before it</summary>
        public uint flags;
        /// <summary>time stamp of its first point, milliseconds of sketching time</summary>
        public ulong start_ms;
    }

    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct FlgCurveWriteDesc
    {
        public uint struct_size;
        /// <summary>of .glb; the text formats hold lines. Default FlgGeometry.Lines</summary>
        public FlgGeometry geometry;
        /// <summary>metres, &gt; 0, for curves without a RADIUS column. Default 0.005</summary>
        public float default_radius;
        /// <summary>3 to 64. Default 8</summary>
        public uint tube_sides;
        /// <summary>
        /// nonzero: .xyz and the lines of .glb hold all columns of the view (.glb but TANGENT and ORIENTATION), else
        /// positions, radii and, in .glb, colours. Default 0
        /// </summary>
        public uint all_columns;
        public uint reserved;
    }

    /// <summary>Whole numbers that belong to the triangles, by a name.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct FlgMeshFaceColumn
    {
        /// <summary>letters, digits and _, at most 63; not `region` nor `vertex_indices`</summary>
        public byte* name;
        /// <summary>one a triangle</summary>
        public uint* values;
    }

    /// <summary>
    /// How a region looks: glTF's metallic-roughness model, and a line where it meets another. Colours are linear RGB.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct FlgMeshMaterial
    {
        /// <summary>UTF-8, at most 255 bytes; null: `region N`</summary>
        public byte* name;
        /// <summary>0 to 1 each</summary>
        public fixed float color[3];
        /// <summary>0 = paint, clay, wood to 1 = bare metal</summary>
        public float metallic;
        /// <summary>0 = polished to 1 = matte</summary>
        public float roughness;
        /// <summary>of the lines to regions that come before it in the table, 0 to 1 each</summary>
        public fixed float border_color[3];
        /// <summary>of these lines, 0 to 64 pixels; 0: none</summary>
        public float border_width_px;
        public uint reserved;
    }

    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct FlgMeshFileInfo
    {
        public uint struct_size;
        /// <summary>as stored: formats that keep normals or texture with vertices repeat positions</summary>
        public uint vertex_count;
        /// <summary>after polygons are split</summary>
        public uint triangle_count;
        /// <summary>different labels; 1 where the file has none</summary>
        public uint region_count;
        /// <summary>faces as stored; of strips and fans their triangles</summary>
        public ulong polygon_count;
        /// <summary>"ply", "obj", "off", "gltf"</summary>
        public byte* format;
        /// <summary>of the positions, metres; units are taken as given</summary>
        public fixed float box_min[3];
        /// <summary>of the positions, metres; units are taken as given</summary>
        public fixed float box_max[3];
        public uint warning_count;
        public uint reserved;
        /// <summary>sentences; live until the file is released</summary>
        public byte** warnings;
    }

    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct FlgMeshWriteDesc
    {
        public uint struct_size;
        /// <summary>0 to 16. Default 0</summary>
        public uint face_column_count;
        /// <summary>written to .ply, different names; the other formats have no place for them</summary>
        public FlgMeshFaceColumn* face_columns;
        /// <summary>nonzero: a primitive and a material for each region in .glb. Default 0</summary>
        public uint split_regions;
        /// <summary>with split_regions: above all regions' labels. Default 0: named, without colour</summary>
        public uint material_count;
        /// <summary>those of .glb, by label; materials that no region has are left out</summary>
        public FlgMeshMaterial* materials;
    }

    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct FlgSkinFileInfo
    {
        public uint struct_size;
        /// <summary>the highest of the view's parts, and one</summary>
        public uint part_count;
        /// <summary>of the positions at rest, metres</summary>
        public fixed float box_min[3];
        /// <summary>of the positions at rest, metres</summary>
        public fixed float box_max[3];
        public uint warning_count;
        public uint reserved;
        /// <summary>sentences; live until the file is released</summary>
        public byte** warnings;
    }

    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct FlgSkinFileDesc
    {
        public uint struct_size;
        /// <summary>default 0</summary>
        public uint animation_count;
        public FlgSkinView* skin;
        /// <summary>animation_count of them, of all of the skin's joints</summary>
        public FlgSkinAnimation* animations;
        /// <summary>of the model, UTF-8, at most 255 bytes; null: "model"</summary>
        public byte* name;
        /// <summary>0: one without colour; 1: of all; else above all parts. Default 0</summary>
        public uint material_count;
        public uint reserved;
        /// <summary>by part. A triangle is of the part that two of its corners are of, else of the first's</summary>
        public FlgMeshMaterial* materials;
    }

    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct FlgMotionFileDesc
    {
        public uint struct_size;
        /// <summary>at least 1</summary>
        public uint position_count;
        /// <summary>seconds from 0 on; as floats they must rise</summary>
        public double* times;
        /// <summary>
        /// 12 a position: three rows of four, the rotation and the place, metres. Points p of the body are at rotation
        /// p + place
        /// </summary>
        public double* poses;
        /// <summary>when the first pose comes again, after the last time; 0: it does not. Default 0</summary>
        public double end_time;
        /// <summary>moves with the body; null: none</summary>
        public FlgMeshView* mesh;
        /// <summary>its materials, as for flgMeshFileWrite; null: defaults</summary>
        public FlgMeshWriteDesc* mesh_desc;
        /// <summary>
        /// above 0 and below pi: a camera that looks along the body's -z, with y up, and sees this angle from bottom to
        /// top. Default 0: none
        /// </summary>
        public float camera_fov_rad;
        public uint reserved;
        /// <summary>of the body, UTF-8, at most 255 bytes; null: "motion"</summary>
        public byte* name;
    }
}
