// SPDX-License-Identifier: MIT
// What all tests of the command line start from.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <regex>
#include <sstream>

#include "program.h"

namespace flg::test {

class Cli : public ::testing::Test {
protected:
    // What a slow machine's run says of its progress is apart from what is wrong.
    Outcome run(const std::vector<std::string>& arguments) const {
        Outcome outcome = run_program(FLG_CLI_PROGRAM, arguments, folder.path());
        static const std::regex said("filigree: [0-9]+ s: ");
        std::istringstream lines(outcome.err);
        outcome.err.clear();
        progress.clear();
        for (std::string line; std::getline(lines, line);)
            (std::regex_search(line, said, std::regex_constants::match_continuous) ? progress : outcome.err) +=
                line + "\n";
        return outcome;
    }

    // Runs and expects success.
    Outcome done(const std::vector<std::string>& arguments) const {
        const Outcome outcome = run(arguments);
        EXPECT_EQ(outcome.status, 0) << outcome.err;
        return outcome;
    }

    // Expects this exit status and one line on stderr that says all of `words`, in this order.
    void expect_refused(const std::vector<std::string>& arguments, int status,
                        const std::vector<std::string>& words) const {
        const Outcome outcome = run(arguments);
        EXPECT_EQ(outcome.status, status) << outcome.err;
        EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
        EXPECT_TRUE(outcome.err.starts_with("filigree: ")) << outcome.err;
        size_t from = 0;
        for (const std::string& word : words) {
            const size_t found = outcome.err.find(word, from);
            EXPECT_NE(found, std::string::npos) << "'" << word << "' is missing in: " << outcome.err;
            if (found != std::string::npos) from = found;
        }
    }

    nlohmann::json report(const std::string& name = "report.json") const {
        return nlohmann::json::parse(folder.read(name));
    }

    Folder folder;
    mutable std::string progress;  // of the last run
};

}  // namespace flg::test
