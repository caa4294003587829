// SPDX-License-Identifier: MIT
#include "shell/gui.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <span>

#include "shell/frame_budget.h"

namespace flg::studio {
namespace {

constexpr float kFontUnits = 15.0f;
constexpr float kDoubleClick_s = 0.3f, kSlowDoubleClick_s = 0.6f;
static_assert(sizeof(ImDrawVert) == sizeof(render::UiVertex) && sizeof(ImDrawIdx) == sizeof(uint16_t));

ImVec4 rgb(int hex, float alpha = 1.0f) {
    return {static_cast<float>(hex >> 16 & 255) / 255.0f, static_cast<float>(hex >> 8 & 255) / 255.0f,
            static_cast<float>(hex & 255) / 255.0f, alpha};
}

// Dark and quiet, so that what is made has the colours; what is chosen is amber.
void set_look(float scale) {
    ImGuiStyle& style = ImGui::GetStyle();
    ImGui::StyleColorsDark(&style);
    style.WindowRounding = 0.0f;
    style.PopupRounding = style.FrameRounding = style.GrabRounding = 4.0f;
    style.ScrollbarRounding = 6.0f;
    style.WindowBorderSize = 0.0f;
    style.PopupBorderSize = 1.0f;
    style.WindowPadding = {10.0f, 8.0f};
    style.FramePadding = {8.0f, 4.0f};
    style.ItemSpacing = {7.0f, 5.0f};
    style.ScrollbarSize = 11.0f;
    style.GrabMinSize = 12.0f;
    style.IndentSpacing = 15.0f;
    const std::pair<ImGuiCol, ImVec4> colors[] = {
        {ImGuiCol_Text, rgb(0xE6E2DC)},
        {ImGuiCol_TextDisabled, rgb(0x9A958D)},
        {ImGuiCol_WindowBg, rgb(0x211F1D)},
        {ImGuiCol_PopupBg, rgb(0x2A2725, 0.98f)},
        {ImGuiCol_MenuBarBg, rgb(0x191816)},
        {ImGuiCol_Border, rgb(0x45413C)},
        {ImGuiCol_FrameBg, rgb(0x35312D)},
        {ImGuiCol_FrameBgHovered, rgb(0x433E38)},
        {ImGuiCol_FrameBgActive, rgb(0x4C463F)},
        {ImGuiCol_Button, rgb(0x3B3631)},
        {ImGuiCol_ButtonHovered, rgb(0x544C43)},
        {ImGuiCol_ButtonActive, rgb(0xA8692A)},
        {ImGuiCol_Header, rgb(0x5A4327)},
        {ImGuiCol_HeaderHovered, rgb(0x4A443D)},
        {ImGuiCol_HeaderActive, rgb(0xA8692A)},
        {ImGuiCol_SliderGrab, rgb(0xD99A4E)},
        {ImGuiCol_SliderGrabActive, rgb(0xF2B666)},
        {ImGuiCol_CheckMark, rgb(0xF2B666)},
        {ImGuiCol_Separator, rgb(0x45413C)},
        {ImGuiCol_PlotHistogram, rgb(0xC0813B)},
        {ImGuiCol_PlotLines, rgb(0xF2B666)},
        {ImGuiCol_TitleBgActive, rgb(0x2E2A27)},
        {ImGuiCol_TitleBg, rgb(0x2E2A27)},
        {ImGuiCol_ModalWindowDimBg, rgb(0x000000, 0.45f)},
    };
    for (const auto& [which, color] : colors) style.Colors[which] = color;
    style.ScaleAllSizes(scale);
}

// Fowler, Noll and Vo's hash, by words.
constexpr uint64_t kBasis = 0xcbf29ce484222325u;
uint64_t with(uint64_t hash, uint64_t word) {
    return (hash ^ word) * 0x100000001b3u;
}
template <class T>
uint64_t with(uint64_t hash, const ImVector<T>& values) {
    const auto bytes = std::as_bytes(std::span(values.Data, static_cast<size_t>(values.Size)));
    uint64_t word = 0;
    for (size_t i = 0; i < bytes.size(); i += sizeof word) {
        word = 0;
        std::memcpy(&word, bytes.data() + i, std::min(sizeof word, bytes.size() - i));
        hash = with(hash, word);
    }
    return with(hash, bytes.size());
}

void map_keys(ImGuiIO& io) {
    const std::pair<ImGuiKey, int> keys[] = {
        {ImGuiKey_Tab, GLFW_KEY_TAB},
        {ImGuiKey_LeftArrow, GLFW_KEY_LEFT},
        {ImGuiKey_RightArrow, GLFW_KEY_RIGHT},
        {ImGuiKey_UpArrow, GLFW_KEY_UP},
        {ImGuiKey_DownArrow, GLFW_KEY_DOWN},
        {ImGuiKey_PageUp, GLFW_KEY_PAGE_UP},
        {ImGuiKey_PageDown, GLFW_KEY_PAGE_DOWN},
        {ImGuiKey_Home, GLFW_KEY_HOME},
        {ImGuiKey_End, GLFW_KEY_END},
        {ImGuiKey_Insert, GLFW_KEY_INSERT},
        {ImGuiKey_Delete, GLFW_KEY_DELETE},
        {ImGuiKey_Backspace, GLFW_KEY_BACKSPACE},
        {ImGuiKey_Space, GLFW_KEY_SPACE},
        {ImGuiKey_Enter, GLFW_KEY_ENTER},
        {ImGuiKey_Escape, GLFW_KEY_ESCAPE},
        {ImGuiKey_KeyPadEnter, GLFW_KEY_KP_ENTER},
        {ImGuiKey_A, GLFW_KEY_A},
        {ImGuiKey_C, GLFW_KEY_C},
        {ImGuiKey_V, GLFW_KEY_V},
        {ImGuiKey_X, GLFW_KEY_X},
        {ImGuiKey_Y, GLFW_KEY_Y},
        {ImGuiKey_Z, GLFW_KEY_Z},
    };
    for (const auto& [key, code] : keys) io.KeyMap[key] = code;
}

}  // namespace

Gui::Gui(render::Renderer& renderer, float scale) : renderer_(renderer), context_(ImGui::CreateContext()) {
    ImGui::SetCurrentContext(context_);
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;
    io.BackendFlags |= ImGuiBackendFlags_RendererHasVtxOffset;
    io.ConfigWindowsMoveFromTitleBarOnly = true;
    io.ConfigInputTextCursorBlink = false;  // nothing moves where nothing happens
    map_keys(io);
    set_look(scale);
    // Debian's fonts-dejavu-core; elsewhere ImGui's own, which is plain but complete for our texts.
    if (std::filesystem::exists(FLG_STUDIO_FONT)) {
        io.Fonts->AddFontFromFileTTF(FLG_STUDIO_FONT, std::round(kFontUnits * scale));
    } else {
        ImFontConfig config;
        config.SizePixels = std::round(13.0f * scale);
        io.Fonts->AddFontDefault(&config);
    }
    upload_font();
}

Gui::~Gui() {
    ImGui::DestroyContext(context_);
}

void Gui::upload_font() {
    unsigned char* pixels = nullptr;
    int width = 0, height = 0;
    ImGuiIO& io = ImGui::GetIO();
    io.Fonts->GetTexDataAsRGBA32(&pixels, &width, &height);
    render::Image image{static_cast<uint32_t>(width), static_cast<uint32_t>(height), {}};
    image.pixels.assign(pixels, pixels + 4 * size_t{image.width} * image.height);
    font_ = renderer_.upload(image);
    io.Fonts->SetTexID(reinterpret_cast<ImTextureID>(static_cast<uintptr_t>(font_.value)));
}

void Gui::device_lost() {
    upload_font();
}

void Gui::begin(const Input& input, uint32_t width, uint32_t height, float seconds) {
    ImGui::SetCurrentContext(context_);
    ImGuiIO& io = ImGui::GetIO();
    io.DisplaySize = {static_cast<float>(width), static_cast<float>(height)};
    io.DeltaTime = std::max(seconds, 1e-4f);
    // A click takes two frames at least, however slow they are; but a frame may also have slept.
    io.MouseDoubleClickTime = std::clamp(3.0f * io.DeltaTime, kDoubleClick_s, kSlowDoubleClick_s);
    io.MousePos = input.px.x < 0.0f ? ImVec2(-FLT_MAX, -FLT_MAX) : ImVec2(input.px.x, input.px.y);
    for (int b = 0; b < kButtons; ++b) io.MouseDown[b] = input.down[b] || input.pressed[b];
    io.MouseWheelH = input.scrolled.x;
    io.MouseWheel = input.scrolled.y;
    io.KeyCtrl = input.control();
    io.KeyShift = input.shift();
    io.KeyAlt = input.alt();
    std::copy(std::begin(input.keys), std::end(input.keys), std::begin(io.KeysDown));
    for (const char32_t character : input.text) io.AddInputCharacter(character);
    ImGui::NewFrame();
}

render::UiFrame Gui::end() {
    ImGui::Render();
    const ImDrawData& data = *ImGui::GetDrawData();
    vertices_.clear();
    indices_.clear();
    commands_.clear();
    fingerprint_ = kBasis;
    const glm::vec2 size(data.DisplaySize.x, data.DisplaySize.y);
    for (int l = 0; l < data.CmdListsCount; ++l) {
        const ImDrawList& list = *data.CmdLists[l];
        if (list._OwnerName == nullptr || std::strcmp(list._OwnerName, FrameBudget::kWindow) != 0)
            fingerprint_ = with(with(fingerprint_, list.VtxBuffer), list.IdxBuffer);
        const auto first_vertex = static_cast<uint32_t>(vertices_.size());
        const auto first_index = static_cast<uint32_t>(indices_.size());
        vertices_.resize(vertices_.size() + static_cast<size_t>(list.VtxBuffer.Size));
        if (list.VtxBuffer.Size > 0)
            std::memcpy(vertices_.data() + first_vertex, list.VtxBuffer.Data,
                        static_cast<size_t>(list.VtxBuffer.Size) * sizeof(ImDrawVert));
        indices_.insert(indices_.end(), list.IdxBuffer.begin(), list.IdxBuffer.end());
        for (const ImDrawCmd& command : list.CmdBuffer) {
            const glm::vec2 low =
                glm::clamp(glm::floor(glm::vec2(command.ClipRect.x, command.ClipRect.y)), glm::vec2(0.0f), size);
            const glm::vec2 high =
                glm::clamp(glm::ceil(glm::vec2(command.ClipRect.z, command.ClipRect.w)), glm::vec2(0.0f), size);
            if (high.x <= low.x || high.y <= low.y || command.ElemCount == 0) continue;
            fingerprint_ = with(fingerprint_, reinterpret_cast<uintptr_t>(command.TextureId));
            commands_.push_back({first_index + command.IdxOffset,
                                 command.ElemCount,
                                 first_vertex + command.VtxOffset,
                                 {reinterpret_cast<uintptr_t>(command.TextureId)},
                                 glm::ivec4(low, high - low)});
        }
    }
    return {vertices_, indices_, commands_};
}

bool Gui::wants_mouse() const {
    return ImGui::GetIO().WantCaptureMouse;
}
Gui::Keys Gui::keys() const {
    if (ImGui::GetTopMostPopupModal() != nullptr) return Keys::dialog;
    if (ImGui::GetIO().WantTextInput) return Keys::text;
    return ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopup) ? Keys::popup : Keys::app;
}

void Gui::close_popups() {
    if (ImGui::GetTopMostPopupModal() == nullptr) ImGui::ClosePopupToLevel(0, false);
}

std::vector<std::string> Gui::windows() const {
    std::vector<std::string> titles;
    for (const ImGuiWindow* window : context_->Windows)
        if (window->WasActive && !window->Hidden) titles.emplace_back(window->Name);
    return titles;
}

bool Gui::holds_widget() const {
    return ImGui::IsAnyItemActive() && ImGui::IsMouseDown(ImGuiMouseButton_Left);
}

}  // namespace flg::studio
