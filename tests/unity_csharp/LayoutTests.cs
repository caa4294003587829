// SPDX-License-Identifier: MIT
// The binding's structs are those of C: each size and offset, and nothing that a call would have to marshal.
using System;
using System.IO;
using System.Runtime.InteropServices;

namespace Filigree.Tests
{
    static class LayoutTests
    {
        internal static void EqualsThatOfC(string listingOfC)
        {
            var listing = new StringWriter { NewLine = "\n" };
            AbiLayout.List(listing);
            string[] found = listing.ToString().Split('\n'), expected = File.ReadAllText(listingOfC).Split('\n');
            for (int i = 0; i < Math.Min(found.Length, expected.Length); ++i)
            {
                Expect.Equal(expected[i], found[i], "C's layout and C#'s");
            }
            Expect.Equal(expected.Length, found.Length, "lines of the layout");

            int blittable = 0;
            foreach (Type type in typeof(FlgContext).Assembly.GetTypes())
            {
                if (!type.IsValueType || type.IsEnum || !type.IsPublic || !type.Name.StartsWith("Flg")) continue;
                GCHandle.Alloc(Activator.CreateInstance(type), GCHandleType.Pinned).Free(); // throws where it isn't
                ++blittable;
            }
            Expect.True(blittable > 100, blittable + " structs are not all");
            Expect.Equal(Native.flgVersionGet(), (uint)Native.FLG_VERSION, "version of library and binding");
        }
    }
}
