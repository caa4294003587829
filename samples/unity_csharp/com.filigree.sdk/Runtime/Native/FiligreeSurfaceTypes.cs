// SPDX-License-Identifier: MIT
// Types of filigree_surface.h. Written by tools/abi/generate from sdk/api/abi.json: change the header.

using System;

namespace Filigree
{
    public static unsafe partial class Native
    {
        /// <summary>The largest triangle label.</summary>
        public const uint FLG_REGION_MAX = 16777215;
    }

    /// <summary>How triangles are refined.</summary>
    public enum FlgSubdivision
    {
        /// <summary>FLG_SUBDIVISION_MIDPOINT: splits each triangle into four; the shape does not change</summary>
        Midpoint = 0,
        /// <summary>FLG_SUBDIVISION_LOOP: Loop's scheme: smooth; borders become cubic splines</summary>
        Loop = 1,
    }

    /// <summary>How near distances are to those of the triangles.</summary>
    public enum FlgAccuracy
    {
        /// <summary>FLG_ACCURACY_REFINED: within some 0.2 %, in about 40 ns a triangle</summary>
        Refined = 0,
        /// <summary>
        /// FLG_ACCURACY_EXACT: to rounding, by windows: some hundred times the work; up to some 300,000 triangles
        /// </summary>
        Exact = 1,
    }

    /// <summary>A mesh with its adjacency and data for geodesics. Cutting changes it.</summary>
    public partial struct FlgSurface : IEquatable<FlgSurface>
    {
        public ulong id;
        public bool IsNull => id == 0;
        public bool Equals(FlgSurface other) => id == other.id;
        public override bool Equals(object other) => other is FlgSurface handle && Equals(handle);
        public override int GetHashCode() => id.GetHashCode();
    }

    /// <summary>One value per vertex of a surface. Never changes once ready.</summary>
    public partial struct FlgField : IEquatable<FlgField>
    {
        public ulong id;
        public bool IsNull => id == 0;
        public bool Equals(FlgField other) => id == other.id;
        public override bool Equals(object other) => other is FlgField handle && Equals(handle);
        public override int GetHashCode() => id.GetHashCode();
    }

    /// <summary>Curves on a surface, straight in each triangle. Never change once ready.</summary>
    public partial struct FlgSurfaceCurves : IEquatable<FlgSurfaceCurves>
    {
        public ulong id;
        public bool IsNull => id == 0;
        public bool Equals(FlgSurfaceCurves other) => id == other.id;
        public override bool Equals(object other) => other is FlgSurfaceCurves handle && Equals(handle);
        public override int GetHashCode() => id.GetHashCode();
    }
}
