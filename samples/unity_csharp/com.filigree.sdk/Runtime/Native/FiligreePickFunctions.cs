// SPDX-License-Identifier: MIT
// Functions of filigree_pick.h. Written by tools/abi/generate from sdk/api/abi.json: change the header.
//
// Picking on surfaces and curves, with Embree, in a separate library (filigree_pick) that hosts may leave out. Follows
// the grammar of filigree.h but needs no context: a scene copies its input.
//
// Threads   A function that changes a scene must not overlap with any other call on it, and no query may run between a
//           change and the commit after it; queries may run in parallel on any threads.
// Brushes   The area within a geodesic radius of a hit is a field: flgFieldCreateGeodesic from the hit's triangle, u
//           and v, with max_distance.
// Waiting   Setting up a surface of 2 million triangles takes seconds: do it where your engine loads assets. Updating
//           after a cut adds only the changes: well below a millisecond per thousand changed triangles.

using System;
using System.Runtime.InteropServices;
using static System.Runtime.InteropServices.CallingConvention;

namespace Filigree
{
    public static unsafe partial class Native
    {
        /// <summary>[any thread] As flgErrorGetMessage, for the functions of this header.</summary>
        [DllImport(Library.Pick, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern byte* flgPickErrorGetMessage();

        [DllImport(Library.Pick, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgPickSceneDescInit(FlgPickSceneDesc* desc, uint struct_size);

        /// <summary>`desc` may be null: all defaults. Cost: 0.2 to 1 ms.</summary>
        [DllImport(Library.Pick, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgPickSceneCreate(FlgPickSceneDesc* desc, FlgPickScene* out_scene);

        /// <summary>Null is allowed.</summary>
        [DllImport(Library.Pick, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern void flgPickSceneDestroy(FlgPickScene scene);

        /// <summary>
        /// Adds a surface to the scene under an index of the host's choice, or updates the one there; anything else
        /// under that index is removed. With `changed` (flgSurfaceGetChanges since the revision last set in the scene;
        /// triangles beyond those set count as changed) only these triangles are added beside the existing structure.
        /// The structure is rebuilt once a quarter of the triangles has changed, or with `changed` null. Takes effect
        /// with flgPickSceneCommit. Cost: about 1 us a triangle that is new, with flgPickSceneCommit.
        /// </summary>
        [DllImport(Library.Pick, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgPickSceneSetSurface(
            FlgPickScene scene, uint @object, FlgSurfaceView* surface, uint* changed, uint changed_count);

        /// <summary>
        /// Likewise for curves, as round tubes: with their RADIUS, or half their WIDTH, but at least `min_radius`
        /// (metres, &gt; 0), so that thin lines can be hit. Cost: about 1.6 us a point that is new, with
        /// flgPickSceneCommit.
        /// </summary>
        [DllImport(Library.Pick, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgPickSceneSetCurves(
            FlgPickScene scene, uint @object, FlgCurveSetView* curves, float min_radius);

        /// <summary>FlgResult.ErrorInvalidArgument if nothing is under that index.</summary>
        [DllImport(Library.Pick, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgPickSceneRemove(FlgPickScene scene, uint @object);

        /// <summary>
        /// Builds what was set since the last commit. Queries before the first commit hit nothing. Cost: with
        /// flgPickSceneSetSurface, see there.
        /// </summary>
        [DllImport(Library.Pick, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgPickSceneCommit(FlgPickScene scene);

        /// <summary>
        /// [any thread] The first hit of each ray, on both sides of surfaces. FlgResult.ErrorInvalidArgument names the
        /// first invalid ray; no ray is then shot. Cost, with 2 million triangles: about a microsecond a ray, half of
        /// that for 10,000 rays or more at a time.
        /// </summary>
        [DllImport(Library.Pick, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgPickSceneCastRays(
            FlgPickScene scene, FlgRay* rays, uint ray_count, FlgHit* out_hits);

        /// <summary>
        /// [any thread] The nearest point within `max_distance` (metres, &gt; 0, may be infinite). Cost: some us, tens
        /// if it is far.
        /// </summary>
        [DllImport(Library.Pick, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgPickSceneFindNearest(
            FlgPickScene scene, float* point, float max_distance, FlgHit* out_hit);

        public static FlgPickSceneDesc flgPickSceneDefaults()
        {
            FlgPickSceneDesc made;
            flgPickSceneDescInit(&made, (uint)sizeof(FlgPickSceneDesc));
            return made;
        }
    }
}
