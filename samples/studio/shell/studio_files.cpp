// SPDX-License-Identifier: MIT
// Documents and files of the app.
#include <algorithm>
#include <filesystem>

#include "shell/studio.h"
#include "shell/studio_error.h"

namespace flg::studio {
namespace {

constexpr const char* kExtension = ".filigree";

std::string key_of(const Workspace& workspace) {
    std::string key = workspace.title();
    std::transform(key.begin(), key.end(), key.begin(), [](char c) { return static_cast<char>(std::tolower(c)); });
    return key;
}

nlohmann::json to_json(const glm::vec3& v) {
    return {v.x, v.y, v.z};
}
glm::vec3 to_vec3(const nlohmann::json& v) {
    return {v.at(0).get<float>(), v.at(1).get<float>(), v.at(2).get<float>()};
}

}  // namespace

nlohmann::json Studio::document() const {
    nlohmann::json whole;
    whole["scene"] = scene_.save();
    const render::Camera& camera = view_.orbit.camera;
    whole["camera"] = {{"eye", to_json(camera.eye)}, {"target", to_json(camera.target)}};
    for (const auto& workspace : workspaces_) whole[key_of(*workspace)] = workspace->save();
    whole["front"] = key_of(*workspaces_[front_]);
    return whole;
}

bool Studio::take_document(const nlohmann::json& whole) {
    const auto part = [&](const std::string& key) { return whole.value(key, nlohmann::json::object()); };
    // A part that can't be taken leaves the others: as much as possible of a damaged document, and nothing of the one before.
    bool all = guarded("The scene", [&] { scene_.load(part("scene")); });
    for (const auto& workspace : workspaces_) {
        if (guarded(workspace->title(), [&] { workspace->load(part(key_of(*workspace))); })) continue;
        guarded(workspace->title(), [&] { workspace->load(nlohmann::json::object()); });
        all = false;
    }
    all = guarded("The camera",
                  [&] {
                      framed_ = whole.contains("camera");
                      if (!framed_) return;
                      view_.orbit.camera.eye = to_vec3(whole.at("camera").at("eye"));
                      view_.orbit.camera.target = to_vec3(whole.at("camera").at("target"));
                      view_.orbit.camera.up = {0.0f, 1.0f, 0.0f};
                  }) &&
          all;
    guarded("The workspace in front", [&] {
        for (size_t i = 0; i < workspaces_.size(); ++i)
            if (whole.value("front", "") == key_of(*workspaces_[i])) bring_to_front(i);
    });
    saved_changes_ = desk_.changes;
    if (!all) ++desk_.changes;
    return all;
}

void Studio::open_any(const std::string& path) {
    if (std::filesystem::path(path).extension() == kExtension) {
        when_safe([this, path] { load_path(path); });
        return;
    }
    // The one in front first: what it can take, it shall have.
    std::vector<Workspace*> order = {&front()};
    for (const auto& workspace : workspaces_)
        if (workspace.get() != &front()) order.push_back(workspace.get());
    for (Workspace* workspace : order) {
        if (!workspace->open(path)) continue;
        for (size_t i = 0; i < workspaces_.size(); ++i)
            if (workspaces_[i].get() == workspace) bring_to_front(i);
        ++desk_.changes;
        return;
    }
    scene_.open(path);
    framed_ = false;
    ++desk_.changes;
}

void Studio::load_path(const std::string& path) {
    const nlohmann::json whole = read_document(path);
    path_.clear();
    if (take_document(whole)) {
        path_ = path;
        autosave_.forget(desk_.changes);
    } else {
        notices_.add(Weight::warning,
                     "Not all of " + path + " could be taken. It stays as it is: saving asks for a name.");
    }
}

void Studio::save_path(const std::string& path) {
    write_document(path, document());
    path_ = path;
    saved_changes_ = desk_.changes;
    autosave_.forget(desk_.changes);
    notices_.add(Weight::info, "Saved as " + path + ".");
}

void Studio::save() {
    if (path_.empty())
        ask_save_as();
    else
        save_path(path_);
}

void Studio::ask_save_as() {
    files_.open(FileDialog::For::writing, "Save as", {kExtension}, "untitled.filigree",
                [this](const std::string& path) {
                    guarded("save", [&] { save_path(path); });
                    // It was asked for because of something else.
                    if (!unsaved() && when_safe_) std::exchange(when_safe_, nullptr)();
                });
}

void Studio::ask_open() {
    files_.open(FileDialog::For::reading, "Open", {}, "",
                [this](const std::string& path) { guarded("open a file", [&] { open_any(path); }); });
}

void Studio::ask_export(Workspace& workspace, const Workspace::Export& what) {
    files_.open(FileDialog::For::writing, "Export", {what.extension}, key_of(workspace) + what.extension,
                [this, &workspace, what](const std::string& path) {
                    guarded("export", [&] {
                        workspace.write(what, path);
                        notices_.add(Weight::info, std::string(what.what) + " written to " + path + ".");
                    });
                });
}

void Studio::export_path(const std::string& what, const std::string& path) {
    const std::string extension = std::filesystem::path(path).extension().string();
    for (const auto& workspace : workspaces_) {
        for (const Workspace::Export& format : workspace->exports()) {
            if (format.what != what || format.extension != extension) continue;
            workspace->write(format, path);
            return;
        }
    }
    throw StudioError("there is no export \"" + what + "\" as " + extension + ".");
}

void Studio::when_safe(std::function<void()> action) {
    if (unsaved())
        when_safe_ = std::move(action);
    else
        action();
}

void Studio::new_document() {
    take_document(nlohmann::json::object());
    path_.clear();
    autosave_.forget(desk_.changes);
}

}  // namespace flg::studio
