// SPDX-License-Identifier: MIT
// Filigree's renderer: curves as ribbons, tubes and lines, and surfaces, by Vulkan, offscreen or in a window.
//
//     flg::render::Renderer renderer;
//     renderer.upload(view, {.shape = Shape::tube, .radius = 0.01f});
//     flg::render::Target target(renderer, 1280, 720);
//     renderer.draw(target, frame_box(renderer.bounds(), {-1, -0.4f, -1}, target.aspect()));
//     write_png(renderer.capture(target), "out.png");
//
// Errors are thrown as flg::render::Error, a sentence each. One thread at a time may use a Renderer with its targets and
// windows; several renderers in a process are independent. Nothing here needs a display except Window.
// Same input, same device: same bits.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "filigree/filigree.h"
#include "filigree/filigree_model.h"
#include "filigree/filigree_surface.h"
#include "filigree_renderer/camera.h"
#include "filigree_renderer/error.h"
#include "filigree_renderer/image.h"
#include "filigree_renderer/surface_look.h"
#include "filigree_renderer/ui.h"

namespace flg::render {

// How both eyes of a StereoTarget are drawn.
enum class StereoPasses {
    automatic,  // by one pass, but on llvmpipe, which goes wrong there (renderer/README.md)
    one,        // multiview
    two         // an eye each
};

struct Options {
    // Part of the name of the Vulkan device to use. Empty: what the environment variable FLG_RENDERER_DEVICE names, else the
    // first discrete, integrated, virtual or CPU device, in this order.
    std::string device;
    // Turns the Khronos validation layer on, synchronization included; what it says is kept in Renderer::messages().
    bool validation = false;
    // Samples a pixel: 1, 2, 4 or 8; fewer where the device has fewer. 1 = no anti-aliasing. 0 = as programs that people
    // wait for want it: 4, but 1 where the device is a processor, which 4 cost as much as five pictures.
    uint32_t samples = 4;
    // Edge of the sun's shadow map, pixels, 256 to 8192; 0 = no shadows.
    uint32_t shadow_size = 2048;
    // The most memory the renderer may hold on the device, bytes; 0 = four fifths of the device's own. What would take it
    // beyond throws, and nothing changes. A window's own images, which are the system's, don't count.
    uint64_t memory_limit_bytes = 0;
    // For those who write shaders: where the files of shaders/ lie, which are then compiled at the start instead of those the
    // program was built with. Only in programs linked with filigree_shader_compiler; others throw. Empty: built in.
    std::string shader_folder;
    StereoPasses stereo = StereoPasses::automatic;
};

enum class Shape {
    ribbon,  // two-sided band, 2 radius wide along tangent x normal
    tube,    // round, of that radius
    line     // of a fixed width in pixels, always facing the camera; casts no shadow
};

enum class Caps { round, flat, none };

// How a set of curves looks.
struct CurveLook {
    Shape shape = Shape::ribbon;
    // Linear RGB, where the set has no COLOR column: from the first to the last point of each curve, on
    // closed ones there and back.
    glm::vec3 color{0.90f, 0.13f, 0.03f};
    glm::vec3 color_end{0.50f, 0.02f, 0.22f};
    float radius = 0.005f;       // metres, where the set has no RADIUS column; >= 0
    float radius_scale = 1.0f;   // on either; >= 0
    uint32_t sides = 12;         // of a tube, 3 to 32: the most; tubes small on the screen get fewer
    Caps caps = Caps::round;     // of a tube's ends
    float line_width_px = 1.5f;  // of a line, 0.5 to 64
    float gloss = 0.4f;          // 0 = matte to 1 = polished
    bool casts_shadow = true;
    // Drawn over everything that is not, and without its shadows: bones within a body. Not over what is very near, within a twentieth of the way to the
    // camera's target.
    bool in_front = false;
};

// Light and surroundings. Colours are linear RGB.
struct Scene {
    glm::vec3 sun_direction{0.45f, 0.80f, 0.40f};  // towards the sun, any length but zero
    glm::vec3 sun_color{3.9f, 3.6f, 3.15f};
    glm::vec3 sky_color{0.62f, 0.72f, 0.90f};     // light from above ...
    glm::vec3 bounce_color{0.42f, 0.36f, 0.32f};  // ... and from below
    glm::vec3 background_top{0.50f, 0.66f, 0.86f};
    glm::vec3 background_bottom{1.30f, 1.26f, 1.20f};
    bool ground = true;     // a floor at the lowest point of the scene that takes shadows
    float exposure = 1.0f;  // > 0
};

// What is uploaded; zero is none.
struct CurvesId {
    uint64_t value = 0;
    bool operator==(const CurvesId&) const = default;
};
struct SurfaceId {
    uint64_t value = 0;
    bool operator==(const SurfaceId&) const = default;
};

// The last frame that draw() recorded, but for gpu_*: those are of the newest frame the device has finished.
struct FrameStats {
    double cpu_ms = 0;     // of draw(), without the three below
    double submit_ms = 0;  // in the driver: submission and presentation
    double wait_ms = 0;    // for the device, which may be two frames behind
    double gpu_ms = -1;    // of the whole frame on the device; -1: not known, as for those below
    // Of it, one after the other. Devices may overlap them, and then a part ends when the last before it has.
    double gpu_uploads_ms = -1;
    double gpu_shadow_ms = -1;  // the shadow map; 0 when it could be kept
    double gpu_surfaces_ms = -1;
    double gpu_curves_ms = -1;
    double gpu_backdrop_ms = -1;  // and the mean of each pixel's samples
    double gpu_ui_ms = -1;
    uint32_t draw_calls = 0;
    uint64_t triangles = 0;       // of the main pass, caps and border lines included
    uint64_t uploaded_bytes = 0;  // on their way to the device with this frame
    uint64_t device_bytes = 0;    // of memory held on the device
};

// What a frame shows besides the scene.
struct DrawOptions {
    UiFrame ui{};
    // The part of the target that the scene's picture fills: x, y, width, height in pixels, within the target. The rest is
    // black, for the UI to cover. All 0: the whole target.
    glm::ivec4 viewport{0};
};

// What the renderer holds of the device's memory, bytes.
struct MemoryReport {
    uint64_t limit = 0;
    uint64_t held = 0;  // all below, and room for more in blocks that are partly used
    uint64_t curves = 0;
    uint64_t surfaces = 0;
    uint64_t textures = 0;
    uint64_t targets = 0;
    uint64_t shadow_map = 0;
    uint64_t staging = 0;  // on the way to the device or back
    uint64_t other = 0;    // tables, and what frames in flight need
};

class Renderer;
class TargetImage;
struct FrameSubmission;

// An image to draw into, no display needed.
class Target {
public:
    // 1 to 16384 pixels each way, and no more than the device allows.
    Target(Renderer& renderer, uint32_t width, uint32_t height);
    virtual ~Target();
    Target(const Target&) = delete;
    Target& operator=(const Target&) = delete;

