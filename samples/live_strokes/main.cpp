// SPDX-License-Identifier: MIT
// Recorded controller strokes drawn again in real time, stylized while they are drawn, in stereo, at a headset's pace.
#include <CLI/CLI.hpp>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <memory>

#include "filigree_renderer/window.h"
#include "live_strokes/pacing.h"
#include "live_strokes/painter.h"
#include "live_strokes/replay_source.h"
#include "live_strokes/stage.h"
#include "support/vulkan_loader.h"

namespace {

using namespace flg::samples;
namespace render = flg::render;
using Clock = std::chrono::steady_clock;

struct Options {
    std::string strokes = "builtin:session", style = "builtin:loops", out = "out";
    double seconds = 20.0, hertz = 90.0;
    uint32_t width = 720, height = 800, samples = 4;
    float displacement_mm = 14.0f;
    bool fast = false, no_window = false, validation = false;
};

double ms_since(Clock::time_point start) {
    return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

std::unique_ptr<render::Window> open_window(const Options& options, render::Renderer& renderer) {
    if (options.no_window || options.fast || !render::Window::available()) return nullptr;
    return std::make_unique<render::Window>(renderer, 2 * options.width, options.height, "Filigree: live strokes");
}

// Draws what the source asks for until it has enough, or the window is closed.
PacingReport draw_session(XrSource& source, render::Renderer& renderer, render::StereoTarget& target,
                          render::Window* window, Painter& painter) {
    PacingReport report;
    Stage stage(renderer);
    XrFrame frame;
    while (source.wait_frame(frame)) {
        if (window && !window->poll_events()) break;
        const auto start = Clock::now();
        source.begin_frame();
        Added added = painter.paint(frame.drawing, frame.display_s);
        const FlgFrameReport tick = painter.tick(added);
        stage.place(frame);
        renderer.draw(target, {camera_of(frame.eyes[0]), camera_of(frame.eyes[1])}, window);
        source.end_frame();
        const render::FrameStats& stats = renderer.stats();
        report.add({added.push_us, tick.tick_us, stats.cpu_ms, stats.submit_ms, stats.wait_ms, ms_since(start),
                    stats.gpu_ms, frame.missed, added.samples, added.points, added.strokes, added.tips,
                    stats.uploaded_bytes});
    }
    renderer.wait_idle();
    return report;
}

// Returns whether the validation layer, if it was asked for, had nothing to say.
bool run(const Options& options) {
    std::filesystem::create_directories(options.out);
    const Recording recording(options.strokes);
    const CurveSource style(options.style);
    calm_vulkan_loader();
    render::Options renderer_options;
    renderer_options.validation = options.validation;
    renderer_options.samples = options.samples;
    render::Renderer renderer(renderer_options);
    render::StereoTarget target(renderer, options.width, options.height);
    const std::unique_ptr<render::Window> window = open_window(options, renderer);
    Painter painter(renderer, style, 0.001f * options.displacement_mm);
    ReplaySource source(recording, options.seconds, options.hertz, !options.fast);
    const PacingReport report = draw_session(source, renderer, target, window.get(), painter);

    const SessionFacts facts{
        renderer.device_name(), options.strokes, options.style,  options.hertz,          options.seconds,
        !options.fast,          options.width,   options.height, painter.stroke_count(), renderer.stats().device_bytes};
    report.print(facts);
    report.write(facts, options.out + "/live_strokes.json");
    write_png(renderer.capture(target, 0), options.out + "/left.png");
    write_png(renderer.capture(target, 1), options.out + "/right.png");
    std::printf("wrote %s/live_strokes.json, left.png, right.png\n", options.out.c_str());
    for (const std::string& message : renderer.messages()) std::fprintf(stderr, "validation: %s\n", message.c_str());
    return renderer.messages().empty();
}

}  // namespace

int main(int argc, char** argv) {
    Options options;
    CLI::App app("Recorded controller strokes, stylized while they are drawn again, in stereo at a headset's pace.");
    app.add_option("strokes", options.strokes, "what the controller draws: .tilt, .xyz, builtin:NAME, builtin:session");
    app.add_option("--style", options.style, "the example stroke: a file or builtin:NAME")->capture_default_str();
    app.add_option("--displacement", options.displacement_mm, "how far the style goes off the hand's path, mm")
        ->check(CLI::Range(0.1f, 1000.0f))
        ->capture_default_str();
    app.add_option("--seconds", options.seconds, "length of the session")
        ->check(CLI::Range(0.05, 3600.0))
        ->capture_default_str();
    app.add_option("--hertz", options.hertz, "displays a second")
        ->check(CLI::Range(10.0, 500.0))
        ->capture_default_str();
    app.add_option("--width", options.width, "of an eye's picture, pixels")
        ->check(CLI::Range(16, 8192))
        ->capture_default_str();
    app.add_option("--height", options.height, "pixels")->check(CLI::Range(16, 8192))->capture_default_str();
    app.add_option("--samples", options.samples, "a pixel")->check(CLI::IsMember({1, 2, 4, 8}))->capture_default_str();
    app.add_option("--out", options.out, "folder for the report and the last pictures")->capture_default_str();
    app.add_flag("--fast", options.fast, "don't wait for displays, open no window: the same pictures every time");
    app.add_flag("--no-window", options.no_window, "draw offscreen");
    app.add_flag("--validation", options.validation,
                 "run under Vulkan's validation layer, and fail if it says anything");
    CLI11_PARSE(app, argc, argv);
    try {
        return run(options) ? 0 : 1;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "live_strokes: %s\n", error.what());
        return 1;
    }
}
