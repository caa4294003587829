// SPDX-License-Identifier: MIT
// What it costs to have Filigree in a program: its size, a context, a call.
#include <elf.h>

#include <algorithm>
#include <chrono>
#include <fstream>
#include <stdexcept>

#include "bench/groups.h"
#include "bench/host.h"

namespace flg::bench {
namespace {

constexpr double kSizeBarMb = 3, kContextBarMs = 5, kGetterBarNs = 30;
constexpr int kContexts = 200, kRounds = 15, kCalls = 100'000;

// What `strip` leaves of a library: all that is loaded, the names and headers of its sections.
double stripped_mb(const char* path) {
    std::ifstream file(path, std::ios::binary);
    Elf64_Ehdr header = {};
    size_t loaded = 0, tables = 0;
    if (!file.read(reinterpret_cast<char*>(&header), sizeof header)) throw std::runtime_error("no library to measure");
    for (int i = 0; i < header.e_phnum; ++i) {
        Elf64_Phdr segment = {};
        file.seekg(static_cast<std::streamoff>(header.e_phoff + i * sizeof segment));
        file.read(reinterpret_cast<char*>(&segment), sizeof segment);
        if (segment.p_type == PT_LOAD) loaded = std::max<size_t>(loaded, segment.p_offset + segment.p_filesz);
    }
    for (int i = 0; i < header.e_shnum; ++i) {
        Elf64_Shdr section = {};
        file.seekg(static_cast<std::streamoff>(header.e_shoff + i * sizeof section));
        file.read(reinterpret_cast<char*>(&section), sizeof section);
        tables += sizeof section;
        if (i == header.e_shstrndx) tables += section.sh_size;
    }
    if (!file || loaded == 0) throw std::runtime_error("no library to measure");
    return 1e-6 * static_cast<double>(loaded + tables);
}

// By the wall, as workers start and end.
double context_ms() {
    const auto start = std::chrono::steady_clock::now();
    FlgContext context{};
    check(flgContextCreate(nullptr, &context));
    check(flgContextDestroy(context));
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

template <class Call>
double call_ns(const Call& call) {
    const auto round_ms = [&] {
        FlgResult worst = FLG_OK;
        const double ms = time_ms([&] {
            for (int i = 0; i < kCalls; ++i) worst = std::min(worst, call());
        });
        check(worst);
        return ms;
    };
    return median_ms(kRounds, round_ms) * 1e6 / kCalls;
}

}  // namespace

std::vector<Row> run_library() {
    Host host;
    const FlgCurveSet set = host.add(scenes::make_style("loops"));
    FlgJob job = {};
    host.prepare(set, 0, &job);
    host.run();
    FlgCurveSetView view = flgCurveSetViewDefaults();
    FlgJobStatus status = {};
    status.struct_size = sizeof status;
    const double view_ns = call_ns([&] { return flgCurveSetGetView(host.context(), set, &view); });
    const double status_ns = call_ns([&] { return flgJobGetStatus(host.context(), job, &status); });
    char note[80];
    std::snprintf(note, sizeof note, "flgCurveSetGetView %.1f ns, flgJobGetStatus %.1f ns", view_ns, status_ns);
    return {below("the library, stripped, without io and pick", stripped_mb(FLG_SHARED_LIBRARY), "MB", kSizeBarMb),
            below("a context, created and destroyed", median_ms(kContexts, context_ms), "ms", kContextBarMs),
            below("a getter of the ABI", std::max(view_ns, status_ns), "ns", kGetterBarNs, note)};
}

}  // namespace flg::bench
