// SPDX-License-Identifier: MIT
#include "finish_pass.h"

#include <utility>

#include "shaders/finish_frag.h"
#include "shaders/finish_frag_multisampled.h"
#include "shaders/finish_vert.h"
#include "shaders/occlusion_frag.h"
#include "shaders/occlusion_frag_multisampled.h"

namespace flg::render {
namespace {

constexpr uint32_t read_images = 3;  // depths, picture, occlusion

// How a pass finds its image, who used it before, and who reads it then.
struct PassDesc {
    VkFormat format;
    VkAttachmentLoadOp load;
    VkImageLayout before, after;
    VkPipelineStageFlags stages;  // of others
    VkAccessFlags reads;
};

VkRenderPass make_pass(VkDevice device, const PassDesc& desc) {
    VkAttachmentDescription image{};
    image.format = desc.format;
    image.samples = VK_SAMPLE_COUNT_1_BIT;
    image.loadOp = desc.load;
    image.storeOp = VK_ATTACHMENT_STORE_OP_STORE;
    image.stencilLoadOp = VK_ATTACHMENT_LOAD_OP_DONT_CARE;
    image.stencilStoreOp = VK_ATTACHMENT_STORE_OP_DONT_CARE;
    image.initialLayout = desc.before;
    image.finalLayout = desc.after;
    const VkAttachmentReference reference{0, VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL};
    VkSubpassDescription subpass{};
    subpass.pipelineBindPoint = VK_PIPELINE_BIND_POINT_GRAPHICS;
    subpass.colorAttachmentCount = 1;
    subpass.pColorAttachments = &reference;
    const VkPipelineStageFlags drawing = VK_PIPELINE_STAGE_COLOR_ATTACHMENT_OUTPUT_BIT;
    VkSubpassDependency dependencies[2]{};
    dependencies[0].srcSubpass = VK_SUBPASS_EXTERNAL;
    dependencies[0].srcStageMask = drawing | desc.stages;
    dependencies[0].srcAccessMask = VK_ACCESS_COLOR_ATTACHMENT_WRITE_BIT | desc.reads;
    dependencies[0].dstStageMask = drawing;
    dependencies[0].dstAccessMask = VK_ACCESS_COLOR_ATTACHMENT_READ_BIT | VK_ACCESS_COLOR_ATTACHMENT_WRITE_BIT;
    dependencies[1].dstSubpass = VK_SUBPASS_EXTERNAL;
    dependencies[1].srcStageMask = drawing;
    dependencies[1].srcAccessMask = VK_ACCESS_COLOR_ATTACHMENT_WRITE_BIT;
    dependencies[1].dstStageMask = desc.stages;
    dependencies[1].dstAccessMask = desc.reads;
    VkRenderPassCreateInfo info{VK_STRUCTURE_TYPE_RENDER_PASS_CREATE_INFO};
    info.attachmentCount = 1;
    info.pAttachments = &image;
    info.subpassCount = 1;
    info.pSubpasses = &subpass;
    info.dependencyCount = 2;
    info.pDependencies = dependencies;
    VkRenderPass pass = VK_NULL_HANDLE;
    check(vkCreateRenderPass(device, &info, nullptr, &pass), "make a render pass");
    return pass;
}

VkSampler make_sampler(VkDevice device, VkFilter filter) {
    VkSamplerCreateInfo info{VK_STRUCTURE_TYPE_SAMPLER_CREATE_INFO};
    info.magFilter = info.minFilter = filter;
    info.addressModeU = info.addressModeV = info.addressModeW = VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE;
    VkSampler sampler = VK_NULL_HANDLE;
    check(vkCreateSampler(device, &info, nullptr, &sampler), "make a sampler");
    return sampler;
}

void begin(VkCommandBuffer commands, VkRenderPass pass, VkFramebuffer framebuffer, VkExtent2D extent,
           const VkRect2D& area) {
    const VkClearValue black{{{0, 0, 0, 1}}};
    VkRenderPassBeginInfo info{VK_STRUCTURE_TYPE_RENDER_PASS_BEGIN_INFO};
    info.renderPass = pass;
    info.framebuffer = framebuffer;
    info.renderArea.extent = extent;
    info.clearValueCount = 1;
    info.pClearValues = &black;
    vkCmdBeginRenderPass(commands, &info, VK_SUBPASS_CONTENTS_INLINE);
    const VkViewport viewport{static_cast<float>(area.offset.x),
                              static_cast<float>(area.offset.y),
                              static_cast<float>(area.extent.width),
                              static_cast<float>(area.extent.height),
                              0,
                              1};
    vkCmdSetViewport(commands, 0, 1, &viewport);
    vkCmdSetScissor(commands, 0, 1, &area);
}

void draw_triangle(VkCommandBuffer commands, VkPipeline pipeline) {
    vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, pipeline);
    vkCmdDraw(commands, 3, 1, 0, 0);
    vkCmdEndRenderPass(commands);
}

glm::ivec2 size_of(VkExtent2D extent) {
    return {static_cast<int>(extent.width), static_cast<int>(extent.height)};
}

}  // namespace

