// SPDX-License-Identifier: MIT
// Types of filigree_model.h. Written by tools/abi/generate from sdk/api/abi.json: change the header.

using System;

namespace Filigree
{
    /// <summary>What a host or its user sets about a joint.</summary>
    public enum FlgJointEditKind
    {
        /// <summary>
        /// FLG_JOINT_EDIT_KIND_PIN: the joint stays at `at`, also if that moves it, and is never refined away; one that
        /// is not there is made on the nearest bone of its part
        /// </summary>
        Pin = 0,
        /// <summary>
        /// FLG_JOINT_EDIT_KIND_SPLIT: a new joint, with `name` as its key, on the bone from its parent, at `share`
        /// </summary>
        Split = 1,
        /// <summary>FLG_JOINT_EDIT_KIND_MERGE: the joint becomes one with its parent, which stays where it is</summary>
        Merge = 2,
        /// <summary>FLG_JOINT_EDIT_KIND_RENAME: the joint is called `name`; its key stays</summary>
        Rename = 3,
    }

    /// <summary>How a part was attached to the model.</summary>
    public enum FlgPartEvent
    {
        /// <summary>FLG_PART_EVENT_ROOT: meets no earlier part</summary>
        Root = 0,
        /// <summary>FLG_PART_EVENT_BONE_SPLIT: a new joint on a bone of its parent part</summary>
        BoneSplit = 1,
        /// <summary>FLG_PART_EVENT_JOINT_CONNECT: a bone from one of its parent part's joints</summary>
        JointConnect = 2,
    }

    /// <summary>How a vertex follows several joints.</summary>
    public enum FlgSkinning
    {
        /// <summary>
        /// FLG_SKINNING_LINEAR: the mean of the positions each joint gives: thins out where joints twist
        /// </summary>
        Linear = 0,
        /// <summary>
        /// FLG_SKINNING_DUAL_QUATERNION: one rigid motion between the joints': keeps the girth, bulges a little in
        /// sharp bends
        /// </summary>
        DualQuaternion = 1,
    }

    /// <summary>A surface's silhouette from afar, as a contour. Never changes once ready.</summary>
    public partial struct FlgOutline : IEquatable<FlgOutline>
    {
        public ulong id;
        public bool IsNull => id == 0;
        public bool Equals(FlgOutline other) => id == other.id;
        public override bool Equals(object other) => other is FlgOutline handle && Equals(handle);
        public override int GetHashCode() => id.GetHashCode();
    }

    /// <summary>A drawn contour with its axis. Never changes once ready.</summary>
    public partial struct FlgPart : IEquatable<FlgPart>
    {
        public ulong id;
        public bool IsNull => id == 0;
        public bool Equals(FlgPart other) => id == other.id;
        public override bool Equals(object other) => other is FlgPart handle && Equals(handle);
        public override int GetHashCode() => id.GetHashCode();
    }

    /// <summary>A part's own inflated surface. Never changes once ready.</summary>
    public partial struct FlgPartMesh : IEquatable<FlgPartMesh>
    {
        public ulong id;
        public bool IsNull => id == 0;
        public bool Equals(FlgPartMesh other) => id == other.id;
        public override bool Equals(object other) => other is FlgPartMesh handle && Equals(handle);
        public override int GetHashCode() => id.GetHashCode();
    }

    /// <summary>Parts in their places and one tree of joints. Never changes once ready.</summary>
    public partial struct FlgModel : IEquatable<FlgModel>
    {
        public ulong id;
        public bool IsNull => id == 0;
        public bool Equals(FlgModel other) => id == other.id;
        public override bool Equals(object other) => other is FlgModel handle && Equals(handle);
        public override int GetHashCode() => id.GetHashCode();
    }

    /// <summary>A model's surface, bound to its joints. Never changes once ready.</summary>
    public partial struct FlgSkin : IEquatable<FlgSkin>
    {
        public ulong id;
        public bool IsNull => id == 0;
        public bool Equals(FlgSkin other) => id == other.id;
        public override bool Equals(object other) => other is FlgSkin handle && Equals(handle);
        public override int GetHashCode() => id.GetHashCode();
    }
}
