// SPDX-License-Identifier: MIT
// A display of its own (Xvfb) and a person at it: mouse and keys go through X (XTEST, by xdotool) to the real program,
// which says in a file what is to be seen and where. Nothing goes past the window.
#pragma once

#include <sys/types.h>

#include <functional>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tools/program.h"

namespace flg::test {

// A program in the background; killed at the end if it still runs.
class Process {
public:
    // What it prints goes to `log`. `ready_fd`: a descriptor for it to keep; -1: none.
    Process(const std::vector<std::string>& command, const std::string& log, int ready_fd = -1);
    ~Process();
    Process(const Process&) = delete;
    Process& operator=(const Process&) = delete;

    bool runs();
    // -1 if it did not end of itself. Throws after two minutes.
    int wait();
    pid_t id() const { return id_; }

private:
    pid_t id_;
    int status_ = 0;
    bool ended_ = false;
};

class Desktop {
public:
    Desktop(int width, int height);

    const std::string& display() const { return display_; }
    // What is on the screen, as a PNG file.
    void photograph(const std::filesystem::path& png) const;

private:
    Folder folder_;
    std::unique_ptr<Process> server_;
    std::string display_;
};

// The studio in a window at the desktop's upper left corner, and the person who uses it. What the person does returns
// when the studio has heard it and done it; it throws what could not be done.
class Person {
public:
    struct Share {
        double x, y;  // of the 3D picture, 0 to 1
    };
    // `counts` are those that count() is asked for. `arguments` go to the studio.
    Person(const Desktop& desktop, const std::vector<std::string>& arguments, const std::vector<std::string>& counts);

    void move(Share place);
    // `keys` are held meanwhile: "ctrl", "ctrl shift".
    void click(Share place, const std::string& keys = "", int button = 1);
    void click(const std::string& label, const std::string& keys = "");
    void drag(const std::vector<Share>& way, const std::string& keys = "", int button = 1);
    // From the middle of a widget to a share of its width.
    void slide(const std::string& label, double share);
    void scroll(Share place, int notches);
    // Chords as xdotool knows them, one after the other: "ctrl+s", "Return".
    void keys(const std::vector<std::string>& chords);
    void type(const std::string& text);
    // All at once, as by a fast hand.
    void keys_and_text(const std::vector<std::string>& before, const std::string& text,
                       const std::vector<std::string>& after);
    void drop(Share place, const std::vector<std::string>& paths);
    // The click that ends the program.
    void leave(const std::string& label);
    // Any of xdotool's commands, without waiting.
    void by_hand(const std::vector<std::string>& commands);
    // What a window manager's close button sends.
    void press_close();

    void pass(double seconds);
    double count(const std::string& name);
    bool sees(const std::string& label);
    bool has_window(const std::string& title);
    // Until the studio has done what it was asked for.
    void rest();
    // Until it draws no more, not even the same picture more finely.
    void sleep();
    // Until this holds of its report; throws `what` after two minutes.
    void until(const std::string& what, const std::function<bool(const nlohmann::json&)>& holds);
    const nlohmann::json& report();
    Process& studio() { return *studio_; }
    // What the studio printed.
    std::string said() const { return folder_.read("log"); }

private:
    struct Pixel {
        int x, y;
    };
    Pixel at(Share place);
    // Scrolls it into sight if need be.
    Pixel at(const std::string& label);
    void act(const std::vector<std::string>& commands);

    const Desktop& desktop_;
    Folder folder_;
    std::unique_ptr<Process> studio_;
    nlohmann::json report_;
    uint64_t buttons_ = 0, keys_ = 0, notches_ = 0, drops_ = 0;  // that the studio is to have heard
};

}  // namespace flg::test
