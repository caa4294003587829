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
    if (report.longest_chunk_us > longest_us_) {
        longest_us_ = report.longest_chunk_us;
        longest_stage_ = report.longest_chunk_stage;
    }
}

void FrameBudget::draw(const glm::ivec4& viewport, uint32_t budget_us, const render::Renderer& renderer) const {
    const float unit = ImGui::GetFontSize();
    ImGui::SetNextWindowPos(
        {static_cast<float>(viewport.x + viewport.z) - 0.6f * unit, static_cast<float>(viewport.y) + 0.6f * unit},
        ImGuiCond_Always, {1.0f, 0.0f});
    ImGui::SetNextWindowBgAlpha(0.85f);
    ImGui::Begin("##budget", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoInputs |
                     ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoSavedSettings);
    const ImVec2 size(17.0f * unit, 2.4f * unit);
    const auto count = static_cast<int>(kFrames);
    const auto offset = static_cast<int>(next_);
    char text[96];
    std::snprintf(text, sizeof text, "tick, of %u us", budget_us);
    ImGui::PlotHistogram("##tick", tick_us_.data(), count, offset, text, 0.0f, static_cast<float>(budget_us), size);
    const float most = std::max(*std::max_element(worker_us_.begin(), worker_us_.end()), 1000.0f);
    std::snprintf(text, sizeof text, "workers a frame, up to %.1f ms", 1e-3 * static_cast<double>(most));
    ImGui::PlotHistogram("##workers", worker_us_.data(), count, offset, text, 0.0f, most, size);
    const render::FrameStats& stats = renderer.stats();
    row("tick", "%.0f us", static_cast<double>(last_.tick_us));
    row("queue", "%.0f jobs", last_.jobs_pending);
    row("longest chunk", "%.0f us", static_cast<double>(longest_us_));
    if (longest_stage_[0] != '\0') ImGui::TextDisabled("  in %s", longest_stage_);
    ImGui::Separator();
    row("frame", "%.1f ms", static_cast<double>(frame_ms_[(next_ + kFrames - 1) % kFrames]));
    row("renderer", "%.2f ms", stats.cpu_ms);
    row("device", "%.1f ms", stats.gpu_ms);
    const std::pair<const char*, double> passes[] = {
        {"  uploads", stats.gpu_uploads_ms},   {"  shadows", stats.gpu_shadow_ms},
        {"  surfaces", stats.gpu_surfaces_ms}, {"  curves", stats.gpu_curves_ms},
        {"  backdrop", stats.gpu_backdrop_ms}, {"  widgets", stats.gpu_ui_ms}};
    for (const auto& [what, ms] : passes) row(what, "%.1f ms", ms);
    row("triangles", "%.0f", static_cast<double>(stats.triangles));
    ImGui::Separator();
    const render::MemoryReport memory = renderer.memory();
    row("memory", "%.0f MiB", mebibytes(memory.held));
    row("  of at most", "%.0f MiB", mebibytes(memory.limit));
    row("  curves", "%.1f MiB", mebibytes(memory.curves));
    row("  surfaces", "%.1f MiB", mebibytes(memory.surfaces));
    row("  pictures", "%.1f MiB", mebibytes(memory.targets + memory.textures + memory.shadow_map));
    ImGui::TextDisabled("%s", renderer.device_name().c_str());
    ImGui::End();
}

}  // namespace flg::studio
