// SPDX-License-Identifier: MIT
// filigree styles: the style library, by name and as files.
#include <cstdio>
#include <filesystem>
#include <memory>

#include "command.h"
#include "documents/failure.h"
#include "documents/report.h"
#include "documents/text_file.h"
#include "support/curve_source.h"

namespace flg::cli {
namespace {

struct Options {
    std::string folder;
};

void write(const samples::CurveSource& style, const std::string& path) {
    FlgCurveFileWriteDesc desc = flgCurveFileWriteDefaults();
    // Radii and colours are there in any case, and in a plainer file.
    desc.all_columns = samples::find_column(style.view(), FLG_ATTRIBUTE_ANGLE) != nullptr;
    if (flgCurveFileWrite(path.c_str(), &style.view(), &desc) != FLG_OK) throw InputError(flgIoErrorGetMessage());
}

void run_styles(const Options& options, const CommonOptions& common) {
    require_writable(common.report);
    Report report("styles", common);
    if (!options.folder.empty()) {
        report.parameters["folder"] = options.folder;
        std::error_code error;
        std::filesystem::create_directories(options.folder, error);
        if (error) throw InputError(options.folder + ": can't be made: " + error.message());
    }
    for (const std::string& name : scenes::library_names()) {
        const samples::CurveSource style("builtin:" + name);
        std::printf("%-10s %zu points, %.3g m\n", name.c_str(), style.point_count(),
                    samples::curve_length(style.view(), 0));
        if (!options.folder.empty()) write(style, options.folder + "/" + name + ".xyz");
    }
    report.counts["styles"] = scenes::library_names().size();
    report.write();
}

}  // namespace

Command add_styles(CLI::App& program, const CommonOptions& common) {
    CLI::App* app = program.add_subcommand("styles", "Lists the style library, or writes it as files");
    const auto o = std::make_shared<Options>();
    app->add_option("-o,--output", o->folder,
                    "Writes each style into this folder, NAME.xyz: radius and colour, too, and the angle of ribbons")
        ->type_name("FOLDER");
    return {app, [o, &common] { run_styles(*o, common); }};
}

}  // namespace flg::cli
