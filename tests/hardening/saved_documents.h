// SPDX-License-Identifier: MIT
// Documents in two versions, whose saves the tests cut short.
#pragma once

#ifdef FLG_WITH_IO
#include <functional>
#include <span>
#include <string>

#include "filigree/filigree.h"

namespace flg::test {

// Saves one of two versions of a document, and reads whatever is there now: its bits, or why it can't be read.
struct Document {
    const char* name;
    std::function<FlgResult(const std::string& path, uint32_t version)> save;
    std::function<std::string(const std::string& path)> load;
};

std::span<const Document> documents();

// Of a test.
std::string name_of(const Document& document);

void PrintTo(const Document& document, std::ostream* out);

}  // namespace flg::test
#endif
