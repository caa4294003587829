// SPDX-License-Identifier: MIT
// Which format a picture's file is of, by how it begins.
#pragma once

#include <algorithm>
#include <array>

#include "io/base/files.h"

namespace flg::io {

inline bool is_png(Bytes file) {
    constexpr std::array<uint8_t, 4> begin = {0x89, 'P', 'N', 'G'};
    return file.size() > begin.size() && std::equal(begin.begin(), begin.end(), file.begin());
}

inline bool is_jpeg(Bytes file) {
    constexpr std::array<uint8_t, 3> begin = {0xff, 0xd8, 0xff};
    return file.size() > begin.size() && std::equal(begin.begin(), begin.end(), file.begin());
}

}  // namespace flg::io
