// SPDX-License-Identifier: MIT
// The renderer's inside. Members are destroyed from the last to the first, the device at the end.
#pragma once

#include <memory>

#include "curve_store.h"
#include "device.h"
#include "finish_pass.h"
#include "frame.h"
#include "pipelines.h"
#include "shaders.h"
#include "shadow_map.h"
#include "surface_store.h"
#include "target_image.h"
#include "texture_store.h"
#include "ui_pass.h"
#include "upload_ring.h"

namespace flg::render {

struct OwnedPass {
    VkDevice device;
    VkRenderPass handle;
    OwnedPass(VkDevice of, VkRenderPass pass) : device(of), handle(pass) {}
    ~OwnedPass() { vkDestroyRenderPass(device, handle, nullptr); }
    OwnedPass(const OwnedPass&) = delete;
    OwnedPass& operator=(const OwnedPass&) = delete;
};

struct Renderer::State {
    State(const Options& wanted, std::shared_ptr<MessageLog> message_log);
    ~State();
    Box bounds() const;
    // Gives back what the device has done with, without waiting for it.
    void recycle();
    // Waits for all frames and gives back what can be.
    void reclaim();
    // Takes the times of a slot's frame, which must be finished, into `stats`.
    void read_times(const FrameSlot& slot);
    // Draws a frame and submits it: as many cameras as the images have layers together. `around`: what a target adds to
    // it.
    void draw(std::span<const std::unique_ptr<TargetImage>> images, Target* around, std::span<const Camera> cameras,
              const DrawOptions& draw_options);
    void record_frame(FrameSlot& slot, FrameSubmission& submission,
                      std::span<const std::unique_ptr<TargetImage>> images, std::span<const Camera> cameras,
                      const DrawOptions& draw_options, uint32_t refined);
    // The picture in an image, of what record_frame has chosen. Moments in between are marked if `marked` is not null.
    void record_picture(VkCommandBuffer commands, const TargetImage& image, const SurfaceSets& sets,
                        VkBuffer instance_buffer, VkExtent2D drawn, FrameSlot* marked);
    Image capture(const TargetImage& image, uint32_t layer);
    void need_stereo() {
        pipelines.need_stereo();
        surface_pipelines.need_stereo();
    }
    RenderPasses render_passes() const { return {{main_pass.handle, stereo_pass.handle}, samples, shadow_map.pass()}; }
    TargetPasses passes() const { return {{main_pass.handle, stereo_pass.handle}, ui_pass.handle(), finish_pass}; }
    // Whatever is drawn has become other than it was.
    void scene_changed() {
        shadow_is_current = false;
        ++revision;
    }

    SurfacePlace surface_place() { return {memory, ring, surface_pipelines.texture_set_layout()}; }

    // What draws into an image of its own, on this device.
    struct Entry {
        std::unique_ptr<TargetImage>* image;
        Target* target;
    };

    Options options;
    std::shared_ptr<MessageLog> log;
    Device device;
    DeviceMemory memory;
    UploadRing ring;
    ShadowMap shadow_map;
    VkSampleCountFlagBits samples;
    OwnedPass main_pass, stereo_pass;
    std::unique_ptr<Shaders> shaders;
    Pipelines pipelines;
    SurfacePipelines surface_pipelines;
    TextureSampler texture_sampler;
    FinishPass finish_pass;
    UiPass ui_pass;
    IndexPatterns patterns;
    CurveStore curves;
    SurfaceStore surfaces;
    TextureStore textures;
    std::unique_ptr<FrameSlot> slots[frames_in_flight];

    std::vector<Entry> targets;
    Scene scene;
    EnvironmentUniforms environment = make_environment(scene);
    FrameStats stats;
    uint64_t frame = 0;  // the last submitted
    bool shadow_is_current = false;
    uint64_t revision = 1;            // of what is drawn
    DrawList main_list, shadow_list;  // scratch of record_frame
    std::vector<ViewUniforms> views;
    std::vector<uint32_t> instances;
    std::vector<float> joints;
};

}  // namespace flg::render
