// SPDX-License-Identifier: MIT
// What hangs in the gallery.
#pragma once

#include <span>
#include <string>

#include "gallery/workshop.h"
#include "panels/panels.h"

namespace flg::gallery {

using namespace panels;

struct Picture {
    const char* name;
    const char* shows;  // one sentence
    bool in_readme;     // kept in the repository
    void (*make)(Workshop& workshop, Studio& studio);
};

std::span<const Picture> front_pictures();      // what the project's README opens with
std::span<const Picture> coaster_pictures();    // a camera path as a track
std::span<const Picture> attribute_pictures();  // what a style carries besides its shape
std::span<const Picture> live_pictures();       // strokes that are being drawn
std::span<const Picture> surface_pictures();    // distances, paths and regions
std::span<const Picture> skeleton_pictures();   // from a drawn line to bones
std::span<const Picture> bone_pictures();       // joints, and parts that are connected
std::span<const Picture> spline_pictures();     // curves that stay on surfaces
std::span<const Picture> obstacle_pictures();   // and out of solids
std::span<const Picture> footpoint_pictures();  // how splines are found
std::span<const Picture> motion_pictures();     // rigid bodies on their way
#if defined(FLG_WITH_REFERENCE)
std::span<const Picture> steps();  // what a step of the method does
#endif
#if defined(FLG_WITH_BASELINE)
std::span<const Picture> analogies_pictures();  // another method
#endif
#if defined(FLG_WITH_SCRIPTS)
std::span<const Picture> model_pictures();  // models, by drawings
#endif
#if defined(FLG_WITH_STUDIO)
std::span<const Picture> app_pictures();  // the studio's window
#endif

// A sketch of the user's before and after, as `sketch`; its file is named on the command line. `credit` is written
// below.
void before_and_after(const std::string& file, const std::string& credit, Workshop& workshop, Studio& studio);

}  // namespace flg::gallery
