// SPDX-License-Identifier: MIT
// Drawings as the command line reads them (sdk/bones/README.md), and as part of a document, with what only the studio
// knows.
#pragma once

#include <memory>
#include <nlohmann/json.hpp>

#include "documents/kept_joints.h"
#include "skeletons/drawing.h"

namespace flg::studio {

// All throw StudioError.

// A .json drawing, or a contour file: a part for each outline; `warnings` say what was left out.
Drawing read_drawing(const std::string& path, std::vector<std::string>& warnings);
// For the command line: parts without the picture and the pose; at least one part.
nlohmann::json drawing_json(const Drawing& drawing);
void write_drawing(const Drawing& drawing, const std::string& path);

nlohmann::json document_json(const Drawing& drawing);
Drawing drawing_of_document(const nlohmann::json& document);
// By what its joints are known; null: the document does not say.
std::unique_ptr<const cli::KeptJoints> joints_of_document(const nlohmann::json& document);

}  // namespace flg::studio
