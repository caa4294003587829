// SPDX-License-Identifier: MIT
// Prepared styles as bytes: refused, or a style that can be applied, and gives the same bytes again. Input is what
// follows the header, which is put before it as it must be: the hash would refuse all else.
#include <cstring>
#include <vector>

#include "fuzz/bounded_memory.h"
#include "stylization/style_file.h"

namespace {

constexpr size_t max_bytes = size_t{256} << 20;
constexpr uint32_t point_limit = 20'000;

void apply(FlgContext context, FlgStyle style) {
    const float line[] = {0, 0, 0, 1, 0, 0, 1, 2, 0};
    const uint32_t offsets[] = {0, 3};
    const FlgColumn column{FLG_ATTRIBUTE_POSITION, 3, line, 0, 0};
    FlgCurveSetView view = flgCurveSetViewDefaults();
    view.curve_count = 1;
    view.curve_offsets = offsets;
    view.columns = &column;
    view.column_count = 1;
    FlgCurveSetStylizeDesc desc = flgCurveSetStylizeDefaults();
    FlgCurveSet result = {};
    desc.style = style;
    desc.temperature = 1;
    desc.max_points = point_limit;
    FLG_DEMAND(flgCurveSetCreate(context, &view, &desc.target) == FLG_OK);
    FLG_DEMAND(flgCurveSetStylize(context, &desc, &result, nullptr) == FLG_OK);
    FLG_DEMAND(flgContextTick(context, FLG_UNLIMITED, nullptr) == FLG_OK);
    flgCurveSetGetView(context, result, &view);
}

std::vector<uint8_t> with_header(const uint8_t* content, size_t content_size) {
    std::vector<uint8_t> data(flg::style_file_content_offset + content_size);
    const uint32_t version = 1;
    const uint64_t size = data.size(), hash = flg::style_file_hash(std::as_bytes(std::span(content, content_size)));
    std::memcpy(data.data(), "FLGSTYLE", 8);
    std::memcpy(data.data() + 8, &version, sizeof version);
    std::memcpy(data.data() + 16, &size, sizeof size);
    std::memcpy(data.data() + flg::style_file_hash_offset, &hash, sizeof hash);
    if (content_size > 0) std::memcpy(data.data() + flg::style_file_content_offset, content, content_size);
    return data;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* content, size_t content_size) {
    const std::vector<uint8_t> data = with_header(content, content_size);
    flg::fuzz::BoundedMemory memory(max_bytes);
    FlgContextDesc desc = flgContextDefaults();
    desc.worker_count = 0;
    desc.allocator = memory.hooks();
    FlgContext context{};
    FLG_DEMAND(flgContextCreate(&desc, &context) == FLG_OK);
    FlgStyle style = {};
    const FlgResult result = flgStyleCreateFromData(context, data.data(), data.size(), &style);
    if (result == FLG_OK) {
        size_t same_size = 0;
        FLG_DEMAND(flgStyleGetData(context, style, nullptr, 0, &same_size) == FLG_OK && same_size == data.size());
        std::vector<uint8_t> same(same_size);
        FLG_DEMAND(flgStyleGetData(context, style, same.data(), same_size, &same_size) == FLG_OK);
        FLG_DEMAND(same == data);
        apply(context, style);
    } else {
        FLG_DEMAND(style.id == 0);
        FLG_DEMAND(result == FLG_ERROR_FORMAT || result == FLG_ERROR_OUT_OF_MEMORY ||
                   result == FLG_ERROR_INVALID_ARGUMENT);
    }
    FLG_DEMAND(flgContextDestroy(context) == FLG_OK);
    return 0;
}
