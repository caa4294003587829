// SPDX-License-Identifier: MIT
#include "filigree_renderer/renderer.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "renderer_state.h"

namespace flg::render {
namespace {

using SteadyClock = std::chrono::steady_clock;

double milliseconds_since(SteadyClock::time_point start) {
    return std::chrono::duration<double, std::milli>(SteadyClock::now() - start).count();
}

Options checked(Options options) {
    const uint32_t samples = options.samples;
    if (samples != 0 && samples != 1 && samples != 2 && samples != 4 && samples != 8)
        fail("options.samples is %u; it must be 0, 1, 2, 4 or 8.", samples);
    if (options.shadow_size != 0 && (options.shadow_size < 256 || options.shadow_size > 8192))
        fail("options.shadow_size is %u; it must be 0 or 256 to 8192.", options.shadow_size);
    if (options.max_points != 0 && options.max_points < 128)
        fail("options.max_points is %u; it must be 0 or at least 128.", options.max_points);
    return options;
}

void check_viewport(glm::ivec4 viewport, const Target& target) {
    if (viewport == glm::ivec4(0)) return;
    const auto within = [](int64_t from, int64_t size, int64_t whole) {
        return from >= 0 && size > 0 && from + size <= whole;
    };
    if (!within(viewport.x, viewport.z, target.width()) || !within(viewport.y, viewport.w, target.height()))
        fail("The viewport of %d x %d pixels at (%d, %d) does not lie on the target of %u x %u.", viewport.z,
             viewport.w, viewport.x, viewport.y, target.width(), target.height());
}

// The pixels of a checked viewport that are on an image, at least one.
VkRect2D picture_area(glm::ivec4 viewport, const TargetImage& image) {
    const glm::ivec2 whole(image.width(), image.height());
    if (viewport == glm::ivec4(0)) return {{0, 0}, {image.width(), image.height()}};
    const glm::ivec2 from = glm::min(glm::ivec2(viewport), whole - 1);
    const glm::uvec2 size = glm::min(glm::ivec2(viewport.z, viewport.w), whole - from);
    return {{from.x, from.y}, {size.x, size.y}};
}

VkExtent2D scaled(VkExtent2D extent, float scale) {
    const auto part = [&](uint32_t size) {
        return std::max(static_cast<uint32_t>(std::lround(scale * static_cast<float>(size))), 1u);
    };
    return {part(extent.width), part(extent.height)};
}

void bind_view(VkCommandBuffer commands, const Pipelines& pipelines, VkDescriptorSet set) {
    vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, pipelines.layout(), 0, 1, &set, 0, nullptr);
}

}  // namespace

Renderer::State::State(const Options& wanted, std::shared_ptr<MessageLog> message_log)
    : options(checked(wanted)),
      log(std::move(message_log)),
      device(options, log),
      memory(device, options.memory_limit_bytes),
      ring(memory),
      shadow_map(memory, options.shadow_size),
      samples(device.supported_samples(options.samples)),
      main_pass{device.handle(), make_main_pass(device.handle(), samples, Eyes::one)},
      stereo_pass{device.handle(), make_main_pass(device.handle(), samples, Eyes::both)},
      shaders(std::make_unique<Shaders>(options.shader_folder)),
      pipelines(device, *shaders, render_passes()),
      surface_pipelines(device, *shaders, render_passes(), pipelines.view_layout()),
      texture_sampler(device),
      finish_pass(device, *shaders, pipelines.view_layout(), samples),
      ui_pass(device, *shaders, texture_sampler.layout()),
      patterns(ring),
      curves(ring),
      surfaces(ring),
      textures(memory, ring, texture_sampler) {
    if (options.stereo == StereoPasses::automatic)
        options.stereo = device.loses_views() ? StereoPasses::two : StereoPasses::one;
    for (auto& slot : slots)
        slot = std::make_unique<FrameSlot>(memory, pipelines, surface_pipelines.joints_layout(), shadow_map);
    memory.reclaim = [this] { reclaim(); };
}

Renderer::State::~State() {
    vkDeviceWaitIdle(device.handle());
}

void Renderer::State::recycle() {
    uint64_t finished = frame;
    for (const auto& slot : slots)
        if (slot->busy()) finished = std::min(finished, std::max<uint64_t>(slot->frame, 1) - 1);
    ring.recycle(finished);
    curves.recycle(finished);
    surfaces.recycle(finished);
    textures.recycle(finished);
}

void Renderer::State::reclaim() {
    for (const auto& slot : slots) slot->wait();
    recycle();
    ring.trim();
}

