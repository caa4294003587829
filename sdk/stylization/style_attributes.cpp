// SPDX-License-Identifier: MIT
#include "stylization/style_attributes.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "core/failure.h"
#include "curves/sampling_job.h"
#include "runtime/each.h"

namespace flg {

namespace {

// Of RADII.
constexpr uint32_t turn_component = 2;

double nearest(double value, double to, double period) {
    return value + period * std::round((to - value) / period);
}

struct AttributeName {
    char text[32];

    explicit AttributeName(FlgAttribute attribute) {
        const auto number = static_cast<int32_t>(attribute);
        switch (attribute) {
            case FLG_ATTRIBUTE_RADIUS: std::snprintf(text, sizeof text, "RADIUS"); break;
            case FLG_ATTRIBUTE_COLOR: std::snprintf(text, sizeof text, "COLOR"); break;
            case FLG_ATTRIBUTE_RADII: std::snprintf(text, sizeof text, "RADII"); break;
            case FLG_ATTRIBUTE_ANGLE: std::snprintf(text, sizeof text, "ANGLE"); break;
            case FLG_ATTRIBUTE_WIDTH: std::snprintf(text, sizeof text, "WIDTH"); break;
            case FLG_ATTRIBUTE_SPEED: std::snprintf(text, sizeof text, "SPEED"); break;
            default: std::snprintf(text, sizeof text, "USER + %d", number - FLG_ATTRIBUTE_USER);
        }
    }
};

FlgMetric resolved_metric(const FlgStyleAttribute& wanted) {
    if (wanted.metric != FLG_METRIC_AUTO) return wanted.metric;
    return wanted.attribute == FLG_ATTRIBUTE_ANGLE ? FLG_METRIC_CIRCLE : FLG_METRIC_EUCLIDEAN;
}

// The value of a point, at a fraction of the way from one point of the example, whose values are `from`, to the next.
void take(StyleAttribute& attribute, const float* from, double fraction, uint32_t point, bool is_first) {
    const uint32_t width = attribute.components;
    float* out = attribute.values.data() + size_t{point} * width;
    for (uint32_t k = 0; k < width; ++k) {
        const double period = attribute.period(k);
        const double a = from[k];
        double b = from[width + k];
        if (period > 0) b = nearest(b, a, period);
        double value = (1.0 - fraction) * a + fraction * b;
        if (period > 0 && !is_first) value = nearest(value, (out - width)[k], period);
        out[k] = static_cast<float>(value);
    }
    attribute.extend_ranges(point);
}

}  // namespace

uint32_t StyleAttribute::length_count() const {
    switch (attribute) {
        case FLG_ATTRIBUTE_RADIUS:
        case FLG_ATTRIBUTE_WIDTH: return 1;
        case FLG_ATTRIBUTE_RADII: return turn_component;
        default: return 0;
    }
}

uint32_t StyleAttribute::first_angle() const {
    if (attribute == FLG_ATTRIBUTE_RADII) return turn_component;
    return metric == FLG_METRIC_EUCLIDEAN ? components : 0;
}

double StyleAttribute::period(uint32_t component) const {
    if (component < first_angle()) return 0.0;
    return metric == FLG_METRIC_PROJECTIVE ? std::numbers::pi : 2 * std::numbers::pi;
}

void StyleAttribute::extend_ranges(uint32_t point) {
    const float* value = values.data() + size_t{point} * components;
    for (uint32_t k = 0; k < components; ++k) {
        ranges[k] = {std::min(ranges[k].low, value[k]), std::max(ranges[k].high, value[k])};
    }
}

bool can_transfer(int32_t attribute) {
    switch (attribute) {
        case FLG_ATTRIBUTE_RADIUS:
        case FLG_ATTRIBUTE_COLOR:
        case FLG_ATTRIBUTE_RADII:
        case FLG_ATTRIBUTE_ANGLE:
        case FLG_ATTRIBUTE_WIDTH:
        case FLG_ATTRIBUTE_SPEED: return true;
        default: return attribute >= FLG_ATTRIBUTE_USER;
    }
}

bool metric_fits(FlgAttribute attribute, uint32_t components, FlgMetric metric) {
    if (metric == FLG_METRIC_EUCLIDEAN || attribute == FLG_ATTRIBUTE_RADII) return true;
    return components == 1 && (attribute == FLG_ATTRIBUTE_ANGLE || attribute >= FLG_ATTRIBUTE_USER);
}

void check_attribute_column(const CurveSet& example, const FlgStyleAttribute& wanted, uint32_t index) {
    const Column* column = example.find(wanted.attribute);
    if (!column) {
        throw Failure(FLG_ERROR_INVALID_ARGUMENT, "desc.style has no column for desc.attributes[%u]: %s", index,
                      AttributeName(wanted.attribute).text);
    }
    const FlgMetric metric = resolved_metric(wanted);
    if (!metric_fits(wanted.attribute, column->components, metric)) {
        throw Failure(FLG_ERROR_INVALID_ARGUMENT,
                      "desc.attributes[%u]: metric %d does not fit %s of %u component%s, which is no single angle",
                      index, static_cast<int>(metric), AttributeName(wanted.attribute).text, column->components,
                      column->components == 1 ? "" : "s");
    }
}

StyleAttribute make_attribute(const CurveSet& example, const FlgStyleAttribute& wanted, uint32_t points,
                              Memory* memory) {
    const uint32_t components = example.find(wanted.attribute)->components;
    return {wanted.attribute,
            components,
            resolved_metric(wanted),
            wanted.weight,
            Buffer<float>(size_t{points} * components, memory),
            {}};
}

Task<void> take_values(Pace& pace, const CurveSet& example, uint32_t curve, std::span<const double> places,
                       uint32_t first_point, std::span<StyleAttribute> attributes) {
    SegmentStream stream(curve_view(example, curve));
    double segment_begin = 0, segment_end = 0;  // arc lengths
    Slice slice(Cost::hundreds_of_ns);
    for (uint32_t i = 0; i < places.size(); ++i) {
        while (places[i] >= segment_end && !stream.done()) {
            if (stream.advance()) {
                segment_begin = segment_end;
                segment_end += stream.segment().length();
            }
            if (slice.is_over()) co_await pace;
        }
        const double fraction = std::clamp((places[i] - segment_begin) / (segment_end - segment_begin), 0.0, 1.0);
        const size_t from = size_t{example.offsets()[curve]} + stream.index();
        for (StyleAttribute& attribute : attributes) {
            const float* values = example.find(attribute.attribute)->values.data() + from * attribute.components;
            take(attribute, values, fraction, first_point + i, i == 0);
        }
        if (slice.is_over()) co_await pace;
    }
}

Task<void> add_channels(Pace& pace, const StyleAttribute& attribute, std::pmr::vector<PatchChannel>& channels) {
    const uint32_t width = attribute.components;
    const size_t points = attribute.values.size() / width;
    const double weight = attribute.weight;
    for (uint32_t component = 0; component < width; ++component) {
        const double period = weight * attribute.period(component);
        channels.push_back({Buffer<double>(points, pace.memory()), period});
        const auto weigh = [=, from = attribute.values.data() + component,
                            to = channels.back().values.data()](uint32_t point) {
            const double value = weight * from[size_t{point} * width];
            // Rounding can give the period itself, which is as good as 0.
            to[point] = period > 0 ? value - period * std::floor(value / period) : value;
        };
        co_await each(pace, points, Cost::some_ns, weigh);
    }
}

}  // namespace flg
