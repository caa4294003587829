// SPDX-License-Identifier: MIT
// Styles for the tests of this room.
#pragma once

#include "api/host.h"

namespace flg::test {

// Curves with any columns besides their positions.
struct Columns {
    Curves curves;
    struct Extra {
        FlgAttribute attribute;
        uint32_t components;
        std::vector<float> values;
    };
    std::vector<Extra> extra = {};

    // A value for each component of each point.
    template <class Value>
    Columns& with(FlgAttribute attribute, uint32_t components, Value value) {
        Extra column{attribute, components, {}};
        for (uint32_t i = 0; i < curves.offsets.back(); ++i) {
            for (uint32_t k = 0; k < components; ++k) column.values.push_back(static_cast<float>(value(i, k)));
        }
        extra.push_back(std::move(column));
        return *this;
    }
    FlgCurveSet create(const Host& host) {
        FlgCurveSetView view = curves.view();
        std::vector<FlgColumn> columns = curves.columns;
        for (const Extra& column : extra) {
            columns.push_back({column.attribute, column.components, column.values.data(), 0, 0});
        }
        view.columns = columns.data();
        view.column_count = static_cast<uint32_t>(columns.size());
        FlgCurveSet set{};
        EXPECT_EQ(flgCurveSetCreate(host.context, &view, &set), FLG_OK) << flgErrorGetMessage();
        return set;
    }
};

// Several coils of different lengths, one behind the other.
inline Curves coils(const std::vector<double>& lengths) {
    Curves curves;
    for (size_t c = 0; c < lengths.size(); ++c) {
        const Curves one = coil(200, 2 * lengths[c], lengths[c], 0.2 + 0.03 * static_cast<double>(c));
        for (size_t i = 0; i < one.positions.size(); i += 3) {
            curves.add_point(one.positions[i], one.positions[i + 1] + 2.0 * static_cast<double>(c),
                             one.positions[i + 2]);
        }
        curves.end_curve();
    }
    return curves;
}

inline FlgStyleInfo style_info(const Host& host, FlgStyle style) {
    FlgStyleInfo info{};
    info.struct_size = sizeof info;
    EXPECT_EQ(flgStyleGetInfo(host.context, style, &info), FLG_OK) << flgErrorGetMessage();
    return info;
}

// Prepares a style to the end.
inline FlgStyle prepare(const Host& host, const FlgStyleDesc& desc) {
    FlgStyle style{};
    FlgJob job{};
    EXPECT_EQ(flgStyleCreate(host.context, &desc, &style, &job), FLG_OK) << flgErrorGetMessage();
    host.finish();
    EXPECT_EQ(host.result_of(job), FLG_OK) << host.status_of(job).error;
    return style;
}

// Expects the style's job to fail with a sentence that contains `words`.
inline void expect_failing_job(const Host& host, const FlgStyleDesc& desc, FlgResult expected, const char* words) {
    FlgStyle style{};
    FlgJob job{};
    ASSERT_EQ(flgStyleCreate(host.context, &desc, &style, &job), FLG_OK) << flgErrorGetMessage();
    host.finish();
    EXPECT_EQ(host.result_of(job), expected);
    EXPECT_NE(std::strstr(host.status_of(job).error, words), nullptr) << host.status_of(job).error;
}

inline FlgCurveSet stylize(const Host& host, FlgCurveSetStylizeDesc desc) {
    FlgCurveSet out{};
    FlgJob job{};
    EXPECT_EQ(flgCurveSetStylize(host.context, &desc, &out, &job), FLG_OK) << flgErrorGetMessage();
    host.finish();
    EXPECT_EQ(host.result_of(job), FLG_OK) << host.status_of(job).error;
    return out;
}

}  // namespace flg::test