    // Same limits. Frames in flight are waited for; the picture is lost.
    void resize(uint32_t width, uint32_t height);
    uint32_t width() const;
    uint32_t height() const;
    float aspect() const { return static_cast<float>(width()) / static_cast<float>(height()); }

protected:
    friend class Renderer;
    // What a window adds around each frame; a plain target needs none of it.
    virtual bool begin_frame(uint32_t slot);
    virtual void end_frame(FrameSubmission& submission);
    virtual void present(FrameSubmission& submission);
    // After begin_frame(): the frame will not be submitted.
    virtual void abandon_frame() noexcept;
    // The renderer goes on with another device; the image is looked after.
    virtual void leave_device() noexcept;

    Renderer& renderer_;
    std::unique_ptr<TargetImage> image_;
};

// Two images of one size, an eye each.
class StereoTarget {
public:
    // Sizes as of a Target. The first also makes the pipelines for two eyes.
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
    std::vector<std::unique_ptr<TargetImage>> images_;  // one of two layers, or one an eye
};

class Renderer {
public:
    explicit Renderer(const Options& options = {});
    ~Renderer();
    Renderer(const Renderer&) = delete;
    Renderer& operator=(const Renderer&) = delete;

    // Copies curves to the device, in the background of the next frames. Needs a POSITION column; takes RADIUS, COLOR, NORMAL
    // and DISPLACEMENT where there are; without NORMAL it carries a rotation-minimizing frame along. Values must be finite.
    // Points repeated in a row count once, curves without length are not drawn. The view is not needed afterwards.
    // Cost: one pass over the data, about 60 ns a point, more without NORMAL or with DISPLACEMENT.
    CurvesId upload(const FlgCurveSetView& view, const CurveLook& look = {});
    // Replaces what `id` shows. On error nothing changes.
    void update(CurvesId id, const FlgCurveSetView& view, const CurveLook& look = {});
    // A curve that grows at its end, as a live stroke does: nothing yet, and room for `capacity` points, 2 to 2^22. The picture
    // is that of upload() with all of its points, bit for bit, but that without a COLOR column it is of the look's `color`
    // throughout. It can't be closed, DISPLACEMENT is not taken. update() replaces it by curves that don't grow.
    // Cost: 24 bytes a point of capacity on the device, at once; 60 on the host, as they are used.
    CurvesId begin_growing(const CurveLook& look, uint32_t capacity);
    // Appends the points of a view's only curve; columns as of upload(). On error nothing changes.
    // Cost: about 60 ns a point. 24 bytes for each, for the last one before, whose direction is now known, and 16 for
    // each 64 points go to the device with the next frame, whatever is there already; all of it once more only when the first
    // NORMAL comes that does not point along the curve. No memory is taken.
    void append(CurvesId id, const FlgCurveSetView& view);
    // Takes points off its end, as a live stroke's undo does: leaves `points` of those appended. As if no more had come.
    void truncate(CurvesId id, uint32_t points);
    // Magnitude changed after the fact, on the device (sec. 4.5.3 of the paper): draws POSITION + offset * DISPLACEMENT, so
    // that curves stylized at magnitude m are shown at m + offset, in -1e6 to 1e6. Tubes and ribbons follow the curve as it
    // then is, ribbons by their NORMAL column; without one they keep the frame that was carried along the upload. 0 after
    // upload() and update(). Needs curves with a DISPLACEMENT column.
    // Cost: of the call under a microsecond, whatever the number of points, and nothing is uploaded; the shadow map is drawn
    // anew. A frame's vertices take longer while the offset is not 0: each ring is followed from the start of its chunk.
    void set_magnitude_offset(CurvesId id, float offset);
    // Copies a surface to the device, in the background of the next frames; of an FlgSurfaceView its `mesh`. Needs a
    // POSITION column; takes NORMAL and COLOR where there are, and regions. `field`: one value a vertex, as of an
    // FlgFieldView, infinite where there is none; empty for no field. Both sides are drawn, triangles without an area are
    // not. None of the arrays is needed afterwards. Shadows fall from curves on surfaces and the other way round.
    // Throws for a mesh without triangles, indices out of range, positions that are not finite, NaN in the field, more than
    // 2^24 - 1 vertices (those between regions counted once a region) or 2^26 triangles.
    // Cost: of the call about 80 ns a triangle, no wait for the device; 28 bytes a vertex and 12 a triangle are held there.
    SurfaceId upload(const FlgMeshView& mesh, const SurfaceLook& look = {}, std::span<const float> field = {});
    // Replaces what `id` shows, after a cut or for another look. All of it is uploaded again. On error nothing changes.
    void update(SurfaceId id, const FlgMeshView& mesh, const SurfaceLook& look = {}, std::span<const float> field = {});
    // Copies a surface that follows joints, at rest. Parts of vertices are regions: a triangle is of the part that two of its
    // corners are of, else of the first's. No lines between regions: throws if the look has any. Besides what is said above
    // it throws for joints that are not there, weights that are not 0 to 1 with the sum 1 and the largest first.
    // Cost: as above, and 16 bytes a vertex more.
    SurfaceId upload(const FlgSkinView& skin, const SurfaceLook& look = {});
    // Replaces what `id` shows, by a skin at rest. On error nothing changes.
    void update(SurfaceId id, const FlgSkinView& skin, const SurfaceLook& look = {});
    // The pose of a skin from the next frame on: its joints' transforms as flgSkinPose makes them, 12 floats a joint for
    // FLG_SKINNING_LINEAR, 8 for FLG_SKINNING_DUAL_QUATERNION. Vertices are moved in the vertex shader, in the shadow map
    // too, by what flgSkinDeform says. bounds() then is around all vertices, and a little wider where joints bend.
    // Throws for a surface without joints, another number of floats, floats that are not finite, quaternions not of length 1.
    // Cost: about 0.2 us a joint for the bounds; the mesh is not uploaded again, its joints are copied with each frame.
    void set_pose(SurfaceId id, FlgSkinning skinning, std::span<const float> transforms);
    // Copies a picture to the device for the UI to draw with: sampled linearly between texels, clamped at its edges.
    TextureId upload(const Image& image);
    // Replaces what `id` shows, by a picture of any size. On error nothing changes.
    void update(TextureId id, const Image& image);
    // What is not visible is not drawn, casts no shadow and is not in bounds(). Stays as it is over update().
    void set_visible(CurvesId id, bool visible);
    void set_visible(SurfaceId id, bool visible);
    // Zero does nothing. Throws for an id that was removed or never given.
    void remove(CurvesId id);
    void remove(SurfaceId id);
    void remove(TextureId id);
    // Removes all curves and surfaces; textures stay.
    void clear();

