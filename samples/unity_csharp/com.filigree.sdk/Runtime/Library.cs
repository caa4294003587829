// SPDX-License-Identifier: MIT
// Where the native functions are. Players that link plugins into the program have them in the program itself.
namespace Filigree
{
    static class Library
    {
#if (UNITY_IOS || UNITY_TVOS || UNITY_VISIONOS || UNITY_WEBGL) && !UNITY_EDITOR
        internal const string Filigree = "__Internal";
        internal const string Io = "__Internal";
        internal const string Pick = "__Internal";
#else
        internal const string Filigree = "filigree";
        internal const string Io = "filigree_io";
        internal const string Pick = "filigree_pick";
#endif
    }
}
