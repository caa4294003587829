// SPDX-License-Identifier: MIT
// A prepared style as bytes, to be kept in a file or an asset and loaded without being prepared again.
//
// Little-endian, without padding: the magic "FLGSTYLE", u32 version, u32 0, u64 size of the whole, u64 hash of all that
// follows; then, as StyleBytes lists them in style_file.cpp, counts, measures, the guide, displacement, matching,
// attributes and the graph's jumps, and its caps if it has any. Whatever follows from the rest (destinations, ends of
// curves) is made anew.
// Invariants: the same style gives the same bytes; a loaded style gives the same results, bit by bit. Nothing in the
// bytes is trusted: the hash finds damage, but anyone can make one, so all that a job relies on is checked as if there
// were none: sizes before memory is taken, the graph's order and reach, numbers for being finite.
#pragma once

#include <cstddef>
#include <span>

#include "stylization/style.h"

namespace flg {

size_t style_file_size(const PreparedStyle& style);
// `out` has style_file_size() bytes.
void write_style_file(const PreparedStyle& style, std::span<std::byte> out);
// Fills in an empty style. Throws FLG_ERROR_FORMAT; the sentence says what is wrong. About a millisecond a megabyte.
void read_style_file(std::span<const std::byte> data, PreparedStyle& style, Memory* memory);

// Where things lie, for tests that tamper with them.
constexpr size_t style_file_hash_offset = 24;
constexpr size_t style_file_content_offset = 32;
uint64_t style_file_hash(std::span<const std::byte> content);

}  // namespace flg
