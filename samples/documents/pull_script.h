// SPDX-License-Identifier: MIT
// How a model is pulled over time, recorded or written by hand as JSON:
//     {"name": "pull", "motion": "walk", "rate": 30, "rounds": 8, "tolerance": 0.002, "radius": 0.1,
//      "pins": [[x, y, z], ...],
//      "handles": [{"at": [x, y, z], "compliance": 0, "radius": 0.2,
//                   "keys": [{"time": t, "position": [x, y, z]} or {"time": t, "move": [x, y, z]}, ...]}]}
// `at` and `pins` are points of the surface at rest, as near as anybody can tell. A `position` is where the point is to
// be; a `move` is how far from where it would be without being pulled, as bones have it: pins are handles that move by
// nothing. All keys of a handle are of one kind. The first `radius` is that of pins, and of handles without their own.
// Only `handles` must be there.
#pragma once

#include <array>
#include <string>
#include <vector>

namespace flg::cli {

struct PullScriptHandle {
    std::string place;  // in the file, for sentences
    std::array<double, 3> at{};
    double compliance = 0;
    double radius = -1;  // metres, of what it pulls at; below 0: the usual
    bool moves = false;  // its keys are moves
    std::vector<double> times;
    std::vector<double> positions;  // 3 a key
};

struct PullScript {
    std::string subject;  // the file
    std::string name = "pull", motion;
    double rate = 30;          // frames a second
    uint32_t rounds = 8;       // a frame
    double tolerance = 0.002;  // of the size, between keys
    // Pins are the last, with one key.
    std::vector<PullScriptHandle> handles;

    double begin() const;
    double end() const;
};

// Throws InputError, with file and place.
PullScript read_pull_script(const std::string& path);

}  // namespace flg::cli
