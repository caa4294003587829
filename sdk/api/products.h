// SPDX-License-Identifier: MIT
// What the entry points of products share that a job makes once and the host looks at through a view.
#pragma once

#include "api/descriptors.h"
#include "api/error.h"

namespace flg {

template <class View>
View empty_view() {
    View view{};
    view.struct_size = sizeof view;
    return view;
}

template <class View>
FlgResult init_view(View* view, uint32_t struct_size) {
    return guarded([&] {
        init_struct(view, struct_size, empty_view<View>(), "view");
        return FLG_OK;
    });
}

// The whole of a GetView: `find` gives the product, or throws. Until that is published the view is empty.
template <class View, class Find>
FlgResult get_view(View* out_view, Find find) {
    return guarded([&] {
        write_struct(out_view, empty_view<View>(), "out_view");
        const auto& product = *find();
        const FlgResult result = product.visible_result();
        if (result == FLG_OK) write_struct(out_view, product.view(), "out_view");
        return result < 0 ? set_last_error(result, product.error()) : result;
    });
}

}  // namespace flg
