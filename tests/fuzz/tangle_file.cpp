// SPDX-License-Identifier: MIT
// Documents of tangles: refused, or a history that can be written, and is then read as the same bytes.
#include <cstring>
#include <fstream>
#include <iterator>

#include "filigree/filigree_io.h"
#include "fuzz/fuzz.h"

namespace {

std::string contents(const char* path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
    static const flg::fuzz::InputFile input(".json"), copy(".copy.json");
    FlgTangleFile file = nullptr, again = nullptr;
    const FlgResult result = flgTangleFileRead(input.holding(data, size), nullptr, &file);
    if (result != FLG_OK) {
        FLG_DEMAND(file == nullptr);
        flg::fuzz::demand_refusal(result, flgIoErrorGetMessage());
        return 0;
    }
    FlgTangleHistory history = {};
    history.struct_size = sizeof history;
    FLG_DEMAND(flgTangleFileGetHistory(file, &history) == FLG_OK);
    const char* const path = copy.holding(nullptr, 0);
    FLG_DEMAND(flgTangleFileWrite(path, &history, nullptr) == FLG_OK);
    const std::string first = contents(path);
    FLG_DEMAND(flgTangleFileRead(path, nullptr, &again) == FLG_OK &&
               flgTangleFileGetHistory(again, &history) == FLG_OK);
    FLG_DEMAND(flgTangleFileWrite(path, &history, nullptr) == FLG_OK);
    FLG_DEMAND(contents(path) == first);
    flgTangleFileRelease(again);
    flgTangleFileRelease(file);
    return 0;
}
