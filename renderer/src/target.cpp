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
uint32_t Target::refined() const {
    return image_->refined;
}
bool Target::begin_frame(uint32_t) {
    return true;
}
void Target::end_frame(FrameSubmission&) {}
void Target::present(FrameSubmission&) {}
void Target::abandon_frame() noexcept {}
void Target::leave_device() noexcept {}

StereoTarget::StereoTarget(Renderer& renderer, uint32_t width, uint32_t height) : renderer_(renderer) {
    auto& s = *renderer.state_;
    const bool one_pass = s.options.stereo == StereoPasses::one;
    if (one_pass) s.need_stereo();
    for (int i = 0; i < (one_pass ? 1 : 2); ++i)
        images_.push_back(std::make_unique<TargetImage>(s.memory, s.passes(), s.samples, width, height,
                                                        one_pass ? Eyes::both : Eyes::one));
    for (auto& image : images_) s.targets.push_back({&image, nullptr});
}

StereoTarget::~StereoTarget() {
    auto& s = *renderer_.state_;
    vkDeviceWaitIdle(s.device.handle());
    for (const auto& image : images_)
        std::erase_if(s.targets, [&](const auto& entry) { return entry.image == &image; });
}

uint32_t StereoTarget::width() const {
    return images_[0]->width();
}
uint32_t StereoTarget::height() const {
    return images_[0]->height();
}

Image Renderer::capture(Target& target) {
    if (&target.renderer_ != this) fail("The target belongs to another renderer.");
    return state_->capture(*target.image_, 0);
}

Image Renderer::capture(StereoTarget& target, uint32_t eye) {
    if (&target.renderer_ != this) fail("The target belongs to another renderer.");
    if (eye > 1) fail("The eye is %u; it must be 0 or 1.", eye);
    const bool layered = target.images_.size() == 1;
    return state_->capture(*target.images_[layered ? 0 : eye], layered ? eye : 0);
}

Image Renderer::State::capture(const TargetImage& target, uint32_t layer) {
    Image image{target.width(), target.height(), {}};
    image.pixels.resize(size_t{4} * image.width * image.height);
    if (!target.drawn) {
        for (size_t i = 3; i < image.pixels.size(); i += 4) image.pixels[i] = 255;
        return image;
    }
    const Buffer readback(memory, image.pixels.size(), VK_BUFFER_USAGE_TRANSFER_DST_BIT, DeviceMemory::Place::readback,
                          MemoryUse::staging);
    // The slot of the next frame does the copy; its own last frame is the older of the two in flight.
    const auto slot_index = static_cast<uint32_t>((frame + 1) % frames_in_flight);
    FrameSlot& slot = *slots[slot_index];
    slot.wait();
    read_times(slot);
    recycle();
    FrameSubmission submission;
    submission.slot = slot_index;
    submission.commands = slot.begin();
    VkBufferImageCopy region{};
    region.imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, layer, 1};
    region.imageExtent = {image.width, image.height, 1};
    vkCmdCopyImageToBuffer(submission.commands, target.color(), VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, readback.handle(),
                           1, &region);
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
