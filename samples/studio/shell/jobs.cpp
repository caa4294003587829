// SPDX-License-Identifier: MIT
#include "shell/jobs.h"

#include <imgui.h>

#include <cstdio>

#include "shell/widgets.h"

namespace flg::studio {

void Jobs::add(std::string name, filigree::Job job, Done done, Shown shown, Failure failure) {
    running_.push_back({std::move(name), std::move(job), std::move(done), shown, failure});
}

void Jobs::update() {
    // What is added meanwhile comes at the end, and is looked at in this call too.
    for (auto it = running_.begin(); it != running_.end();) {
        const FlgJobStatus status = it->job.status();
        if (status.state != FLG_JOB_STATE_FINISHED) {
            ++it;
            continue;
        }
        // A copy of the node: `done` may add jobs, and the status names memory of the job.
        std::list<Running> ended;
        ended.splice(ended.begin(), running_, it++);
        const bool expected =
            status.result == FLG_OK || status.result == FLG_ERROR_CANCELLED || status.result == FLG_ERROR_DEPENDENCY;
        if (!expected) notices_.add(Weight::error, ended.front().name + ": " + status.error);
        if (ended.front().done) ended.front().done(status);
    }
}

void Jobs::cancel_all() {
    for (Running& running : running_) {
        running.job.cancel();
        running.cancelled = true;
    }
}

void Jobs::draw() {
    int number = 0;
    for (Running& running : running_) {
        if (running.shown == Shown::quiet) continue;
        const FlgJobStatus status = running.job.status();
        ImGui::PushID(number);
        ImGui::TextUnformatted(running.name.c_str());
        const float button = ImGui::GetFrameHeight();
        const ImGuiStyle& style = ImGui::GetStyle();
        const float width = ImGui::GetContentRegionAvail().x - button - style.ItemSpacing.x;
        const char* stage = running.cancelled ? "cancelling" : status.stage[0] ? status.stage : "waiting";
        char text[96];
        std::snprintf(text, sizeof text, "%s %.0f %%", stage, 100.0 * static_cast<double>(status.progress));
        ImGui::ProgressBar(status.progress, {width, 0.0f}, text);
        ui::tip("The job's current stage and its progress.");
        ImGui::SameLine();
        const std::string label = "x##cancel " + running.name + std::to_string(number);
        if (ui::button(label.c_str(), "Cancels this job. Nothing else is lost.", {.enabled = !running.cancelled})) {
            running.job.cancel();
            running.cancelled = true;
        }
        ImGui::PopID();
        ++number;
    }
}

}  // namespace flg::studio
