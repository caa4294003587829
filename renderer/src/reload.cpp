// SPDX-License-Identifier: MIT
// Shaders that have been edited while the renderer runs.
#include "renderer_state.h"

namespace flg::render {

bool Renderer::reload_shaders() {
    State& s = *state_;
    auto shaders = std::make_unique<Shaders>(s.options.shader_folder);
    Pipelines pipelines(s.device, *shaders, s.render_passes());
    SurfacePipelines surface_pipelines(s.device, *shaders, s.render_passes(), pipelines.view_layout());
    FinishPass finish_pass(s.device, *shaders, s.pipelines.view_layout(), s.samples);
    UiPass ui_pass(s.device, *shaders, s.texture_sampler.layout());
    if (s.pipelines.has_stereo()) {
        pipelines.need_stereo();
        surface_pipelines.need_stereo();
    }
    if (*shaders == *s.shaders) return false;
    for (const auto& slot : s.slots) slot->wait();
    s.pipelines.swap_pipelines(pipelines);
    s.surface_pipelines.swap_pipelines(surface_pipelines);
    s.finish_pass.swap_pipelines(finish_pass);
    s.ui_pass.swap_pipelines(ui_pass);
    s.shaders = std::move(shaders);
    s.scene_changed();
    return true;
}

}  // namespace flg::render
