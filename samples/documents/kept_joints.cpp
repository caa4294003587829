// SPDX-License-Identifier: MIT
#include "documents/kept_joints.h"

#include <algorithm>

namespace flg::cli {

KeptJoints::KeptJoints(const JsonPlace& joints) {
    const std::vector<JsonPlace> items = joints.items();
    if (items.empty()) joints.fail("is empty");
    for (const JsonPlace& item : items) {
        const auto number = static_cast<uint32_t>(keys_.size());
        keys_.push_back(item.at("key").text());
        key_pointers_.push_back(keys_.back().c_str());
        const JsonPlace parent = item.at("parent");
        if (!parent.is_null() && number == 0) parent.fail("must be null: no joint comes before this one");
        parents_.push_back(parent.is_null() ? FLG_NO_INDEX : parent.count(0, number - 1));
        const JsonPlace place = item.at("place");
        const std::vector<JsonPlace> numbers = place.items();
        if (numbers.size() != 3) place.fail("must be 3 numbers");
        for (const JsonPlace& coordinate : numbers) places_.push_back(coordinate.real(-1e30, 1e30));
    }
}

nlohmann::json KeptJoints::json_of(const FlgModelView& model) {
    nlohmann::json joints = nlohmann::json::array();
    for (size_t j = 0; j < model.joint_count; ++j) {
        const double* place = model.joint_places + 3 * j;
        const uint32_t parent = model.joint_parents[j];
        joints.push_back({{"key", model.joint_keys[j]},
                          {"parent", parent == FLG_NO_INDEX ? nlohmann::json(nullptr) : nlohmann::json(parent)},
                          {"place", {place[0], place[1], place[2]}}});
    }
    return joints;
}

bool KeptJoints::has(const std::string& key) const {
    return std::find(keys_.begin(), keys_.end(), key) != keys_.end();
}

FlgModelView KeptJoints::view() const {
    FlgModelView view = flgModelViewDefaults();
    view.joint_count = static_cast<uint32_t>(keys_.size());
    view.joint_keys = key_pointers_.data();
    view.joint_places = places_.data();
    view.joint_parents = parents_.data();
    return view;
}

}  // namespace flg::cli
