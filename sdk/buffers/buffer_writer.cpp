// SPDX-License-Identifier: MIT
#include "buffers/buffer_writer.h"

#include <algorithm>
#include <cstring>
#include <limits>
#include <type_traits>

#include "core/failure.h"
#include "core/number_formats.h"
#include "runtime/each.h"

namespace flg {

namespace {

constexpr uint32_t max_components = 16;
constexpr uint32_t numbers_a_step = 512;  // about a microsecond
constexpr uint32_t rows_prepared = 32;
constexpr uint32_t triangles_a_step = 256;

// Rows of floats, `stride` floats from one to the next.
struct FloatRows {
    const float* data;
    size_t stride;
};

// `fixed` components, 0: as many as `to` has.
template <uint32_t fixed, class Convert>
void store_rows(FloatRows from, const FlgBufferColumn& to, char* at, uint32_t rows, Convert convert) {
    using Number = decltype(convert(0.0f));
    const uint32_t components = fixed ? fixed : to.components;
    for (uint32_t r = 0; r < rows; ++r, from.data += from.stride, at += to.stride) {
        auto* const numbers = reinterpret_cast<Number*>(at);
        for (uint32_t k = 0; k < components; ++k) numbers[k] = convert(from.data[k]);
    }
}

template <class Convert>
void store_rows(const FloatRows& from, const FlgBufferColumn& to, char* at, uint32_t rows, Convert convert) {
    switch (to.components) {
        case 1: return store_rows<1>(from, to, at, rows, convert);
        case 2: return store_rows<2>(from, to, at, rows, convert);
        case 3: return store_rows<3>(from, to, at, rows, convert);
        case 4: return store_rows<4>(from, to, at, rows, convert);
        default: return store_rows<0>(from, to, at, rows, convert);
    }
}

void store(const FloatRows& from, const FlgBufferColumn& to, uint32_t begin, uint32_t rows) {
    char* const at = static_cast<char*>(to.data) + size_t{begin} * to.stride;
    if (is_of_rows(to.format)) {
        for (uint32_t r = 0; r < rows; ++r)
            store_row(to.format, from.data + r * from.stride, to.components, at + size_t{r} * to.stride);
        return;
    }
    with_conversion(to.format, [&](auto convert) {
        using Number = decltype(convert(0.0f));
        if (from.stride != to.components || to.stride != to.components * sizeof(Number))
            return store_rows(from, to, at, rows, convert);
        const size_t count = size_t{rows} * to.components;
        if constexpr (std::is_same_v<Number, float>) {
            std::memcpy(at, from.data, count * sizeof(float));
        } else {
            auto* const numbers = reinterpret_cast<Number*>(at);
            for (size_t i = 0; i < count; ++i) numbers[i] = convert(from.data[i]);
        }
    });
}

// Bit k: component k changes its sign in a left-handed space of which z points the other way. There the second normal
// is tangent x normal too, so that angles from the first to it turn the other way.
uint32_t mirrored_components(FlgAttribute attribute) {
    switch (attribute) {
        case FLG_ATTRIBUTE_POSITION:
        case FLG_ATTRIBUTE_TANGENT:
        case FLG_ATTRIBUTE_NORMAL:
        case FLG_ATTRIBUTE_DISPLACEMENT:
        case FLG_ATTRIBUTE_RADII: return 1u << 2;
        case FLG_ATTRIBUTE_ORIENTATION: return 1u << 0 | 1u << 1;
        case FLG_ATTRIBUTE_ANGLE: return 1u << 0;
        default: return 0;
    }
}

// How a column's numbers change before they are stored.
struct Preparation {
    const ResultColumn& from;
    const FlgBufferColumn& to;
    const double* shift;  // null: none
    uint32_t mirrored;
    uint32_t whole_weight;  // the number that stands for weight 1; 0: not weights that are normalized

    Preparation(const ColumnCopy& column, const BufferPlan& plan)
        : from(column.from),
          to(column.to),
          shift(plan.shifted && from.attribute == FLG_ATTRIBUTE_POSITION ? plan.shift : nullptr),
          mirrored(plan.left_handed ? mirrored_components(to.attribute) : 0),
          whole_weight(to.attribute != FLG_ATTRIBUTE_WEIGHTS    ? 0
                       : to.format == FLG_NUMBER_FORMAT_UNORM8  ? 255
                       : to.format == FLG_NUMBER_FORMAT_UNORM16 ? 65535
                                                                : 0) {}

    bool nothing() const {
        return from.data && to.components <= from.components && !shift && mirrored == 0 && whole_weight == 0;
    }

