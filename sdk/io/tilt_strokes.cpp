// SPDX-License-Identifier: MIT
// Source: the .tilt format as the painting program's own reader has it (googlevr/tilt-brush c5fb8671, SketchWriter.cs).
// Invariants: a first pass walks over the strokes and checks every count against the bytes that are there; only then is
// memory taken, so that it never exceeds a small multiple of the file. Nothing is returned unless all strokes are sound.
// Conversion: 1 unit = 0.1 m; z is negated (left- to right-handed), with it x and y of quaternions; colours are decoded
// from sRGB; a point's radius is half of size * scale * (m + (1 - m) * pressure).
// Departures: m depends on the brush there, most have 0.1, which is used for all.
#include "io/tilt_strokes.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

#include "io/byte_reader.h"
#include "io/limits.h"
#include "io/tilt_brushes.h"

namespace flg::io {

namespace {

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
constexpr float least_width = 0.1f;  // m: the part of the width that is left without pressure
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
    const std::string place = reader.place();
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

FlgStroke describe(const Stroke& stroke, uint32_t index, const std::vector<std::string>& brushes, Oddities& odd) {
    FlgStroke result = {};
    std::string_view name = "unknown";
    if (stroke.brush < 0 || static_cast<size_t>(stroke.brush) >= brushes.size()) {
        odd.brush_range.add(index);
    } else {
        const std::string& guid = brushes[static_cast<size_t>(stroke.brush)];
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
            data_.radii[point_] = half_width * (least_width + (1.0f - least_width) * pressure);
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

}  // namespace

CurveData read_tilt_strokes(Bytes bytes, const char* part, const std::vector<std::string>& brushes) {
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
    const std::string count_place = reader.place();
    const auto stroke_count = reader.read<int32_t>("the stroke count");
    if (stroke_count < 0 || static_cast<uint64_t>(stroke_count) * smallest_stroke > reader.left()) {
        fail(FLG_ERROR_FORMAT, count_place, "declares %d strokes, but only %zu bytes are left", stroke_count,
             reader.left());
    }

    std::vector<Stroke> strokes;
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
    if (reader.left() != 0) data.warnings.push_back(std::to_string(reader.left()) + " bytes follow the last stroke");
    return data;
}

}  // namespace flg::io
