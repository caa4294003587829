// SPDX-License-Identifier: MIT
// Prepared styles as bytes: the way there and back, and bytes that nobody should trust.
#include "api/style_inputs.h"
#include "core/random.h"
#include "stylization/style_file.h"

namespace flg::test {
namespace {

// Two short curves with attributes: all that a file can hold, in little.
FlgStyle small_style(const Host& host) {
    Columns curves{coils({1, 2})};
    curves.with(FLG_ATTRIBUTE_COLOR, 4, [](auto i, auto k) { return std::sin(0.1 * i + k); })
        .with(FLG_ATTRIBUTE_ANGLE, 1, [](auto i, auto) { return 0.1 * i; });
    const FlgStyleAttribute attributes[2] = {{FLG_ATTRIBUTE_COLOR, FLG_METRIC_AUTO, 0.1f, 0},
                                             {FLG_ATTRIBUTE_ANGLE, FLG_METRIC_PROJECTIVE, 0.1f, 0}};
    FlgStyleDesc desc = flgStyleDefaults();
    desc.style = curves.create(host);
    desc.attributes = attributes;
    desc.attribute_count = 2;
    desc.point_count = 40;
    desc.patch = 3;
    return prepare(host, desc);
}

std::string data_of(const Host& host, FlgStyle style) {
    size_t size = 0;
    EXPECT_EQ(flgStyleGetData(host.context, style, nullptr, 0, &size), FLG_OK) << flgErrorGetMessage();
    std::string data(size, 0);
    EXPECT_EQ(flgStyleGetData(host.context, style, data.data(), size, &size), FLG_OK) << flgErrorGetMessage();
    EXPECT_EQ(size, data.size());
    return data;
}

FlgResult load(const Host& host, const std::string& data, FlgStyle& style) {
    return flgStyleCreateFromData(host.context, data.data(), data.size(), &style);
}

// As if whoever changed the bytes had made a hash for them.
void fix_hash(std::string& data) {
    if (data.size() < style_file_content_offset) return;
    const uint64_t size = data.size();
    std::memcpy(data.data() + style_file_hash_offset - sizeof size, &size, sizeof size);
    const auto bytes = std::as_bytes(std::span(data));
    const uint64_t hash = style_file_hash(bytes.subspan(style_file_content_offset));
    std::memcpy(data.data() + style_file_hash_offset, &hash, sizeof hash);
}

std::string stylized_bits(const Host& host, FlgStyle style, FlgStyleStart start = FLG_STYLE_START_RANDOM) {
    FlgCurveSetStylizeDesc desc = flgCurveSetStylizeDefaults();
    desc.style = style;
    desc.start = start;
    desc.temperature = 0.5f;
    desc.target = host.create(arcs(3));
    const FlgCurveSet result = stylize(host, desc);
    std::string all = bits(host.view_of(result));
    EXPECT_EQ(flgCurveSetRelease(host.context, result), FLG_OK);
    EXPECT_EQ(flgCurveSetRelease(host.context, desc.target), FLG_OK);
    return all;
}

TEST(StyleData, LoadedStylesGiveTheSameBits) {
    Host host;
    FlgStyleDesc desc = flgStyleDefaults();
    desc.style = host.create(coil());
    for (const FlgStyle style : {small_style(host), prepare(host, desc)}) {
        const std::string data = data_of(host, style);
        EXPECT_TRUE(data == data_of(host, style));
        Host other;
        FlgStyle loaded{};
        ASSERT_EQ(load(other, data, loaded), FLG_OK) << flgErrorGetMessage();
        EXPECT_TRUE(data_of(other, loaded) == data);
        EXPECT_TRUE(stylized_bits(other, loaded) == stylized_bits(host, style));
        EXPECT_TRUE(stylized_bits(other, loaded, FLG_STYLE_START_STYLE) ==
                    stylized_bits(host, style, FLG_STYLE_START_STYLE));
        const FlgStyleInfo a = style_info(host, style), b = style_info(other, loaded);
        EXPECT_EQ(std::memcmp(&a, &b, offsetof(FlgStyleInfo, matching)), 0);
        EXPECT_EQ(std::memcmp(a.matching, b.matching, a.point_count * sizeof(float)), 0);
        FlgCurveSet guide{}, loaded_guide{};
        ASSERT_EQ(flgStyleGetGuide(host.context, style, &guide), FLG_OK);
        ASSERT_EQ(flgStyleGetGuide(other.context, loaded, &loaded_guide), FLG_OK);
        EXPECT_TRUE(bits(host.view_of(guide)) == bits(other.view_of(loaded_guide)));
    }
}

TEST(StyleData, TheBytesNeedNoAlignment) {
    Host host;
    std::string data(1, 'x');
    data += data_of(host, small_style(host));
    FlgStyle loaded{};
    EXPECT_EQ(flgStyleCreateFromData(host.context, data.data() + 1, data.size() - 1, &loaded), FLG_OK);
}

TEST(StyleData, EveryTruncationIsRefused) {
    Host host;
    const std::string data = data_of(host, small_style(host));
    for (size_t size = 0; size < data.size(); ++size) {
        std::string cut = data.substr(0, size);
        FlgStyle style{7};
        ASSERT_EQ(load(host, cut, style), FLG_ERROR_FORMAT) << size;
        EXPECT_EQ(style.id, 0u);
        fix_hash(cut);
        ASSERT_EQ(load(host, cut, style), FLG_ERROR_FORMAT) << size << " with a hash that fits";
    }
    std::string longer = data + '\0';
    FlgStyle style{};
    expect_failure(load(host, longer, style), FLG_ERROR_FORMAT, "data has");
    fix_hash(longer);
    expect_failure(load(host, longer, style), FLG_ERROR_FORMAT, "data goes on for 1 bytes");
}

// Damage is always found. What is made with a hash that fits is refused or can be used like any style.
TEST(StyleData, FlippedBytesAreRefusedOrHarmless) {
    Host host;
    const std::string data = data_of(host, small_style(host));
    uint32_t accepted = 0, refused = 0;
    for (uint32_t round = 0; round < 2000; ++round) {
        std::string changed = data;
        const bool fixed = round % 2 == 1;
        const uint32_t flips = 1 + random_below(round, 0, 0, 3);
        for (uint32_t k = 0; k < flips; ++k) {
            const auto size = static_cast<uint32_t>(data.size());
            // Half of them among counts, measures and offsets.
            const uint32_t at = random_below(round, k, 1, round % 4 < 2 ? 120 : size);
            changed[at] = static_cast<char>(changed[at] ^ (1 + random_below(round, k, 2, 255)));
        }
        if (fixed) fix_hash(changed);
        if (changed == data) continue;
        FlgStyle style{};
        const FlgResult result = load(host, changed, style);
        if (!fixed) {
            ASSERT_EQ(result, FLG_ERROR_FORMAT) << round;
        } else if (result != FLG_OK) {
            ASSERT_EQ(result, FLG_ERROR_FORMAT) << round;
            ++refused;
        } else {
            ++accepted;
            FlgCurveSetStylizeDesc desc = flgCurveSetStylizeDefaults();
            desc.style = style;
            desc.temperature = 1;
            desc.target = host.create(arcs(1, 4, 2));
            // A spacing of 1e-300 is past the limit on points; any larger is work.
            if (style_info(host, style).spacing > 1e-3f) {
                FlgCurveSet out{};
                ASSERT_EQ(flgCurveSetStylize(host.context, &desc, &out, nullptr), FLG_OK) << flgErrorGetMessage();
                host.finish();
                flgCurveSetRelease(host.context, out);
            }
            flgCurveSetRelease(host.context, desc.target);
            flgStyleRelease(host.context, style);
        }
    }
    EXPECT_GT(accepted, 50u);
    EXPECT_GT(refused, 50u);
}

TEST(StyleData, TheSentenceSaysWhatIsWrong) {
    Host host;
    const std::string data = data_of(host, small_style(host));
    const auto refused = [&](size_t at, auto value, const char* words) {
        std::string changed = data;
        std::memcpy(changed.data() + at, &value, sizeof value);
        if (at >= style_file_content_offset) fix_hash(changed);
        FlgStyle style{};
        expect_failure(load(host, changed, style), FLG_ERROR_FORMAT, words);
    };
    const size_t content = style_file_content_offset;
    refused(0, 'f', "does not begin as one");
    refused(8, uint32_t{3}, "format 3, this library reads formats 1 and 2");
    refused(style_file_hash_offset, uint64_t{1}, "its hash does not fit");
    refused(content, uint32_t{0}, "number of points");
    refused(content, uint32_t{16385}, "number of points");
    refused(content + 4, uint32_t{0}, "number of curves");
    refused(content + 4, uint32_t{257}, "number of curves");
    refused(content + 8, uint32_t{0}, "patch size");
    refused(content + 8, uint32_t{1024}, "no curve is long enough");
    refused(content + 12, uint32_t{0xffffffff}, "too many jumps");
    refused(content + 16, uint32_t{9}, "too many attributes");
    refused(content + 24, 0.0, "no length");
    refused(content + 32, -1.0, "no length");
    refused(content + 32, static_cast<double>(NAN), "no length");
    refused(content + 40, -1.0, "no size");
    const size_t offsets = content + 56;
    refused(offsets, uint32_t{1}, "curves do not follow");
    refused(offsets + 4, uint32_t{39}, "curves do not follow");
    refused(offsets + 4, uint32_t{0xfffffff0}, "curves do not follow");
    const size_t positions = offsets + 12, vectors = 40 * 3 * sizeof(float);
    refused(positions, NAN, "position");
    refused(positions + vectors, 2.0f, "unit");
    refused(positions + 2 * vectors, INFINITY, "unit");
    const size_t displacement = positions + 3 * vectors;
    refused(displacement, static_cast<double>(INFINITY), "displacement");
    const size_t matching = displacement + 3 * 40 * sizeof(double);
    refused(matching + 4, -1.0f, "backwards");
    const size_t color = matching + 40 * sizeof(float);
    refused(color, FLG_ATTRIBUTE_POSITION, "attribute 0");
    refused(color, int32_t{-5}, "attribute -5");
    refused(color, FLG_ATTRIBUTE_ANGLE, "number of components");
    refused(color + 4, uint32_t{17}, "17 components");
    refused(color + 8, FLG_METRIC_CIRCLE, "metric");
    refused(color + 8, FLG_METRIC_AUTO, "metric 0");
    refused(color + 12, -1.0, "weight");
    refused(color + 20, NAN, "value");
    const size_t unit = color + 2 * 20 + 40 * 5 * sizeof(float);
    refused(unit, -1.0f, "temperature");
    const size_t in_begin = unit + 4;
    refused(in_begin, uint32_t{1}, "not in order");
    refused(in_begin + 4 * 20, uint32_t{0xffff}, "not in order");
    const size_t in_source = in_begin + 41 * 4;
    refused(in_source, uint16_t{0xffff}, "where none may");
    refused(in_source, uint16_t{0}, "where none may");
    refused(data.size() - 4, -1.0f, "cost");
    refused(data.size() - 4, INFINITY, "cost");
}

TEST(StyleData, RefusesBadArguments) {
    Host host;
    FlgStyleDesc desc = flgStyleDefaults();
    desc.style = host.create(coil());
    FlgStyle style{};
    ASSERT_EQ(flgStyleCreate(host.context, &desc, &style, nullptr), FLG_OK);
    size_t size = 9;
    EXPECT_EQ(flgStyleGetData(host.context, style, nullptr, 0, &size), FLG_NOT_READY);
    EXPECT_EQ(size, 0u);
    host.finish();
    const std::string data = data_of(host, style);
    std::string out(data.size(), 'x');
    expect_failure(flgStyleGetData(host.context, style, out.data(), 100, &size), FLG_ERROR_LIMIT, "capacity is 100");
    EXPECT_EQ(size, data.size());
    EXPECT_EQ(out, std::string(data.size(), 'x'));
    expect_failure(flgStyleGetData(host.context, style, nullptr, 100, &size), FLG_ERROR_INVALID_ARGUMENT,
                   "out_data is null");
    expect_failure(flgStyleGetData(host.context, style, nullptr, 0, nullptr), FLG_ERROR_INVALID_ARGUMENT,
                   "out_size is null");
    expect_failure(flgStyleGetData(host.context, {77}, nullptr, 0, &size), FLG_ERROR_INVALID_HANDLE, "style");
    expect_failure(flgStyleCreateFromData(host.context, nullptr, 5, &style), FLG_ERROR_INVALID_ARGUMENT,
                   "data is null");
    expect_failure(flgStyleCreateFromData(host.context, data.data(), data.size(), nullptr), FLG_ERROR_INVALID_ARGUMENT,
                   "out_style is null");
}

// Whichever allocation fails, nothing is lost (the host's destructor counts).
TEST(StyleData, SurvivesRunningOutOfMemory) {
    Host host;
    const std::string data = data_of(host, small_style(host));
    FlgResult result = FLG_ERROR_OUT_OF_MEMORY;
    for (int64_t k = 0; result != FLG_OK; ++k) {
        ASSERT_LT(k, 200);
        host.allocator.fail_at = host.allocator.calls + k;
        FlgStyle style{};
        result = load(host, data, style);
        if (result != FLG_OK) {
            ASSERT_EQ(result, FLG_ERROR_OUT_OF_MEMORY);
        }
    }
    host.allocator.fail_at = -1;
}

}  // namespace
}  // namespace flg::test