    void set_scene(const Scene& scene);
    const Scene& scene() const;
    // Of everything visible, radii included; lines count as thin.
    Box bounds() const;

    // Records and submits one frame; returns before it is drawn. Waits only when two frames are in flight already. A
    // window that has no area just now (minimized) is left alone. The camera's aspect is the viewport's. The UI is drawn over
    // the finished picture, with no samples but one a pixel; its vertices and indices are copied, and take no allocation once
    // buffers have grown to the largest frame. Throws for a viewport that is not on the target, for indices out of range
    // and for textures that are not there; a window that has shrunk since it was asked for its size cuts the viewport.
    void draw(Target& target, const Camera& camera, const DrawOptions& options = {});
    // The same for two eyes, left and right, in one pass (multiview): what is drawn is chosen, uploaded and recorded once for
    // both, there is one shadow map. Each picture is that of draw() with its eye's camera, but that curves have the detail
    // that the nearer eye sees. `mirror`, a window say, shows both side by side, each stretched over a half; its own picture
    // stays as it was. Options::stereo: two passes in one command buffer count their triangles and calls each.
    void draw(StereoTarget& target, const Camera (&eyes)[2], Target* mirror = nullptr);
    // Waits for the target's last frame and copies it out; black before the first.
    Image capture(Target& target);
    Image capture(StereoTarget& target, uint32_t eye);  // 0 or 1
    // Waits until all frames are drawn.
    void wait_idle();

    // Compiles the shaders of options.shader_folder again, for the next frame; false: nothing has changed, or there is no
    // folder. Throws with the compiler's words for one that doesn't compile, and goes on with those it had.
    bool reload_shaders();

    // Goes on with a new device, after DeviceLost or whenever a host wants to. All curves, surfaces and textures are gone;
    // their ids are no longer valid and are not given out again. Options, scene, targets and windows stay, their pictures
    // don't. On error nothing changes, and it can be tried again.
    void recover();
    // For tests, of hosts too: the device is fine, but draw(), capture(), wait_idle(), resize() and windows will find it lost,
    // until recover(); the first `calls` calls of those to the driver pass before it happens. Uploads don't notice, as
    // with real losses.
    void simulate_device_loss(uint32_t calls = 0);

    const FrameStats& stats() const;
    // What is removed or replaced is given back once the device is done with it, and whole blocks to the system when none of
    // them is used. The next draw(), wait_idle(), update() or remove() looks after it.
    MemoryReport memory() const;
    const std::string& device_name() const;
    uint32_t samples() const;
    // What the validation layer said since the start: empty in a sound program.
    const std::vector<std::string>& messages() const;

private:
    friend class StereoTarget;
    friend class Target;
    friend class Window;
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace flg::render
