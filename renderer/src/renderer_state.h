// SPDX-License-Identifier: MIT
// The renderer's inside. Members are destroyed from the last to the first, the device at the end.
#pragma once

#include <memory>

#include "curve_store.h"
#include "device.h"
#include "frame.h"
#include "pipelines.h"
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
    void record_frame(FrameSlot& slot, FrameSubmission& submission, const TargetImage& image, const Camera& camera,
                      const DrawOptions& draw_options);
    TargetPasses passes() const { return {main_pass.handle, ui_pass.handle()}; }

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
    OwnedPass main_pass;
    Pipelines pipelines;
    SurfacePipelines surface_pipelines;
    TextureSampler texture_sampler;
    UiPass ui_pass;
    IndexPatterns patterns;
    CurveStore curves;
    SurfaceStore surfaces;
    TextureStore textures;
    std::unique_ptr<FrameSlot> slots[frames_in_flight];

    std::vector<Entry> targets;
    Scene scene;
    FrameStats stats;
    uint64_t frame = 0;  // the last submitted
    bool shadow_is_current = false;
    DrawList main_list, shadow_list;  // scratch of record_frame
    std::vector<uint32_t> instances;
    std::vector<float> joints;
};

}  // namespace flg::render
