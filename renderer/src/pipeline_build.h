// SPDX-License-Identifier: MIT
// What all graphics pipelines have in common, and in what they differ.
#pragma once

#include <span>

#include "device.h"

namespace flg::render {

class ShaderModule {
public:
    ShaderModule(VkDevice device, std::span<const uint32_t> code);
    ~ShaderModule() { vkDestroyShaderModule(device_, module_, nullptr); }
    ShaderModule(const ShaderModule&) = delete;
    ShaderModule& operator=(const ShaderModule&) = delete;
    VkShaderModule handle() const { return module_; }

private:
    VkDevice device_;
    VkShaderModule module_ = VK_NULL_HANDLE;
};

enum class Blending {
    none,
    by_alpha,    // over what is there, straight alpha
    by_constant  // the mean, this one by the blend constants, which are dynamic
};

struct PipelineDesc {
    VkShaderModule vertex = VK_NULL_HANDLE;
    VkShaderModule fragment = VK_NULL_HANDLE;  // null: depth only
    std::span<const uint32_t> constants;       // of both shaders, by constant_id from 0
    std::span<const VkVertexInputBindingDescription> bindings;
    std::span<const VkVertexInputAttributeDescription> attributes;
    VkCullModeFlags cull = VK_CULL_MODE_NONE;
    VkCompareOp depth_test = VK_COMPARE_OP_GREATER;
    bool writes_depth = true;
    bool biased = false;
    Blending blending = Blending::none;
    VkSampleCountFlagBits samples = VK_SAMPLE_COUNT_1_BIT;
    VkRenderPass pass = VK_NULL_HANDLE;
    VkPipelineLayout layout = VK_NULL_HANDLE;
};

VkPipeline make_pipeline(VkDevice device, const PipelineDesc& desc);

VkDescriptorSetLayout make_set_layout(VkDevice device, std::span<const VkDescriptorSetLayoutBinding> bindings);

// One range of push constants, for both shaders.
VkPipelineLayout make_pipeline_layout(VkDevice device, std::span<const VkDescriptorSetLayout> sets,
                                      uint32_t push_bytes);

}  // namespace flg::render
