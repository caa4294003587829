// SPDX-License-Identifier: MIT
// How much managed memory was asked for.
using System;

namespace Filigree.Tests
{
    static class Garbage
    {
        static object kept;

        /// <summary>Bytes that a piece of work allocates on this thread.</summary>
        internal static long Of(Action work)
        {
            int collections = GC.CollectionCount(0);
            long before = GC.GetAllocatedBytesForCurrentThread();
            work();
            long bytes = GC.GetAllocatedBytesForCurrentThread() - before;
            Expect.True(bytes > 0 || collections == GC.CollectionCount(0), "who collects garbage where there is none?");
            return bytes;
        }

        /// <summary>That the runtime counts at all, down to one object.</summary>
        internal static void ProveTheCounter()
        {
            Of(() => { });
            Expect.Equal(0L, Of(() => { }), "bytes of nothing");
            Expect.True(Of(() => kept = new object()) > 0, "an object counts");
            long bytes = Of(() => kept = new byte[1000]);
            Expect.True(bytes >= 1000 && bytes < 1100 && kept != null, "an array of 1000 bytes counts as " + bytes);
        }
    }
}
