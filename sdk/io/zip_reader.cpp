// SPDX-License-Identifier: MIT
// Source: PKWARE's APPNOTE.TXT 6.3 (zip), RFC 1951 (deflate, by zlib).
// Invariants: nothing is believed before it was compared with the bytes that exist: offsets and sizes lie inside the
// archive, a member's unpacked size fits what deflate can make of its packed bytes, and unpacking stops there.
// Departures: no zip64, no encryption, one disk, methods stored and deflate; sizes come from the directory, so that
// archives with data descriptors can be read. Offsets count from the start of the archive, which is computed from the end
// record, so that prefixes do no harm.
#include "io/zip_reader.h"

#include <zlib.h>

#include <algorithm>
#include <memory>

#include "io/byte_reader.h"
#include "io/limits.h"

namespace flg::io {

namespace {

constexpr uint32_t local_signature = 0x04034b50;
constexpr uint32_t directory_signature = 0x02014b50;
constexpr uint32_t end_signature = 0x06054b50;
constexpr size_t end_record_size = 22;
constexpr size_t longest_comment = 65535;
constexpr uint16_t flag_encrypted = 1;
constexpr uint16_t method_stored = 0;
constexpr uint16_t method_deflate = 8;
// Deflate's shortest code for its longest run: 258 bytes from 2 bits. A little more for the block's header.
constexpr uint64_t deflate_ratio = 1032;
constexpr uint64_t deflate_slack = 1024;

// The end record is found from behind: its comment must end where the file does.
size_t find_end_record(Bytes file) {
    if (file.size() >= end_record_size) {
        const size_t last = file.size() - end_record_size;
        const size_t first = last > longest_comment ? last - longest_comment : 0;
        for (size_t at = last + 1; at-- > first;) {
            uint32_t signature;
            std::memcpy(&signature, file.data() + at, sizeof signature);
            if (signature != end_signature) continue;
            uint16_t comment;
            std::memcpy(&comment, file.data() + at + end_record_size - sizeof comment, sizeof comment);
            if (at + end_record_size + comment == file.size()) return at;
        }
    }
    fail(FLG_ERROR_FORMAT, byte_place("", file.size()), "ends without the end record of a zip archive: cut off?");
}

ByteBlock inflate_member(Bytes packed, uint32_t size, const std::string& place) {
    if (size > packed.size() * deflate_ratio + deflate_slack) {
        fail(FLG_ERROR_FORMAT, place, "can't unpack to the %u bytes it declares: it has %zu packed ones", size,
             packed.size());
    }
    z_stream stream = {};
    if (inflateInit2(&stream, -MAX_WBITS) != Z_OK) throw std::bad_alloc();
    const std::unique_ptr<z_stream, int (*)(z_stream*)> guard(&stream, inflateEnd);
    // One byte more than declared, so that a member which goes on is noticed without being unpacked.
    ByteBlock block(size_t{size} + 1);
    stream.next_in = const_cast<uint8_t*>(packed.data());
    stream.avail_in = static_cast<uInt>(packed.size());
    stream.next_out = block.data();
    stream.avail_out = static_cast<uInt>(block.size());
    const int status = inflate(&stream, Z_FINISH);
    if (stream.total_out > size) {
        fail(FLG_ERROR_FORMAT, place, "unpacks to more than the %u bytes it declares", size);
    }
    if (status == Z_MEM_ERROR) throw std::bad_alloc();
    if (status != Z_STREAM_END) {
        fail(FLG_ERROR_FORMAT, place, "can't be unpacked: %s", stream.msg ? stream.msg : "its packed bytes end early");
    }
    if (stream.total_out != size) {
        fail(FLG_ERROR_FORMAT, place, "unpacks to %lu bytes but declares %u", stream.total_out, size);
    }
    return block;
}

}  // namespace

ZipReader::ZipReader(Bytes file) : file_(file) {
    const size_t end_at = find_end_record(file);
    ByteReader end(file, "", end_at + sizeof end_signature);
    const auto disk = end.read<uint16_t>("the end record");
    const auto directory_disk = end.read<uint16_t>("the end record");
    const auto disk_members = end.read<uint16_t>("the end record");
    const auto member_count = end.read<uint16_t>("the end record");
    const auto directory_size = end.read<uint32_t>("the end record");
    const auto directory_offset = end.read<uint32_t>("the end record");
    if (disk != 0 || directory_disk != 0 || disk_members != member_count) {
        fail(FLG_ERROR_FORMAT, byte_place("", end_at), "is a zip archive of several disks");
    }
    if (uint64_t{directory_size} + directory_offset > end_at) {
        fail(FLG_ERROR_FORMAT, byte_place("", end_at),
             "declares a zip directory of %u bytes at %u, beyond its end record", directory_size, directory_offset);
    }
    const uint64_t base = end_at - directory_size - directory_offset;
    directory_ = end_at - directory_size;

    ByteReader directory(file.first(end_at), "", directory_);
    for (uint32_t i = 0; i < member_count; ++i) {
        const std::string place = directory.place();
        constexpr const char* what = "an entry of the zip directory";
        if (directory.read<uint32_t>(what) != directory_signature) {
            fail(FLG_ERROR_FORMAT, place, "holds no zip directory entry where entry %u of %u should be", i,
                 member_count);
        }
        Member member;
        directory.take(4, what);  // version made by, version needed
        member.flags = directory.read<uint16_t>(what);
        member.method = directory.read<uint16_t>(what);
        directory.take(4, what);  // time, date
        member.crc = directory.read<uint32_t>(what);
        member.packed_size = directory.read<uint32_t>(what);
        member.size = directory.read<uint32_t>(what);
        const auto name_size = directory.read<uint16_t>(what);
        const auto extra_size = directory.read<uint16_t>(what);
        const auto comment_size = directory.read<uint16_t>(what);
        directory.take(8, what);  // disk, internal and external attributes
        member.header = base + directory.read<uint32_t>(what);
        member.name = as_text(directory.take(name_size, "a name in the zip directory"));
        directory.take(uint64_t{extra_size} + comment_size, what);
        members_.push_back(std::move(member));
    }
}

const ZipReader::Member* ZipReader::find(std::string_view name) const {
    const Member* found = nullptr;
    for (const Member& member : members_) {
        if (member.name != name) continue;
        if (found) fail(FLG_ERROR_FORMAT, std::string(name), "is in the archive twice");
        found = &member;
    }
    return found;
}

bool ZipReader::has(std::string_view name) const {
    return find(name) != nullptr;
}

ZipContent ZipReader::read(std::string_view name, uint64_t limit) const {
    const std::string place(name);
    const Member* member = find(name);
    if (!member) fail(FLG_ERROR_FORMAT, place, "is not in the archive");
    if (member->flags & flag_encrypted) fail(FLG_ERROR_FORMAT, place, "is encrypted");
    if (member->size > limit) {
        fail(FLG_ERROR_LIMIT, place, "declares %u bytes, more than the limit of %s", member->size,
             size_text(limit).c_str());
    }
    ByteReader local(file_.first(directory_), "", std::min(member->header, directory_));
    const std::string header_place = local.place();
    if (local.read<uint32_t>("a local zip header") != local_signature) {
        fail(FLG_ERROR_FORMAT, header_place, "holds no zip header where %s should be", place.c_str());
    }
    local.take(22, "a local zip header");  // all that the directory says too
    const auto name_size = local.read<uint16_t>("a local zip header");
    const auto extra_size = local.read<uint16_t>("a local zip header");
    local.take(uint64_t{name_size} + extra_size, "a local zip header");
    const Bytes packed = local.take(member->packed_size, place.c_str());

    ZipContent content;
    if (member->method == method_stored) {
        if (member->size != member->packed_size) {
            fail(FLG_ERROR_FORMAT, place, "is stored but declares %u bytes for its %u", member->size,
                 member->packed_size);
        }
        content.bytes = packed;
    } else if (member->method == method_deflate) {
        content.owned = inflate_member(packed, member->size, place);
        content.bytes = content.owned.bytes().first(member->size);
    } else {
        fail(FLG_ERROR_FORMAT, place, "is packed by method %u; only 0 (stored) and 8 (deflate) are known",
             member->method);
    }
    const uLong crc = crc32_z(crc32_z(0, nullptr, 0), content.bytes.data(), content.bytes.size());
    if (crc != member->crc) {
        fail(FLG_ERROR_FORMAT, place, "is damaged: its check sum is %08lx, not %08x", crc, member->crc);
    }
    return content;
}

}  // namespace flg::io
