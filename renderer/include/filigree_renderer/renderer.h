// SPDX-License-Identifier: MIT
// Filigree's renderer: draws curves as ribbons, tubes and lines, and surfaces, with Vulkan, offscreen or in a window.
//
//     flg::render::Renderer renderer;
//     renderer.upload(view, {.shape = Shape::tube, .radius = 0.01f});
//     flg::render::Target target(renderer, 1280, 720);
//     renderer.draw(target, frame_box(renderer.bounds(), {-1, -0.4f, -1}, target.aspect()));
//     write_png(renderer.capture(target), "out.png");
//
// Errors are thrown as flg::render::Error, one sentence each. One thread at a time may use a Renderer with its targets
// and windows; several renderers in a process are independent. Only Window needs a display. Same input, same device:
// same bits.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "filigree/filigree.h"
#include "filigree/filigree_model.h"
#include "filigree/filigree_surface.h"
#include "filigree_renderer/camera.h"
#include "filigree_renderer/error.h"
#include "filigree_renderer/image.h"
#include "filigree_renderer/placement.h"
#include "filigree_renderer/surface_look.h"
#include "filigree_renderer/ui.h"

namespace flg::render {

// How a StereoTarget's two eyes are drawn.
enum class StereoPasses {
    automatic,  // in one pass, except on llvmpipe, which draws it wrong (renderer/README.md)
    one,        // multiview
    two         // one pass per eye
};

struct Options {
    // Part of the name of the Vulkan device to use. Empty: the device named by the environment variable
    // FLG_RENDERER_DEVICE, else the first discrete, integrated, virtual or CPU device, in this order.
    std::string device;
    // Enables the Khronos validation layer, including synchronization; Renderer::messages() keeps its messages.
    bool validation = false;
    // Samples per pixel: 1, 2, 4 or 8; fewer if the device supports fewer. 1 = no anti-aliasing. 0 = chosen for
    // interactive programs: 4, but 1 on CPU devices, where 4 samples cost as much as five pictures.
    uint32_t samples = 4;
    // Edge of the sun's shadow map, pixels, 256 to 8192; 0 = no shadows.
    uint32_t shadow_size = 2048;
    // Maximum device memory for the renderer, bytes; 0 = four fifths of the device's own. Exceeding it throws, and
    // nothing changes. A window's own images belong to the system and do not count.
    uint64_t memory_limit_bytes = 0;
    // Points of curves in one device buffer, at least 128; uploads with more are divided, and drawn as if they were
    // not. 0 = as many as the device allows: 8 million on lavapipe.
    uint32_t max_points = 0;
    // For shader authors: folder with the files of shaders/, compiled at startup in place of the built-in ones. Only in
    // programs linked with filigree_shader_compiler; others throw. Empty: built in.
    std::string shader_folder;
    StereoPasses stereo = StereoPasses::automatic;
};

enum class Shape {
    ribbon,  // two-sided band, 2 * radius wide along tangent x normal
    tube,    // round, with that radius
    line     // fixed width in pixels, always facing the camera; casts no shadow
};

enum class Caps { round, flat, none };

// Appearance of a set of curves.
struct CurveLook {
    Shape shape = Shape::ribbon;
    // Linear RGB, if the set has no COLOR column: from the first to the last point of each curve; on closed curves
    // there and back.
    glm::vec3 color{0.90f, 0.13f, 0.03f};
    glm::vec3 color_end{0.50f, 0.02f, 0.22f};
    float radius = 0.005f;       // metres, if the set has no RADIUS column; >= 0
    float radius_scale = 1.0f;   // applies to either; >= 0
    uint32_t sides = 12;         // maximum for a tube, 3 to 32; tubes small on the screen get fewer
    Caps caps = Caps::round;     // of a tube's ends
    float line_width_px = 1.5f;  // of a line, 0.5 to 64
    float gloss = 0.4f;          // 0 = matte to 1 = polished
    bool casts_shadow = true;
    // Drawn over everything else that is not in front, and without its shadows: bones within a body. Not over objects
    // very near the camera, within a twentieth of the way to its target.
    bool in_front = false;
};

// Light and environment. Colours are linear RGB.
struct Scene {
    glm::vec3 sun_direction{0.45f, 0.80f, 0.40f};  // towards the sun, any length but zero
    glm::vec3 sun_color{3.9f, 3.6f, 3.15f};
    glm::vec3 sky_color{0.62f, 0.72f, 0.90f};     // light from above ...
    glm::vec3 bounce_color{0.42f, 0.36f, 0.32f};  // ... and from below
    glm::vec3 background_top{0.50f, 0.66f, 0.86f};
    glm::vec3 background_bottom{1.30f, 1.26f, 1.20f};
    bool ground = true;                  // a floor that receives shadows
    std::optional<float> ground_height;  // metres; none: at the lowest point of the scene
    float exposure = 1.0f;               // > 0
};

// Uploaded objects; zero is none.
struct CurvesId {
    uint64_t value = 0;
    bool operator==(const CurvesId&) const = default;
};
struct SurfaceId {
    uint64_t value = 0;
    bool operator==(const SurfaceId&) const = default;
};

// The last frame recorded by draw(), except gpu_*: those are of the newest frame the device has finished.
struct FrameStats {
    double cpu_ms = 0;     // of draw(), without the three below
    double submit_ms = 0;  // in the driver: submission and presentation
    double wait_ms = 0;    // waiting for the device, which may be two frames behind
    double gpu_ms = -1;    // of the whole frame on the device; -1: unknown, as for those below
    // Consecutive parts of it. Devices may overlap them; then a part ends when the last before it has.
    double gpu_uploads_ms = -1;
    double gpu_shadow_ms = -1;  // the shadow map; 0 when it could be kept
    double gpu_surfaces_ms = -1;
    double gpu_curves_ms = -1;
    double gpu_backdrop_ms = -1;  // including the mean of each pixel's samples
    double gpu_finish_ms = -1;    // occlusion of ambient light; the mean of frames
    double gpu_ui_ms = -1;
    uint32_t draw_calls = 0;
    uint64_t triangles = 0;       // of the main pass, including caps and border lines
    uint64_t uploaded_bytes = 0;  // sent to the device with this frame
    uint64_t device_bytes = 0;    // memory held on the device
};

// Options of a frame besides the scene.
struct DrawOptions {
    UiFrame ui{};
    // The part of the target that shows the scene: x, y, width, height in pixels, within the target. The rest is black,
    // for the UI to cover. All 0: the whole target.
    glm::ivec4 viewport{0};
    // While only the UI changes between frames of a target, the picture improves: each frame varies a little, and the
    // target shows the mean of up to max_refined of them, with smooth edges and soft shadows. Then the picture stays,
    // and a frame costs a copy of it and the UI.
    bool refines = false;
    // Scales the resolution each way, 0.25 to 1, for the first frame after a change, which is then enlarged: for slow
    // frames.
    float changing_scale = 1.0f;
};

constexpr uint32_t max_refined = 16;

// The renderer's device memory, bytes.
struct MemoryReport {
    uint64_t limit = 0;
    uint64_t held = 0;  // all below, and free room in partly used blocks
    uint64_t curves = 0;
    uint64_t surfaces = 0;
    uint64_t textures = 0;
    uint64_t targets = 0;
    uint64_t shadow_map = 0;
    uint64_t staging = 0;  // in transit to or from the device
    uint64_t other = 0;    // tables, and data of frames in flight
};

class Renderer;
class TargetImage;
struct FrameSubmission;

// An image to draw into, no display needed.
class Target {
public:
    // 1 to 16384 pixels each way, within the device's limits.
    Target(Renderer& renderer, uint32_t width, uint32_t height);
    virtual ~Target();
    Target(const Target&) = delete;
    Target& operator=(const Target&) = delete;