Box Renderer::State::bounds() const {
    Box box = curves.bounds();
    box.add(surfaces.bounds());
    return box;
}

void Renderer::State::read_times(const FrameSlot& slot) {
    if (slot.frame == 0) return;
    stats.gpu_ms = slot.elapsed_ms(Moment::begin, Moment::end);
    const double nothing_drawn = stats.gpu_ms < 0 ? -1.0 : 0.0;
    stats.gpu_uploads_ms = slot.elapsed_ms(Moment::begin, Moment::uploads_done);
    stats.gpu_shadow_ms = slot.drew_shadow ? slot.elapsed_ms(Moment::uploads_done, Moment::shadow_done) : nothing_drawn;
    stats.gpu_surfaces_ms = slot.elapsed_ms(Moment::shadow_done, Moment::surfaces_done);
    stats.gpu_curves_ms = slot.elapsed_ms(Moment::surfaces_done, Moment::curves_done);
    stats.gpu_backdrop_ms = slot.elapsed_ms(Moment::curves_done, Moment::picture_done);
    stats.gpu_finish_ms = slot.elapsed_ms(Moment::picture_done, Moment::finish_done);
    stats.gpu_ui_ms = slot.elapsed_ms(Moment::finish_done, Moment::ui_done);
}

Renderer::Renderer(const Options& options) : state_(std::make_unique<State>(options, std::make_shared<MessageLog>())) {}

Renderer::~Renderer() = default;

CurvesId Renderer::upload(const FlgCurveSetView& view, const CurveLook& look) {
    State& s = *state_;
    auto curves = s.ring.all_or_nothing([&] {
        return std::make_unique<DeviceCurves>(s.memory, s.ring, s.pipelines, view, look, s.options.max_points);
    });
    s.scene_changed();
    return {s.curves.add(std::move(curves))};
}

void Renderer::update(CurvesId id, const FlgCurveSetView& view, const CurveLook& look) {
    State& s = *state_;
    const bool visible = s.curves.at(id.value).visible;
    auto curves = s.ring.all_or_nothing([&] {
        return std::make_unique<DeviceCurves>(s.memory, s.ring, s.pipelines, view, look, s.options.max_points);
    });
    curves->visible = visible;
    s.curves.replace(id.value, std::move(curves), s.frame);
    s.recycle();
    s.scene_changed();
}

CurvesId Renderer::begin_growing(const CurveLook& look, uint32_t capacity) {
    State& s = *state_;
    return {s.curves.add(std::make_unique<DeviceCurves>(s.memory, s.pipelines, look, capacity))};
}

void Renderer::append(CurvesId id, const FlgCurveSetView& view) {
    state_->curves.growing(id).append(view);
    state_->scene_changed();
}

void Renderer::truncate(CurvesId id, uint32_t points) {
    state_->curves.growing(id).truncate(points);
    state_->scene_changed();
}

void Renderer::set_magnitude_offset(CurvesId id, float offset) {
    state_->curves.set_magnitude_offset(id, offset);
    state_->scene_changed();
}

struct PreparedSurface::State {
    SurfaceData data;
    SurfaceLook look;
};

PreparedSurface::PreparedSurface(const FlgMeshView& mesh, const SurfaceLook& look, std::span<const float> field)
    : state_(std::make_unique<State>(State{prepare_surface(mesh, look, field), look})) {}
PreparedSurface::~PreparedSurface() = default;
PreparedSurface::PreparedSurface(PreparedSurface&&) noexcept = default;
PreparedSurface& PreparedSurface::operator=(PreparedSurface&&) noexcept = default;

SurfaceId Renderer::upload(const PreparedSurface& prepared) {
    State& s = *state_;
    const PreparedSurface::State& p = *prepared.state_;
    auto surface =
        s.ring.all_or_nothing([&] { return std::make_unique<DeviceSurface>(s.surface_place(), p.data, p.look); });
    s.scene_changed();
    return {s.surfaces.add(std::move(surface))};
}

SurfaceId Renderer::upload(const FlgMeshView& mesh, const SurfaceLook& look, std::span<const float> field) {
    State& s = *state_;
    auto surface =
        s.ring.all_or_nothing([&] { return std::make_unique<DeviceSurface>(s.surface_place(), mesh, look, field); });
    s.scene_changed();
    return {s.surfaces.add(std::move(surface))};
}

void Renderer::update(SurfaceId id, const FlgMeshView& mesh, const SurfaceLook& look, std::span<const float> field) {
    State& s = *state_;
    const DeviceSurface& before = s.surfaces.at(id.value);
    auto surface =
        s.ring.all_or_nothing([&] { return std::make_unique<DeviceSurface>(s.surface_place(), mesh, look, field); });
    surface->visible = before.visible;
    surface->place(before.placement);
    s.surfaces.replace(id.value, std::move(surface), s.frame);
    s.recycle();
    s.scene_changed();
}

