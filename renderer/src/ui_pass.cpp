// SPDX-License-Identifier: MIT
#include "ui_pass.h"

#include <algorithm>
#include <cstddef>

#include "pipeline_build.h"
#include "shaders/ui_frag.h"
#include "shaders/ui_vert.h"
#include "target_image.h"

namespace flg::render {
namespace {

constexpr VkVertexInputBindingDescription vertex_binding = {0, sizeof(UiVertex), VK_VERTEX_INPUT_RATE_VERTEX};
constexpr VkVertexInputAttributeDescription vertex_attributes[] = {
    {0, 0, VK_FORMAT_R32G32_SFLOAT, offsetof(UiVertex, position_px)},
    {1, 0, VK_FORMAT_R32G32_SFLOAT, offsetof(UiVertex, uv)},
    {2, 0, VK_FORMAT_R8G8B8A8_UNORM, offsetof(UiVertex, color)}};

// From and to the state in which the main pass leaves the picture.
VkRenderPass make_pass(VkDevice device) {
    VkAttachmentDescription picture{};
    picture.format = encoded_color_format;
    picture.samples = VK_SAMPLE_COUNT_1_BIT;
    picture.loadOp = VK_ATTACHMENT_LOAD_OP_LOAD;
    picture.storeOp = VK_ATTACHMENT_STORE_OP_STORE;
    picture.stencilLoadOp = VK_ATTACHMENT_LOAD_OP_DONT_CARE;
    picture.stencilStoreOp = VK_ATTACHMENT_STORE_OP_DONT_CARE;
    picture.initialLayout = picture.finalLayout = VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL;
    const VkAttachmentReference reference{0, VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL};
    VkSubpassDescription subpass{};
    subpass.pipelineBindPoint = VK_PIPELINE_BIND_POINT_GRAPHICS;
    subpass.colorAttachmentCount = 1;
    subpass.pColorAttachments = &reference;
    VkSubpassDependency dependencies[2]{};
    // The main pass hands the picture over to transfers.
    dependencies[0].srcSubpass = VK_SUBPASS_EXTERNAL;
    dependencies[0].srcStageMask = VK_PIPELINE_STAGE_COLOR_ATTACHMENT_OUTPUT_BIT | VK_PIPELINE_STAGE_TRANSFER_BIT;
    dependencies[0].srcAccessMask = VK_ACCESS_COLOR_ATTACHMENT_WRITE_BIT;
    dependencies[0].dstStageMask = VK_PIPELINE_STAGE_COLOR_ATTACHMENT_OUTPUT_BIT;
    dependencies[0].dstAccessMask = VK_ACCESS_COLOR_ATTACHMENT_READ_BIT | VK_ACCESS_COLOR_ATTACHMENT_WRITE_BIT;
    dependencies[1].dstSubpass = VK_SUBPASS_EXTERNAL;
    dependencies[1].srcStageMask = VK_PIPELINE_STAGE_COLOR_ATTACHMENT_OUTPUT_BIT;
    dependencies[1].srcAccessMask = VK_ACCESS_COLOR_ATTACHMENT_WRITE_BIT;
    dependencies[1].dstStageMask = VK_PIPELINE_STAGE_TRANSFER_BIT;
    dependencies[1].dstAccessMask = VK_ACCESS_TRANSFER_READ_BIT;
    VkRenderPassCreateInfo info{VK_STRUCTURE_TYPE_RENDER_PASS_CREATE_INFO};
    info.attachmentCount = 1;
    info.pAttachments = &picture;
    info.subpassCount = 1;
    info.pSubpasses = &subpass;
    info.dependencyCount = 2;
    info.pDependencies = dependencies;
    VkRenderPass pass;
    check(vkCreateRenderPass(device, &info, nullptr, &pass), "make a render pass");
    return pass;
}

// The part of a clip rectangle that lies on the target; empty if none does.
VkRect2D on_target(glm::ivec4 clip, VkExtent2D extent) {
    const auto cut = [](int64_t begin, int64_t size, uint32_t end) {
        const int64_t from = std::clamp<int64_t>(begin, 0, end), to = std::clamp<int64_t>(begin + size, 0, end);
        return std::pair{static_cast<int32_t>(from), static_cast<uint32_t>(to - from)};
    };
    const auto [x, width] = cut(clip.x, clip.z, extent.width);
    const auto [y, height] = cut(clip.y, clip.w, extent.height);
    return {{x, y}, {width, height}};
}

}  // namespace

void check_ui(const UiFrame& ui, const TextureStore& textures) {
    for (size_t i = 0; i < ui.commands.size(); ++i) {
        const UiCommand& command = ui.commands[i];
        if (uint64_t{command.first_index} + command.index_count > ui.indices.size())
            fail("ui.commands[%zu] takes the indices %u to %llu; there are %zu.", i, command.first_index,
                 static_cast<unsigned long long>(command.first_index) + command.index_count, ui.indices.size());
        if (command.clip.z < 0 || command.clip.w < 0)
            fail("ui.commands[%zu].clip is %d x %d pixels; neither may be negative.", i, command.clip.z,
                 command.clip.w);
        textures.set_of(command.texture);
        if (command.index_count == 0) continue;
        const auto indices = ui.indices.subspan(command.first_index, command.index_count);
        const uint16_t most = *std::max_element(indices.begin(), indices.end());
        if (uint64_t{command.first_vertex} + most >= ui.vertices.size())
            fail("ui.commands[%zu] takes the vertex %u + %u; there are %zu.", i, command.first_vertex, most,
                 ui.vertices.size());
    }
}

UiPass::UiPass(const Device& device, const Shaders& shaders, VkDescriptorSetLayout texture_layout)
    : device_(device.handle()) {
    try {
        pass_ = make_pass(device_);
        layout_ = make_pipeline_layout(device_, {&texture_layout, 1}, sizeof(glm::vec2));
        const ShaderModule vertex(device_, shaders.of("ui.vert", ui_vert_spv));
        const ShaderModule fragment(device_, shaders.of("ui.frag", ui_frag_spv));
        PipelineDesc desc;
        desc.vertex = vertex.handle();
        desc.fragment = fragment.handle();
        desc.bindings = {&vertex_binding, 1};
        desc.attributes = vertex_attributes;
        desc.blending = Blending::by_alpha;
        desc.pass = pass_;
        desc.layout = layout_;
        pipeline_ = make_pipeline(device_, desc);
    } catch (...) {
        destroy();
        throw;
    }
}

UiPass::~UiPass() {
    destroy();
}

void UiPass::destroy() {
    vkDestroyPipeline(device_, pipeline_, nullptr);
    vkDestroyPipelineLayout(device_, layout_, nullptr);
    vkDestroyRenderPass(device_, pass_, nullptr);
}

uint32_t UiPass::record(VkCommandBuffer commands, VkFramebuffer framebuffer, VkExtent2D extent, const UiFrame& ui,
                        const UiBuffers& buffers, const TextureStore& textures) const {
    VkRenderPassBeginInfo info{VK_STRUCTURE_TYPE_RENDER_PASS_BEGIN_INFO};
    info.renderPass = pass_;
    info.framebuffer = framebuffer;
    info.renderArea.extent = extent;
    vkCmdBeginRenderPass(commands, &info, VK_SUBPASS_CONTENTS_INLINE);
    const glm::vec2 size(extent.width, extent.height);
    const VkViewport viewport{0, 0, size.x, size.y, 0, 1};
    vkCmdSetViewport(commands, 0, 1, &viewport);
    vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, pipeline_);
    const glm::vec2 per_pixel = 2.0f / size;
    vkCmdPushConstants(commands, layout_, VK_SHADER_STAGE_VERTEX_BIT | VK_SHADER_STAGE_FRAGMENT_BIT, 0,
                       sizeof per_pixel, &per_pixel);
    const VkDeviceSize no_offset = 0;
    vkCmdBindVertexBuffers(commands, 0, 1, &buffers.buffer, &no_offset);
    vkCmdBindIndexBuffer(commands, buffers.buffer, buffers.indices_at, VK_INDEX_TYPE_UINT16);
    VkDescriptorSet bound = VK_NULL_HANDLE;
    uint32_t calls = 0;
    for (const UiCommand& command : ui.commands) {
        const VkRect2D scissor = on_target(command.clip, extent);
        if (command.index_count == 0 || scissor.extent.width == 0 || scissor.extent.height == 0) continue;
        vkCmdSetScissor(commands, 0, 1, &scissor);
        const VkDescriptorSet set = textures.set_of(command.texture);
        if (set != bound)
            vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, layout_, 0, 1, &set, 0, nullptr);
        bound = set;
        vkCmdDrawIndexed(commands, command.index_count, 1, command.first_index,
                         static_cast<int32_t>(command.first_vertex), 0);
        ++calls;
    }
    vkCmdEndRenderPass(commands);
    return calls;
}

}  // namespace flg::render
