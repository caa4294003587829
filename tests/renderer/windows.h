// SPDX-License-Identifier: MIT
// A real window where there is a display (tools/test starts Xvfb), and a clear no where there is none.
#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <string>

#include "filigree_renderer/window.h"

namespace flg::render::test {

inline bool has_display() {
    return std::getenv("DISPLAY") || std::getenv("WAYLAND_DISPLAY");
}

// What a test of windows asserts where there is no display.
inline void expect_no_window(Renderer& renderer) {
    EXPECT_FALSE(Window::available());
    try {
        Window window(renderer, 320, 200, "Filigree");
        ADD_FAILURE() << "a window without a display";
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find("no display"), std::string::npos) << error.what();
    }
}

}  // namespace flg::render::test