SurfaceId Renderer::upload(const FlgSkinView& skin, const SurfaceLook& look) {
    State& s = *state_;
    auto surface =
        s.ring.all_or_nothing([&] { return std::make_unique<DeviceSurface>(s.surface_place(), skin, look); });
    s.scene_changed();
    return {s.surfaces.add(std::move(surface))};
}

void Renderer::update(SurfaceId id, const FlgSkinView& skin, const SurfaceLook& look) {
    State& s = *state_;
    const DeviceSurface& before = s.surfaces.at(id.value);
    auto surface =
        s.ring.all_or_nothing([&] { return std::make_unique<DeviceSurface>(s.surface_place(), skin, look); });
    surface->visible = before.visible;
    surface->place(before.placement);
    s.surfaces.replace(id.value, std::move(surface), s.frame);
    s.recycle();
    s.scene_changed();
}

void Renderer::set_pose(SurfaceId id, FlgSkinning skinning, std::span<const float> transforms) {
    state_->surfaces.set_pose(id, skinning, transforms);
    state_->scene_changed();
}

void Renderer::set_placement(SurfaceId id, const Placement& placement) {
    const glm::quat& q = placement.turn;
    const bool finite = std::isfinite(glm::dot(placement.at, placement.at)) && std::isfinite(placement.scale);
    if (!finite || !(placement.scale > 0.0f) || !(std::abs(glm::dot(q, q) - 1.0f) < 1e-3f))
        fail(
            "A placement is at %g, %g, %g, scaled by %g, with a turn of length %g; it must be finite, with a scale > 0 "
            "and a turn of length 1.",
            placement.at.x, placement.at.y, placement.at.z, placement.scale, glm::length(q));
    DeviceSurface& surface = state_->surfaces.at(id.value);
    if (surface.placement == placement) return;
    surface.place(placement);
    state_->scene_changed();
}

TextureId Renderer::upload(const Image& image) {
    State& s = *state_;
    auto texture = s.ring.all_or_nothing(
        [&] { return std::make_unique<DeviceTexture>(s.memory, s.ring, s.texture_sampler, image); });
    return {s.textures.add(std::move(texture))};
}

void Renderer::update(TextureId id, const Image& image) {
    State& s = *state_;
    s.textures.at(id.value);
    auto texture = s.ring.all_or_nothing(
        [&] { return std::make_unique<DeviceTexture>(s.memory, s.ring, s.texture_sampler, image); });
    s.textures.replace(id.value, std::move(texture), s.frame);
    s.recycle();
}

void Renderer::set_visible(CurvesId id, bool visible) {
    bool& is_visible = state_->curves.at(id.value).visible;
    if (is_visible != visible) state_->scene_changed();
    is_visible = visible;
}

void Renderer::set_visible(SurfaceId id, bool visible) {
    bool& is_visible = state_->surfaces.at(id.value).visible;
    if (is_visible != visible) state_->scene_changed();
    is_visible = visible;
}

void Renderer::remove(CurvesId id) {
    if (id.value == 0) return;
    state_->curves.remove(id.value, state_->frame);
    state_->recycle();
    state_->scene_changed();
}

void Renderer::remove(SurfaceId id) {
    if (id.value == 0) return;
    state_->surfaces.remove(id.value, state_->frame);
    state_->recycle();
    state_->scene_changed();
}

void Renderer::remove(TextureId id) {
    if (id.value == 0) return;
    state_->textures.remove(id.value, state_->frame);
    state_->recycle();
}

void Renderer::clear() {
    state_->curves.remove_all(state_->frame);
    state_->surfaces.remove_all(state_->frame);
    state_->recycle();
    state_->scene_changed();
}

bool Renderer::changed() const {
    return !state_->shadow_is_current || state_->ring.pending();
}

void Renderer::set_scene(const Scene& scene) {
    state_->scene = scene;
    state_->environment = make_environment(scene);
    state_->scene_changed();
}

const Scene& Renderer::scene() const {
    return state_->scene;
}
Box Renderer::bounds() const {
    return state_->bounds();
}
const FrameStats& Renderer::stats() const {
    return state_->stats;
}
MemoryReport Renderer::memory() const {
    return state_->memory.report();
}
const std::string& Renderer::device_name() const {
    return state_->device.name();
}
uint32_t Renderer::samples() const {
    return static_cast<uint32_t>(state_->samples);
}
const std::vector<std::string>& Renderer::messages() const {
    return state_->log->messages;
}

