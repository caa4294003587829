// SPDX-License-Identifier: MIT
// Keyframes of a motion, written by hand as JSON:
//     {"closed": false, "end_time": 9, "energy": "e2", "tension": 1, "smoothing": 0, "positions": 300,
//      "body": {"points": [[x, y, z], ...], "masses": [...]} or {"box": [width, height, depth]},
//      "timing": "given", "chord" or "centripetal", "pacing": "keys", "path" or "body", "speed": 0,
//      "limits": {"speed": 0, "acceleration": 0, "turn": 0, "turn_acceleration": 0}, "clearance": 0,
//      "look": {"at": [x, y, z]} or {"points": [[x, y, z], ...], "times": [...]} or {"path": true}, each of them also
//              with "up": [0, 1, 0], "bank": 0, "bank_time": 0.25,
//      "keys": [{"time": t, "pose": [12 numbers]} or {"time": t, "position": [x, y, z], "rotation": [x, y, z, w]}, each
//              of them also with "ease_in": 0, "ease_out": 0]}
// Only `keys` must be there. Without `rotation` a key does not turn; with found times `time` does not count.
#pragma once

#include <string>
#include <vector>

#include "filigree/filigree_motion.h"

namespace flg::cli {

struct MotionFile {
    std::vector<double> times, poses, eases;  // times and eases may be empty
    std::vector<double> look_points, look_times;
    std::vector<double> body_points, body_masses;
    bool has_body = false;
    FlgMotionDesc desc = flgMotionDefaults();  // without arrays
};

// With its arrays, of which it must not outlive the file.
FlgMotionDesc desc_of(const MotionFile& file);

// Throws InputError, with file and place.
MotionFile read_motion_file(const std::string& path);

}  // namespace flg::cli
