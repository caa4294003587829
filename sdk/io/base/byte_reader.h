// SPDX-License-Identifier: MIT
// A cursor over little-endian bytes that can't leave them: what is not there is a Failure that names its place.
#pragma once

#include <bit>
#include <cstring>
#include <string_view>

#include "io/base/failure.h"
#include "io/base/files.h"
#include "io/base/memory.h"

namespace flg::io {

static_assert(std::endian::native == std::endian::little, "values are copied as they lie in the file");

class ByteReader {
public:
    // `part` is the part of the file that places name, such as "data.sketch"; "" for the file itself.
    ByteReader(Bytes bytes, std::string_view part, size_t position = 0)
        : bytes_(bytes), part_(part), position_(position) {
        if (position_ > bytes_.size()) fail_end(position, "what should be here");
    }

    size_t position() const { return position_; }
    size_t left() const { return bytes_.size() - position_; }
    String place() const { return byte_place(part_, position_); }

    template <class T>
    T read(const char* what) {
        need(sizeof(T), what);
        T value;
        std::memcpy(&value, bytes_.data() + position_, sizeof value);
        position_ += sizeof value;
        return value;
    }

    // The next bytes, still where they lie.
    Bytes take(uint64_t count, const char* what) {
        need(count, what);
        const Bytes taken = bytes_.subspan(position_, count);
        position_ += count;
        return taken;
    }

private:
    void need(uint64_t count, const char* what) const {
        if (count > left()) fail_end(count, what);
    }
    [[noreturn]] void fail_end(uint64_t count, const char* what) const {
        fail(FLG_ERROR_FORMAT, byte_place(part_, std::min(position_, bytes_.size())),
             "ends too early: %s takes %llu bytes, %llu are left", what, static_cast<unsigned long long>(count),
             static_cast<unsigned long long>(position_ > bytes_.size() ? 0 : left()));
    }

    Bytes bytes_;
    std::string_view part_;
    size_t position_;
};

}  // namespace flg::io
