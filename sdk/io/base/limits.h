// SPDX-License-Identifier: MIT
// The limits that filigree_io.h and filigree.h state.
#pragma once

#include <cstdint>

#include "io/base/memory.h"

namespace flg::io {

// Of a file, of what is unpacked from it, and of what is made of it: hostile files must not fill the machine.
constexpr uint64_t max_bytes = uint64_t{1} << 31;
// Of a sketch's metadata, which real sketches need some kilobytes for.
constexpr uint64_t max_metadata_bytes = uint64_t{16} << 20;
constexpr uint64_t max_points = uint64_t{1} << 31;
// A limit in a sentence: whole GiB or MiB.
inline String size_text(uint64_t bytes) {
    constexpr int mib = 20, gib = 30;
    return bytes >> gib != 0 ? to_text(bytes >> gib) + " GiB" : to_text(bytes >> mib) + " MiB";
}
// Positions and radii, in size; beyond it squares overflow in float.
constexpr float max_coordinate = 1e30f;
// Metres; of curves that have no radius where others of the file have one, and of FlgCurveFileWriteDesc.
constexpr float default_radius = 0.005f;

}  // namespace flg::io
