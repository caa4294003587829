// SPDX-License-Identifier: MIT
// Which format a picture's file is of, by how it begins; and PNG files as glTF wants them.
#pragma once

#include <algorithm>
#include <array>

#include <string_view>

#include "io/base/files.h"

namespace flg::io {

inline bool is_png(Bytes file) {
    constexpr std::array<uint8_t, 4> begin = {0x89, 'P', 'N', 'G'};
    return file.size() > begin.size() && std::equal(begin.begin(), begin.end(), file.begin());
}

// Without what glTF has its readers pass over, and its validator warns of: colour spaces, shapes of pixels, animation.
// Pixels stay as they are. What is no sound PNG is copied as it is.
inline Vector<uint8_t> plain_png(Bytes file) {
    constexpr std::string_view left_out[] = {"gAMA", "cHRM", "iCCP", "sRGB", "pHYs", "acTL", "fcTL", "fdAT"};
    constexpr size_t signature = 8, around = 12;  // bytes; those of a chunk besides its data
    Vector<uint8_t> plain(file.begin(), file.begin() + static_cast<ptrdiff_t>(std::min(signature, file.size())));
    size_t at = plain.size();
    while (at < file.size()) {
        const Bytes rest = file.subspan(at);
        if (rest.size() < around) break;
        const size_t size = size_t{rest[0]} << 24 | size_t{rest[1]} << 16 | size_t{rest[2]} << 8 | size_t{rest[3]};
        if (size > rest.size() - around) break;
        const std::string_view name = as_text(rest.subspan(4, 4));
        if (std::find(std::begin(left_out), std::end(left_out), name) == std::end(left_out))
            plain.insert(plain.end(), rest.begin(), rest.begin() + static_cast<ptrdiff_t>(size + around));
        at += size + around;
    }
    if (at != file.size()) plain.assign(file.begin(), file.end());
    return plain;
}

inline bool is_jpeg(Bytes file) {
    constexpr std::array<uint8_t, 3> begin = {0xff, 0xd8, 0xff};
    return file.size() > begin.size() && std::equal(begin.begin(), begin.end(), file.begin());
}

}  // namespace flg::io
