// SPDX-License-Identifier: MIT
// The app: one context, one renderer, one scene, four workspaces; and its frame, which is what every host of the SDK does once
// a frame: input, tick, what has become visible is taken over, draw.
#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "filigree_renderer/window.h"
#include "shell/document.h"
#include "shell/file_dialog.h"
#include "shell/frame_budget.h"
#include "shell/gui.h"
#include "shell/input.h"
#include "shell/script.h"
#include "workspaces.h"

namespace flg::studio {

struct StudioOptions {
    std::vector<std::string> files;
    std::string script;                   // empty: a person is at it
    std::string out = ".";                // folder for the script's pictures
    uint32_t width = 1280, height = 800;  // units of the layout
    float scale = 0.0f;                   // pixels to a unit; 0: the display's
    uint32_t workers = 1, budget_us = 2000;
    bool offscreen = false;  // no window, even with a display
    std::string autosave;    // a folder; empty: none
    render::Options renderer{};
    // Takes the script's pictures; none: they are written to `out`.
    std::function<void(const std::string& name, const render::Image& image)> keep_shot{};
};

class Studio final : ScriptHost {
public:
    explicit Studio(const StudioOptions& options);
    ~Studio() override;

    // Until it is closed, or the script is over. Throws StudioError for a script's step that fails.
    void run();
    // What Vulkan's validation layer said.
    const std::vector<std::string>& messages() const { return renderer_.messages(); }

private:
    bool frame();
    void tick();
    void draw();
    // False if it threw: the user has been told, a lost device been opened again.
    bool guarded(const char* what, const std::function<void()>& work);
    void recover();
    void wait_for_events();
    void lay_out();
    void move_camera();
    void send_keys();
    void send_pointer();
    bool shell_key(int key, bool control, bool shift);

    // The windows around the picture: chrome.cpp, menus.cpp.
    void draw_chrome();
    void draw_menu();
    void draw_file_menu();
    void draw_edit_menu();
    void draw_view_menu();
    void draw_tabs();
    void draw_panel();
    void draw_scene_panel();
    void draw_status();
    void draw_shortcuts();
    void draw_log();
    void draw_questions();

    // Documents: studio_files.cpp.
    bool unsaved() const { return desk_.changes != saved_changes_; }
    nlohmann::json document() const;
    // False if some of it could not be taken: the rest is there, and counts as not saved.
    bool take_document(const nlohmann::json& document);
    void open_any(const std::string& path);
    void ask_open();
    void save();
    void ask_save_as();
    void ask_export(Workspace& workspace, const Workspace::Export& what);
    // Does it at once, or once the user has said what is to become of changes that are not saved.
    void when_safe(std::function<void()> action);
    void new_document();
    void close() {
        when_safe([this] { closing_ = true; });
    }

    Workspace& front() { return *workspaces_[front_]; }
    void bring_to_front(size_t index);

    View& view() override { return view_; }
    Input& input() override { return input_; }
    double seconds() const override { return desk_.seconds; }
    bool idle() const override;
    void open_path(const std::string& path) override { open_any(path); }
    void save_path(const std::string& path) override;
    void load_path(const std::string& path) override;
    void export_path(const std::string& what, const std::string& path) override;
    void take_shot(const std::string& name, bool everything) override;
    double count(const std::string& name) const override;
    void resize(uint32_t width, uint32_t height) override;
    void lose_device() override;
    render::Box scene_box() const override { return renderer_.bounds(); }

    StudioOptions options_;
    filigree::Context context_;
    render::Renderer renderer_;
    std::unique_ptr<render::Target> target_;
    render::Window* window_ = nullptr;  // the target, if it is one
    float scale_;
    Notices notices_;
    Jobs jobs_;
    View view_;
    Scene scene_;
    Desk desk_;
    std::vector<std::unique_ptr<Workspace>> workspaces_;
    size_t front_ = 0;
    Gui gui_;
    Input input_;
    FrameBudget budget_;
    FileDialog files_;
    Autosave autosave_;
    std::optional<ScriptPlayer> player_;

    std::string path_;  // of the document; empty: none yet
    uint64_t saved_changes_ = 0;
    std::function<void()> when_safe_;  // waits for the answer
    uint32_t removing_ = 0;            // a mesh that waits for the answer; 0: none
    std::string left_behind_;          // a crash's document, to be asked about
    bool closing_ = false;
    bool shows_budget_ = false, shows_shortcuts_ = false, shows_log_ = false;
    bool camera_drag_ = false, pointer_drag_ = false;
    double last_press_s_ = -1.0;
    glm::vec2 last_press_px_{0.0f};
    struct Shot {
        std::string name;
        bool everything;
    };
    std::optional<Shot> shot_;
    std::chrono::steady_clock::time_point started_, frame_start_;
    double frame_ms_ = 0.0;
    uint64_t frames_ = 0;
    int quiet_frames_ = 0;
    bool framed_ = false;  // the camera has seen the first mesh
};

}  // namespace flg::studio
