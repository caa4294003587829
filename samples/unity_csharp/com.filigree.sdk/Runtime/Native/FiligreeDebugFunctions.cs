// SPDX-License-Identifier: MIT
// Functions of filigree_debug.h. Written by tools/abi/generate from sdk/api/abi.json: change the header.
//
// Debug drawing: what an object holds, as coloured lines and points for the engine's own line drawer. Follows the
// grammar of filigree.h. The calling thread does the work; there is no job and no allocation.
//
//     FlgDebugDrawDesc desc = flgDebugDrawDefaults();
//     FlgDebugDrawing drawing = flgDebugDrawingDefaults();
//     flgDebugDrawSurface(context, surface, &desc, &drawing);   counts
//     ...                                                       room for them: lines, line_capacity, points, ...
//     flgDebugDrawSurface(context, surface, &desc, &drawing);   writes
//
// Parts        `parts` says what to draw; each function lists the parts it knows and those it draws by default. Parts
//              that an object does not have are left out, so one descriptor serves all objects.
// Range        A part has elements: curves, triangles, nodes, ... `first` and `count` choose among them. A range beyond
//              the end is empty. Ranges that follow each other draw everything once: large objects can be drawn over
//              several frames.
// Places       In metres, relative to the `origin` of the descriptor: the difference to the object's own origin is
//              applied in doubles. Drawings in the plane lie at z = 0. Transforms are the host's matter.
// Results      FlgResult.NotReady until the object's view is ready, its job's error if that failed.
//              FlgResult.ErrorLimit if an
//              array is too small; the counts then say how much room it takes, and nothing is written. On all other
//              failures the counts are 0.
// Cost         Counting is one pass over the range, writing two. A pass takes about 5 ns for each triangle or point
//              that is looked at, and for each line 15 ns to count it or 30 ns to write it: the edges of a million
//              triangles 70 ms, their borders 10 ms.

using System;
using System.Runtime.InteropServices;
using static System.Runtime.InteropServices.CallingConvention;

namespace Filigree
{
    public static unsafe partial class Native
    {
        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgDebugDrawDescInit(FlgDebugDrawDesc* desc, uint struct_size);

        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgDebugDrawingInit(FlgDebugDrawing* drawing, uint struct_size);

        /// <summary>
        /// Curves. LINES and POINTS; FRAMES, where the set has a NORMAL column; SEAMS, where it has STYLE_INDEX.
        /// Tangents are those of the TANGENT column, or between neighbours. Default LINES, FRAMES and SEAMS. Elements:
        /// curves. With partial_results the leading curves are drawn. Cost: a pass over the points.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgDebugDrawCurveSet(
            FlgContext context, FlgCurveSet set, FlgDebugDrawDesc* desc, FlgDebugDrawing* drawing);

