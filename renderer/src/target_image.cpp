// SPDX-License-Identifier: MIT
#include "target_image.h"

#include <algorithm>

#include "finish_pass.h"

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

VkImageView make_layer_view(VkDevice device, VkImage image, VkFormat format, VkImageAspectFlags aspect,
                            uint32_t layer) {
    VkImageViewCreateInfo info{VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO};
    info.image = image;
    info.viewType = VK_IMAGE_VIEW_TYPE_2D;
    info.format = format;
    info.subresourceRange = {aspect, 0, 1, layer, 1};
    VkImageView view = VK_NULL_HANDLE;
    check(vkCreateImageView(device, &info, nullptr, &view), "make an image view");
    return view;
}

}  // namespace

bool PictureKey::operator==(const PictureKey& other) const {
    const auto same_field = [](const std::optional<FieldOfView>& a, const std::optional<FieldOfView>& b) {
        if (!a || !b) return !a && !b;
        return a->left == b->left && a->right == b->right && a->up == b->up && a->down == b->down;
    };
    return revision == other.revision && viewport == other.viewport && camera.eye == other.camera.eye &&
           camera.target == other.camera.target && camera.up == other.camera.up &&
           camera.fov_y_rad == other.camera.fov_y_rad && same_field(camera.field, other.camera.field);
}

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
    const VkImageLayout read = VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL;
    color.finalLayout = multisampled ? VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL : read;
    VkAttachmentDescription depth = color;
    depth.format = depth_format;
    depth.loadOp = VK_ATTACHMENT_LOAD_OP_CLEAR;
    depth.storeOp = VK_ATTACHMENT_STORE_OP_STORE;
    depth.finalLayout = VK_IMAGE_LAYOUT_DEPTH_STENCIL_READ_ONLY_OPTIMAL;
    VkAttachmentDescription resolved = color;
    resolved.samples = VK_SAMPLE_COUNT_1_BIT;
    resolved.storeOp = VK_ATTACHMENT_STORE_OP_STORE;
    resolved.finalLayout = read;
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
    // The frame before, and its finish, must be done with the images.
    dependencies[0].srcSubpass = VK_SUBPASS_EXTERNAL;
    dependencies[0].srcStageMask = drawing | VK_PIPELINE_STAGE_FRAGMENT_SHADER_BIT;
    dependencies[0].srcAccessMask = writing | VK_ACCESS_SHADER_READ_BIT;
    dependencies[0].dstStageMask = drawing;
    dependencies[0].dstAccessMask =
        writing | VK_ACCESS_COLOR_ATTACHMENT_READ_BIT | VK_ACCESS_DEPTH_STENCIL_ATTACHMENT_READ_BIT;
    dependencies[1].dstSubpass = VK_SUBPASS_EXTERNAL;
    dependencies[1].srcStageMask = drawing;
    dependencies[1].srcAccessMask = writing;
    dependencies[1].dstStageMask = VK_PIPELINE_STAGE_FRAGMENT_SHADER_BIT;
    dependencies[1].dstAccessMask = VK_ACCESS_SHADER_READ_BIT;

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

VkFramebuffer TargetImage::make_framebuffer(VkRenderPass pass, std::span<const VkImageView> views, uint32_t width,
                                            uint32_t height) const {
    VkFramebufferCreateInfo info{VK_STRUCTURE_TYPE_FRAMEBUFFER_CREATE_INFO};
    info.renderPass = pass;
    info.attachmentCount = static_cast<uint32_t>(views.size());
    info.pAttachments = views.data();
    info.width = width;
    info.height = height;
    info.layers = 1;
    VkFramebuffer framebuffer = VK_NULL_HANDLE;
    check(vkCreateFramebuffer(device_, &info, nullptr, &framebuffer), "make a framebuffer");
    return framebuffer;
}

