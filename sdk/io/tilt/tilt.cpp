// SPDX-License-Identifier: MIT
// Source: the .tilt format as the painting program's own reader has it (googlevr/tilt-brush c5fb8671): a header, a zip
// archive, and in it metadata.json (brushes) and data.sketch (strokes; SketchWriter.cs).
// Names of brushes: the program's brush manifest (Apache-2.0), for the brushes met in real sketches.
#include "io/tilt/tilt.h"

#include <zlib.h>
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <memory>
#include <optional>
#include <string_view>

#include "core/sized_struct.h"
#include "io/base/byte_reader.h"
#include "io/base/failure.h"
#include "io/base/files.h"
#include "io/base/json.h"
#include "io/base/limits.h"

namespace flg::io {

namespace {

// ---- Members of a zip archive that may lie behind a prefix
//
// Source: PKWARE's APPNOTE.TXT 6.3 (zip), RFC 1951 (deflate, by zlib). Invariants: nothing is believed before it was
// compared with the bytes that exist: offsets and sizes lie inside the archive, a member's unpacked size fits what
// deflate can make of its packed bytes, and unpacking stops there. Departures: no zip64, no encryption, one disk,
// methods stored and deflate; sizes come from the directory, so that archives with data descriptors can be read.
// Offsets count from the start of the archive, which is computed from the end record, so that prefixes do no harm.

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
        String name;
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
    Vector<Member> members_;
};

constexpr uint32_t local_signature = 0x04034b50;
constexpr uint32_t directory_signature = 0x02014b50;
constexpr uint32_t end_signature = 0x06054b50;
constexpr size_t end_record_size = 22;
constexpr size_t max_comment = 65535;
constexpr uint16_t flag_encrypted = 1;
constexpr uint16_t method_stored = 0;
constexpr uint16_t method_deflate = 8;
// Deflate's shortest code for its longest run: 258 bytes from 2 bits. A little more for the block's header.
constexpr uint64_t deflate_ratio = 1032;
constexpr uint64_t deflate_slack = 1024;
// Real sketches shrink to a third, their metadata to a tenth. Beyond this much more is made of members than is read.
constexpr uint64_t max_ratio = 64, always_unpacked = uint64_t{32} << 20;

// The end record is found from behind: its comment must end where the file does.
size_t find_end_record(Bytes file) {
    if (file.size() >= end_record_size) {
        const size_t last = file.size() - end_record_size;
        const size_t first = last > max_comment ? last - max_comment : 0;
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

// zlib does not tell the size of what it gives back: it stands before.
constexpr size_t zlib_alignment = alignof(std::max_align_t);
static_assert(zlib_alignment >= sizeof(size_t));

void* take_for_zlib(void*, uInt count, uInt size) {
    try {
        const size_t bytes = zlib_alignment + size_t{count} * size;
        auto* const memory = static_cast<uint8_t*>(take_memory(bytes, zlib_alignment));
        std::memcpy(memory, &bytes, sizeof bytes);
        return memory + zlib_alignment;
    } catch (const std::bad_alloc&) {
        return nullptr;
    }
}

void give_back_for_zlib(void*, void* address) {
    auto* const memory = static_cast<uint8_t*>(address) - zlib_alignment;
    size_t bytes;
    std::memcpy(&bytes, memory, sizeof bytes);
    give_memory_back(memory, bytes, zlib_alignment);
}

ByteBlock inflate_member(Bytes packed, uint32_t size, const String& place) {
    if (size > packed.size() * deflate_ratio + deflate_slack) {
        fail(FLG_ERROR_FORMAT, place, "can't unpack to the %u bytes it declares: it has %zu packed ones", size,
             packed.size());
    }
    if (size > always_unpacked && size > packed.size() * max_ratio) {
        fail(FLG_ERROR_LIMIT, place,
             "declares %u bytes of %zu packed ones, more than %llu for each: no sketch is so empty", size,
             packed.size(), static_cast<unsigned long long>(max_ratio));
    }
    z_stream stream = {};
    stream.zalloc = take_for_zlib;
    stream.zfree = give_back_for_zlib;
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
        const String place = directory.place();
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
        if (found) fail(FLG_ERROR_FORMAT, String(name), "is in the archive twice");
        found = &member;
    }
    return found;
}

bool ZipReader::has(std::string_view name) const {
    return find(name) != nullptr;
}

ZipContent ZipReader::read(std::string_view name, uint64_t limit) const {
    const String place(name);
    const Member* member = find(name);
    if (!member) fail(FLG_ERROR_FORMAT, place, "is not in the archive");
    if (member->flags & flag_encrypted) fail(FLG_ERROR_FORMAT, place, "is encrypted");
    if (member->size > limit) {
        fail(FLG_ERROR_LIMIT, place, "declares %u bytes, more than the limit of %s", member->size,
             size_text(limit).c_str());
    }
    ByteReader local(file_.first(directory_), "", std::min(member->header, directory_));
    const String header_place = local.place();
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

// ---- The list of brushes in the metadata
//
// metadata.json holds much that isn't needed. Only BrushIndex, an array of strings in the root object, is kept while
// the text is parsed: a document of everything takes many times the text's size, and hostile text packs well.

constexpr size_t max_brushes = size_t{1} << 16;
constexpr uint32_t max_depth = 256;
constexpr std::string_view index_name = "BrushIndex";

// GUIDs of the brushes that strokes name by number. `part`: the metadata's name within the sketch, for failures.
Vector<String> read_brush_index(Bytes metadata, const String& part) {
    const JsonDocument document(metadata, max_depth, part, index_name);
    const Json* const index = document.root().find(index_name);
    if (!index) fail(FLG_ERROR_FORMAT, part, "has no BrushIndex");
    const String place = (part + ".").append(index_name);
    if (!index->is_array()) fail(FLG_ERROR_FORMAT, place, "is no array");
    if (index->size() > max_brushes) fail(FLG_ERROR_LIMIT, place, "has more than 65536 brushes");
    Vector<String> guids;
    for (size_t i = 0; i < index->size(); ++i) {
        if (!(*index)[i].is_string()) fail(FLG_ERROR_FORMAT, place + "[" + to_text(i) + "]", "is no string");
        guids.emplace_back((*index)[i].string());
    }
    return guids;
}

// ---- Names of brushes

struct Brush {
    std::string_view guid;
    std::string_view name;
};

constexpr Brush known_brushes[] = {
    {"0077f88c-d93a-42f3-b59b-b31c50cdb414", "Taffy"},
    {"02ffb866-7fb2-4d15-b761-1012cefb1360", "Embers"},
    {"0d3889f3-3ede-470c-8af4-de4813306126", "DoubleTaperedMarker"},
    {"0d3889f3-3ede-470c-8af4-f44813306126", "DoubleTaperedFlat"},
    {"0eb4db27-3f82-408d-b5a1-19ebd7d5b711", "Stars"},
    {"0f0ff7b2-a677-45eb-a7d6-0cd7206f4816", "ChromaticWave"},
    {"10201aa3-ebc2-42d8-84b7-2e63f6eeb8ab", "Waveform"},
    {"2241cd32-8ba2-48a5-9ee7-2caef7e9ed62", "Light"},
    {"280c0a7a-aad8-416c-a7d2-df63d129ca70", "Flat"},
    {"2f212815-f4d3-c1a4-681a-feeaf9c6dc37", "Icing"},
    {"3ca16e2f-bdcd-4da2-8631-dcef342f40f1", "DuctTape"},
    {"429ed64a-4e97-4466-84d3-145a861ef684", "Marker"},
    {"4391385a-cf83-4396-9e33-31e4e4930b27", "Wire"},
    {"4391385a-df73-4396-9e33-31e4e4930b27", "Toon"},
    {"4391aaaa-df73-4396-9e33-31e4e4930b27", "Disco"},
    {"4391aaaa-df81-4396-9e33-31e4e4930b27", "LightWire"},
    {"44bb800a-fbc3-4592-8426-94ecb05ddec3", "Streamers"},
    {"55303bc4-c749-4a72-98d9-d23e68e76e18", "FlatDeprecated"},
    {"6a1cf9f9-032c-45ec-9b1d-a6680bee30f7", "Dots"},
    {"6a1cf9f9-032c-45ec-9b6e-a6680bee32e9", "HyperGrid"},
    {"700f3aa8-9a7c-2384-8b8a-ea028905dd8c", "CelVinyl"},
    {"70d79cca-b159-4f35-990c-f02193947fe8", "Smoke"},
    {"759f1ebd-20cd-4720-8d41-234e0da63716", "Paper"},
    {"79168f10-6961-464a-8be1-57ed364c5600", "CoarseBristles"},
    {"7a1c8107-50c5-4b70-9a39-421576d6617e", "Splatter"},
    {"89d104cd-d012-426b-b5b3-bbaee63ac43c", "Bubbles"},
    {"accb32f5-4509-454f-93f8-1df3fd31df1b", "SoftHighlighter"},
    {"ad1ad437-76e2-450d-a23a-e17f8310b960", "Rainbow"},
    {"b2ffef01-eaaa-4ab5-aa64-95a2c4f5dbc6", "NeonPulse"},
    {"c0012095-3ffd-4040-8ee1-fc180d346eaa", "Ink"},
    {"c33714d1-b2f9-412e-bd50-1884c9d46336", "Plasma"},
    {"c515dad7-4393-4681-81ad-162ef052241b", "OilPaint"},
    {"c8ccb53d-ae13-45ef-8afb-b730d81394eb", "TaperedFlat"},
    {"cb92b597-94ca-4255-b017-0e3f42f12f9e", "Fire"},
    {"cf019139-d41c-4eb0-a1d0-5cf54b0a42f3", "Highlighter"},
    {"d229d335-c334-495a-a801-660ac8a87360", "VelvetInk"},
    {"d902ed8b-d0d1-476c-a8de-878a79e3a34c", "Snow"},
    {"d90c6ad8-af0f-4b54-b422-e0f92abe1b3c", "TaperedMarker"},
    {"e8ef32b1-baa8-460a-9c2c-9cf8506794f5", "Hypercolor"},
    {"ea19de07-d0c0-4484-9198-18489a3c1487", "Leaves"},
    {"f6e85de3-6dcc-4e7f-87fd-cee8c3d25d51", "Electricity"},
    {"fdf0326a-c0d1-4fed-b101-9db0ff6d071f", "ThickPaint"},
};

// The name that the painting program gives to a brush, or "" if its GUID (lower case, no braces) is not known.
std::string_view tilt_brush_name(std::string_view guid) {
    for (const Brush& brush : known_brushes) {
        if (brush.guid == guid) return brush.name;
    }
    return {};
}

// ---- Strokes (data.sketch)
//
// Invariants: a first pass walks over the strokes and checks every count against the bytes that are there; only then is
// memory taken, so that it never exceeds a small multiple of the file. Nothing is returned unless all strokes are
// sound. Conversion: 1 unit = 0.1 m; z is negated (left- to right-handed), with it x and y of quaternions; colours are
// decoded from sRGB; a point's radius is half of size * scale * (m + (1 - m) * pressure). Departures: m depends on the
// brush there, most have 0.1, which is used for all.

constexpr uint32_t sentinel = 0xc576a5cd;
constexpr int32_t oldest_version = 5;
constexpr int32_t newest_version = 6;
constexpr uint32_t smallest_stroke = 36;  // bytes: its fixed part and its point count

constexpr uint32_t stroke_flags = 0x1;
constexpr uint32_t stroke_scale = 0x2;
constexpr uint32_t stroke_group = 0x4;
constexpr uint32_t stroke_known = 0x3f;  // seed, layer and frame are known, and of no use here
constexpr int last_fixed_bit = 15;       // extensions above it say their length themselves
constexpr uint32_t point_pressure = 0x1;
constexpr uint32_t point_time = 0x2;
constexpr uint32_t point_known = 0x3;

constexpr uint32_t position_floats = 3;
constexpr uint32_t orientation_floats = 4;
constexpr float metres_per_unit = 0.1f;
constexpr float min_width = 0.1f;  // m: the part of the width that is left without pressure
constexpr float milliseconds = 1000.0f;
// How far a quaternion's squared length may be from 1 before it is normalized; sound files stay within 1e-5.
constexpr float unit_tolerance = 1e-3f;

struct Stroke {
    int32_t brush;
    float color[4];
    float size;
    float scale = 1.0f;
    uint32_t flags = 0;
    uint32_t group = 0;
    uint32_t stroke_mask;
    uint32_t point_mask;
    uint32_t point_count;
    uint32_t point_words;  // of 4 bytes
    size_t points_at;      // from the start of the bytes
};

struct Oddities {
    Tally empty, brush_range, brush_unknown, stroke_bits, point_bits, color, time, no_time, pressure, orientation;
};

float srgb_to_linear(float value) {
    constexpr float linear_end = 0.04045f;
    return value <= linear_end ? value / 12.92f : std::pow((value + 0.055f) / 1.055f, 2.4f);
}

Stroke read_stroke_header(ByteReader& reader, uint32_t index) {
    constexpr const char* what = "a stroke";
    const String place = reader.place();
    Stroke stroke;
    stroke.brush = reader.read<int32_t>(what);
    for (float& channel : stroke.color) channel = reader.read<float>(what);
    stroke.size = reader.read<float>(what);
    stroke.stroke_mask = reader.read<uint32_t>(what);
    stroke.point_mask = reader.read<uint32_t>(what);
    for (uint32_t mask = stroke.stroke_mask; mask != 0; mask &= mask - 1) {
        const int bit = std::countr_zero(mask);
        if (bit > last_fixed_bit) {
            reader.take(reader.read<uint32_t>("a stroke extension"), "a stroke extension");
            continue;
        }
        const auto value = reader.read<uint32_t>("a stroke extension");
        if (bit == std::countr_zero(stroke_flags)) stroke.flags = value;
        if (bit == std::countr_zero(stroke_scale)) stroke.scale = std::bit_cast<float>(value);
        if (bit == std::countr_zero(stroke_group)) stroke.group = value;
    }
    const auto point_count = reader.read<int32_t>("a point count");
    if (point_count < 0) fail(FLG_ERROR_FORMAT, place, "stroke %u declares %d points", index, point_count);
    stroke.point_count = static_cast<uint32_t>(point_count);
    stroke.point_words = position_floats + orientation_floats + static_cast<uint32_t>(std::popcount(stroke.point_mask));
    stroke.points_at = reader.position();
    const uint64_t bytes = uint64_t{stroke.point_count} * stroke.point_words * sizeof(float);
    if (bytes > reader.left()) {
        fail(FLG_ERROR_FORMAT, place, "stroke %u declares %u points of %zu bytes, but %zu bytes are left", index,
             stroke.point_count, stroke.point_words * sizeof(float), reader.left());
    }
    reader.take(bytes, "points");

    for (float channel : stroke.color) {
        if (!std::isfinite(channel)) {
            fail(FLG_ERROR_FORMAT, place, "stroke %u has a colour of %g", index, double{channel});
        }
    }
    const float width = stroke.size * stroke.scale;
    if (!(stroke.size >= 0) || !(stroke.scale >= 0) || !(width <= max_coordinate)) {
        fail(FLG_ERROR_FORMAT, place, "stroke %u has the size %g at scale %g", index, double{stroke.size},
             double{stroke.scale});
    }
    return stroke;
}

FlgStroke describe(const Stroke& stroke, uint32_t index, const Vector<String>& brushes, Oddities& odd) {
    auto result = sized<FlgStroke>();
    std::string_view name = "unknown";
    if (stroke.brush < 0 || static_cast<size_t>(stroke.brush) >= brushes.size()) {
        odd.brush_range.add(index);
    } else {
        const String& guid = brushes[static_cast<size_t>(stroke.brush)];
        name = tilt_brush_name(guid);
        if (name.empty()) {
            odd.brush_unknown.add(index);
            name = guid;
        }
    }
    name.copy(result.brush, sizeof result.brush - 1);
    result.size = stroke.size * stroke.scale * metres_per_unit;
    result.group = stroke.group;
    result.flags = stroke.flags;
    return result;
}

// Appends the columns' values of one stroke's points.
class PointReader {
public:
    PointReader(CurveData& data, Bytes bytes, const char* part, Oddities& odd)
        : data_(data), bytes_(bytes), part_(part), odd_(odd) {}

    void read(const Stroke& stroke, uint32_t index, FlgStroke& description) {
        float color[4];
        bool clamped = false;
        for (int i = 0; i < 4; ++i) {
            const float value = std::clamp(stroke.color[i], 0.0f, 1.0f);
            clamped |= value != stroke.color[i];
            color[i] = i < 3 ? srgb_to_linear(value) : value;
        }
        if (clamped) odd_.color.add(index);
        const float half_width = 0.5f * stroke.size * stroke.scale * metres_per_unit;
        const bool has_pressure = stroke.point_mask & point_pressure;
        const bool has_time = stroke.point_mask & point_time;
        const size_t time_word = position_floats + orientation_floats + (has_pressure ? 1 : 0);
        uint32_t first_ms = 0;
        uint32_t last_ms = 0;
        bool backwards = false, all_zero = true, pressure_odd = false, orientation_odd = false;

        for (uint32_t i = 0; i < stroke.point_count; ++i, ++point_) {
            const size_t at = stroke.points_at + size_t{i} * stroke.point_words * sizeof(float);
            float words[position_floats + orientation_floats + 2];
            std::memcpy(words, bytes_.data() + at, std::min<size_t>(stroke.point_words * sizeof(float), sizeof words));
            read_position(words, at);
            orientation_odd |= read_orientation(words + position_floats, at);

            float pressure = has_pressure ? words[position_floats + orientation_floats] : 1.0f;
            if (!(pressure >= 0 && pressure <= 1)) {
                if (!std::isfinite(pressure)) refuse(at, "pressure", pressure);
                pressure = std::clamp(pressure, 0.0f, 1.0f);
                pressure_odd = true;
            }
            data_.pressures[point_] = pressure;
            data_.radii[point_] = half_width * (min_width + (1.0f - min_width) * pressure);
            std::memcpy(&data_.colors[point_ * 4], color, sizeof color);

            const uint32_t ms = has_time ? std::bit_cast<uint32_t>(words[time_word]) : 0;
            if (i == 0) first_ms = last_ms = ms;
            backwards |= ms < last_ms;
            all_zero &= ms == 0;
            last_ms = ms;
            data_.times[point_] = static_cast<float>(int64_t{ms} - int64_t{first_ms}) / milliseconds;
        }
        description.start_ms = first_ms;
        if (backwards) odd_.time.add(index);
        if (all_zero) odd_.no_time.add(index);
        if (pressure_odd) odd_.pressure.add(index);
        if (orientation_odd) odd_.orientation.add(index);
    }

private:
    [[noreturn]] void refuse(size_t at, const char* what, float value) const {
        fail(FLG_ERROR_FORMAT, byte_place(part_, at), "a %s of %g: points must be finite, and at most 1e30 m in size",
             what, double{value});
    }

    void read_position(const float* words, size_t at) {
        float* out = &data_.positions[point_ * position_floats];
        for (uint32_t i = 0; i < position_floats; ++i) {
            out[i] = words[i] * metres_per_unit;
            if (!(std::abs(out[i]) <= max_coordinate)) refuse(at, "position", words[i]);
        }
        out[2] = -out[2];
    }

    // Returns whether it had to be made a unit quaternion.
    bool read_orientation(const float* words, size_t at) {
        float* out = &data_.orientations[point_ * orientation_floats];
        float squared = 0;
        for (uint32_t i = 0; i < orientation_floats; ++i) {
            if (!std::isfinite(words[i])) refuse(at, "orientation", words[i]);
            out[i] = i < 2 ? -words[i] : words[i];
            squared += words[i] * words[i];
        }
        if (std::abs(squared - 1.0f) <= unit_tolerance) return false;
        const double length =
            std::hypot(std::hypot(double{out[0]}, double{out[1]}), std::hypot(double{out[2]}, double{out[3]}));
        // None at all: the identity.
        if (length == 0)
            out[3] = 1.0f;
        else
            for (uint32_t i = 0; i < orientation_floats; ++i) out[i] = static_cast<float>(out[i] / length);
        return true;
    }

    CurveData& data_;
    Bytes bytes_;
    const char* part_;
    Oddities& odd_;
    size_t point_ = 0;
};

void report(const Oddities& odd, CurveData& data) {
    data.warn(odd.empty, "stroke", "no points, left out");
    data.warn(odd.brush_range, "stroke", "the brush's number is not in BrushIndex");
    data.warn(odd.brush_unknown, "stroke", "the brush is not known by name");
    data.warn(odd.stroke_bits, "stroke", "unknown stroke extensions, skipped");
    data.warn(odd.point_bits, "stroke", "unknown point extensions, skipped");
    data.warn(odd.color, "stroke", "the colour is not within 0 to 1, clamped");
    data.warn(odd.time, "stroke", "time stamps run backwards");
    data.warn(odd.no_time, "stroke", "time stamps are all 0");
    data.warn(odd.pressure, "stroke", "pressures are not within 0 to 1, clamped");
    data.warn(odd.orientation, "stroke", "orientations are no unit quaternions, normalized");
}

// `part` is what failures name, `brushes` the GUIDs that strokes refer to. The result is in metres and right-handed.
CurveData read_tilt_strokes(Bytes bytes, const char* part, const Vector<String>& brushes) {
    ByteReader reader(bytes, part);
    if (const auto found = reader.read<uint32_t>("the sentinel"); found != sentinel) {
        fail(FLG_ERROR_FORMAT, byte_place(part, 0), "holds no strokes: starts with %08x, not %08x", found, sentinel);
    }
    const auto version = reader.read<int32_t>("the version");
    if (version < oldest_version || version > newest_version) {
        fail(FLG_ERROR_FORMAT, byte_place(part, 4), "has the version %d; only %d and %d are known", version,
             oldest_version, newest_version);
    }
    reader.read<int32_t>("the header");
    reader.take(reader.read<uint32_t>("the header"), "the header's further bytes");
    const String count_place = reader.place();
    const auto stroke_count = reader.read<int32_t>("the stroke count");
    if (stroke_count < 0 || static_cast<uint64_t>(stroke_count) * smallest_stroke > reader.left()) {
        fail(FLG_ERROR_FORMAT, count_place, "declares %d strokes, but only %zu bytes are left", stroke_count,
             reader.left());
    }

    Vector<Stroke> strokes;
    strokes.reserve(static_cast<size_t>(stroke_count));
    size_t point_count = 0;
    Oddities odd;
    for (uint32_t i = 0; i < static_cast<uint32_t>(stroke_count); ++i) {
        strokes.push_back(read_stroke_header(reader, i));
        point_count += strokes.back().point_count;
        if (strokes.back().stroke_mask & ~stroke_known) odd.stroke_bits.add(i);
        if (strokes.back().point_mask & ~point_known) odd.point_bits.add(i);
    }

    CurveData data;
    data.format = "tilt";
    data.units = "decimetres, left-handed";
    data.positions.resize(point_count * position_floats);
    data.radii.resize(point_count);
    data.colors.resize(point_count * 4);
    data.times.resize(point_count);
    data.pressures.resize(point_count);
    data.orientations.resize(point_count * orientation_floats);
    PointReader points(data, bytes, part, odd);
    uint32_t end = 0;
    for (uint32_t i = 0; i < strokes.size(); ++i) {
        if (strokes[i].point_count == 0) {
            odd.empty.add(i);
            continue;
        }
        data.strokes.push_back(describe(strokes[i], i, brushes, odd));
        points.read(strokes[i], i, data.strokes.back());
        end += strokes[i].point_count;
        data.offsets.push_back(end);
        data.flags.push_back(0);
    }
    report(odd, data);
    if (data.strokes.empty()) data.warnings.push_back("the sketch holds no strokes");
    if (reader.left() != 0) data.warnings.push_back(to_text(reader.left()) + " bytes follow the last stroke");
    return data;
}

constexpr uint32_t magic = 0x546c6974;  // "tilT"
constexpr uint16_t smallest_header = 16;
constexpr uint16_t known_version = 1;
constexpr uint32_t zip_start = 0x04034b50;  // "PK\3\4"
constexpr const char* strokes_name = "data.sketch";
constexpr const char* metadata_name = "metadata.json";
constexpr const char* old_metadata_name = "main.json";  // of pre-release files

CurveData read_directory(const Path& path) {
    const ByteBlock strokes = read_file(path.within(strokes_name), strokes_name);
    const char* name = file_exists(path.within(metadata_name)) || !file_exists(path.within(old_metadata_name))
                           ? metadata_name
                           : old_metadata_name;
    const ByteBlock metadata = read_file(path.within(name), name, max_metadata_bytes);
    return read_tilt_strokes(strokes.bytes(), strokes_name, read_brush_index(metadata.bytes(), name));
}

CurveData read_archive(const Path& path) {
    const ByteBlock file = read_file(path, "");
    ByteReader header(file.bytes(), "");
    if (const auto found = header.read<uint32_t>("the header"); found != magic) {
        fail(FLG_ERROR_FORMAT, "@0", "is no .tilt sketch: starts with %08x, not with 'tilT'", found);
    }
    const auto header_size = header.read<uint16_t>("the header");
    if (header_size < smallest_header) {
        fail(FLG_ERROR_FORMAT, "@4", "declares a header of %u bytes; the smallest is %u", header_size, smallest_header);
    }
    if (const auto version = header.read<uint16_t>("the header"); version != known_version) {
        fail(FLG_ERROR_FORMAT, "@6", "has the header version %u; only %u is known", version, known_version);
    }
    header.take(header_size - header.position(), "the header");
    const String zip_place = header.place();
    if (header.read<uint32_t>("a zip archive") != zip_start) {
        fail(FLG_ERROR_FORMAT, zip_place, "holds no zip archive behind its header");
    }
    const ZipReader zip(file.bytes());
    const char* name = !zip.has(metadata_name) && zip.has(old_metadata_name) ? old_metadata_name : metadata_name;
    const ZipContent metadata = zip.read(name, max_metadata_bytes);
    const ZipContent strokes = zip.read(strokes_name);
    return read_tilt_strokes(strokes.bytes, strokes_name, read_brush_index(metadata.bytes, name));
}

}  // namespace

CurveData read_tilt(const Path& path) {
    return is_folder(path, strokes_name) ? read_directory(path) : read_archive(path);
}

}  // namespace flg::io
