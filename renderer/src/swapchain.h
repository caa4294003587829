// SPDX-License-Identifier: MIT
// A window's images. Frames are drawn into the target's own image and copied here, so that windows and offscreen
// targets share all code, and a window's picture can be read back.
#pragma once

#include <vector>

#include "frame.h"

namespace flg::render {

class Swapchain {
public:
    // Outdated: the images no longer fit the window; they are to be rebuilt. Lost: the surface is no longer the
    // window's; all is to be made anew.
    enum class Fitness { good, outdated, lost };

    // Takes the surface over, also when it throws.
    Swapchain(const Device& device, VkSurfaceKHR surface);
    ~Swapchain();
    Swapchain(const Swapchain&) = delete;
    Swapchain& operator=(const Swapchain&) = delete;

    // For a window of this size in pixels; the device must be idle. Good with an extent of 0: the window has no area.
    Fitness rebuild(uint32_t width, uint32_t height);
    VkExtent2D extent() const { return extent_; }

    Fitness acquire(uint32_t slot);
    // Copies the picture, of the swapchain's extent, to the acquired image.
    void record_copy(FrameSubmission& submission);
    Fitness present();

private:
    void choose_format();
    void destroy_images();
    void destroy();

    const Device& device_;
    VkSurfaceKHR surface_;
    VkSurfaceFormatKHR format_{};
    VkSwapchainKHR swapchain_ = VK_NULL_HANDLE;
    VkExtent2D extent_{};
    std::vector<VkImage> images_;
    std::vector<VkSemaphore> drawn_;  // an image each: presentation waits for it
    VkSemaphore acquired_[frames_in_flight] = {};
    uint32_t current_ = 0;
    uint32_t slot_ = 0;
};

}  // namespace flg::render
