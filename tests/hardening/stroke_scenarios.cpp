// SPDX-License-Identifier: MIT
// Contexts, curves, styles, stylization, live strokes.
#include <utility>
#include <vector>

#include "api/live_inputs.h"
#include "filigree/filigree_brush.h"
#include "filigree/filigree_model.h"
#include "filigree/filigree_surface.h"
#include "filigree/filigree_tangle.h"
#include "hardening/host_buffers.h"
#include "hardening/scenarios.h"

namespace flg::test {

namespace {

FlgCurveSet create(Calls& calls, Curves curves) {
    const FlgCurveSetView view = curves.view();
    FlgCurveSet set{};
    FLG_CALL(calls, flgCurveSetCreate, calls.context, &view, calls.out(set));
    return set;
}

FlgStyle create_style(Calls& calls, float end_cap = 0) {
    FlgStyleDesc desc = FLG_INIT(calls, flgStyleDescInit);
    desc.style = create(calls, coil(64, 3, 2));
    desc.point_count = 64;
    desc.patch = 4;
    desc.end_cap = end_cap;
    FlgStyle style{};
    FLG_CALL(calls, flgStyleCreate, calls.context, &desc, calls.out(style), calls.job());
    return style;
}

// In two calls, the second of which goes on with the same points.
void sweep(Calls& calls, const FlgCurveSetView& view) {
    FlgBrushMeshDesc desc = FLG_INIT(calls, flgBrushMeshDescInit);
    desc.curves = &view;
    FlgBrushMeshState state = FLG_INIT(calls, flgBrushMeshStateInit);
    FlgBrushMeshSizes sizes = FLG_INIT(calls, flgBrushMeshSizesInit);
    for (int i = 0; i < 2; ++i) {
        FLG_CALL(calls, flgBrushMeshGetSizes, &desc, &state, &sizes);
        std::vector<float> positions(3 * sizes.vertex_count);
        std::vector<uint32_t> indices(sizes.index_count);
        const FlgBufferColumn column = {
            FLG_ATTRIBUTE_POSITION, FLG_NUMBER_FORMAT_FLOAT32, positions.data(), 0, 0, {}, 0, 0};
        FlgBrushMeshOutput output = FLG_INIT(calls, flgBrushMeshOutputInit);
        output.columns = &column;
        output.column_count = 1;
        output.vertex_capacity = sizes.vertex_count;
        output.indices = indices.data();
        output.index_capacity = sizes.index_count;
        FLG_CALL(calls, flgBrushMeshWrite, &desc, &state, &output, &sizes);
        calls.bits.append(reinterpret_cast<const char*>(positions.data()), positions.size() * sizeof(float));
        calls.bits.append(reinterpret_cast<const char*>(indices.data()), indices.size() * sizeof(uint32_t));
    }
}

// At once: of any view, and of any triangles.
void write_at_once(Calls& calls, const FlgCurveSetView& view) {
    FlgBufferOutput output = output_to_buffers(calls, {{FLG_ATTRIBUTE_POSITION, FLG_NUMBER_FORMAT_FLOAT16}});
    output.left_handed = 1;
    FlgColumnsWriteDesc desc = FLG_INIT(calls, flgColumnsWriteDescInit);
    desc.columns = view.columns;
    desc.column_count = view.column_count;
    desc.row_count = view.curve_offsets[view.curve_count];
    desc.output = &output;
    FLG_CALL(calls, flgColumnsWrite, &desc);
    note_buffers(calls, output);
    const uint32_t triangle[] = {0, 1, 2};
    FlgBufferOutput indices = output_to_buffers(calls, {});
    add_triangles(indices);
    indices.index_format = FLG_NUMBER_FORMAT_UINT16;
    FLG_CALL(calls, flgIndicesWrite, triangle, 3u, &indices);
    note_buffers(calls, indices);
}

}  // namespace

void make_contexts(Calls& calls) {
    EXPECT_EQ(FLG_VALUE(calls, flgVersionGet), uint32_t{FLG_VERSION});
    EXPECT_STREQ(FLG_VALUE(calls, flgResultGetName, FLG_ERROR_LIMIT), "FLG_ERROR_LIMIT");
    EXPECT_NE(FLG_VALUE(calls, flgErrorGetMessage), nullptr);
    // Structs that scenarios fill by hand: by their defaults, too.
    FLG_INIT(calls, flgAllocatorInit);
    FLG_INIT(calls, flgBoneThresholdsInit);
    FLG_INIT(calls, flgClockInit);
    FLG_INIT(calls, flgFrameReportInit);
    FLG_INIT(calls, flgJobOptionsInit);
    FLG_INIT(calls, flgJobStatusInit);
    FLG_INIT(calls, flgJobSystemInit);
    FLG_INIT(calls, flgLiveStrokeInfoInit);
    FLG_INIT(calls, flgLogInit);
    FLG_INIT(calls, flgProfilerInit);
    FLG_INIT(calls, flgStyleInfoInit);
    FLG_INIT(calls, flgCurveSetScalesInit);
    FLG_INIT(calls, flgSurfaceReportInit);
    FLG_INIT(calls, flgTangleHistoryInit);
    FLG_INIT(calls, flgTangleSeedPlacesInit);
    FLG_INIT(calls, flgTangleInfoInit);
    FLG_INIT(calls, flgTangleRegionInit);
    FLG_INIT(calls, flgTangleStepInit);
    FlgContextDesc desc = FLG_INIT(calls, flgContextDescInit);
    desc.allocator = calls.contexts.allocator;
    desc.job_system = calls.contexts.job_system;
    desc.worker_count = 0;
    FlgContext context = calls.context;
    try {
        FLG_CALL(calls, flgContextCreate, &desc, &context);
    } catch (const Ended&) {
        EXPECT_EQ(context.id, 0u);
        throw;
    }
    FlgFrameReport report{};
    report.struct_size = sizeof report;
    FLG_CALL(calls, flgContextTick, context, 100u, &report);
    EXPECT_EQ(report.frame, 1u);
    FlgMemoryUse total = FLG_INIT(calls, flgMemoryUseInit), runtime = total;
    FLG_CALL(calls, flgContextSetMemoryLimit, context, FLG_MEMORY_KIND_STYLES, uint64_t{1'000'000'000});
    FLG_CALL(calls, flgContextGetMemory, context, FLG_MEMORY_KIND_TOTAL, &total);
    FLG_CALL(calls, flgContextGetMemory, context, FLG_MEMORY_KIND_RUNTIME, &runtime);
    EXPECT_EQ(total.bytes, runtime.bytes);
    FLG_CALL(calls, flgContextWait, context, 10u);
    FLG_CALL(calls, flgContextRun, context, nullptr, 0u, 1.0);
    FLG_CALL(calls, flgContextDestroy, context);
}

void make_curves(Calls& calls) {
    const Curves arc = arcs(1, 12);
    FlgCurveSet lone{};
    FLG_CALL(calls, flgCurveSetCreateFromPoints, calls.context, arc.positions.data(), 12u, uint8_t{0}, calls.out(lone));
    FlgCurveSetView view = FLG_INIT(calls, flgCurveSetViewInit);
    FLG_CALL(calls, flgCurveSetGetView, calls.context, lone, &view);
    sweep(calls, view);
    write_at_once(calls, view);
    EXPECT_EQ(FLG_VALUE(calls, flgCurveSetViewGetColumn, &std::as_const(view), FLG_ATTRIBUTE_POSITION), view.columns);
    calls.bits += bits(view);
    FLG_CALL(calls, flgCurveSetRelease, calls.context, lone);
    FlgCurveSetResampleDesc desc = FLG_INIT(calls, flgCurveSetResampleDescInit);
    desc.curves = create(calls, arcs(3, 12));
    desc.spacing = 0.4f;
    FlgCurveSet even{}, framed{};
    FLG_CALL(calls, flgCurveSetResample, calls.context, &desc, calls.out(even), calls.job());
    desc.curves = even;
    desc.frame = FLG_FRAME_METHOD_FRENET;
    FLG_CALL(calls, flgCurveSetResample, calls.context, &desc, calls.out(framed), calls.job());
    const FlgBufferOutput output = output_to_buffers(calls, {{FLG_ATTRIBUTE_POSITION, FLG_NUMBER_FORMAT_FLOAT32},
                                                             {FLG_ATTRIBUTE_NORMAL, FLG_NUMBER_FORMAT_SNORM16}});
    FLG_CALL(calls, flgCurveSetWrite, calls.context, even, &output, nullptr, calls.job());
    FlgCurveSetSimplifyDesc simplify = FLG_INIT(calls, flgCurveSetSimplifyDescInit);
    const float tolerances[] = {0.01f, 0.1f};
    simplify.curves = even;
    simplify.level_count = 2;
    simplify.tolerances = tolerances;
    FlgCurveSet fewer{};
    FLG_CALL(calls, flgCurveSetSimplify, calls.context, &simplify, calls.out(fewer), calls.job());
    calls.finish();
    calls.note(framed);
    calls.note(fewer);
    note_buffers(calls, output);

    FLG_CALL(calls, flgCurveSetRelease, calls.context, even);
}

void make_styles(Calls& calls) {
    FlgCurveSet guide{};
    const FlgStyle style = create_style(calls);
    calls.finish();
    FlgStyleInfo info{};
    info.struct_size = sizeof info;
    FLG_CALL(calls, flgStyleGetInfo, calls.context, style, &info);
    calls.note(info.matching, info.point_count * sizeof(float));
    FLG_DRAW(calls, flgDebugDrawStyle, style);
    FLG_CALL(calls, flgStyleGetGuide, calls.context, style, calls.out(guide));
    calls.note(guide);

    size_t size = 0;
    FLG_CALL(calls, flgStyleGetData, calls.context, style, nullptr, size_t{0}, &size);
    std::string data(size, '\0');
    FLG_CALL(calls, flgStyleGetData, calls.context, style, data.data(), size, &size);
    calls.bits += data;
    FlgStyle loaded{};
    FLG_CALL(calls, flgStyleCreateFromData, calls.context, data.data(), size, calls.out(loaded));
    FLG_CALL(calls, flgStyleRelease, calls.context, loaded);

    // Every option at once: a guide of one's own, attributes, several patch sizes, caps.
    FlgStyleDesc desc = FLG_INIT(calls, flgStyleDescInit);
    const FlgPatchSize sizes[] = {{2, 1}, {4, 0.5f}};
    const FlgStyleAttribute attribute = {FLG_ATTRIBUTE_RADIUS, FLG_METRIC_AUTO, 0.1f, 0};
    desc.style = create(calls, arcs(2, 40, 3));
    desc.guide = create(calls, arcs(2, 7, 3));
    desc.point_count = 48;
    desc.patch_sizes = sizes;
    desc.patch_size_count = 2;
    desc.attributes = &attribute;
    desc.attribute_count = 1;
    desc.start_cap = 0.2f;
    desc.end_cap = -1;
    FlgStyle rich{};
    FLG_CALL(calls, flgStyleCreate, calls.context, &desc, calls.out(rich), calls.job());
    calls.finish();
    FLG_CALL(calls, flgStyleGetInfo, calls.context, rich, &info);
    calls.note(info.matching, info.point_count * sizeof(float));
}

void stylize_curves(Calls& calls) {
    FlgCurveSetStylizeDesc desc = FLG_INIT(calls, flgCurveSetStylizeDescInit);
    desc.style = create_style(calls);
    desc.target = create(calls, arcs(3, 12, 4));
    desc.temperature = 1;
    desc.strokes = 2;
    desc.keep_displacement = 1;
    FlgJobOptions options = flgJobOptionsDefaults();
    options.partial_results = 1;
    desc.job = &options;
    FlgCurveSet one{}, two{};
    FLG_CALL(calls, flgCurveSetStylize, calls.context, &desc, calls.out(one), calls.job());
    calls.finish();
    calls.note(one);
    FLG_DRAW(calls, flgDebugDrawCurveSet, one);
    desc.scale = 0;
    FlgCurveSet fitting{};
    FLG_CALL(calls, flgCurveSetStylize, calls.context, &desc, calls.out(fitting), calls.job());
    calls.finish();
    calls.note(fitting);
    FlgCurveSetScales scales = flgCurveSetScalesDefaults();
    FLG_CALL(calls, flgCurveSetGetScales, calls.context, fitting, &scales);
    calls.note(scales.scales, scales.curve_count * sizeof(float));
    desc.target = one;
    desc.strokes = 1;
    desc.scale = 0.5f;
    desc.temperature = 0;
    desc.pin_ends = 1;
    const FlgStyleDrive drives[] = {{FLG_ATTRIBUTE_RADIUS, FLG_STYLE_DRIVEN_SCALE, 0, 0.1f, 0.7f, 1},
                                    {FLG_ATTRIBUTE_STYLE_INDEX, FLG_STYLE_DRIVEN_TEMPERATURE, 0, 40, 0, 1}};
    desc.drives = drives;
    desc.drive_count = 2;
    desc.fit = 0.5f;
    FLG_CALL(calls, flgCurveSetStylize, calls.context, &desc, calls.out(two), calls.job());
    calls.finish();
    calls.note(two);
    const FlgStyle other = create_style(calls);
    desc.further_styles = &other;
    desc.further_style_count = 1;
    const FlgStyleDrive choice = {FLG_ATTRIBUTE_STYLE_INDEX, FLG_STYLE_DRIVEN_STYLE, 0, 40, 0, 1};
    desc.drives = &choice;
    desc.drive_count = 1;
    desc.corners = FLG_STYLE_CORNERS_MOTIFS;
    desc.corner_angle = 0.3f;
    desc.smooth_junctions = 1;
    desc.max_points = 20000;
    FlgCurveSet mixed{};
    FLG_CALL(calls, flgCurveSetStylize, calls.context, &desc, calls.out(mixed), calls.job());
    calls.finish();
    calls.note(mixed);
}

void draw_live_strokes(Calls& calls) {
    const FlgContext context = calls.context;
    FlgLiveStrokeDesc desc = FLG_INIT(calls, flgLiveStrokeDescInit);
    desc.style = create_style(calls, 0.3f);
    desc.end_cap = 1;
    const FlgStyle other = create_style(calls);
    desc.further_styles = &other;
    desc.further_style_count = 1;
    desc.style_blend = 0.2f;
    for (const FlgStyle style : {desc.style, other}) {
        FLG_CALL(calls, flgStyleWarm, context, style, 0.0f, nullptr, calls.job());
    }
    calls.finish();
    desc.scale = 0.3f;
    desc.max_samples = 64;
    desc.max_points = 512;
    const FlgStyleDrive drives[] = {{FLG_ATTRIBUTE_SPEED, FLG_STYLE_DRIVEN_SCALE, 0.5f, 2, 1, 0.8f},
                                    {FLG_ATTRIBUTE_PRESSURE, FLG_STYLE_DRIVEN_STYLE, 0, 1, 0, 1}};
    desc.drives = drives;
    desc.drive_count = 2;
    FlgLiveStroke stroke{};
    FLG_CALL(calls, flgLiveStrokeBegin, context, &desc, calls.out(stroke));
    const Samples samples = drawn(30);
    FlgCurveSetView view = FLG_INIT(calls, flgCurveSetViewInit);
    FlgLiveSampleView pushed = FLG_INIT(calls, flgLiveSampleViewInit);
    for (uint32_t i = 0; i + 5 <= 30; i += 5) {
        pushed = view_of(samples.data() + i, 5);
        FLG_CALL(calls, flgLiveStrokePush, context, stroke, &pushed, &view);
    }
    uint32_t left = 0;
    FLG_CALL(calls, flgLiveStrokeUndo, context, stroke, 3u, &left);
    pushed = view_of(samples.data() + 27, 3);
    FLG_CALL(calls, flgLiveStrokePush, context, stroke, &pushed, &view);
    FLG_CALL(calls, flgLiveStrokeGetPoints, context, stroke, &view);
    calls.bits += bits(view);
    FLG_DRAW(calls, flgDebugDrawLiveStroke, stroke);
    FLG_CALL(calls, flgLiveStrokeGetTip, context, stroke, &view);
    calls.bits += bits(view);
    FlgLiveStrokeInfo info{};
    info.struct_size = sizeof info;
    FLG_CALL(calls, flgLiveStrokeGetInfo, context, stroke, &info);
    EXPECT_EQ(info.sample_count, 30u);

    FlgCurveSet stylized{}, recorded{}, first{}, second{}, replayed{};
    FLG_CALL(calls, flgLiveStrokeEnd, context, stroke, nullptr, calls.out(stylized), calls.out(recorded), calls.job());
    calls.finish();
    calls.note(stylized);
    FLG_CALL(calls, flgLiveStrokeSplit, context, stroke, 20u, nullptr, calls.out(first), calls.out(second),
             calls.job());
    FLG_CALL(calls, flgLiveStrokeReplay, context, &desc, recorded, nullptr, calls.out(replayed), calls.job());
    calls.finish();
    calls.note(first);
    calls.note(second);
    calls.note(replayed);
    FLG_CALL(calls, flgLiveStrokeResume, context, stroke);
    FLG_CALL(calls, flgLiveStrokeGetPoints, context, stroke, &view);
    calls.bits += bits(view);
    FLG_CALL(calls, flgLiveStrokeRelease, context, stroke);
}

}  // namespace flg::test
