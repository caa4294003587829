// SPDX-License-Identifier: MIT
#include "pipelines.h"

#include <utility>

#include "pipeline_build.h"
#include "shaders/backdrop_frag.h"
#include "shaders/backdrop_frag_stereo.h"
#include "shaders/backdrop_vert.h"
#include "shaders/curve_frag.h"
#include "shaders/curve_frag_stereo.h"
#include "shaders/curve_vert.h"
#include "shaders/curve_vert_stereo.h"

namespace flg::render {
namespace {

constexpr VkVertexInputBindingDescription instance_binding[] = {{0, sizeof(uint32_t), VK_VERTEX_INPUT_RATE_INSTANCE}};
constexpr VkVertexInputAttributeDescription instance_attribute[] = {{0, 0, VK_FORMAT_R32_UINT, 0}};

}  // namespace

Pipelines::Pipelines(const Device& device, const Shaders& shaders, const RenderPasses& passes)
    : device_(device.handle()), shaders_(&shaders), passes_(passes) {
    const VkShaderStageFlags vertex = VK_SHADER_STAGE_VERTEX_BIT, fragment = VK_SHADER_STAGE_FRAGMENT_BIT;
    const VkDescriptorSetLayoutBinding view_bindings[] = {
        {0, VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, 1, vertex | fragment, nullptr},
        {1, VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, 1, fragment, nullptr},
        {2, VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, 1, fragment, nullptr}};
    VkDescriptorSetLayoutBinding curve_bindings[curve_buffers];
    for (uint32_t i = 0; i < curve_buffers; ++i)
        curve_bindings[i] = {i, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, 1, vertex, nullptr};
    try {
        view_layout_ = make_set_layout(device_, view_bindings);
        curves_layout_ = make_set_layout(device_, curve_bindings);
        const VkDescriptorSetLayout sets[] = {view_layout_, curves_layout_};
        layout_ = make_pipeline_layout(device_, sets, sizeof(CurvePush));
        make_main(Eyes::one);
        make_shadow();
    } catch (...) {
        destroy();
        throw;
    }
}

void Pipelines::need_stereo() {
    if (!has_stereo()) make_main(Eyes::both);
}

void Pipelines::make_main(Eyes eyes) {
    const auto shader = [&](const char* file, std::span<const uint32_t> one, std::span<const uint32_t> both) {
        const bool stereo = eyes == Eyes::both;
        const ShaderVariant variant = stereo ? ShaderVariant::stereo : ShaderVariant::plain;
        return ShaderModule(device_, shaders_->of(file, stereo ? both : one, variant));
    };
    const ShaderModule curve_vertex = shader("curve.vert", curve_vert_spv, curve_vert_stereo_spv);
    const ShaderModule curve_fragment = shader("curve.frag", curve_frag_spv, curve_frag_stereo_spv);
    const ShaderModule backdrop_vertex(device_, shaders_->of("backdrop.vert", backdrop_vert_spv));
    const ShaderModule backdrop_fragment = shader("backdrop.frag", backdrop_frag_spv, backdrop_frag_stereo_spv);
    Main& made = main_[static_cast<int>(eyes)];
    PipelineDesc desc;
    desc.layout = layout_;
    desc.pass = passes_.main[static_cast<int>(eyes)];
    desc.samples = passes_.samples;

    uint32_t shape_and_displaced[2] = {};
    PipelineDesc curve = desc;
    curve.bindings = instance_binding;
    curve.attributes = instance_attribute;
    curve.constants = shape_and_displaced;
    curve.vertex = curve_vertex.handle();
    curve.fragment = curve_fragment.handle();
    PipelineDesc closed = curve;
    closed.cull = VK_CULL_MODE_BACK_BIT;
    auto& [shape, displaced] = shape_and_displaced;
    for (displaced = 0; displaced < 2; ++displaced) {
        for (shape = 0; shape < 3; ++shape) made.curve[displaced][shape] = make_pipeline(device_, curve);
        shape = static_cast<uint32_t>(Shape::tube);
        made.closed_tube[displaced] = make_pipeline(device_, closed);
    }

    PipelineDesc backdrop = desc;
    backdrop.vertex = backdrop_vertex.handle();
    backdrop.fragment = backdrop_fragment.handle();
    backdrop.depth_test = VK_COMPARE_OP_EQUAL;  // only where nothing was drawn: depth 0 as cleared
    backdrop.writes_depth = false;
    made.backdrop = make_pipeline(device_, backdrop);
}

void Pipelines::make_shadow() {
    const ShaderModule curve_vertex(device_, shaders_->of("curve.vert", curve_vert_spv));
    uint32_t shape_and_displaced[2] = {};
    PipelineDesc shadow;
    shadow.layout = layout_;
    shadow.bindings = instance_binding;
    shadow.attributes = instance_attribute;
    shadow.constants = shape_and_displaced;
    shadow.vertex = curve_vertex.handle();
    shadow.pass = passes_.shadow;
    shadow.depth_test = VK_COMPARE_OP_LESS;
    shadow.biased = true;
    auto& [shape, displaced] = shape_and_displaced;
    for (displaced = 0; displaced < 2; ++displaced)
        for (shape = 0; shape < 2; ++shape) shadow_[displaced][shape] = make_pipeline(device_, shadow);
}

void Pipelines::swap_pipelines(Pipelines& other) {
    std::swap(shaders_, other.shaders_);
    std::swap(main_, other.main_);
    std::swap(shadow_, other.shadow_);
}

Pipelines::~Pipelines() {
    destroy();
}

void Pipelines::destroy() {
    for (const Main& main : main_) {
        for (const auto& by_shape : main.curve)
            for (VkPipeline pipeline : by_shape) vkDestroyPipeline(device_, pipeline, nullptr);
        for (VkPipeline pipeline : main.closed_tube) vkDestroyPipeline(device_, pipeline, nullptr);
        vkDestroyPipeline(device_, main.backdrop, nullptr);
    }
    for (const auto& by_shape : shadow_)
        for (VkPipeline pipeline : by_shape) vkDestroyPipeline(device_, pipeline, nullptr);
    vkDestroyPipelineLayout(device_, layout_, nullptr);
    vkDestroyDescriptorSetLayout(device_, curves_layout_, nullptr);
    vkDestroyDescriptorSetLayout(device_, view_layout_, nullptr);
}

VkPipeline Pipelines::curve(const CurveLook& look, bool displaced, Eyes eyes) const {
    const Main& main = main_[static_cast<int>(eyes)];
    if (look.shape == Shape::tube && look.caps != Caps::none) return main.closed_tube[displaced];
    return main.curve[displaced][static_cast<int>(look.shape)];
}

}  // namespace flg::render
