// SPDX-License-Identifier: MIT
#include "shell/frame_budget.h"

#include <imgui.h>

#include <algorithm>
#include <cstdio>

#include "shell/widgets.h"

namespace flg::studio {
namespace {

void row(const char* what, const char* format, double value) {
    ImGui::TextDisabled("%s", what);
    ImGui::SameLine(8.5f * ImGui::GetFontSize());
    char text[64];
    std::snprintf(text, sizeof text, format, value);
    ImGui::TextUnformatted(text);
}

double mebibytes(uint64_t bytes) {
    return static_cast<double>(bytes) / (1 << 20);
}

}  // namespace

void FrameBudget::add(const FlgFrameReport& report, double frame_ms) {
    tick_us_[next_] = report.tick_us;
    worker_us_[next_] = report.worker_us;
    frame_ms_[next_] = static_cast<float>(frame_ms);
    next_ = (next_ + 1) % kFrames;
    last_ = report;
    if (report.max_slice_us > max_us_) {
        max_us_ = report.max_slice_us;
        max_stage_ = report.max_slice_stage;
    }
}

void FrameBudget::draw(const glm::ivec4& viewport, uint32_t budget_us, const render::Renderer& renderer) const {
    if (shown_ == Shown::graph) draw_graph(viewport);
    if (shown_ == Shown::all) draw_all(viewport, budget_us, renderer);
}

// A bar a frame: the SDK's tick in amber, everything else in grey. The line is a 60th of a second.
void FrameBudget::draw_graph(const glm::ivec4& viewport) const {
    constexpr size_t kBars = 60;
    constexpr float kSixtieth_ms = 1000.0f / 60.0f;
    const float unit = ImGui::GetFontSize(), width = 8.0f * unit, height = 2.6f * unit, margin = 0.6f * unit;
    const ImVec2 low = {static_cast<float>(viewport.x + viewport.z) - width - margin,
                        static_cast<float>(viewport.y + viewport.w) - height - margin};
    ImGui::SetNextWindowPos(low);
    ImGui::SetNextWindowSize({width, height});
    ImGui::Begin(kWindow, nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_NoInputs |
                     ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoBringToFrontOnFocus |
                     ImGuiWindowFlags_NoSavedSettings);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(low, {low.x + width, low.y + height}, IM_COL32(25, 24, 22, 170), 0.25f * unit);
    float max_ms = 2.0f * kSixtieth_ms;
    for (const float ms : frame_ms_) max_ms = std::max(max_ms, ms);
    const float bottom = low.y + height, per_ms = (height - 1.2f * unit) / max_ms, bar = width / kBars;
    for (size_t i = 0; i < kBars; ++i) {
        const size_t at = (next_ + kFrames - kBars + i) % kFrames;
        const float left = low.x + static_cast<float>(i) * bar, tick = 1e-3f * tick_us_[at] * per_ms;
        list.AddRectFilled({left, bottom - frame_ms_[at] * per_ms}, {left + 0.8f * bar, bottom},
                           IM_COL32(150, 145, 138, 210));
        if (tick > 0.0f)
            list.AddRectFilled({left, bottom - std::max(tick, 1.0f)}, {left + 0.8f * bar, bottom},
                               IM_COL32(242, 166, 76, 255));
    }
    list.AddLine({low.x, bottom - kSixtieth_ms * per_ms}, {low.x + width, bottom - kSixtieth_ms * per_ms},
                 IM_COL32(255, 255, 255, 70));
    char text[64];
    const size_t now = (next_ + kFrames - 1) % kFrames;
    std::snprintf(text, sizeof text, "%.0f ms, SDK %.1f", static_cast<double>(frame_ms_[now]),
                  1e-3 * static_cast<double>(tick_us_[now]));
    list.AddText(ImGui::GetFont(), 0.8f * unit, {low.x + 0.3f * unit, low.y + 0.15f * unit},
                 IM_COL32(230, 226, 220, 255), text);
    ImGui::End();
}

void FrameBudget::draw_all(const glm::ivec4& viewport, uint32_t budget_us, const render::Renderer& renderer) const {
    const float unit = ImGui::GetFontSize();
    ImGui::SetNextWindowPos({static_cast<float>(viewport.x + viewport.z) - 0.6f * unit,
                             static_cast<float>(viewport.y + viewport.w) - 0.6f * unit},
                            ImGuiCond_Always, {1.0f, 1.0f});
    ImGui::SetNextWindowBgAlpha(0.85f);
    ImGui::Begin(kWindow, nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoInputs |
                     ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoSavedSettings);
    const ImVec2 size(17.0f * unit, 2.4f * unit);
    const auto count = static_cast<int>(kFrames);
    const auto offset = static_cast<int>(next_);
    char text[96];
    std::snprintf(text, sizeof text, "tick, budget %u us", budget_us);
    ImGui::PlotHistogram("##tick", tick_us_.data(), count, offset, text, 0.0f, static_cast<float>(budget_us), size);
    const float most = std::max(*std::max_element(worker_us_.begin(), worker_us_.end()), 1000.0f);
    std::snprintf(text, sizeof text, "workers per frame, up to %.1f ms", 1e-3 * static_cast<double>(most));
    ImGui::PlotHistogram("##workers", worker_us_.data(), count, offset, text, 0.0f, most, size);
    const render::FrameStats& stats = renderer.stats();
    row("tick", "%.0f us", static_cast<double>(last_.tick_us));
    row("queue", "%.0f jobs", last_.jobs_pending);
    row("longest chunk", "%.0f us", static_cast<double>(max_us_));
    if (max_stage_[0] != '\0') ImGui::TextDisabled("  in %s", max_stage_);
    ImGui::Separator();
    row("frame", "%.1f ms", static_cast<double>(frame_ms_[(next_ + kFrames - 1) % kFrames]));
    row("renderer", "%.2f ms", stats.cpu_ms);
    row("device", "%.1f ms", stats.gpu_ms);
    const std::pair<const char*, double> passes[] = {
        {"  uploads", stats.gpu_uploads_ms},   {"  shadows", stats.gpu_shadow_ms},
        {"  surfaces", stats.gpu_surfaces_ms}, {"  curves", stats.gpu_curves_ms},
        {"  backdrop", stats.gpu_backdrop_ms}, {"  finish", stats.gpu_finish_ms},
        {"  widgets", stats.gpu_ui_ms}};
    for (const auto& [what, ms] : passes) row(what, "%.1f ms", ms);
    row("triangles", "%.0f", static_cast<double>(stats.triangles));
    ImGui::Separator();
    const render::MemoryReport memory = renderer.memory();
    row("memory", "%.0f MiB", mebibytes(memory.held));
    row("  limit", "%.0f MiB", mebibytes(memory.limit));
    row("  curves", "%.1f MiB", mebibytes(memory.curves));
    row("  surfaces", "%.1f MiB", mebibytes(memory.surfaces));
    row("  textures", "%.1f MiB", mebibytes(memory.targets + memory.textures + memory.shadow_map));
    ImGui::TextDisabled("%s", renderer.device_name().c_str());
    ImGui::End();
}

}  // namespace flg::studio
