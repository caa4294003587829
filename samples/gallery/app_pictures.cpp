// SPDX-License-Identifier: MIT
// The studio at work: its scripts of samples/studio/scripts, played here, and some of the pictures they take.
#include <cstdio>

#include "gallery/pictures.h"
#include "panels/small_png.h"
#include "shell/studio.h"

namespace flg::gallery {
namespace {

void take(Studio& gallery, const char* script, const char* shot, const char* name) {
    studio::StudioOptions options;
    options.script = std::string(FLG_STUDIO_SCRIPTS "/") + script + ".txt";
    options.offscreen = true;
    options.width = 1120;
    options.height = 700;
    options.scale = 1.0f;
    bool taken = false;
    options.keep_shot = [&](const std::string& of, const render::Image& image) {
        if (of != shot) return;
        gallery.keep(name, image);
        taken = true;
    };
    studio::Studio(options).run();
    if (!taken) throw std::runtime_error(options.script + " takes no picture " + shot);
}

}  // namespace

std::span<const Picture> app_pictures() {
    static constexpr Picture kPictures[] = {
        {"studio_scene", "A drawn animal beside a vase, with ornament, strokes and a curve on it", true,
         [](Workshop&, Studio& gallery) { take(gallery, "scene", "scene_decorated", "studio_scene"); }},
        {"studio_strokes", "Strokes drawn on a vase in the studio, in styles built in and drawn by hand", true,
         [](Workshop&, Studio& gallery) { take(gallery, "strokes", "strokes_two", "studio_strokes"); }},
        {"studio_tangles", "A vase ornamented in the studio: bands, polka dots, a grid, painted in materials", true,
         [](Workshop&, Studio& gallery) { take(gallery, "tangles", "tangles_done", "studio_tangles"); }},
        {"studio_skeletons", "An animal drawn in the studio, with its bones, in a pose", true,
         [](Workshop&, Studio& gallery) { take(gallery, "skeletons", "skeletons_posed", "studio_skeletons"); }},
        {"studio_splines", "A closed curve through six points of a torus, in a style", true,
         [](Workshop&, Studio& gallery) { take(gallery, "splines", "splines_stylized", "studio_splines"); }},
    };
    return kPictures;
}

}  // namespace flg::gallery
