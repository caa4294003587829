// SPDX-License-Identifier: MIT
#include "shaders.h"

#include "shader_compiler.h"
#include "vk.h"

namespace flg::render {

Shaders::Shaders(std::string folder) : folder_(std::move(folder)) {
    if (!folder_.empty() && !compile_shader)
        fail("options.shader_folder is \"%s\", but this program is not linked with filigree_shader_compiler.",
             folder_.c_str());
}

std::span<const uint32_t> Shaders::of(const std::string& file, std::span<const uint32_t> built_in,
                                      ShaderVariant variant) const {
    if (folder_.empty()) return built_in;
    std::vector<std::string> macros;
    if (variant == ShaderVariant::multisampled) macros.emplace_back("MULTISAMPLED");
    if (variant == ShaderVariant::textured || variant == ShaderVariant::textured_stereo)
        macros.emplace_back("TEXTURED");
    if (variant == ShaderVariant::stereo || variant == ShaderVariant::textured_stereo) macros.emplace_back("STEREO");
    std::string key = file;
    for (const std::string& macro : macros) key += " " + macro;
    const auto found = compiled_.find(key);
    if (found != compiled_.end()) return found->second;
    return compiled_[key] = compile_shader(folder_, file, macros);
}

}  // namespace flg::render
