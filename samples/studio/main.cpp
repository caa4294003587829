// SPDX-License-Identifier: MIT
#include <CLI/CLI.hpp>
#include <cstdio>

#include "shell/studio.h"
#include "support/vulkan_loader.h"

int main(int argc, char** argv) {
    flg::samples::calm_vulkan_loader();
    flg::studio::StudioOptions options;
    options.autosave = flg::studio::state_folder();
    options.renderer.samples = 0;
    CLI::App program("Draws, ornaments, models and lays curves, with all of Filigree.", "studio");
    program.add_option("FILE", options.files, "Documents (.filigree), meshes, strokes, drawings; builtin:NAME");
    program.add_option("--script", options.script, "Steps to do instead of a person's (samples/studio/README.md)");
    program.add_option("--out", options.out, "Folder for a script's pictures")->capture_default_str();
    std::string size;
    program.add_option("--size", size, "WIDTHxHEIGHT of the window, in units of the layout (1280x800)");
    program.add_option("--scale", options.scale, "Pixels to a unit, 0.5 to 4; 0 = the display's")
        ->capture_default_str()
        ->check(CLI::Range(0.0f, 4.0f));
    program.add_option("--workers", options.workers, "Threads to work on, 0 = in the frame itself")
        ->capture_default_str()
        ->check(CLI::Range(0u, 256u));
    program.add_option("--budget", options.budget_us, "Microseconds of the SDK's work a frame")
        ->capture_default_str()
        ->check(CLI::Range(100u, 1'000'000u));
    program.add_option("--samples", options.renderer.samples, "A pixel: 1, 2, 4 or 8; 0 = as suits the device")
        ->capture_default_str()
        ->check(CLI::IsMember({0u, 1u, 2u, 4u, 8u}));
    program.add_option("--device", options.renderer.device, "Part of the Vulkan device's name");
    program.add_option("--autosave", options.autosave, "Folder for the copy that survives a crash; empty: none")
        ->capture_default_str();
    program.add_flag("--offscreen", options.offscreen, "A script without a window, even with a display");
    program.add_flag("--validation", options.renderer.validation,
                     "With Vulkan's validation layer; its messages are errors");
    CLI11_PARSE(program, argc, argv);
    if (!size.empty() && std::sscanf(size.c_str(), "%ux%u", &options.width, &options.height) != 2) {
        std::fprintf(stderr, "studio: --size is \"%s\"; WIDTHxHEIGHT is needed.\n", size.c_str());
        return 2;
    }
    if (!options.script.empty() && program.count("--autosave") == 0) options.autosave.clear();
    try {
        flg::studio::Studio studio(options);
        studio.run();
        for (const std::string& message : studio.messages()) std::fprintf(stderr, "studio: %s\n", message.c_str());
        return studio.messages().empty() ? 0 : 3;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "studio: %s\n", error.what());
        return 1;
    }
}
