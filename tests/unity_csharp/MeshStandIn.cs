// SPDX-License-Identifier: MIT
// Unity's Mesh with its signatures of 2021.3, as far as the sample uses it. It keeps what is uploaded, and counts.
using System;
using System.Runtime.InteropServices;
using UnityEngine.Rendering;

namespace UnityEngine.Rendering
{
    public enum VertexAttribute { Position, Normal }
    public enum VertexAttributeFormat { Float32 }
    public enum IndexFormat { UInt16, UInt32 }
    public enum MeshTopology { Triangles }

    [Flags]
    public enum MeshUpdateFlags { DontValidateIndices = 1, DontResetBoneBounds = 2, DontRecalculateBounds = 8 }

    public struct VertexAttributeDescriptor
    {
        public int dimension { get; set; }

        public VertexAttributeDescriptor(VertexAttribute attribute, VertexAttributeFormat format, int dimension)
        {
            this.dimension = dimension;
        }
    }

    public struct SubMeshDescriptor
    {
        public Bounds bounds { get; set; }
        public int indexCount { get; set; }
        public int vertexCount { get; set; }

        public SubMeshDescriptor(int indexStart, int indexCount, MeshTopology topology = MeshTopology.Triangles)
        {
            this.indexCount = indexCount;
            bounds = default(Bounds);
            vertexCount = 0;
        }
    }
}

namespace UnityEngine
{
    public class Mesh : Object
    {
        byte[] vertices;
        int[] indices;
        int stride;

        public int subMeshCount { get; set; }
        public Bounds bounds { get; set; }
        public SubMeshDescriptor Part { get; private set; }
        public long UploadedBytes { get; private set; }
        public ReadOnlySpan<int> Indices => indices;

        /// <summary>What was uploaded, as floats of position and normal.</summary>
        public ReadOnlySpan<float> Vertices => MemoryMarshal.Cast<byte, float>(new ReadOnlySpan<byte>(vertices));

        public void MarkDynamic() { }

        public void SetVertexBufferParams(int vertexCount, params VertexAttributeDescriptor[] attributes)
        {
            stride = 0;
            foreach (VertexAttributeDescriptor attribute in attributes) stride += 4 * attribute.dimension;
            vertices = new byte[stride * vertexCount];
        }

        public void SetIndexBufferParams(int indexCount, IndexFormat format)
        {
            if (format != IndexFormat.UInt32) throw new ArgumentException("indices here have 32 bits");
            indices = new int[indexCount];
        }

        public void SetVertexBufferData<T>(T[] data, int dataStart, int meshBufferStart, int count, int stream = 0,
            MeshUpdateFlags flags = 0) where T : struct
        {
            ReadOnlySpan<byte> bytes = MemoryMarshal.AsBytes(new ReadOnlySpan<T>(data, dataStart, count));
            if (bytes.Length != count * stride) throw new ArgumentException("another vertex than the mesh has");
            bytes.CopyTo(new Span<byte>(vertices, meshBufferStart * stride, bytes.Length));
            UploadedBytes += bytes.Length;
        }

        public void SetIndexBufferData<T>(T[] data, int dataStart, int meshBufferStart, int count,
            MeshUpdateFlags flags = 0) where T : struct
        {
            ReadOnlySpan<int> from = MemoryMarshal.Cast<T, int>(new ReadOnlySpan<T>(data, dataStart, count));
            from.CopyTo(new Span<int>(indices, meshBufferStart, from.Length));
        }

        public void SetSubMesh(int index, SubMeshDescriptor desc, MeshUpdateFlags flags = 0)
        {
            if (index >= subMeshCount) throw new IndexOutOfRangeException("no such part of the mesh");
            Part = desc;
        }
    }
}
