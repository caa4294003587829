// SPDX-License-Identifier: MIT
// Names that joints keep from one run to the next, as models of a host keep keys by `previous` (FlgModelDesc): two
// joints of parts of the same name are the same if each is the other's nearest in the drawing, and near.
#pragma once

#include <string>
#include <vector>

#include "documents/model_drawing.h"

namespace flg::cli {

class LastingNames {
public:
    // `bones` is what `filigree skeleton --bones` wrote. Names that the drawing gives stay. Throws InputError.
    LastingNames(const std::string& bones, const FlgModelView& model, const ModelDrawing& drawing);
    LastingNames(const LastingNames&) = delete;

    // One per joint; they live as long as this.
    const char* const* pointers() const { return pointers_.data(); }

private:
    std::vector<std::string> names_;
    std::vector<const char*> pointers_;
};

}  // namespace flg::cli
