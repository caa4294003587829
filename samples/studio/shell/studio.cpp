// SPDX-License-Identifier: MIT
#include "shell/studio.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "shell/report.h"
#include "shell/studio_error.h"
#include "shell/widgets.h"

namespace flg::studio {
namespace {

constexpr double kScriptFrame_s = 1.0 / 60.0;
constexpr int kFramesBetweenDraws = 40;  // in scripts, where nobody looks
constexpr int kQuietFrames = 2;          // in which nothing happened, before the app sleeps until something does
constexpr double kMaxSleep_s = 1.0;
constexpr double kFrame_s = 1.0 / 60.0;      // while something goes on
constexpr double kMaxUnseen_s = 1.0 / 20.0;  // that input may wait, when there is more of it than pictures
constexpr uint32_t kShotFrames = 8;          // that a script's picture is the mean of
constexpr int kFramesUntilTimed = 4;
constexpr double kSlowFrame_ms = 40.0;  // on the device: while something moves, half the pixels each way
constexpr double kFastFrame_ms = 8.0;   // of those: all of them again
constexpr float kTurn_rad = 4.0f;       // of dragging over the picture's height
constexpr float kZoomPerNotch = 0.88f;
constexpr double kDoubleClick_s = 0.35;
constexpr float kDoubleClickUnits = 6.0f;

double seconds_since(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

// Keys that do more the longer they are held.
bool goes_on(int key) {
    return key == GLFW_KEY_LEFT_BRACKET || key == GLFW_KEY_RIGHT_BRACKET ||
           (key >= GLFW_KEY_RIGHT && key <= GLFW_KEY_UP);
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
            throw StudioError("No display was found to open a window on. --script works without a display.");
        return std::make_unique<render::Target>(renderer, width, height);
    }
    auto window = std::make_unique<render::Window>(renderer, width, height, "Filigree Studio");
    *out_window = window.get();
    return window;
}

// The mouse looks as ImGui asks for.
void show_cursor(GLFWwindow* window) {
    static GLFWcursor* const kAcross = glfwCreateStandardCursor(GLFW_HRESIZE_CURSOR);
    static GLFWcursor* const kText = glfwCreateStandardCursor(GLFW_IBEAM_CURSOR);
    static GLFWcursor* const kHand = glfwCreateStandardCursor(GLFW_HAND_CURSOR);
    static ImGuiMouseCursor shown = ImGuiMouseCursor_Arrow;
    const ImGuiMouseCursor wanted = ImGui::GetMouseCursor();
    if (wanted == std::exchange(shown, wanted)) return;
    glfwSetCursor(window, wanted == ImGuiMouseCursor_ResizeEW    ? kAcross
                          : wanted == ImGuiMouseCursor_TextInput ? kText
                          : wanted == ImGuiMouseCursor_Hand      ? kHand
                                                                 : nullptr);
}

}  // namespace

Studio::Studio(const StudioOptions& options)
    : options_(options),
      context_(filigree::Context::create(context_desc(options))),
      renderer_(options.renderer),
      target_(make_target(renderer_, options, &window_)),
      scale_(options.scale > 0.0f ? options.scale
             : window_            ? window_->content_scale()
                                  : 1.0f),
      jobs_(notices_),
      scene_(context_, renderer_, jobs_),
      timeline_(scene_),
      app_{context_, renderer_, scene_, view_, jobs_, notices_, timeline_, scale_},
      steps_(scene_, timeline_, app_.changes),
      gizmo_(app_, steps_),
      workspaces_(make_workspaces(app_)),
      gui_(renderer_, scale_),
      pen_(window_ ? window_->handle() : nullptr),
      autosave_(options.autosave),
      first_steps_(options.script.empty() ? options.autosave : std::string()) {
    if (window_) glfwSetWindowSizeLimits(window_->handle(), 760, 480, GLFW_DONT_CARE, GLFW_DONT_CARE);
    listen(window_ ? window_->handle() : nullptr,
           {&input_, [this] { return player_ ? app_.seconds : seconds_since(started_); },
            [this] { return player_ ? 1.0f : pen_.pressure(); }});
    scene_.beside = [this] { return boxes_beside(); };
    timeline_.show = [this](UndoSource& source) {
        for (size_t i = 0; i < workspaces_.size(); ++i)
            if (workspaces_[i].get() == &source) bring_to_front(i);
    };
    view_.orbit.camera = {{1.1f, 0.9f, 2.2f}, {0.0f, 0.4f, 0.0f}};
    app_.tells_times = options_.script.empty();
    if (!options_.script.empty())
        player_.emplace(static_cast<ScriptHost&>(*this), options_.script, read_script(options_.script));
    lay_out();
    started_ = frame_start_ = std::chrono::steady_clock::now();
    const std::vector<std::string> left = autosave_.left_behind();
    if (!left.empty()) left_behind_ = left.front();
    for (const std::string& file : options_.files) guarded("open a file", [&] { open_any(file); });
    if (options_.files.empty() && !player_) guarded("make the first mesh", [&] { open_mesh("builtin:vase"); });
    app_.changes = saved_changes_ = 0;
    steps_.reset();
    timeline_.reset();
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
    ++frames_;
    app_.seconds =
        player_ ? static_cast<double>(frames_) * kScriptFrame_s : std::chrono::duration<double>(now - started_).count();
    if (window_ && !listen_once()) {
        if (player_) return false;
        close();
    }
    pen_.pressure();
    if (player_ && !player_->frame()) return false;
    input_.begin_frame(files_.is_opening());
    tick();
    lay_out();
    gui_.begin(input_, target_->width(), target_->height(), player_ ? kScriptFrame_s : static_cast<float>(elapsed));
    ui::begin_widgets();
    const Gui::Keys keys = gui_.keys();
    for (const std::string& path : input_.dropped) guarded("open a file", [&] { open_any(path); });
    move_camera();
    // A panel that throws leaves ImGui in the middle of its windows.
    if (!guarded("draw the panels", [&] { draw_chrome(); })) ImGui::ErrorCheckEndFrameRecover(nullptr);
    send_keys(std::max(keys, gui_.keys()));
    send_pointer();
    if (player_ == std::nullopt)
        notices_.draw(static_cast<float>(elapsed));
    else if (shot_ && shot_->everything)
        notices_.draw(0.0f);
    draw();
    worked_ms_ = 1e3 * std::chrono::duration<double>(std::chrono::steady_clock::now() - now).count();
    if (unsaved() && autosave_.waits(app_.changes)) ui::frame_in(kMaxSleep_s);
    if (autosave_.due(app_.seconds, app_.changes) && unsaved())
        guarded("save a recovery copy", [&] { autosave_.write(document(), app_.seconds, app_.changes); });
    rest();
    return !closing_;
}

// False once the window is to close.
bool Studio::listen_once() {
    const bool stays = window_->poll_events();
    const double now = seconds_since(started_);
    if (!player_) input_.came_between(heard_s_, now);
    heard_s_ = now;
    if (!stays) glfwSetWindowShouldClose(window_->handle(), GLFW_FALSE);
    return stays;
}

void Studio::tick() {
    const FlgFrameReport report = context_.tick(options_.budget_us);
    budget_.add(report, worked_ms_);
    guarded("finish a job", [&] { jobs_.update(); });
    guarded("show a mesh", [&] { scene_.update(); });
    for (const auto& workspace : workspaces_) guarded("update a workspace", [&] { workspace->update(); });
    guarded("save", [&] { finish_saving(false); });
    std::vector<UndoSource*> sources = {&steps_};
    for (const auto& workspace : workspaces_) sources.push_back(workspace.get());
    guarded("undo or redo", [&] { timeline_.update(sources); });
    lay_floor();
    if (wants_frame_ && front().shows_scene() && scene_.is_placed() && view_.viewport.z > 1) {
        render::Box box = scene_.box();
        for (const render::Box& other : boxes_beside()) box.add(other);
        wants_frame_ = false;
        if (box.empty()) return;
        if (std::exchange(framed_, true))
            view_.frame(box);
        else
            view_.frame(box, {-0.45f, -0.32f, -1.0f});
    }
}

void Studio::lay_floor() {
    render::Scene scene = renderer_.scene();
    if (scene.ground_height == front().floor()) return;
    scene.ground_height = front().floor();
    renderer_.set_scene(scene);
}

std::vector<render::Box> Studio::boxes_beside() const {
    std::vector<render::Box> boxes;
    for (const auto& workspace : workspaces_)
        if (const render::Box box = workspace->box(); !box.empty()) boxes.push_back(box);
    return boxes;
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
        notices_.add(Weight::error, std::string("Cannot ") + what + ": " + error.what());
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
    notices_.add(Weight::warning, "The graphics device was lost and has been restarted. Your work is safe.");
}

void Studio::lay_out() {
    const auto width = static_cast<float>(target_->width()), height = static_cast<float>(target_->height());
    const float units = width / scale_, border = SidePanel::kBorder * scale_;
    const float left = left_.width(units) * scale_ + border, right = right_.width(units) * scale_ + border;
    const float top = 62.0f * scale_, bottom = 26.0f * scale_;
    const glm::vec2 size = glm::max(glm::vec2(width - left - right, height - top - bottom), glm::vec2(16.0f));
    view_.viewport = {static_cast<int>(std::min(left, width - 16.0f)), static_cast<int>(std::min(top, height - 16.0f)),
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
        first_steps_.done(FirstSteps::kTurn);
    }
    if (over && input_.scrolled.y != 0.0f && !input_.control() && !input_.shift())
        view_.orbit.zoom(std::pow(kZoomPerNotch, input_.scrolled.y));
}

void Studio::send_keys(Gui::Keys whose) {
    if (!input_.pressed_key || whose == Gui::Keys::dialog) return;
    const KeyPress press = *input_.pressed_key;
    const bool plain = whose == Gui::Keys::app, closes = whose == Gui::Keys::popup;
    guarded("handle a key", [&] {
        if (shell_key(press) || (whose != Gui::Keys::text && edit_key(press))) {
            if (closes) gui_.close_popups();
        } else if (closes) {
            if (press.key == GLFW_KEY_ESCAPE) gui_.close_popups();
        } else if (plain && !view_key(press) && !(press.repeated && !goes_on(press.key))) {
            front().shortcut({press.key, input_.control(), input_.shift()});
        }
    });
}

// Whatever has the keyboard. One that is held does it once.
bool Studio::shell_key(const KeyPress& press) {
    const int key = press.key;
    const bool control = (press.modifiers & GLFW_MOD_CONTROL) != 0, shift = (press.modifiers & GLFW_MOD_SHIFT) != 0;
    const auto count = static_cast<int>(workspaces_.size());
    std::function<void()> what;
    if (key == GLFW_KEY_F1)
        what = [&] { shows_shortcuts_ = !shows_shortcuts_; };
    else if (key == GLFW_KEY_F2)
        what = [&] { budget_.show_more(); };
    else if (control && key == GLFW_KEY_S)
        what = [&] { shift ? ask_save_as() : save(); };
    else if (control && key == GLFW_KEY_O)
        what = [&] { ask_open(); };
    else if (control && key == GLFW_KEY_N)
        what = [&] { when_safe([this] { new_document(); }); };
    else if (control && key == GLFW_KEY_Q)
        what = [&] { close(); };
    else if (control && key >= GLFW_KEY_1 && key < GLFW_KEY_1 + count)
        what = [&] { bring_to_front(static_cast<size_t>(key - GLFW_KEY_1)); };
    if (what && !press.repeated) what();
    return what != nullptr;
}

bool Studio::edit_key(const KeyPress& press) {
    const bool shift = (press.modifiers & GLFW_MOD_SHIFT) != 0;
    if ((press.modifiers & GLFW_MOD_CONTROL) == 0) return false;
    if (press.key == GLFW_KEY_Z && !shift) {
        undo();
    } else if (press.key == GLFW_KEY_Y || press.key == GLFW_KEY_Z) {
        timeline_.redo();
    } else {
        return false;
    }
    return true;
}

// Both at once; if one is folded already, both come back.
void Studio::fold_panels() {
    const bool folds = !left_.folded() || !right_.folded();
    left_.fold(folds);
    right_.fold(folds);
}

bool Studio::view_key(const KeyPress& press) {
    const int key = press.key;
    const bool control = (press.modifiers & GLFW_MOD_CONTROL) != 0;
    if (key == GLFW_KEY_ESCAPE && (shows_shortcuts_ || shows_log_))
        shows_shortcuts_ = shows_log_ = false;
    else if (key == GLFW_KEY_ESCAPE && gizmo_.give_up())
        return true;
    else if (!control && key == GLFW_KEY_M)
        gizmo_.toggle();
    else if (!control && key == GLFW_KEY_TAB)
        fold_panels();
    else if (!control && (key == GLFW_KEY_HOME || key == GLFW_KEY_F))
        view_.frame(renderer_.bounds());
    else if (key == GLFW_KEY_KP_1)
        view_.frame(renderer_.bounds(), {0, 0, -1});
    else if (key == GLFW_KEY_KP_3)
        view_.frame(renderer_.bounds(), {-1, 0, 0});
    else if (key == GLFW_KEY_KP_7)
        view_.frame(renderer_.bounds(), {0, -1, 0});
    else
        return false;
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
        const double when = input_.path.front().seconds;
        mouse.double_clicked = when - last_press_s_ < kDoubleClick_s && away < kDoubleClickUnits * scale_;
        last_press_s_ = mouse.double_clicked ? -1.0 : when;
        last_press_px_ = input_.px;
    }
    mouse.down = pointer_drag_;
    if (pointer_drag_ && input_.released[kLeft]) {
        first_steps_.done(FirstSteps::kDraw);
        mouse.released = true;
        pointer_drag_ = mouse.down = false;
    }
    mouse.inside = over || mouse.down || mouse.released;
    if (front().shows_scene() && gizmo_.pointer(mouse)) {
        // Nobody else's: for the workspace the mouse has gone away.
        mouse.inside = mouse.pressed = mouse.down = mouse.released = mouse.double_clicked = false;
        mouse.path = {};
    }
    if (mouse.pressed && mouse.inside && front().shows_scene()) scene_.stop_playing();
    guarded("handle the mouse", [&] { front().pointer(mouse); });
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    const glm::ivec4 v = view_.viewport;
    list.PushClipRect({static_cast<float>(v.x), static_cast<float>(v.y)},
                      {static_cast<float>(v.x + v.z), static_cast<float>(v.y + v.w)});
    guarded("draw the handles", [&] { front().overlay(list); });
    if (front().shows_scene()) gizmo_.overlay(list);
    list.PopClipRect();
}

