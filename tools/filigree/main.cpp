// SPDX-License-Identifier: MIT
// The command line: everything the SDK does, without a window. Exit status: 0 done, 1 bad input or failed work, 2 bad
// usage.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <iostream>
#include <map>
#include <thread>

#include "choices.h"
#include "command.h"
#include "documents/failure.h"
#include "documents/progress.h"
#include "support/curve_source.h"

namespace {

constexpr int kDone = 0, kFailed = 1, kBadUsage = 2;
constexpr uint32_t kMaxWorkers = 256;

// One line, whatever was in it.
int complain(std::string sentence, int status) {
    std::replace(sentence.begin(), sentence.end(), '\n', ' ');
    std::cerr << "filigree: " << sentence << "\n";
    return status;
}

std::string version_text() {
    const uint32_t version = flgVersionGet();
    return "filigree " + std::to_string(version >> 22) + "." + std::to_string((version >> 12) & 0x3ff) + "." +
           std::to_string(version & 0xfff);
}

void add_common_options(CLI::App& program, flg::cli::CommonOptions& common) {
    program.add_option("--report", common.report, "Write a JSON report to this file")->type_name("FILE.json");
    program.add_option("--seed", common.seed, "Key of all random choices, 0 to 2^64 - 1")
        ->type_name("N")
        ->check(flg::cli::whole_64_bit())
        ->capture_default_str();
    program
        .add_option("--workers", common.workers,
                    "Threads to work on, 0 to 256; 0 = on the calling thread. Default: one a core (here " +
                        std::to_string(common.workers) + ")")
        ->type_name("N")
        ->check(CLI::Range(0u, kMaxWorkers).description(""));
    program
        .add_option("--budget", common.budget_us,
                    "Budget of each tick in microseconds, as a host would give it; 0 = run to the end")
        ->type_name("US")
        ->capture_default_str();
    program.add_flag("--quiet", common.quiet, "No progress and no warnings on stderr");
}

// Which all ranges let pass.
std::string refuse_nan(const std::string& text) {
    char* end = nullptr;
    return std::isnan(std::strtod(text.c_str(), &end)) && *end == '\0' ? text + " is not a number" : "";
}

// What a value is, in place of its type in the program.
void name_values(CLI::App& program) {
    static const std::map<std::string, std::string> names = {{"TEXT", "FILE"}, {"FLOAT", "X"}, {"UINT", "N"}};
    for (CLI::App* app : program.get_subcommands({})) {
        for (CLI::Option* option : app->get_options()) {
            if (option->get_type_name().starts_with("FLOAT")) option->check(refuse_nan);
            const auto found = names.find(option->get_type_name());
            if (found != names.end()) option->type_name(found->second);
        }
        name_values(*app);
    }
}

// Of two outputs in one file only one would be left.
void refuse_shared_outputs(const CLI::App& program, const CLI::App& command) {
    std::map<std::filesystem::path, std::string> options;  // by their file
    for (const CLI::App* app : {&program, &command}) {
        for (const char* name :
             {"--report", "--output", "--save-guide", "--save-matching", "--save-path", "--curves", "--masks"}) {
            const CLI::Option* option = app->get_option_no_throw(name);
            if (option == nullptr || option->count() == 0) continue;
            const std::string file = option->results().back();
            std::error_code ignored;
            const auto path = std::filesystem::weakly_canonical(std::filesystem::absolute(file, ignored), ignored);
            const auto [other, is_new] = options.emplace(path, name);
            if (!is_new)
                throw flg::cli::UsageError(file + ": " + other->second + " and " + name + " name the same file");
        }
    }
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App program(
        "Filigree draws curves in the style of an example, and works on the surfaces that curves live on.\n"
        "Curves are read from .xyz, .obj, .gltf, .glb, .tilt and .svg files, or built in: builtin:NAME or\n"
        "builtin:NAME:POINTS (builtin:loops, builtin:thomas:369400, ...). Meshes are read from .ply, .obj, .off, .gltf "
        "and\n"
        ".glb files, or built in: builtin:NAME (figure, scalp, vase, dish, ball, egg, cloth, torus).",
        "filigree");
    flg::cli::CommonOptions common;
    common.workers = std::clamp(std::thread::hardware_concurrency(), 1u, kMaxWorkers);
    add_common_options(program, common);
    program.set_version_flag("--version", version_text());
    program.require_subcommand(1);
    program.footer(
        "filigree COMMAND --help tells a command's options. For a start:\n"
        "  filigree stylize --style builtin:curls --target builtin:flourish -o curls.glb --as tube");
    // Common options may also follow the command.
    program.fallthrough();

    std::vector<flg::cli::Command> commands = {
        flg::cli::add_info(program, common), flg::cli::add_stylize(program, common),
        flg::cli::add_styles(program, common), flg::cli::add_replay(program, common)};
    for (flg::cli::Command& command : flg::cli::add_mesh(program, common)) commands.push_back(std::move(command));
    commands.push_back(flg::cli::add_geodesic(program, common));
    commands.push_back(flg::cli::add_path(program, common));
    commands.push_back(flg::cli::add_spline(program, common));
    commands.push_back(flg::cli::add_contour(program, common));
    commands.push_back(flg::cli::add_motion(program, common));
    commands.push_back(flg::cli::add_skeleton(program, common));
    commands.push_back(flg::cli::add_straight_skeleton(program, common));
    commands.push_back(flg::cli::add_tangle(program, common));
#if defined(FLG_WITH_RENDERER)
    commands.push_back(flg::cli::add_render(program, common));
    commands.push_back(flg::cli::add_panels(program, common));
#endif
    commands.push_back(flg::cli::add_bench(program, common));

    name_values(program);

    try {
        program.parse(argc, argv);
    } catch (const CLI::Success& help) {  // --help, --version
        return program.exit(help);
    } catch (const CLI::RequiredError& error) {
        const std::vector<std::string> unknown = program.remaining();
        const std::string what = unknown.empty() ? error.what() : "there is no command '" + unknown[0] + "'";
        return complain(what + " (filigree --help)", kBadUsage);
    } catch (const CLI::ParseError& error) {
        return complain(std::string(error.what()) + " (filigree --help)", kBadUsage);
    }

    try {
        for (const flg::cli::Command& command : commands) {
            if (!command.app->parsed()) continue;
            refuse_shared_outputs(program, *command.app);
            const flg::cli::Progress progress(common.quiet, command.app->get_name());
            command.run();
        }
    } catch (const flg::cli::UsageError& error) {
        return complain(error.what(), kBadUsage);
    } catch (const std::bad_alloc&) {
        return complain("out of memory", kFailed);
    } catch (const std::exception& error) {
        return complain(error.what(), kFailed);
    }
    return kDone;
}
