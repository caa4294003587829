// SPDX-License-Identifier: MIT
// A tube that grows: a ring of vertices a point, in arrays that are made once. What is appended is uploaded, and
// nothing else is, as points of a live stroke never move.
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

        readonly int sides;
        readonly int maxPoints;
        readonly Vertex[] vertices;
        readonly float[] cosines, sines;
        Bounds bounds;

        public Mesh Mesh { get; }
        public int PointCount { get; private set; }

        public StrokeMesh(int maxPoints, int sides)
        {
            this.sides = sides;
            this.maxPoints = maxPoints;
            vertices = new Vertex[maxPoints * sides];
            cosines = new float[sides];
            sines = new float[sides];
            for (int k = 0; k < sides; ++k)
            {
                cosines[k] = (float)Math.Cos(2 * Math.PI * k / sides);
                sines[k] = (float)Math.Sin(2 * Math.PI * k / sides);
            }

            Mesh = new Mesh { name = "Stylized stroke" };
            Mesh.MarkDynamic();
            Mesh.SetVertexBufferParams(vertices.Length,
                new VertexAttributeDescriptor(VertexAttribute.Position, VertexAttributeFormat.Float32, 3),
                new VertexAttributeDescriptor(VertexAttribute.Normal, VertexAttributeFormat.Float32, 3));
            int[] indices = Indices();
            Mesh.SetIndexBufferParams(indices.Length, IndexFormat.UInt32);
            Mesh.SetIndexBufferData(indices, 0, 0, indices.Length, Trusting);
            Mesh.subMeshCount = 1;
            Clear();
        }

        public void Clear()
        {
            PointCount = 0;
            Show();
        }

        /// <summary>Appends the points of a view from number `first` on, as far as there is room.</summary>
        public void Append(CurveSetView points, int first)
        {
            ReadOnlySpan<Vector3> positions = points.Column<Vector3>(FlgAttribute.Position);
            ReadOnlySpan<Vector3> tangents = points.Column<Vector3>(FlgAttribute.Tangent);
            ReadOnlySpan<Vector3> normals = points.Column<Vector3>(FlgAttribute.Normal);
            ReadOnlySpan<float> radii = points.Floats(FlgAttribute.Radius);
            int count = Math.Min(positions.Length - first, maxPoints - PointCount);
            if (count <= 0) return;

            int begin = PointCount * sides;
            int vertex = begin;
            for (int i = first; i < first + count; ++i)
            {
                Vector3 across = normals[i];
                Vector3 up = Vector3.Cross(tangents[i], across);
                for (int k = 0; k < sides; ++k, ++vertex)
                {
                    Vector3 outwards = across * cosines[k] + up * sines[k];
                    vertices[vertex].Position = Handedness.Turn(positions[i] + outwards * radii[i]);
                    vertices[vertex].Normal = Handedness.Turn(outwards);
                }
                Include(Handedness.Turn(positions[i]), radii[i]);
                ++PointCount;
            }
            Mesh.SetVertexBufferData(vertices, begin, begin, count * sides, 0, Trusting);
            Show();
        }

        void Include(Vector3 place, float radius)
        {
            var around = new Bounds(place, new Vector3(2 * radius, 2 * radius, 2 * radius));
            if (PointCount == 0) bounds = around;
            else bounds.Encapsulate(around);
        }

        void Show()
        {
            int pieces = Math.Max(PointCount - 1, 0);
            var part = new SubMeshDescriptor(0, pieces * sides * 6);
            part.vertexCount = PointCount * sides;
            part.bounds = bounds;
            Mesh.SetSubMesh(0, part, Trusting);
            Mesh.bounds = bounds;
        }

        // Two triangles a side, clockwise seen from outside, as Unity wants them.
        int[] Indices()
        {
            var indices = new int[(maxPoints - 1) * sides * 6];
            int at = 0;
            for (int i = 0; i + 1 < maxPoints; ++i)
            {
                for (int k = 0; k < sides; ++k)
                {
                    int a = i * sides + k, b = i * sides + (k + 1) % sides;
                    int c = a + sides, d = b + sides;
                    indices[at++] = a;
                    indices[at++] = d;
                    indices[at++] = b;
                    indices[at++] = a;
                    indices[at++] = c;
                    indices[at++] = d;
                }
            }
            return indices;
        }
    }
}
