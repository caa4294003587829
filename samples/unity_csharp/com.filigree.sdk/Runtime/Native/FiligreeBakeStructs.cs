// SPDX-License-Identifier: MIT
// Structs of filigree_bake.h. Written by tools/abi/generate from sdk/api/abi.json: change the header.

using System;

namespace Filigree
{
    /// <summary>What is drawn, and where to: null maps are not wanted, one at least is.</summary>
    public unsafe partial struct FlgTangleBakeDesc
    {
        public uint struct_size;
        /// <summary>texels a side: 1 to FLG_BAKE_MAX_SIZE. Default 1024</summary>
        public uint size;
        public FlgJobOptions* job;
        /// <summary>of a surface with FlgSurfaceDesc.provenance</summary>
        public FlgTangle tangle;
        /// <summary>what the surface was made of; copied</summary>
        public FlgMeshView* mesh;
        /// <summary>6 per triangle of `mesh`: texture coordinates of its corners, 0 to 1; copied</summary>
        public float* corner_uvs;
        /// <summary>
        /// draws only triangles of `mesh` with this label: of a mesh whose materials have textures of their own, each
        /// has maps of its own. Default FLG_NO_INDEX: all
        /// </summary>
        public uint mesh_region;
        /// <summary>texels, 0 to FLG_BAKE_MAX_PADDING. Default 16</summary>
        public uint padding;
        /// <summary>of the lines in `borders`, metres, &gt;= 0 and finite. Default 0.01</summary>
        public float border_width;
        /// <summary>of `blends`, 1 to 16 where that is wanted. Default 0</summary>
        public uint component_count;
        /// <summary>by region of the tangle, component_count each, finite: colours, roughness; copied</summary>
        public float* blend_values;
        /// <summary>that have values; at least the tangle's</summary>
        public uint region_count;
        public uint reserved;
        /// <summary>1 per texel: the leaf there, the label of its triangles. Background: FLG_NO_INDEX</summary>
        public uint* ids;
        /// <summary>
        /// 1: metres to the nearest border that is seen, by the straight line to one of the pieces that are nearest to
        /// the corners of the cut triangle there. That is never less than the distance to the border; inside triangles
        /// much larger than the pattern it may be more, by at most about twice the way to the nearest corner. Infinite
        /// where there is no border, and in the background
        /// </summary>
        public float* distances;
        /// <summary>
        /// 1: how much of the texel a line along the borders that are seen covers, 0 to 255. Background: 0
        /// </summary>
        public byte* borders;
        /// <summary>
        /// 1: how far displacement raised the surface along the mesh's smooth normals, metres; below 0: sunk.
        /// Background: 0
        /// </summary>
        public float* heights;
        /// <summary>
        /// 3: the displaced surface's, of length 1, relative to the mesh's: x along rising u, y along falling v (up in
        /// the picture, as in glTF), z outwards. Background: 0 0 1
        /// </summary>
        public float* normals;
        /// <summary>
        /// component_count: blend_values of the leaf; across borders that are seen, the mean of both sides by how much
        /// of the texel they cover. Background: 0
        /// </summary>
        public float* blends;
    }
}
