// SPDX-License-Identifier: MIT
// Targets, and reading them back.
#include <cstring>

#include "renderer_state.h"

namespace flg::render {

Target::Target(Renderer& renderer, uint32_t width, uint32_t height) : renderer_(renderer) {
    auto& s = *renderer.state_;
    image_ = std::make_unique<TargetImage>(s.memory, s.passes(), s.samples, width, height);
    s.targets.push_back({&image_, this});
}

Target::~Target() {
    auto& s = *renderer_.state_;
    // Frames in flight may still draw into the image.
    vkDeviceWaitIdle(s.device.handle());
    std::erase_if(s.targets, [this](const auto& entry) { return entry.image == &image_; });
}

void Target::resize(uint32_t width, uint32_t height) {
    auto& s = *renderer_.state_;
    renderer_.wait_idle();
    image_ = std::make_unique<TargetImage>(s.memory, s.passes(), s.samples, width, height);
}

uint32_t Target::width() const {
    return image_->width();
}
uint32_t Target::height() const {
    return image_->height();
}
bool Target::begin_frame(uint32_t) {
    return true;
}
void Target::end_frame(FrameSubmission&) {}
void Target::present(FrameSubmission&) {}
void Target::abandon_frame() noexcept {}
void Target::leave_device() noexcept {}

Image Renderer::capture(Target& target) {
    State& s = *state_;
    if (&target.renderer_ != this) fail("The target belongs to another renderer.");
    Image image{target.width(), target.height(), {}};
    image.pixels.resize(size_t{4} * image.width * image.height);
    if (!target.image_->drawn) {
        for (size_t i = 3; i < image.pixels.size(); i += 4) image.pixels[i] = 255;
        return image;
    }
    const Buffer readback(s.memory, image.pixels.size(), VK_BUFFER_USAGE_TRANSFER_DST_BIT,
                          DeviceMemory::Place::readback, MemoryUse::staging);
    // The slot of the next frame does the copy; its own last frame is the older of the two in flight.
    const auto slot_index = static_cast<uint32_t>((s.frame + 1) % frames_in_flight);
    FrameSlot& slot = *s.slots[slot_index];
    slot.wait();
    s.read_times(slot);
    s.recycle();
    FrameSubmission submission;
    submission.slot = slot_index;
    submission.commands = slot.begin();
    VkBufferImageCopy region{};
    region.imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1};
    region.imageExtent = {image.width, image.height, 1};
    vkCmdCopyImageToBuffer(submission.commands, target.image_->color(), VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL,
                           readback.handle(), 1, &region);
    VkMemoryBarrier barrier{VK_STRUCTURE_TYPE_MEMORY_BARRIER};
    barrier.srcAccessMask = VK_ACCESS_TRANSFER_WRITE_BIT;
    barrier.dstAccessMask = VK_ACCESS_HOST_READ_BIT;
    vkCmdPipelineBarrier(submission.commands, VK_PIPELINE_STAGE_TRANSFER_BIT, VK_PIPELINE_STAGE_HOST_BIT, 0, 1,
                         &barrier, 0, nullptr, 0, nullptr);
    slot.submit(submission);
    slot.frame = 0;  // no frame of its own: what it took is not reported
    slot.wait();
    std::memcpy(image.pixels.data(), readback.mapped(), image.pixels.size());
    return image;
}

}  // namespace flg::render
