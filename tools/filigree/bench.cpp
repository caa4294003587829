// SPDX-License-Identifier: MIT
// filigree bench: the table of bars.
#include "bench/bench.h"

#include <unistd.h>

#include <iostream>
#include <memory>

#include "command.h"
#include "failure.h"
#include "report.h"
#include "text_file.h"

namespace flg::cli {
namespace {

nlohmann::ordered_json json_of(const std::vector<bench::Row>& rows) {
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (const bench::Row& row : rows) {
        list.push_back({{"name", row.name},
                        {"figure", row.figure},
                        {"unit", row.unit},
                        {"bar", row.bar_text()},
                        {"held", row.held()},
                        {"note", row.note}});
    }
    return list;
}

void print_row(const bench::Row& row) {
    std::printf("%-46s %12.4g %-4s %-16s %s%s%s\n", row.name.c_str(), row.figure, row.unit.c_str(),
                row.bar_text().c_str(), row.held() ? "held" : "NOT HELD", row.note.empty() ? "" : "  ",
                row.note.c_str());
    std::fflush(stdout);
}

void run_bench(const std::string& filter, bool as_json, const CommonOptions& common) {
    require_writable(common.report);
    Report report("bench", common);
    report.parameters["filter"] = filter;
    std::vector<bench::Row> rows;
    const bool shows_progress = !common.quiet && isatty(STDERR_FILENO) != 0;
    for (const bench::Group& group : bench::groups()) {
        if (group.name.find(filter) == std::string::npos) continue;
        if (shows_progress) std::cerr << "\r\033[K" << group.name << " ..." << std::flush;
        const std::vector<bench::Row> added = group.run();
        if (shows_progress) std::cerr << "\r\033[K" << std::flush;
        rows.insert(rows.end(), added.begin(), added.end());
        if (!as_json) {
            for (const bench::Row& row : added) print_row(row);
        }
    }
    if (rows.empty()) {
        std::string names;
        for (const bench::Group& group : bench::groups()) names += (names.empty() ? "" : ", ") + group.name;
        throw UsageError("bench: nothing is called '" + filter + "'; there are " + names);
    }
    uint32_t held = 0;
    for (const bench::Row& row : rows) held += row.held();
    report.counts = {{"bars", rows.size()}, {"held", held}};
    report.quality["bars"] = json_of(rows);
    if (as_json) std::cout << nlohmann::ordered_json({{"bars", json_of(rows)}}).dump(2) << "\n";
    report.write();
    if (held < rows.size()) {
        throw InputError("bench: " + std::to_string(rows.size() - held) + " of " + std::to_string(rows.size()) +
                         " bars are not held");
    }
}

}  // namespace

Command add_bench(CLI::App& program, const CommonOptions& common) {
    CLI::App* app = program.add_subcommand(
        "bench", "Measures what has a bar, and says whether it is held; exit status 1 if one is not");
    const auto filter = std::make_shared<std::string>();
    const auto as_json = std::make_shared<bool>(false);
    app->add_option("FILTER", *filter, "Only groups whose name contains this");
    app->add_flag("--json", *as_json, "The table as JSON on stdout");
    return {app, [=, &common] { run_bench(*filter, *as_json, common); }};
}

}  // namespace flg::cli
