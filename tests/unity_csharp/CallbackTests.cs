// SPDX-License-Identifier: MIT
// Native code calls C#: when jobs are published, and with messages for the log.
using System;
using System.Collections.Generic;
using System.Threading;

namespace Filigree.Tests
{
    static class CallbackTests
    {
        internal static void Run()
        {
            JobsCallBackOnceInsideOfTick();
            ExceptionsComeOutOfTick();
            JobsThatAreCutOffStaySilent();
            TheLogGetsSentences();
        }

        static void JobsCallBackOnceInsideOfTick()
        {
            var results = new List<FlgResult>();
            int thread = 0;
            using (var context = new FiligreeContext(2))
            {
                Style style = Scenes.Style(context);
                CurveSet target = CurveSet.Create(context, Scenes.Line);
                CurveSet result = style.Stylize(target, Native.flgCurveSetStylizeDefaults(), ended =>
                {
                    results.Add(ended);
                    thread = Thread.CurrentThread.ManagedThreadId;
                });
                while (results.Count == 0)
                {
                    context.Wait(10000); // done, perhaps, but not published
                    Expect.True(!result.IsReady, "nothing changes outside of Tick");
                    context.Tick(FiligreeContext.Unlimited);
                }
                Expect.True(result.IsReady, "called back when it is there");
                Scenes.Finish(context);
                Expect.Equal(1, results.Count, "calls");
                Expect.Equal(FlgResult.Ok, results[0], "its result");
                Expect.Equal(Thread.CurrentThread.ManagedThreadId, thread, "the thread that ticks");

                FlgCurveSetStylizeDesc wrong = Native.flgCurveSetStylizeDefaults();
                wrong.scale = -1;
                Expect.Throws<FiligreeException>(() => style.Stylize(target, wrong, results.Add), "a wrong descriptor");
                Scenes.Finish(context);
                Expect.Equal(1, results.Count, "calls, with a job that was refused");
            }
        }

        static void ExceptionsComeOutOfTick()
        {
            using (var context = new FiligreeContext(0))
            {
                Style style = Scenes.Style(context);
                CurveSet target = CurveSet.Create(context, Scenes.Line);
                int calls = 0;
                FlgCurveSetStylizeDesc desc = Native.flgCurveSetStylizeDefaults();
                style.Stylize(target, desc, ended => { throw new Exception("the game's own"); });
                style.Stylize(target, desc, ended => ++calls);
                var thrown = Expect.Throws<InvalidOperationException>(
                    () => context.Tick(FiligreeContext.Unlimited), "a callback that throws");
                Expect.Equal("the game's own", thrown.InnerException.Message, "what it threw");
                Expect.Equal(1, calls, "the other is called all the same");
                context.Tick(FiligreeContext.Unlimited);
            }
        }

        static void JobsThatAreCutOffStaySilent()
        {
            int calls = 0;
            using (var context = new FiligreeContext(1))
            using (CurveSet example = CurveSet.Create(context, Scenes.Coil(2000)))
            {
                Style.Create(example, Native.flgStyleDefaults(), null, ended => ++calls);
            }
            GC.Collect();
            Expect.Equal(0, calls, "calls");
        }

        static void TheLogGetsSentences()
        {
            var messages = new List<string>();
            using (var context = new FiligreeContext(0, 0, (level, message) => messages.Add(level + ": " + message)))
            {
                FlgCurveSetStylizeDesc desc = Native.flgCurveSetStylizeDefaults();
                desc.frame = FlgFrameMethod.Supplied;
                Scenes.Style(context).Stylize(CurveSet.Create(context, Scenes.Line), desc);
                Scenes.Finish(context);
            }
            Expect.Equal(1, messages.Count, "messages");
            Expect.Contains("Error: job", messages[0], "level and sentence");
            Expect.Contains("NORMAL", messages[0], "what is missing");
        }
    }
}
