// SPDX-License-Identifier: MIT
// Types of filigree_io.h. Written by tools/abi/generate from sdk/api/abi.json: change the header.

using System;

namespace Filigree
{
    /// <summary>What a file is opened for.</summary>
    public enum FlgFileAccess
    {
        /// <summary>FLG_FILE_ACCESS_READ: from its start</summary>
        Read = 0,
        /// <summary>
        /// FLG_FILE_ACCESS_WRITE: anew: what is there is replaced when the file is closed as complete
        /// </summary>
        Write = 1,
    }

    /// <summary>Geometry of curves in .glb.</summary>
    public enum FlgCurveGeometry
    {
        /// <summary>FLG_CURVE_GEOMETRY_LINES: no surface</summary>
        Lines = 0,
        /// <summary>FLG_CURVE_GEOMETRY_RIBBON: flat, across the frame's second normal</summary>
        Ribbon = 1,
        /// <summary>FLG_CURVE_GEOMETRY_TUBE: round, with `tube_sides` sides</summary>
        Tube = 2,
    }

    /// <summary>How a texture goes on beyond its picture.</summary>
    public enum FlgTextureWrap
    {
        /// <summary>FLG_TEXTURE_WRAP_REPEAT</summary>
        Repeat = 0,
        /// <summary>FLG_TEXTURE_WRAP_CLAMP: by its edge</summary>
        Clamp = 1,
        /// <summary>FLG_TEXTURE_WRAP_MIRROR: repeated, every other one mirrored</summary>
        Mirror = 2,
    }

    /// <summary>Curves read from a file, with their memory.</summary>
    public partial struct FlgCurveFile
    {
        public IntPtr pointer;
        public bool IsNull => pointer == IntPtr.Zero;
    }

    /// <summary>A mesh read from a file, with its memory.</summary>
    public partial struct FlgMeshFile
    {
        public IntPtr pointer;
        public bool IsNull => pointer == IntPtr.Zero;
    }

    /// <summary>A skin read from a .gltf or .glb file, with its animations and its memory.</summary>
    public partial struct FlgSkinFile
    {
        public IntPtr pointer;
        public bool IsNull => pointer == IntPtr.Zero;
    }

    /// <summary>A history read from a file, with its memory.</summary>
    public partial struct FlgTangleFile
    {
        public IntPtr pointer;
        public bool IsNull => pointer == IntPtr.Zero;
    }
}
