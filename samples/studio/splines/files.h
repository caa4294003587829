// SPDX-License-Identifier: MIT
// Files of the workspace: keyframes and obstacles as the command line takes them; curves and motions for other
// programs.
#pragma once

#include <string>

#include "splines/spline_editor.h"

namespace flg::studio::splines {

// Whether the file was one of keys or obstacles; then they are in the document. Throws StudioError for one that is
// broken.
bool read_file(SplineEditor& editor, const std::string& path);
// All curves that are shown. Throws StudioError, also where there are none.
void write_curves(const SplineEditor& editor, const std::string& path);
// The chosen motion with its body.
void write_motion(const SplineEditor& editor, const std::string& path);

}  // namespace flg::studio::splines