FinishPass::FinishPass(const Device& device, const Shaders& shaders, VkDescriptorSetLayout view_layout,
                       VkSampleCountFlagBits samples)
    : device_(device.handle()) {
    const VkImageLayout unknown = VK_IMAGE_LAYOUT_UNDEFINED, copied = VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL;
    const VkPipelineStageFlags shader = VK_PIPELINE_STAGE_FRAGMENT_SHADER_BIT, copy = VK_PIPELINE_STAGE_TRANSFER_BIT;
    try {
        occlusion_pass_ =
            make_pass(device_, {occlusion_format, VK_ATTACHMENT_LOAD_OP_DONT_CARE, unknown,
                                VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL, shader, VK_ACCESS_SHADER_READ_BIT});
        finish_pass_ = make_pass(
            device_, {color_format, VK_ATTACHMENT_LOAD_OP_CLEAR, unknown, copied, copy, VK_ACCESS_TRANSFER_READ_BIT});
        mean_passes_[0] = make_pass(
            device_, {mean_format, VK_ATTACHMENT_LOAD_OP_CLEAR, unknown, copied, copy, VK_ACCESS_TRANSFER_READ_BIT});
        mean_passes_[1] = make_pass(
            device_, {mean_format, VK_ATTACHMENT_LOAD_OP_LOAD, copied, copied, copy, VK_ACCESS_TRANSFER_READ_BIT});
        nearest_ = make_sampler(device_, VK_FILTER_NEAREST);
        linear_ = make_sampler(device_, VK_FILTER_LINEAR);
        VkDescriptorSetLayoutBinding bindings[read_images];
        for (uint32_t i = 0; i < read_images; ++i)
            bindings[i] = {i, VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, 1, VK_SHADER_STAGE_FRAGMENT_BIT, nullptr};
        set_layout_ = make_set_layout(device_, bindings);
        const VkDescriptorSetLayout sets[] = {view_layout, set_layout_};
        layout_ = make_pipeline_layout(device_, sets, sizeof(FinishPush));
        make_pipelines(shaders, samples);
    } catch (...) {
        destroy();
        throw;
    }
}

FinishPass::~FinishPass() {
    destroy();
}

void FinishPass::destroy() {
    for (VkPipeline pipeline : {occlusion_, finish_, mean_}) vkDestroyPipeline(device_, pipeline, nullptr);
    vkDestroyPipelineLayout(device_, layout_, nullptr);
    vkDestroyDescriptorSetLayout(device_, set_layout_, nullptr);
    for (VkSampler sampler : {nearest_, linear_}) vkDestroySampler(device_, sampler, nullptr);
    for (VkRenderPass pass : {occlusion_pass_, finish_pass_, mean_passes_[0], mean_passes_[1]})
        vkDestroyRenderPass(device_, pass, nullptr);
}

void FinishPass::make_pipelines(const Shaders& shaders, VkSampleCountFlagBits samples) {
    const auto fragment = [&](const char* file, std::span<const uint32_t> one, std::span<const uint32_t> many) {
        const bool multisampled = samples != VK_SAMPLE_COUNT_1_BIT;
        return ShaderModule(device_, shaders.of(file, multisampled ? many : one,
                                                multisampled ? ShaderVariant::multisampled : ShaderVariant::plain));
    };
    const ShaderModule vertex(device_, shaders.of("finish.vert", finish_vert_spv));
    const ShaderModule occlusion = fragment("occlusion.frag", occlusion_frag_spv, occlusion_frag_multisampled_spv);
    const ShaderModule finish = fragment("finish.frag", finish_frag_spv, finish_frag_multisampled_spv);
    PipelineDesc desc;
    desc.vertex = vertex.handle();
    desc.layout = layout_;
    desc.fragment = occlusion.handle();
    desc.pass = occlusion_pass_;
    occlusion_ = make_pipeline(device_, desc);
    desc.fragment = finish.handle();
    desc.pass = finish_pass_;
    finish_ = make_pipeline(device_, desc);
    desc.pass = mean_passes_[0];
    desc.blending = Blending::by_constant;
    mean_ = make_pipeline(device_, desc);
}

void FinishPass::swap_pipelines(FinishPass& other) {
    std::swap(occlusion_, other.occlusion_);
    std::swap(finish_, other.finish_);
    std::swap(mean_, other.mean_);
}

VkDescriptorPool FinishPass::make_pool(uint32_t layers) const {
    const VkDescriptorPoolSize size{VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, read_images * layers};
    VkDescriptorPoolCreateInfo info{VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO};
    info.maxSets = layers;
    info.poolSizeCount = 1;
    info.pPoolSizes = &size;
    VkDescriptorPool pool = VK_NULL_HANDLE;
    check(vkCreateDescriptorPool(device_, &info, nullptr, &pool), "make a descriptor pool");
    return pool;
}

