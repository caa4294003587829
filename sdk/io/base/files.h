// SPDX-License-Identifier: MIT
// Files: read whole into memory, written whole or not at all; by the host's functions, or by the operating system's.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "filigree/filigree_io.h"
#include "io/base/limits.h"
#include "io/base/memory.h"

namespace flg::io {

using Bytes = std::span<const uint8_t>;

// Bytes with their memory; not cleared when made.
class ByteBlock {
public:
    ByteBlock() = default;
    explicit ByteBlock(size_t size) : size_(size) {
        if (size_ != 0) data_ = static_cast<uint8_t*>(take_memory(size_, 1));
    }
    ByteBlock(ByteBlock&& other) noexcept
        : data_(std::exchange(other.data_, nullptr)), size_(std::exchange(other.size_, 0)) {}
    ByteBlock& operator=(ByteBlock&& other) noexcept {
        std::swap(data_, other.data_);
        std::swap(size_, other.size_);
        return *this;
    }
    ~ByteBlock() {
        if (data_) give_memory_back(data_, size_, 1);
    }
    uint8_t* data() { return data_; }
    size_t size() const { return size_; }
    Bytes bytes() const { return {data_, size_}; }

private:
    uint8_t* data_ = nullptr;
    size_t size_ = 0;
};

// Where a file is: a name in UTF-8, and the file system that knows it.
class Path {
public:
    // `host`: the host's functions; null: the operating system's.
    Path(String name, const FlgFileSystem* host);

    const String& name() const { return name_; }
    const FlgFileSystem* host() const { return host_; }
    std::string_view filename() const;
    String extension() const;  // in lower case, with its dot
    // Another file, by its path from this one's folder.
    Path beside(std::string_view file) const;
    // A file in this folder.
    Path within(std::string_view file) const;

private:
    String name_;
    const FlgFileSystem* host_;
};

// Reads a regular file of at most `limit` bytes. `place` is what failures name.
ByteBlock read_file(const Path& path, const String& place, uint64_t limit = max_bytes);

inline std::string_view as_text(Bytes bytes) {
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

// Writes a file whole or not at all (core/saved_file.h). The host's functions see to that themselves.
class FileWriter {
public:
    explicit FileWriter(const Path& path);
    ~FileWriter();
    FileWriter(const FileWriter&) = delete;
    FileWriter& operator=(const FileWriter&) = delete;

    // What comes next. drain() lets it leave once it is long.
    String text;
    void drain() {
        if (text.size() >= drained_bytes) write_out();
    }
    // After the text.
    void append(std::string_view content);
    void finish();

private:
    static constexpr size_t drained_bytes = size_t{1} << 16;
    class Target;
    void write_out();

    Owned<Target> target_;
};

// The same of content that is there as a whole. Refuses more than max_bytes.
void write_file(const Path& path, std::string_view content);

bool file_exists(const Path& path);

// Whether `path` is a folder; for the host's functions, which know none: whether `file` is below it, and nothing at it.
bool is_folder(const Path& path, std::string_view file);

// Where a file is after all links; for the host's functions the path itself.
Path resolved(const Path& path);

// Whether `path` has no links that lead out of the folder of `document`; for the host's functions: yes.
bool stays_beside(const Path& path, const Path& document);

// The names of the files beside the one at `path` that begin with its name and are ten minutes older; none for the
// host's functions, which list no folders, nor where no file is.
Vector<String> older_companions(const Path& path);

// Without a word if it cannot.
void remove_file(const Path& path);

}  // namespace flg::io
