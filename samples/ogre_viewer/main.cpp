// SPDX-License-Identifier: MIT
// Filigree inside OGRE: a window with an orbit camera, or so many frames and a screenshot.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>

#include "app.h"

int main(int argc, char** argv) {
    viewer::Options options;
    CLI::App app("Strokes, a decorated mesh and a skinned model inside an OGRE scene.");
    app.add_option("--frames", options.frames, "once all is made draw so many frames, then quit");
    app.add_option("--rate", options.rate, "of these frames a second, in the scene's time")
        ->check(CLI::Range(1.0, 1000.0))
        ->capture_default_str();
    app.add_option("--screenshot", options.screenshot, "write the last frame to this file (.png)");
    app.add_option("--width", options.width, "pixels")->check(CLI::Range(64, 8192))->capture_default_str();
    app.add_option("--height", options.height, "pixels")->check(CLI::Range(64, 8192))->capture_default_str();
    CLI11_PARSE(app, argc, argv);
    try {
        return viewer::App(options).run() == 0 ? 0 : 1;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "ogre_viewer: %s\n", error.what());
        return 1;
    }
}
