// SPDX-License-Identifier: MIT
#include "surface_pipelines.h"

#include <cstddef>
#include <utility>
#include <vector>

#include "shaders/border_frag.h"
#include "shaders/border_frag_stereo.h"
#include "shaders/border_vert.h"
#include "shaders/border_vert_stereo.h"
#include "shaders/skinned_surface_shadow_vert.h"
#include "shaders/skinned_surface_vert.h"
#include "shaders/skinned_surface_vert_stereo.h"
#include "shaders/skinned_surface_vert_textured.h"
#include "shaders/skinned_surface_vert_textured_stereo.h"
#include "shaders/surface_frag.h"
#include "shaders/surface_frag_stereo.h"
#include "shaders/surface_frag_textured.h"
#include "shaders/surface_frag_textured_stereo.h"
#include "shaders/surface_shadow_vert.h"
#include "shaders/surface_vert.h"
#include "shaders/surface_vert_stereo.h"
#include "shaders/surface_vert_textured.h"
#include "shaders/surface_vert_textured_stereo.h"
#include "skin_data.h"
#include "surface_data.h"

namespace flg::render {
namespace {

constexpr uint32_t field_location = 4, uv_location = 7;
constexpr VkVertexInputBindingDescription vertex_bindings[] = {{0, sizeof(glm::vec3), VK_VERTEX_INPUT_RATE_VERTEX},
                                                               {1, sizeof(SurfaceVertex), VK_VERTEX_INPUT_RATE_VERTEX}};
constexpr VkVertexInputAttributeDescription vertex_attributes[] = {
    {0, 0, VK_FORMAT_R32G32B32_SFLOAT, 0},
    {1, 1, VK_FORMAT_R16G16_SNORM, offsetof(SurfaceVertex, normal)},
    {2, 1, VK_FORMAT_R8G8B8A8_UNORM, offsetof(SurfaceVertex, color)},
    {3, 1, VK_FORMAT_R8G8B8A8_UNORM, offsetof(SurfaceVertex, material)},
    {field_location, 1, VK_FORMAT_R32_SFLOAT, offsetof(SurfaceVertex, field)}};

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

SurfacePipelines::SurfacePipelines(const Device& device, const Shaders& shaders, const RenderPasses& passes,
                                   VkDescriptorSetLayout view_layout)
    : device_(device.handle()), shaders_(&shaders), passes_(passes) {
    try {
        make_layouts(view_layout);
        make_main(Eyes::one);
        make_shadows();
    } catch (...) {
        destroy();
        throw;
    }
}

void SurfacePipelines::make_layouts(VkDescriptorSetLayout view_layout) {
    layout_ = make_pipeline_layout(device_, {&view_layout, 1}, sizeof(SurfacePush));
    const VkDescriptorSetLayoutBinding joints{0, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, 1, VK_SHADER_STAGE_VERTEX_BIT,
                                              nullptr};
    joints_layout_ = make_set_layout(device_, {&joints, 1});
    const VkDescriptorSetLayout sets[] = {view_layout, joints_layout_};
    skinned_layout_ = make_pipeline_layout(device_, sets, sizeof(SurfacePush));
    const VkDescriptorSetLayoutBinding texture{0, VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, 1,
                                               VK_SHADER_STAGE_FRAGMENT_BIT, nullptr};
    texture_set_layout_ = make_set_layout(device_, {&texture, 1});
    const VkDescriptorSetLayout all[] = {view_layout, joints_layout_, texture_set_layout_};
    textured_layout_ = make_pipeline_layout(device_, all, sizeof(SurfacePush));
}

void SurfacePipelines::need_stereo() {
    if (!of(Eyes::both).surface) make_main(Eyes::both);
}

void SurfacePipelines::make_main(Eyes eyes) {
    const auto shader = [&](const char* file, std::span<const uint32_t> one, std::span<const uint32_t> both) {
        const bool stereo = eyes == Eyes::both;
        const ShaderVariant variant = stereo ? ShaderVariant::stereo : ShaderVariant::plain;
        return ShaderModule(device_, shaders_->of(file, stereo ? both : one, variant));
    };
    const ShaderModule surface_vertex = shader("surface.vert", surface_vert_spv, surface_vert_stereo_spv);
    const ShaderModule surface_fragment = shader("surface.frag", surface_frag_spv, surface_frag_stereo_spv);
    const ShaderModule border_vertex = shader("border.vert", border_vert_spv, border_vert_stereo_spv);
    const ShaderModule border_fragment = shader("border.frag", border_frag_spv, border_frag_stereo_spv);
    const ShaderModule skinned_vertex =
        shader("skinned_surface.vert", skinned_surface_vert_spv, skinned_surface_vert_stereo_spv);
    Main& made = main_[static_cast<int>(eyes)];
    PipelineDesc surface;
    surface.layout = layout_;
    surface.pass = passes_.main[static_cast<int>(eyes)];
    surface.samples = passes_.samples;
    surface.vertex = surface_vertex.handle();
    surface.fragment = surface_fragment.handle();
    surface.bindings = vertex_bindings;
    surface.attributes = vertex_attributes;

    PipelineDesc border = surface;
    border.vertex = border_vertex.handle();
    border.fragment = border_fragment.handle();
    border.bindings = edge_binding;
    border.attributes = edge_attributes;
    border.writes_depth = false;  // it is as if on the surface
    made.border = make_pipeline(device_, border);

    PipelineDesc skinned = surface;
    skinned.vertex = skinned_vertex.handle();
    make_skinned(skinned, skinned_layout_, made.skinned);
    made.surface = make_pipeline(device_, surface);
    make_textured(eyes, surface);
}

void SurfacePipelines::make_textured(Eyes eyes, PipelineDesc desc) {
    const bool stereo = eyes == Eyes::both;
    const auto shader = [&](const char* file, std::span<const uint32_t> one, std::span<const uint32_t> both) {
        const ShaderVariant variant = stereo ? ShaderVariant::textured_stereo : ShaderVariant::textured;
        return ShaderModule(device_, shaders_->of(file, stereo ? both : one, variant));
    };
    const ShaderModule vertex = shader("surface.vert", surface_vert_textured_spv, surface_vert_textured_stereo_spv);
    const ShaderModule fragment = shader("surface.frag", surface_frag_textured_spv, surface_frag_textured_stereo_spv);
    const ShaderModule skinned =
        shader("skinned_surface.vert", skinned_surface_vert_textured_spv, skinned_surface_vert_textured_stereo_spv);
    std::vector<VkVertexInputBindingDescription> bindings(desc.bindings.begin(), desc.bindings.end());
    std::vector<VkVertexInputAttributeDescription> attributes(desc.attributes.begin(), desc.attributes.end());
    bindings.push_back({textured_binding, sizeof(glm::vec2), VK_VERTEX_INPUT_RATE_VERTEX});
    attributes.push_back({uv_location, textured_binding, VK_FORMAT_R32G32_SFLOAT, 0});
    desc.bindings = bindings;
    desc.attributes = attributes;
    desc.layout = textured_layout_;
    desc.vertex = vertex.handle();
    desc.fragment = fragment.handle();
    Main& made = main_[static_cast<int>(eyes)];
    made.textured = make_pipeline(device_, desc);
    desc.vertex = skinned.handle();
    make_skinned(desc, textured_layout_, made.textured_skinned);
}

void SurfacePipelines::make_shadows() {
    const ShaderModule vertex(device_, shaders_->of("surface_shadow.vert", surface_shadow_vert_spv));
    const ShaderModule skinned_vertex(device_,
                                      shaders_->of("skinned_surface_shadow.vert", skinned_surface_shadow_vert_spv));
    PipelineDesc shadow;
    shadow.layout = layout_;
    shadow.pass = passes_.shadow;
    shadow.vertex = vertex.handle();
    shadow.bindings = {vertex_bindings, 1};
    shadow.attributes = {vertex_attributes, 1};
    shadow.depth_test = VK_COMPARE_OP_LESS;
    shadow.biased = true;
    shadow_ = make_pipeline(device_, shadow);
    shadow.vertex = skinned_vertex.handle();
    make_skinned(shadow, skinned_layout_, skinned_shadow_);
}

void SurfacePipelines::make_skinned(PipelineDesc desc, VkPipelineLayout layout, VkPipeline (&out_pipelines)[2]) const {
    std::vector<VkVertexInputBindingDescription> bindings(desc.bindings.begin(), desc.bindings.end());
    std::vector<VkVertexInputAttributeDescription> attributes(desc.attributes.begin(), desc.attributes.end());
    bindings.push_back(skin_binding);
    attributes.insert(attributes.end(), std::begin(skin_attributes), std::end(skin_attributes));
    for (VkVertexInputAttributeDescription& attribute : attributes)
        if (attribute.location == field_location) attribute.format = VK_FORMAT_R8G8B8A8_UNORM;  // the other colour
    desc.layout = layout;
    desc.bindings = bindings;
    desc.attributes = attributes;
    for (uint32_t skinning = 0; skinning < 2; ++skinning) {
        desc.constants = {&skinning, 1};
        out_pipelines[skinning] = make_pipeline(device_, desc);
    }
}

void SurfacePipelines::swap_pipelines(SurfacePipelines& other) {
    std::swap(shaders_, other.shaders_);
    std::swap(main_, other.main_);
    std::swap(shadow_, other.shadow_);
    std::swap(skinned_shadow_, other.skinned_shadow_);
}

SurfacePipelines::~SurfacePipelines() {
    destroy();
}

void SurfacePipelines::destroy() {
    for (const Main& main : main_)
        for (VkPipeline pipeline : {main.surface, main.border, main.skinned[0], main.skinned[1], main.textured,
                                    main.textured_skinned[0], main.textured_skinned[1]})
            vkDestroyPipeline(device_, pipeline, nullptr);
    for (VkPipeline pipeline : {shadow_, skinned_shadow_[0], skinned_shadow_[1]})
        vkDestroyPipeline(device_, pipeline, nullptr);
    vkDestroyPipelineLayout(device_, textured_layout_, nullptr);
    vkDestroyDescriptorSetLayout(device_, texture_set_layout_, nullptr);
    vkDestroyPipelineLayout(device_, skinned_layout_, nullptr);
    vkDestroyDescriptorSetLayout(device_, joints_layout_, nullptr);
    vkDestroyPipelineLayout(device_, layout_, nullptr);
}

}  // namespace flg::render
