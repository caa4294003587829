// SPDX-License-Identifier: MIT
// Prepared styles as bytes.
#include "api/descriptors.h"
#include "stylization/style_file.h"

using namespace flg;

extern "C" {

FlgResult flgStyleGetData(FlgContext context, FlgStyle style, void* out_data, size_t capacity, size_t* out_size) {
    return guarded([&] {
        require(out_size, "out_size") = 0;
        if (!out_data && capacity > 0) {
            throw Failure(FLG_ERROR_INVALID_ARGUMENT, "out_data is null, but capacity is %zu", capacity);
        }
        const std::shared_ptr<Style> self = get_context(context).styles.get(style.id, "style");
        const FlgResult result = visible_result_now(*self);
        if (result != FLG_OK) return result;
        const size_t size = style_file_size(self->prepared);
        *out_size = size;
        if (!out_data) return FLG_OK;
        if (capacity < size) throw Failure(FLG_ERROR_LIMIT, "capacity is %zu, the style has %zu bytes", capacity, size);
        write_style_file(self->prepared, {static_cast<std::byte*>(out_data), size});
        return FLG_OK;
    });
}

FlgResult flgStyleCreateFromData(FlgContext context, const void* data, size_t size, FlgStyle* out_style) {
    return guarded([&] {
        require(out_style, "out_style") = {};
        Context& self = get_context(context);
        Memory* const memory = self.memory[MemoryKind::styles];
        if (!data) throw Failure(FLG_ERROR_INVALID_ARGUMENT, "data is null");
        auto style = make_object<Style>(memory, memory, self.memory[MemoryKind::caches]);
        read_style_file({static_cast<const std::byte*>(data), size}, style->prepared, memory);
        style->publish_complete();
        *out_style = {self.styles.add(std::move(style))};
    });
}

}  // extern "C"
