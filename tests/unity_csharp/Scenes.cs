// SPDX-License-Identifier: MIT
// What the tests draw.
using System;

namespace Filigree.Tests
{
    static class Scenes
    {
        internal static float[] Coil(int points)
        {
            var numbers = new float[3 * points];
            for (int i = 0; i < points; ++i)
            {
                numbers[3 * i] = 0.01f * i;
                numbers[3 * i + 1] = 0.1f * (float)Math.Cos(0.2 * i);
                numbers[3 * i + 2] = 0.1f * (float)Math.Sin(0.2 * i);
            }
            return numbers;
        }

        internal static readonly float[] Line = { 0, 0, 0, 5, 1, 0, 10, 0, 2 };

        /// <summary>Where the hand is in a frame at 90 Hz: on a slow circle, 5 cm a frame or less.</summary>
        internal static LiveSample Hand(int frame)
        {
            double angle = 0.02 * frame;
            float x = (float)Math.Cos(angle), z = (float)Math.Sin(angle);
            float pressure = 0.5f + 0.5f * (float)Math.Sin(0.1 * frame);
            return new LiveSample(x, 0.001f * frame, z, pressure, frame / 90.0);
        }

        internal static Style Style(FiligreeContext context)
        {
            using (CurveSet example = CurveSet.Create(context, Coil(300))) return Filigree.Style.Create(example);
        }

        internal static void Finish(FiligreeContext context)
        {
            do
            {
                context.Wait(10000);
                context.Tick(FiligreeContext.Unlimited);
            } while (context.Report.jobs_pending > 0);
        }
    }
}
