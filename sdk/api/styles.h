// SPDX-License-Identifier: MIT
// What the entry points of styles share.
#pragma once

#include "api/context.h"
#include "api/error.h"

namespace flg {

// The style, if its job is done; FLG_NOT_READY or the job's error otherwise.
inline FlgResult find_style(const Context& context, FlgStyle handle, std::shared_ptr<Style>& out) {
    out = context.styles.get(handle.id, "style");
    const FlgResult result = out->visible_result();
    return result < 0 ? set_last_error(result, out->error()) : result;
}

}  // namespace flg
