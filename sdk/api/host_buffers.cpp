// SPDX-License-Identifier: MIT
#include "api/host_buffers.h"

#include <algorithm>
#include <cstdarg>

#include "api/columns.h"
#include "api/inputs.h"
#include "core/number_formats.h"

namespace flg {

namespace {

constexpr uint32_t max_colors = 4;      // components of SRGB8
constexpr uint32_t direction_size = 3;  // of OCTAHEDRAL16

bool takes(FlgAttribute attribute, FlgNumberFormat format) {
    const bool own = attribute >= FLG_ATTRIBUTE_USER;
    const bool whole =
        attribute == FLG_ATTRIBUTE_JOINTS || attribute == FLG_ATTRIBUTE_PART || attribute == FLG_ATTRIBUTE_LABEL;
    const bool direction = attribute == FLG_ATTRIBUTE_NORMAL || attribute == FLG_ATTRIBUTE_TANGENT;
    switch (format) {
        case FLG_NUMBER_FORMAT_FLOAT32:
        case FLG_NUMBER_FORMAT_FLOAT16: return !whole;
        case FLG_NUMBER_FORMAT_UNORM8:
        case FLG_NUMBER_FORMAT_UNORM16:
            return own || attribute == FLG_ATTRIBUTE_COLOR || attribute == FLG_ATTRIBUTE_PRESSURE ||
                   attribute == FLG_ATTRIBUTE_WEIGHTS || attribute == FLG_ATTRIBUTE_VALUE;
        case FLG_NUMBER_FORMAT_SNORM8:
        case FLG_NUMBER_FORMAT_SNORM16: return own || direction || attribute == FLG_ATTRIBUTE_ORIENTATION;
        case FLG_NUMBER_FORMAT_OCTAHEDRAL16: return direction;
        case FLG_NUMBER_FORMAT_SRGB8: return attribute == FLG_ATTRIBUTE_COLOR;
        default: return whole;
    }
}

}  // namespace

BlockName::BlockName(const char* format, ...) {
    va_list arguments;
    va_start(arguments, format);
    std::vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
}

bool Block::meets(const Block& other) const {
    if (count == 0 || other.count == 0) return false;
    const auto begin = reinterpret_cast<uintptr_t>(data), other_begin = reinterpret_cast<uintptr_t>(other.data);
    const uintptr_t end = begin + (count - 1) * stride + size;
    const uintptr_t other_end = other_begin + (other.count - 1) * other.stride + other.size;
    if (begin >= other_end || other_begin >= end) return false;
    if (stride != other.stride) return true;
    // Interleaved: one lies in the gaps of the other.
    const uint64_t low_size = begin <= other_begin ? size : other.size;
    const uint64_t high_size = begin <= other_begin ? other.size : size;
    const uint64_t offset = (std::max(begin, other_begin) - std::min(begin, other_begin)) % stride;
    return offset < low_size || offset + high_size > stride;
}

void Blocks::add_output(const Block& block) {
    blocks_[count_++] = block;
    output_count_ = count_;
}

void Blocks::add_input(const FlgColumn& column, uint64_t rows, const BlockName& name) {
    const uint64_t size = column.components * sizeof(float);
    add_input({name, column.data, column.stride ? column.stride : size, size, rows});
}

void Blocks::check_apart() const {
    for (uint32_t a = 0; a < output_count_; ++a) {
        for (uint32_t b = 0; b < count_; ++b) {
            if (b >= a && b < output_count_) continue;
            if (!blocks_[a].meets(blocks_[b])) continue;
            throw Failure(FLG_ERROR_INVALID_ARGUMENT, "%s overlaps %s", blocks_[a].name.text, blocks_[b].name.text);
        }
    }
}

void check_buffer_column(const FlgBufferColumn* columns, uint32_t i) {
    const FlgBufferColumn& column = columns[i];
    const auto named = [i](const char* field) { return BlockName("output.columns[%u].%s", i, field); };
    const int32_t attribute = number_of(column.attribute);
    const int own = components_of(attribute);
    if (own < 0) {
        throw Failure(FLG_ERROR_INVALID_ARGUMENT, "output.columns[%u].attribute is %d, not one of FLG_ATTRIBUTE_...", i,
                      attribute);
    }
    for (uint32_t j = 0; j < i; ++j) {
        if (number_of(columns[j].attribute) == attribute)
            throw Failure(FLG_ERROR_INVALID_ARGUMENT, "output.columns[%u].attribute is %d once more", i, attribute);
    }
    check_enum(column.format, FLG_NUMBER_FORMAT_FLOAT32, FLG_NUMBER_FORMAT_SRGB8, named("format").text,
               "FLG_NUMBER_FORMAT_");
    if (!takes(column.attribute, column.format)) {
        throw Failure(FLG_ERROR_INVALID_ARGUMENT, "output.columns[%u].format is %d, which attribute %d cannot have", i,
                      static_cast<int>(column.format), attribute);
    }
    if (column.format == FLG_NUMBER_FORMAT_OCTAHEDRAL16)
        check_range(column.components == 0 || column.components == direction_size, named("components").text,
                    column.components, "0 or 3 for FLG_NUMBER_FORMAT_OCTAHEDRAL16");
    if (column.format == FLG_NUMBER_FORMAT_SRGB8)
        check_range(column.components <= max_colors, named("components").text, column.components,
                    "0 to 4 for FLG_NUMBER_FORMAT_SRGB8");
    check_range(column.components <= max_user_components, named("components").text, column.components, "0 to 16");
    const uint32_t number = bytes_of(column.format);
    check_aligned(column.data, number, named("data").text);
    const uint32_t components = column.components ? column.components : std::max(static_cast<uint32_t>(own), 1u);
    checked_stride(column.stride, number, row_size(column.format, components), named("stride").text);
    const bool whole = is_whole(column.format);
    for (uint32_t k = 0; k < 4; ++k) {
        if (whole ? column.fill[k] == 0 : is_coordinate(column.fill[k])) continue;
        check_range(false, BlockName("output.columns[%u].fill[%u]", i, k).text, double{column.fill[k]},
                    whole ? "0 for whole numbers" : "finite and at most 1e30 in size");
    }
    check_range(!whole || column.optional == 0, named("optional").text, column.optional, "0 for whole numbers");
    check_range(column.reserved == 0, named("reserved").text, column.reserved, "0");
}

void check_aligned(const void* data, uint32_t number, const char* name) {
    if (!data) throw Failure(FLG_ERROR_INVALID_ARGUMENT, "%s is null", name);
    if (reinterpret_cast<uintptr_t>(data) % number != 0)
        throw Failure(FLG_ERROR_INVALID_ARGUMENT, "%s is %p, must be aligned to %u bytes", name, data, number);
}

uint32_t checked_stride(uint32_t stride, uint32_t number, uint32_t size, const char* name) {
    if (stride != 0 && (stride % number != 0 || stride < size)) {
        throw Failure(FLG_ERROR_INVALID_ARGUMENT, "%s is %u bytes, must be 0 or a multiple of %u and at least %u", name,
                      stride, number, size);
    }
    return stride ? stride : size;
}

void check_capacity(uint64_t capacity, uint64_t needed, const char* name) {
    if (capacity >= needed) return;
    throw Failure(FLG_ERROR_INVALID_ARGUMENT, "%s is %llu, must be at least %llu", name,
                  static_cast<unsigned long long>(capacity), static_cast<unsigned long long>(needed));
}

void check_indices(const void* indices, const FlgNumberFormat& format, uint64_t capacity, uint64_t count,
                   uint64_t end_vertex) {
    constexpr uint64_t narrow_vertices = 65535;  // the last number has another meaning
    check_enum(format, FLG_NUMBER_FORMAT_UINT16, FLG_NUMBER_FORMAT_UINT32, "output.index_format",
               "FLG_NUMBER_FORMAT_UINT");
    check_aligned(indices, bytes_of(format), "output.indices");
    check_capacity(capacity, count, "output.index_capacity");
    if (format == FLG_NUMBER_FORMAT_UINT16 && end_vertex > narrow_vertices) {
        throw Failure(
            FLG_ERROR_LIMIT,
            "output.index_format is FLG_NUMBER_FORMAT_UINT16, but the last vertex is number %llu; the limit is "
            "65534",
            static_cast<unsigned long long>(end_vertex - 1));
    }
    if (end_vertex > UINT32_MAX) {
        throw Failure(FLG_ERROR_LIMIT, "output.indices: the last vertex is number %llu, the limit is 2^32 - 2",
                      static_cast<unsigned long long>(end_vertex - 1));
    }
}

}  // namespace flg
