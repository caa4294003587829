// SPDX-License-Identifier: MIT
#include "shell/studio.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "shell/studio_error.h"
#include "shell/widgets.h"

namespace flg::studio {
namespace {

constexpr double kScriptFrame_s = 1.0 / 60.0;
constexpr int kFramesBetweenDraws = 10;  // in scripts, where nobody looks
constexpr int kQuietFrames = 4;          // without anything to do, before the app sleeps until there is
constexpr double kSleep_s = 0.25;
constexpr float kTurn_rad = 4.0f;  // of dragging over the picture's height
constexpr float kZoomPerNotch = 0.88f;
constexpr double kDoubleClick_s = 0.35;
constexpr float kDoubleClickUnits = 6.0f;

double seconds_now() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

FlgContextDesc context_desc(const StudioOptions& options) {
    FlgContextDesc desc = flgContextDefaults();
    desc.worker_count = options.workers;
    return desc;
}

std::unique_ptr<render::Target> make_target(render::Renderer& renderer, const StudioOptions& options,
                                            render::Window** out_window) {
    const float scale = options.scale > 0.0f ? options.scale : 1.0f;
    const auto width = static_cast<uint32_t>(std::lround(static_cast<float>(options.width) * scale));
    const auto height = static_cast<uint32_t>(std::lround(static_cast<float>(options.height) * scale));
    if (options.offscreen || !render::Window::available()) {
        if (options.script.empty())
            throw StudioError("There is no display to open a window on; --script works without one.");
        return std::make_unique<render::Target>(renderer, width, height);
    }
    auto window = std::make_unique<render::Window>(renderer, width, height, "Filigree Studio");
    *out_window = window.get();
    return window;
}

}  // namespace

Studio::Studio(const StudioOptions& options)
    : options_(options),
      context_(context_desc(options)),
      renderer_(options.renderer),
      target_(make_target(renderer_, options, &window_)),
      scale_(options.scale > 0.0f ? options.scale
             : window_            ? window_->content_scale()
                                  : 1.0f),
      jobs_(notices_),
      scene_(context_, renderer_, jobs_),
      desk_{context_, renderer_, scene_, view_, jobs_, notices_, scale_},
      workspaces_(make_workspaces(desk_)),
      gui_(renderer_, scale_),
      autosave_(options.autosave) {
    if (window_) {
        listen(window_->handle(), input_, seconds_now);
        glfwSetWindowSizeLimits(window_->handle(), 760, 480, GLFW_DONT_CARE, GLFW_DONT_CARE);
    }
    view_.orbit.camera = {{1.1f, 0.9f, 2.2f}, {0.0f, 0.4f, 0.0f}};
    if (!options_.script.empty())
        player_.emplace(static_cast<ScriptHost&>(*this), options_.script, read_script(options_.script));
    lay_out();
    started_ = frame_start_ = std::chrono::steady_clock::now();
    const std::vector<std::string> left = autosave_.left_behind();
    if (!left.empty()) left_behind_ = left.front();
    for (const std::string& file : options_.files) guarded("open a file", [&] { open_any(file); });
    if (options_.files.empty() && !player_) guarded("make the first mesh", [&] { scene_.open("builtin:vase"); });
    desk_.changes = saved_changes_ = 0;
    front().enter();
}

Studio::~Studio() {
    // Jobs may call back into workspaces: these go while the context is there.
    jobs_.cancel_all();
    workspaces_.clear();
}

void Studio::run() {
    while (frame()) {}
}

bool Studio::frame() {
    const auto now = std::chrono::steady_clock::now();
    const double elapsed = std::chrono::duration<double>(now - std::exchange(frame_start_, now)).count();
    frame_ms_ = 1e3 * elapsed;
    ++frames_;
    desk_.seconds =
        player_ ? static_cast<double>(frames_) * kScriptFrame_s : std::chrono::duration<double>(now - started_).count();
    if (window_ && !window_->poll_events()) {
        glfwSetWindowShouldClose(window_->handle(), GLFW_FALSE);
        if (player_) return false;
        close();
    }
    if (player_ && !player_->frame()) return false;
    input_.begin_frame();
    tick();
    lay_out();
    gui_.begin(input_, target_->width(), target_->height(), player_ ? kScriptFrame_s : static_cast<float>(elapsed));
    ui::begin_widgets();
    for (const std::string& path : input_.dropped) guarded("open a file", [&] { open_any(path); });
    move_camera();
    // A panel that throws leaves ImGui in the middle of its windows.
    if (!guarded("the panels", [&] { draw_chrome(); })) ImGui::ErrorCheckEndFrameRecover(nullptr);
    send_keys();
    send_pointer();
    if (player_ == std::nullopt)
        notices_.draw(static_cast<float>(elapsed));
    else if (shot_ && shot_->everything)
        notices_.draw(0.0f);
    draw();
    if (autosave_.due(desk_.seconds, desk_.changes) && unsaved())
        guarded("keep a copy", [&] { autosave_.write(document(), desk_.seconds, desk_.changes); });
    wait_for_events();
    return !closing_;
}

void Studio::tick() {
    const FlgFrameReport report = context_.tick(options_.budget_us);
    budget_.add(report, frame_ms_);
    guarded("take a job's result", [&] { jobs_.update(); });
    guarded("show a mesh", [&] { scene_.update(); });
    for (const auto& workspace : workspaces_) guarded(workspace->title(), [&] { workspace->update(); });
    if (!framed_ && !scene_.box().empty() && view_.viewport.z > 1) {
        framed_ = true;
        view_.frame(scene_.box(), {-0.45f, -0.32f, -1.0f});
    }
}

bool Studio::guarded(const char* what, const std::function<void()>& work) {
    try {
        work();
        return true;
    } catch (const StudioError& error) {
        notices_.add(Weight::error, error.what());
    } catch (const render::DeviceLost&) {
        recover();
    } catch (const std::exception& error) {
        notices_.add(Weight::error, std::string(what) + ": " + error.what());
    }
    return false;
}

void Studio::recover() {
    try {
        renderer_.recover();
    } catch (const render::Error& error) {
        notices_.add(Weight::error, error.what());  // the next frame tries again
        return;
    }
    gui_.device_lost();
    scene_.device_lost();
    for (const auto& workspace : workspaces_) workspace->device_lost();
    notices_.add(Weight::warning, "The graphics device was lost and has been opened again; nothing of yours is gone.");
}

void Studio::lay_out() {
    const float panel = 300.0f * scale_, right = 230.0f * scale_, top = 62.0f * scale_, bottom = 26.0f * scale_;
    const auto width = static_cast<float>(target_->width()), height = static_cast<float>(target_->height());
    const glm::vec2 size = glm::max(glm::vec2(width - panel - right, height - top - bottom), glm::vec2(16.0f));
    view_.viewport = {static_cast<int>(std::min(panel, width - 16.0f)), static_cast<int>(std::min(top, height - 16.0f)),
                      static_cast<int>(std::min(size.x, width)), static_cast<int>(std::min(size.y, height))};
}

void Studio::move_camera() {
    const bool over = view_.contains(input_.px) && !gui_.wants_mouse();
    const bool alt_left = input_.alt() && input_.pressed[kLeft];
    if (over && (input_.pressed[kRight] || input_.pressed[kMiddle] || alt_left)) camera_drag_ = true;
    if (!input_.down[kRight] && !input_.down[kMiddle] && !(input_.down[kLeft] && input_.alt())) camera_drag_ = false;
    const float unit = 1.0f / static_cast<float>(view_.viewport.w);
    if (camera_drag_ && input_.moved != glm::vec2(0.0f)) {
        const glm::vec2 moved = input_.moved * unit;
        if (input_.shift() || (input_.down[kMiddle] && !input_.alt()))
            view_.orbit.pan(-moved.x, moved.y);
        else
            view_.orbit.turn(-moved.x * kTurn_rad, moved.y * kTurn_rad);
    }
    if (over && input_.scrolled.y != 0.0f && !input_.control() && !input_.shift())
        view_.orbit.zoom(std::pow(kZoomPerNotch, input_.scrolled.y));
}

void Studio::send_keys() {
    for (const int key : input_.pressed_keys) {
        if (gui_.wants_keys()) continue;
        guarded("a key", [&] {
            if (!shell_key(key, input_.control(), input_.shift()))
                front().shortcut({key, input_.control(), input_.shift()});
        });
    }
}

bool Studio::shell_key(int key, bool control, bool shift) {
    if (control && key == GLFW_KEY_Z && !shift) {
        if (front().can_undo()) front().undo();
    } else if (control && (key == GLFW_KEY_Y || (key == GLFW_KEY_Z && shift))) {
        if (front().can_redo()) front().redo();
    } else if (control && key == GLFW_KEY_S) {
        shift ? ask_save_as() : save();
    } else if (control && key == GLFW_KEY_O) {
        ask_open();
    } else if (control && key == GLFW_KEY_N) {
        when_safe([this] { new_document(); });
    } else if (control && key == GLFW_KEY_Q) {
        close();
    } else if (control && key >= GLFW_KEY_1 && key < GLFW_KEY_1 + static_cast<int>(workspaces_.size())) {
        bring_to_front(static_cast<size_t>(key - GLFW_KEY_1));
    } else if (key == GLFW_KEY_F1) {
        shows_shortcuts_ = !shows_shortcuts_;
    } else if (key == GLFW_KEY_F2) {
        shows_budget_ = !shows_budget_;
    } else if (!control && (key == GLFW_KEY_HOME || key == GLFW_KEY_F)) {
        view_.frame(renderer_.bounds());
    } else if (key == GLFW_KEY_KP_1) {
        view_.frame(renderer_.bounds(), {0, 0, -1});
    } else if (key == GLFW_KEY_KP_3) {
        view_.frame(renderer_.bounds(), {-1, 0, 0});
    } else if (key == GLFW_KEY_KP_7) {
        view_.frame(renderer_.bounds(), {0, -1, 0});
    } else {
        return false;
    }
    return true;
}

void Studio::send_pointer() {
    Pointer mouse;
    mouse.px = input_.px;
    mouse.shift = input_.shift();
    mouse.control = input_.control();
    mouse.path = input_.path;
    const bool over = view_.contains(input_.px) && !gui_.wants_mouse() && !camera_drag_;
    if (over && input_.pressed[kLeft]) {
        pointer_drag_ = mouse.pressed = true;
        const float away = glm::distance(input_.px, last_press_px_);
        mouse.double_clicked = desk_.seconds - last_press_s_ < kDoubleClick_s && away < kDoubleClickUnits * scale_;
        last_press_s_ = mouse.double_clicked ? -1.0 : desk_.seconds;
        last_press_px_ = input_.px;
    }
    mouse.down = pointer_drag_;
    if (pointer_drag_ && input_.released[kLeft]) {
        mouse.released = true;
        pointer_drag_ = mouse.down = false;
    }
    mouse.inside = over || mouse.down || mouse.released;
    guarded(front().title(), [&] { front().pointer(mouse); });
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    const glm::ivec4 v = view_.viewport;
    list.PushClipRect({static_cast<float>(v.x), static_cast<float>(v.y)},
                      {static_cast<float>(v.x + v.z), static_cast<float>(v.y + v.w)});
    guarded(front().title(), [&] { front().overlay(list); });
    list.PopClipRect();
}

void Studio::draw() {
    const render::UiFrame ui = gui_.end();
    if (player_ && !shot_ && frames_ % kFramesBetweenDraws != 0) return;
    guarded("draw", [&] { renderer_.draw(*target_, view_.orbit.camera, {ui, view_.viewport}); });
    if (!shot_) return;
    const std::string name = std::exchange(shot_, std::nullopt)->name;
    guarded("take a picture", [&] {
        const render::Image image = renderer_.capture(*target_);
        if (options_.keep_shot) return options_.keep_shot(name, image);
        std::error_code error;
        std::filesystem::create_directories(options_.out, error);
        write_png(image, options_.out + "/" + name + ".png");
    });
}

void Studio::wait_for_events() {
    if (!window_ || player_) return;
    const bool busy = !idle() || front().moving() || input_.pending() || !input_.path.empty() ||
                      !input_.pressed_keys.empty() || input_.down[kLeft] || input_.scrolled != glm::vec2(0.0f);
    quiet_frames_ = busy ? 0 : quiet_frames_ + 1;
    if (quiet_frames_ > kQuietFrames) glfwWaitEventsTimeout(kSleep_s);
}

bool Studio::idle() const {
    if (!jobs_.idle() || input_.pending() || !scene_.settled()) return false;
    return std::none_of(workspaces_.begin(), workspaces_.end(),
                        [](const auto& workspace) { return workspace->busy(); });
}

void Studio::bring_to_front(size_t index) {
    if (index == front_) return;
    front().leave();
    front_ = index;
    front().enter();
}

double Studio::count(const std::string& name) const {
    const size_t dot = name.find('.');
    const std::string who = name.substr(0, dot), what = dot == std::string::npos ? "" : name.substr(dot + 1);
    if (who == "scene" && what == "meshes") return static_cast<double>(scene_.meshes().size());
    if (who == "studio" && what == "unsaved") return unsaved() ? 1.0 : 0.0;
    if (who == "studio" && what == "notices") return static_cast<double>(notices_.log().size());
    for (const auto& workspace : workspaces_) {
        std::string title = workspace->title();
        std::transform(title.begin(), title.end(), title.begin(), [](char c) { return std::tolower(c); });
        if (title == who) return workspace->count(what);
    }
    throw StudioError("there is nothing to count by the name " + name + ".");
}

void Studio::take_shot(const std::string& name, bool everything) {
    shot_ = {name, everything};
}

void Studio::resize(uint32_t width, uint32_t height) {
    const auto wide = static_cast<uint32_t>(std::lround(static_cast<float>(width) * scale_));
    const auto high = static_cast<uint32_t>(std::lround(static_cast<float>(height) * scale_));
    if (window_) return window_->set_size(wide, high);
    try {
        target_->resize(wide, high);
    } catch (const render::DeviceLost&) {
        recover();
        target_->resize(wide, high);
    }
}

void Studio::lose_device() {
    renderer_.simulate_device_loss();
}

}  // namespace flg::studio
