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
    CLI::App program("The Filigree studio: draw strokes, divide meshes, build skeletons, lay splines.", "studio");
    program.add_option("FILE", options.files,
                       "Files to open: documents (.filigree), meshes, strokes, drawings, or builtin:NAME");
    program.add_option("--script", options.script, "Script to run (samples/studio/README.md)");
    program.add_option("--out", options.out, "Folder for the pictures of a script")->capture_default_str();
    std::string size;
    program.add_option("--size", size, "Window size as WIDTHxHEIGHT, before scaling (1280x800)");
    program.add_option("--scale", options.scale, "Scale of the interface, 0.5 to 4; 0 = the scale of the display")
        ->capture_default_str()
        ->check(CLI::Range(0.0f, 4.0f));
    program.add_option("--workers", options.workers, "Worker threads; 0 = work inside the frame")
        ->capture_default_str()
        ->check(CLI::Range(0u, 256u));
    program.add_option("--budget", options.budget_us, "Budget of the SDK per frame, microseconds")
        ->capture_default_str()
        ->check(CLI::Range(100u, 1'000'000u));
    program
        .add_option("--samples", options.renderer.samples, "Samples per pixel: 1, 2, 4 or 8; 0 = chosen for the device")
        ->capture_default_str()
        ->check(CLI::IsMember({0u, 1u, 2u, 4u, 8u}));
    program.add_option("--device", options.renderer.device, "Part of the name of the Vulkan device");
    program.add_option("--autosave", options.autosave, "Folder for recovery copies; empty = none")
        ->capture_default_str();
    program.add_option("--report", options.report,
                       "File that says after each frame what is to be seen and where: for tests");
    program.add_option("--count", options.counts, "Adds a number to the report, such as strokes.count");
    program.add_flag("--offscreen", options.offscreen, "Runs a script without a window");
    program.add_flag("--validation", options.renderer.validation,
                     "Enables the Vulkan validation layer; its messages are errors");
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
