// SPDX-License-Identifier: MIT
// Functions of filigree_surface.h. Written by tools/abi/generate from sdk/api/abi.json: change the header.
//
// Surfaces: triangle meshes that hold up, geodesic distances, tracing, sampling and cutting (Nazzaro, Puppo, Pellacini:
// geoTangle, 2021, sec. 3 and 4). It follows the grammar of filigree.h.
//
// Order        Jobs on one surface see it as it was when they were started: those that read it run side by side, one
//              that
//              changes it (a cut) runs after all that were started before it and before all that are started later. No
//              host has to wait for that.
// Revisions    A surface counts its changes. Fields and curves belong to the revision they were started on; with
//              another
//              they are FlgResult.ErrorInvalidArgument. (A change counts when it is started, also if it fails later.)
// Regions      Each triangle has a label, 0 to FLG_REGION_MAX. Functions that take `regions` keep to triangles with
//              these
//              labels, paths included; null means the whole surface.

using System;
using System.Runtime.InteropServices;

namespace Filigree
{
    public static unsafe partial class Native
    {
        [DllImport(Library.Filigree, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgMeshViewInit(FlgMeshView* view, uint struct_size);

        [DllImport(Library.Filigree, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgSurfaceDescInit(FlgSurfaceDesc* desc, uint struct_size);

        /// <summary>
        /// Starts a job that makes a manifold surface of any triangles, and reports what it had to do
        /// (flgSurfaceGetReport). The arrays are copied in this call: about 10 ms for 2 million triangles. The job
        /// fails with FlgResult.ErrorInvalidArgument if an index is out of range, a position isn't finite, or no
        /// triangle is left. Cost: about 0.3 us a triangle.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgSurfaceCreate(
            FlgContext context, FlgSurfaceDesc* desc, FlgSurface* out_surface, FlgJob* out_job);

        /// <summary>
        /// The report of the job that made the surface; FlgResult.NotReady before it is published, its error if it
        /// failed. Cuts don't change it. Cost: tens of nanoseconds.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgSurfaceGetReport(
            FlgContext context, FlgSurface surface, FlgSurfaceReport* out_report);

        [DllImport(Library.Filigree, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgSurfaceViewInit(FlgSurfaceView* view, uint struct_size);

        /// <summary>
        /// The surface's arrays; they may be read until a job that changes the surface is started. FlgResult.NotReady
        /// while such a job, or the one that makes the surface, isn't published. Cost: tens of nanoseconds.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgSurfaceGetView(
            FlgContext context, FlgSurface surface, FlgSurfaceView* out_view);

        /// <summary>
        /// Triangles that are new, have moved or have other vertices than at an earlier revision (0: when it was made):
        /// those to upload again, or to put into a picking scene. Regions may have changed anywhere. Writes at most
        /// `capacity` indices, each once, rising, and their whole number; `out_triangles` may be null when capacity is
        /// 0. Not ready when the view isn't. Cost: about 0.5 ns a triangle of the surface.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgSurfaceGetChanges(
            FlgContext context, FlgSurface surface, uint since_revision, uint* out_triangles, uint capacity, uint*
            out_count);

        /// <summary>
        /// Gives the handle and its views back; jobs that use the surface keep its memory until they are done.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgSurfaceRelease(FlgContext context, FlgSurface surface);

        [DllImport(Library.Filigree, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgRefineDescInit(FlgRefineDesc* desc, uint struct_size);

        /// <summary>
        /// Starts a job that makes a finer surface: four triangles of each, `levels` times, with its regions and
        /// columns. Fails with FlgResult.ErrorLimit above 2^30 triangles. Vertices keep their numbers, new ones follow.
        /// Cost: about 0.12 us a triangle that is made.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgSurfaceRefine(
            FlgContext context, FlgRefineDesc* desc, FlgSurface* out_surface, FlgJob* out_job);

        [DllImport(Library.Filigree, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgSurfaceCurvesViewInit(FlgSurfaceCurvesView* view, uint struct_size);

        /// <summary>
        /// The arrays live until the curves are released. FlgResult.NotReady before their job is published, its error
        /// if it failed.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgSurfaceCurvesGetView(
            FlgContext context, FlgSurfaceCurves curves, FlgSurfaceCurvesView* out_view);

        [DllImport(Library.Filigree, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgSurfaceCurvesRelease(FlgContext context, FlgSurfaceCurves curves);

        [DllImport(Library.Filigree, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgLiftDescInit(FlgLiftDesc* desc, uint struct_size);

        /// <summary>
        /// Starts a job that makes curves in space of curves on a surface: POSITION and, from the surface's smooth
        /// normals, NORMAL, so that flgStylize with FlgFrameMethod.Supplied decorates them in the surface's frame.
        /// Fails if there are no curves. Cost: about 25 ns a triangle of the surface, for its normals, and 0.1 us a
        /// point.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgLiftCurves(
            FlgContext context, FlgLiftDesc* desc, FlgCurveSet* out_set, FlgJob* out_job);

        [DllImport(Library.Filigree, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgGeodesicDescInit(FlgGeodesicDesc* desc, uint struct_size);

        /// <summary>
        /// Starts a job that computes distances along the surface from the nearest source to every vertex. The first on
        /// a surface also builds what the solver needs (about 0.15 us a triangle, kept and updated by cuts). Cost then:
        /// about 40 ns a triangle within the limits and below 1 ns for each other one (FlgAccuracy.Graph: a few ns), as
        /// every vertex has a value. With sources outside the regions all distances are infinite.
        /// FlgResult.ErrorOutOfMemory also if memory runs out in what is built first.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgGeodesic(
            FlgContext context, FlgGeodesicDesc* desc, FlgField* out_field, FlgJob* out_job);

        [DllImport(Library.Filigree, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgFieldViewInit(FlgFieldView* view, uint struct_size);

        /// <summary>
        /// The arrays live until the field is released. FlgResult.NotReady before its job is published, its error if it
        /// failed.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgFieldGetView(FlgContext context, FlgField field, FlgFieldView* out_view);

        /// <summary>
        /// A field of the host's own, one value a vertex of the surface as it is now (FlgResult.NotReady while it
        /// changes); infinite values are allowed, NaN is not. Cost: a copy.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgFieldCreate(
            FlgContext context, FlgSurface surface, float* values, uint value_count, FlgField* out_field);

        [DllImport(Library.Filigree, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgFieldRelease(FlgContext context, FlgField field);

        [DllImport(Library.Filigree, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgBlendDescInit(FlgBlendDesc* desc, uint struct_size);

        /// <summary>
        /// Starts a job that blends two distance fields of one surface: from / (from + to), sec. 3.2. Where both are 0:
        /// 0.5; infinite where both are. Cost: about 5 ns a vertex.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgFieldBlend(
            FlgContext context, FlgBlendDesc* desc, FlgField* out_field, FlgJob* out_job);

        [DllImport(Library.Filigree, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgSamplingDescInit(FlgSamplingDesc* desc, uint struct_size);

        /// <summary>
        /// Starts a job that spreads points over the surface, each as far as possible from those before it (of more
        /// than 16,384 vertices most in space): Poisson-disk samples in the geodesic metric (sec. 4.2), at vertices.
        /// The field: distances to the nearest one; labels: its cell. Cost: some 3 to 4 fields for 130 points.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgSurfaceSample(
            FlgContext context, FlgSamplingDesc* desc, FlgField* out_field, FlgJob* out_job);

        [DllImport(Library.Filigree, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgBorderSamplingDescInit(FlgBorderSamplingDesc* desc, uint struct_size);

        /// <summary>
        /// Starts a job that places points evenly along the borders of a region: one closed curve a border, which is
        /// not straight in triangles between its points and can't be cut in. Cost: about 8 ns a triangle.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgBorderSample(
            FlgContext context, FlgBorderSamplingDesc* desc, FlgSurfaceCurves* out_curves, FlgJob* out_job);

        [DllImport(Library.Filigree, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgIsolinesDescInit(FlgIsolinesDesc* desc, uint struct_size);

        /// <summary>
        /// Starts a job that traces isolines: closed ones, and open ones from border to border. Higher values lie to
        /// their left. First the open ones, then the closed ones, each kind by the triangle it begins in; curve_values
        /// are their levels. Cost: about 9 ns a triangle and 0.2 us a point.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgTraceIsolines(
            FlgContext context, FlgIsolinesDesc* desc, FlgSurfaceCurves* out_curves, FlgJob* out_job);

        [DllImport(Library.Filigree, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgStreamsDescInit(FlgStreamsDesc* desc, uint struct_size);

        /// <summary>
        /// Starts a job that traces integral curves of a field's gradient. The field rises (falls) strictly along them;
        /// each ends at the border, at `end_value` or where the field has an extremum. A start outside the regions
        /// gives no curve. Cost: about 0.25 us a point.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgTraceStreams(
            FlgContext context, FlgStreamsDesc* desc, FlgSurfaceCurves* out_curves, FlgJob* out_job);

        [DllImport(Library.Filigree, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgPathsDescInit(FlgPathsDesc* desc, uint struct_size);

        /// <summary>
        /// Starts a job that joins points by locally shortest paths: straight over edges, and at vertices no shorter on
        /// either side (to 1e-6). Points that no path joins make the job fail; a path without length is left out. Cost:
        /// a field for each two points, up to where they meet, and its copy.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgTracePaths(
            FlgContext context, FlgPathsDesc* desc, FlgSurfaceCurves* out_curves, FlgJob* out_job);

        [DllImport(Library.Filigree, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgCutIsolinesDescInit(FlgCutIsolinesDesc* desc, uint struct_size);

        /// <summary>
        /// Starts a job that cuts a surface along isolines, all levels in one pass: they become chains of edges.
        /// Crossings nearer to a vertex than 1/100 of their edge move to it, so that no slivers come about; else
        /// nothing moves, the surface keeps its area and its topology. New vertices and triangles are appended, the
        /// columns interpolated. `out_field`, which may be null, is the field on the cut surface. Cost: about 10 ns a
        /// triangle of the surface and 0.5 us a triangle cut.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgCutIsolines(
            FlgContext context, FlgCutIsolinesDesc* desc, FlgField* out_field, FlgJob* out_job);

        [DllImport(Library.Filigree, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgCutCurvesDescInit(FlgCutCurvesDesc* desc, uint struct_size);

        /// <summary>
        /// Starts a job that cuts a surface along curves, which may cross, touch, and end anywhere. Finding out how to
        /// divide triangles comes first and takes longest; until then the surface is as it was and the job can be
        /// cancelled. Cost: as flgCutIsolines; n curves that cross each other in one triangle take about n * n us
        /// there.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgCutCurves(FlgContext context, FlgCutCurvesDesc* desc, FlgJob* out_job);

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

        public static FlgRefineDesc flgRefineDefaults()
        {
            FlgRefineDesc made;
            flgRefineDescInit(&made, (uint)sizeof(FlgRefineDesc));
            return made;
        }

        public static FlgSurfaceCurvesView flgSurfaceCurvesViewDefaults()
        {
            FlgSurfaceCurvesView made;
            flgSurfaceCurvesViewInit(&made, (uint)sizeof(FlgSurfaceCurvesView));
            return made;
        }

        public static FlgLiftDesc flgLiftDefaults()
        {
            FlgLiftDesc made;
            flgLiftDescInit(&made, (uint)sizeof(FlgLiftDesc));
            return made;
        }

        public static FlgGeodesicDesc flgGeodesicDefaults()
        {
            FlgGeodesicDesc made;
            flgGeodesicDescInit(&made, (uint)sizeof(FlgGeodesicDesc));
            return made;
        }

        public static FlgFieldView flgFieldViewDefaults()
        {
            FlgFieldView made;
            flgFieldViewInit(&made, (uint)sizeof(FlgFieldView));
            return made;
        }

        public static FlgBlendDesc flgBlendDefaults()
        {
            FlgBlendDesc made;
            flgBlendDescInit(&made, (uint)sizeof(FlgBlendDesc));
            return made;
        }

        public static FlgSamplingDesc flgSamplingDefaults()
        {
            FlgSamplingDesc made;
            flgSamplingDescInit(&made, (uint)sizeof(FlgSamplingDesc));
            return made;
        }

        public static FlgBorderSamplingDesc flgBorderSamplingDefaults()
        {
            FlgBorderSamplingDesc made;
            flgBorderSamplingDescInit(&made, (uint)sizeof(FlgBorderSamplingDesc));
            return made;
        }

        public static FlgIsolinesDesc flgIsolinesDefaults()
        {
            FlgIsolinesDesc made;
            flgIsolinesDescInit(&made, (uint)sizeof(FlgIsolinesDesc));
            return made;
        }

        public static FlgStreamsDesc flgStreamsDefaults()
        {
            FlgStreamsDesc made;
            flgStreamsDescInit(&made, (uint)sizeof(FlgStreamsDesc));
            return made;
        }

        public static FlgPathsDesc flgPathsDefaults()
        {
            FlgPathsDesc made;
            flgPathsDescInit(&made, (uint)sizeof(FlgPathsDesc));
            return made;
        }

        public static FlgCutIsolinesDesc flgCutIsolinesDefaults()
        {
            FlgCutIsolinesDesc made;
            flgCutIsolinesDescInit(&made, (uint)sizeof(FlgCutIsolinesDesc));
            return made;
        }

        public static FlgCutCurvesDesc flgCutCurvesDefaults()
        {
            FlgCutCurvesDesc made;
            flgCutCurvesDescInit(&made, (uint)sizeof(FlgCutCurvesDesc));
            return made;
        }
    }
}
