// SPDX-License-Identifier: MIT
// The pipelines of surfaces and of the lines between their regions.
#pragma once

#include <glm/glm.hpp>

#include "device.h"
#include "eyes.h"
#include "filigree/filigree_model.h"
#include "pipeline_build.h"
#include "shaders.h"

namespace flg::render {

// Mirrors the push constants of shaders/surface_draw.glsl.
struct SurfacePush {
    glm::vec3 isoline_color;
    float isoline_half_width_px;
    float field_low;
    float colors_per_unit;    // 1 / what the map spans
    float isolines_per_unit;  // 0 = none
    uint32_t flags;
    glm::vec4 turn;        // Placement
    glm::vec4 at;          // w: scale
    uint32_t first_joint;  // of the joints' vectors, of surfaces that follow some

    static constexpr uint32_t shows_field = 1;
    static constexpr uint32_t is_flat = 2;
};

constexpr uint32_t texture_set = 2, textured_binding = 3;
constexpr uint32_t border_vertices = 12;  // of a line: four triangles, mirrors shaders/border.vert

class SurfacePipelines {
public:
    // Those for one eye; those for both when they are first needed.
    SurfacePipelines(const Device& device, const Shaders& shaders, const RenderPasses& passes,
                     VkDescriptorSetLayout view_layout);
    ~SurfacePipelines();
    SurfacePipelines(const SurfacePipelines&) = delete;
    SurfacePipelines& operator=(const SurfacePipelines&) = delete;

    // Before anything is drawn for both eyes.
    void need_stereo();
    // With those of others for the same device and passes, and their shaders.
    void swap_pipelines(SurfacePipelines& other);

    VkPipelineLayout layout() const { return layout_; }               // set 0: the view
    VkPipeline surface(Eyes eyes) const { return of(eyes).surface; }  // vertex buffers: positions, SurfaceVertex
    VkPipeline shadow() const { return shadow_; }                     // positions
    VkPipeline border(Eyes eyes) const { return of(eyes).border; }    // an instance each: BorderEdge

    // Of surfaces that follow joints: set 1 is their buffer; a third vertex buffer: SkinVertex.
    VkDescriptorSetLayout joints_layout() const { return joints_layout_; }
    VkPipelineLayout skinned_layout() const { return skinned_layout_; }
    VkPipeline skinned(FlgSkinning skinning, Eyes eyes) const { return of(eyes).skinned[skinning]; }
    VkPipeline skinned_shadow(FlgSkinning skinning) const { return skinned_shadow_[skinning]; }

    // Of surfaces with textures, skins or not: set 2 is one of them; a fourth vertex buffer: texture coordinates.
    VkDescriptorSetLayout texture_set_layout() const { return texture_set_layout_; }
    VkPipelineLayout textured_layout() const { return textured_layout_; }
    VkPipeline textured(Eyes eyes) const { return of(eyes).textured; }
    VkPipeline textured_skinned(FlgSkinning skinning, Eyes eyes) const { return of(eyes).textured_skinned[skinning]; }

private:
    // Of a main pass.
    struct Main {
        VkPipeline surface = VK_NULL_HANDLE;
        VkPipeline border = VK_NULL_HANDLE;
        VkPipeline skinned[2] = {};  // by FlgSkinning
        VkPipeline textured = VK_NULL_HANDLE;
        VkPipeline textured_skinned[2] = {};
    };
    const Main& of(Eyes eyes) const { return main_[static_cast<int>(eyes)]; }
    void make_layouts(VkDescriptorSetLayout view_layout);
    void make_main(Eyes eyes);
    void make_textured(Eyes eyes, PipelineDesc desc);
    void make_shadows();
    void make_skinned(PipelineDesc desc, VkPipelineLayout layout, VkPipeline (&out_pipelines)[2]) const;
    void destroy();

    VkDevice device_;
    const Shaders* shaders_;
    RenderPasses passes_;
    VkPipelineLayout layout_ = VK_NULL_HANDLE;
    Main main_[2];  // by Eyes
    VkPipeline shadow_ = VK_NULL_HANDLE;
    VkDescriptorSetLayout joints_layout_ = VK_NULL_HANDLE;
    VkPipelineLayout skinned_layout_ = VK_NULL_HANDLE;
    VkDescriptorSetLayout texture_set_layout_ = VK_NULL_HANDLE;
    VkPipelineLayout textured_layout_ = VK_NULL_HANDLE;
    VkPipeline skinned_shadow_[2] = {};  // by FlgSkinning
};

}  // namespace flg::render