    void row(const float* values, float* out) const {
        const uint32_t given = values ? std::min(from.components, to.components) : 0;
        for (uint32_t k = 0; k < given; ++k) out[k] = values[k];
        for (uint32_t k = given; k < to.components; ++k) out[k] = k < 4 ? to.fill[k] : 0;
        if (shift)
            for (uint32_t k = 0; k < std::min(given, 3u); ++k)
                out[k] = static_cast<float>(static_cast<double>(out[k]) + shift[k]);
        for (uint32_t k = 0; k < given; ++k)
            if (mirrored >> k & 1u) out[k] = -out[k];
        // What rounding the others takes or leaves, the first one has.
        if (whole_weight && given > 0) {
            const auto whole = static_cast<float>(whole_weight);
            int32_t left = static_cast<int32_t>(whole_weight);
            for (uint32_t k = 1; k < from.components; ++k) left -= to_nearest(clamped(values[k], 0, 1) * whole);
            out[0] = static_cast<float>(left) / whole;
        }
    }
};

template <class From, class To>
void store_whole(const ColumnCopy& column, const char* from, char* at, uint32_t rows) {
    constexpr uint32_t most = std::numeric_limits<To>::max();
    for (uint32_t r = 0; r < rows; ++r, from += column.from.stride, at += column.to.stride) {
        const auto* const values = reinterpret_cast<const From*>(from);
        auto* const numbers = reinterpret_cast<To*>(at);
        for (uint32_t k = 0; k < column.to.components; ++k)
            numbers[k] = static_cast<To>(std::min(uint32_t{values[k]}, most));
    }
}

template <class From>
void store_whole(const ColumnCopy& column, const char* from, char* at, uint32_t rows) {
    switch (column.to.format) {
        case FLG_NUMBER_FORMAT_UINT8: return store_whole<From, uint8_t>(column, from, at, rows);
        case FLG_NUMBER_FORMAT_UINT16: return store_whole<From, uint16_t>(column, from, at, rows);
        default: return store_whole<From, uint32_t>(column, from, at, rows);
    }
}

// Rows begin to end - 1 of those that are written.
void write_column(const BufferPlan& plan, const ColumnCopy& column, uint32_t begin, uint32_t end) {
    const FlgBufferColumn& to = column.to;
    const ResultColumn& from = column.from;
    const auto row_at = [&](uint32_t row) {
        return from.data ? static_cast<const char*>(from.data) + (size_t{plan.first_row} + row) * from.stride : nullptr;
    };
    if (is_whole(to.format)) {
        char* const at = static_cast<char*>(to.data) + size_t{begin} * to.stride;
        if (from.format == FLG_NUMBER_FORMAT_UINT16)
            return store_whole<uint16_t>(column, row_at(begin), at, end - begin);
        return store_whole<uint32_t>(column, row_at(begin), at, end - begin);
    }
    const Preparation prepare(column, plan);
    if (prepare.nothing()) {
        const FloatRows rows{reinterpret_cast<const float*>(row_at(begin)), from.stride / sizeof(float)};
        return store(rows, to, begin, end - begin);
    }
    float prepared[rows_prepared * max_components];
    while (begin < end) {
        const uint32_t rows = std::min(end - begin, rows_prepared);
        for (uint32_t r = 0; r < rows; ++r)
            prepare.row(reinterpret_cast<const float*>(row_at(begin + r)), prepared + size_t{r} * to.components);
        store({prepared, to.components}, to, begin, rows);
        begin += rows;
    }
}

uint32_t rows_a_step(const BufferPlan& plan) {
    uint32_t numbers = 1;
    for (uint32_t c = 0; c < plan.column_count; ++c) numbers += plan.columns[c].to.components;
    return std::max(numbers_a_step / numbers, 1u);
}

void write_rows(const BufferPlan& plan, uint32_t begin, uint32_t end) {
    for (uint32_t c = 0; c < plan.column_count; ++c) write_column(plan, plan.columns[c], begin, end);
}

template <class Index>
void store_indices(const BufferPlan& plan, uint32_t begin, uint32_t end) {
    auto* to = static_cast<Index*>(plan.indices) + size_t{3} * begin;
    const uint32_t* from = plan.triangles + size_t{3} * begin;
    const uint32_t second = plan.left_handed ? 2 : 1;
    for (uint32_t t = begin; t < end; ++t, to += 3, from += 3) {
        to[0] = static_cast<Index>(plan.base_vertex + from[0]);
        to[1] = static_cast<Index>(plan.base_vertex + from[second]);
        to[2] = static_cast<Index>(plan.base_vertex + from[3 - second]);
    }
}

// Labels of triangles, which all have one.
ColumnCopy label_copy(const BufferPlan& plan) {
    ColumnCopy column{};
    column.from = {FLG_ATTRIBUTE_PART, FLG_NUMBER_FORMAT_UINT32, 1, sizeof(uint32_t), plan.regions};
    column.to.attribute = FLG_ATTRIBUTE_PART;
    column.to.format = plan.label_format;
    column.to.data = plan.labels;
    column.to.components = 1;
    column.to.stride = bytes_of(plan.label_format);
    return column;
}

// Triangles begin to end - 1 of those that are written.
void write_triangles(const BufferPlan& plan, uint32_t begin, uint32_t end) {
    if (plan.indices && plan.index_format == FLG_NUMBER_FORMAT_UINT16) store_indices<uint16_t>(plan, begin, end);
    if (plan.indices && plan.index_format == FLG_NUMBER_FORMAT_UINT32) store_indices<uint32_t>(plan, begin, end);
    if (!plan.labels) return;
    const ColumnCopy column = label_copy(plan);
    store_whole<uint32_t>(column, reinterpret_cast<const char*>(plan.regions + begin),
                          static_cast<char*>(plan.labels) + size_t{begin} * column.to.stride, end - begin);
}

// Refuses a whole number that its format cannot hold. No index has the format's largest number, if there may be one.
Task<void> check_whole(Pace& pace, const ColumnCopy& column, uint32_t first, uint32_t count, const char* name) {
    const uint32_t bytes = bytes_of(column.to.format);
    if (!is_whole(column.to.format) || bytes >= bytes_of(column.from.format)) co_return;
    const bool may_be_none =
        column.to.attribute == FLG_ATTRIBUTE_LABEL && column.from.format == FLG_NUMBER_FORMAT_UINT32;
    const uint32_t most = (1u << 8 * bytes) - 1 - (may_be_none ? 1 : 0);
    const char* const rows = static_cast<const char*>(column.from.data) + size_t{first} * column.from.stride;
    uint32_t largest = 0;
    co_await each(pace, count, Cost::some_ns, [&column, &largest, rows](uint32_t r) {
        const char* const row = rows + size_t{r} * column.from.stride;
        for (uint32_t k = 0; k < column.to.components; ++k) {
            const uint32_t value = column.from.format == FLG_NUMBER_FORMAT_UINT16
                                       ? uint32_t{reinterpret_cast<const uint16_t*>(row)[k]}
                                       : reinterpret_cast<const uint32_t*>(row)[k];
            if (value != UINT32_MAX) largest = std::max(largest, value);
        }
    });
    if (largest > most)
        throw Failure(FLG_ERROR_LIMIT, "%s holds %u, the most that its format can hold is %u", name, largest, most);
}

}  // namespace

void write_buffers(const BufferPlan& plan) {
    if (plan.column_count > 0) {
        const uint32_t step = plan.column_count > 1 ? rows_a_step(plan) : plan.row_count;
        for (uint32_t begin = 0, end; begin < plan.row_count; begin = end) {
            end = begin + std::min(plan.row_count - begin, step);
            write_rows(plan, begin, end);
        }
    }
    write_triangles(plan, 0, plan.triangle_count);
}

Task<void> write_buffers(Pace& pace, const BufferPlan& plan) {
    const uint32_t rows = plan.column_count > 0 ? plan.row_count : 0;
    const uint32_t triangles = plan.indices || plan.labels ? plan.triangle_count : 0;
    pace.stage("numbers");
    for (uint32_t c = 0; c < plan.column_count; ++c) {
        char name[32];
        std::snprintf(name, sizeof name, "output.columns[%u]", c);
        co_await check_whole(pace, plan.columns[c], plan.first_row, rows, name);
    }
    if (plan.labels) {
        const ColumnCopy labels = label_copy(plan);
        co_await check_whole(pace, labels, 0, triangles, "output.regions");
    }
    pace.stage("buffers");
    pace.expect(uint64_t{rows} + triangles);
    const uint32_t step = rows_a_step(plan);
    co_await each(pace, (size_t{rows} + step - 1) / step, Cost::microseconds, [&](uint32_t s) {
        const uint32_t begin = s * step, end = begin + std::min(rows - begin, step);
        write_rows(plan, begin, end);
        pace.advance(end - begin);
    });
    co_await each(pace, (size_t{triangles} + triangles_a_step - 1) / triangles_a_step, Cost::microseconds,
                  [&](uint32_t s) {
                      const uint32_t begin = s * triangles_a_step;
                      const uint32_t end = begin + std::min(triangles - begin, triangles_a_step);
                      write_triangles(plan, begin, end);
                      pace.advance(end - begin);
                  });
}

}  // namespace flg
