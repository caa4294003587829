// SPDX-License-Identifier: MIT
// Asks for a file's name, in a window of its own: a list of the folder and a line to type in.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace flg::studio {

class FileDialog {
public:
    enum class For { reading, writing };
    // Files with these extensions are listed; none: all. `done` gets the path when one is chosen. An `offered` name for
    // writing.
    void open(For what_for, std::string title, std::vector<std::string> extensions, std::string offered,
              std::function<void(const std::string&)> done);
    // Each frame.
    void draw();
    bool is_open() const { return open_; }
    // It has been asked for, and its line does not have the keyboard yet.
    bool is_opening() const { return open_ && frames_to_focus_ > 0; }

private:
    void list();
    void choose();

    bool open_ = false, opening_ = false, asks_to_replace_ = false;
    int frames_to_focus_ = 0;  // that are left for it
    For for_ = For::reading;
    std::string title_, folder_, name_;
    std::vector<std::string> extensions_, folders_, files_;
    std::function<void(const std::string&)> done_;
};

}  // namespace flg::studio
