// SPDX-License-Identifier: MIT
// Frames of the renderer: the paper's largest ribbon, a scene of everything, stereo, tubes against triangles, live
// strokes, the first picture. A frame's time is the device's; on a device in software the wall's clock, the shortest of
// a few frames: what else the machine does is not the frame's.
#include <time.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <limits>

#include "bench/groups.h"
#include "bench/host.h"
#include "bench/meshes.h"
#include "filigree/filigree_brush.h"
#include "filigree_renderer/renderer.h"

namespace flg::bench {
namespace {

constexpr uint32_t kWidth = 1280, kHeight = 720;
constexpr uint32_t kRibbonPoints = 369'400, kStrands = 2000, kTriangles = 2'000'000;
constexpr uint32_t kTubePoints = 60'000, kTubeSides = 12;
constexpr int kFrames = 5;  // steady: a frame is what it was before

// A tube as triangles made on the processor: what the renderer's expansion in the vertex shader is measured against.
struct TubeMesh {
    std::vector<float> positions, normals;
    std::vector<uint32_t> triangles;

    TubeMesh(const FlgCurveSetView& curves, float radius) {
        FlgBrushMeshDesc desc = flgBrushMeshDefaults();
        desc.curves = &curves;
        desc.sides = kTubeSides;
        desc.default_radius = radius;
        desc.start_cap = desc.end_cap = FLG_BRUSH_CAP_NONE;
        desc.join = FLG_BRUSH_JOIN_NARROW;
        FlgBrushMeshSizes sizes = flgBrushMeshSizesDefaults();
        check(flgBrushMeshGetSizes(&desc, nullptr, &sizes));
        positions.resize(3 * sizes.vertex_count);
        normals.resize(3 * sizes.vertex_count);
        triangles.resize(sizes.index_count);
        const FlgBufferColumn columns[] = {
            {FLG_ATTRIBUTE_POSITION, FLG_NUMBER_FORMAT_FLOAT32, positions.data(), 0, 0, {}, 0, 0},
            {FLG_ATTRIBUTE_NORMAL, FLG_NUMBER_FORMAT_FLOAT32, normals.data(), 0, 0, {}, 0, 0}};
        FlgBrushMeshOutput output = flgBrushMeshOutputDefaults();
        output.columns = columns;
        output.column_count = 2;
        output.vertex_capacity = sizes.vertex_count;
        output.indices = triangles.data();
        output.index_capacity = sizes.index_count;
        check(flgBrushMeshWrite(&desc, nullptr, &output, nullptr));
    }

