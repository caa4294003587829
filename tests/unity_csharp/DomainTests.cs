// SPDX-License-Identifier: MIT
// What Unity's Editor does when scripts change: the domain goes, and with it the contexts that nobody disposed of.
using System;
using System.IO;

namespace Filigree.Tests
{
    static class DomainTests
    {
        const int Workers = 16;

        internal static void TakeTheirContextsAlong()
        {
            int before = Threads();
            AppDomain domain = AppDomain.CreateDomain("scripts");
            domain.DoCallBack(LeaveAContextBehind);
            Expect.True(Threads() >= before + Workers, "its " + Workers + " workers live in the other domain");
            AppDomain.Unload(domain);
            Expect.True(Threads() < before + Workers, "its workers are gone with the domain");
        }

        static void LeaveAContextBehind()
        {
            // A running job whose callback is C# of this domain.
            CurveSet example = CurveSet.Create(new FiligreeContext(Workers), Scenes.Coil(2000));
            Style.Create(example, Native.flgStyleDefaults(), null, ended => { });
        }

        // Of the whole process, the runtime's own included.
        static int Threads()
        {
            return Directory.GetDirectories("/proc/self/task").Length;
        }
    }
}
