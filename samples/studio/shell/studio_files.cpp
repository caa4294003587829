// SPDX-License-Identifier: MIT
// Documents and files of the app.
#include <algorithm>
#include <filesystem>
#include <map>

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

std::function<nlohmann::json()> Studio::document() const {
    nlohmann::json whole;
    whole["scene"] = scene_.save();
    const render::Camera* of_scene = workspaces_[front_]->scene_camera();
    const render::Camera& camera = of_scene != nullptr ? *of_scene : view_.orbit.camera;
    whole["camera"] = {{"eye", to_json(camera.eye)}, {"target", to_json(camera.target)}};
    whole["front"] = key_of(*workspaces_[front_]);
    std::map<std::string, std::function<nlohmann::json()>> parts;
    for (const auto& workspace : workspaces_) parts.emplace(key_of(*workspace), workspace->saver());
    return [whole = std::move(whole), parts = std::move(parts)] {
        nlohmann::json filled = whole;
        for (const auto& [key, part] : parts) filled[key] = part();
        return filled;
    };
}

bool Studio::take_document(const nlohmann::json& whole) {
    const auto part = [&](const std::string& key) { return whole.value(key, nlohmann::json::object()); };
    const size_t front_before = front_;
    bring_to_front(0);  // which looks at the scene
    // A part that can't be taken leaves the others: as much as possible of a damaged document, and nothing of the one
    // before.
    bool all = guarded("load the scene", [&] { scene_.load(part("scene")); });
    steps_.reset();
    timeline_.reset();
    for (const auto& workspace : workspaces_) {
        if (guarded("load a workspace", [&] { workspace->load(part(key_of(*workspace))); })) continue;
        guarded("clear a workspace", [&] { workspace->load(nlohmann::json::object()); });
        all = false;
    }
    all = guarded("load the camera",
                  [&] {
                      framed_ = whole.contains("camera");
                      wants_frame_ = !framed_;
                      if (!framed_) return;
                      view_.orbit.camera.eye = to_vec3(whole.at("camera").at("eye"));
                      view_.orbit.camera.target = to_vec3(whole.at("camera").at("target"));
                      view_.orbit.camera.up = {0.0f, 1.0f, 0.0f};
                  }) &&
          all;
    guarded("choose a workspace", [&] {
        const std::string key = whole.value("front", key_of(*workspaces_[front_before]));
        for (size_t i = 0; i < workspaces_.size(); ++i)
            if (key == key_of(*workspaces_[i])) bring_to_front(i);
    });
    saved_changes_ = app_.changes;
    if (!all) ++app_.changes;
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
        wants_frame_ = wants_frame_ || !workspace->box().empty();
        ++app_.changes;
        return;
    }
    open_mesh(path);
}

void Studio::open_mesh(const std::string& source) {
    steps_.open(source);
    wants_frame_ = true;
}

void Studio::load_path(const std::string& path) {
    const nlohmann::json whole = read_document(path);
    path_.clear();
    if (take_document(whole)) {
        path_ = path;
        autosave_.forget(app_.changes);
    } else {
        notices_.add(Weight::warning,
                     "Some of " + path + " could not be loaded. The file is unchanged; saving asks for a new name.");
    }
}

void Studio::begin_saving(const std::string& path) {
    finish_saving(true);
    saving_ =
        Saving{std::async(std::launch::async, [path, document = document()] { write_document(path, document()); }),
               path, app_.changes};
}

void Studio::finish_saving(bool waits) {
    if (!saving_) return;
    if (!waits && saving_->written.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return;
    Saving saving = std::move(*std::exchange(saving_, std::nullopt));
    saving.written.get();
    path_ = saving.path;
    saved_changes_ = saving.changes;
    autosave_.forget(saving.changes);
    notices_.add(Weight::info, "Saved " + path_ + ".");
}

void Studio::save_path(const std::string& path) {
    begin_saving(path);
    finish_saving(true);
}

void Studio::save() {
    if (path_.empty())
        ask_save_as();
    else
        begin_saving(path_);
}

void Studio::ask_save_as() {
    files_.open(FileDialog::For::writing, "Save as", {kExtension}, "untitled.filigree",
                [this](const std::string& path) {
                    // Where it was asked for because of something else, that waits for it.
                    guarded("save", [&] { when_safe_ ? save_path(path) : begin_saving(path); });
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
                        notices_.add(Weight::info, std::string(what.what) + " exported to " + path + ".");
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

std::string Studio::document_name() const {
    return path_.empty() ? "untitled" : std::filesystem::path(path_).filename().string();
}

void Studio::when_safe(std::function<void()> action, bool closes) {
    closes_ = closes;
    if (unsaved())
        when_safe_ = std::move(action);
    else
        action();
}

void Studio::new_document() {
    take_document(nlohmann::json::object());
    path_.clear();
    autosave_.forget(app_.changes);
}

}  // namespace flg::studio