void Studio::draw() {
    if (window_) show_cursor(window_->handle());
    const std::string title = document_name() + (unsaved() ? " * - " : " - ") + "Filigree Studio";
    if (window_ && title != std::exchange(title_, title)) glfwSetWindowTitle(window_->handle(), title.c_str());
    const render::UiFrame ui = gui_.end();
    drew_ = false;
    if (player_ && !shot_ && frames_ % kFramesBetweenDraws != 0) return;
    if (!player_ && !shows_new()) return;
    drew_ = true;
    ++drawn_;
    drawn_at_ = std::chrono::steady_clock::now();
    const bool refines = !player_ || shot_;
    const render::DrawOptions options{ui, view_.viewport, refines, player_ ? 1.0f : changing_scale_};
    bool drawn = false;
    do {
        drawn = guarded("draw the scene", [&] { renderer_.draw(*target_, view_.orbit.camera, options); });
    } while (drawn && shot_ && target_->refined() < kShotFrames);
    choose_changing_scale();
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

void Studio::choose_changing_scale() {
    changing_frames_ = target_->refined() == 0 ? changing_frames_ + 1 : 0;
    // The device tells a frame's time some frames later.
    if (changing_frames_ < kFramesUntilTimed) return;
    const double ms = renderer_.stats().gpu_ms;
    if (ms > kSlowFrame_ms) changing_scale_ = 0.5f;
    if (ms < kFastFrame_ms) changing_scale_ = 1.0f;
}

// Whether there is a picture to be drawn: it would show something else than the last one, or the same more finely, and
// what comes next can't wait.
bool Studio::shows_new() {
    if (window_ && glfwGetWindowAttrib(window_->handle(), GLFW_ICONIFIED) == GLFW_TRUE) return false;
    if (input_.pending() && !input_.exposed && seconds_since(drawn_at_) < kMaxUnseen_s) return false;
    const render::Camera& camera = view_.orbit.camera;
    const Shown now{gui_.fingerprint(), camera.eye,     camera.target,
                    camera.up,          view_.viewport, {target_->width(), target_->height()}};
    const bool refines = target_->refined() < render::max_refined;
    const bool is_new = !(now == shown_) || renderer_.changed() || input_.exposed;
    shown_ = now;
    only_refines_ = refines && !is_new;
    return is_new || refines;
}

// Sleeps: until the next frame is due while something goes on, else until something happens.
void Studio::rest() {
    const bool goes_on = !idle() || front().moving() || scene_.plays() || gui_.holds_widget() || input_.changed();
    settled_frames_ = goes_on || (drew_ && !only_refines_) ? 0 : settled_frames_ + 1;
    quiet_frames_ = goes_on || drew_ ? 0 : quiet_frames_ + 1;
    const bool asleep = quiet_frames_ > kQuietFrames;
    if (!options_.report.empty()) report(asleep);
    if (!window_ || player_ || closing_ || input_.pending()) return;
    const double max_s = asleep ? std::min(ui::next_frame_in(), kMaxSleep_s) : kFrame_s;
    const double left_s = max_s - (asleep ? 0.0 : seconds_since(frame_start_));
    if (left_s <= 0.0) return;
    glfwWaitEventsTimeout(left_s);  // an event ends it
    input_.came_at_once();
    heard_s_ = seconds_since(started_);
}

void Studio::report(bool asleep) const {
    nlohmann::json whole = report_of(view_, input_);
    whole["windows"] = gui_.windows();
    whole["frame"] = frames_;
    whole["drawn"] = drawn_;
    whole["settled"] = settled_frames_ > kQuietFrames;
    whole["asleep"] = asleep;
    for (const std::string& name : options_.counts) whole["counts"][name] = count(name);
    write_report(options_.report, whole);
}

bool Studio::idle() const {
    if (!jobs_.idle() || timeline_.busy() || saving_ || input_.pending() || !scene_.settled()) return false;
    return std::none_of(workspaces_.begin(), workspaces_.end(),
                        [](const auto& workspace) { return workspace->busy(); });
}

void Studio::undo() {
    if (!gizmo_.give_up()) timeline_.undo(front());
}

void Studio::bring_to_front(size_t index) {
    if (index == front_) return;
    first_steps_.done(FirstSteps::kSwitch);
    front().leave();
    front_ = index;
    front().enter();
}

double Studio::count(const std::string& name) const {
    const size_t dot = name.find('.');
    const std::string who = name.substr(0, dot), what = dot == std::string::npos ? "" : name.substr(dot + 1);
    if (who == "scene" && what == "meshes") return static_cast<double>(scene_.meshes().size());
    if (who == "scene" && what == "floor") return renderer_.scene().ground_height.value_or(0.0f);
    if (who == "scene" && what == "overlaps") return static_cast<double>(scene_.overlap_count());
    if (who == "scene" && what == "playing") return scene_.plays() ? 1.0 : 0.0;
    if (who == "scene" && what == "bent")
        return static_cast<double>(std::count_if(scene_.meshes().begin(), scene_.meshes().end(),
                                                 [](const auto& mesh) { return mesh->bent() != nullptr; }));
    if (who == "scene" && what == "visible")
        return static_cast<double>(std::count_if(scene_.meshes().begin(), scene_.meshes().end(),
                                                 [](const auto& mesh) { return mesh->visible; }));
    if (who == "studio" && what == "steps") return static_cast<double>(timeline_.done());
    if (who == "studio" && what == "undone") return static_cast<double>(timeline_.undone());
    if (who == "studio" && what == "unsaved") return unsaved() ? 1.0 : 0.0;
    if (who == "studio" && what == "tool_panel_width")
        return static_cast<double>(left_.width(static_cast<float>(target_->width()) / scale_));
    if (who == "studio" && what == "notices") return static_cast<double>(notices_.log().size());
    for (const auto& workspace : workspaces_) {
        std::string title = workspace->title();
        std::transform(title.begin(), title.end(), title.begin(), [](char c) { return std::tolower(c); });
        if (title == who) return workspace->count(what);
    }
    throw StudioError("there is no value named " + name + ".");
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