    render::SurfaceId upload(render::Renderer& renderer, const render::SurfaceLook& look) const {
        const FlgColumn columns[] = {{FLG_ATTRIBUTE_POSITION, 3, positions.data(), 0, 0},
                                     {FLG_ATTRIBUTE_NORMAL, 3, normals.data(), 0, 0}};
        FlgMeshView view = flgMeshViewDefaults();
        view.vertex_count = static_cast<uint32_t>(positions.size() / 3);
        view.triangle_count = static_cast<uint32_t>(triangles.size() / 3);
        view.columns = columns;
        view.column_count = 2;
        view.triangles = triangles.data();
        return renderer.upload(view, look);
    }
};

double process_ms() {
    timespec now = {};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

bool in_software(const render::Renderer& renderer) {
    return renderer.device_name().find("llvmpipe") != std::string::npos;
}

double wall_ms(const std::function<void()>& work) {
    const auto start = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

// Of one frame, of which `draw` draws one.
double frame_ms(render::Renderer& renderer, const std::function<void()>& draw) {
    draw();  // uploads, and the shadow map
    renderer.wait_idle();
    double shortest_ms = std::numeric_limits<double>::infinity();
    for (int i = 0; i < kFrames; ++i) {
        const double ms = wall_ms([&] {
            draw();
            renderer.wait_idle();
        });
        shortest_ms = std::min(shortest_ms, in_software(renderer) ? ms : renderer.stats().gpu_ms);
    }
    return shortest_ms;
}

// As programs that people wait for have it.
render::Options usual() {
    render::Options options;
    options.samples = 0;
    return options;
}

render::CurvesId upload_ribbon(render::Renderer& renderer, const render::CurveLook& look) {
    Host host;
    return renderer.upload(host.view(host.add(scenes::make_target("thomas", kRibbonPoints))), look);
}

render::CurveLook ribbon_look() {
    render::CurveLook look;
    look.radius = 0.01f;
    return look;
}

void add_everything(render::Renderer& renderer) {
    Host host;
    const scenes::Scene hair = scenes::make_scene("hair", kStrands);
    renderer.upload(host.view(host.add(hair.curves)));
    FlgColumn column;
    const MeshArrays torus = wavy_torus(kTriangles, 0.02);
    FlgMeshView mesh = torus.view(column);
    // Slanted bands.
    std::vector<uint32_t> regions(mesh.triangle_count);
    for (uint32_t i = 0; i < mesh.triangle_count; ++i) {
        const float* corner = &torus.positions[3 * size_t{torus.triangles[3 * size_t{i}]}];
        regions[i] = static_cast<uint32_t>(std::floor(6.0f * (corner[0] + corner[1] + corner[2]) + 60.0f)) % 3;
    }
    mesh.regions = regions.data();
    render::SurfaceLook look;
    look.regions = {render::Material{}, {.color = {0.1f, 0.3f, 0.5f}}, {.color = {0.6f, 0.5f, 0.2f}, .metallic = 1.0f}};
    look.border_width_px = 1.5f;
    renderer.upload(mesh, look);
}

void ribbon_rows(std::vector<Row>& rows) {
    render::Renderer renderer(usual());
    upload_ribbon(renderer, ribbon_look());
    render::Target target(renderer, kWidth, kHeight);
    const render::Camera camera = frame_box(renderer.bounds(), {-1.0f, -0.5f, -1.0f}, target.aspect());
    const double mono_ms = frame_ms(renderer, [&] { renderer.draw(target, camera); });
    const render::FrameStats stats = renderer.stats();
    // Where frames take long, programs draw a quarter of the pixels while something moves.
    const bool slow = in_software(renderer);
    const render::DrawOptions moving = {.changing_scale = slow ? 0.5f : 1.0f};
    const double moving_ms = frame_ms(renderer, [&] { renderer.draw(target, camera, moving); });
    char note[200];
    std::snprintf(note, sizeof note,
                  "%s: %.1f ms; on the device %.1f ms: curves %.1f, backdrop %.1f, finish %.1f; %llu triangles",
                  renderer.device_name().c_str(), mono_ms, stats.gpu_ms, stats.gpu_curves_ms, stats.gpu_backdrop_ms,
                  stats.gpu_finish_ms, static_cast<unsigned long long>(stats.triangles));
    const double min_frames = slow ? 12.0 : 500.0;
    rows.push_back(at_least("ribbon of 369,400 points, 1280 x 720: frames", 1e3 / mono_ms, "/s", min_frames, note));
    rows.push_back(at_least("the same while it moves, with fewer pixels where frames take long: frames",
                            1e3 / moving_ms, "/s", min_frames, ""));

    render::StereoTarget both(renderer, kWidth, kHeight);
    render::Camera eyes[2] = {camera, camera};
    eyes[1].eye.x += 0.064f;
    eyes[1].target.x += 0.064f;
    const double stereo_ms = frame_ms(renderer, [&] { renderer.draw(both, eyes); });
    std::snprintf(note, sizeof note, "%.1f ms against %.1f ms for one eye", stereo_ms, mono_ms);
    rows.push_back(below("both eyes in one frame over two frames", stereo_ms / (2.0 * mono_ms), "", 1.05, note));

    add_everything(renderer);
    const render::Camera wide = frame_box(renderer.bounds(), {-1.0f, -0.5f, -1.0f}, target.aspect());
    std::vector<double> recorded;
    for (int i = 0; i < kFrames; ++i) {
        renderer.draw(target, wide);
        renderer.wait_idle();
        recorded.push_back(renderer.stats().cpu_ms);
    }
    std::snprintf(note, sizeof note, "%u draw calls, %.1f M triangles, %llu MB held", renderer.stats().draw_calls,
                  1e-6 * static_cast<double>(renderer.stats().triangles),
                  static_cast<unsigned long long>(renderer.stats().device_bytes >> 20));
    rows.push_back(
        below("ribbon, 2,000 strands, 2 M triangles: processor outside the driver", median(recorded), "ms", 0.5, note));
}

// Pixels where a picture is not the empty scene's.
std::vector<bool> covered(const render::Image& image, const render::Image& empty) {
    std::vector<bool> mask;
    for (size_t i = 0; i < image.pixels.size(); i += 4) {
        int most = 0;
        for (size_t c = i; c < i + 3; ++c) most = std::max(most, std::abs(image.pixels[c] - empty.pixels[c]));
        mask.push_back(most > 12);
    }
    return mask;
}

void tube_rows(std::vector<Row>& rows) {
    render::Options options;
    options.shadow_size = 0;  // surfaces look into the shadow map more often than curves
    render::Renderer renderer(options);
    render::Scene scene;
    scene.ground = false;
    renderer.set_scene(scene);
    render::Target target(renderer, kWidth, kHeight);
    const scenes::Curve curve = scenes::make_target("thomas", kTubePoints);
    render::CurveLook look;
    look.shape = render::Shape::tube;
    look.caps = render::Caps::none;
    look.sides = kTubeSides;
    look.radius = 0.03f;
    look.color = look.color_end = {0.1f, 0.1f, 0.1f};
    Host host;
    const FlgCurveSet tube = host.add(curve);
    const render::CurvesId tubes = renderer.upload(host.view(tube), look);
    const render::Camera camera = frame_box(renderer.bounds(), {-1.0f, -0.5f, -1.0f}, target.aspect());
    const auto draw = [&] { renderer.draw(target, camera); };
    const double tubes_ms = frame_ms(renderer, draw);
    const render::Image tube_image = renderer.capture(target);
    const double tube_bytes = static_cast<double>(renderer.memory().curves);
    renderer.remove(tubes);

    const TubeMesh mesh(host.view(tube), look.radius);
    render::SurfaceLook surface_look;
    surface_look.material = {.color = look.color, .roughness = 0.6f};
    const render::SurfaceId triangles = mesh.upload(renderer, surface_look);
    const double triangles_ms = frame_ms(renderer, draw);
    const render::Image triangle_image = renderer.capture(target);
    const double triangle_bytes = static_cast<double>(renderer.memory().surfaces);
    renderer.remove(triangles);
    draw();
    const render::Image empty = renderer.capture(target);

    const std::vector<bool> a = covered(tube_image, empty), b = covered(triangle_image, empty);
    double either = 0.0, one = 0.0;
    for (size_t i = 0; i < a.size(); ++i) {
        either += a[i] || b[i];
        one += a[i] != b[i];
    }
    char note[160];
    std::snprintf(note, sizeof note, "%.1f MB against %.1f MB", 1e-6 * tube_bytes, 1e-6 * triangle_bytes);
    rows.push_back(
        below("tubes expanded on the device over triangles: memory", tube_bytes / triangle_bytes, "", 0.2, note));
    std::snprintf(note, sizeof note, "%.1f ms against %.1f ms", tubes_ms, triangles_ms);
    rows.push_back(below("tubes expanded on the device over triangles: frame", tubes_ms / triangles_ms, "", 1.0, note));
    rows.push_back(
        below("tubes expanded on the device and triangles: pixels only one covers", 100.0 * one / either, "%", 3.0));
}

// Bytes of the frame in which a sample's points were new, after so many points.
double growth_bytes(render::Renderer& renderer, render::Target& target, uint32_t length) {
    constexpr uint32_t kNew = 10;  // points of a sample
    std::vector<float> positions;
    for (uint32_t i = 0; i < length + kNew; ++i) {
        const float t = 0.01f * static_cast<float>(i);
        positions.insert(positions.end(), {std::sin(t), 1e-4f * t, std::cos(t)});
    }
    const auto append = [&](render::CurvesId id, uint32_t first, uint32_t count) {
        const FlgColumn column = {FLG_ATTRIBUTE_POSITION, 3, &positions[3 * size_t{first}], 0, 0};
        const uint32_t offsets[2] = {0, count};
        FlgCurveSetView view = flgCurveSetViewDefaults();
        view.curve_count = 1;
        view.curve_offsets = offsets;
        view.columns = &column;
        view.column_count = 1;
        renderer.append(id, view);
        renderer.draw(target, {});
    };
    const render::CurvesId id = renderer.begin_growing({}, length + kNew);
    append(id, 0, length);
    append(id, length, kNew);
    renderer.remove(id);
    return static_cast<double>(renderer.stats().uploaded_bytes);
}

void growth_rows(std::vector<Row>& rows) {
    render::Renderer renderer;
    render::Target target(renderer, 64, 64);
    // Neither begins a chunk.
    const double after_few = growth_bytes(renderer, target, 130), after_many = growth_bytes(renderer, target, 128'002);
    char note[80];
    std::snprintf(note, sizeof note, "%.0f B for 10 points after 130, %.0f B after 128,002", after_few, after_many);
    rows.push_back(within("live stroke: upload of a sample, after 128,002 points over after 130",
                          after_many / after_few, "", 1.0, 0.0, note));
}

void start_rows(std::vector<Row>& rows) {
    Host host;
    const FlgCurveSetView view = host.view(host.add(scenes::make_target("thomas", kRibbonPoints)));
    const double before_ms = process_ms();
    const double first_ms = wall_ms([&] {
        render::Renderer renderer(usual());
        renderer.upload(view, ribbon_look());
        render::Target target(renderer, kWidth, kHeight);
        renderer.draw(target, frame_box(renderer.bounds(), {-1.0f, -0.5f, -1.0f}, target.aspect()));
        renderer.capture(target);
    });
    char note[80];
    std::snprintf(note, sizeof note, "%.0f ms of processor time, all threads", process_ms() - before_ms);
    rows.push_back(below("start to first picture of 369,400 points", 1e-3 * first_ms, "s", 1.0, note));
}

}  // namespace

std::vector<Row> run_drawing() {
    std::vector<Row> rows;
    try {
        start_rows(rows);  // while nothing is compiled yet
        ribbon_rows(rows);
        tube_rows(rows);
        growth_rows(rows);
    } catch (const render::Error& error) {
        rows.push_back(below("frames", std::nan(""), "", 0.0, error.what()));
    }
    return rows;
}

}  // namespace flg::bench
