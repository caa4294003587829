// SPDX-License-Identifier: MIT
// Where shaders come from: out of the program, or compiled from a folder.
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <vector>

namespace flg::render {

enum class ShaderVariant { plain, stereo, multisampled, textured, textured_stereo };

class Shaders {
public:
    // Empty: those that the program was built with. Throws Error for a program that can't compile any.
    explicit Shaders(std::string folder);

    // SPIR-V of a file of shaders/, `built_in` if there is no folder. Throws Error with what the compiler says. Stays
    // as it is from the first time on.
    std::span<const uint32_t> of(const std::string& file, std::span<const uint32_t> built_in,
                                 ShaderVariant variant = ShaderVariant::plain) const;

    // Whether all that both were asked for is the same.
    bool operator==(const Shaders& other) const { return compiled_ == other.compiled_; }

private:
    std::string folder_;
    mutable std::map<std::string, std::vector<uint32_t>> compiled_;
};

}  // namespace flg::render
