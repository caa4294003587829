// SPDX-License-Identifier: MIT
// Functions of filigree_pick.h. Written by tools/abi/generate from sdk/api/abi.json: change the header.
//
// Picking on surfaces and curves, with Embree, in a library of its own (filigree_pick) that hosts may leave out. It
// follows the grammar of filigree.h but needs no context: a scene copies what it is shown.
//
// Threads   Functions that change a scene must not overlap with any other on it, and no query may run from a change to
//           the
//           commit after it; queries may run side by side on any threads.
// Brushes   What lies within a geodesic radius of a hit is a field: flgGeodesic from the hit's triangle, u and v, with
//           max_distance.
// Waiting   Setting up a surface of 2 million triangles takes seconds: call it where your engine loads assets. After a
//           cut only what changed is taken in: well below a millisecond for each thousand changed triangles.

using System;
using System.Runtime.InteropServices;

namespace Filigree
{
    public static unsafe partial class Native
    {
        /// <summary>[any thread] As flgLastError, for the functions of this header.</summary>
        [DllImport(Library.Pick, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern byte* flgPickLastError();

        [DllImport(Library.Pick, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgPickSceneDescInit(FlgPickSceneDesc* desc, uint struct_size);

        /// <summary>`desc` may be null: all defaults. Cost: 0.2 to 1 ms.</summary>
        [DllImport(Library.Pick, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgPickSceneCreate(FlgPickSceneDesc* desc, FlgPickScene* out_scene);

        /// <summary>Null is allowed.</summary>
        [DllImport(Library.Pick, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern void flgPickSceneDestroy(FlgPickScene scene);

        /// <summary>
        /// Puts a surface into the scene under a number of the host's choice, or brings the one there up to date; what
        /// was there under that number before and isn't this surface goes. With `changed` (flgSurfaceGetChanges since
        /// the revision that the scene has seen; triangles beyond those seen count as changed) only these are taken in,
        /// beside the structure that is there; it is built anew once a quarter of the triangles changed, or with
        /// `changed` null. Takes effect with flgPickSceneCommit. Cost: about 1 us a triangle that is new, with
        /// flgPickSceneCommit.
        /// </summary>
        [DllImport(Library.Pick, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgPickSceneSetSurface(
            FlgPickScene scene, uint @object, FlgSurfaceView* surface, uint* changed, uint changed_count);

        /// <summary>
        /// Likewise curves, as round tubes: of their RADIUS, or half the WIDTH, but at least `least_radius` (metres,
        /// &gt; 0), so that thin lines can be hit. Cost: about 1.6 us a point that is new, with flgPickSceneCommit.
        /// </summary>
        [DllImport(Library.Pick, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgPickSceneSetCurves(
            FlgPickScene scene, uint @object, FlgCurveSetView* curves, float least_radius);

        /// <summary>FlgResult.ErrorInvalidArgument if there is nothing under that number.</summary>
        [DllImport(Library.Pick, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgPickSceneRemove(FlgPickScene scene, uint @object);

        /// <summary>
        /// Builds what was set since the last time. Queries before the first commit hit nothing. Cost: with
        /// flgPickSceneSetSurface, see there.
        /// </summary>
        [DllImport(Library.Pick, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgPickSceneCommit(FlgPickScene scene);

        /// <summary>
        /// [any thread] The first hit of each ray, on both sides of surfaces. FlgResult.ErrorInvalidArgument names the
        /// first ray that isn't one; no ray is then shot. Cost, with 2 million triangles: about a microsecond a ray,
        /// half of that for 10,000 rays or more at a time.
        /// </summary>
        [DllImport(Library.Pick, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgPickRays(FlgPickScene scene, FlgRay* rays, uint ray_count, FlgHit* out_hits);

        /// <summary>
        /// [any thread] The nearest point within `max_distance` (metres, &gt; 0, may be infinite). Cost: some us, tens
        /// where it is far.
        /// </summary>
        [DllImport(Library.Pick, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgPickNearest(
            FlgPickScene scene, float* point, float max_distance, FlgHit* out_hit);
    }
}
