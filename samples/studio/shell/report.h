// SPDX-License-Identifier: MIT
// What is to be seen, as data: for tests that use the window as a person does, by mouse and keys, and must know where
// to aim and when the app has done all that it was asked for.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "shell/input.h"
#include "shell/view.h"

namespace flg::studio {

// Labels with their rectangles, the 3D picture's place, the pointer, and how much input the frames have taken so far.
nlohmann::json report_of(const View& view, const Input& input);

// Replaces `path` at once: who reads it finds a whole report. Throws StudioError.
void write_report(const std::string& path, const nlohmann::json& report);

}  // namespace flg::studio
