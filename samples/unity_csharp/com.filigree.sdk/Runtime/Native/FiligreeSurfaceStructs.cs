// SPDX-License-Identifier: MIT
// Structs of filigree_surface.h. Written by tools/abi/generate from sdk/api/abi.json: change the header.

using System;

namespace Filigree
{
    /// <summary>
    /// A triangle mesh in flat arrays. Used for input (the host owns the arrays, which must live for the call) and for
    /// results.
    /// </summary>
    public unsafe partial struct FlgMeshView
    {
        public uint struct_size;
        public uint vertex_count;
        public uint triangle_count;
        /// <summary>1 to 16, each attribute at most once</summary>
        public uint column_count;
        /// <summary>one value per vertex; POSITION is required, others are carried along</summary>
        public FlgColumn* columns;
        /// <summary>3 vertices per triangle, counter-clockwise seen from outside</summary>
        public uint* triangles;
        /// <summary>one label per triangle; null: all 0</summary>
        public uint* regions;
        /// <summary>metres: what positions are relative to. Default 0</summary>
        public fixed double origin[3];
    }

    public unsafe partial struct FlgSurfaceDesc
    {
        public uint struct_size;
        /// <summary>
        /// Vertices up to this distance apart are merged, metres, &gt;= 0; 0: only vertices at the same place, to the
        /// bit. Below 0: none. Default 0.
        /// </summary>
        public float weld_distance;
        public FlgJobOptions* job;
        /// <summary>copied</summary>
        public FlgMeshView* mesh;
        /// <summary>
        /// Nonzero: flgSurfaceGetProvenance can be asked where triangles lie on `mesh`. 20 bytes a vertex, 4 a triangle
        /// and 12 a triangle of `mesh`. Default 0.
        /// </summary>
        public uint provenance;
        public uint reserved;
    }

    /// <summary>Defects found in the input, their repairs, and properties of the surface.</summary>
    public unsafe partial struct FlgSurfaceReport
    {
        public uint struct_size;
        /// <summary>merged into another vertex</summary>
        public uint welded_vertices;
        /// <summary>dropped: no triangle uses them</summary>
        public uint unused_vertices;
        /// <summary>dropped: they use a vertex twice</summary>
        public uint degenerate_triangles;
        /// <summary>dropped: the same three vertices as another, in any order</summary>
        public uint duplicate_triangles;
        /// <summary>reversed, to match their neighbours' winding</summary>
        public uint flipped_triangles;
        /// <summary>had more than two triangles: joined in pairs, the rest separated</summary>
        public uint crowded_edges;
        /// <summary>opened because their two sides cannot stay joined (Moebius strips, crowded edges)</summary>
        public uint cut_edges;
        /// <summary>vertices added where triangles formed several fans</summary>
        public uint split_vertices;
        /// <summary>kept: height below 1e-6 of the longest edge</summary>
        public uint flat_triangles;
        public uint vertex_count;
        public uint triangle_count;
        /// <summary>pieces not joined by any edge</summary>
        public uint component_count;
        /// <summary>closed chains of border edges</summary>
        public uint border_count;
        /// <summary>edges with one triangle</summary>
        public uint border_edges;
        /// <summary>handles, over all components</summary>
        public uint genus;
        /// <summary>vertices - edges + triangles</summary>
        public long euler_number;
        /// <summary>square metres</summary>
        public double area;
        /// <summary>of the positions, metres, relative to `origin`</summary>
        public fixed float box_min[3];
        /// <summary>of the positions, metres, relative to `origin`</summary>
        public fixed float box_max[3];
        /// <summary>
        /// one per input vertex: its index in the surface, FLG_NO_INDEX if dropped (for a split vertex, that of its
        /// first fan); null if no index changed. Lives until the surface is released
        /// </summary>
        public uint* vertex_of_input;
        public uint input_vertex_count;
        public uint reserved;
        /// <summary>the input mesh's</summary>
        public fixed double origin[3];
    }

    public unsafe partial struct FlgSurfaceView
    {
        public uint struct_size;
        /// <summary>changes so far</summary>
        public uint revision;
        /// <summary>never null; lives as long as its arrays</summary>
        public FlgMeshView* mesh;
        /// <summary>3 per triangle: across the edges from corner k to corner k + 1; FLG_NO_INDEX at a border</summary>
        public uint* neighbours;
    }

    /// <summary>
    /// At weights (1 - u - v, u, v) of the triangle's corners; u, v &gt;= 0 and u + v &lt;= 1 (clipped within 1e-5).
    /// </summary>
    public unsafe partial struct FlgSurfacePoint
    {
        /// <summary>its index</summary>
        public uint triangle;
        /// <summary>weights of corners 1 and 2</summary>
        public float u;
        /// <summary>weights of corners 1 and 2</summary>
        public float v;
    }

