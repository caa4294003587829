// SPDX-License-Identifier: MIT
#include "target_image.h"

#include <algorithm>

namespace flg::render {
namespace {

constexpr uint32_t largest_size = 16384;

void check_size(const Device& device, uint32_t width, uint32_t height) {
    const auto& limits = device.properties().limits;
    const uint32_t most =
        std::min({largest_size, limits.maxImageDimension2D, limits.maxFramebufferWidth, limits.maxFramebufferHeight});
    if (width == 0 || height == 0 || width > most || height > most)
        fail("An image of %u x %u pixels was asked for; each must be 1 to %u.", width, height, most);
}

}  // namespace

VkRenderPass make_main_pass(VkDevice device, VkSampleCountFlagBits samples, Eyes eyes) {
    const bool multisampled = samples != VK_SAMPLE_COUNT_1_BIT;
    VkAttachmentDescription color{};
    color.format = color_format;
    color.samples = samples;
    color.loadOp = VK_ATTACHMENT_LOAD_OP_DONT_CARE;  // the backdrop covers all that curves don't
    color.storeOp = multisampled ? VK_ATTACHMENT_STORE_OP_DONT_CARE : VK_ATTACHMENT_STORE_OP_STORE;
    color.stencilLoadOp = VK_ATTACHMENT_LOAD_OP_DONT_CARE;
    color.stencilStoreOp = VK_ATTACHMENT_STORE_OP_DONT_CARE;
    color.initialLayout = VK_IMAGE_LAYOUT_UNDEFINED;
    color.finalLayout = multisampled ? VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL : VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL;
    VkAttachmentDescription depth = color;
    depth.format = depth_format;
    depth.loadOp = VK_ATTACHMENT_LOAD_OP_CLEAR;
    depth.storeOp = VK_ATTACHMENT_STORE_OP_DONT_CARE;
    depth.finalLayout = VK_IMAGE_LAYOUT_DEPTH_STENCIL_ATTACHMENT_OPTIMAL;
    VkAttachmentDescription resolved = color;
    resolved.samples = VK_SAMPLE_COUNT_1_BIT;
    resolved.storeOp = VK_ATTACHMENT_STORE_OP_STORE;
    resolved.finalLayout = VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL;
    const VkAttachmentDescription attachments[] = {color, depth, resolved};

    const VkAttachmentReference color_reference{0, VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL};
    const VkAttachmentReference depth_reference{1, VK_IMAGE_LAYOUT_DEPTH_STENCIL_ATTACHMENT_OPTIMAL};
    const VkAttachmentReference resolve_reference{2, VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL};
    VkSubpassDescription subpass{};
    subpass.pipelineBindPoint = VK_PIPELINE_BIND_POINT_GRAPHICS;
    subpass.colorAttachmentCount = 1;
    subpass.pColorAttachments = &color_reference;
    subpass.pResolveAttachments = multisampled ? &resolve_reference : nullptr;
    subpass.pDepthStencilAttachment = &depth_reference;

    const VkPipelineStageFlags drawing = VK_PIPELINE_STAGE_COLOR_ATTACHMENT_OUTPUT_BIT |
                                         VK_PIPELINE_STAGE_EARLY_FRAGMENT_TESTS_BIT |
                                         VK_PIPELINE_STAGE_LATE_FRAGMENT_TESTS_BIT;
    const VkAccessFlags writing = VK_ACCESS_COLOR_ATTACHMENT_WRITE_BIT | VK_ACCESS_DEPTH_STENCIL_ATTACHMENT_WRITE_BIT;
    VkSubpassDependency dependencies[2]{};
    // The frame before, and whoever copied it, must be done with the images.
    dependencies[0].srcSubpass = VK_SUBPASS_EXTERNAL;
    dependencies[0].srcStageMask = drawing | VK_PIPELINE_STAGE_TRANSFER_BIT;
    dependencies[0].srcAccessMask = writing | VK_ACCESS_TRANSFER_READ_BIT;
    dependencies[0].dstStageMask = drawing;
    dependencies[0].dstAccessMask =
        writing | VK_ACCESS_COLOR_ATTACHMENT_READ_BIT | VK_ACCESS_DEPTH_STENCIL_ATTACHMENT_READ_BIT;
    dependencies[1].dstSubpass = VK_SUBPASS_EXTERNAL;
    dependencies[1].srcStageMask = VK_PIPELINE_STAGE_COLOR_ATTACHMENT_OUTPUT_BIT;
    dependencies[1].srcAccessMask = VK_ACCESS_COLOR_ATTACHMENT_WRITE_BIT;
    dependencies[1].dstStageMask = VK_PIPELINE_STAGE_TRANSFER_BIT;
    dependencies[1].dstAccessMask = VK_ACCESS_TRANSFER_READ_BIT;

    const uint32_t both_layers = 0b11;
    VkRenderPassMultiviewCreateInfo views{VK_STRUCTURE_TYPE_RENDER_PASS_MULTIVIEW_CREATE_INFO};
    views.subpassCount = views.correlationMaskCount = 1;
    views.pViewMasks = views.pCorrelationMasks = &both_layers;
    VkRenderPassCreateInfo info{VK_STRUCTURE_TYPE_RENDER_PASS_CREATE_INFO};
    info.pNext = eyes == Eyes::both ? &views : nullptr;
    info.attachmentCount = multisampled ? 3 : 2;
    info.pAttachments = attachments;
    info.subpassCount = 1;
    info.pSubpasses = &subpass;
    info.dependencyCount = 2;
    info.pDependencies = dependencies;
    VkRenderPass pass;
    check(vkCreateRenderPass(device, &info, nullptr, &pass), "make a render pass");
    return pass;
}

TargetImage::TargetImage(DeviceMemory& memory, const TargetPasses& passes, VkSampleCountFlagBits samples,
                         uint32_t width, uint32_t height, Eyes eyes)
    : device_(memory.device().handle()), width_(width), height_(height), eyes_(eyes) {
    check_size(memory.device(), width, height);
    try {
        create(memory, passes, samples);
    } catch (...) {
        destroy();
        throw;
    }
}

TargetImage::~TargetImage() {
    destroy();
}

void TargetImage::create(DeviceMemory& memory, const TargetPasses& passes, VkSampleCountFlagBits samples) {
    const bool multisampled = samples != VK_SAMPLE_COUNT_1_BIT;
    const uint32_t layers = layers_of(eyes_);
    color_ = DeviceImage(
        memory, {width_, height_, color_format, VK_SAMPLE_COUNT_1_BIT,
                 VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT, VK_IMAGE_ASPECT_COLOR_BIT,
                 VK_IMAGE_CREATE_MUTABLE_FORMAT_BIT, MemoryUse::targets, layers});
    depth_ = DeviceImage(memory, {width_, height_, depth_format, samples, VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT,
                                  VK_IMAGE_ASPECT_DEPTH_BIT, 0, MemoryUse::targets, layers});
    if (multisampled)
        multisampled_ =
            DeviceImage(memory, {width_, height_, color_format, samples, VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT,
                                 VK_IMAGE_ASPECT_COLOR_BIT, 0, MemoryUse::targets, layers});
    const VkImageView views[] = {multisampled ? multisampled_.view() : color_.view(), depth_.view(), color_.view()};
    VkFramebufferCreateInfo info{VK_STRUCTURE_TYPE_FRAMEBUFFER_CREATE_INFO};
    info.renderPass = passes.main[static_cast<uint32_t>(eyes_)];
    info.attachmentCount = multisampled ? 3 : 2;
    info.pAttachments = views;
    info.width = width_;
    info.height = height_;
    info.layers = 1;
    check(vkCreateFramebuffer(device_, &info, nullptr, &framebuffer_), "make a framebuffer");
    if (eyes_ == Eyes::both) return;
    VkImageViewCreateInfo view_info{VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO};
    view_info.image = color_.handle();
    view_info.viewType = VK_IMAGE_VIEW_TYPE_2D;
    view_info.format = encoded_color_format;
    view_info.subresourceRange = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1};
    check(vkCreateImageView(device_, &view_info, nullptr, &encoded_view_), "make an image view");
    info.renderPass = passes.ui;
    info.attachmentCount = 1;
    info.pAttachments = &encoded_view_;
    check(vkCreateFramebuffer(device_, &info, nullptr, &ui_framebuffer_), "make a framebuffer");
}

void TargetImage::destroy() {
    vkDestroyFramebuffer(device_, ui_framebuffer_, nullptr);
    vkDestroyFramebuffer(device_, framebuffer_, nullptr);
    vkDestroyImageView(device_, encoded_view_, nullptr);
}

}  // namespace flg::render
