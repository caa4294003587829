// SPDX-License-Identifier: MIT
// Functions of filigree_surface.h. Written by tools/abi/generate from sdk/api/abi.json: change the header.
//
// Surfaces: robust triangle meshes, geodesic distances, tracing, sampling and cutting (Nazzaro, Puppo, Pellacini:
// geoTangle, 2021, sec. 3 and 4). Follows the grammar of filigree.h.
//
// Order        A job sees its surface as it was when the job was started. Jobs that read a surface run side by side. A
//              job that changes it (a cut) runs after all jobs started before it and before all jobs started later. The
//              host need not wait.
// Revisions    A surface counts its changes. Fields and curves belong to the revision they were started on; using them
//              with another gives FlgResult.ErrorInvalidArgument. (A change counts when it is started, even if it fails
//              later.)
// Regions      Each triangle has a label, 0 to FLG_REGION_MAX. Functions that take `regions` stay on triangles with
//              these labels, and so do their paths; null means the whole surface.

using System;
using System.Runtime.InteropServices;
using static System.Runtime.InteropServices.CallingConvention;

namespace Filigree
{
    public static unsafe partial class Native
    {
        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgMeshViewInit(FlgMeshView* view, uint struct_size);

        /// <summary>[any thread] The view's column of an attribute, null if there is none.</summary>
        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgColumn* flgMeshViewGetColumn(FlgMeshView* view, FlgAttribute attribute);

        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgSurfaceDescInit(FlgSurfaceDesc* desc, uint struct_size);

        /// <summary>
        /// Starts a job that makes a manifold surface from any triangles; flgSurfaceGetReport reports its repairs. This
        /// call copies the arrays: about 10 ms for 2 million triangles. The job fails with
        /// FlgResult.ErrorInvalidArgument if an index is out of range, a position is not finite, or no triangle is
        /// left; also if the mesh lies so far from its origin that floats cannot hold its shape: if most edges are
        /// shorter than 8 times the spacing of floats at their ends. Cost: about 0.3 us a triangle.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgSurfaceCreate(
            FlgContext context, FlgSurfaceDesc* desc, FlgSurface* out_surface, FlgJob* out_job);

