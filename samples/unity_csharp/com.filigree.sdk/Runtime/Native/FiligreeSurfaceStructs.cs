// SPDX-License-Identifier: MIT
// Structs of filigree_surface.h. Written by tools/abi/generate from sdk/api/abi.json: change the header.

using System;
using System.Runtime.InteropServices;

namespace Filigree
{
    /// <summary>
    /// A triangle mesh in flat arrays. Used for input (the host owns the arrays, for the time of the call) and for
    /// results.
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct FlgMeshView
    {
        public uint struct_size;
        public uint vertex_count;
        public uint triangle_count;
        /// <summary>1 to 16, each attribute at most once</summary>
        public uint column_count;
        /// <summary>one value a vertex; POSITION is needed, the others are carried along</summary>
        public FlgColumn* columns;
        /// <summary>3 vertices a triangle, counter-clockwise seen from outside</summary>
        public uint* triangles;
        /// <summary>a label a triangle; null: all 0</summary>
        public uint* regions;
    }

    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct FlgSurfaceDesc
    {
        public uint struct_size;
        /// <summary>
        /// Vertices at most so far apart become one, metres, &gt;= 0; 0: those at the same place, to the bit. Below 0:
        /// none. Default 0.
        /// </summary>
        public float weld_distance;
        public FlgJobOptions job;
        public FlgMeshView mesh;
    }

    /// <summary>What was found in the input and done about it, and what the surface is like.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct FlgSurfaceReport
    {
        public uint struct_size;
        /// <summary>became one with another</summary>
        public uint welded_vertices;
        /// <summary>dropped: no triangle names them</summary>
        public uint unused_vertices;
        /// <summary>dropped: they name a vertex twice</summary>
        public uint degenerate_triangles;
        /// <summary>dropped: the same three vertices as another, in any order</summary>
        public uint duplicate_triangles;
        /// <summary>turned over, to be of one winding with their neighbours</summary>
        public uint flipped_triangles;
        /// <summary>had more than two triangles: joined in pairs, the rest apart</summary>
        public uint crowded_edges;
        /// <summary>opened because both sides could not be kept (Moebius strips, crowded edges)</summary>
        public uint cut_edges;
        /// <summary>vertices added for those whose triangles formed several fans</summary>
        public uint split_vertices;
        /// <summary>kept: lower than 1e-6 of their longest edge</summary>
        public uint flat_triangles;
        public uint vertex_count;
        public uint triangle_count;
        /// <summary>pieces that no edge joins</summary>
        public uint component_count;
        /// <summary>closed chains of border edges</summary>
        public uint border_count;
        /// <summary>edges with one triangle</summary>
        public uint border_edges;
        /// <summary>handles, of all components together</summary>
        public uint genus;
        /// <summary>vertices - edges + triangles</summary>
        public long euler_number;
        /// <summary>square metres</summary>
        public double area;
        /// <summary>of the positions, metres</summary>
        public fixed float box_min[3];
        /// <summary>of the positions, metres</summary>
        public fixed float box_max[3];
        /// <summary>
        /// one a vertex of the input: where it is now, FLG_NO_INDEX if dropped (one that was split is named where its
        /// first fan is); null if all are where they were. Lives until the surface is released
        /// </summary>
        public uint* vertex_of_input;
        public uint input_vertex_count;
        public uint reserved;
    }

    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct FlgSurfaceView
    {
        public uint struct_size;
        /// <summary>changes so far</summary>
        public uint revision;
        public FlgMeshView mesh;
        /// <summary>3 a triangle: across the edges from corner k to corner k + 1; FLG_NO_INDEX at a border</summary>
        public uint* neighbours;
    }

    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct FlgRefineDesc
    {
        public uint struct_size;
        /// <summary>default FlgSubdivision.Midpoint</summary>
        public FlgSubdivision scheme;
        public FlgJobOptions job;
        public FlgSurface surface;
        /// <summary>1 to 8; default 1</summary>
        public uint levels;
        public uint reserved;
    }

