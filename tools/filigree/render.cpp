// SPDX-License-Identifier: MIT
// filigree render: draws curves into a picture, without a window.
#include <array>
#include <cmath>
#include <cstdio>
#include <map>
#include <memory>
#include <numbers>

#include "choices.h"
#include "command.h"
#include "failure.h"
#include "filigree_renderer/renderer.h"
#include "report.h"
#include "support/curve_source.h"
#include "support/vulkan_loader.h"
#include "text_file.h"

namespace flg::cli {
namespace {

using render::Shape;

constexpr uint32_t kMaxFrames = 10'000;
constexpr uint32_t kMaxPixels = 16'384;
// Radius of curves that bring none: this share of the diagonal of the picture's content.
constexpr float kDefaultRadiusShare = 1.0f / 400.0f;

const std::map<std::string, Shape> kShapes = {{"lines", Shape::line}, {"ribbon", Shape::ribbon}, {"tube", Shape::tube}};

struct Options {
    std::vector<std::string> files;
    std::string output;
    std::string size = "1280x720";
    Shape as = Shape::tube;
    std::vector<double> camera = {25.0, 15.0, 1.0};
    uint32_t frames = 1;
    double radius = 0.0;
};

glm::vec3 vec3_of(const std::vector<double>& values, size_t first) {
    return {values[first], values[first + 1], values[first + 2]};
}

// The camera of frame `index` of a turn around.
render::Camera camera_of(const Options& options, const render::Box& box, float aspect, uint32_t index) {
    const double turn = 2.0 * std::numbers::pi * index / options.frames;
    if (options.camera.size() == 6) {
        render::Orbit orbit;
        orbit.camera.eye = vec3_of(options.camera, 0);
        orbit.camera.target = vec3_of(options.camera, 3);
        orbit.turn(static_cast<float>(turn), 0.0f);
        return orbit.camera;
    }
    constexpr double kRadians = std::numbers::pi / 180.0;
    const double yaw = options.camera[0] * kRadians + turn, pitch = options.camera[1] * kRadians;
    const glm::vec3 direction(-std::sin(yaw) * std::cos(pitch), -std::sin(pitch), -std::cos(yaw) * std::cos(pitch));
    render::Orbit orbit;
    orbit.camera = frame_box(box, direction, aspect);
    if (options.camera.size() == 3) orbit.zoom(static_cast<float>(1.0 / options.camera[2]));
    return orbit.camera;
}

// out.png -> out-0001.png where there are several.
std::string frame_path(const Options& options, uint32_t index) {
    if (options.frames == 1) return options.output;
    char number[16];
    std::snprintf(number, sizeof number, "-%04u", index + 1);
    const size_t dot = options.output.rfind('.');
    return options.output.substr(0, dot) + number + options.output.substr(dot);
}

std::vector<samples::CurveSource> load(const Options& options, Report& report) {
    std::vector<samples::CurveSource> sources;
    uint64_t curves = 0, points = 0;
    for (const std::string& file : options.files) {
        const samples::CurveSource& source = sources.emplace_back(file);
        for (const std::string& warning : source.warnings()) report.warn(source.name() + ": " + warning);
        curves += source.view().curve_count;
        points += source.point_count();
    }
    report.counts = {{"files", options.files.size()}, {"curves", curves}, {"points", points}};
    return sources;
}

void upload(render::Renderer& renderer, const Options& options, const std::vector<samples::CurveSource>& sources) {
    render::CurveLook line;
    line.shape = Shape::line;
    std::vector<render::CurvesId> ids;
    for (const samples::CurveSource& source : sources) ids.push_back(renderer.upload(source.view(), line));
    if (options.as == Shape::line) return;
    // Now that the size of the whole is known, so is a sensible radius.
    render::CurveLook look;
    look.shape = options.as;
    look.radius =
        options.radius > 0.0 ? static_cast<float>(options.radius) : renderer.bounds().diagonal() * kDefaultRadiusShare;
    for (size_t i = 0; i < ids.size(); ++i) renderer.update(ids[i], sources[i].view(), look);
}

void run_render(const Options& options, const CommonOptions& common) {
    if (!options.output.ends_with(".png")) throw UsageError(options.output + ": pictures are written as .png");
    if (options.camera.size() < 2 || options.camera.size() == 4 || options.camera.size() == 5) {
        throw UsageError("--camera: takes YAW,PITCH[,ZOOM] or EX,EY,EZ,TX,TY,TZ");
    }
    if (options.camera.size() == 3 && !(options.camera[2] > 0.0)) throw UsageError("--camera: ZOOM must be > 0");
    uint32_t width = 0, height = 0;
    int used = 0;
    if (std::sscanf(options.size.c_str(), "%5ux%5u%n", &width, &height, &used) != 2 ||
        static_cast<size_t>(used) != options.size.size() || width < 1 || height < 1 || width > kMaxPixels ||
        height > kMaxPixels) {
        throw UsageError("--size: '" + options.size + "' is not WxH with 1 to 16384 pixels each");
    }
    require_writable(options.output);
    require_writable(common.report);

    Report report("render", common);
    report.parameters = {{"files", options.files},
                         {"size", {width, height}},
                         {"as", name_of(kShapes, options.as)},
                         {"camera", options.camera},
                         {"frames", options.frames}};
    const std::vector<samples::CurveSource> sources = load(options, report);
    samples::calm_vulkan_loader();
    render::Renderer renderer;
    upload(renderer, options, sources);
    render::Target target(renderer, width, height);
    std::vector<float> cpu_ms;
    for (uint32_t i = 0; i < options.frames; ++i) {
        renderer.draw(target, camera_of(options, renderer.bounds(), target.aspect(), i));
        cpu_ms.push_back(static_cast<float>(renderer.stats().cpu_ms));
        write_png(renderer.capture(target), frame_path(options, i));
    }
    report.quality = {{"device", renderer.device_name()},
                      {"triangles", renderer.stats().triangles},
                      {"draw_calls", renderer.stats().draw_calls},
                      {"device_bytes", renderer.stats().device_bytes},
                      {"frame_cpu_p50_ms", percentile(cpu_ms, 0.5)},
                      {"frame_cpu_max_ms", percentile(cpu_ms, 1.0)}};
    report.write();
}

}  // namespace

Command add_render(CLI::App& program, const CommonOptions& common) {
    CLI::App* app = program.add_subcommand("render", "Draws curves into a picture, without a window");
    const auto o = std::make_shared<Options>();
    app->add_option("FILE", o->files, "Curves: files or builtin:NAME")->required();
    app->add_option("-o,--output", o->output, "The picture")->required()->type_name("OUT.png");
    app->add_option("--size", o->size, "Pixels, 1 to 16384 each")->type_name("WxH")->capture_default_str();
    add_choice(*app, "--as", o->as, kShapes, "How curves are drawn");
    app->add_option(
           "--camera", o->camera,
           "YAW,PITCH[,ZOOM] of a camera that sees all (degrees; 0,0 looks along -z, positive pitch from above), "
           "or EX,EY,EZ,TX,TY,TZ: eye and target, metres")
        ->delimiter(',')
        ->expected(1, 6)
        ->type_name("...")
        ->check(finite())
        ->capture_default_str();
    app->add_option("--frames", o->frames, "Pictures of a turn around, 1 to 10000; several are called OUT-0001.png ...")
        ->capture_default_str()
        ->check(CLI::Range(1u, kMaxFrames).description(""));
    app->add_option("--radius", o->radius, "Radius of curves that bring none, metres; 0 = from the size of the whole")
        ->capture_default_str()
        ->check(at_least_zero());
    return {app, [o, &common] { run_render(*o, common); }};
}

}  // namespace flg::cli