        /// <summary>
        /// The same with all defaults for plain arrays: 3 floats a vertex, metres, and 3 vertices a triangle. Cost:
        /// that of flgSurfaceCreate.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgSurfaceCreateFromTriangles(
            FlgContext context, float* positions, uint vertex_count, uint* triangles, uint triangle_count,
            FlgJobOptions* job, FlgSurface* out_surface, FlgJob* out_job);

        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgSurfaceReportInit(FlgSurfaceReport* report, uint struct_size);

        /// <summary>
        /// The report of the job that made the surface; FlgResult.NotReady until it is published, the job's error if it
        /// failed. Cuts do not change it. Cost: tens of nanoseconds.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgSurfaceGetReport(
            FlgContext context, FlgSurface surface, FlgSurfaceReport* out_report);

        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgSurfaceViewInit(FlgSurfaceView* view, uint struct_size);

        /// <summary>
        /// The surface's arrays, readable until a job that changes the surface is started. FlgResult.NotReady until
        /// such a job, or the one that makes the surface, is published. Cost: tens of nanoseconds.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgSurfaceGetView(
            FlgContext context, FlgSurface surface, FlgSurfaceView* out_view);

        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgSurfaceProvenanceViewInit(FlgSurfaceProvenanceView* view, uint struct_size);

        /// <summary>
        /// The arrays, readable as those of flgSurfaceGetView. FlgResult.ErrorInvalidArgument without
        /// FlgSurfaceDesc.provenance; a refined surface has it from the one it was refined from. After Loop's scheme a
        /// vertex lies where it would lie had its edge been split halfway. Cost: tens of nanoseconds.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgSurfaceGetProvenance(
            FlgContext context, FlgSurface surface, FlgSurfaceProvenanceView* out_view);

        /// <summary>
        /// [any thread] The place on the input of a vertex of a triangle: `triangle` of the input, and the weights of
        /// that triangle's corners 1 and 2 in the input's order. FlgResult.ErrorInvalidArgument if the vertex is none
        /// of the triangle's. Cost: tens of nanoseconds.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgSurfaceProvenanceViewGetPoint(
            FlgSurfaceProvenanceView* view, uint triangle, uint vertex, FlgSurfacePoint* out_point);

        /// <summary>
        /// Triangles that are new, have moved or have other vertices since an earlier revision (0: its creation): those
        /// to upload again or to update in a picking scene. Regions may have changed anywhere. Writes at most
        /// `capacity` indices, each once, ascending, and their total number; `out_triangles` may be null when capacity
        /// is 0. FlgResult.NotReady while the view is not ready. Cost: about 0.5 ns a triangle of the surface.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgSurfaceGetChanges(
            FlgContext context, FlgSurface surface, uint since_revision, uint* out_triangles, uint capacity, uint*
            out_count);

        /// <summary>
        /// Releases the handle and its views; jobs that use the surface keep its memory until they finish.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgSurfaceRelease(FlgContext context, FlgSurface surface);

        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgSurfaceRefineDescInit(FlgSurfaceRefineDesc* desc, uint struct_size);

        /// <summary>
        /// Starts a job that makes a finer surface: splits each triangle into four, `levels` times, and keeps regions
        /// and columns. Fails with FlgResult.ErrorLimit above 2^30 triangles. Vertices keep their indices; new ones
        /// follow. Cost: about 0.12 us a triangle that is made.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgSurfaceRefine(
            FlgContext context, FlgSurfaceRefineDesc* desc, FlgSurface* out_surface, FlgJob* out_job);

        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgSurfaceCurvesViewInit(FlgSurfaceCurvesView* view, uint struct_size);

        /// <summary>
        /// The arrays live until the curves are released. FlgResult.NotReady until their job is published, the job's
        /// error if it failed.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgSurfaceCurvesGetView(
            FlgContext context, FlgSurfaceCurves curves, FlgSurfaceCurvesView* out_view);

        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgSurfaceCurvesRelease(FlgContext context, FlgSurfaceCurves curves);

        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgSurfaceCurvesLiftDescInit(FlgSurfaceCurvesLiftDesc* desc, uint struct_size);

        /// <summary>
        /// Starts a job that lifts surface curves into space, with POSITION and, from the surface's smooth normals,
        /// NORMAL: flgCurveSetStylize with FlgFrameMethod.Supplied then decorates them in the surface's frame. Fails if
        /// there are no curves. Cost: about 25 ns a triangle of the surface, for its normals, and 0.1 us a point.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgSurfaceCurvesLift(
            FlgContext context, FlgSurfaceCurvesLiftDesc* desc, FlgCurveSet* out_set, FlgJob* out_job);

        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgFieldGeodesicDescInit(FlgFieldGeodesicDesc* desc, uint struct_size);

        /// <summary>
        /// Starts a job that computes distances along the surface from the nearest source to every vertex. It unfolds
        /// fronts over triangles; the error is below 0.2 % (RMS) on natural meshes, and below 0.6 % on them stretched
        /// to twenty times their length: where triangles are obtuse, others of the same shape are unfolded (intrinsic
        /// edge flips), and the surface is not changed. No distance exceeds that along edges by more than 3e-5 of it.
        /// From points and vertices alone, at most 16 or with labels, none is less than the straight line. The first
        /// job on a surface also builds the solver's data (about 0.15 us a triangle; kept, and updated by cuts). Cost
        /// then: about 40 ns a triangle within the limits and below 1 ns for each other one, as every vertex has a
        /// value. If sources lie outside the regions, all distances are infinite. FlgResult.ErrorOutOfMemory also if
        /// memory runs out while building that data.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgFieldCreateGeodesic(
            FlgContext context, FlgFieldGeodesicDesc* desc, FlgField* out_field, FlgJob* out_job);

        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgFieldViewInit(FlgFieldView* view, uint struct_size);

        /// <summary>
        /// The arrays live until the field is released. FlgResult.NotReady until its job is published, the job's error
        /// if it failed.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgFieldGetView(FlgContext context, FlgField field, FlgFieldView* out_view);

        /// <summary>
        /// A field from the host, one value per vertex of the current surface (FlgResult.NotReady while it changes);
        /// values may be infinite, but not NaN. Cost: a copy.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgFieldCreate(
            FlgContext context, FlgSurface surface, float* values, uint value_count, FlgField* out_field);

        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgFieldRelease(FlgContext context, FlgField field);

        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgFieldBlendDescInit(FlgFieldBlendDesc* desc, uint struct_size);

        /// <summary>
        /// Starts a job that blends two distance fields of one surface: from / (from + to), sec. 3.2. 0.5 where both
        /// are 0; infinite where both are infinite. Cost: about 5 ns a vertex.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgFieldBlend(
            FlgContext context, FlgFieldBlendDesc* desc, FlgField* out_field, FlgJob* out_job);

        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgSurfaceSampleDescInit(FlgSurfaceSampleDesc* desc, uint struct_size);

        /// <summary>
        /// Starts a job that spreads points over the surface, each as far as possible from those before it:
        /// Poisson-disk samples in the geodesic metric (sec. 4.2), at vertices. (Above 16,384 vertices, most are chosen
        /// by distance in space.) The field: distances to the nearest sample; labels: its cell. Cost: some 3 to 4
        /// fields for 130 points.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgSurfaceSample(
            FlgContext context, FlgSurfaceSampleDesc* desc, FlgField* out_field, FlgJob* out_job);

        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgSurfaceSampleBordersDescInit(
            FlgSurfaceSampleBordersDesc* desc, uint struct_size);

        /// <summary>
        /// Starts a job that places points evenly along the borders of a region: one closed curve per border. Such a
        /// curve is not straight in triangles between its points and cannot be cut in. Cost: about 8 ns a triangle.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgSurfaceSampleBorders(
            FlgContext context, FlgSurfaceSampleBordersDesc* desc, FlgSurfaceCurves* out_curves, FlgJob* out_job);

        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgFieldTraceIsolinesDescInit(FlgFieldTraceIsolinesDesc* desc, uint struct_size);

        /// <summary>
        /// Starts a job that traces isolines: closed ones, and open ones from border to border. Higher values lie to
        /// their left. Open isolines come first, then closed ones, each kind ordered by the triangle it begins in;
        /// curve_values are their levels. Cost: about 9 ns a triangle and 0.2 us a point.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgFieldTraceIsolines(
            FlgContext context, FlgFieldTraceIsolinesDesc* desc, FlgSurfaceCurves* out_curves, FlgJob* out_job);

        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgFieldTraceStreamsDescInit(FlgFieldTraceStreamsDesc* desc, uint struct_size);

        /// <summary>
        /// Starts a job that traces integral curves of a field's gradient. The field rises (falls) strictly along them.
        /// Each ends at the border, at `end_value` or at an extremum of the field. A start outside the regions gives no
        /// curve. Cost: about 0.25 us a point.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgFieldTraceStreams(
            FlgContext context, FlgFieldTraceStreamsDesc* desc, FlgSurfaceCurves* out_curves, FlgJob* out_job);

        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgFieldTracePathsDescInit(FlgFieldTracePathsDesc* desc, uint struct_size);

        /// <summary>
        /// Starts a job that joins points by locally shortest paths: straight across edges, and at vertices no shorter
        /// on either side (to 1e-6). The job fails if no path joins two points; zero-length paths are omitted. Cost: a
        /// field for each two points, up to where they meet, and its copy.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgFieldTracePaths(
            FlgContext context, FlgFieldTracePathsDesc* desc, FlgSurfaceCurves* out_curves, FlgJob* out_job);

        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgSurfaceCutIsolinesDescInit(FlgSurfaceCutIsolinesDesc* desc, uint struct_size);

        /// <summary>
        /// Starts a job that cuts a surface along isolines, all levels in one pass: they become chains of edges.
        /// Crossings nearer to a vertex than 1/100 of their edge move to it, to avoid slivers. Nothing else moves; the
        /// surface keeps its area and topology. New vertices and triangles are appended, with interpolated columns.
        /// `out_field` (may be null): the field on the cut surface. Cost: about 10 ns a triangle of the surface and 0.5
        /// us a triangle cut.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgSurfaceCutIsolines(
            FlgContext context, FlgSurfaceCutIsolinesDesc* desc, FlgField* out_field, FlgJob* out_job);

        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgSurfaceCutCurvesDescInit(FlgSurfaceCutCurvesDesc* desc, uint struct_size);

        /// <summary>
        /// Starts a job that cuts a surface along curves, which may cross, touch, and end anywhere. The job first works
        /// out how to divide triangles, which takes longest; until then the surface does not change and the job can be
        /// cancelled. Cost: as flgSurfaceCutIsolines; n curves that cross each other in one triangle take about n * n
        /// us there.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgSurfaceCutCurves(
            FlgContext context, FlgSurfaceCutCurvesDesc* desc, FlgJob* out_job);

        public static FlgSurfaceReport flgSurfaceReportDefaults()
        {
            FlgSurfaceReport made;
            flgSurfaceReportInit(&made, (uint)sizeof(FlgSurfaceReport));
            return made;
        }

        public static FlgMeshView flgMeshViewDefaults()
        {
            FlgMeshView made;
            flgMeshViewInit(&made, (uint)sizeof(FlgMeshView));
            return made;
        }

        public static FlgSurfaceDesc flgSurfaceDefaults()
        {
            FlgSurfaceDesc made;
            flgSurfaceDescInit(&made, (uint)sizeof(FlgSurfaceDesc));
            return made;
        }

        public static FlgSurfaceView flgSurfaceViewDefaults()
        {
            FlgSurfaceView made;
            flgSurfaceViewInit(&made, (uint)sizeof(FlgSurfaceView));
            return made;
        }

        public static FlgSurfaceProvenanceView flgSurfaceProvenanceViewDefaults()
        {
            FlgSurfaceProvenanceView made;
            flgSurfaceProvenanceViewInit(&made, (uint)sizeof(FlgSurfaceProvenanceView));
            return made;
        }

        public static FlgSurfaceRefineDesc flgSurfaceRefineDefaults()
        {
            FlgSurfaceRefineDesc made;
            flgSurfaceRefineDescInit(&made, (uint)sizeof(FlgSurfaceRefineDesc));
            return made;
        }

        public static FlgSurfaceCurvesView flgSurfaceCurvesViewDefaults()
        {
            FlgSurfaceCurvesView made;
            flgSurfaceCurvesViewInit(&made, (uint)sizeof(FlgSurfaceCurvesView));
            return made;
        }

        public static FlgSurfaceCurvesLiftDesc flgSurfaceCurvesLiftDefaults()
        {
            FlgSurfaceCurvesLiftDesc made;
            flgSurfaceCurvesLiftDescInit(&made, (uint)sizeof(FlgSurfaceCurvesLiftDesc));
            return made;
        }

        public static FlgFieldGeodesicDesc flgFieldGeodesicDefaults()
        {
            FlgFieldGeodesicDesc made;
            flgFieldGeodesicDescInit(&made, (uint)sizeof(FlgFieldGeodesicDesc));
            return made;
        }

        public static FlgFieldView flgFieldViewDefaults()
        {
            FlgFieldView made;
            flgFieldViewInit(&made, (uint)sizeof(FlgFieldView));
            return made;
        }

        public static FlgFieldBlendDesc flgFieldBlendDefaults()
        {
            FlgFieldBlendDesc made;
            flgFieldBlendDescInit(&made, (uint)sizeof(FlgFieldBlendDesc));
            return made;
        }

        public static FlgSurfaceSampleDesc flgSurfaceSampleDefaults()
        {
            FlgSurfaceSampleDesc made;
            flgSurfaceSampleDescInit(&made, (uint)sizeof(FlgSurfaceSampleDesc));
            return made;
        }

        public static FlgSurfaceSampleBordersDesc flgSurfaceSampleBordersDefaults()
        {
            FlgSurfaceSampleBordersDesc made;
            flgSurfaceSampleBordersDescInit(&made, (uint)sizeof(FlgSurfaceSampleBordersDesc));
            return made;
        }

        public static FlgFieldTraceIsolinesDesc flgFieldTraceIsolinesDefaults()
        {
            FlgFieldTraceIsolinesDesc made;
            flgFieldTraceIsolinesDescInit(&made, (uint)sizeof(FlgFieldTraceIsolinesDesc));
            return made;
        }

        public static FlgFieldTraceStreamsDesc flgFieldTraceStreamsDefaults()
        {
            FlgFieldTraceStreamsDesc made;
            flgFieldTraceStreamsDescInit(&made, (uint)sizeof(FlgFieldTraceStreamsDesc));
            return made;
        }

        public static FlgFieldTracePathsDesc flgFieldTracePathsDefaults()
        {
            FlgFieldTracePathsDesc made;
            flgFieldTracePathsDescInit(&made, (uint)sizeof(FlgFieldTracePathsDesc));
            return made;
        }

        public static FlgSurfaceCutIsolinesDesc flgSurfaceCutIsolinesDefaults()
        {
            FlgSurfaceCutIsolinesDesc made;
            flgSurfaceCutIsolinesDescInit(&made, (uint)sizeof(FlgSurfaceCutIsolinesDesc));
            return made;
        }

        public static FlgSurfaceCutCurvesDesc flgSurfaceCutCurvesDefaults()
        {
            FlgSurfaceCutCurvesDesc made;
            flgSurfaceCutCurvesDescInit(&made, (uint)sizeof(FlgSurfaceCutCurvesDesc));
            return made;
        }
    }
}
