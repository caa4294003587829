// SPDX-License-Identifier: MIT
// What ends a command early: one sentence, printed as `filigree: SENTENCE`.
#pragma once

#include <stdexcept>

#include "filigree/filigree.h"

namespace flg::cli {

// Bad input or failed work: exit status 1. The sentence starts with the file it is about.
class InputError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

// Bad usage: exit status 2.
class UsageError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

// Throws InputError with the SDK's sentence, about `subject` (a file).
inline void check(FlgResult result, const std::string& subject) {
    if (result != FLG_OK) throw InputError(subject + ": " + flgErrorGetMessage());
}

}  // namespace flg::cli
