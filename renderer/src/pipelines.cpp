// SPDX-License-Identifier: MIT
#include "pipelines.h"

#include <span>

#include "shaders/backdrop_frag.h"
#include "shaders/backdrop_vert.h"
#include "shaders/curve_frag.h"
#include "shaders/curve_vert.h"

namespace flg::render {
namespace {

// Against acne in the shadow map, in units of its depth resolution and of the slope.
constexpr float shadow_bias = 2.0f;
constexpr float shadow_slope_bias = 2.0f;

class ShaderModule {
public:
    ShaderModule(VkDevice device, std::span<const uint32_t> code) : device_(device) {
        VkShaderModuleCreateInfo info{VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO};
        info.codeSize = code.size_bytes();
        info.pCode = code.data();
        check(vkCreateShaderModule(device, &info, nullptr, &module_), "take a shader");
    }
    ~ShaderModule() { vkDestroyShaderModule(device_, module_, nullptr); }
    ShaderModule(const ShaderModule&) = delete;
    ShaderModule& operator=(const ShaderModule&) = delete;
    VkShaderModule handle() const { return module_; }

private:
    VkDevice device_;
    VkShaderModule module_ = VK_NULL_HANDLE;
};

struct PipelineDesc {
    VkShaderModule vertex = VK_NULL_HANDLE;
    VkShaderModule fragment = VK_NULL_HANDLE;  // null: depth only
    uint32_t shape = 0;
    VkBool32 displaced = VK_FALSE;
    bool has_instances = false;
    VkCullModeFlags cull = VK_CULL_MODE_NONE;
    VkCompareOp depth_test = VK_COMPARE_OP_GREATER;
    bool writes_depth = true;
    bool biased = false;
    VkSampleCountFlagBits samples = VK_SAMPLE_COUNT_1_BIT;
    VkRenderPass pass = VK_NULL_HANDLE;
    VkPipelineLayout layout = VK_NULL_HANDLE;
};

VkPipeline make_pipeline(VkDevice device, const PipelineDesc& desc) {
    const uint32_t values[] = {desc.shape, desc.displaced};
    const VkSpecializationMapEntry entries[] = {{0, 0, sizeof values[0]}, {1, sizeof values[0], sizeof values[1]}};
    const VkSpecializationInfo constants{2, entries, sizeof values, values};
    VkPipelineShaderStageCreateInfo stages[2]{};
    for (auto& stage : stages) {
        stage.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO;
        stage.pName = "main";
        stage.pSpecializationInfo = desc.has_instances ? &constants : nullptr;
    }
    stages[0].stage = VK_SHADER_STAGE_VERTEX_BIT;
    stages[0].module = desc.vertex;
    stages[1].stage = VK_SHADER_STAGE_FRAGMENT_BIT;
    stages[1].module = desc.fragment;

    const VkVertexInputBindingDescription binding{0, sizeof(uint32_t), VK_VERTEX_INPUT_RATE_INSTANCE};
    const VkVertexInputAttributeDescription attribute{0, 0, VK_FORMAT_R32_UINT, 0};
    VkPipelineVertexInputStateCreateInfo input{VK_STRUCTURE_TYPE_PIPELINE_VERTEX_INPUT_STATE_CREATE_INFO};
    if (desc.has_instances) {
        input.vertexBindingDescriptionCount = 1;
        input.pVertexBindingDescriptions = &binding;
        input.vertexAttributeDescriptionCount = 1;
        input.pVertexAttributeDescriptions = &attribute;
    }
    VkPipelineInputAssemblyStateCreateInfo assembly{VK_STRUCTURE_TYPE_PIPELINE_INPUT_ASSEMBLY_STATE_CREATE_INFO};
    assembly.topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST;
    VkPipelineViewportStateCreateInfo viewport{VK_STRUCTURE_TYPE_PIPELINE_VIEWPORT_STATE_CREATE_INFO};
    viewport.viewportCount = viewport.scissorCount = 1;
    VkPipelineRasterizationStateCreateInfo raster{VK_STRUCTURE_TYPE_PIPELINE_RASTERIZATION_STATE_CREATE_INFO};
    raster.polygonMode = VK_POLYGON_MODE_FILL;
    raster.cullMode = desc.cull;
    raster.frontFace = VK_FRONT_FACE_COUNTER_CLOCKWISE;
    raster.lineWidth = 1.0f;
    raster.depthBiasEnable = desc.biased;
    raster.depthBiasConstantFactor = shadow_bias;
    raster.depthBiasSlopeFactor = shadow_slope_bias;
    VkPipelineMultisampleStateCreateInfo samples{VK_STRUCTURE_TYPE_PIPELINE_MULTISAMPLE_STATE_CREATE_INFO};
    samples.rasterizationSamples = desc.samples;
    VkPipelineDepthStencilStateCreateInfo depth{VK_STRUCTURE_TYPE_PIPELINE_DEPTH_STENCIL_STATE_CREATE_INFO};
    depth.depthTestEnable = VK_TRUE;
    depth.depthWriteEnable = desc.writes_depth;
    depth.depthCompareOp = desc.depth_test;
    VkPipelineColorBlendAttachmentState opaque{};
    opaque.colorWriteMask =
        VK_COLOR_COMPONENT_R_BIT | VK_COLOR_COMPONENT_G_BIT | VK_COLOR_COMPONENT_B_BIT | VK_COLOR_COMPONENT_A_BIT;
    VkPipelineColorBlendStateCreateInfo blend{VK_STRUCTURE_TYPE_PIPELINE_COLOR_BLEND_STATE_CREATE_INFO};
    blend.attachmentCount = desc.fragment ? 1 : 0;
    blend.pAttachments = &opaque;
    const VkDynamicState dynamic_states[] = {VK_DYNAMIC_STATE_VIEWPORT, VK_DYNAMIC_STATE_SCISSOR};
    VkPipelineDynamicStateCreateInfo dynamic{VK_STRUCTURE_TYPE_PIPELINE_DYNAMIC_STATE_CREATE_INFO};
    dynamic.dynamicStateCount = 2;
    dynamic.pDynamicStates = dynamic_states;

    VkGraphicsPipelineCreateInfo info{VK_STRUCTURE_TYPE_GRAPHICS_PIPELINE_CREATE_INFO};
    info.stageCount = desc.fragment ? 2 : 1;
    info.pStages = stages;
    info.pVertexInputState = &input;
    info.pInputAssemblyState = &assembly;
    info.pViewportState = &viewport;
    info.pRasterizationState = &raster;
    info.pMultisampleState = &samples;
    info.pDepthStencilState = &depth;
    info.pColorBlendState = &blend;
    info.pDynamicState = &dynamic;
    info.layout = desc.layout;
    info.renderPass = desc.pass;
    VkPipeline pipeline = VK_NULL_HANDLE;
    check(vkCreateGraphicsPipelines(device, VK_NULL_HANDLE, 1, &info, nullptr, &pipeline), "make a pipeline");
    return pipeline;
}

VkDescriptorSetLayout make_set_layout(VkDevice device, std::span<const VkDescriptorSetLayoutBinding> bindings) {
    VkDescriptorSetLayoutCreateInfo info{VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO};
    info.bindingCount = static_cast<uint32_t>(bindings.size());
    info.pBindings = bindings.data();
    VkDescriptorSetLayout layout;
    check(vkCreateDescriptorSetLayout(device, &info, nullptr, &layout), "make a descriptor layout");
    return layout;
}

}  // namespace

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
    try {
        view_layout_ = make_set_layout(device_, view_bindings);
        curves_layout_ = make_set_layout(device_, curve_bindings);
        const VkDescriptorSetLayout sets[] = {view_layout_, curves_layout_};
        const VkPushConstantRange push{vertex | fragment, 0, sizeof(CurvePush)};
        VkPipelineLayoutCreateInfo info{VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO};
        info.setLayoutCount = 2;
        info.pSetLayouts = sets;
        info.pushConstantRangeCount = 1;
        info.pPushConstantRanges = &push;
        check(vkCreatePipelineLayout(device_, &info, nullptr, &layout_), "make a pipeline layout");

        const ShaderModule curve_vertex(device_, curve_vert_spv), curve_fragment(device_, curve_frag_spv);
        const ShaderModule backdrop_vertex(device_, backdrop_vert_spv), backdrop_fragment(device_, backdrop_frag_spv);
        PipelineDesc desc;
        desc.layout = layout_;
        desc.pass = main_pass;
        desc.samples = samples;
        desc.has_instances = true;
        desc.vertex = curve_vertex.handle();
        desc.fragment = curve_fragment.handle();
        PipelineDesc closed = desc;
        closed.shape = static_cast<uint32_t>(Shape::tube);
        closed.cull = VK_CULL_MODE_BACK_BIT;

        PipelineDesc shadow = desc;
        shadow.fragment = VK_NULL_HANDLE;
        shadow.pass = shadow_pass;
        shadow.samples = VK_SAMPLE_COUNT_1_BIT;
        shadow.depth_test = VK_COMPARE_OP_LESS;
        shadow.biased = true;

        for (const VkBool32 displaced : {VK_FALSE, VK_TRUE}) {
            desc.displaced = closed.displaced = shadow.displaced = displaced;
            for (desc.shape = 0; desc.shape < 3; ++desc.shape)
                curve_[displaced][desc.shape] = make_pipeline(device_, desc);
            closed_tube_[displaced] = make_pipeline(device_, closed);
            for (shadow.shape = 0; shadow.shape < 2; ++shadow.shape)
                shadow_[displaced][shadow.shape] = make_pipeline(device_, shadow);
        }

        PipelineDesc backdrop = desc;
        backdrop.has_instances = false;
        backdrop.vertex = backdrop_vertex.handle();
        backdrop.fragment = backdrop_fragment.handle();
        backdrop.depth_test = VK_COMPARE_OP_EQUAL;  // only where nothing was drawn: depth 0 as cleared
        backdrop.writes_depth = false;
        backdrop_ = make_pipeline(device_, backdrop);
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
