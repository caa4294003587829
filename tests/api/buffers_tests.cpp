// SPDX-License-Identifier: MIT
// Results into the host's buffers: what is written, what is not touched, what is refused.
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <random>

#include "api/part_inputs.h"
#include "api/surface_inputs.h"
#include "filigree/filigree_buffers.h"

namespace flg::test {
namespace {

constexpr float inf = std::numeric_limits<float>::infinity();
constexpr float nan = std::numeric_limits<float>::quiet_NaN();
constexpr unsigned char untouched = 0xcd;
constexpr FlgAttribute user = FLG_ATTRIBUTE_USER;

FlgBufferColumn column_to(FlgAttribute attribute, FlgNumberFormat format, void* data, uint32_t stride = 0,
                          uint32_t components = 0) {
    FlgBufferColumn column = {};
    column.attribute = attribute;
    column.format = format;
    column.data = data;
    column.stride = stride;
    column.components = components;
    return column;
}

FlgBufferOutput output_of(const std::vector<FlgBufferColumn>& columns, uint64_t capacity) {
    FlgBufferOutput output = flgBufferOutputDefaults();
    output.columns = columns.data();
    output.column_count = static_cast<uint32_t>(columns.size());
    output.row_capacity = capacity;
    return output;
}

// One column of the host's own numbers, written in a format.
template <class Number>
std::vector<Number> written(const std::vector<float>& values, FlgNumberFormat format, FlgAttribute attribute = user) {
    const FlgColumn from = {attribute, 1, values.data(), 0, 0};
    std::vector<Number> numbers(values.size());
    const std::vector<FlgBufferColumn> to = {column_to(attribute, format, numbers.data())};
    const FlgBufferOutput output = output_of(to, numbers.size());
    FlgColumnsWriteDesc desc = flgColumnsWriteDefaults();
    desc.columns = &from;
    desc.column_count = 1;
    desc.row_count = static_cast<uint32_t>(values.size());
    desc.output = &output;
    EXPECT_EQ(flgColumnsWrite(&desc), FLG_OK) << flgErrorGetMessage();
    return numbers;
}

TEST(Buffers, EndsOfEveryFormat) {
    const std::vector<float> values = {0, 1, -1, 2, -2, inf, -inf, nan, 0.5f, -0.5f};
    using V8 = std::vector<uint8_t>;
    using S8 = std::vector<int8_t>;
    using V16 = std::vector<uint16_t>;
    using S16 = std::vector<int16_t>;
    EXPECT_EQ(written<uint8_t>(values, FLG_NUMBER_FORMAT_UNORM8), (V8{0, 255, 0, 255, 0, 255, 0, 0, 128, 0}));
    EXPECT_EQ(written<uint16_t>(values, FLG_NUMBER_FORMAT_UNORM16),
              (V16{0, 65535, 0, 65535, 0, 65535, 0, 0, 32768, 0}));
    EXPECT_EQ(written<int8_t>(values, FLG_NUMBER_FORMAT_SNORM8),
              (S8{0, 127, -127, 127, -127, 127, -127, -127, 64, -63}));
    EXPECT_EQ(written<int16_t>(values, FLG_NUMBER_FORMAT_SNORM16),
              (S16{0, 32767, -32767, 32767, -32767, 32767, -32767, -32767, 16384, -16383}));
    EXPECT_EQ(written<uint16_t>(values, FLG_NUMBER_FORMAT_FLOAT16),
              (V16{0, 0x3c00, 0xbc00, 0x4000, 0xc000, 0x7bff, 0xfbff, 0xfbff, 0x3800, 0xb800}));
}

TEST(Buffers, NumbersThatAFormatHoldsAreExact) {
    std::vector<float> values;
    for (int i = 0; i <= 65535; ++i) values.push_back(static_cast<float>(i) / 65535.0f);
    const std::vector<uint16_t> wide = written<uint16_t>(values, FLG_NUMBER_FORMAT_UNORM16);
    for (size_t i = 0; i < wide.size(); ++i) ASSERT_EQ(wide[i], i);
    values.clear();
    for (int i = -32767; i <= 32767; ++i) values.push_back(static_cast<float>(i) / 32767.0f);
    const std::vector<int16_t> with_sign = written<int16_t>(values, FLG_NUMBER_FORMAT_SNORM16);
    for (size_t i = 0; i < with_sign.size(); ++i) ASSERT_EQ(with_sign[i], static_cast<int>(i) - 32767);
    values.clear();
    for (int e = -24; e <= 15; ++e) values.push_back(std::ldexp(1.0f, e));
    const std::vector<uint16_t> halves = written<uint16_t>(values, FLG_NUMBER_FORMAT_FLOAT16);
    for (int e = -24; e <= 15; ++e)
        ASSERT_EQ(halves[static_cast<size_t>(e + 24)], e < -14 ? 1 << (e + 24) : (e + 15) << 10) << e;
}

// Rows of one column, all their components in the format.
template <class Number>
std::vector<Number> written_rows(const std::vector<float>& values, uint32_t components, FlgAttribute attribute,
                                 FlgNumberFormat format, uint32_t numbers_a_row) {
    const FlgColumn from = {attribute, components, values.data(), 0, 0};
    const auto rows = static_cast<uint32_t>(values.size() / components);
    std::vector<Number> numbers(size_t{rows} * numbers_a_row);
    const std::vector<FlgBufferColumn> to = {column_to(attribute, format, numbers.data())};
    const FlgBufferOutput output = output_of(to, rows);
    FlgColumnsWriteDesc desc = flgColumnsWriteDefaults();
    desc.columns = &from;
    desc.column_count = 1;
    desc.row_count = rows;
    desc.output = &output;
    EXPECT_EQ(flgColumnsWrite(&desc), FLG_OK) << flgErrorGetMessage();
    return numbers;
}

TEST(Buffers, OctahedralDirectionsPointWhereTheyDid) {
    std::mt19937 random(7);
    std::normal_distribution<float> normal;
    std::vector<float> values = {1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1, 1, 1, 0, 1, -1, -1e-6f};
    for (int i = 0; i < 30000; ++i) values.push_back(100 * normal(random));
    const std::vector<int16_t> packed =
        written_rows<int16_t>(values, 3, FLG_ATTRIBUTE_NORMAL, FLG_NUMBER_FORMAT_OCTAHEDRAL16, 2);
    for (size_t row = 0; row < values.size() / 3; ++row) {
        const double x = packed[2 * row] / 32767.0, y = packed[2 * row + 1] / 32767.0;
        double back[3] = {x, y, 1 - std::abs(x) - std::abs(y)};
        if (back[2] < 0) {
            back[0] = std::copysign(1 - std::abs(y), x);
            back[1] = std::copysign(1 - std::abs(x), y);
        }
        const float* const d = &values[3 * row];
        const double cross[3] = {d[1] * back[2] - d[2] * back[1], d[2] * back[0] - d[0] * back[2],
                                 d[0] * back[1] - d[1] * back[0]};
        const double dot = d[0] * back[0] + d[1] * back[1] + d[2] * back[2];
        ASSERT_LT(std::atan2(std::hypot(cross[0], cross[1], cross[2]), dot), 7e-5) << row;
    }
    EXPECT_EQ(written_rows<int16_t>({0, 0, 0}, 3, FLG_ATTRIBUTE_TANGENT, FLG_NUMBER_FORMAT_OCTAHEDRAL16, 2),
              (std::vector<int16_t>{0, 0}));
}

TEST(Buffers, SrgbBytesAreTheNearest) {
    std::vector<float> values;
    for (int i = 0; i <= 400000; ++i) values.push_back(static_cast<float>(i) / 400000);
    for (int e = -149; e < 0; ++e) values.push_back(std::ldexp(1.0f, e));
    while (values.size() % 4 != 3) values.push_back(0.2f);
    values.push_back(0.75f);  // the last row's alpha
    const std::vector<uint8_t> bytes =
        written_rows<uint8_t>(values, 4, FLG_ATTRIBUTE_COLOR, FLG_NUMBER_FORMAT_SRGB8, 4);
    for (size_t i = 0; i < bytes.size(); ++i) {
        const double v = values[i];
        if (i % 4 == 3) {
            ASSERT_NEAR(bytes[i], 255 * v, 0.5001) << v;
            continue;
        }
        const double srgb = v <= 0.0031308 ? 12.92 * v : 1.055 * std::pow(v, 1 / 2.4) - 0.055;
        ASSERT_NEAR(bytes[i], 255 * srgb, 0.5005) << v;
    }
    const std::vector<float> odd = {-1, 2, nan, inf, -inf, inf, 0.5f, nan};
    EXPECT_EQ(written_rows<uint8_t>(odd, 4, FLG_ATTRIBUTE_COLOR, FLG_NUMBER_FORMAT_SRGB8, 4),
              (std::vector<uint8_t>{0, 255, 0, 255, 0, 255, 188, 0}));
}

TEST(Buffers, FloatsKeepAllBits) {
    std::mt19937 random(5);
    std::vector<float> values(1000);
    std::vector<uint32_t> bits(values.size());
    for (uint32_t& word : bits) word = static_cast<uint32_t>(random());
    std::memcpy(values.data(), bits.data(), bits.size() * sizeof(uint32_t));
    const std::vector<float> out = written<float>(values, FLG_NUMBER_FORMAT_FLOAT32);
    EXPECT_EQ(std::memcmp(out.data(), bits.data(), bits.size() * sizeof(uint32_t)), 0);
}

// 1000 rows of the columns that hosts draw.
struct Source {
    static constexpr uint32_t rows = 1000;
    std::vector<float> positions, normals, colors;
    std::vector<FlgColumn> columns;
    FlgColumnsWriteDesc desc = flgColumnsWriteDefaults();
    FlgBufferOutput output = flgBufferOutputDefaults();
    std::vector<FlgBufferColumn> to;
    std::vector<unsigned char> buffer = std::vector<unsigned char>(rows * stride + 64, untouched);
    static constexpr uint32_t stride = 32;  // 12 of the position, 6 of the normal, 2, 4 of the colour, 8

