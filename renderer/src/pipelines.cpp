// SPDX-License-Identifier: MIT
#include "pipelines.h"

#include "pipeline_build.h"
#include "shaders/backdrop_frag.h"
#include "shaders/backdrop_vert.h"
#include "shaders/curve_frag.h"
#include "shaders/curve_vert.h"

namespace flg::render {

Pipelines::Pipelines(const Device& device, VkRenderPass main_pass, VkSampleCountFlagBits samples,
                     VkRenderPass shadow_pass)
    : device_(device.handle()) {
    const VkShaderStageFlags vertex = VK_SHADER_STAGE_VERTEX_BIT, fragment = VK_SHADER_STAGE_FRAGMENT_BIT;
    const VkDescriptorSetLayoutBinding view_bindings[] = {
        {0, VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, 1, vertex | fragment, nullptr},
        {1, VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, 1, fragment, nullptr}};
    VkDescriptorSetLayoutBinding curve_bindings[curve_buffers];
    for (uint32_t i = 0; i < curve_buffers; ++i)
        curve_bindings[i] = {i, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, 1, vertex, nullptr};
    const VkVertexInputBindingDescription instances[] = {{0, sizeof(uint32_t), VK_VERTEX_INPUT_RATE_INSTANCE}};
    const VkVertexInputAttributeDescription instance[] = {{0, 0, VK_FORMAT_R32_UINT, 0}};
    try {
        view_layout_ = make_set_layout(device_, view_bindings);
        curves_layout_ = make_set_layout(device_, curve_bindings);
        const VkDescriptorSetLayout sets[] = {view_layout_, curves_layout_};
        layout_ = make_pipeline_layout(device_, sets, sizeof(CurvePush));

        const ShaderModule curve_vertex(device_, curve_vert_spv), curve_fragment(device_, curve_frag_spv);
        const ShaderModule backdrop_vertex(device_, backdrop_vert_spv), backdrop_fragment(device_, backdrop_frag_spv);
        PipelineDesc desc;
        desc.layout = layout_;
        desc.pass = main_pass;
        desc.samples = samples;

        PipelineDesc backdrop = desc;
        backdrop.vertex = backdrop_vertex.handle();
        backdrop.fragment = backdrop_fragment.handle();
        backdrop.depth_test = VK_COMPARE_OP_EQUAL;  // only where nothing was drawn: depth 0 as cleared
        backdrop.writes_depth = false;
        backdrop_ = make_pipeline(device_, backdrop);

        uint32_t shape_and_displaced[2] = {};
        desc.bindings = instances;
        desc.attributes = instance;
        desc.constants = shape_and_displaced;
        desc.vertex = curve_vertex.handle();
        desc.fragment = curve_fragment.handle();
        PipelineDesc closed = desc;
        closed.cull = VK_CULL_MODE_BACK_BIT;

        PipelineDesc shadow = desc;
        shadow.fragment = VK_NULL_HANDLE;
        shadow.pass = shadow_pass;
        shadow.samples = VK_SAMPLE_COUNT_1_BIT;
        shadow.depth_test = VK_COMPARE_OP_LESS;
        shadow.biased = true;

        auto& [shape, displaced] = shape_and_displaced;
        for (displaced = 0; displaced < 2; ++displaced) {
            for (shape = 0; shape < 3; ++shape) curve_[displaced][shape] = make_pipeline(device_, desc);
            for (shape = 0; shape < 2; ++shape) shadow_[displaced][shape] = make_pipeline(device_, shadow);
            shape = static_cast<uint32_t>(Shape::tube);
            closed_tube_[displaced] = make_pipeline(device_, closed);
        }
    } catch (...) {
        destroy();
        throw;
    }
}

Pipelines::~Pipelines() {
    destroy();
}

void Pipelines::destroy() {
    for (int displaced = 0; displaced < 2; ++displaced) {
        for (VkPipeline pipeline : curve_[displaced]) vkDestroyPipeline(device_, pipeline, nullptr);
        for (VkPipeline pipeline : shadow_[displaced]) vkDestroyPipeline(device_, pipeline, nullptr);
        vkDestroyPipeline(device_, closed_tube_[displaced], nullptr);
    }
    vkDestroyPipeline(device_, backdrop_, nullptr);
    vkDestroyPipelineLayout(device_, layout_, nullptr);
    vkDestroyDescriptorSetLayout(device_, curves_layout_, nullptr);
    vkDestroyDescriptorSetLayout(device_, view_layout_, nullptr);
}

VkPipeline Pipelines::curve(const CurveLook& look, bool displaced) const {
    if (look.shape == Shape::tube && look.caps != Caps::none) return closed_tube_[displaced];
    return curve_[displaced][static_cast<int>(look.shape)];
}

}  // namespace flg::render
