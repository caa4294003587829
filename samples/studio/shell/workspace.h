// SPDX-License-Identifier: MIT
// What a workspace is to the shell, and what the shell gives to a workspace. The four workspaces know the app and the
// scene, never each other.
#pragma once

#include <functional>
#include <nlohmann/json.hpp>
#include <span>
#include <string>

#include "scene/scene.h"
#include "shell/jobs.h"
#include "shell/notices.h"
#include "shell/studio_error.h"
#include "shell/timeline.h"
#include "shell/view.h"

struct ImDrawList;

namespace flg::studio {

// What workspaces share. Outlives them.
struct AppContext {
    filigree::Context& context;
    render::Renderer& renderer;
    Scene& scene;
    View& view;
    Jobs& jobs;
    Notices& notices;
    Timeline& timeline;
    float scale = 1.0f;       // pixels of the window to a unit of the layout: 1 or 2 and between
    double seconds = 0.0;     // since the start; in scripts each frame takes 1/60 s
    bool tells_times = true;  // how long something took is shown; not in scripts, whose pictures are compared
    uint64_t changes = 0;     // of the document: count it up with each that would be a loss
};

// A place of the mouse, and when it was there.
struct MouseSample {
    glm::vec2 px;
    double seconds;
    float pressure = 1.0f;  // of a pen, 0 to 1
};

// The mouse over the 3D picture, in this frame. Turning the camera (right or middle button, Alt with the left) is the
// shell's and does not come here.
struct Pointer {
    glm::vec2 px{0.0f};     // of the window
    bool inside = false;    // over the 3D picture and over no panel; once pressed there, until released
    bool pressed = false;   // the left button went down in this frame
    bool down = false;      // it is down, and went down over the picture
    bool released = false;  // it went up in this frame, having gone down over the picture
    bool double_clicked = false;
    bool shift = false, control = false;
    std::span<const MouseSample> path{};  // all places since the last frame, the last of them `px`; for drawing
};

// GLFW's key code, GLFW_KEY_A and so on.
struct Chord {
    int key = 0;
    bool control = false, shift = false;
};

class Workspace : public UndoSource {
public:
    explicit Workspace(AppContext& app) : app_(app) {}
    ~Workspace() override = default;
    Workspace(const Workspace&) = delete;
    Workspace& operator=(const Workspace&) = delete;

    // "Strokes". Also its button, its script name and its key in documents, in lower case.
    virtual const char* title() const = 0;
    // One sentence for who sees it for the first time: what to do with the mouse. Shown at the foot of the window; may
    // depend on the tool.
    virtual std::string help() const = 0;

    // It comes to the front, or goes.
    virtual void enter() {}
    virtual void leave() {}

    // Once a frame, after the tick and whichever is in front: takes results over, starts previews. Cheap when nothing
    // changed.
    virtual void update() = 0;
    // The rest only for the one in front, in this order, between ImGui's begin and end of the frame:
    virtual void panel() = 0;                        // its widgets (shell/widgets.h), in a window that is open already
    virtual void pointer(const Pointer& mouse) = 0;  // hovering too: mouse.inside and no button
    virtual void overlay(
        ImDrawList& list) = 0;  // over the 3D picture, in pixels of the window: handles, highlights, labels
    // True if it was for the workspace. Ctrl+Z, Ctrl+Shift+Z, Ctrl+Y and the shell's own keys (README.md) don't come
    // here.
    virtual bool shortcut(const Chord& chord) = 0;
    // Rows for the window of keyboard shortcuts.
    struct Shortcut {
        const char* keys;
        const char* what;
    };
    virtual std::span<const Shortcut> shortcuts() const = 0;

    // Files dropped or opened: what it takes, whatever is in front. Returns false without doing anything for others.
    virtual bool open(const std::string& path) = 0;
    // Its part of the document; load() replaces all there is, also by {} (a new document). Throws StudioError for what
    // can't be.
    virtual nlohmann::json save() const = 0;
    // The same, as it is now, to be made in another thread.
    virtual std::function<nlohmann::json()> saver() const {
        return [part = save()] { return part; };
    }
    virtual void load(const nlohmann::json& part) = 0;
    // Results for other programs: formats by extension ("Strokes as .glb"). Offered in the menu.
    struct Export {
        const char* what;       // "Strokes"
        const char* extension;  // ".glb"
    };
    virtual std::span<const Export> exports() const { return {}; }
    virtual void write(const Export&, const std::string& /*path*/) {}

    // That of the scene, while another one is looked through: of the paper to draw on, say.
    virtual const render::Camera* scene_camera() const { return nullptr; }
    // Whether meshes are seen while it is in front.
    virtual bool shows_scene() const { return true; }
    // Height of the floor while it is in front, metres.
    virtual float floor() const { return app_.scene.floor(); }
    // Of what it shows beside the meshes.
    virtual render::Box box() const { return {}; }
    // Whether something is still to come by itself (jobs are known to the shell, previews that wait for them may not
    // be).
    virtual bool busy() const { return false; }
    // Whether the picture changes from frame to frame though nothing is to come, as while something is played.
    virtual bool moving() const { return false; }
    // Everything uploaded to the renderer is gone: upload it again. Ids from before are invalid, not to be removed.
    virtual void device_lost() = 0;
    // For scripts: `expect WORKSPACE.NAME VALUE`. Throws StudioError for a name it does not know.
    virtual double count(const std::string& name) const = 0;

protected:
    AppContext& app_;
};

}  // namespace flg::studio