    Source() {
        std::mt19937 random(7);
        std::uniform_real_distribution<float> number(-1, 1);
        for (uint32_t i = 0; i < 3 * rows; ++i) positions.push_back(100 * number(random));
        for (uint32_t i = 0; i < 3 * rows; ++i) normals.push_back(number(random));
        for (uint32_t i = 0; i < 4 * rows; ++i) colors.push_back(std::abs(number(random)));
        columns = {{FLG_ATTRIBUTE_POSITION, 3, positions.data(), 0, 0},
                   {FLG_ATTRIBUTE_NORMAL, 3, normals.data(), 0, 0},
                   {FLG_ATTRIBUTE_COLOR, 4, colors.data(), 0, 0}};
        desc.columns = columns.data();
        desc.column_count = 3;
        desc.row_count = rows;
        desc.output = &output;
        to = {column_to(FLG_ATTRIBUTE_POSITION, FLG_NUMBER_FORMAT_FLOAT32, at(0), stride),
              column_to(FLG_ATTRIBUTE_NORMAL, FLG_NUMBER_FORMAT_SNORM16, at(12), stride),
              column_to(FLG_ATTRIBUTE_COLOR, FLG_NUMBER_FORMAT_UNORM8, at(20), stride)};
        output = output_of(to, rows);
    }
    Source(const Source&) = delete;
    Source& operator=(const Source&) = delete;

