// SPDX-License-Identifier: MIT
// filigree_analogies STYLE TARGET SCALE PREFIX: writes the curves of a comparison with Curve Analogies to PREFIX-guide.obj,
// -style, -target, -ours and -theirs, for pictures.
#include <cstdio>
#include <cstdlib>
#include <stdexcept>

#include "bench/analogies_scene.h"
#include "bench/host.h"
#include "filigree/filigree_io.h"

namespace flg::bench {
namespace {

void write(const std::string& path, const std::vector<Vec3>& points) {
    std::vector<float> positions(3 * points.size());
    for (size_t i = 0; i < points.size(); ++i) store_vec3(points[i], &positions[3 * i]);
    const uint32_t offsets[] = {0, static_cast<uint32_t>(points.size())};
    const FlgColumn column = {FLG_ATTRIBUTE_POSITION, 3, positions.data(), 0, 0};
    FlgCurveSetView view = flgCurveSetViewDefaults();
    view.curve_count = 1;
    view.curve_offsets = offsets;
    view.columns = &column;
    view.column_count = 1;
    if (flgCurveFileWrite(path.c_str(), &view, nullptr) != FLG_OK) throw std::runtime_error(flgIoLastError());
}

void run(const std::string& style, const std::string& target, float scale, const std::string& prefix) {
    const AnalogiesScene scene = make_analogies_scene(style, target, scale, 1);
    write(prefix + "-guide.obj", scene.guide);
    write(prefix + "-style.obj", scene.style);
    write(prefix + "-target.obj", scene.target);
    write(prefix + "-ours.obj", scene.ours.points);
    write(prefix + "-theirs.obj", scene.theirs.points);
}

}  // namespace
}  // namespace flg::bench

int main(int count, char** arguments) {
    const float scale = count == 5 ? std::strtof(arguments[3], nullptr) : 0.0f;
    const bool known = count == 5 && !flg::scenes::make_style(arguments[1]).points.empty() &&
                       !flg::scenes::make_target(arguments[2]).points.empty();
    if (!known || !(scale > 0.0f)) {
        std::fprintf(stderr, "filigree_analogies STYLE TARGET SCALE PREFIX: built-in names, a scale above 0\n");
        return 2;
    }
    try {
        flg::bench::run(arguments[1], arguments[2], scale, arguments[4]);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "filigree_analogies: %s\n", error.what());
        return 1;
    }
    return 0;
}
