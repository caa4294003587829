// SPDX-License-Identifier: MIT
// Oddities of a file, counted: one warning a kind, however often it was met.
#pragma once

#include <cstdint>

#include "io/base/memory.h"

namespace flg::io {

// How often one oddity was met, and where first.
struct Tally {
    uint64_t count = 0;
    uint64_t first = 0;
    void add(uint64_t index) {
        if (count++ == 0) first = index;
    }
};

// One sentence a kind of oddity: "2 strokes: <what> (first: stroke 7)"; none for what was never met.
inline void warn(Vector<String>& warnings, const Tally& tally, const String& unit, const char* what) {
    if (tally.count == 0) return;
    const String plural = unit == "vertex" ? "vertices" : unit + "s";
    warnings.push_back(to_text(tally.count) + " " + (tally.count == 1 ? unit : plural) + ": " + what +
                       " (first: " + unit + " " + to_text(tally.first) + ")");
}

}  // namespace flg::io
