// SPDX-License-Identifier: MIT
#include "surface_pipelines.h"

#include <cstddef>
#include <vector>

#include "shaders/border_frag.h"
#include "shaders/border_vert.h"
#include "shaders/skinned_surface_shadow_vert.h"
#include "shaders/skinned_surface_vert.h"
#include "shaders/surface_frag.h"
#include "shaders/surface_shadow_vert.h"
#include "shaders/surface_vert.h"
#include "skin_data.h"
#include "surface_data.h"

namespace flg::render {
namespace {

constexpr VkVertexInputBindingDescription vertex_bindings[] = {{0, sizeof(glm::vec3), VK_VERTEX_INPUT_RATE_VERTEX},
                                                               {1, sizeof(SurfaceVertex), VK_VERTEX_INPUT_RATE_VERTEX}};
constexpr VkVertexInputAttributeDescription vertex_attributes[] = {
    {0, 0, VK_FORMAT_R32G32B32_SFLOAT, 0},
    {1, 1, VK_FORMAT_R16G16_SNORM, offsetof(SurfaceVertex, normal)},
    {2, 1, VK_FORMAT_R8G8B8A8_UNORM, offsetof(SurfaceVertex, color)},
    {3, 1, VK_FORMAT_R8G8B8A8_UNORM, offsetof(SurfaceVertex, material)},
    {4, 1, VK_FORMAT_R32_SFLOAT, offsetof(SurfaceVertex, field)}};

constexpr VkVertexInputBindingDescription edge_binding[] = {{0, sizeof(BorderEdge), VK_VERTEX_INPUT_RATE_INSTANCE}};
constexpr VkVertexInputAttributeDescription edge_attributes[] = {
    {0, 0, VK_FORMAT_R32G32B32_SFLOAT, offsetof(BorderEdge, from)},
    {1, 0, VK_FORMAT_R32G32B32_SFLOAT, offsetof(BorderEdge, to)},
    {2, 0, VK_FORMAT_R8G8B8A8_UNORM, offsetof(BorderEdge, color)},
    {3, 0, VK_FORMAT_R32_SFLOAT, offsetof(BorderEdge, half_width_px)}};

constexpr VkVertexInputBindingDescription skin_binding = {2, sizeof(SkinVertex), VK_VERTEX_INPUT_RATE_VERTEX};
constexpr VkVertexInputAttributeDescription skin_attributes[] = {
    {5, 2, VK_FORMAT_R16G16B16A16_UINT, offsetof(SkinVertex, joints)},
    {6, 2, VK_FORMAT_R16G16B16A16_UNORM, offsetof(SkinVertex, weights)}};

}  // namespace

SurfacePipelines::SurfacePipelines(const Device& device, VkRenderPass main_pass, VkSampleCountFlagBits samples,
                                   VkRenderPass shadow_pass, VkDescriptorSetLayout view_layout)
    : device_(device.handle()) {
    try {
        layout_ = make_pipeline_layout(device_, {&view_layout, 1}, sizeof(SurfacePush));
        const ShaderModule surface_vertex(device_, surface_vert_spv), surface_fragment(device_, surface_frag_spv);
        const ShaderModule border_vertex(device_, border_vert_spv), border_fragment(device_, border_frag_spv);
        const ShaderModule shadow_vertex(device_, surface_shadow_vert_spv);
        PipelineDesc surface;
        surface.layout = layout_;
        surface.pass = main_pass;
        surface.samples = samples;
        surface.vertex = surface_vertex.handle();
        surface.fragment = surface_fragment.handle();
        surface.bindings = vertex_bindings;
        surface.attributes = vertex_attributes;
        surface_ = make_pipeline(device_, surface);

        PipelineDesc border = surface;
        border.vertex = border_vertex.handle();
        border.fragment = border_fragment.handle();
        border.bindings = edge_binding;
        border.attributes = edge_attributes;
        border_ = make_pipeline(device_, border);

        PipelineDesc shadow;
        shadow.layout = layout_;
        shadow.pass = shadow_pass;
        shadow.vertex = shadow_vertex.handle();
        shadow.bindings = {vertex_bindings, 1};
        shadow.attributes = {vertex_attributes, 1};
        shadow.depth_test = VK_COMPARE_OP_LESS;
        shadow.biased = true;
        shadow_ = make_pipeline(device_, shadow);
        make_skinned(surface, shadow, view_layout);
    } catch (...) {
        destroy();
        throw;
    }
}

void SurfacePipelines::make_skinned(const PipelineDesc& surface, const PipelineDesc& shadow,
                                    VkDescriptorSetLayout view_layout) {
    const VkDescriptorSetLayoutBinding joints{0, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, 1, VK_SHADER_STAGE_VERTEX_BIT,
                                              nullptr};
    joints_layout_ = make_set_layout(device_, {&joints, 1});
    const VkDescriptorSetLayout sets[] = {view_layout, joints_layout_};
    skinned_layout_ = make_pipeline_layout(device_, sets, sizeof(SkinnedPush));
    const ShaderModule vertex(device_, skinned_surface_vert_spv);
    const ShaderModule shadow_vertex(device_, skinned_surface_shadow_vert_spv);
    const auto with_skin = [&](PipelineDesc desc, const ShaderModule& shader, VkPipeline(&pipelines)[2]) {
        std::vector<VkVertexInputBindingDescription> bindings(desc.bindings.begin(), desc.bindings.end());
        std::vector<VkVertexInputAttributeDescription> attributes(desc.attributes.begin(), desc.attributes.end());
        bindings.push_back(skin_binding);
        attributes.insert(attributes.end(), std::begin(skin_attributes), std::end(skin_attributes));
        desc.layout = skinned_layout_;
        desc.vertex = shader.handle();
        desc.bindings = bindings;
        desc.attributes = attributes;
        for (uint32_t skinning = 0; skinning < 2; ++skinning) {
            desc.constants = {&skinning, 1};
            pipelines[skinning] = make_pipeline(device_, desc);
        }
    };
    with_skin(surface, vertex, skinned_);
    with_skin(shadow, shadow_vertex, skinned_shadow_);
}

SurfacePipelines::~SurfacePipelines() {
    destroy();
}

void SurfacePipelines::destroy() {
    for (VkPipeline pipeline : {surface_, shadow_, border_}) vkDestroyPipeline(device_, pipeline, nullptr);
    for (int i = 0; i < 2; ++i) {
        vkDestroyPipeline(device_, skinned_[i], nullptr);
        vkDestroyPipeline(device_, skinned_shadow_[i], nullptr);
    }
    vkDestroyPipelineLayout(device_, skinned_layout_, nullptr);
    vkDestroyDescriptorSetLayout(device_, joints_layout_, nullptr);
    vkDestroyPipelineLayout(device_, layout_, nullptr);
}

}  // namespace flg::render