VkDescriptorSet FinishPass::make_set(VkDescriptorPool pool, VkImageView depth, VkImageView scene,
                                     VkImageView occlusion) const {
    VkDescriptorSetAllocateInfo info{VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO};
    info.descriptorPool = pool;
    info.descriptorSetCount = 1;
    info.pSetLayouts = &set_layout_;
    VkDescriptorSet set = VK_NULL_HANDLE;
    check(vkAllocateDescriptorSets(device_, &info, &set), "make a descriptor set");
    const VkDescriptorImageInfo images[read_images] = {
        {nearest_, depth, VK_IMAGE_LAYOUT_DEPTH_STENCIL_READ_ONLY_OPTIMAL},
        {linear_, scene, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL},
        {nearest_, occlusion, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL}};
    VkWriteDescriptorSet write{VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET};
    write.dstSet = set;
    write.descriptorCount = read_images;
    write.descriptorType = VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER;
    write.pImageInfo = images;
    for (uint32_t i = 0; i < read_images; ++i) {
        write.dstBinding = i;
        write.descriptorCount = 1;
        write.pImageInfo = &images[i];
        vkUpdateDescriptorSets(device_, 1, &write, 0, nullptr);
    }
    return set;
}

void FinishPass::bind(VkCommandBuffer commands, VkDescriptorSet view, const TargetImage& image, uint32_t layer,
                      VkExtent2D drawn, const VkRect2D& area) const {
    const VkDescriptorSet sets[] = {view, image.layer(layer).set};
    vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, layout_, 0, 2, sets, 0, nullptr);
    const FinishPush push{size_of(drawn), {area.offset.x, area.offset.y}, size_of(area.extent)};
    vkCmdPushConstants(commands, layout_, VK_SHADER_STAGE_VERTEX_BIT | VK_SHADER_STAGE_FRAGMENT_BIT, 0, sizeof push,
                       &push);
}

void FinishPass::record_occlusion(VkCommandBuffer commands, const TargetImage& image, uint32_t layer,
                                  VkExtent2D drawn) const {
    const VkRect2D all{{0, 0}, {(drawn.width + 1) / 2, (drawn.height + 1) / 2}};
    begin(commands, occlusion_pass_, image.layer(layer).occlusion_framebuffer, all.extent, all);
    draw_triangle(commands, occlusion_);
}

void FinishPass::record(VkCommandBuffer commands, VkDescriptorSet view, const TargetImage& image, uint32_t layer,
                        VkExtent2D drawn, const VkRect2D& area) const {
    bind(commands, view, image, layer, drawn, area);
    record_occlusion(commands, image, layer, drawn);
    begin(commands, finish_pass_, image.layer(layer).framebuffer, {image.width(), image.height()}, area);
    draw_triangle(commands, finish_);
}

void FinishPass::record_mean(VkCommandBuffer commands, VkDescriptorSet view, const TargetImage& image, VkExtent2D drawn,
                             const VkRect2D& area, uint32_t frame) const {
    bind(commands, view, image, 0, drawn, area);
    record_occlusion(commands, image, 0, drawn);
    begin(commands, mean_pass(frame == 1), image.mean_framebuffer(), {image.width(), image.height()}, area);
    const float share = 1.0f / static_cast<float>(frame);
    const float shares[4] = {share, share, share, share};
    vkCmdSetBlendConstants(commands, shares);
    draw_triangle(commands, mean_);
}

void FinishPass::record_copy(VkCommandBuffer commands, const TargetImage& image) {
    VkImageMemoryBarrier barrier{VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER};
    barrier.srcAccessMask = VK_ACCESS_COLOR_ATTACHMENT_WRITE_BIT;
    barrier.dstAccessMask = VK_ACCESS_TRANSFER_WRITE_BIT;
    barrier.oldLayout = VK_IMAGE_LAYOUT_UNDEFINED;
    barrier.newLayout = VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL;
    barrier.srcQueueFamilyIndex = barrier.dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
    barrier.image = image.color();
    barrier.subresourceRange = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1};
    const VkPipelineStageFlags users = VK_PIPELINE_STAGE_COLOR_ATTACHMENT_OUTPUT_BIT | VK_PIPELINE_STAGE_TRANSFER_BIT;
    vkCmdPipelineBarrier(commands, users, VK_PIPELINE_STAGE_TRANSFER_BIT, 0, 0, nullptr, 0, nullptr, 1, &barrier);
    VkImageBlit region{};
    region.srcSubresource = region.dstSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1};
    region.srcOffsets[1] =
        region.dstOffsets[1] = {static_cast<int32_t>(image.width()), static_cast<int32_t>(image.height()), 1};
    vkCmdBlitImage(commands, image.mean(), VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, image.color(),
                   VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, 1, &region, VK_FILTER_NEAREST);
    barrier.srcAccessMask = VK_ACCESS_TRANSFER_WRITE_BIT;
    barrier.dstAccessMask =
        VK_ACCESS_TRANSFER_READ_BIT | VK_ACCESS_COLOR_ATTACHMENT_READ_BIT | VK_ACCESS_COLOR_ATTACHMENT_WRITE_BIT;
    barrier.oldLayout = VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL;
    barrier.newLayout = VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL;
    vkCmdPipelineBarrier(commands, VK_PIPELINE_STAGE_TRANSFER_BIT, users, 0, 0, nullptr, 0, nullptr, 1, &barrier);
}

}  // namespace flg::render
