// SPDX-License-Identifier: MIT
// Strokes, stylized as jobs while Vulkan draws frames: what tools/run starts.
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>

#include "filigree_renderer/window.h"
#include "strokes/framing.h"
#include "strokes/live.h"
#include "support/vulkan_loader.h"

namespace {

using namespace flg::samples;
namespace render = flg::render;

struct Options {
    std::vector<std::string> files = {"builtin:bouquet"};
    std::string style = "loops";
    std::string out = "out";
    uint32_t workers = 1;
    uint32_t budget_us = 2000;
    bool no_window = false;
};

std::string known_styles() {
    std::string list;
    for (const std::string& name : flg::scenes::library_names()) list += (list.empty() ? "" : ", ") + name;
    return list;
}

// A built-in style goes by its bare name, too.
std::string style_source(const std::string& style) {
    const std::vector<std::string>& names = flg::scenes::library_names();
    if (std::find(names.begin(), names.end(), style) != names.end()) return "builtin:" + style;
    const bool is_name = style.find_first_of("./:") == style.npos;
    if (is_name && !std::filesystem::exists(style)) {
        throw std::runtime_error("--style: '" + style + "' is no file and none of the built-in styles " +
                                 known_styles());
    }
    return style;
}

// Null, having said so, where there is no display.
std::unique_ptr<render::Window> open_window(const Options& options, render::Renderer& renderer) {
    if (options.no_window) return nullptr;
    if (!render::Window::available()) {
        std::puts("no display here: drawing offscreen");
        return nullptr;
    }
    try {
        return std::make_unique<render::Window>(renderer, kWidth, kHeight, "Filigree");
    } catch (const render::Error& error) {
        std::printf("no window (%s): drawing offscreen\n", error.what());
        return nullptr;
    }
}

// Draws the set alone, as ribbons or tubes, into a picture.
void save_picture(render::Renderer& renderer, render::Target& target, const render::Camera& camera,
                  const FlgCurveSetView& view, render::Shape shape, const std::string& path) {
    render::CurveLook look;
    look.shape = shape;
    renderer.clear();
    renderer.upload(view, look);
    renderer.draw(target, camera);
    write_png(renderer.capture(target), path);
    std::printf("wrote %s\n", path.c_str());
}

std::vector<CurveSource> load(const std::vector<std::string>& names) {
    std::vector<CurveSource> sources;
    for (const std::string& name : names) {
        const CurveSource& source = sources.emplace_back(name);
        std::printf("%s: %u strokes, %zu points\n", name.c_str(), source.view().curve_count, source.point_count());
        for (const std::string& warning : source.warnings()) std::printf("  odd: %s\n", warning.c_str());
    }
    return sources;
}

void run(const Options& options) {
    const std::string style_name = style_source(options.style);
    std::filesystem::create_directories(options.out);
    const auto path = [&](const char* name) { return options.out + "/" + name; };
    const std::vector<CurveSource> sources = load(options.files);
    const CurveSource style(style_name);
    std::vector<StrokeGroup> groups = group_by_size(sources);

    calm_vulkan_loader();
    render::Renderer renderer;
    std::printf("drawing with %s\n", renderer.device_name().c_str());
    render::Target offscreen(renderer, kWidth, kHeight);
    const std::unique_ptr<render::Window> window = open_window(options, renderer);

    StrokeSet originals;
    for (const CurveSource& source : sources) originals.add_all(source.view());
    const FlgCurveSetView before = originals.view();
    const Framing live_framing = frame_strokes({&before, 1});
    offscreen.resize(live_framing.width, kHeight);
    const render::Camera camera = live_framing.camera;

    Live live(options.workers, options.budget_us);
    live.start(style, groups);
    render::Target& target = window ? static_cast<render::Target&>(*window) : offscreen;
    if (window) window->orbit.camera = camera;
    const bool terminal = isatty(STDOUT_FILENO) != 0;
    while (live.frame(renderer, target, window ? window->orbit.camera : camera)) {
        if (terminal) std::printf("\r\033[Kstylizing: %3.0f %%", 100.0 * static_cast<double>(live.progress()));
        if (terminal) std::fflush(stdout);
        if (window && !window->poll()) break;
    }
    renderer.wait_idle();
    const FrameLog& log = live.log();
    std::printf("%sstylized: %llu points in %zu frames, %.1f ms of work, longest chunk %.0f us (%s)\n",
                terminal ? "\r\033[K" : "", static_cast<unsigned long long>(log.result_points), log.tick_us.size(),
                static_cast<double>(log.busy_ms), static_cast<double>(log.max_slice_us), log.max_slice_stage.c_str());
    log.write(path("frames.json"), options.budget_us, options.workers, renderer.device_name());
    std::printf("wrote %s\n", path("frames.json").c_str());

    StrokeSet result = live.result();
    const FlgCurveSetView view = result.view();
    const FlgCurveSetView all[] = {before, view};
    const Framing framing = frame_strokes(all);
    offscreen.resize(framing.width, kHeight);
    save_picture(renderer, offscreen, framing.camera, before, render::Shape::ribbon, path("before.png"));
    FlgCurveFileWriteDesc write = {};
    flgCurveFileWriteDescInit(&write, sizeof write);
    write.geometry = FLG_CURVE_GEOMETRY_RIBBON;
    if (flgCurveFileWrite(path("result.glb").c_str(), &view, &write) != FLG_OK) {
        throw std::runtime_error(flgIoErrorGetMessage());
    }
    std::printf("wrote %s\n", path("result.glb").c_str());
    save_picture(renderer, offscreen, framing.camera, view, render::Shape::tube, path("styled_tubes.png"));
    save_picture(renderer, offscreen, framing.camera, view, render::Shape::ribbon, path("styled_ribbons.png"));

    if (window) std::puts("drag to turn, shift + drag to move, wheel to zoom, Escape to end");
    while (window && window->poll()) renderer.draw(*window, window->orbit.camera);
}

}  // namespace

int main(int argc, char** argv) {
    Options options;
    CLI::App program("Stylizes strokes by example while drawing them; leaves pictures, the result and a report.",
                     "strokes");
    program.add_option("FILE", options.files, "Strokes: .tilt, .xyz, .obj, .gltf, .glb or builtin:NAME")
        ->capture_default_str();
    program.add_option("--style", options.style, known_styles() + ", or a file")->capture_default_str();
    program.add_option("--out", options.out, "Folder for the results")->capture_default_str();
    program.add_option("--workers", options.workers, "Threads to work on, 0 = in the frame itself")
        ->capture_default_str()
        ->check(CLI::Range(0u, 256u));
    program.add_option("--budget", options.budget_us, "Microseconds of work a frame")
        ->capture_default_str()
        ->check(CLI::Range(100u, 1'000'000u));
    program.add_flag("--no-window", options.no_window, "Only offscreen, even with a display");
    CLI11_PARSE(program, argc, argv);
    try {
        run(options);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "strokes: %s\n", error.what());
        return 1;
    }
    return 0;
}
