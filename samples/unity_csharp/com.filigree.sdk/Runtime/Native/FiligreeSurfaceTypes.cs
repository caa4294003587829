// SPDX-License-Identifier: MIT
// Types of filigree_surface.h. Written by tools/abi/generate from sdk/api/abi.json: change the header.

using System;
using System.Runtime.InteropServices;

namespace Filigree
{
    public static unsafe partial class Native
    {
        /// <summary>The largest label that a triangle may have.</summary>
        public const uint FLG_REGION_MAX = 16777215;
    }

    /// <summary>How triangles are made finer.</summary>
    public enum FlgSubdivision
    {
        /// <summary>FLG_SUBDIVISION_MIDPOINT: each triangle in four, the surface stays as it is</summary>
        Midpoint = 0,
        /// <summary>FLG_SUBDIVISION_LOOP: Loop's scheme: smooth; borders become cubic splines</summary>
        Loop = 1,
    }

    /// <summary>Which solver measures distances.</summary>
    public enum FlgAccuracy
    {
        /// <summary>
        /// FLG_ACCURACY_REFINED: unfolding: below 0.2 % of error (RMS) on natural meshes, and the faster one
        /// </summary>
        Refined = 0,
        /// <summary>FLG_ACCURACY_GRAPH: sec. 4.2: shortest paths along edges and dual arcs; 1 to 3 % too long</summary>
        Graph = 1,
    }

    /// <summary>A mesh with its adjacency and what geodesics need. Cutting changes it.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public partial struct FlgSurface : IEquatable<FlgSurface>
    {
        public ulong id;
        public bool IsNull => id == 0;
        public bool Equals(FlgSurface other) => id == other.id;
        public override bool Equals(object other) => other is FlgSurface handle && Equals(handle);
        public override int GetHashCode() => id.GetHashCode();
    }

    /// <summary>A value a vertex of a surface. Never changes once ready.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public partial struct FlgField : IEquatable<FlgField>
    {
        public ulong id;
        public bool IsNull => id == 0;
        public bool Equals(FlgField other) => id == other.id;
        public override bool Equals(object other) => other is FlgField handle && Equals(handle);
        public override int GetHashCode() => id.GetHashCode();
    }

    /// <summary>Curves on a surface, straight in each triangle. Never change once ready.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public partial struct FlgSurfaceCurves : IEquatable<FlgSurfaceCurves>
    {
        public ulong id;
        public bool IsNull => id == 0;
        public bool Equals(FlgSurfaceCurves other) => id == other.id;
        public override bool Equals(object other) => other is FlgSurfaceCurves handle && Equals(handle);
        public override int GetHashCode() => id.GetHashCode();
    }
}
