// SPDX-License-Identifier: MIT
// filigree bench: the table of bars.
#include "bench/bench.h"

#include <iostream>
#include <memory>

#include "command.h"
#include "documents/failure.h"
#include "documents/progress.h"
#include "documents/report.h"
#include "documents/text_file.h"

namespace flg::cli {
namespace {

void append(nlohmann::ordered_json& list, const bench::Group& group, const std::vector<bench::Row>& rows) {
    for (const bench::Row& row : rows) {
        list.push_back({{"ability", group.ability},
                        {"group", group.name},
                        {"name", row.name},
                        {"figure", row.figure},
                        {"unit", row.unit},
                        {"bar", row.bar_text()},
                        {"held", row.held()},
                        {"note", row.note}});
    }
}

void print_row(const bench::Row& row) {
    std::printf("%-46s %12.4g %-4s %-16s %s%s%s\n", row.name.c_str(), row.figure, row.unit.c_str(),
                row.bar_text().c_str(), row.held() ? "met" : "MISSED", row.note.empty() ? "" : "  ", row.note.c_str());
    std::fflush(stdout);
}

void run_bench(const std::string& filter, bool as_json, const CommonOptions& common) {
    require_writable(common.report);
    Report report("bench", common);
    report.parameters["filter"] = filter;
    nlohmann::ordered_json bars = nlohmann::ordered_json::array();
    uint32_t held = 0;
    std::string ability;
    for (const bench::Group& group : bench::groups()) {
        if (group.name.find(filter) == std::string::npos) continue;
        say_step("measuring " + group.name);
        const std::vector<bench::Row> added = group.run();
        clear_progress_line();
        append(bars, group, added);
        for (const bench::Row& row : added) held += row.held();
        if (as_json) continue;
        if (ability != group.ability) std::printf("%s%s\n", ability.empty() ? "" : "\n", group.ability.c_str());
        ability = group.ability;
        for (const bench::Row& row : added) print_row(row);
    }
    if (bars.empty()) {
        std::string names;
        for (const bench::Group& group : bench::groups()) names += (names.empty() ? "" : ", ") + group.name;
        throw UsageError("bench: nothing is called '" + filter + "'; there are " + names);
    }
    report.counts = {{"bars", bars.size()}, {"held", held}};
    report.quality["bars"] = bars;
    if (as_json) std::cout << nlohmann::ordered_json({{"bars", bars}}).dump(2) << "\n";
    report.write();
    if (held < bars.size()) {
        throw InputError("bench: " + std::to_string(bars.size() - held) + " of " + std::to_string(bars.size()) +
                         " targets missed");
    }
}

}  // namespace

Command add_bench(CLI::App& program, const CommonOptions& common) {
    CLI::App* app =
        program.add_subcommand("bench", "Measures all targets and reports pass or fail; exit status 1 if one fails");
    const auto filter = std::make_shared<std::string>();
    const auto as_json = std::make_shared<bool>(false);
    app->add_option("FILTER", *filter, "Only groups whose name contains this");
    app->add_flag("--json", *as_json, "The table as JSON on stdout");
    return {app, [=, &common] { run_bench(*filter, *as_json, common); }};
}

}  // namespace flg::cli
