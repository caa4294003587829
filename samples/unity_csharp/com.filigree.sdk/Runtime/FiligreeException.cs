// SPDX-License-Identifier: MIT
// Results that say no become exceptions whose message is the SDK's own sentence.
using System;
using System.Text;

namespace Filigree
{
    /// <summary>A call or a job failed. The message names the argument and its value.</summary>
    public sealed class FiligreeException : Exception
    {
        public FlgResult Result { get; }

        public FiligreeException(FlgResult result, string sentence) : base(sentence)
        {
            Result = result;
        }

        /// <summary>Throws if the call failed. NotReady is no failure: the caller decides.</summary>
        public static FlgResult Check(FlgResult result)
        {
            if (result < 0) throw Last(result);
            return result;
        }

        internal static unsafe FiligreeException Last(FlgResult result)
        {
            return new FiligreeException(result, ToString(Native.flgErrorGetMessage()));
        }

        /// <summary>UTF-8 from the SDK as a string, which allocates; null stays null.</summary>
        internal static unsafe string ToString(byte* text)
        {
            if (text == null) return null;
            int length = 0;
            while (text[length] != 0) ++length;
            return length == 0 ? "" : Encoding.UTF8.GetString(text, length);
        }
    }
}
