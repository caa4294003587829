// SPDX-License-Identifier: MIT
// What entry points share: defaults for structs, outputs cleared before work begins, views of what jobs made, handles
// given back.
#pragma once

#include "api/context.h"
#include "api/error.h"
#include "core/sized_struct.h"

namespace flg {

// The whole of an entry point that fills a struct with its defaults.
template <class T>
FlgResult init(T* out, uint32_t struct_size, const T& defaults, const char* name = "desc") {
    return guarded([&] { init_struct(out, struct_size, defaults, name); });
}

template <class View>
FlgResult init_view(View* view, uint32_t struct_size) {
    return init(view, struct_size, sized<View>(), "view");
}

// Clears what an entry point that starts a job hands out.
template <class Handle>
Context& clear_outputs(FlgContext context, Handle* out, const char* name, FlgJob* out_job) {
    if (out_job) *out_job = {};
    require(out, name) = {};
    return get_context(context);
}

// Likewise one that makes something at once.
template <class Handle>
Context& clear_output(FlgContext context, Handle* out, const char* name) {
    require(out, name) = {};
    Context& self = get_context(context);
    refuse_after_destroy(self);
    return self;
}

// Whether what a job makes can be seen now: FLG_NOT_READY while it is made, its job's error if that failed.
template <class Product>
FlgResult visible_result_now(const Product& product) {
    const FlgResult result = product.visible_result();
    return result < 0 ? set_last_error(result, product.error()) : result;
}

// The whole of an entry point that shows a product: `find` gives it, or throws; until it can be seen, `empty` is shown.
template <class Out, class Find, class Describe>
FlgResult show(Out* out, const char* name, const Out& empty, Find find, Describe describe) {
    return guarded([&] {
        write_struct(out, empty, name);
        const auto product = find();
        const FlgResult result = visible_result_now(*product);
        if (result == FLG_OK) write_struct(out, describe(*product), name);
        return result;
    });
}

template <class View, class Find>
FlgResult get_view(View* out_view, Find find) {
    return show(out_view, "out_view", sized<View>(), find, [](const auto& product) { return product.view(); });
}

// The whole of an entry point that gives a handle back.
template <class T, class Handle>
FlgResult release(FlgContext context, HandleTable<T> Context::*table, Handle handle, const char* name) {
    return guarded([&] { (get_context(context).*table).remove(handle.id, name); });
}

}  // namespace flg