    /// <summary>
    /// At weights (1 - u - v, u, v) of the triangle's corners; u, v &gt;= 0 and u + v &lt;= 1 (up to 1e-5, which is
    /// clipped).
    /// </summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct FlgSurfacePoint
    {
        /// <summary>its number</summary>
        public uint triangle;
        /// <summary>weights of corners 1 and 2</summary>
        public float u;
        /// <summary>weights of corners 1 and 2</summary>
        public float v;
    }

    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct FlgSurfaceCurvesView
    {
        public uint struct_size;
        /// <summary>may be 0</summary>
        public uint curve_count;
        /// <summary>curve_count + 1 values</summary>
        public uint* curve_offsets;
        /// <summary>FLG_CURVE_CLOSED</summary>
        public byte* curve_flags;
        /// <summary>of an isoline its value, of a path its length, of a stream the field's value at its end</summary>
        public float* curve_values;
        /// <summary>the stretch from a point to the next lies in the triangle that the point names</summary>
        public FlgSurfacePoint* points;
        /// <summary>of the surface</summary>
        public uint revision;
        public uint reserved;
    }

    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct FlgLiftDesc
    {
        public uint struct_size;
        /// <summary>metres above the surface along its normal; any finite number, default 0</summary>
        public float height;
        public FlgJobOptions job;
        public FlgSurfaceCurves curves;
    }

    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct FlgGeodesicDesc
    {
        public uint struct_size;
        /// <summary>default FlgAccuracy.Refined</summary>
        public FlgAccuracy accuracy;
        public FlgJobOptions job;
        public FlgSurface surface;
        /// <summary>Sources: any of these together, at least one. All arrays are copied.</summary>
        public uint* vertices;
        public uint vertex_count;
        public uint point_count;
        /// <summary>places on triangles</summary>
        public FlgSurfacePoint* points;
        /// <summary>every point of these curves; null: none</summary>
        public FlgSurfaceCurves curves;
        /// <summary>the borders of these regions, also where the surface ends</summary>
        public uint* border_regions;
        public uint border_region_count;
        /// <summary>Where distances are computed and paths may lead.</summary>
        public uint region_count;
        /// <summary>labels; null: the whole surface</summary>
        public uint* regions;
        /// <summary>Distances beyond this are left infinite, metres, &gt; 0; default infinity.</summary>
        public float max_distance;
        /// <summary>
        /// Stop once these vertices have their distance; further ones may be left infinite or too far.
        /// </summary>
        public uint target_count;
        /// <summary>vertices</summary>
        public uint* targets;
        /// <summary>
        /// The metric may be perturbed for an organic look (sec. 3.4, Fig. 10): distances are measured as if the
        /// vertices were moved along their normals by Perlin noise of at most so many metres; 0 (default): not.
        /// </summary>
        public float perturbation;
        /// <summary>Waves a metre of that noise, &gt; 0; default 1.</summary>
        public float frequency;
        /// <summary>of the noise; default 1</summary>
        public ulong seed;
        /// <summary>Nonzero: the field has labels, the numbers of the nearest sources. Default 0.</summary>
        public uint labels;
        public uint reserved;
    }

    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct FlgFieldView
    {
        public uint struct_size;
        public uint vertex_count;
        /// <summary>
        /// one a vertex; of distances: metres, infinite where no path leads or none within the limits
        /// </summary>
        public float* values;
        /// <summary>
        /// the nearest source's number: vertices, then points, then curves, then border regions, in the order of the
        /// descriptor; FLG_NO_INDEX where infinite. Null if the field has none
        /// </summary>
        public uint* labels;
        /// <summary>of a sampling: its vertices, in the order they were chosen</summary>
        public uint* samples;
        public uint sample_count;
        /// <summary>of the surface</summary>
        public uint revision;
    }

    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct FlgBlendDesc
    {
        public uint struct_size;
        public uint reserved;
        public FlgJobOptions job;
        /// <summary>0 there</summary>
        public FlgField from;
        /// <summary>1 there</summary>
        public FlgField to;
    }

    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct FlgSamplingDesc
    {
        public uint struct_size;
        /// <summary>points at most; 0 (default): as many as fit</summary>
        public uint max_count;
        public FlgJobOptions job;
        public FlgSurface surface;
        /// <summary>no two points are nearer to each other along the surface, metres, &gt; 0</summary>
        public float radius;
        public uint region_count;
        /// <summary>labels; null: the whole surface</summary>
        public uint* regions;
        /// <summary>of the first point; default 1</summary>
        public ulong seed;
    }

    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct FlgBorderSamplingDesc
    {
        public uint struct_size;
        /// <summary>
        /// wanted distance along the border, metres, &gt; 0; each border gets a whole number of equal steps
        /// </summary>
        public float spacing;
        public FlgJobOptions job;
        public FlgSurface surface;
        /// <summary>whose borders, also where the surface ends</summary>
        public uint region;
        public uint reserved;
    }

