// SPDX-License-Identifier: MIT
// The scenarios call every function that the headers declare, with what it takes, and give the same bits each time.
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>

#include "hardening/scenarios.h"

namespace flg::test {
namespace {

std::set<std::string> declared_functions(const std::filesystem::path& headers) {
    std::set<std::string> names;
    const std::regex function(R"(FLG_API\s+[^;(]*?\b(flg\w+)\()");
    for (const auto& header : std::filesystem::directory_iterator(headers)) {
        const std::string file = header.path().filename().string();
        if (header.path().extension() != ".h") continue;
#ifndef FLG_WITH_IO
        if (file == "filigree_io.h") continue;
#endif
#ifndef FLG_WITH_PICK
        if (file == "filigree_pick.h") continue;
#endif
        std::ifstream stream(header.path());
        const std::string text{std::istreambuf_iterator<char>(stream), {}};
        for (std::sregex_iterator at(text.begin(), text.end(), function), end; at != end; ++at) names.insert((*at)[1]);
    }
    return names;
}

std::string run_all() {
    std::string all;
    for (const Scenario& scenario : scenarios) {
        SCOPED_TRACE(scenario.name);
        const Host host;
        Calls calls(host.context);
        try {
            scenario.run(calls);
        } catch (const Ended&) {}
        EXPECT_FALSE(calls.ended);
        all += calls.bits;
    }
    return all;
}

TEST(Completeness, EveryFunctionIsCalled) {
    const std::string bits = run_all();
#ifdef FLG_WITH_IO
    const Host host;
    for (const auto keep : {keep_curve_files, keep_mesh_files, keep_skin_files, keep_tangle_files}) {
        Calls calls(host.context);
        keep(calls);
    }
#endif
#ifdef FLG_WITH_PICK
    Calls picking(FlgContext{});
    pick(picking);
#endif
    const std::set<std::string> called = called_functions(), declared = declared_functions(FLG_HEADERS);
    EXPECT_GT(declared.size(), 150u);
    for (const std::string& name : declared) EXPECT_TRUE(called.contains(name)) << name << " is not called";
    EXPECT_TRUE(run_all() == bits);
    RecordProperty("bits", std::to_string(std::hash<std::string>()(bits)));  // for tests/abi/grown.py
}

}  // namespace
}  // namespace flg::test