    // Same limits. Waits for frames in flight; the picture is lost.
    void resize(uint32_t width, uint32_t height);
    uint32_t width() const;
    uint32_t height() const;
    float aspect() const { return static_cast<float>(width()) / static_cast<float>(height()); }
    // Number of frames averaged in the picture: 0 after a change and without DrawOptions::refines, up to max_refined.
    uint32_t refined() const;

protected:
    friend class Renderer;
    // A window's additions around each frame; a plain target needs none.
    virtual bool begin_frame(uint32_t slot);
    virtual void end_frame(FrameSubmission& submission);
    virtual void present(FrameSubmission& submission);
    // After begin_frame(): the frame will not be submitted.
    virtual void abandon_frame() noexcept;
    // The renderer moves to another device; the image is handled separately.
    virtual void leave_device() noexcept;

    Renderer& renderer_;
    std::unique_ptr<TargetImage> image_;
};

// Two images of the same size, one per eye.
class StereoTarget {
public:
    // Sizes as for a Target. The first StereoTarget also makes the pipelines for two eyes.
    StereoTarget(Renderer& renderer, uint32_t width, uint32_t height);
    ~StereoTarget();
    StereoTarget(const StereoTarget&) = delete;
    StereoTarget& operator=(const StereoTarget&) = delete;