    /// <summary>
    /// Where a vertex lies on the mesh that its surface was made of: weights of at most three of that mesh's vertices,
    /// all of one triangle.
    /// </summary>
    public unsafe partial struct FlgSourceWeights
    {
        /// <summary>of the input, rising, welded: the first at a place; FLG_NO_INDEX behind the last</summary>
        public fixed uint vertices[3];
        /// <summary>of the second and the third, 0 to 1; the first has what is missing to 1</summary>
        public fixed float weights[2];
    }

    /// <summary>
    /// Where a surface's triangles and vertices lie on the mesh that it was made of, however often it was cut, refined
    /// or displaced since: so that whatever that mesh has at the corners of its triangles (texture coordinates with
    /// seams, tangents, joints and weights, morph targets) can be had at the corners of the surface's. Each triangle
    /// lies in one triangle of the input.
    /// </summary>
    public unsafe partial struct FlgSurfaceProvenanceView
    {
        public uint struct_size;
        /// <summary>of the surface</summary>
        public uint revision;
        /// <summary>the surface's</summary>
        public uint vertex_count;
        public uint triangle_count;
        public uint input_triangle_count;
        public uint reserved;
        /// <summary>one per triangle: the input's triangle it lies in</summary>
        public uint* triangles;
        /// <summary>3 per triangle of the input, in its order, welded as above</summary>
        public uint* input_vertices;
        /// <summary>one per vertex</summary>
        public FlgSourceWeights* weights;
    }

    public unsafe partial struct FlgSurfaceRefineDesc
    {
        public uint struct_size;
        /// <summary>default FlgSubdivision.Midpoint</summary>
        public FlgSubdivision scheme;
        public FlgJobOptions* job;
        public FlgSurface surface;
        /// <summary>1 to 8; default 1</summary>
        public uint levels;
        public uint reserved;
    }

    public unsafe partial struct FlgSurfaceCurvesView
    {
        public uint struct_size;
        /// <summary>may be 0</summary>
        public uint curve_count;
        /// <summary>curve_count + 1 values</summary>
        public uint* curve_offsets;
        /// <summary>FLG_CURVE_CLOSED</summary>
        public byte* curve_flags;
        /// <summary>an isoline's value, a path's length, or the field's value at a stream's end</summary>
        public float* curve_values;
        /// <summary>the segment from each point to the next lies in the triangle that the point names</summary>
        public FlgSurfacePoint* points;
        /// <summary>of the surface</summary>
        public uint revision;
        public uint reserved;
    }

    public unsafe partial struct FlgSurfaceCurvesLiftDesc
    {
        public uint struct_size;
        /// <summary>metres above the surface along its normal; any finite number, default 0</summary>
        public float height;
        public FlgJobOptions* job;
        public FlgSurfaceCurves curves;
    }

    public unsafe partial struct FlgFieldGeodesicDesc
    {
        public uint struct_size;
        /// <summary>Nonzero: the field has labels, the indices of the nearest sources. Default 0.</summary>
        public uint labels;
        public FlgJobOptions* job;
        public FlgSurface surface;
        /// <summary>Sources: any combination of these, at least one. All arrays are copied.</summary>
        public uint* vertices;
        public uint vertex_count;
        public uint point_count;
        /// <summary>points on triangles</summary>
        public FlgSurfacePoint* points;
        /// <summary>all points of these curves; null: none</summary>
        public FlgSurfaceCurves curves;
        /// <summary>the borders of these regions, including surface borders</summary>
        public uint* border_regions;
        public uint border_region_count;
        /// <summary>Limits on where distances are computed and paths lead.</summary>
        public uint region_count;
        /// <summary>labels; null: the whole surface</summary>
        public uint* regions;
        /// <summary>Distances beyond this stay infinite, metres, &gt; 0; default infinity.</summary>
        public float max_distance;
        /// <summary>
        /// Stop once these vertices have their distance; more distant ones may stay infinite or be too large.
        /// </summary>
        public uint target_count;
        /// <summary>vertices</summary>
        public uint* targets;
        /// <summary>
        /// Perturbs the metric for an organic look (sec. 3.4, Fig. 10): distances are measured as if Perlin noise moved
        /// the vertices along their normals by at most this many metres; 0 (default): none.
        /// </summary>
        public float perturbation;
        /// <summary>Waves of that noise per metre, &gt; 0; default 1.</summary>
        public float frequency;
        /// <summary>of the noise; default 1</summary>
        public ulong seed;
        /// <summary>default FlgAccuracy.Refined; an exact field has no perturbation</summary>
        public FlgAccuracy accuracy;
        public uint reserved;
    }

    public unsafe partial struct FlgFieldView
    {
        public uint struct_size;
        public uint vertex_count;
        /// <summary>one per vertex; for distances: metres, infinite where no path leads within the limits</summary>
        public float* values;
        /// <summary>
        /// index of the nearest source: vertices, then points, then curves, then border regions, in the descriptor's
        /// order; FLG_NO_INDEX where infinite. Null if the field has none
        /// </summary>
        public uint* labels;
        /// <summary>for a sampling: its vertices, in the order chosen</summary>
        public uint* samples;
        public uint sample_count;
        /// <summary>of the surface</summary>
        public uint revision;
    }

