// SPDX-License-Identifier: MIT
#include "swapchain.h"

#include <algorithm>

namespace flg::render {
namespace {

VkSemaphore make_semaphore(VkDevice device) {
    const VkSemaphoreCreateInfo info{VK_STRUCTURE_TYPE_SEMAPHORE_CREATE_INFO};
    VkSemaphore semaphore;
    check(vkCreateSemaphore(device, &info, nullptr, &semaphore), "make a semaphore");
    return semaphore;
}

void change_layout(VkCommandBuffer commands, VkImage image, VkImageLayout from, VkImageLayout to, VkAccessFlags before,
                   VkAccessFlags after, VkPipelineStageFlags after_stage) {
    VkImageMemoryBarrier barrier{VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER};
    barrier.srcAccessMask = before;
    barrier.dstAccessMask = after;
    barrier.oldLayout = from;
    barrier.newLayout = to;
    barrier.srcQueueFamilyIndex = barrier.dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
    barrier.image = image;
    barrier.subresourceRange = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1};
    vkCmdPipelineBarrier(commands, VK_PIPELINE_STAGE_TRANSFER_BIT, after_stage, 0, 0, nullptr, 0, nullptr, 1, &barrier);
}

Swapchain::Fitness fitness_of(VkResult result) {
    if (result == VK_ERROR_SURFACE_LOST_KHR || result == VK_ERROR_NATIVE_WINDOW_IN_USE_KHR)
        return Swapchain::Fitness::lost;
    if (result == VK_ERROR_OUT_OF_DATE_KHR || result == VK_SUBOPTIMAL_KHR) return Swapchain::Fitness::outdated;
    return Swapchain::Fitness::good;
}

VkOffset3D corner(uint32_t x, uint32_t y, uint32_t z) {
    return {static_cast<int32_t>(x), static_cast<int32_t>(y), static_cast<int32_t>(z)};
}

}  // namespace

Swapchain::Swapchain(const Device& device, VkSurfaceKHR surface) : device_(device), surface_(surface) {
    try {
        VkBool32 supported = VK_FALSE;
        check(vkGetPhysicalDeviceSurfaceSupportKHR(device.physical(), device.queue_family(), surface, &supported),
              "say whether it can show windows");
        if (!supported || !device.has_swapchain())
            fail("The device \"%s\" can't show its pictures in this window.", device.name().c_str());
        choose_format();
        for (VkSemaphore& semaphore : acquired_) semaphore = make_semaphore(device.handle());
    } catch (...) {
        destroy();
        throw;
    }
}

Swapchain::~Swapchain() {
    destroy();
}

void Swapchain::destroy() {
    destroy_images();
    vkDestroySwapchainKHR(device_.handle(), swapchain_, nullptr);
    for (VkSemaphore semaphore : acquired_) vkDestroySemaphore(device_.handle(), semaphore, nullptr);
    vkDestroySurfaceKHR(device_.instance(), surface_, nullptr);
}

void Swapchain::destroy_images() {
    for (VkSemaphore semaphore : drawn_) vkDestroySemaphore(device_.handle(), semaphore, nullptr);
    drawn_.clear();
    images_.clear();
}

void Swapchain::choose_format() {
    uint32_t count = 0;
    check(vkGetPhysicalDeviceSurfaceFormatsKHR(device_.physical(), surface_, &count, nullptr), "list window formats");
    std::vector<VkSurfaceFormatKHR> formats(count);
    check(vkGetPhysicalDeviceSurfaceFormatsKHR(device_.physical(), surface_, &count, formats.data()),
          "list window formats");
    for (const VkSurfaceFormatKHR& format : formats) {
        if (format.format != VK_FORMAT_B8G8R8A8_SRGB && format.format != VK_FORMAT_R8G8B8A8_SRGB) continue;
        format_ = format;
        return;
    }
    fail("The window offers no sRGB format with 8 bits a channel.");
}

