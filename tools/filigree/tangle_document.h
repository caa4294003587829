// SPDX-License-Identifier: MIT
// Documents of tangles: written, and made again.
#pragma once

#include <nlohmann/json.hpp>

#include "documents/session.h"
#include "filigree/filigree_tangle.h"

namespace flg::cli {

// Whether a JSON file is a document and no script.
bool is_document(const nlohmann::json& file);

// Both throw InputError.
void replay_document(Session& session, FlgTangle tangle, const std::string& name, Report& report);
void write_document(const Session& session, FlgTangle tangle, const std::string& name);

}  // namespace flg::cli