void Renderer::draw(Target& target, const Camera& camera, const DrawOptions& options) {
    if (&target.renderer_ != this) fail("The target belongs to another renderer.");
    check_viewport(options.viewport, target);
    if (!(options.changing_scale >= 0.25f && options.changing_scale <= 1.0f))
        fail("options.changing_scale is %g; it must be 0.25 to 1.", options.changing_scale);
    check_ui(options.ui, state_->textures);
    state_->draw({&target.image_, 1}, &target, {&camera, 1}, options);
}

void Renderer::draw(StereoTarget& target, const Camera (&eyes)[2], Target* mirror) {
    if (&target.renderer_ != this) fail("The target belongs to another renderer.");
    if (mirror && &mirror->renderer_ != this) fail("The mirror belongs to another renderer.");
    state_->draw(target.images_, mirror, eyes, {});
}

void Renderer::State::draw(std::span<const std::unique_ptr<TargetImage>> images, Target* around,
                           std::span<const Camera> cameras, const DrawOptions& draw_options) {
    const auto start = SteadyClock::now();
    // Before a window's image is taken, which would have to be given back.
    for (const Camera& camera : cameras)
        camera_view(camera, scene, bounds(), images[0]->width(), images[0]->height(), options.shadow_size);
    const auto slot_index = static_cast<uint32_t>((frame + 1) % frames_in_flight);
    FrameSlot& slot = *slots[slot_index];
    slot.wait();
    recycle();
    if (around && !around->begin_frame(slot_index)) return;  // a window may be of another size now
    const double wait_ms = milliseconds_since(start);
    read_times(slot);

    FrameSubmission submission;
    submission.slot = slot_index;
    submission.size = {images[0]->width(), images[0]->height()};
    for (const auto& image : images)
        for (uint32_t layer = 0; layer < layers_of(image->eyes()); ++layer)
            submission.pictures[submission.picture_count++] = {image->color(), layer};
    TargetImage& image = *images[0];
    const PictureKey key{cameras[0], draw_options.viewport, draw_options.refines ? revision : 0};
    const bool goes_on = draw_options.refines && image.drawn && key == image.key;
    const uint32_t refined = goes_on ? std::min(image.refined + 1, max_refined + 1) : 0;
    SteadyClock::time_point submit_start;
    try {
        record_frame(slot, submission, images, cameras, draw_options, refined);
        if (around) around->end_frame(submission);
        slot.mark(Moment::end);
        submit_start = SteadyClock::now();
        slot.submit(submission);
    } catch (...) {
        if (around) around->abandon_frame();
        throw;
    }
    slot.frame = ++frame;
    ring.submitted(frame);
    shadow_is_current = true;
    for (const auto& drawn : images) drawn->drawn = true;
    image.key = key;
    image.refined = std::min(refined, max_refined);
    if (around) around->present(submission);
    stats.submit_ms = milliseconds_since(submit_start);
    stats.wait_ms = wait_ms;
    stats.device_bytes = memory.report().held;
    stats.cpu_ms = milliseconds_since(start) - wait_ms - stats.submit_ms;
}