    unsigned char* at(size_t byte) { return buffer.data() + byte; }
    template <class Number>
    Number read(uint32_t row, size_t byte) const {
        Number number;
        std::memcpy(&number, buffer.data() + size_t{row} * stride + byte, sizeof number);
        return number;
    }
    bool is_untouched() const {
        return std::all_of(buffer.begin(), buffer.end(), [](unsigned char byte) { return byte == untouched; });
    }
    FlgResult write() { return flgColumnsWrite(&desc); }
};

TEST(Buffers, InterleavedColumnsLeaveTheRestAlone) {
    Source s;
    ASSERT_EQ(s.write(), FLG_OK) << flgErrorGetMessage();
    for (uint32_t r = 0; r < Source::rows; ++r) {
        for (uint32_t k = 0; k < 3; ++k) {
            ASSERT_EQ(s.read<float>(r, 4 * k), s.positions[3 * r + k]);
            ASSERT_EQ(s.read<int16_t>(r, 12 + 2 * k), std::floor(s.normals[3 * r + k] * 32767.0f + 0.5f));
        }
        for (uint32_t k = 0; k < 4; ++k)
            ASSERT_EQ(s.read<uint8_t>(r, 20 + k), std::floor(s.colors[4 * r + k] * 255.0f + 0.5f));
        for (const size_t byte : {18u, 19u, 24u, 31u}) ASSERT_EQ(s.read<unsigned char>(r, byte), untouched);
    }
    for (size_t byte = Source::rows * Source::stride; byte < s.buffer.size(); ++byte)
        ASSERT_EQ(s.buffer[byte], untouched);
}

TEST(Buffers, APartOfTheRows) {
    Source s;
    s.output.first_row = 990;
    s.output.row_count = 4;
    s.output.row_capacity = 4;
    ASSERT_EQ(s.write(), FLG_OK) << flgErrorGetMessage();
    for (uint32_t r = 0; r < 4; ++r) ASSERT_EQ(s.read<float>(r, 4), s.positions[3 * (990 + r) + 1]);
    EXPECT_EQ(s.read<uint32_t>(4, 0), 0xcdcdcdcdu);
    s.output.row_count = FLG_UNLIMITED;
    s.output.row_capacity = 10;
    ASSERT_EQ(s.write(), FLG_OK) << flgErrorGetMessage();
    EXPECT_EQ(s.read<float>(9, 0), s.positions[3 * 999]);
    EXPECT_EQ(s.read<uint32_t>(10, 0), 0xcdcdcdcdu);
    // A count of 0 is 0.
    s.output.row_count = 0;
    s.output.first_row = 3;
    s.output.row_capacity = 0;
    const std::vector<unsigned char> before(s.buffer.begin(), s.buffer.end());
    EXPECT_EQ(s.write(), FLG_OK) << flgErrorGetMessage();
    EXPECT_TRUE(std::equal(before.begin(), before.end(), s.buffer.begin()));
    s.output.row_count = FLG_UNLIMITED;
    s.output.first_row = Source::rows;
    s.output.row_capacity = 0;
    EXPECT_EQ(s.write(), FLG_OK) << flgErrorGetMessage();
}

TEST(Buffers, StridedInput) {
    Source s;
    s.columns = {{FLG_ATTRIBUTE_POSITION, 3, s.colors.data(), 16, 0}};
    s.desc.columns = s.columns.data();
    s.desc.column_count = 1;
    s.output.column_count = 1;
    ASSERT_EQ(s.write(), FLG_OK) << flgErrorGetMessage();
    for (uint32_t r = 0; r < Source::rows; ++r)
        for (uint32_t k = 0; k < 3; ++k) ASSERT_EQ(s.read<float>(r, 4 * k), s.colors[4 * r + k]);
}

TEST(Buffers, ComponentsAreCutAndFilled) {
    Source s;
    std::vector<float> homogeneous(4 * Source::rows), flat(2 * Source::rows), none(4 * Source::rows);
    s.to = {column_to(FLG_ATTRIBUTE_POSITION, FLG_NUMBER_FORMAT_FLOAT32, homogeneous.data(), 0, 4),
            column_to(FLG_ATTRIBUTE_NORMAL, FLG_NUMBER_FORMAT_FLOAT32, flat.data(), 0, 2),
            column_to(FLG_ATTRIBUTE_ORIENTATION, FLG_NUMBER_FORMAT_FLOAT32, none.data())};
    s.to[0].fill[3] = 1;
    s.to[2].optional = 1;
    s.to[2].fill[0] = 0.25f;
    s.to[2].fill[3] = -3;
    s.output.columns = s.to.data();
    ASSERT_EQ(s.write(), FLG_OK) << flgErrorGetMessage();
    for (uint32_t r = 0; r < Source::rows; ++r) {
        for (uint32_t k = 0; k < 3; ++k) ASSERT_EQ(homogeneous[4 * r + k], s.positions[3 * r + k]);
        ASSERT_EQ(homogeneous[4 * r + 3], 1);
        for (uint32_t k = 0; k < 2; ++k) ASSERT_EQ(flat[2 * r + k], s.normals[3 * r + k]);
        ASSERT_EQ(none[4 * r], 0.25f);
        ASSERT_EQ(none[4 * r + 1], 0);
        ASSERT_EQ(none[4 * r + 3], -3);
    }
}

TEST(Buffers, LeftHandedSpacesMirrorZ) {
    const std::vector<float> values = {1, 2, 3, 4};
    std::vector<FlgColumn> from;
    std::vector<FlgBufferColumn> to;
    std::vector<std::vector<float>> out(7, std::vector<float>(4, 99));
    const auto add = [&](FlgAttribute attribute, uint32_t components) {
        from.push_back({attribute, components, values.data(), 0, 0});
        to.push_back(column_to(attribute, FLG_NUMBER_FORMAT_FLOAT32, out[to.size()].data()));
    };
    add(FLG_ATTRIBUTE_POSITION, 3);
    add(FLG_ATTRIBUTE_NORMAL, 3);
    add(FLG_ATTRIBUTE_TANGENT, 3);
    add(FLG_ATTRIBUTE_DISPLACEMENT, 3);
    add(FLG_ATTRIBUTE_ORIENTATION, 4);
    add(FLG_ATTRIBUTE_ANGLE, 1);
    add(FLG_ATTRIBUTE_COLOR, 4);
    FlgBufferOutput output = output_of(to, 1);
    output.left_handed = 1;
    FlgColumnsWriteDesc desc = flgColumnsWriteDefaults();
    desc.columns = from.data();
    desc.column_count = 7;
    desc.row_count = 1;
    desc.output = &output;
    ASSERT_EQ(flgColumnsWrite(&desc), FLG_OK) << flgErrorGetMessage();
    for (size_t c = 0; c < 4; ++c) EXPECT_EQ(out[c], (std::vector<float>{1, 2, -3, 99})) << c;
    EXPECT_EQ(out[4], (std::vector<float>{-1, -2, 3, 4}));
    EXPECT_EQ(out[5], (std::vector<float>{-1, 99, 99, 99}));
    EXPECT_EQ(out[6], values);
    // A rotation by the mirrored quaternion is the mirrored rotation: M R(q) M = R(q').
    const auto turned = [](std::vector<float> q, std::array<double, 3> v) {
        const double norm = q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3];
        std::array<double, 3> t{}, r{};
        const auto cross = [&](const std::array<double, 3>& a) {
            return std::array<double, 3>{q[1] * a[2] - q[2] * a[1], q[2] * a[0] - q[0] * a[2],
                                         q[0] * a[1] - q[1] * a[0]};
        };
        t = cross(v);
        const std::array<double, 3> u = cross(t);
        for (size_t k = 0; k < 3; ++k) r[k] = v[k] + 2 * (q[3] * t[k] + u[k]) / norm;
        return r;
    };
    const auto right = turned(values, {5, 6, 7}), left = turned(out[4], {5, 6, -7});
    EXPECT_NEAR(left[0], right[0], 1e-12);
    EXPECT_NEAR(left[1], right[1], 1e-12);
    EXPECT_NEAR(left[2], -right[2], 1e-12);
}

TEST(Buffers, OriginsMeetInDoubles) {
    Source s;
    const double far = 6.4e6, origin[3] = {far - 0.125, 2, 0};
    s.desc.origin[0] = far;
    s.output.origin = origin;
    ASSERT_EQ(s.write(), FLG_OK) << flgErrorGetMessage();
    for (uint32_t r = 0; r < Source::rows; ++r) {
        const float* const p = &s.positions[3 * r];
        ASSERT_EQ(s.read<float>(r, 0), static_cast<float>(double{p[0]} + 0.125));
        ASSERT_EQ(s.read<float>(r, 4), static_cast<float>(double{p[1]} - 2));
        ASSERT_EQ(s.read<float>(r, 8), p[2]);
        ASSERT_EQ(s.read<int16_t>(r, 12), std::floor(s.normals[3 * r] * 32767.0f + 0.5f));
    }
}

void expect_refused(const std::function<void(Source&)>& spoil, const char* words,
                    FlgResult result = FLG_ERROR_INVALID_ARGUMENT) {
    Source s;
    spoil(s);
    expect_failure(s.write(), result, words);
    EXPECT_TRUE(s.is_untouched()) << words;
}

TEST(Buffers, RefusedColumnsLeaveEverythingAlone) {
    expect_failure(flgColumnsWrite(nullptr), FLG_ERROR_INVALID_ARGUMENT, "desc is null");
    expect_refused([](Source& s) { s.desc.struct_size = 4; }, "desc: struct_size is 4");
    expect_refused([](Source& s) { s.desc.reserved = 1; }, "desc.reserved is 1");
    expect_refused([](Source& s) { s.desc.output = nullptr; }, "output is null");
    expect_refused([](Source& s) { s.desc.columns = nullptr; }, "desc.columns is null");
    expect_refused([](Source& s) { s.desc.column_count = 0; }, "desc.column_count is 0");
    expect_refused([](Source& s) { s.columns[1].stride = 6; }, "desc.columns[1].stride is 6");
    expect_refused([](Source& s) { s.columns[1].attribute = FLG_ATTRIBUTE_JOINTS; }, "desc.columns[1].attribute is 32");
    expect_refused([](Source& s) { s.desc.origin[1] = NAN; }, "desc.origin[1] is nan");
    expect_refused([](Source& s) { s.output.struct_size = 0; }, "output: struct_size is 0");
    expect_refused([](Source& s) { s.output.columns = nullptr; }, "output.columns is null");
    expect_refused([](Source& s) { s.output.column_count = 17; }, "output.column_count is 17, must be 0 to 16");
    expect_refused([](Source& s) { s.output.row_capacity = 999; }, "output.row_capacity is 999, must be at least 1000");
    expect_refused([](Source& s) { s.output.first_row = 1001; }, "output.first_row is 1001");
    expect_refused([](Source& s) { s.output.row_count = 1001; }, "output.row_count 1001, but there are 1000 rows");
    expect_refused([](Source& s) { s.output.indices = s.at(0); }, "output.indices is set, but desc has none");
    expect_refused([](Source& s) { s.output.regions = s.at(0); }, "output.regions is set, but desc has none");
    static const double origin[3] = {0, 0, INFINITY};
    expect_refused([](Source& s) { s.output.origin = origin; }, "output.origin[2] is inf");
    expect_refused([](Source& s) { std::memset(&s.to[1].attribute, 0x31, 4); },
                   "output.columns[1].attribute is 825307441, of which");
    expect_refused([](Source& s) { std::memset(&s.to[1].attribute, 0xff, 4); }, "output.columns[1].attribute is -1");
    expect_refused([](Source& s) { s.to[1].attribute = FLG_ATTRIBUTE_POSITION; }, "attribute is 0 once more");
    expect_refused([](Source& s) { std::memset(&s.to[1].format, 9, 4); }, "output.columns[1].format is 151587081");
    expect_refused([](Source& s) { s.to[0].format = FLG_NUMBER_FORMAT_UNORM8; },
                   "output.columns[0].format is 2, which attribute 0 cannot have");
    expect_refused([](Source& s) { s.to[1].format = FLG_NUMBER_FORMAT_UINT16; }, "output.columns[1].format is 5");
    expect_refused([](Source& s) { s.to[2].format = FLG_NUMBER_FORMAT_SNORM8; }, "output.columns[2].format is 3");
    expect_refused([](Source& s) { s.to[0].format = FLG_NUMBER_FORMAT_OCTAHEDRAL16; },
                   "output.columns[0].format is 9, which attribute 0 cannot have");
    expect_refused([](Source& s) { s.to[1].format = FLG_NUMBER_FORMAT_SRGB8; },
                   "output.columns[1].format is 10, which attribute 4 cannot have");
    expect_refused([](Source& s) { s.to[1].format = FLG_NUMBER_FORMAT_OCTAHEDRAL16, s.to[1].components = 2; },
                   "output.columns[1].components is 2, must be 0 or 3");
    expect_refused([](Source& s) { s.to[2].format = FLG_NUMBER_FORMAT_SRGB8, s.to[2].components = 5; },
                   "output.columns[2].components is 5, must be 0 to 4");
    expect_refused([](Source& s) { s.to[0].data = nullptr; }, "output.columns[0].data is null");
    expect_refused([](Source& s) { s.to[0].data = s.at(2); }, "must be aligned to 4 bytes");
    expect_refused([](Source& s) { s.to[1].data = s.at(13); }, "must be aligned to 2 bytes");
    expect_refused([](Source& s) { s.to[0].stride = 8; }, "output.columns[0].stride is 8 bytes");
    expect_refused([](Source& s) { s.to[0].stride = 30; }, "output.columns[0].stride is 30 bytes");
    expect_refused([](Source& s) { s.to[0].components = 17; }, "output.columns[0].components is 17");
    expect_refused([](Source& s) { s.to[0].fill[2] = inf; }, "output.columns[0].fill[2] is inf");
    expect_refused([](Source& s) { s.to[0].reserved = 1; }, "output.columns[0].reserved is 1");
    expect_refused([](Source& s) { s.to[1].attribute = FLG_ATTRIBUTE_TANGENT; },
                   "output.columns[1].attribute is 3, of which desc has no column");
    expect_refused([](Source& s) { s.to[1].data = s.at(10); }, "output.columns[1] overlaps output.columns[0]");
    expect_refused([](Source& s) { s.to[1].stride = 6; }, "output.columns[1] overlaps output.columns[0]");
    expect_refused([](Source& s) { s.to[2].data = s.colors.data() + 1; }, "output.columns[2] overlaps desc.columns[2]");
}

// Two triangles a square, in rows.
MeshArrays squares(uint32_t across) {
    MeshArrays mesh;
    for (uint32_t y = 0; y <= across; ++y)
        for (uint32_t x = 0; x <= across; ++x) mesh.add_vertex(x, y, 0.01 * x * y);
    for (uint32_t y = 0; y < across; ++y) {
        for (uint32_t x = 0; x < across; ++x) {
            const uint32_t a = y * (across + 1) + x, b = a + across + 1;
            mesh.add_triangle(a, a + 1, b + 1);
            mesh.add_triangle(a, b + 1, b);
        }
    }
    return mesh;
}

TEST(Buffers, IndicesOfBothWidths) {
    const std::vector<uint32_t> triangles = {0, 1, 2, 65434, 3, 4};
    std::vector<uint16_t> narrow(7, 0xcdcd);
    FlgBufferOutput output = flgBufferOutputDefaults();
    output.indices = narrow.data();
    output.index_capacity = 6;
    output.index_format = FLG_NUMBER_FORMAT_UINT16;
    output.base_vertex = 100;
    ASSERT_EQ(flgIndicesWrite(triangles.data(), 6, &output), FLG_OK) << flgErrorGetMessage();
    EXPECT_EQ(narrow, (std::vector<uint16_t>{100, 101, 102, 65534, 103, 104, 0xcdcd}));
    output.left_handed = 1;
    ASSERT_EQ(flgIndicesWrite(triangles.data(), 6, &output), FLG_OK) << flgErrorGetMessage();
    EXPECT_EQ(narrow, (std::vector<uint16_t>{100, 102, 101, 65534, 104, 103, 0xcdcd}));
    output.first_triangle = 1;
    ASSERT_EQ(flgIndicesWrite(triangles.data(), 6, &output), FLG_OK) << flgErrorGetMessage();
    EXPECT_EQ(narrow[0], 65534);

    std::fill(narrow.begin(), narrow.end(), uint16_t{0xcdcd});
    const std::vector<uint16_t> before = narrow;
    const auto refuse = [&](FlgBufferOutput spoilt, FlgResult result, const char* words) {
        expect_failure(flgIndicesWrite(triangles.data(), 6, &spoilt), result, words);
        EXPECT_EQ(narrow, before);
    };
    output.first_triangle = 0;
    FlgBufferOutput spoilt = output;
    spoilt.base_vertex = 101;
    refuse(spoilt, FLG_ERROR_LIMIT, "the last vertex is number 65535; the limit is 65534");
    spoilt = output;
    spoilt.index_capacity = 5;
    refuse(spoilt, FLG_ERROR_INVALID_ARGUMENT, "output.index_capacity is 5, must be at least 6");
    spoilt = output;
    spoilt.indices = reinterpret_cast<char*>(narrow.data()) + 1;
    refuse(spoilt, FLG_ERROR_INVALID_ARGUMENT, "must be aligned to 2 bytes");
    spoilt = output;
    spoilt.index_format = FLG_NUMBER_FORMAT_UINT8;
    refuse(spoilt, FLG_ERROR_INVALID_ARGUMENT, "output.index_format is 8");
    spoilt = output;
    spoilt.triangle_count = 3;
    refuse(spoilt, FLG_ERROR_INVALID_ARGUMENT, "output.triangle_count 3, but there are 2 triangles");
    expect_failure(flgIndicesWrite(nullptr, 6, &output), FLG_ERROR_INVALID_ARGUMENT, "indices is null");
    expect_failure(flgIndicesWrite(triangles.data(), 5, &output), FLG_ERROR_INVALID_ARGUMENT, "index_count is 5");

    std::vector<uint32_t> wide(6);
    output.indices = wide.data();
    output.index_format = FLG_NUMBER_FORMAT_UINT32;
    output.left_handed = 0;
    output.base_vertex = UINT32_MAX - 1 - 65434;
    ASSERT_EQ(flgIndicesWrite(triangles.data(), 6, &output), FLG_OK) << flgErrorGetMessage();
    EXPECT_EQ(wide[3], UINT32_MAX - 1);
    ++output.base_vertex;
    expect_failure(flgIndicesWrite(triangles.data(), 6, &output), FLG_ERROR_LIMIT, "the limit is 2^32 - 2");
    output.base_vertex = 0;
    std::vector<uint32_t> own = triangles;
    output.indices = own.data();
    expect_failure(flgIndicesWrite(own.data(), 6, &output), FLG_ERROR_INVALID_ARGUMENT,
                   "output.indices overlaps indices.triangles");
    EXPECT_EQ(own, triangles);
}

// ---- Jobs ----

// Ticks until the job is done; its result and sentence.
void expect_done(const Host& host, FlgJob job, FlgResult result = FLG_OK, const char* words = "") {
    host.finish();
    const FlgJobStatus status = host.status_of(job);
    EXPECT_EQ(status.result, result) << status.error;
    EXPECT_NE(std::strstr(status.error, words), nullptr) << status.error;
}

// Position and radius of all points, interleaved.
struct PointBuffer {
    std::vector<unsigned char> bytes;
    std::vector<FlgBufferColumn> columns;
    FlgBufferOutput output;

