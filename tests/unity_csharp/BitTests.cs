// SPDX-License-Identifier: MIT
// Results through the binding are those of a C host, bit for bit. The inputs come from that host, too.
using System;
using System.IO;
using System.Runtime.InteropServices;

namespace Filigree.Tests
{
    static class BitTests
    {
        static readonly FlgAttribute[] columns =
        {
            FlgAttribute.Position, FlgAttribute.Tangent, FlgAttribute.Normal, FlgAttribute.StyleIndex,
        };

        internal static void EqualThoseOfC(string reference)
        {
            using (var file = new BinaryReader(File.OpenRead(reference)))
            using (var context = new FiligreeContext(2))
            {
                Style style = Learn(context, Floats(file));
                Stylize(context, style, file);
                Draw(context, style, file);
                Expect.Equal(file.BaseStream.Length, file.BaseStream.Position, "all of the file is read");
            }
        }

        static Style Learn(FiligreeContext context, float[] example)
        {
            using (CurveSet strokes = CurveSet.Create(context, example))
            {
                FlgStyleDesc desc = Native.flgStyleDefaults();
                desc.point_count = 400;
                return Style.Create(strokes, desc);
            }
        }

        static void Stylize(FiligreeContext context, Style style, BinaryReader file)
        {
            CurveSet target = CurveSet.Create(context, Floats(file), closed: true);
            FlgCurveSetStylizeDesc desc = Native.flgCurveSetStylizeDefaults();
            desc.temperature = 1;
            desc.seed = 7;
            desc.strokes = 3;
            CurveSet result = style.Stylize(target, desc);
            target.Dispose();
            Scenes.Finish(context);
            Compare(file, result.View, "stylized");
            Expect.Equal(3, result.View.CurveCount, "strokes");
            Expect.True(result.View.IsClosed(2), "closed targets give closed results");
        }

        static void Draw(FiligreeContext context, Style style, BinaryReader file)
        {
            byte[] bytes = Block(file);
            LiveSample[] samples = MemoryMarshal.Cast<byte, LiveSample>(new ReadOnlySpan<byte>(bytes)).ToArray();
            style.Warm(0.5f);
            Scenes.Finish(context);
            FlgLiveStrokeDesc desc = Native.flgLiveStrokeDefaults();
            desc.temperature = 0.5f;
            LiveStroke stroke = LiveStroke.TryBegin(style, desc);
            var pushed = new MemoryStream();
            for (int i = 0; i < samples.Length;)
            {
                int count = Math.Min(1 + i % 3, samples.Length - i); // points don't depend on how samples come
                CurveSetView made = stroke.Push(new ReadOnlySpan<LiveSample>(samples, i, count));
                byte[] positions = MemoryMarshal.AsBytes(made.Floats(FlgAttribute.Position)).ToArray();
                pushed.Write(positions, 0, positions.Length);
                i += count;
            }
            ReadOnlySpan<byte> all = MemoryMarshal.AsBytes(stroke.Points.Floats(FlgAttribute.Position));
            Expect.True(all.SequenceEqual(pushed.ToArray()), "what pushes showed is what the stroke has");
            Compare(file, stroke.Points, "drawn");
            CurveSet ended = stroke.End();
            Scenes.Finish(context);
            Compare(file, ended.View, "ended");
            Expect.True(ended.View.PointCount >= stroke.Info.point_count, "the end is part of the result");
        }

        static void Compare(BinaryReader file, CurveSetView found, string what)
        {
            Expect.True(found.PointCount > 300, what + " has points");
            foreach (FlgAttribute column in columns)
            {
                ReadOnlySpan<byte> bytes = MemoryMarshal.AsBytes(found.Floats(column));
                Expect.True(bytes.SequenceEqual(Block(file)), what + ", " + column + ": not the bits of C");
            }
        }

        static byte[] Block(BinaryReader file)
        {
            return file.ReadBytes(checked((int)file.ReadUInt32()));
        }

        static float[] Floats(BinaryReader file)
        {
            return MemoryMarshal.Cast<byte, float>(new ReadOnlySpan<byte>(Block(file))).ToArray();
        }
    }
}