void TargetImage::create(DeviceMemory& memory, const TargetPasses& passes, VkSampleCountFlagBits samples) {
    const bool multisampled = samples != VK_SAMPLE_COUNT_1_BIT;
    const uint32_t layers = layers_of(eyes_);
    const VkImageUsageFlags drawn_and_read = VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_SAMPLED_BIT;
    color_ = DeviceImage(
        memory,
        {width_, height_, color_format, VK_SAMPLE_COUNT_1_BIT,
         VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT,
         VK_IMAGE_ASPECT_COLOR_BIT, VK_IMAGE_CREATE_MUTABLE_FORMAT_BIT, MemoryUse::targets, layers});
    scene_ = DeviceImage(memory, {width_, height_, color_format, VK_SAMPLE_COUNT_1_BIT, drawn_and_read,
                                  VK_IMAGE_ASPECT_COLOR_BIT, 0, MemoryUse::targets, layers});
    depth_ = DeviceImage(memory, {width_, height_, depth_format, samples,
                                  VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT | VK_IMAGE_USAGE_SAMPLED_BIT,
                                  VK_IMAGE_ASPECT_DEPTH_BIT, 0, MemoryUse::targets, layers});
    occlusion_ = DeviceImage(memory, {(width_ + 1) / 2, (height_ + 1) / 2, occlusion_format, VK_SAMPLE_COUNT_1_BIT,
                                      drawn_and_read, VK_IMAGE_ASPECT_COLOR_BIT, 0, MemoryUse::targets, layers});
    if (multisampled)
        multisampled_ =
            DeviceImage(memory, {width_, height_, color_format, samples, VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT,
                                 VK_IMAGE_ASPECT_COLOR_BIT, 0, MemoryUse::targets, layers});
    const VkImageView views[] = {multisampled ? multisampled_.view() : scene_.view(), depth_.view(), scene_.view()};
    framebuffer_ =
        make_framebuffer(passes.main[static_cast<uint32_t>(eyes_)], {views, multisampled ? 3u : 2u}, width_, height_);
    descriptors_ = passes.finish.make_pool(layers);
    for (uint32_t i = 0; i < layers; ++i) create_layer(i, passes);
    if (eyes_ == Eyes::both) return;
    encoded_view_ = make_layer_view(device_, color_.handle(), encoded_color_format, VK_IMAGE_ASPECT_COLOR_BIT, 0);
    ui_framebuffer_ = make_framebuffer(passes.ui, {&encoded_view_, 1}, width_, height_);
}

void TargetImage::create_layer(uint32_t index, const TargetPasses& passes) {
    Layer& layer = layers_[index];
    const VkImageAspectFlags color = VK_IMAGE_ASPECT_COLOR_BIT;
    layer.depth = make_layer_view(device_, depth_.handle(), depth_format, VK_IMAGE_ASPECT_DEPTH_BIT, index);
    layer.scene = make_layer_view(device_, scene_.handle(), color_format, color, index);
    layer.occlusion = make_layer_view(device_, occlusion_.handle(), occlusion_format, color, index);
    layer.color = make_layer_view(device_, color_.handle(), color_format, color, index);
    layer.occlusion_framebuffer =
        make_framebuffer(passes.finish.occlusion_pass(), {&layer.occlusion, 1}, (width_ + 1) / 2, (height_ + 1) / 2);
    layer.framebuffer = make_framebuffer(passes.finish.finish_pass(), {&layer.color, 1}, width_, height_);
    layer.set = passes.finish.make_set(descriptors_, layer.depth, layer.scene, layer.occlusion);
}

void TargetImage::need_mean(DeviceMemory& memory, const FinishPass& finish) {
    if (mean_framebuffer_) return;
    mean_ = DeviceImage(memory, {width_, height_, mean_format, VK_SAMPLE_COUNT_1_BIT,
                                 VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT,
                                 VK_IMAGE_ASPECT_COLOR_BIT, 0, MemoryUse::targets, 1});
    const VkImageView view = mean_.view();
    mean_framebuffer_ = make_framebuffer(finish.mean_pass(true), {&view, 1}, width_, height_);
}

void TargetImage::destroy() {
    for (VkFramebuffer framebuffer : {mean_framebuffer_, ui_framebuffer_, framebuffer_})
        vkDestroyFramebuffer(device_, framebuffer, nullptr);
    vkDestroyImageView(device_, encoded_view_, nullptr);
    for (const Layer& layer : layers_) {
        vkDestroyFramebuffer(device_, layer.framebuffer, nullptr);
        vkDestroyFramebuffer(device_, layer.occlusion_framebuffer, nullptr);
        for (VkImageView view : {layer.depth, layer.scene, layer.occlusion, layer.color})
            vkDestroyImageView(device_, view, nullptr);
    }
    vkDestroyDescriptorPool(device_, descriptors_, nullptr);
}

}  // namespace flg::render
