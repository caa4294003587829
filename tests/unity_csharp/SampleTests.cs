// SPDX-License-Identifier: MIT
// The sample's components, run as Unity runs them: Awake, Update each frame, OnDestroy.
using System;
using System.Reflection;
using Filigree.Samples;
using UnityEngine;

namespace Filigree.Tests
{
    static class SampleTests
    {
        const int Frames = 400;

        internal static void Run()
        {
            Garbage.ProveTheCounter();
            var runner = new FiligreeRunner();
            var stroke = new StylizedStroke { runner = runner, hand = new Transform(), example = Example() };
            stroke.transform.position = new Vector3(5, 0, 0);
            Call(runner, "Awake")();
            Call(stroke, "Awake")();
            Mesh mesh = stroke.GetComponent<MeshFilter>().sharedMesh;
            Action tick = Call(runner, "Update"), update = Call(stroke, "Update");

            stroke.Drawing = true;
            Frame(stroke, 0, tick, update);
            Expect.Equal(0, mesh.Part.vertexCount, "vertices while the style is in the making");
            Scenes.Finish(runner.Context);
            const int frame = 100;
            Draw(stroke, 1, frame, tick, update);
            int before = mesh.Part.vertexCount;
            long garbage = Garbage.Of(() => Draw(stroke, frame, frame + Frames, tick, update));
            Expect.True(mesh.Part.vertexCount > before + 8 * Frames, "the stroke grew");
            Expect.Equal(0L, garbage, "bytes of garbage in " + Frames + " frames");
            Expect.True(mesh.UploadedBytes <= 24L * (mesh.Part.vertexCount + 8 * (frame + Frames)),
                mesh.UploadedBytes + " bytes uploaded: each vertex once, and a ring a frame again");

            stroke.Drawing = false;
            while (stroke.Finished == null) Frame(stroke, frame + Frames, tick, update);
            IsTheStylizedCurve(mesh, stroke.Finished.View);
            FacesOutwards(mesh);

            stroke.temperature = 2; // in the inspector, say: the next stroke waits for what that needs
            stroke.Drawing = true;
            Frame(stroke, 0, tick, update);
            Expect.True(stroke.Finished == null, "another stroke takes the place of the first");
            Scenes.Finish(runner.Context);
            Draw(stroke, 0, 50, tick, update);
            Expect.True(mesh.Part.vertexCount > 0, "and is drawn");
            Call(runner, "OnDestroy")(); // in any order
            Call(stroke, "OnDestroy")();
            Expect.True(mesh.Destroyed && runner.Context.IsDisposed, "nothing is left");
            RotationsTurnWithPlaces();
        }

        static Vector3[] Example()
        {
            float[] coil = Scenes.Coil(300);
            var example = new Vector3[300];
            for (int i = 0; i < 300; ++i) example[i] = new Vector3(coil[3 * i], coil[3 * i + 1], coil[3 * i + 2]);
            return example;
        }

        static Action Call(MonoBehaviour component, string message)
        {
            MethodInfo method = component.GetType().GetMethod(message, BindingFlags.Instance | BindingFlags.NonPublic);
            return (Action)Delegate.CreateDelegate(typeof(Action), component, method);
        }

        static void Draw(StylizedStroke stroke, int begin, int end, Action tick, Action update)
        {
            for (int frame = begin; frame < end; ++frame) Frame(stroke, frame, tick, update);
        }

        static void Frame(StylizedStroke stroke, int frame, Action tick, Action update)
        {
            double angle = 0.02 * frame;
            Vector3 local = new Vector3((float)Math.Cos(angle), 0.001f * frame, (float)Math.Sin(angle));
            stroke.hand.position = local + stroke.transform.position;
            Time.timeAsDouble = frame / 90.0;
            tick();
            update();
        }

        static Vector3 Position(Mesh mesh, int vertex)
        {
            ReadOnlySpan<float> v = mesh.Vertices.Slice(6 * vertex, 3);
            return new Vector3(v[0], v[1], v[2]);
        }

        static Vector3 Normal(Mesh mesh, int vertex)
        {
            ReadOnlySpan<float> v = mesh.Vertices.Slice(6 * vertex + 3, 3);
            return new Vector3(v[0], v[1], v[2]);
        }

        static void IsTheStylizedCurve(Mesh mesh, CurveSetView curve)
        {
            Expect.Equal(8 * curve.PointCount, mesh.Part.vertexCount, "a ring of eight for each point, to the last");
            for (int i = 0; i < curve.PointCount; ++i)
            {
                var sum = new Vector3();
                for (int k = 0; k < 8; ++k) sum += Position(mesh, 8 * i + k);
                Vector3 centre = sum * 0.125f, point = curve.Column<Vector3>(FlgAttribute.Position)[i];
                Vector3 off = centre - new Vector3(point.x, point.y, -point.z);
                Expect.True(Vector3.Dot(off, off) < 1e-10f, "the ring of point " + i + " is around it");
                Vector3 out0 = Position(mesh, 8 * i) - centre;
                float radius = curve.Floats(FlgAttribute.Radius)[i];
                Expect.True(Math.Abs(Vector3.Dot(out0, out0) - radius * radius) < 1e-7f, "its radius is the curve's");
                Inside(mesh.bounds, Position(mesh, 8 * i));
            }
        }

        static void Inside(Bounds bounds, Vector3 p)
        {
            const float rounding = 1e-5f;
            Vector3 a = p - bounds.min, b = bounds.max - p;
            Expect.True(Math.Min(Math.Min(a.x, a.y), Math.Min(a.z, Math.Min(b.x, Math.Min(b.y, b.z)))) > -rounding,
                "bounds hold all vertices");
        }

        // Unity's front faces are those whose cross product of edges, by its coordinates, points at the viewer.
        static void FacesOutwards(Mesh mesh)
        {
            int triangles = mesh.Part.indexCount / 3, outwards = 0;
            for (int t = 0; t < triangles; ++t)
            {
                int a = mesh.Indices[3 * t], b = mesh.Indices[3 * t + 1], c = mesh.Indices[3 * t + 2];
                Expect.True(Math.Max(a, Math.Max(b, c)) < mesh.Part.vertexCount, "triangles of what is there");
                Vector3 first = Position(mesh, b) - Position(mesh, a), second = Position(mesh, c) - Position(mesh, a);
                if (Vector3.Dot(Vector3.Cross(first, second), Normal(mesh, a)) > 0) ++outwards;
            }
            // Where the curve bends more tightly than the tube is thick rings cut through each other.
            Expect.True(outwards > 0.98 * triangles, outwards + " of " + triangles + " triangles face outwards");
        }

        static void RotationsTurnWithPlaces()
        {
            var rotation = new Quaternion(0.1f, 0.7f, -0.1f, 0.7f);
            var place = new Vector3(1, 2, 3);
            Vector3 there = Handedness.Turn(rotation * place);
            Vector3 here = Handedness.Turn(rotation) * Handedness.Turn(place);
            Vector3 off = there - here;
            Expect.True(Vector3.Dot(off, off) < 1e-10f, "turned rotations turn turned places");
        }
    }
}
