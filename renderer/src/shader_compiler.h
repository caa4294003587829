// SPDX-License-Identifier: MIT
// Shaders compiled while a program runs. Defined by the library filigree_shader_compiler alone, since glslang is large:
// programs that are not linked with it see a null here and know only the shaders they were built with.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace flg::render {

// SPIR-V of the file `name` in `folder`, whose includes are found there too; `macros` are defined. Throws Error with
// what the compiler says: file, line, reason.
[[gnu::weak]] std::vector<uint32_t> compile_shader(const std::string& folder, const std::string& name,
                                                   std::span<const std::string> macros);

}  // namespace flg::render