    public unsafe partial struct FlgFieldBlendDesc
    {
        public uint struct_size;
        public uint reserved;
        public FlgJobOptions* job;
        /// <summary>the blend is 0 there</summary>
        public FlgField from;
        /// <summary>the blend is 1 there</summary>
        public FlgField to;
    }

    public unsafe partial struct FlgSurfaceSampleDesc
    {
        public uint struct_size;
        /// <summary>maximum points; 0 (default): as many as fit</summary>
        public uint max_count;
        public FlgJobOptions* job;
        public FlgSurface surface;
        /// <summary>minimum distance between points along the surface, metres, &gt; 0</summary>
        public float radius;
        public uint region_count;
        /// <summary>labels; null: the whole surface</summary>
        public uint* regions;
        /// <summary>for the first point; default 1</summary>
        public ulong seed;
    }

    public unsafe partial struct FlgSurfaceSampleBordersDesc
    {
        public uint struct_size;
        /// <summary>
        /// desired distance along the border, metres, &gt; 0; each border gets a whole number of equal steps
        /// </summary>
        public float spacing;
        public FlgJobOptions* job;
        public FlgSurface surface;
        /// <summary>the region with the borders, including surface borders</summary>
        public uint region;
        public uint reserved;
    }

    public unsafe partial struct FlgFieldTraceIsolinesDesc
    {
        public uint struct_size;
        public uint region_count;
        public FlgJobOptions* job;
        public FlgField field;
        /// <summary>labels; null: the whole surface</summary>
        public uint* regions;
        /// <summary>values of the field, ascending, copied; null: level_first + k * level_every</summary>
        public float* levels;
        /// <summary>
        /// at most 65534; 0 without `levels`: as many as the field has, starting at the first k not below its smallest
        /// value
        /// </summary>
        public uint level_count;
        /// <summary>used without `levels`; level_every &gt; 0</summary>
        public float level_first;
        /// <summary>used without `levels`; level_every &gt; 0</summary>
        public float level_every;
        public uint reserved;
    }

    public unsafe partial struct FlgFieldTraceStreamsDesc
    {
        public uint struct_size;
        /// <summary>nonzero: against the gradient. Default 0</summary>
        public uint downhill;
        public FlgJobOptions* job;
        public FlgField field;
        /// <summary>one curve each; copied</summary>
        public FlgSurfacePoint* starts;
        public uint start_count;
        public uint region_count;
        /// <summary>further starts: the points of flgSurfaceSampleBorders, whose job may still run</summary>
        public FlgSurfaceCurves border_samples;
        /// <summary>the curves end where these regions end</summary>
        public uint* regions;
        /// <summary>they end where the field reaches this; default: infinity, of either sign</summary>
        public float end_value;
        public uint reserved;
    }

    public unsafe partial struct FlgFieldTracePathsDesc
    {
        public uint struct_size;
        /// <summary>nonzero: each path's last point joins its first. Default 0</summary>
        public uint closed;
        public FlgJobOptions* job;
        public FlgSurface surface;
        /// <summary>the points of all paths, copied</summary>
        public FlgSurfacePoint* points;
        /// <summary>path_count + 1 values: path p passes through points offsets[p] to offsets[p + 1] - 1</summary>
        public uint* path_offsets;
        public uint path_count;
        public uint region_count;
        /// <summary>the initial guess stays on these</summary>
        public uint* regions;
    }

    public unsafe partial struct FlgSurfaceCutIsolinesDesc
    {
        public uint struct_size;
        public uint region_count;
        public FlgJobOptions* job;
        /// <summary>its surface is cut</summary>
        public FlgField field;
        /// <summary>labels; null: the whole surface</summary>
        public uint* regions;
        /// <summary>as in FlgFieldTraceIsolinesDesc, but at most 256 levels</summary>
        public float* levels;
        public uint level_count;
        /// <summary>likewise</summary>
        public float level_first;
        /// <summary>likewise</summary>
        public float level_every;
        /// <summary>
        /// Triangles of regions[i] above k of n levels get the label first_label + i * (n + 1) + k; with `regions` null
        /// all get first_label + k. Default FLG_NO_INDEX: labels do not change.
        /// </summary>
        public uint first_label;
    }

    public unsafe partial struct FlgSurfaceCutCurvesDesc
    {
        public uint struct_size;
        /// <summary>
        /// If a region falls apart, its parts get labels from here on, in the order in which the curves meet them;
        /// other regions keep their labels. Default FLG_NO_INDEX: labels do not change.
        /// </summary>
        public uint first_label;
        public FlgJobOptions* job;
        /// <summary>their surface is cut</summary>
        public FlgSurfaceCurves curves;
    }
}
