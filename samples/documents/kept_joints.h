// SPDX-License-Identifier: MIT
// The joints of a model as a file keeps them, so that those of a later model have the same keys
// (FlgModelDesc::previous_view).
#pragma once

#include <deque>
#include <string>
#include <vector>

#include "documents/json_place.h"
#include "filigree/filigree_model.h"

namespace flg::cli {

class KeptJoints {
public:
    // `joints`: a list of objects with `key`, `parent` and `place`, parents first. Throws InputError.
    explicit KeptJoints(const JsonPlace& joints);
    KeptJoints(const KeptJoints&) = delete;

    // Of a model: what the constructor takes.
    static nlohmann::json json_of(const FlgModelView& model);

    bool has(const std::string& key) const;
    // Points into this.
    FlgModelView view() const;

private:
    std::deque<std::string> keys_;  // which stay where they are
    std::vector<const char*> key_pointers_;
    std::vector<double> places_;
    std::vector<uint32_t> parents_;
};

}  // namespace flg::cli
