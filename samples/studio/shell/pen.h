// SPDX-License-Identifier: MIT
// A pen's pressure, which GLFW does not tell: asked of X (XInput 2) on a connection of its own, so that GLFW's events
// stay its own. Elsewhere, and built without libXi, every press is a full one.
#pragma once

#include <memory>

struct GLFWwindow;

namespace flg::studio {

class Pen {
public:
    explicit Pen(GLFWwindow* window);
    ~Pen();
    Pen(const Pen&) = delete;
    Pen& operator=(const Pen&) = delete;

    // Of what moved last, 0 to 1: 1 for a mouse. To be asked now and then, as what X tells waits to be read.
    float pressure();

private:
    struct State;
    std::unique_ptr<State> state_;  // null: there is no way to ask
};

// A device's value in its range as a pressure, 0 to 1. A range that is none: 1.
float pressure_of(double value, double low, double high);

}  // namespace flg::studio