void Renderer::State::record_frame(FrameSlot& slot, FrameSubmission& submission,
                                   std::span<const std::unique_ptr<TargetImage>> images,
                                   std::span<const Camera> cameras, const DrawOptions& draw_options, uint32_t refined) {
    const Box box = bounds();
    const uint32_t shadow_size = options.shadow_size;
    const VkRect2D area = picture_area(draw_options.viewport, *images[0]);
    const VkExtent2D drawn = refined ? area.extent : scaled(area.extent, draw_options.changing_scale);
    const bool is_done = refined > max_refined;  // and shown again
    views.clear();
    for (const Camera& camera : cameras) {
        views.push_back(camera_view(camera, scene, box, drawn.width, drawn.height, shadow_size));
        views.back().environment = environment;
        if (refined) vary(views.back(), refined);
    }
    const ViewUniforms sun = sun_view(scene, box, shadow_size);
    const bool draw_shadow = !shadow_is_current;  // without shadows too: the map must be readable
    instances.clear();
    shadow_list.clear();
    main_list.clear();
    if (draw_shadow && shadow_size) curves.select({&sun, 1}, true, shadow_list, instances);
    curves.select(views, false, main_list, instances);
    slot.set_views(views, sun);
    curves.upload_growth();
    const VkBuffer instance_buffer = slot.set_instances(instances);
    surfaces.gather_joints(joints);
    const VkDescriptorSet joints_set = slot.set_joints(joints);
    const UiFrame& ui = draw_options.ui;
    const bool has_ui = !ui.commands.empty() && !ui.indices.empty();
    const UiBuffers ui_buffers = has_ui ? slot.set_ui(ui) : UiBuffers{};
    slot.drew_shadow = draw_shadow && shadow_size;

    const VkCommandBuffer commands = submission.commands = slot.begin();
    slot.mark(Moment::begin);
    stats.draw_calls = static_cast<uint32_t>(shadow_list.bins.size());
    stats.triangles = 0;
    stats.uploaded_bytes = ring.record(commands);
    slot.mark(Moment::uploads_done);
    if (draw_shadow) {
        shadow_map.begin(commands);
        stats.draw_calls +=
            record_surface_shadows(commands, surface_pipelines, {slot.sun_view(), joints_set}, surfaces).calls;
        bind_view(commands, pipelines, slot.sun_view());
        record_curves(commands, pipelines, patterns, shadow_list, instance_buffer, {});
        shadow_map.end(commands);
    }
    slot.mark(Moment::shadow_done);

    if (refined) images[0]->need_mean(memory, finish_pass);
    for (const auto& image : images) {
        const bool is_first = image == images.front(), is_last = image == images.back();
        const SurfaceSets sets{is_first ? slot.main_view() : slot.second_view(), joints_set, image->eyes()};
        if (!is_done) record_picture(commands, *image, sets, instance_buffer, drawn, is_last ? &slot : nullptr);
    }
    if (is_done) slot.mark(Moment::surfaces_done);
    if (is_done) slot.mark(Moment::curves_done);
    slot.mark(Moment::picture_done);
    if (refined) {
        if (!is_done) finish_pass.record_mean(commands, slot.main_view(), *images[0], drawn, area, refined);
        FinishPass::record_copy(commands, *images[0]);
    } else {
        for (const auto& image : images)
            for (uint32_t layer = 0; layer < layers_of(image->eyes()); ++layer) {
                const bool second = image != images.front() || layer > 0;
                finish_pass.record(commands, second ? slot.second_view() : slot.main_view(), *image, layer, drawn,
                                   area);
            }
    }
    slot.mark(Moment::finish_done);

    if (has_ui)
        stats.draw_calls +=
            ui_pass.record(commands, images[0]->ui_framebuffer(), submission.size, ui, ui_buffers, textures);
    slot.mark(Moment::ui_done);
}

void Renderer::State::record_picture(VkCommandBuffer commands, const TargetImage& image, const SurfaceSets& sets,
                                     VkBuffer instance_buffer, VkExtent2D drawn, FrameSlot* marked) {
    VkClearValue clear[2]{};  // colour is not cleared; depth 0 is infinitely far
    VkRenderPassBeginInfo info{VK_STRUCTURE_TYPE_RENDER_PASS_BEGIN_INFO};
    info.renderPass = passes().main[static_cast<uint32_t>(image.eyes())];
    info.framebuffer = image.framebuffer();
    info.renderArea.extent = drawn;
    info.clearValueCount = 2;
    info.pClearValues = clear;
    vkCmdBeginRenderPass(commands, &info, VK_SUBPASS_CONTENTS_INLINE);
    const VkRect2D area{{0, 0}, drawn};
    const VkViewport viewport{0, 0, static_cast<float>(drawn.width), static_cast<float>(drawn.height), 0, 1};
    vkCmdSetViewport(commands, 0, 1, &viewport);
    vkCmdSetScissor(commands, 0, 1, &area);
    const SurfaceDraws surface_draws = record_surfaces(commands, surface_pipelines, sets, surfaces);
    if (marked) marked->mark(Moment::surfaces_done);
    bind_view(commands, pipelines, sets.view);
    stats.triangles += surface_draws.triangles;
    stats.triangles += record_curves(commands, pipelines, patterns, main_list, instance_buffer, {&viewport, sets.eyes});
    stats.draw_calls += surface_draws.calls + static_cast<uint32_t>(main_list.bins.size()) + 1;
    if (marked) marked->mark(Moment::curves_done);
    vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, pipelines.backdrop(sets.eyes));
    vkCmdDraw(commands, 3, 1, 0, 0);
    const SurfaceDraws borders = record_borders(commands, surface_pipelines, sets, surfaces);
    stats.triangles += borders.triangles;
    stats.draw_calls += borders.calls;
    vkCmdEndRenderPass(commands);
}

void Renderer::wait_idle() {
    State& s = *state_;
    for (auto& slot : s.slots) slot->wait();
    s.read_times(*s.slots[s.frame % frames_in_flight]);
    s.recycle();
}

}  // namespace flg::render
