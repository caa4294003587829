// SPDX-License-Identifier: MIT
// The loops that are compiled for several processors, as this one runs them and as every compiler without options
// makes them: the same bits.
#include <gtest/gtest.h>

#include <cstring>
#include <random>
#include <vector>

#include "curves/sample_block.h"

namespace flg::plain {
#include "curves/sample_block.inl"
#include "curves/segment_block.inl"
}  // namespace flg::plain

namespace flg::test {
namespace {

constexpr uint32_t segments = SegmentBlock::capacity;

// A walk with sharp turns, gentle ones and a reversal.
SegmentBlock random_block(uint32_t seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> side(-1, 1);
    SegmentBlock block{};
    Vec3 place = Vec3::Zero(), way = Vec3::UnitX();
    for (uint32_t j = 0; j <= segments + 1; ++j) {
        block.points.set(j, place.cast<float>().cast<double>());
        const double turn = j % 5 == 0 ? 1.0 : 0.05;
        way = (way + turn * Vec3(side(random), side(random), side(random))).normalized();
        if (j == 9) way = -way;
        place += 0.3 * (1.2 + side(random)) * way;
    }
    block.directions.set(0, Vec3::UnitX());
    block.chords[0] = 1;
    return block;
}

bool same_bits(const void* a, const void* b, size_t size) {
    return std::memcmp(a, b, size) == 0;
}

TEST(VectorTargets, CurvesHaveTheSameBitsOnEveryProcessor) {
    for (uint32_t seed = 1; seed <= 20; ++seed) {
        SegmentBlock here = random_block(seed), there = here;
        SegmentBlock::Vectors tangents{}, plain_tangents{};
        double cosines[SegmentBlock::size] = {}, plain_cosines[SegmentBlock::size] = {};
        here.make_edges(segments);
        plain::make_edges(there, segments);
        here.make_vertices(segments, tangents, cosines);
        plain::make_vertices(there, segments, plain_tangents, plain_cosines);
        for (uint32_t j = 0; j < segments; ++j) {
            here.tangents_start.set(j, tangents[j]), there.tangents_start.set(j, plain_tangents[j]);
            here.tangents_end.set(j, tangents[j + 1]), there.tangents_end.set(j, plain_tangents[j + 1]);
        }
        here.measure(segments);
        plain::measure_segments(there, segments);
        EXPECT_TRUE(same_bits(cosines, plain_cosines, sizeof cosines));
        EXPECT_TRUE(same_bits(&here, &there, sizeof here)) << seed;

        SegmentRows rows{}, plain_rows{};
        make_rows(here, 1, segments, rows);
        plain::make_rows(there, 1, segments, plain_rows);
        EXPECT_TRUE(same_bits(&rows, &plain_rows, sizeof rows)) << seed;

        SampleBlock samples{}, plain_samples{};
        samples.count = SampleBlock::capacity;
        for (uint32_t k = 0; k < samples.count; ++k) {
            const uint32_t j = 1 + k * (segments - 2) / samples.count;
            samples.row[k] = static_cast<int32_t>(j);
            samples.along[k] = rows.length[j] * static_cast<float>(k % 7) / 6;
        }
        plain_samples = samples;
        place_samples(rows, samples);
        plain::place_samples(plain_rows, plain_samples);
        EXPECT_TRUE(same_bits(&samples, &plain_samples, sizeof samples)) << seed;
        FrameChain chain(0.1);
        chain.begin(samples, Vec3::UnitY());
        chain.follow(samples);
        for (int c = 0; c < 3; ++c) {
            plain_samples.start[c][0] = samples.start[c][0];
            plain_samples.offset[c][0] = samples.offset[c][0];
            plain_samples.tangent[c][0] = samples.tangent[c][0];
        }
        plain::find_steps(plain_samples, static_cast<float>(1 / 0.1));
        EXPECT_TRUE(same_bits(samples.first, plain_samples.first, sizeof samples.first)) << seed;
        EXPECT_TRUE(same_bits(samples.real[1], plain_samples.real[1], sizeof samples.real[1])) << seed;
    }
}

TEST(VectorTargets, AnyNumberOfPointsIsPacked) {
    SampleBlock block{};
    for (uint32_t k = 0; k < SampleBlock::size; ++k) {
        for (uint32_t c = 0; c < 3; ++c) block.tangent[c][k] = static_cast<float>(3 * k + c);
    }
    for (uint32_t count = 0; count <= SampleBlock::capacity; ++count) {
        std::vector<float> packed(3 * SampleBlock::size, -1.0f);
        pack(block.tangent, count, packed.data());
        // Slot k + 1 is sample k's; behind the last one nothing is written.
        for (uint32_t i = 0; i < packed.size(); ++i) {
            ASSERT_EQ(packed[i], i < 3 * count ? static_cast<float>(i + 3) : -1.0f) << count << ", " << i;
        }
    }
}

}  // namespace
}  // namespace flg::test
