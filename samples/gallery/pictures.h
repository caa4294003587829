// SPDX-License-Identifier: MIT
// What hangs in the gallery.
#pragma once

#include <span>

#include "gallery/studio.h"
#include "gallery/workshop.h"

namespace flg::gallery {

struct Picture {
    const char* name;
    const char* shows;  // one sentence
    bool in_readme;     // kept in the repository
    void (*make)(Workshop& workshop, Studio& studio);
};

std::span<const Picture> showpieces();      // what a README opens with
std::span<const Picture> scene_pictures();  // each built-in scene, stylized
std::span<const Picture> comparisons();     // what an option does
std::span<const Picture> steps();           // what a step of the method does

}  // namespace flg::gallery
