// SPDX-License-Identifier: MIT
// Remakes those pictures of the gallery that no command makes, offscreen; the others are in scripts/.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <vector>

#include "gallery/pictures.h"
#include "support/vulkan_loader.h"

namespace {

using namespace flg::gallery;

std::vector<Picture> all_pictures() {
    std::vector<Picture> list;
    for (const auto pictures : {front_pictures(), coaster_pictures(), attribute_pictures(), live_pictures(),
                                surface_pictures(), skeleton_pictures(), bone_pictures(), spline_pictures(),
                                footpoint_pictures(), obstacle_pictures(), motion_pictures()}) {
        list.insert(list.end(), pictures.begin(), pictures.end());
    }
#if defined(FLG_WITH_REFERENCE)
    for (const Picture& picture : steps()) list.push_back(picture);
#endif
#if defined(FLG_WITH_BASELINE)
    for (const Picture& picture : analogies_pictures()) list.push_back(picture);
#endif
#if defined(FLG_WITH_SCRIPTS)
    for (const Picture& picture : model_pictures()) list.push_back(picture);
#endif
#if defined(FLG_WITH_STUDIO)
    for (const Picture& picture : app_pictures()) list.push_back(picture);
#endif
    return list;
}

// A sketch of the user's for the picture `sketch`.
struct SketchFile {
    std::string file, credit;
};

void run(const std::vector<std::string>& names, const std::string& folder, bool readme, const SketchFile& sketch) {
    const std::vector<Picture> pictures = all_pictures();
    for (const std::string& name : names) {
        if (std::none_of(pictures.begin(), pictures.end(), [&](const Picture& p) { return name == p.name; })) {
            throw std::runtime_error("there is no picture '" + name + "' (gallery --list)");
        }
    }
    std::filesystem::create_directories(folder);
    flg::samples::calm_vulkan_loader();
    Workshop workshop;
    Studio studio(folder);
    if (!sketch.file.empty()) {
        before_and_after(sketch.file, sketch.credit, workshop, studio);
        return;
    }
    for (const Picture& picture : pictures) {
        const bool named = std::find(names.begin(), names.end(), picture.name) != names.end();
        if (names.empty() ? !readme || picture.in_readme : named) picture.make(workshop, studio);
    }
}

}  // namespace

int main(int argc, char** argv) {
    std::vector<std::string> names;
    std::string folder = "out/gallery";
    SketchFile sketch;
    bool readme = false, list = false;
    CLI::App program("Remakes the gallery's pictures, offscreen.", "gallery");
    program.add_option("NAME", names, "Pictures to make; none = all");
    program.add_option("--out", folder, "Folder for the pictures")->capture_default_str();
    program.add_option("--sketch", sketch.file,
                       "Make only the picture `sketch`: this file's strokes (.tilt) before and after");
    program.add_option("--credit", sketch.credit, "Written below that picture");
    program.add_flag("--readme", readme, "Make those that READMEs show, into the repository");
    program.add_flag("--list", list, "Say what there is, and make nothing");
    CLI11_PARSE(program, argc, argv);
    if (list) {
        for (const Picture& picture : all_pictures()) std::printf("%-20s %s\n", picture.name, picture.shows);
        return 0;
    }
    try {
        run(names, readme ? FLG_README_PICTURES : folder, readme, sketch);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "gallery: %s\n", error.what());
        return 1;
    }
    return 0;
}
