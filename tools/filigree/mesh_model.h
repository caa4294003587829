// SPDX-License-Identifier: MIT
// A mesh with joints and weights, as if it had been drawn in one part: for what takes models.
#pragma once

#include <string>
#include <vector>

#include "documents/mesh_file.h"
#include "documents/model_drawing.h"
#include "documents/report.h"
#include "documents/session.h"
#include "skin_looks.h"

namespace flg::cli {

class MeshModel {
public:
    // Reads the file and makes its skin, which lives as long as the session's context. Throws InputError.
    MeshModel(Session& session, const std::string& file, const FlgBoneThresholds& thresholds, Report& report);
    MeshModel(const MeshModel&) = delete;
    MeshModel& operator=(const MeshModel&) = delete;

    const MeshFile& file() const { return file_; }
    const FlgSkinView& skin() const { return skin_; }
    const SkinLooks& looks() const { return looks_; }
    const FlgModelView& bones() const { return bones_; }
    const ModelDrawing& drawing() const { return drawing_; }

private:
    MeshFile file_;
    FlgSkinView skin_ = flgSkinViewDefaults();
    SkinLooks looks_;
    FlgModelView bones_ = flgModelViewDefaults();
    ModelDrawing drawing_;
    std::vector<double> places_;
    std::vector<uint8_t> pinned_;
    std::vector<uint32_t> parts_;
};

}  // namespace flg::cli