    uint32_t width() const;
    uint32_t height() const;
    float aspect() const { return static_cast<float>(width()) / static_cast<float>(height()); }

private:
    friend class Renderer;
    Renderer& renderer_;
    std::vector<std::unique_ptr<TargetImage>> images_;  // one with two layers, or one per eye
};

// The work of upload() on a mesh before the copy, which is most of its cost: for a thread of the host's own.
class PreparedSurface {
public:
    // [any thread] Same parameters and exceptions as upload(). Cost: about 80 ns a triangle.
    explicit PreparedSurface(const FlgMeshView& mesh, const SurfaceLook& look = {}, std::span<const float> field = {});
    ~PreparedSurface();
    PreparedSurface(PreparedSurface&&) noexcept;
    PreparedSurface& operator=(PreparedSurface&&) noexcept;

private:
    friend class Renderer;
    struct State;
    std::unique_ptr<State> state_;
};

class Renderer {
public:
    explicit Renderer(const Options& options = {});
    ~Renderer();
    Renderer(const Renderer&) = delete;
    Renderer& operator=(const Renderer&) = delete;

    // Copies curves to the device, in the background of the next frames. Needs a POSITION column; uses RADIUS, COLOR,
    // NORMAL and DISPLACEMENT if present; without NORMAL it carries a rotation-minimizing frame along. Values must be
    // finite. Consecutive repeated points count once; zero-length curves are not drawn. The view is not needed
    // afterwards. Cost: one pass over the data, about 60 ns a point, more without NORMAL or with DISPLACEMENT.
    CurvesId upload(const FlgCurveSetView& view, const CurveLook& look = {});
    // Replaces the curves of `id`. On error nothing changes.
    void update(CurvesId id, const FlgCurveSetView& view, const CurveLook& look = {});
    // A curve that grows at its end, as a live stroke does: empty at first, with room for `capacity` points, 2 to 2^22.
    // The picture equals that of upload() with all points, bit for bit, except that without a COLOR column the look's
    // `color` applies throughout. It cannot be closed, and DISPLACEMENT is not used. update() replaces it with curves
    // that do not grow. Cost: 24 bytes a point of capacity on the device, at once; 60 on the host, as they are used.
    CurvesId begin_growing(const CurveLook& look, uint32_t capacity);
    // Appends the points of a view's only curve; columns as for upload(). On error nothing changes. Cost: about 60 ns a
    // point. The next frame uploads 24 bytes for each new point and for the last one before, whose direction is now
    // known, and 16 for each 64 points, whatever is there already. Everything is uploaded once more only when the first
    // NORMAL arrives that does not point along the curve. Takes no memory.
    void append(CurvesId id, const FlgCurveSetView& view);
    // Removes points from its end, as a live stroke's undo does: keeps the first `points` appended, as if no more had
    // come.
    void truncate(CurvesId id, uint32_t points);
    // Changes the magnitude afterwards, on the device (sec. 4.5.3 of the paper): draws POSITION + offset *
    // DISPLACEMENT, so curves stylized at magnitude m appear at m + offset; offset in -1e6 to 1e6. Tubes and ribbons
    // follow the displaced curve, ribbons by their NORMAL column; without one they keep the frame carried along at
    // upload. 0 after upload() and update(). Needs curves with a DISPLACEMENT column. Cost: the call takes under a
    // microsecond for any number of points and uploads nothing; the shadow map is redrawn. A frame's vertices take
    // longer while the offset is not 0: each ring is followed from the start of its chunk.
    void set_magnitude_offset(CurvesId id, float offset);
    // Copies a surface to the device, in the background of the next frames; from an FlgSurfaceView, pass its `mesh`.
    // Needs a POSITION column; uses NORMAL, COLOR and regions if present. `field`: one value per vertex, as in an
    // FlgFieldView, infinite where there is none; empty for no field. Draws both sides; skips triangles without an
    // area. None of the arrays is needed afterwards. Curves and surfaces cast shadows on each other. Throws for a mesh
    // without triangles, indices out of range, positions that are not finite, NaN in the field, more than 2^24 - 1
    // vertices (those between regions count once per region) or 2^26 triangles. Cost: of the call about 80 ns a
    // triangle, no wait for the device; the device holds 28 bytes a vertex and 12 a triangle.
    SurfaceId upload(const FlgMeshView& mesh, const SurfaceLook& look = {}, std::span<const float> field = {});
    // Likewise. Cost: that of copying 28 bytes a vertex and 12 a triangle.
    SurfaceId upload(const PreparedSurface& prepared);
    // Replaces the surface of `id`, after a cut or for another look. Uploads all of it again. On error nothing changes.
    void update(SurfaceId id, const FlgMeshView& mesh, const SurfaceLook& look = {}, std::span<const float> field = {});
    // Copies a surface that follows joints, at rest. Vertex parts become regions: a triangle belongs to the part of two
    // of its corners, else of its first corner. No lines between regions: throws if the look has any. Throws also for
    // joints that do not exist, and for weights that are not 0 to 1 with the sum 1 and the largest first. Cost: as
    // above, and 16 bytes a vertex more.
    SurfaceId upload(const FlgSkinView& skin, const SurfaceLook& look = {});
    // Replaces the surface of `id` with a skin at rest. On error nothing changes.
    void update(SurfaceId id, const FlgSkinView& skin, const SurfaceLook& look = {});
    // The pose of a skin from the next frame on: its joints' transforms from flgSkinPose, 12 floats per joint for
    // FLG_SKINNING_LINEAR, 8 for FLG_SKINNING_DUAL_QUATERNION. The vertex shader moves vertices as flgSkinDeform does,
    // in the shadow map too. bounds() then contains all vertices, with a little margin where joints bend. Throws for a
    // surface without joints, another number of floats, floats that are not finite, quaternions not of length 1.
    // Cost: about 0.2 us a joint for the bounds; the mesh is not uploaded again, its joints are copied with each frame.
    void set_pose(SurfaceId id, FlgSkinning skinning, std::span<const float> transforms);
    // The placement of a surface from the next frame on, with its lines, joints and bounds(): the identity after
    // upload(), unchanged by update(). Uploads nothing. Throws for values that are not finite, a scale that is not > 0,
    // a turn not of length 1.
    void set_placement(SurfaceId id, const Placement& placement);
    // Copies a picture to the device as a UI texture: sampled linearly between texels, clamped at its edges.
    TextureId upload(const Image& image);
    // Replaces the texture of `id` with a picture of any size. On error nothing changes.
    void update(TextureId id, const Image& image);
    // Invisible objects are not drawn, cast no shadow and are not in bounds(). Kept by update().
    void set_visible(CurvesId id, bool visible);
    void set_visible(SurfaceId id, bool visible);
    // Zero does nothing. Throws for an id that was removed or never issued.
    void remove(CurvesId id);
    void remove(SurfaceId id);
    void remove(TextureId id);
    // Removes all curves and surfaces; textures stay.
    void clear();

