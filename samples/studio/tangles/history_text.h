// SPDX-License-Identifier: MIT
// Histories of tangles within the studio's document: the file format of filigree_io.h, its side file as base64.
#pragma once

#include <memory>
#include <nlohmann/json.hpp>

#include "filigree/filigree_io.h"

namespace flg::studio {

// Throws StudioError.
nlohmann::json history_to_json(const FlgTangleHistory& history);

using HistoryFile = std::unique_ptr<FlgTangleFileT, decltype(&flgTangleFileRelease)>;
// Throws StudioError, and nlohmann's exceptions.
HistoryFile history_from_json(const nlohmann::json& json);
HistoryFile read_history(const std::string& path);
FlgTangleHistory history_of(const HistoryFile& file);

}  // namespace flg::studio
