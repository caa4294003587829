// SPDX-License-Identifier: MIT
// Scripts that use the app as a person would: mouse and keys come as GLFW's do (shell/input.h), a frame each; commands
// open, save, take pictures and say what is expected. A step a line; README.md lists them.
#pragma once

#include <deque>
#include <string>
#include <vector>

#include "shell/input.h"

namespace flg::studio {

struct ScriptStep {
    int line = 0;
    std::vector<std::string> words;  // the verb first
    std::vector<bool> quoted;        // whether the word was: a widget's label
};

// Throws StudioError with file and line.
std::vector<ScriptStep> read_script(const std::string& path);

// The app, as scripts see it.
class ScriptHost {
public:
    virtual ~ScriptHost() = default;
    virtual View& view() = 0;
    virtual bool idle() const = 0;
    virtual void open_path(const std::string& path) = 0;
    virtual void save_path(const std::string& path) = 0;
    virtual void load_path(const std::string& path) = 0;
    virtual void export_path(const std::string& what, const std::string& path) = 0;
    virtual void take_shot(const std::string& name, bool everything) = 0;  // of the next frame
    virtual double count(const std::string& name) const = 0;               // "strokes.count"
    virtual void resize(uint32_t width, uint32_t height) = 0;
    virtual void lose_device() = 0;
    virtual render::Box scene_box() const = 0;
};

class ScriptPlayer {
public:
    // `name` for errors.
    ScriptPlayer(ScriptHost& host, std::string name, std::vector<ScriptStep> steps);

    // Before each frame: performs its events. False once all is done. Throws StudioError for a step that fails:
    // "FILE:LINE: why".
    bool frame();

private:
    using Beat = std::vector<InputEvent>;  // of one frame

    // As GLFW would.
    void perform(const InputEvent& event);
    void start(const ScriptStep& step);
    bool start_mouse(const ScriptStep& step);
    void start_command(const ScriptStep& step);
    void click(glm::vec2 at, const ScriptStep& step);
    void drag(const std::vector<glm::vec2>& way, const ScriptStep& step, size_t places);
    void slide(const ScriptStep& step);
    void keys(const std::string& chord);
    void expect(const ScriptStep& step) const;
    void hold(const ScriptStep& step, size_t from, bool press);
    // Where a place of a script is: "Label", X,Y of the 3D picture (0 to 1 from its upper left corner), world:X,Y,Z.
    // Scrolls a widget into sight first, then none.
    bool find(const ScriptStep& step, size_t word, glm::vec2* out);

    ScriptHost& host_;
    std::string name_;
    std::vector<ScriptStep> steps_;
    size_t next_ = 0;
    std::deque<Beat> beats_;
    int modifiers_ = 0;  // GLFW's bits, of keys that are down
    int tries_ = 0;      // frames that the present step waits already
};

}  // namespace flg::studio
