// SPDX-License-Identifier: MIT
// Whole documents of the command line, read and carried out as it does: refused with a sentence, or done.
#include <string>
#include <string_view>

#include "documents/contour_file.h"
#include "documents/failure.h"
#include "documents/model_drawing.h"
#include "documents/motion_file.h"
#include "documents/pull_script.h"
#include "documents/tangle_script.h"
#include "fuzz/bounded_memory.h"

namespace flg::fuzz {
namespace {

// No more memory than a small model needs, so that what asks for too much is refused and not swapped.
constexpr size_t memory_bytes = 512u << 20;

struct Command {
    cli::CommonOptions common = [] {
        cli::CommonOptions options;
        options.quiet = true;
        return options;
    }();
    BoundedMemory memory{memory_bytes};
    cli::Report report{"fuzz", common};
    cli::Session session{common, *memory.hooks()};
};

void read_drawing(const std::string& path) {
    Command command;
    make_drawn_model(command.session, cli::read_model_drawing(path), path, command.report);
}

void read_outline(const std::string& path) {
    Command command;
    cli::ModelDrawing drawing;
    std::vector<std::string> warnings;
    drawing.parts = cli::read_contour_parts(path, warnings);
    make_drawn_model(command.session, drawing, path, command.report);
}

void read_motion(const std::string& path) {
    Command command;
    const cli::MotionFile file = cli::read_motion_file(path);
    const FlgMotionDesc desc = desc_of(file);
    FlgMotion motion{};
    FlgJob job{};
    cli::check(flgMotionCreate(command.session.context(), &desc, &motion, &job), path);
    const cli::Session::Pending pending{job, path};
    command.session.finish({&pending, 1}, command.report);
}

void read_pulls(const std::string& path) {
    cli::read_pull_script(path);
}

// Of a square of 128 triangles.
const std::string& mesh_file() {
    static const InputFile file(".mesh.obj");
    static const std::string path = [] {
        std::string text;
        for (int y = 0; y <= 8; ++y)
            for (int x = 0; x <= 8; ++x) text += "v " + std::to_string(x) + " " + std::to_string(y) + " 0\n";
        for (int y = 0; y < 8; ++y)
            for (int x = 0; x < 8; ++x) {
                const int a = 9 * y + x + 1;
                const auto f = [&](int i, int k, int m) {
                    text += "f " + std::to_string(i) + " " + std::to_string(k) + " " + std::to_string(m) + "\n";
                };
                f(a, a + 1, a + 10);
                f(a, a + 10, a + 9);
            }
        return std::string(file.holding(reinterpret_cast<const uint8_t*>(text.data()), text.size()));
    }();
    return path;
}

void read_script(const std::string& path) {
    Command command;
    const cli::MeshSurface surface(command.session, mesh_file(), 0, command.report);
    cli::TangleScript script(command.session, surface, command.report);
    script.run(cli::JsonPlace::read(path), path, false);
}

struct Kind {
    std::string_view name;
    void (*read)(const std::string& path);
};
constexpr Kind kinds[] = {{"drawings", read_drawing},
                          {"outlines", read_outline},
                          {"motions", read_motion},
                          {"pulls", read_pulls},
                          {"scripts", read_script}};

auto reader() {
    const std::string_view target = FLG_TARGET;
    for (const Kind& kind : kinds)
        if (target.starts_with(kind.name)) return kind.read;
    std::abort();
}

}  // namespace
}  // namespace flg::fuzz

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
    static const flg::fuzz::InputFile input(FLG_EXTENSION);
    static const auto read = flg::fuzz::reader();
    try {
        read(input.holding(data, size));
    } catch (const flg::cli::InputError& error) {
        FLG_DEMAND(error.what()[0] != '\0');
    } catch (const flg::cli::UsageError& error) {
        FLG_DEMAND(error.what()[0] != '\0');
    }
    return 0;
}
