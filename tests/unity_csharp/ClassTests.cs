// SPDX-License-Identifier: MIT
// What the classes add to the ABI: styles as bytes, strokes taken back and taken up again, columns as structs.
using System;
using System.Runtime.InteropServices;
using UnityEngine;

namespace Filigree.Tests
{
    static unsafe class ClassTests
    {
        internal static void Run()
        {
            using (var context = new FiligreeContext(1))
            {
                Style style = Scenes.Style(context);
                style.Warm(0);
                Scenes.Finish(context);
                SavedStylesAreTheSame(context, style);
                StrokesGoBackAndForth(context, style);
                ColumnsAreWhatTheySay(context, style);
            }
        }

        static byte[] Bytes(CurveSetView view)
        {
            return MemoryMarshal.AsBytes(view.Floats(FlgAttribute.Position)).ToArray();
        }

        static void SavedStylesAreTheSame(FiligreeContext context, Style style)
        {
            Style loaded = Style.Load(context, style.Save());
            Expect.True(loaded.IsReady && !loaded.Job.Exists, "ready at once");
            Expect.Equal(style.Info.point_count, loaded.Info.point_count, "its points");
            CurveSet target = CurveSet.Create(context, Scenes.Line);
            CurveSet a = style.Stylize(target), b = loaded.Stylize(target);
            Scenes.Finish(context);
            Expect.True(Bytes(a.View).AsSpan().SequenceEqual(Bytes(b.View)), "the same results, bit for bit");
            Expect.True(a.Job.IsFinished && a.Job.Progress == 1, "its job is over");
            a.Job.ThrowIfFailed();
        }

        static void StrokesGoBackAndForth(FiligreeContext context, Style style)
        {
            LiveStroke stroke = LiveStroke.TryBegin(style, Native.flgLiveStrokeDefaults());
            for (int frame = 0; frame < 100; ++frame) stroke.Push(Scenes.Hand(frame));
            byte[] points = Bytes(stroke.Points);
            int left = stroke.Undo(30);
            Expect.Equal(left, stroke.Points.PointCount, "points that are left");
            Expect.True(left > 0 && 12 * left < points.Length, left + " points are left");
            for (int frame = 70; frame < 100; ++frame) stroke.Push(Scenes.Hand(frame));
            Expect.True(Bytes(stroke.Points).AsSpan().SequenceEqual(points), "the same stroke again");

            CurveSet ended = stroke.End();
            Expect.True(!stroke.Resume(), "the job still reads it");
            Scenes.Finish(context);
            Expect.True(Bytes(ended.View).AsSpan(0, points.Length).SequenceEqual(points), "it begins as it was drawn");
            Expect.True(stroke.Info.ended != 0 && stroke.Resume() && stroke.Info.ended == 0, "it goes on");
            Expect.True(Bytes(stroke.Points).AsSpan().SequenceEqual(points), "as if it had not been ended");
            stroke.Dispose();
        }

        static FlgColumn Column(FlgAttribute attribute, uint components, float* data)
        {
            return new FlgColumn { attribute = attribute, components = components, data = data, stride = 20 };
        }

        struct Vertex
        {
            public float Before;
            public Vector3 Place;
        }

        static void ColumnsAreWhatTheySay(FiligreeContext context, Style style)
        {
            CurveSet made;
            fixed (float* numbers = new float[] { 0, 0, 0, 1, 2, 3, 4, 5, 6, 7 })
            fixed (uint* offsets = new uint[] { 0, 2 })
            {
                FlgColumn* columns = stackalloc FlgColumn[2];
                columns[0] = Column(FlgAttribute.Position, 3, numbers);
                columns[1] = Column(FlgAttribute.User, 2, numbers + 3);
                FlgCurveSetView view = Native.flgCurveSetViewDefaults();
                view.curve_count = 1;
                view.curve_offsets = offsets;
                view.columns = columns;
                view.column_count = 2;
                made = CurveSet.Create(context, view);
            }
            using (CurveSet set = made)
            {
                Expect.Equal(new Vector3(3, 4, 5), set.View.Column<Vector3>(FlgAttribute.Position)[1], "a place");
                Expect.Equal(7f, set.View.Floats(FlgAttribute.User)[3], "the second number of the second point");
                Expect.True(set.View.Has(FlgAttribute.User) && !set.View.Has(FlgAttribute.Color), "what is there");
                Expect.Equal(0, set.View.Column<Vector3>(FlgAttribute.Normal).Length, "a column that isn't");
                Expect.Throws<ArgumentException>(
                    () => { int n = set.View.Column<Quaternion>(FlgAttribute.Position).Length; }, "four of three");
                Expect.Throws<ArgumentOutOfRangeException>(() => set.View.IsClosed(1), "a curve too many");
                Expect.True(!set.View.IsClosed(0) && set.View.Offsets[1] == 2, "an open curve of two points");
                var vertices = new Vertex[2];
                set.View.Write<Vertex>(FlgAttribute.Position, FlgNumberFormat.Float32, vertices, 4);
                Expect.Equal(0f, vertices[1].Before, "what stands before it");
                Expect.Equal(new Vector3(3, 4, -5), vertices[1].Place, "a place in a vertex, for Unity");
                set.View.Write<Vertex>(FlgAttribute.User, FlgNumberFormat.Unorm8, vertices);
                Expect.Equal(3f, vertices[1].Place.x, "what stands beside two bytes");
                Expect.Throws<FiligreeException>(
                    () => set.View.Write<Vertex>(FlgAttribute.Color, FlgNumberFormat.Unorm8, new Vertex[2]), "colours");
                Expect.Throws<FiligreeException>(
                    () => set.View.Write<Vertex>(FlgAttribute.User, FlgNumberFormat.Unorm8, new Vertex[1]), "room");
                Expect.Throws<ArgumentOutOfRangeException>(
                    () => set.View.Write<Vertex>(FlgAttribute.Position, FlgNumberFormat.Float32, new Vertex[2], 16),
                    "beyond a vertex");
            }
        }
    }
}
