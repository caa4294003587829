// SPDX-License-Identifier: MIT
// Instance, physical and logical device, the one queue, and the validation layer's messages.
#pragma once

#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "filigree_renderer/renderer.h"
#include "vk.h"

namespace flg::render {

// What the validation layer has said; the layer may call from the driver's threads.
struct MessageLog {
    std::mutex mutex;
    std::vector<std::string> messages;
};

class Device {
public:
    Device(const Options& options, std::shared_ptr<MessageLog> log);
    ~Device();
    Device(const Device&) = delete;
    Device& operator=(const Device&) = delete;

    VkInstance instance() const { return instance_; }
    VkPhysicalDevice physical() const { return physical_; }
    VkDevice handle() const { return device_; }
    VkQueue queue() const { return queue_; }
    uint32_t queue_family() const { return queue_family_; }
    const VkPhysicalDeviceProperties& properties() const { return properties_; }
    const std::string& name() const { return name_; }
    // Whether the device can show images in windows at all.
    bool has_swapchain() const { return has_swapchain_; }
    // 0 where the queue writes no time stamps.
    uint32_t timestamp_bits() const { return timestamp_bits_; }
    // The most samples, up to `wanted`, or of what suits the device if that is 0, that colour and depth images can
    // have. llvmpipe of Mesa 22.3 draws triangles into the first view only where they cover whole tiles of 64 x 64
    // pixels.
    bool loses_views() const { return properties_.vendorID == VK_VENDOR_ID_MESA; }
    VkSampleCountFlagBits supported_samples(uint32_t wanted) const;
    // From the call after so many others on, calls that can find the device lost find it lost.
    void simulate_loss(uint32_t calls) { calls_until_loss_ = calls; }
    // The result of one of those, `call`; or that the device is lost, and then it isn't called.
    template <class Call>
    VkResult unless_lost(Call&& call) const {
        return seems_lost() ? VK_ERROR_DEVICE_LOST : call();
    }

private:
    bool seems_lost() const;
    void create_instance();
    void create_messenger();
    void choose_physical(const std::string& wanted_name);
    void create_device();
    void destroy();
    static VKAPI_ATTR VkBool32 VKAPI_CALL on_message(VkDebugUtilsMessageSeverityFlagBitsEXT severity,
                                                     VkDebugUtilsMessageTypeFlagsEXT type,
                                                     const VkDebugUtilsMessengerCallbackDataEXT* data, void* self);
    VkDebugUtilsMessengerCreateInfoEXT messenger_info();

    bool validation_ = false;
    VkInstance instance_ = VK_NULL_HANDLE;
    VkDebugUtilsMessengerEXT messenger_ = VK_NULL_HANDLE;
    VkPhysicalDevice physical_ = VK_NULL_HANDLE;
    VkPhysicalDeviceProperties properties_{};
    std::string name_;
    VkDevice device_ = VK_NULL_HANDLE;
    VkQueue queue_ = VK_NULL_HANDLE;
    uint32_t queue_family_ = 0;
    uint32_t timestamp_bits_ = 0;
    bool has_swapchain_ = false;
    std::shared_ptr<MessageLog> log_;
    mutable std::optional<uint32_t> calls_until_loss_;  // simulated
};

}  // namespace flg::render
