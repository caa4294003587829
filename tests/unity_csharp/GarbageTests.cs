// SPDX-License-Identifier: MIT
// A game's frames: a stroke is drawn, curves are stylized over and over, results go into a mesh array that is used
// again and again. None of it makes garbage.
using System;
using System.Runtime.InteropServices;
using UnityEngine;

namespace Filigree.Tests
{
    static unsafe class GarbageTests
    {
        const int WarmUp = 60;
        const int Frames = 600;

        internal static void ThereIsNone()
        {
            Garbage.ProveTheCounter();
            foreach (int workers in new[] { 0, 1 })
            {
                using (var game = new Game(workers))
                {
                    game.Run(0, WarmUp);
                    int jobs = game.FinishedJobs, points = game.StrokePoints;
                    long bytes = Garbage.Of(() => game.Run(WarmUp, WarmUp + Frames));
                    jobs = game.FinishedJobs - jobs;
                    points = game.StrokePoints - points;
                    Console.WriteLine(workers + " workers, " + Frames + " frames: " + bytes + " bytes of garbage, " +
                        points + " points drawn, " + jobs + " jobs of " + game.ResultPoints + " points");
                    Expect.True(game.TipPoints > Frames, "there were tips");
                    Expect.True(points > Frames && jobs > 2 && game.ResultPoints > 1000, "the frames had work to do");
                    Expect.Equal(0L, bytes, "bytes of garbage in " + Frames + " frames");
                    // The control: the same frames, each with one object too many, are told apart.
                    game.Litter = true;
                    bytes = Garbage.Of(() => game.Run(WarmUp + Frames, WarmUp + 2 * Frames));
                    Expect.True(bytes >= Frames * 16, "an object a frame counts as " + bytes + " bytes");
                    Expect.True(game.LastLitter != null, "litter");
                }
            }
        }

        sealed class Game : IDisposable
        {
            readonly FiligreeContext context;
            readonly Style style;
            readonly CurveSet target;
            readonly LiveStroke stroke;
            readonly float[] strokeMesh = new float[3 * 65536];
            readonly float[] resultMesh = new float[3 * 65536];
            FlgCurveSetStylizeDesc again;
            FlgCurveSet running;
            internal object LastLitter;

            internal bool Litter;
            internal int StrokePoints, TipPoints, FinishedJobs, ResultPoints;

            internal Game(int workers)
            {
                context = new FiligreeContext(workers);
                style = Scenes.Style(context);
                style.Warm(0);
                target = CurveSet.Create(context, Scenes.Line);
                Scenes.Finish(context);
                FlgLiveStrokeDesc desc = Native.flgLiveStrokeDefaults();
                stroke = LiveStroke.TryBegin(style, desc);
                again = Native.flgCurveSetStylizeDefaults();
                again.style = style.Handle;
                again.target = target.Handle;
                again.strokes = 20;
                Start();
            }

            internal void Run(int begin, int end)
            {
                for (int frame = begin; frame < end; ++frame)
                {
                    bool patient = frame % 100 == 0; // however slow the machine is, some jobs finish
                    context.Tick(patient ? 0 : 200);
                    Draw(frame);
                    Show();
                    if (Litter) LastLitter = new object();
                    context.Wait(patient ? 60000000 : 200); // the rest of the frame
                }
            }

            void Draw(int frame)
            {
                CurveSetView made = stroke.Push(Scenes.Hand(frame));
                var room = new Span<float>(strokeMesh, 3 * StrokePoints, 3 * made.PointCount);
                made.Write(FlgAttribute.Position, FlgNumberFormat.Float32, MemoryMarshal.Cast<float, Vector3>(room));
                StrokePoints += made.PointCount;
                TipPoints += stroke.Tip.PointCount;
            }

            // Jobs by the functions of Native, whose handles are values: starting one makes no garbage either.
            void Start()
            {
                fixed (FlgCurveSetStylizeDesc* desc = &again)
                fixed (FlgCurveSet* made = &running)
                {
                    FiligreeException.Check(Native.flgCurveSetStylize(context.Handle, desc, made, null));
                }
                ++again.seed;
            }

            void Show()
            {
                var view = new FlgCurveSetView { struct_size = (uint)sizeof(FlgCurveSetView) };
                FlgResult result = Native.flgCurveSetGetView(context.Handle, running, &view);
                if (FiligreeException.Check(result) == FlgResult.NotReady) return;
                ResultPoints = (int)view.curve_offsets[view.curve_count];
                Marshal.Copy((IntPtr)view.columns[0].data, resultMesh, 0, 3 * ResultPoints);
                FiligreeException.Check(Native.flgCurveSetRelease(context.Handle, running));
                ++FinishedJobs;
                Start();
            }

            public void Dispose()
            {
                context.Dispose();
            }
        }
    }
}