    /// <summary>Which values of a field: either `values`, or first + k * every for k = 0 to count - 1.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct FlgLevels
    {
        /// <summary>rising, at most 65534; null: evenly spaced ones</summary>
        public float* values;
        /// <summary>
        /// 0 with every &gt; 0: as many as the field has, k from the first that is not below its smallest value; at
        /// most 65534
        /// </summary>
        public uint count;
        /// <summary>used without `values`; `every` &gt; 0</summary>
        public float first;
        /// <summary>used without `values`; `every` &gt; 0</summary>
        public float every;
    }

    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct FlgIsolinesDesc
    {
        public uint struct_size;
        public uint region_count;
        public FlgJobOptions job;
        public FlgField field;
        /// <summary>labels; null: the whole surface</summary>
        public uint* regions;
        public FlgLevels levels;
    }

    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct FlgStreamsDesc
    {
        public uint struct_size;
        /// <summary>nonzero: against the gradient. Default 0</summary>
        public uint downhill;
        public FlgJobOptions job;
        public FlgField field;
        /// <summary>a curve each; copied</summary>
        public FlgSurfacePoint* starts;
        public uint start_count;
        public uint region_count;
        /// <summary>further starts: the points of flgBorderSample, which may still be in the making</summary>
        public FlgSurfaceCurves border_samples;
        /// <summary>the curves end where these do</summary>
        public uint* regions;
        /// <summary>they end where the field reaches this; default: infinity, its sign doesn't matter</summary>
        public float end_value;
        public uint reserved;
    }

    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct FlgPathsDesc
    {
        public uint struct_size;
        /// <summary>nonzero: the last point of each path is joined to its first. Default 0</summary>
        public uint closed;
        public FlgJobOptions job;
        public FlgSurface surface;
        /// <summary>all paths' points, copied</summary>
        public FlgSurfacePoint* points;
        /// <summary>path_count + 1 values: path p goes through points offsets[p] to offsets[p + 1] - 1</summary>
        public uint* path_offsets;
        public uint path_count;
        public uint region_count;
        /// <summary>the first guess keeps to these</summary>
        public uint* regions;
    }

    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct FlgCutIsolinesDesc
    {
        public uint struct_size;
        public uint region_count;
        public FlgJobOptions job;
        /// <summary>its surface is cut</summary>
        public FlgField field;
        /// <summary>labels; null: the whole surface</summary>
        public uint* regions;
        public FlgLevels levels;
        /// <summary>
        /// Triangles of regions[i] above k of n levels get the label first_label + i * (n + 1) + k; with `regions` null
        /// all get first_label + k. Default FLG_NO_INDEX: labels stay as they are. At most 256 levels.
        /// </summary>
        public uint first_label;
        public uint reserved;
    }

    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct FlgCutCurvesDesc
    {
        public uint struct_size;
        /// <summary>
        /// The parts of a region that falls apart get labels from here on, in the order in which the curves meet them;
        /// a region that doesn't keeps its own. Default FLG_NO_INDEX: labels stay as they are.
        /// </summary>
        public uint first_label;
        public FlgJobOptions job;
        /// <summary>their surface is cut</summary>
        public FlgSurfaceCurves curves;
    }
}
