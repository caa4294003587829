// SPDX-License-Identifier: MIT
// Names that joints keep from one run to the next, as models of a host keep keys by `previous` (FlgModelDesc): two
// joints of parts of the same name are the same if each is the other's nearest in the drawing, and near.
#pragma once

#include <string>
#include <vector>

#include "documents/model_drawing.h"

namespace flg::cli {

// Edits of joints are by the keys that these had in `bones`: they become those of the same joints in `model`, made of
// the drawing without them. Edits of joints that are gone go too; returns their keys. Throws InputError.
std::vector<std::string> follow_joints(const std::string& bones, const FlgModelView& model, ModelDrawing& drawing);

class LastingNames {
public:
    // `bones` is what `filigree skeleton --bones` wrote. Names that the drawing gives stay. Throws InputError.
    LastingNames(const std::string& bones, const FlgModelView& model, const ModelDrawing& drawing);
    LastingNames(const LastingNames&) = delete;

    // One per joint; they live as long as this.
    const char* const* pointers() const { return pointers_.data(); }
    // Likewise keys, by which edits in the drawing know the joints from the first run on.
    const char* const* keys() const { return key_pointers_.data(); }

private:
    std::vector<std::string> names_, keys_;
    std::vector<const char*> pointers_, key_pointers_;
};

}  // namespace flg::cli
