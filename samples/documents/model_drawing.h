// SPDX-License-Identifier: MIT
// Drawings of models: contours, and where their parts are in space. Written by hand as JSON (sdk/bones/README.md), or
// plain contour files, a part each.
#pragma once

#include <array>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "documents/contour_file.h"
#include "documents/json_place.h"
#include "documents/kept_joints.h"
#include "documents/session.h"
#include "filigree/filigree_io.h"
#include "filigree/filigree_model.h"

namespace flg::cli {

struct DrawnPart {
    std::string name;
    ContourArrays contour;
    std::array<double, 12> placement = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};
    float thickness = 1, depth = 0;
    bool is_mirrored = false;
    std::optional<FlgBoneThresholds> thresholds;
    FlgMeshMaterial material = flgMeshMaterialDefaults();  // without a name
    std::string parent, parent_joint;                      // names; empty: to be found
    std::array<double, 4> picture{};                       // as FlgModelPart has it
};

// As FlgJointEdit.
struct JointEdit {
    FlgJointEditKind kind = FLG_JOINT_EDIT_KIND_PIN;
    std::string joint, name;
    std::array<double, 3> at = {0, 0, 0};
    double share = 0.5;
    bool operator==(const JointEdit&) const = default;
};
// For the ABI; points into the edit.
FlgJointEdit described(const JointEdit& edit);

struct ModelDrawing {
    std::vector<DrawnPart> parts;
    std::array<float, 4> mirror = {1, 0, 0, 0};
    FlgBoneThresholds thresholds = flgBoneThresholdsDefaults();
    bool has_colors = false;
    std::string texture;           // a picture's file; empty: none
    bool repair = false;           // contours that cross themselves
    std::string root, root_joint;  // of the part, and of its joint; empty: to be found
    std::vector<JointEdit> joint_edits;
    std::vector<std::array<std::string, 2>> apart;  // parts that are not welded
    std::shared_ptr<const KeptJoints> previous;     // of its model before; null: joints' keys are new
};

// Throws InputError, with file and place.
ModelDrawing read_model_drawing(const std::string& path);
// Of a file that has been read, or of a part of one; contours that it names are in `folder`.
ModelDrawing model_drawing_of(const nlohmann::json& json, const std::string& subject,
                              const std::filesystem::path& folder);
// A part for each outline of a file (contour_file.h), called NAME, NAME-2 and so on; warnings say what was left out.
std::vector<DrawnPart> read_contour_parts(const std::string& path, std::vector<std::string>& warnings);

// Its model, made; `subject` is what errors are about. Parts stay alive with the session.
FlgModel make_drawn_model(Session& session, const ModelDrawing& drawing, const std::string& subject, Report& report);

}  // namespace flg::cli
