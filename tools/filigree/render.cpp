// SPDX-License-Identifier: MIT
// filigree render: draws curves and meshes into a picture, without a window.
#include <array>
#include <cmath>
#include <cstdio>
#include <memory>
#include <numbers>
#include <optional>

#include "camera_motion.h"
#include "choices.h"
#include "command.h"
#include "documents/failure.h"
#include "documents/progress.h"
#include "documents/text_file.h"
#include "render_scene.h"
#include "support/vulkan_loader.h"

namespace flg::cli {
namespace {

constexpr uint32_t kMaxFrames = 10'000;
constexpr uint32_t kMaxPixels = 16'384;
// How much larger the picture is than what it shows: room for the shadow.
constexpr float kMargin = 1.14f;
constexpr float kSunAside = 0.5f, kSunHeight = 0.93f;  // radians

const std::map<std::string, FlgSkinning> kSkinnings = {{"linear", FLG_SKINNING_LINEAR},
                                                       {"dual", FLG_SKINNING_DUAL_QUATERNION}};

struct Options {
    SceneOptions scene;
    std::string output;
    std::string size = "1280x720";
    std::vector<double> camera = {25.0, 15.0, 1.0};
    uint32_t frames = 1;
};

glm::vec3 vec3_of(const std::vector<double>& values, size_t first) {
    return {values[first], values[first + 1], values[first + 2]};
}

// The camera of frame `index` of a turn around.
render::Camera camera_of(const Options& options, std::span<const glm::vec3> points, float aspect, uint32_t index) {
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
    orbit.camera = render::frame_points(points, direction, aspect, kMargin);
    if (options.camera.size() == 3) orbit.zoom(static_cast<float>(1.0 / options.camera[2]));
    return orbit.camera;
}

// When frame `index` is on the way along a motion: all of it for several frames, --time for one.
double time_of(const Options& options, const CameraMotion& motion, uint32_t index) {
    if (options.frames == 1) return options.scene.pose.time.value_or(motion.begin());
    const double parts = options.frames - (motion.closed() ? 0 : 1);
    return motion.begin() + (motion.end() - motion.begin()) * index / parts;
}

void check_time(const Options& options, const CameraMotion& motion) {
    if (options.frames > 1 || motion.closed() || !options.scene.pose.time) return;
    const double time = *options.scene.pose.time;
    if (time >= motion.begin() && time <= motion.end()) return;
    char text[128];
    std::snprintf(text, sizeof text, "%g is not within the motion, %g to %g", time, motion.begin(), motion.end());
    throw InputError(options.scene.camera_motion + ": --time: " + text);
}

// A little to the right of the camera and high above it.
glm::vec3 sun_beside(const render::Camera& camera) {
    const glm::vec3 arm = camera.eye - camera.target;
    const float azimuth = std::atan2(arm.x, arm.z) + kSunAside;
    return {std::cos(kSunHeight) * std::sin(azimuth), std::sin(kSunHeight), std::cos(kSunHeight) * std::cos(azimuth)};
}

// out.png -> out-0001.png where there are several.
std::string frame_path(const Options& options, uint32_t index) {
    if (options.frames == 1) return options.output;
    char number[16];
    std::snprintf(number, sizeof number, "-%04u", index + 1);
    const size_t dot = options.output.rfind('.');
    return options.output.substr(0, dot) + number + options.output.substr(dot);
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
    if (!options.scene.pose.animation.empty() && !options.scene.pose.time)
        throw UsageError("--animation: its pose is taken at --time, which is missing");
    require_writable(options.output);
    require_writable(common.report);

    Report report("render", common);
    report.parameters = {{"files", options.scene.files},
                         {"size", {width, height}},
                         {"as", name_of(shape_names(), options.scene.as)},
                         {"camera", options.camera},
                         {"frames", options.frames}};
    if (!options.scene.field.empty()) report.parameters["field"] = options.scene.field;
    if (options.scene.pose.time) {
        report.parameters["time"] = *options.scene.pose.time;
        report.parameters["animation"] = options.scene.pose.animation;
    }
    report.parameters["skinning"] = name_of(kSkinnings, options.scene.pose.skinning);
    report.parameters["bones"] = options.scene.bones;
    if (!options.scene.camera_motion.empty()) report.parameters["camera_motion"] = options.scene.camera_motion;
    const RenderScene scene(options.scene, report);
    Session session(common);
    std::optional<CameraMotion> motion;
    if (!options.scene.camera_motion.empty()) {
        motion.emplace(options.scene.camera_motion, options.scene.camera_obstacles, session, report);
        check_time(options, *motion);
    }
    say_step("starting the renderer");
    samples::calm_vulkan_loader();
    render::Renderer renderer;
    scene.upload(renderer);
    const std::vector<glm::vec3> points = scene.points();
    render::Target target(renderer, width, height);
    render::Box box;
    for (const glm::vec3& point : points) box.add({point, point});
    const auto camera = [&](uint32_t index) {
        return motion ? motion->at(time_of(options, *motion, index), box.center())
                      : camera_of(options, points, target.aspect(), index);
    };
    render::Scene light;  // stays where it is when the camera moves
    light.sun_direction = sun_beside(motion ? motion->at(motion->begin(), box.center()) : camera(0));
    renderer.set_scene(light);
    std::vector<float> cpu_ms;
    for (uint32_t i = 0; i < options.frames; ++i) {
        say_step("drawing " + frame_path(options, i));
        renderer.draw(target, camera(i));
        cpu_ms.push_back(static_cast<float>(renderer.stats().cpu_ms));
        write_png(renderer.capture(target), frame_path(options, i));
    }
    report.quality.update({{"device", renderer.device_name()},
                           {"triangles", renderer.stats().triangles},
                           {"draw_calls", renderer.stats().draw_calls},
                           {"device_bytes", renderer.stats().device_bytes},
                           {"frame_cpu_p50_ms", percentile(cpu_ms, 0.5)},
                           {"frame_cpu_max_ms", percentile(cpu_ms, 1.0)}});
    report.write();
}

}  // namespace

Command add_render(CLI::App& program, const CommonOptions& common) {
    CLI::App* app = program.add_subcommand("render", "Draws curves and meshes into a picture, without a window");
    const auto o = std::make_shared<Options>();
    app->add_option("FILE", o->scene.files, "Curves and meshes: files or builtin:NAME")->required();
    app->add_option("-o,--output", o->output, "The picture")->required()->type_name("OUT.png");
    app->add_option("--size", o->size, "Pixels, 1 to 16384 each")->type_name("WxH")->capture_default_str();
    add_choice(*app, "--as", o->scene.as, shape_names(),
               "How curves are drawn. auto: tubes, but of a sketch (.tilt) ribbons where its brushes are flat");
    app->add_option(
           "--camera", o->camera,
           "YAW,PITCH[,ZOOM] of a camera that sees all (degrees; 0,0 looks along -z, positive pitch from above), "
           "or EX,EY,EZ,TX,TY,TZ: eye and target, metres")
        ->delimiter(',')
        ->expected(1, 6)
        ->type_name("...")
        ->check(finite())
        ->capture_default_str();
    app->add_option("--camera-motion", o->scene.camera_motion,
                    "The camera follows a motion (see filigree motion), looking along the body's -z: at --time, or "
                    "with --frames all along it")
        ->type_name("KEYS.json")
        ->excludes("--camera");
    app->add_option("--camera-obstacles", o->scene.camera_obstacles, "What that camera keeps out of")
        ->type_name("OBSTACLES.json")
        ->needs("--camera-motion");
    app->add_option("--frames", o->frames,
                    "Pictures of a turn around or of a motion, 1 to 10000; several are called OUT-0001.png ...")
        ->capture_default_str()
        ->check(CLI::Range(1u, kMaxFrames).description(""));
    app->add_option("--radius", o->scene.radius,
                    "Radius of curves that bring none, metres; 0 = from the size of the whole")
        ->capture_default_str()
        ->check(at_least_zero());
    app->add_option("--field", o->scene.field,
                    "Colours the mesh, of which there must be one, by these values: one a vertex and line, inf where "
                    "there is none (grey)")
        ->type_name("FIELD.txt");
    app->add_option("--every", o->scene.every,
                    "Between isolines of the field, in its unit; 0 = a round number that gives up to 20")
        ->type_name("D")
        ->capture_default_str()
        ->check(at_least_zero());
    app->add_option("--time", o->scene.pose.time,
                    "Skins in their pose at T seconds of their first animation; without it at rest")
        ->type_name("T")
        ->check(finite());
    app->add_option("--animation", o->scene.pose.animation, "The animation that --time is of, by its name")
        ->type_name("NAME");
    add_choice(
        *app, "--skinning", o->scene.pose.skinning, kSkinnings,
        "How a skin's vertices follow several joints: by the mean of what they do, or by the rigid motion between, "
        "as dual quaternions have it");
    app->add_flag("--bones", o->scene.bones, "Draws a skin's joints and bones over it");
    return {app, [o, &common] { run_render(*o, common); }};
}

}  // namespace flg::cli
