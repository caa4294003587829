// SPDX-License-Identifier: MIT
// Files: read whole into memory, written whole or not at all.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "io/base/limits.h"

namespace flg::io {

using Bytes = std::span<const uint8_t>;

// Bytes with their memory; not cleared when made.
class ByteBlock {
public:
    ByteBlock() = default;
    explicit ByteBlock(size_t size) : data_(std::make_unique_for_overwrite<uint8_t[]>(size)), size_(size) {}
    uint8_t* data() { return data_.get(); }
    size_t size() const { return size_; }
    Bytes bytes() const { return {data_.get(), size_}; }

private:
    std::unique_ptr<uint8_t[]> data_;
    size_t size_ = 0;
};

// Reads a regular file of at most `limit` bytes. `place` is what failures name.
ByteBlock read_file(const std::filesystem::path& path, const std::string& place, uint64_t limit = max_bytes);

inline std::string_view as_text(Bytes bytes) {
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

// Writes a temporary file beside `name`, or beside what it links to, and renames it; on failure nothing is left behind
// and all is as it was. Refuses more than max_bytes.
void write_file(const std::filesystem::path& name, std::string_view content);

}  // namespace flg::io