    explicit PointBuffer(uint32_t rows) : bytes(size_t{rows} * 20, untouched) {
        columns = {column_to(FLG_ATTRIBUTE_POSITION, FLG_NUMBER_FORMAT_FLOAT32, bytes.data(), 20),
                   column_to(FLG_ATTRIBUTE_RADIUS, FLG_NUMBER_FORMAT_FLOAT16, bytes.data() + 12, 20)};
        output = output_of(columns, rows);
    }
    PointBuffer(const PointBuffer&) = delete;
    PointBuffer& operator=(const PointBuffer&) = delete;
    bool is_untouched() const {
        return std::all_of(bytes.begin(), bytes.end(), [](unsigned char byte) { return byte == untouched; });
    }
};

TEST(BufferJobs, OfCurvesThatAreStillMadeGiveTheBitsOfTheView) {
    std::vector<unsigned char> first;
    for (const uint32_t workers : {0u, 1u, 4u}) {
        const Host host(workers);
        FlgCurveSetResampleDesc desc = flgCurveSetResampleDefaults();
        desc.curves = host.create(arcs(40, 200));
        desc.spacing = 0.02f;
        FlgCurveSet even{};
        ASSERT_EQ(flgCurveSetResample(host.context, &desc, &even, nullptr), FLG_OK) << flgErrorGetMessage();
        PointBuffer by_job(60000);
        FlgJob job{};
        ASSERT_EQ(flgCurveSetWrite(host.context, even, &by_job.output, nullptr, &job), FLG_OK) << flgErrorGetMessage();
        // The structs are read during the call.
        by_job.output = flgBufferOutputDefaults();
        by_job.columns.clear();
        expect_done(host, job);
        const FlgCurveSetView view = host.view_of(even);
        PointBuffer at_once(60000);
        FlgColumnsWriteDesc now = flgColumnsWriteDefaults();
        now.columns = view.columns;
        now.column_count = view.column_count;
        now.row_count = view.curve_offsets[view.curve_count];
        now.output = &at_once.output;
        EXPECT_GT(now.row_count, 30000u);
        ASSERT_EQ(flgColumnsWrite(&now), FLG_OK) << flgErrorGetMessage();
        EXPECT_EQ(by_job.bytes, at_once.bytes);
        EXPECT_EQ(std::memcmp(by_job.bytes.data(), view.columns[0].data, 12), 0);
        if (first.empty()) first = by_job.bytes;
        EXPECT_EQ(by_job.bytes, first) << workers;
    }
}

TEST(BufferJobs, ReleasedHandlesStay) {
    const Host host;
    const FlgCurveSet set = host.create(arcs(3));
    PointBuffer buffer(180);
    FlgJob job{};
    ASSERT_EQ(flgCurveSetWrite(host.context, set, &buffer.output, nullptr, &job), FLG_OK) << flgErrorGetMessage();
    ASSERT_EQ(flgCurveSetRelease(host.context, set), FLG_OK);
    expect_done(host, job);
    EXPECT_FALSE(buffer.is_untouched());
    expect_failure(flgCurveSetWrite(host.context, set, &buffer.output, nullptr, &job), FLG_ERROR_INVALID_HANDLE,
                   "curves");
    EXPECT_EQ(job.id, 0u);
}

TEST(BufferJobs, WhatDoesNotFitIsRefusedAtOnceOrByTheJob) {
    const Host host;
    const FlgCurveSet set = host.create(arcs(3));
    PointBuffer buffer(180);
    buffer.output.row_capacity = 179;
    FlgJob job{};
    expect_failure(flgCurveSetWrite(host.context, set, &buffer.output, nullptr, &job), FLG_ERROR_INVALID_ARGUMENT,
                   "output.row_capacity is 179, must be at least 180");
    buffer.output.row_capacity = 180;
    buffer.columns[1].attribute = FLG_ATTRIBUTE_SPEED;
    expect_failure(flgCurveSetWrite(host.context, set, &buffer.output, nullptr, &job), FLG_ERROR_INVALID_ARGUMENT,
                   "output.columns[1].attribute is 12, of which curves has no column");
    expect_failure(flgCurveSetWrite(host.context, set, nullptr, nullptr, &job), FLG_ERROR_INVALID_ARGUMENT,
                   "output is null");

    FlgCurveSetResampleDesc desc = flgCurveSetResampleDefaults();
    desc.curves = set;
    desc.spacing = 0.02f;
    FlgCurveSet even{};
    ASSERT_EQ(flgCurveSetResample(host.context, &desc, &even, nullptr), FLG_OK);
    buffer.columns[1].attribute = FLG_ATTRIBUTE_RADIUS;
    ASSERT_EQ(flgCurveSetWrite(host.context, even, &buffer.output, nullptr, &job), FLG_OK) << flgErrorGetMessage();
    expect_done(host, job, FLG_ERROR_INVALID_ARGUMENT, "output.row_capacity is 180, must be at least 3");
    EXPECT_TRUE(buffer.is_untouched());

    // One that is not made.
    FlgJob making{};
    ASSERT_EQ(flgCurveSetResample(host.context, &desc, &even, &making), FLG_OK);
    ASSERT_EQ(flgCurveSetWrite(host.context, even, &buffer.output, nullptr, &job), FLG_OK);
    ASSERT_EQ(flgJobCancel(host.context, making), FLG_OK);
    expect_done(host, job, FLG_ERROR_DEPENDENCY);
    EXPECT_TRUE(buffer.is_untouched());
}

TEST(BufferJobs, ACancelledOneStopsWithinASlice) {
    const Host host;
    const FlgCurveSet set = host.create(arcs(1, 400000));
    PointBuffer buffer(400000);
    FlgJob job{};
    ASSERT_EQ(flgCurveSetWrite(host.context, set, &buffer.output, nullptr, &job), FLG_OK) << flgErrorGetMessage();
    FlgFrameReport report = flgFrameReportDefaults();
    ASSERT_EQ(flgContextTick(host.context, 200, &report), FLG_OK);
    EXPECT_EQ(report.jobs_pending, 1u);
    EXPECT_FALSE(buffer.is_untouched());
    ASSERT_EQ(flgJobCancel(host.context, job), FLG_OK);
    host.finish();
    EXPECT_EQ(host.result_of(job), FLG_ERROR_CANCELLED);
    EXPECT_EQ(buffer.bytes.back(), untouched);
    EXPECT_EQ(buffer.bytes[buffer.bytes.size() - 20], untouched);
}

FlgSurface surface_of(const Host& host, MeshArrays mesh) {
    const FlgMeshView view = mesh.view();
    FlgSurfaceDesc desc = flgSurfaceDefaults();
    desc.mesh = &view;
    FlgSurface surface{};
    EXPECT_EQ(flgSurfaceCreate(host.context, &desc, &surface, nullptr), FLG_OK) << flgErrorGetMessage();
    return surface;
}

TEST(BufferJobs, OfSurfacesHaveIndicesAndRegions) {
    for (const uint32_t workers : {0u, 4u}) {
        const Host host(workers);
        MeshArrays mesh = squares(100);
        mesh.set_regions([](const Point& p) { return p[0] < 50 ? 7u : 300u; });
        const FlgSurface surface = surface_of(host, mesh);
        const uint32_t vertices = 101 * 101, triangles = 20000;
        std::vector<float> positions(3 * vertices);
        std::vector<uint16_t> indices(3 * triangles), regions(triangles);
        const std::vector<FlgBufferColumn> columns = {
            column_to(FLG_ATTRIBUTE_POSITION, FLG_NUMBER_FORMAT_FLOAT32, positions.data())};
        FlgBufferOutput output = output_of(columns, vertices);
        output.indices = indices.data();
        output.index_capacity = indices.size();
        output.index_format = FLG_NUMBER_FORMAT_UINT16;
        output.regions = regions.data();
        output.region_capacity = triangles;
        output.region_format = FLG_NUMBER_FORMAT_UINT16;
        FlgJob job{};
        ASSERT_EQ(flgSurfaceWrite(host.context, surface, &output, nullptr, &job), FLG_OK) << flgErrorGetMessage();
        expect_done(host, job);
        FlgSurfaceView view = flgSurfaceViewDefaults();
        ASSERT_EQ(flgSurfaceGetView(host.context, surface, &view), FLG_OK);
        EXPECT_EQ(std::memcmp(positions.data(), view.mesh->columns[0].data, positions.size() * sizeof(float)), 0);
        EXPECT_TRUE(std::equal(indices.begin(), indices.end(), view.mesh->triangles));
        EXPECT_TRUE(std::equal(regions.begin(), regions.end(), view.mesh->regions));

        std::fill(regions.begin(), regions.end(), uint16_t{0xcdcd});
        const std::vector<float> before = positions;
        output.region_format = FLG_NUMBER_FORMAT_UINT8;
        output.left_handed = 1;
        ASSERT_EQ(flgSurfaceWrite(host.context, surface, &output, nullptr, &job), FLG_OK) << flgErrorGetMessage();
        expect_done(host, job, FLG_ERROR_LIMIT, "output.regions holds 300, the most that its format can hold is 255");
        EXPECT_EQ(positions, before);
        EXPECT_TRUE(std::all_of(regions.begin(), regions.end(), [](uint16_t r) { return r == 0xcdcd; }));
        output.region_capacity = triangles - 1;
        expect_failure(flgSurfaceWrite(host.context, surface, &output, nullptr, &job), FLG_ERROR_INVALID_ARGUMENT,
                       "output.region_capacity is 19999, must be at least 20000");
        output.regions = indices.data();
        output.region_capacity = triangles;
        expect_failure(flgSurfaceWrite(host.context, surface, &output, nullptr, &job), FLG_ERROR_INVALID_ARGUMENT,
                       "output.regions overlaps output.indices");
        output.region_format = FLG_NUMBER_FORMAT_FLOAT32;
        expect_failure(flgSurfaceWrite(host.context, surface, &output, nullptr, &job), FLG_ERROR_INVALID_ARGUMENT,
                       "output.region_format is 0");
    }
}

TEST(BufferJobs, TakeTheirTurnBetweenCuts) {
    const Host host;
    const FlgSurface surface = surface_of(host, squares(30));
    FlgFieldGeodesicDesc field_desc = flgFieldGeodesicDefaults();
    const uint32_t corner = 0;
    field_desc.surface = surface;
    field_desc.vertices = &corner;
    field_desc.vertex_count = 1;
    FlgField field{};
    ASSERT_EQ(flgFieldCreateGeodesic(host.context, &field_desc, &field, nullptr), FLG_OK) << flgErrorGetMessage();
    const uint32_t vertices = 31 * 31;
    std::vector<float> before(3 * vertices), after(3 * 2 * vertices);
    std::vector<FlgBufferColumn> columns = {
        column_to(FLG_ATTRIBUTE_POSITION, FLG_NUMBER_FORMAT_FLOAT32, before.data())};
    FlgBufferOutput output = output_of(columns, vertices);
    FlgJob first{}, cut{}, second{};
    ASSERT_EQ(flgSurfaceWrite(host.context, surface, &output, nullptr, &first), FLG_OK) << flgErrorGetMessage();
    const float level = 12.3f;
    FlgSurfaceCutIsolinesDesc cut_desc = flgSurfaceCutIsolinesDefaults();
    cut_desc.field = field;
    cut_desc.levels = &level;
    cut_desc.level_count = 1;
    ASSERT_EQ(flgSurfaceCutIsolines(host.context, &cut_desc, nullptr, &cut), FLG_OK) << flgErrorGetMessage();
    columns[0].data = after.data();
    output.row_capacity = 2 * vertices;
    ASSERT_EQ(flgSurfaceWrite(host.context, surface, &output, nullptr, &second), FLG_OK) << flgErrorGetMessage();
    expect_done(host, first);
    expect_done(host, second);
    FlgSurfaceView view = flgSurfaceViewDefaults();
    ASSERT_EQ(flgSurfaceGetView(host.context, surface, &view), FLG_OK);
    ASSERT_GT(view.mesh->vertex_count, vertices);
    EXPECT_EQ(std::memcmp(after.data(), view.mesh->columns[0].data, 12 * size_t{view.mesh->vertex_count}), 0);
    EXPECT_EQ(std::memcmp(before.data(), after.data(), 12 * size_t{vertices}), 0);
}

TEST(BufferJobs, OfFieldsHaveValuesAndLabels) {
    const Host host;
    const FlgSurface surface = surface_of(host, squares(20));
    FlgFieldGeodesicDesc desc = flgFieldGeodesicDefaults();
    const std::vector<uint32_t> sources = {0, 440};
    desc.surface = surface;
    desc.vertices = sources.data();
    desc.vertex_count = 2;
    desc.labels = 1;
    desc.max_distance = 8;
    FlgField field{};
    ASSERT_EQ(flgFieldCreateGeodesic(host.context, &desc, &field, nullptr), FLG_OK) << flgErrorGetMessage();
    std::vector<float> values(441);
    std::vector<uint8_t> labels(441);
    const std::vector<FlgBufferColumn> columns = {
        column_to(FLG_ATTRIBUTE_VALUE, FLG_NUMBER_FORMAT_FLOAT32, values.data()),
        column_to(FLG_ATTRIBUTE_LABEL, FLG_NUMBER_FORMAT_UINT8, labels.data())};
    const FlgBufferOutput output = output_of(columns, 441);
    FlgJob job{};
    ASSERT_EQ(flgFieldWrite(host.context, field, &output, nullptr, &job), FLG_OK) << flgErrorGetMessage();
    expect_done(host, job);
    FlgFieldView view{};
    view.struct_size = sizeof view;
    ASSERT_EQ(flgFieldGetView(host.context, field, &view), FLG_OK);
    uint32_t none = 0;
    for (uint32_t v = 0; v < 441; ++v) {
        ASSERT_EQ(values[v], view.values[v]);
        ASSERT_EQ(labels[v], view.labels[v] == FLG_NO_INDEX ? 255 : view.labels[v]);
        none += labels[v] == 255;
    }
    EXPECT_GT(none, 0u);
}

std::vector<double> disc(double x, double rx, double ry) {
    std::vector<double> points;
    for (uint32_t i = 0; i < 120; ++i) {
        points.push_back(x + rx * std::cos(2 * M_PI * i / 120));
        points.push_back(ry * std::sin(2 * M_PI * i / 120));
    }
    return points;
}

TEST(BufferJobs, OfPartsAndSkins) {
    const PartHost host(1);
    FlgModelPart part = flgModelPartDefaults();
    part.part = host.part(disc(0, 1, 3));
    FlgPartMeshDesc mesh_desc = flgPartMeshDefaults();
    mesh_desc.part = part.part;
    FlgPartMesh mesh{};
    ASSERT_EQ(flgPartMeshCreate(host.context, &mesh_desc, &mesh, nullptr), FLG_OK) << flgErrorGetMessage();
    FlgModelDesc model_desc = flgModelDefaults();
    model_desc.parts = &part;
    model_desc.part_count = 1;
    FlgBoneThresholds thresholds = flgBoneThresholdsDefaults();
    thresholds.detail = 4;  // bones that share vertices
    model_desc.thresholds = &thresholds;
    FlgSkinDesc skin_desc = flgSkinDefaults();
    ASSERT_EQ(flgModelCreate(host.context, &model_desc, &skin_desc.model, nullptr), FLG_OK) << flgErrorGetMessage();
    skin_desc.vertex_count = 1000;
    FlgSkin skin{};
    ASSERT_EQ(flgSkinCreate(host.context, &skin_desc, &skin, nullptr), FLG_OK) << flgErrorGetMessage();

    constexpr uint32_t room = 5000;
    struct Vertex {
        float position[3];
        int8_t normal[4];
        uint8_t joints[4], weights[4];
    };
    std::vector<Vertex> vertices(room);
    std::vector<uint32_t> indices(6 * room), part_indices(6 * room);
    std::vector<float> part_positions(3 * room);
    const std::vector<FlgBufferColumn> columns = {
        column_to(FLG_ATTRIBUTE_POSITION, FLG_NUMBER_FORMAT_FLOAT32, vertices[0].position, sizeof(Vertex)),
        column_to(FLG_ATTRIBUTE_NORMAL, FLG_NUMBER_FORMAT_SNORM8, vertices[0].normal, sizeof(Vertex), 4),
        column_to(FLG_ATTRIBUTE_JOINTS, FLG_NUMBER_FORMAT_UINT8, vertices[0].joints, sizeof(Vertex)),
        column_to(FLG_ATTRIBUTE_WEIGHTS, FLG_NUMBER_FORMAT_UNORM8, vertices[0].weights, sizeof(Vertex))};
    FlgBufferOutput output = output_of(columns, room);
    output.indices = indices.data();
    output.index_capacity = indices.size();
    FlgJob job{}, part_job{};
    ASSERT_EQ(flgSkinWrite(host.context, skin, &output, nullptr, &job), FLG_OK) << flgErrorGetMessage();
    const std::vector<FlgBufferColumn> part_columns = {
        column_to(FLG_ATTRIBUTE_POSITION, FLG_NUMBER_FORMAT_FLOAT32, part_positions.data())};
    FlgBufferOutput part_output = output_of(part_columns, room);
    part_output.indices = part_indices.data();
    part_output.index_capacity = part_indices.size();
    ASSERT_EQ(flgPartMeshWrite(host.context, mesh, &part_output, nullptr, &part_job), FLG_OK) << flgErrorGetMessage();
    expect_done(host, job);
    expect_done(host, part_job);

    FlgSkinView view = flgSkinViewDefaults();
    ASSERT_EQ(flgSkinGetView(host.context, skin, &view), FLG_OK);
    uint32_t blended = 0;
    for (uint32_t v = 0; v < view.vertex_count; ++v) {
        int sum = 0;
        for (uint32_t k = 0; k < 4; ++k) {
            if (k < 3) {
                ASSERT_EQ(vertices[v].position[k], view.positions[3 * v + k]);
            }
            ASSERT_EQ(vertices[v].normal[k], k < 3 ? std::floor(view.normals[3 * v + k] * 127.0f + 0.5f) : 0);
            ASSERT_EQ(vertices[v].joints[k], view.vertex_joints[4 * v + k]);
            ASSERT_NEAR(vertices[v].weights[k], view.vertex_weights[4 * v + k] * 255, k == 0 ? 2 : 0.501);
            sum += vertices[v].weights[k];
        }
        ASSERT_EQ(sum, 255);
        blended += vertices[v].weights[1] > 0;
    }
    EXPECT_GT(blended, 100u);
    EXPECT_TRUE(std::equal(view.triangles, view.triangles + 3 * view.triangle_count, indices.begin()));
    FlgPartMeshView body = flgPartMeshViewDefaults();
    ASSERT_EQ(flgPartMeshGetView(host.context, mesh, &body), FLG_OK);
    EXPECT_TRUE(std::equal(body.positions, body.positions + 3 * body.vertex_count, part_positions.begin()));
    EXPECT_TRUE(std::equal(body.triangles, body.triangles + 3 * body.triangle_count, part_indices.begin()));
}

TEST(BufferJobs, LeaveNoMemoryBehindAtAnyFailure) {
    for (int64_t fail_at = 0; fail_at < 6; ++fail_at) {
        Host host;
        const FlgCurveSet set = host.create(arcs(3));
        PointBuffer buffer(180);
        host.allocator.calls = 0;
        host.allocator.fail_at = fail_at;
        FlgJob job{};
        const FlgResult result = flgCurveSetWrite(host.context, set, &buffer.output, nullptr, &job);
        EXPECT_TRUE(result == FLG_OK || result == FLG_ERROR_OUT_OF_MEMORY);
        host.finish();
        host.allocator.fail_at = -1;
        const bool done = result == FLG_OK && host.result_of(job) == FLG_OK;
        EXPECT_EQ(buffer.is_untouched(), !done);
    }
}

}  // namespace
}  // namespace flg::test
