// SPDX-License-Identifier: MIT
// The app: one context, one renderer, one scene, four workspaces; and its frame, which is what every host of the SDK
// does once a frame: input, tick, what has become visible is taken over, draw.
#pragma once

#include <chrono>
#include <functional>
#include <future>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "filigree_renderer/window.h"
#include "shell/document.h"
#include "shell/file_dialog.h"
#include "shell/first_steps.h"
#include "shell/frame_budget.h"
#include "shell/gizmo.h"
#include "shell/gui.h"
#include "shell/input.h"
#include "shell/pen.h"
#include "shell/script.h"
#include "shell/side_panel.h"
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
    // Where to say after each frame what is to be seen (shell/report.h), with these counts; empty: nowhere.
    std::string report;
    std::vector<std::string> counts;
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
    bool listen_once();
    void tick();
    void draw();
    // False if it threw: the user has been told, a lost device been opened again.
    bool guarded(const char* what, const std::function<void()>& work);
    void recover();
    void choose_changing_scale();
    void lay_floor();
    // Of what workspaces show beside the meshes.
    std::vector<render::Box> boxes_beside() const;
    bool shows_new();
    void rest();
    void report(bool asleep) const;
    void lay_out();
    void move_camera();
    void send_keys(Gui::Keys whose);
    void send_pointer();
    bool shell_key(const KeyPress& press);
    bool edit_key(const KeyPress& press);
    bool view_key(const KeyPress& press);
    void fold_panels();

    // The windows around the picture: chrome.cpp, menus.cpp.
    void draw_chrome();
    void draw_menu();
    void draw_file_menu();
    void draw_edit_menu();
    void draw_view_menu();
    void draw_tabs();
    void draw_panel();
    void draw_borders();
    void draw_scene_panel();
    void draw_status();
    void draw_shortcuts();
    void draw_log();
    void draw_questions();

    // Documents: studio_files.cpp.
    bool unsaved() const { return app_.changes != saved_changes_; }
    // As it is now; the numbers become text in another thread.
    std::function<nlohmann::json()> document() const;
    // Begins to write it; what becomes of it is told by finish_saving().
    void begin_saving(const std::string& path);
    void finish_saving(bool waits);
    // False if some of it could not be taken: the rest is there, and counts as not saved.
    bool take_document(const nlohmann::json& document);
    void open_any(const std::string& path);
    void open_mesh(const std::string& source);
    void ask_open();
    void save();
    void ask_save_as();
    void ask_export(Workspace& workspace, const Workspace::Export& what);
    // Does it at once, or once the user has said what is to become of changes that are not saved.
    void when_safe(std::function<void()> action, bool closes = false);
    std::string document_name() const;
    void new_document();
    void close() {
        when_safe([this] { closing_ = true; }, true);
    }

    bool can_undo() { return timeline_.can_undo() || !front().is_settled(); }
    void undo();
    Workspace& front() { return *workspaces_[front_]; }
    void bring_to_front(size_t index);

    View& view() override { return view_; }
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
    render::Window* window_ = nullptr;  // the target, if it is one; before it, since making the target sets it
    std::unique_ptr<render::Target> target_;
    float scale_;
    Notices notices_;
    Jobs jobs_;
    View view_;
    Scene scene_;
    Timeline timeline_;
    AppContext app_;
    SceneSteps steps_;
    Gizmo gizmo_;
    std::vector<std::unique_ptr<Workspace>> workspaces_;
    size_t front_ = 0;
    Gui gui_;
    Input input_;
    Pen pen_;
    FrameBudget budget_;
    FileDialog files_;
    Autosave autosave_;
    FirstSteps first_steps_;
    std::optional<ScriptPlayer> player_;

    std::string path_;  // of the document; empty: none yet
    uint64_t saved_changes_ = 0;
    struct Saving {
        std::future<void> written;
        std::string path;
        uint64_t changes;
    };
    std::optional<Saving> saving_;
    std::function<void()> when_safe_;  // waits for the answer
    bool closes_ = false;              // what waits
    std::string title_;                // of the window
    std::string left_behind_;          // a crash's document, to be asked about
    bool closing_ = false;
    bool shows_shortcuts_ = false, shows_log_ = false;
    SidePanel left_{300.0f, 0.3f}, right_{230.0f, 0.22f};
    bool camera_drag_ = false, pointer_drag_ = false;
    double last_press_s_ = -1.0;
    glm::vec2 last_press_px_{0.0f};
    struct Shot {
        std::string name;
        bool everything;
    };
    std::optional<Shot> shot_;
    std::chrono::steady_clock::time_point started_, frame_start_, drawn_at_;
    double worked_ms_ = 0.0;  // in the last frame, without the wait for events
    double heard_s_ = 0.0;    // when the window was last asked for events
    uint64_t frames_ = 0;
    // What the last picture showed: one that shows the same is not drawn.
    struct Shown {
        uint64_t widgets = 0;
        glm::vec3 eye{0.0f}, target{0.0f}, up{0.0f};
        glm::ivec4 viewport{0};
        glm::uvec2 size{0};
        bool operator==(const Shown&) const = default;
    };
    Shown shown_;
    uint64_t drawn_ = 0;           // pictures
    bool drew_ = false;            // in this frame
    bool only_refines_ = false;    // the next picture shows the same as the last one, more finely
    int settled_frames_ = 0;       // in a row, in which nothing happened but that
    int quiet_frames_ = 0;         // and not even that
    int changing_frames_ = 0;      // in a row
    float changing_scale_ = 1.0f;  // of the picture while something moves
    bool framed_ = false;          // the camera has been pointed at what there is
    bool wants_frame_ = false;     // and is to be, at what was opened
};

}  // namespace flg::studio
