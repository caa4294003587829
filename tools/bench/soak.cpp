// SPDX-License-Identifier: MIT
// A minute of tests/soak: all abilities at once in one process of its own. Its bar is meant for ten (filigree_soak
// --minutes 10); memory and errors are the same question in both.
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <stdexcept>

#include <nlohmann/json.hpp>

#include "bench/groups.h"

namespace flg::bench {
namespace {

constexpr double kTickBarUs = 2200;

}  // namespace

std::vector<Row> run_soak() {
    const std::filesystem::path report =
        std::filesystem::temp_directory_path() / ("filigree_soak_" + std::to_string(getpid()) + ".json");
    const std::string command = "\"" FLG_SOAK_PROGRAM "\" --minutes 1 --json \"" + report.string() + "\" > /dev/null";
    const int status = std::system(command.c_str());
    std::ifstream file(report);
    const nlohmann::json soak = nlohmann::json::parse(file, nullptr, false);
    std::filesystem::remove(report);
    if (soak.is_discarded())
        throw std::runtime_error("the soak ended with " + std::to_string(status) + " and no report");

    char note[120];
    std::snprintf(note, sizeof note, "one minute; in processor time %.0f us, longest tick %.0f us",
                  soak["tick_processor_us"]["p99.9"].get<double>(), soak["tick_wall_us"]["max"].get<double>());
    const double first = soak["peak_bytes_first_half"].get<double>(), last = soak["peak_bytes_last_half"].get<double>();
    return {below("all abilities, 90 Hz, one worker: tick, p99.9", soak["tick_wall_us"]["p99.9"].get<double>(), "us",
                  kTickBarUs, note),
            within("  growth of its memory, last half to first", last / first, "x", 1, 0.02),
            within("  its errors", soak["errors"].get<double>(), "", 0, 0)};
}

}  // namespace flg::bench
