// SPDX-License-Identifier: MIT
// What a frame in flight needs for itself, and what has to stay until the device is done with it.
#pragma once

#include <chrono>
#include <vector>

#include "filigree_renderer/ui.h"
#include "memory.h"
#include "pipelines.h"
#include "shadow_map.h"
#include "view_uniforms.h"

namespace flg::render {

constexpr uint32_t frames_in_flight = 2;

struct FrameSubmission {
    uint32_t slot = 0;
    VkCommandBuffer commands = VK_NULL_HANDLE;
    // Ready to be copied from: one, or an eye each, side by side.
    struct Picture {
        VkImage image = VK_NULL_HANDLE;
        uint32_t layer = 0;
    };
    Picture pictures[2];
    uint32_t picture_count = 0;
    VkExtent2D size{};                    // of each
    VkSemaphore wait = VK_NULL_HANDLE;    // before transfers
    VkSemaphore signal = VK_NULL_HANDLE;  // when all is done
};

// In the order in which a frame passes them.
enum class Moment : uint32_t {
    begin,
    uploads_done,
    shadow_done,
    surfaces_done,
    curves_done,
    picture_done,
    finish_done,
    ui_done,
    end
};
constexpr uint32_t moment_count = 9;

// Vertices from the beginning on, then indices.
struct UiBuffers {
    VkBuffer buffer = VK_NULL_HANDLE;
    VkDeviceSize indices_at = 0;
};

class FrameSlot {
    static constexpr uint32_t view_sets = 3;

public:
    FrameSlot(DeviceMemory& memory, const Pipelines& pipelines, VkDescriptorSetLayout joints_layout,
              const ShadowMap& shadow_map);
    ~FrameSlot();
    FrameSlot(const FrameSlot&) = delete;
    FrameSlot& operator=(const FrameSlot&) = delete;

    // Waits until the device has finished the slot's last frame.
    void wait() const;
    // Whether it has not.
    bool busy() const;
    VkCommandBuffer begin();
    void submit(const FrameSubmission& submission);

    void mark(Moment moment);
    // Milliseconds between two moments of the slot's last frame; -1 if not known.
    double elapsed_ms(Moment from, Moment to) const;

    void set_views(std::span<const ViewUniforms> main, const ViewUniforms& sun);  // main: one or two
    VkDescriptorSet main_view() const { return views_[0]; }                       // both, for multiview
    VkDescriptorSet second_view() const { return views_[1]; }
    VkDescriptorSet sun_view() const { return views_[2]; }
    // A buffer that holds these until the slot's next frame.
    VkBuffer set_instances(const std::vector<uint32_t>& instances);
    // The same as a descriptor set; null for none.
    VkDescriptorSet set_joints(const std::vector<float>& joints);
    UiBuffers set_ui(const UiFrame& ui);

    uint64_t frame = 0;        // number of the last frame submitted; 0 = none
    bool drew_shadow = false;  // in that frame

private:
    void create(const Pipelines& pipelines, const ShadowMap& shadow_map);
    void create_joints(VkDescriptorSetLayout layout);
    void destroy();

    DeviceMemory& memory_;
    VkDevice device_;
    VkCommandPool pool_ = VK_NULL_HANDLE;
    VkCommandBuffer commands_ = VK_NULL_HANDLE;
    VkFence done_ = VK_NULL_HANDLE;
    bool submitted_ = false;  // else the fence may never be signalled
    VkQueryPool queries_ = VK_NULL_HANDLE;
    VkDescriptorPool descriptors_ = VK_NULL_HANDLE;
    VkDescriptorSet views_[view_sets] = {};
    VkDescriptorPool joints_pool_ = VK_NULL_HANDLE;
    VkDescriptorSet joints_set_ = VK_NULL_HANDLE;
    VkDeviceSize view_stride_ = 0;  // of two views
    Buffer times_;
    Buffer uniforms_;
    Buffer instances_;
    Buffer joints_;
    Buffer ui_;
};

}  // namespace flg::render
