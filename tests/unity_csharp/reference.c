/* SPDX-License-Identifier: MIT
 * A host in C whose inputs and results are written to a file, as blocks of a size and bytes: BitTests.cs does the same
 * in C# and compares. */
#include <filigree/filigree.h>
#include <filigree/filigree_live.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum { EXAMPLE_POINTS = 300, TARGET_POINTS = 40, SAMPLES = 200 };

static FlgResult check(FlgResult result) {
    if (result >= 0) return result;
    fprintf(stderr, "%s: %s\n", flgResultGetName(result), flgErrorGetMessage());
    exit(1);
}

static void write(FILE* file, const void* data, size_t size) {
    const uint32_t written = (uint32_t)size;
    if (fwrite(&written, sizeof written, 1, file) != 1 || fwrite(data, 1, size, file) != size) exit(1);
}

static FlgCurveSet curve(FlgContext context, FILE* file, const float* points, uint32_t count, uint8_t flags) {
    const uint32_t offsets[] = {0, count};
    const FlgColumn positions = {FLG_ATTRIBUTE_POSITION, 3, points, 0, 0};
    FlgCurveSetView view = flgCurveSetViewDefaults();
    FlgCurveSet set;
    view.curve_count = 1;
    view.curve_offsets = offsets;
    view.curve_flags = &flags;
    view.columns = &positions;
    view.column_count = 1;
    check(flgCurveSetCreate(context, &view, &set));
    write(file, points, count * 3 * sizeof *points);
    return set;
}

static void finish(FlgContext context) {
    FlgFrameReport report = {.struct_size = sizeof report};
    do {
        check(flgContextWait(context, 10000));
        check(flgContextTick(context, FLG_UNLIMITED, &report));
    } while (report.jobs_pending > 0);
}

static void write_columns(FILE* file, const FlgCurveSetView* view) {
    const FlgAttribute wanted[] = {FLG_ATTRIBUTE_POSITION, FLG_ATTRIBUTE_TANGENT, FLG_ATTRIBUTE_NORMAL,
                                   FLG_ATTRIBUTE_STYLE_INDEX};
    const uint32_t points = view->curve_offsets[view->curve_count];
    for (size_t k = 0; k < sizeof wanted / sizeof *wanted; ++k) {
        for (uint32_t i = 0; i < view->column_count; ++i) {
            const FlgColumn* column = &view->columns[i];
            if (column->attribute == wanted[k]) write(file, column->data, points * column->components * sizeof(float));
        }
    }
}

static void write_set(FlgContext context, FILE* file, FlgCurveSet set) {
    FlgCurveSetView view = flgCurveSetViewDefaults();
    finish(context);
    if (check(flgCurveSetGetView(context, set, &view)) != FLG_OK) exit(1);
    write_columns(file, &view);
}

static void draw(FlgContext context, FILE* file, FlgStyle style) {
    static struct Sample {
        float position[3], orientation[4], pressure;
        double time;
    } samples[SAMPLES];
    for (int i = 0; i < SAMPLES; ++i) {
        const float turn = 0.05f * (float)i;
        samples[i] = (struct Sample){{cosf(turn), 0.01f * (float)i, sinf(turn)},
                                     {0, sinf(turn), 0, cosf(turn)},
                                     0.5f + 0.4f * sinf(3 * turn),
                                     i / 90.0};
    }
    write(file, samples, sizeof samples);
    check(flgStyleWarm(context, style, 0.5f, NULL, NULL));
    finish(context);

    FlgLiveStrokeDesc desc = flgLiveStrokeDefaults();
    FlgCurveSetView view = flgCurveSetViewDefaults();
    FlgLiveStroke stroke;
    FlgCurveSet ended;
    desc.style = style;
    desc.temperature = 0.5f;
    if (check(flgLiveStrokeBegin(context, &desc, &stroke)) != FLG_OK) exit(1);
    FlgLiveSampleView pushed = flgLiveSampleViewDefaults();
    pushed.sample_count = SAMPLES;
    pushed.stride = sizeof samples[0];
    pushed.positions = samples[0].position;
    pushed.orientations = samples[0].orientation;
    pushed.pressures = &samples[0].pressure;
    pushed.times = &samples[0].time;
    check(flgLiveStrokePush(context, stroke, &pushed, NULL));
    check(flgLiveStrokeGetPoints(context, stroke, &view));
    write_columns(file, &view);
    check(flgLiveStrokeEnd(context, stroke, NULL, &ended, NULL, NULL));
    write_set(context, file, ended);
}

int main(int count, char** arguments) {
    static float example[EXAMPLE_POINTS][3], target[TARGET_POINTS][3];
    for (int i = 0; i < EXAMPLE_POINTS; ++i) {
        example[i][0] = 0.01f * (float)i;
        example[i][1] = 0.1f * cosf(0.2f * (float)i);
        example[i][2] = 0.1f * sinf(0.2f * (float)i);
    }
    for (int i = 0; i < TARGET_POINTS; ++i) {
        const float angle = 6.2831853f * (float)i / TARGET_POINTS;
        target[i][0] = 3 * cosf(angle);
        target[i][1] = sinf(3 * angle);
        target[i][2] = 2 * sinf(angle);
    }

    FILE* file = count == 2 ? fopen(arguments[1], "wb") : NULL;
    FlgContext context;
    FlgCurveSet result;
    if (file == NULL) return 1;
    check(flgContextCreate(NULL, &context));
    FlgStyleDesc style = flgStyleDefaults();
    style.style = curve(context, file, example[0], EXAMPLE_POINTS, 0);
    style.point_count = 400;
    FlgCurveSetStylizeDesc stylize = flgCurveSetStylizeDefaults();
    check(flgStyleCreate(context, &style, &stylize.style, NULL));
    stylize.target = curve(context, file, target[0], TARGET_POINTS, FLG_CURVE_CLOSED);
    stylize.temperature = 1;
    stylize.seed = 7;
    stylize.strokes = 3;
    check(flgCurveSetStylize(context, &stylize, &result, NULL));
    write_set(context, file, result);
    draw(context, file, stylize.style);
    check(flgContextDestroy(context));
    return fclose(file) == 0 ? 0 : 1;
}