    // Whether anything has changed since the last frame: if not, the same camera sees the same picture.
    bool changed() const;

    void set_scene(const Scene& scene);
    const Scene& scene() const;
    // Box of everything visible, including radii; lines count as thin.
    Box bounds() const;

    // Records and submits one frame; returns before it is drawn. Waits only when two frames are already in flight.
    // Skips a window that has no area at present (minimized). The camera's aspect is the viewport's. The UI is drawn
    // over the finished picture, with one sample per pixel; its vertices and indices are copied, without allocation
    // once buffers have grown to the largest frame. Throws for a viewport outside the target, indices out of range and
    // missing textures; if a window has shrunk since its size was queried, the viewport is clipped.
    void draw(Target& target, const Camera& camera, const DrawOptions& options = {});
    // Likewise for two eyes, left and right, in one pass (multiview): objects are selected, uploaded and recorded once
    // for both, with one shadow map. Each picture equals that of draw() with its eye's camera, except that curves have
    // the detail the nearer eye sees. `mirror`, such as a window, shows both side by side, each stretched over a half;
    // its own picture does not change. Options::stereo: two passes in one command buffer each count their triangles and
    // calls.
    void draw(StereoTarget& target, const Camera (&eyes)[2], Target* mirror = nullptr);
    // Waits for the target's last frame and copies it; black before the first.
    Image capture(Target& target);
    Image capture(StereoTarget& target, uint32_t eye);  // 0 or 1
    // Waits until all frames are drawn.
    void wait_idle();

    // Recompiles the shaders in options.shader_folder for the next frame; false: nothing has changed, or there is no
    // folder. On compile errors throws the compiler's message, and keeps the previous shaders.
    bool reload_shaders();

    // Continues with a new device, after DeviceLost or at any time. All curves, surfaces and textures are gone; their
    // ids become invalid and are never reused. Options, scene, targets and windows stay, without their pictures. On
    // error nothing changes, and the call can be repeated.
    void recover();
    // For tests, including hosts' own: draw(), capture(), wait_idle(), resize() and windows act as if the device were
    // lost, until recover(); the first `calls` driver calls among them still succeed. Uploads do not notice, as with
    // real losses.
    void simulate_device_loss(uint32_t calls = 0);

    const FrameStats& stats() const;
    // Removed or replaced memory is freed once the device is done with it; whole blocks return to the system when none
    // of them is used. The next draw(), wait_idle(), update() or remove() does this.
    MemoryReport memory() const;
    const std::string& device_name() const;
    uint32_t samples() const;
    // Messages of the validation layer since the start: empty in a correct program.
    const std::vector<std::string>& messages() const;

private:
    friend class StereoTarget;
    friend class Target;
    friend class Window;
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace flg::render
