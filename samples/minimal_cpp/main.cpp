// SPDX-License-Identifier: MIT
// The same as minimal_c through filigree.hpp: owners instead of handles, exceptions instead of results. And a stroke
// that is stylized while it is drawn.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <filigree/filigree.hpp>
#include <vector>

namespace {

// How far a curve goes off the x axis. The view shows the SDK's own arrays: draw from them, or upload them.
float farthest(const filigree::CurveSetView& view) {
    float distance = 0;
    for (const auto& point : view.rows<3>(FLG_ATTRIBUTE_POSITION)) distance = std::max(distance, std::abs(point[1]));
    return distance;
}

// A line becomes a zigzag, as a job while frames go by.
void stylize_line(filigree::Context& context, const filigree::Style& style) {
    const filigree::CurveSet line = context.curve_set_from_points({0, 0, 0, 30, 0, 0});  // the SDK copies points
    const filigree::CurveSet zigzag = context.stylize({style, line});
    while (!zigzag.ready()) {
        context.tick(2000);   // once a frame, for at most 2 ms
        context.wait(11000);  // a game draws its frame here
    }
    std::printf("a line of 2 points became a zigzag of %u, up to %.2f m off the line\n", zigzag.view().curve_offsets[1],
                farthest(zigzag.view()));
}

// A hand draws a line at 1 m/s, 90 samples a second: each push shows the points that are new, and they are final.
void draw_live(filigree::Context& context, const filigree::Style& style) {
    const filigree::Job warming = style.warm();
    while (!warming.finished()) {
        context.tick(2000);
        context.wait(11000);
    }
    filigree::LiveStrokeDesc desc(style);
    desc.scale = 0.1f;  // a zigzag of 10 cm on a stroke of 2 m
    filigree::LiveStroke stroke = context.begin(desc);
    uint32_t points = 0;
    for (int frame = 0; frame <= 180; ++frame) {
        const double time = frame / 90.0;
        const float place[] = {static_cast<float>(time), 0, 0};
        filigree::LiveSampleView sample;
        sample.sample_count = 1;
        sample.positions = place;
        sample.times = &time;
        const filigree::CurveSetView added = stroke.push(sample);
        if (added.curve_count > 0) points += added.curve_offsets[1];
    }
    std::printf("181 samples became %u points while they came in, up to %.3f m off the line\n", points,
                farthest(stroke.points()));
}

}  // namespace

int main() {
    try {
        filigree::Context context = filigree::Context::create();
        const filigree::CurveSet zigzag =
            context.curve_set_from_points({0, 0, 0, 1, 1, 0, 2, -1, 0, 3, 1, 0, 4, -1, 0, 5, 1, 0, 6, 0, 0});
        const filigree::Style style = context.style({zigzag});
        stylize_line(context, style);
        draw_live(context, style);
    } catch (const filigree::Error& error) {
        std::fprintf(stderr, "%s: %s\n", filigree::result_name(error.result()), error.what());
        return 1;
    }
}
