// SPDX-License-Identifier: MIT
// What tests say.
using System;

namespace Filigree.Tests
{
    static class Expect
    {
        internal static void True(bool holds, string what)
        {
            if (!holds) throw new Exception(what);
        }

        internal static void Equal<T>(T expected, T found, string what)
        {
            if (!Equals(expected, found)) throw new Exception(what + ": " + found + ", but it has to be " + expected);
        }

        internal static void Contains(string part, string whole, string what)
        {
            bool holds = whole != null && whole.Contains(part);
            True(holds, what + ": \"" + whole + "\" does not speak of \"" + part + "\"");
        }

        internal static T Throws<T>(Action action, string what) where T : Exception
        {
            try
            {
                action();
            }
            catch (T expected)
            {
                return expected;
            }
            throw new Exception(what + ": no " + typeof(T).Name);
        }
    }
}
