// SPDX-License-Identifier: MIT
// Keyframes of a motion, written by hand as JSON:
//     {"closed": false, "end_time": 9, "energy": "e2", "tension": 1, "smoothing": 0, "positions": 300,
//      "body": {"points": [[x, y, z], ...], "masses": [...]} or {"box": [width, height, depth]},
//      "keys": [{"time": t, "pose": [12 numbers]} or {"time": t, "position": [x, y, z], "rotation": [x, y, z, w]}]}
// Only `keys` must be there.
#pragma once

#include <string>
#include <vector>

#include "filigree/filigree_motion.h"

namespace flg::cli {

struct MotionFile {
    std::vector<double> times, poses;
    std::vector<double> body_points, body_masses;
    bool has_body = false;
    FlgMotionDesc desc = flgMotionDefaults();  // without arrays
};

// With its arrays, of which it must not outlive the file.
FlgMotionDesc desc_of(const MotionFile& file);

// Throws InputError, with file and place.
MotionFile read_motion_file(const std::string& path);

}  // namespace flg::cli
