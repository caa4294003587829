// SPDX-License-Identifier: MIT
// Three steps over the picture, for who starts the program for the first time. Each is ticked off once it is done.
#pragma once

#include <glm/glm.hpp>
#include <string>

namespace flg::studio {

class FirstSteps {
public:
    // `folder` remembers that they were shown; empty: they never are.
    explicit FirstSteps(const std::string& folder);

    bool shown() const { return shown_; }
    enum Step { kDraw, kTurn, kSwitch, kSteps };
    void done(Step step) { done_[step] = true; }
    // In the lower left corner of `viewport`. Only its close button takes the mouse.
    void draw(const glm::ivec4& viewport);

private:
    bool shown_ = false;
    bool done_[kSteps] = {};
};

}  // namespace flg::studio
