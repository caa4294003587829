// SPDX-License-Identifier: MIT
// Members of a zip archive that may lie behind a prefix.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/file_bytes.h"
#include "io/limits.h"

namespace flg::io {

// A member's content: a view of the archive when it is stored, memory of its own when it was packed.
struct ZipContent {
    ByteBlock owned;
    Bytes bytes;
};

class ZipReader {
public:
    // `file`: the whole file, prefix included; it must outlive the reader. Fails if it has no sound directory.
    explicit ZipReader(Bytes file);

    bool has(std::string_view name) const;
    // Unpacks a member and checks its sum. Fails if there is none of that name, or it holds more than `limit` bytes.
    ZipContent read(std::string_view name, uint64_t limit = max_bytes) const;

private:
    struct Member {
        std::string name;
        uint16_t flags;
        uint16_t method;
        uint32_t crc;
        uint32_t packed_size;
        uint32_t size;
        uint64_t header;  // of the local header, from the start of the file
    };
    const Member* find(std::string_view name) const;

    Bytes file_;
    uint64_t directory_ = 0;  // where it starts: data of members lie before it
    std::vector<Member> members_;
};

}  // namespace flg::io
