// SPDX-License-Identifier: MIT
// A tube that grows, in arrays that are made once. What is appended is uploaded, with the last ring before it, and
// nothing else is: points of a live stroke never move.
using System;
using UnityEngine;
using UnityEngine.Rendering;

namespace Filigree.Samples
{
    sealed class StrokeMesh
    {
        struct Vertex
        {
            public Vector3 Position;
            public Vector3 Normal;
        }

        // Indices are right by construction, and the bounds are kept here.
        const MeshUpdateFlags Trusting = MeshUpdateFlags.DontValidateIndices | MeshUpdateFlags.DontRecalculateBounds |
            MeshUpdateFlags.DontResetBoneBounds;

        readonly BrushMesh brush;
        readonly Vertex[] vertices;
        readonly uint[] indices;
        Bounds bounds;

        public Mesh Mesh { get; }
        public int PointCount { get; private set; }

        public StrokeMesh(int maxPoints, int sides)
        {
            FlgBrushMeshDesc desc = Native.flgBrushMeshDefaults();
            desc.sides = (uint)sides;
            desc.join = FlgBrushJoin.Narrow; // a ring a point
            desc.start_cap = desc.end_cap = FlgBrushCap.None;
            brush = new BrushMesh(desc);
            vertices = new Vertex[maxPoints * sides];
            indices = new uint[(maxPoints - 1) * sides * 6];

            Mesh = new Mesh { name = "Stylized stroke" };
            Mesh.MarkDynamic();
            Mesh.SetVertexBufferParams(vertices.Length,
                new VertexAttributeDescriptor(VertexAttribute.Position, VertexAttributeFormat.Float32, 3),
                new VertexAttributeDescriptor(VertexAttribute.Normal, VertexAttributeFormat.Float32, 3));
            Mesh.SetIndexBufferParams(indices.Length, IndexFormat.UInt32);
            Mesh.subMeshCount = 1;
            Clear();
        }

        public void Clear()
        {
            PointCount = 0;
            brush.Clear();
            Show();
        }

        /// <summary>Appends the points of a view from number `first` on.</summary>
        public void Append(CurveSetView points, int first)
        {
            FlgBrushMeshSizes added = brush.Append(points, first, vertices, indices);
            ReadOnlySpan<Vector3> positions = points.Column<Vector3>(FlgAttribute.Position);
            ReadOnlySpan<float> radii = points.Floats(FlgAttribute.Radius);
            for (int i = first; i < positions.Length; ++i) Include(Handedness.Turn(positions[i]), radii[i]);
            if (added.vertex_count == 0) return;
            int vertex = (int)added.first_vertex, index = (int)added.first_index;
            Mesh.SetVertexBufferData(vertices, vertex, vertex, (int)added.vertex_count, 0, Trusting);
            Mesh.SetIndexBufferData(indices, index, index, (int)added.index_count, Trusting);
            Show();
        }

        void Include(Vector3 place, float radius)
        {
            var around = new Bounds(place, new Vector3(2 * radius, 2 * radius, 2 * radius));
            if (PointCount++ == 0) bounds = around;
            else bounds.Encapsulate(around);
        }

        void Show()
        {
            var part = new SubMeshDescriptor(0, brush.IndexCount);
            part.vertexCount = brush.VertexCount;
            part.bounds = bounds;
            Mesh.SetSubMesh(0, part, Trusting);
            Mesh.bounds = bounds;
        }
    }
}
