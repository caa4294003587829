// SPDX-License-Identifier: MIT
#include "shell/file_dialog.h"

#include <imgui.h>

#include <algorithm>
#include <filesystem>
#include <utility>

#include "shell/widgets.h"

namespace flg::studio {

namespace fs = std::filesystem;

namespace {

constexpr int kFramesToFocus = 8;  // at most: ImGui takes two or three

}  // namespace

void FileDialog::open(For what_for, std::string title, std::vector<std::string> extensions, std::string offered,
                      std::function<void(const std::string&)> done) {
    for_ = what_for;
    title_ = std::move(title);
    extensions_ = std::move(extensions);
    name_ = std::move(offered);
    done_ = std::move(done);
    std::error_code error;
    if (folder_.empty()) folder_ = fs::current_path(error).string();
    open_ = opening_ = true;
    frames_to_focus_ = kFramesToFocus;
    asks_to_replace_ = false;
    list();
}

void FileDialog::list() {
    folders_.clear();
    files_.clear();
    std::error_code error;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder_, error)) {
        const std::string name = entry.path().filename().string();
        if (name.starts_with('.')) continue;
        if (entry.is_directory(error))
            folders_.push_back(name);
        else if (extensions_.empty() || std::find(extensions_.begin(), extensions_.end(),
                                                  entry.path().extension().string()) != extensions_.end())
            files_.push_back(name);
    }
    std::sort(folders_.begin(), folders_.end());
    std::sort(files_.begin(), files_.end());
}

void FileDialog::choose() {
    fs::path path = fs::path(name_).is_absolute() ? fs::path(name_) : fs::path(folder_) / name_;
    std::error_code error;
    if (fs::is_directory(path, error)) {
        folder_ = path.string();
        name_.clear();
        frames_to_focus_ = kFramesToFocus;
        list();
        return;
    }
    if (for_ == For::writing && !extensions_.empty() && path.extension() != extensions_.front())
        path += extensions_.front();
    if (for_ == For::writing && fs::exists(path, error) && !asks_to_replace_) {
        asks_to_replace_ = true;
        return;
    }
    open_ = false;
    done_(path.string());
}

void FileDialog::draw() {
    if (!open_) return;
    if (std::exchange(opening_, false)) ImGui::OpenPopup(title_.c_str());
    const float unit = ImGui::GetFontSize();
    const ImGuiViewport& window = *ImGui::GetMainViewport();
    ImGui::SetNextWindowPos(window.GetCenter(), ImGuiCond_Always, {0.5f, 0.5f});
    ImGui::SetNextWindowSize({34.0f * unit, 26.0f * unit});
    bool stays = true;
    if (!ImGui::BeginPopupModal(title_.c_str(), &stays, ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove)) return;
    ui::hint(folder_.c_str());
    ImGui::BeginChild("##files", {0.0f, -5.5f * unit}, true);
    std::string entered;
    if (ui::selectable("..", false)) entered = fs::path(folder_).parent_path().string();
    for (const std::string& name : folders_)
        if (ui::selectable((name + "/").c_str(), false)) entered = (fs::path(folder_) / name).string();
    for (const std::string& name : files_) {
        if (!ui::selectable(name.c_str(), name == name_)) continue;
        name_ = name;
        asks_to_replace_ = false;
    }
    ImGui::EndChild();
    if (!entered.empty()) {
        folder_ = entered;
        frames_to_focus_ = kFramesToFocus;
        list();
    }
    if (ui::text("File name", &name_, "A file name or a full path. The path of a folder opens that folder.",
                 frames_to_focus_ > 0))
        asks_to_replace_ = false;
    if (frames_to_focus_ > 0) frames_to_focus_ = ImGui::IsItemActive() ? 0 : frames_to_focus_ - 1;
    const char* verb = asks_to_replace_ ? "Replace" : for_ == For::reading ? "Open" : "Save";
    const bool chosen =
        ui::row_button((std::string(verb) + "##file").c_str(), 2,
                       asks_to_replace_ ? "A file of this name exists. Replacing it cannot be undone." : "",
                       {.enabled = !name_.empty()});
    ui::same_row();
    if (ui::row_button("Cancel##file", 2, "") || !stays || ui::escape()) open_ = false;
    if (open_ && !name_.empty() && (chosen || ui::enter())) choose();
    if (!open_) ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
}

}  // namespace flg::studio