        /// <summary>
        /// [any thread, one per stroke] A live stroke's points so far, as of a curve set; its tip is not drawn. Default
        /// LINES, FRAMES and SEAMS. Elements: curves, of which there is one. As a call of flgLiveStrokeGetPoints, it
        /// ends the life of the view before. Cost: a pass over the points.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgDebugDrawLiveStroke(
            FlgContext context, FlgLiveStroke stroke, FlgDebugDrawDesc* desc, FlgDebugDrawing* drawing);

        /// <summary>
        /// A style: LINES, the example as matched to the guide; GUIDE, green; DISPLACEMENT, grey, from guide to
        /// example; FRAMES of the guide. Default LINES, GUIDE and DISPLACEMENT. Elements: curves. Cost: a pass over the
        /// points.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgDebugDrawStyle(
            FlgContext context, FlgStyle style, FlgDebugDrawDesc* desc, FlgDebugDrawing* drawing);

        /// <summary>
        /// A surface: EDGES, coloured by label; BORDERS, red where there is only one triangle, and coloured by the
        /// greater label between labels; POINTS, the vertices. Default BORDERS. Elements: triangles, of POINTS
        /// vertices. Cost: a pass over the triangles.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgDebugDrawSurface(
            FlgContext context, FlgSurface surface, FlgDebugDrawDesc* desc, FlgDebugDrawing* drawing);

        /// <summary>
        /// A field: POINTS, the vertices of its surface, from blue (its least value) to red (its greatest); grey where
        /// it is infinite. Default POINTS. Elements: vertices. Refuses a field of an earlier revision of its surface.
        /// Cost: a pass over the vertices, and 1 ns a vertex of the surface for the least and greatest value.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgDebugDrawField(
            FlgContext context, FlgField field, FlgDebugDrawDesc* desc, FlgDebugDrawing* drawing);

        /// <summary>
        /// Curves on a surface, lifted into space: LINES and POINTS. Default LINES. Elements: curves. Refuses curves of
        /// an earlier revision of their surface. Cost: a pass over the points.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgDebugDrawSurfaceCurves(
            FlgContext context, FlgSurfaceCurves curves, FlgDebugDrawDesc* desc, FlgDebugDrawing* drawing);

        /// <summary>
        /// A tangle: BORDERS between regions, coloured by the greater look, grey where none is seen (looks are the
        /// same), red where the surface ends; EDGES, coloured by region; SEEDS, the points, samples, lines and first
        /// border vertices that the operators started from, coloured by operator. Default BORDERS and SEEDS. Elements:
        /// triangles, of SEEDS operators. Places of seeds are those when the operator was applied. Cost: a pass over
        /// the triangles, and the operators' seeds.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgDebugDrawTangle(
            FlgContext context, FlgTangle tangle, FlgDebugDrawDesc* desc, FlgDebugDrawing* drawing);

        /// <summary>
        /// A straight skeleton, in the drawing's unit: BORDERS, the contour; LINES, the arcs, and POINTS, their inner
        /// nodes, from blue (time 0) to red (the latest). Default all of these. Elements: points of the contour, arcs,
        /// nodes. Cost: a pass over points, arcs and nodes, and 1 ns a node for the latest time.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgDebugDrawStraightSkeleton(
            FlgContext context, FlgStraightSkeleton skeleton, FlgDebugDrawDesc* desc, FlgDebugDrawing* drawing);

        /// <summary>
        /// An outline in its place: BORDERS, the contour. Default BORDERS. Elements: rings. Cost: a pass over the
        /// points.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgDebugDrawOutline(
            FlgContext context, FlgOutline outline, FlgDebugDrawDesc* desc, FlgDebugDrawing* drawing);

        /// <summary>
        /// A part, in the drawing's unit: BORDERS, the outline; LINES, the axis, green; POINTS, its nodes; FRAMES, the
        /// slices across its branches, grey. Default BORDERS and LINES. Elements: rings, arcs, nodes, samples. Cost: a
        /// pass over the points.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgDebugDrawPart(
            FlgContext context, FlgPart part, FlgDebugDrawDesc* desc, FlgDebugDrawing* drawing);

        /// <summary>
        /// A part's surface, in the drawing's unit: EDGES. Default EDGES. Elements: triangles. Cost: a pass over the
        /// triangles.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgDebugDrawPartMesh(
            FlgContext context, FlgPartMesh mesh, FlgDebugDrawDesc* desc, FlgDebugDrawing* drawing);

        /// <summary>
        /// A model: LINES, a bone from each joint's parent to it, as an octahedron; POINTS, the joints. Both coloured
        /// by part. Default both. Elements: joints. Cost: a pass over the joints.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgDebugDrawModel(
            FlgContext context, FlgModel model, FlgDebugDrawDesc* desc, FlgDebugDrawing* drawing);

        /// <summary>
        /// A skin at rest: LINES and POINTS of its joints, as of a model, in one colour; EDGES, coloured by part.
        /// Default LINES and POINTS. Elements: joints, of EDGES triangles. Cost: a pass over the joints or triangles.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgDebugDrawSkin(
            FlgContext context, FlgSkin skin, FlgDebugDrawDesc* desc, FlgDebugDrawing* drawing);

        /// <summary>
        /// Obstacles: LINES, their wireframes; CLEARANCE, grey, the same moved outwards by the clearance, without
        /// rounding corners. Functions are drawn as their boxes; meshes, layers and borders as the edges of their
        /// surface as it is now, and as its box while it changes. The clearance of a mesh is that of its box; layers
        /// and borders show none. Default both. Elements: obstacles. Cost: a pass over the obstacles, and over the
        /// triangles of meshes.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgDebugDrawObstacles(
            FlgContext context, FlgObstacles obstacles, FlgDebugDrawDesc* desc, FlgDebugDrawing* drawing);

        /// <summary>
        /// A manifold: POINTS on it, and LINES, their outward normals, green. Default both. Meshes and clouds are drawn
        /// at their samples; shapes, formulas and grids next to the middles of 16 x 16 x 16 cells, of the grid's box or
        /// of a cube of the shape's size around its origin; images of surfaces as those. There is nothing to draw of
        /// space itself and of the host's own functions. Elements: samples or cells. Cost: a pass over the samples; 1
        /// to 3 us a cell.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgDebugDrawManifold(
            FlgContext context, FlgManifold manifold, FlgDebugDrawDesc* desc, FlgDebugDrawing* drawing);

        /// <summary>
        /// A spline: LINES, orange if rounds ran out or it stalled (FlgSplineEnding); POINTS, the nodes of the given
        /// points, yellow; FRAMES, where the spline has normals. Default LINES and POINTS. Elements: nodes, of POINTS
        /// given points. Of more than three coordinates the first three are drawn; of two, z is 0. With partial_results
        /// the last round is drawn. Cost: a pass over the nodes.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgDebugDrawSpline(
            FlgContext context, FlgSpline spline, FlgDebugDrawDesc* desc, FlgDebugDrawing* drawing);

        /// <summary>
        /// A motion: LINES, the barycentre's path; FRAMES, the body's axes x, y, z at it in red, green, blue; POINTS,
        /// the keys, yellow. Default all of these. Elements: positions, of POINTS keys. With partial_results the last
        /// round is drawn. Cost: a pass over the positions.
        /// </summary>
        [DllImport(Library.Filigree, CallingConvention = Cdecl, ExactSpelling = true)]
        public static extern FlgResult flgDebugDrawMotion(
            FlgContext context, FlgMotion motion, FlgDebugDrawDesc* desc, FlgDebugDrawing* drawing);

        public static FlgDebugDrawDesc flgDebugDrawDefaults()
        {
            FlgDebugDrawDesc made;
            flgDebugDrawDescInit(&made, (uint)sizeof(FlgDebugDrawDesc));
            return made;
        }

        public static FlgDebugDrawing flgDebugDrawingDefaults()
        {
            FlgDebugDrawing made;
            flgDebugDrawingInit(&made, (uint)sizeof(FlgDebugDrawing));
            return made;
        }
    }
}