Swapchain::Fitness Swapchain::rebuild(uint32_t width, uint32_t height) {
    VkSurfaceCapabilitiesKHR capabilities;
    VkResult result = vkGetPhysicalDeviceSurfaceCapabilitiesKHR(device_.physical(), surface_, &capabilities);
    if (fitness_of(result) == Fitness::lost) return Fitness::lost;
    check(result, "describe a window");
    if (!(capabilities.supportedUsageFlags & VK_IMAGE_USAGE_TRANSFER_DST_BIT))
        fail("The window's images can't be copied to.");
    const bool surface_decides = capabilities.currentExtent.width != UINT32_MAX;
    const VkExtent2D low = capabilities.minImageExtent, high = capabilities.maxImageExtent;
    extent_ = surface_decides
                  ? capabilities.currentExtent
                  : VkExtent2D{std::clamp(width, low.width, high.width), std::clamp(height, low.height, high.height)};
    if (extent_.width == 0 || extent_.height == 0) return Fitness::good;
    destroy_images();
    const VkSwapchainKHR old = swapchain_;
    VkSwapchainCreateInfoKHR info{VK_STRUCTURE_TYPE_SWAPCHAIN_CREATE_INFO_KHR};
    info.surface = surface_;
    info.minImageCount = capabilities.minImageCount + 1;
    if (capabilities.maxImageCount) info.minImageCount = std::min(info.minImageCount, capabilities.maxImageCount);
    info.imageFormat = format_.format;
    info.imageColorSpace = format_.colorSpace;
    info.imageExtent = extent_;
    info.imageArrayLayers = 1;
    info.imageUsage = VK_IMAGE_USAGE_TRANSFER_DST_BIT;
    info.imageSharingMode = VK_SHARING_MODE_EXCLUSIVE;
    info.preTransform = capabilities.currentTransform;
    info.compositeAlpha = (capabilities.supportedCompositeAlpha & VK_COMPOSITE_ALPHA_OPAQUE_BIT_KHR)
                              ? VK_COMPOSITE_ALPHA_OPAQUE_BIT_KHR
                              : VK_COMPOSITE_ALPHA_INHERIT_BIT_KHR;
    info.presentMode = VK_PRESENT_MODE_FIFO_KHR;
    info.clipped = VK_TRUE;
    info.oldSwapchain = old;
    swapchain_ = VK_NULL_HANDLE;
    result = device_.unless_lost([&] { return vkCreateSwapchainKHR(device_.handle(), &info, nullptr, &swapchain_); });
    vkDestroySwapchainKHR(device_.handle(), old, nullptr);
    if (fitness_of(result) == Fitness::lost) return Fitness::lost;
    check(result, "make images for a window");
    uint32_t count = 0;
    check(vkGetSwapchainImagesKHR(device_.handle(), swapchain_, &count, nullptr), "list a window's images");
    images_.resize(count);
    check(vkGetSwapchainImagesKHR(device_.handle(), swapchain_, &count, images_.data()), "list a window's images");
    for (uint32_t i = 0; i < count; ++i) drawn_.push_back(make_semaphore(device_.handle()));
    return Fitness::good;
}

Swapchain::Fitness Swapchain::acquire(uint32_t slot) {
    slot_ = slot;
    const VkResult result = device_.unless_lost([&] {
        return vkAcquireNextImageKHR(device_.handle(), swapchain_, UINT64_MAX, acquired_[slot], VK_NULL_HANDLE,
                                     &current_);
    });
    // One that is only not the best is taken; present() will say so again.
    if (result == VK_SUBOPTIMAL_KHR) return Fitness::good;
    if (fitness_of(result) == Fitness::good) check(result, "give an image of the window");
    return fitness_of(result);
}

void Swapchain::record_copy(FrameSubmission& submission) {
    const VkCommandBuffer commands = submission.commands;
    const VkImage image = images_[current_];
    change_layout(commands, image, VK_IMAGE_LAYOUT_UNDEFINED, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, 0,
                  VK_ACCESS_TRANSFER_WRITE_BIT, VK_PIPELINE_STAGE_TRANSFER_BIT);
    const uint32_t count = submission.picture_count;
    for (uint32_t i = 0; i < count; ++i) {
        VkImageBlit region{};
        region.srcSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, submission.pictures[i].layer, 1};
        region.srcOffsets[1] = corner(submission.size.width, submission.size.height, 1);
        region.dstSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1};
        region.dstOffsets[0] = corner(extent_.width * i / count, 0, 0);
        region.dstOffsets[1] = corner(extent_.width * (i + 1) / count, extent_.height, 1);
        vkCmdBlitImage(commands, submission.pictures[i].image, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, image,
                       VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, 1, &region,
                       count > 1 ? VK_FILTER_LINEAR : VK_FILTER_NEAREST);
    }
    change_layout(commands, image, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, VK_IMAGE_LAYOUT_PRESENT_SRC_KHR,
                  VK_ACCESS_TRANSFER_WRITE_BIT, 0, VK_PIPELINE_STAGE_BOTTOM_OF_PIPE_BIT);
    submission.wait = acquired_[slot_];
    submission.signal = drawn_[current_];
}

Swapchain::Fitness Swapchain::present() {
    VkPresentInfoKHR info{VK_STRUCTURE_TYPE_PRESENT_INFO_KHR};
    info.waitSemaphoreCount = 1;
    info.pWaitSemaphores = &drawn_[current_];
    info.swapchainCount = 1;
    info.pSwapchains = &swapchain_;
    info.pImageIndices = &current_;
    const VkResult result = device_.unless_lost([&] { return vkQueuePresentKHR(device_.queue(), &info); });
    if (fitness_of(result) == Fitness::good) check(result, "show a frame");
    return fitness_of(result);
}

}  // namespace flg::render
