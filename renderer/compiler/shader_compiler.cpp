// SPDX-License-Identifier: MIT
#include "shader_compiler.h"

#include <glslang/Public/ResourceLimits.h>
#include <glslang/Public/ShaderLang.h>
#include <glslang/SPIRV/GlslangToSpv.h>

#include <fstream>
#include <iterator>
#include <memory>

#include "filigree_renderer/error.h"

namespace flg::render {
namespace {

std::string read(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    std::string text(std::istreambuf_iterator<char>(file), {});
    if (!file.good() && !file.eof()) throw Error("The shader \"" + path + "\" can't be read.");
    return text;
}

// One to a process, until it ends: starting is what takes longest.
struct Glslang {
    Glslang() { glslang::InitializeProcess(); }
    ~Glslang() { glslang::FinalizeProcess(); }
};

class FolderIncluder : public glslang::TShader::Includer {
public:
    explicit FolderIncluder(const std::string& folder) : folder_(folder) {}
    IncludeResult* includeLocal(const char* name, const char*, size_t) override {
        auto text = std::make_unique<std::string>();
        try {
            *text = read(folder_ + "/" + name);
        } catch (const Error&) {
            return nullptr;  // the compiler says so, and where
        }
        const char* data = text->data();
        const size_t size = text->size();
        return new IncludeResult(name, data, size, text.release());
    }
    void releaseInclude(IncludeResult* result) override {
        if (!result) return;
        delete static_cast<std::string*>(result->userData);
        delete result;
    }

private:
    const std::string& folder_;
};

}  // namespace

std::vector<uint32_t> compile_shader(const std::string& folder, const std::string& name,
                                     std::span<const std::string> macros) {
    static const Glslang glslang;
    const std::string text = read(folder + "/" + name);
    const char* const texts[] = {text.c_str()};
    const int lengths[] = {static_cast<int>(text.size())};
    const char* const names[] = {name.c_str()};
    std::string preamble = "#extension GL_GOOGLE_include_directive : require\n";
    for (const std::string& macro : macros) preamble += "#define " + macro + "\n";

    const EShLanguage stage = name.ends_with(".frag") ? EShLangFragment : EShLangVertex;
    const EShMessages messages = static_cast<EShMessages>(EShMsgSpvRules | EShMsgVulkanRules);
    glslang::TShader shader(stage);
    shader.setStringsWithLengthsAndNames(texts, lengths, names, 1);
    shader.setPreamble(preamble.c_str());
    shader.setEnvInput(glslang::EShSourceGlsl, stage, glslang::EShClientVulkan, 100);
    shader.setEnvClient(glslang::EShClientVulkan, glslang::EShTargetVulkan_1_1);
    shader.setEnvTarget(glslang::EShTargetSpv, glslang::EShTargetSpv_1_3);
    FolderIncluder includer(folder);
    constexpr int version = 450;
    if (!shader.parse(GetDefaultResources(), version, false, messages, includer))
        throw Error("The shader \"" + name + "\" does not compile: " + shader.getInfoLog());
    glslang::TProgram program;
    program.addShader(&shader);
    if (!program.link(messages)) throw Error("The shader \"" + name + "\" does not link: " + program.getInfoLog());
    std::vector<uint32_t> code;
    glslang::GlslangToSpv(*program.getIntermediate(stage), code);
    return code;
}

}  // namespace flg::render
