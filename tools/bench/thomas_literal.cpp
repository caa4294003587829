// SPDX-License-Identifier: MIT
#include "bench/thomas_literal.h"

#include "bench/bench.h"
#include "bench/stage_inputs.h"
#include "core/random.h"
#include "reference/literal_frames.h"
#include "reference/literal_synthesis.h"

namespace flg::bench {
namespace {

using literal::Vec3;

// The displacement of the style from its guide, rebuilt from what the C ABI tells of them.
std::vector<Vec3> displacement_of(Host& host, FlgStyle style, const char* name) {
    const FlgStyleInfo info = host.info(style);
    FlgCurveSet guide = {};
    check(flgStyleGetGuide(host.context(), style, &guide));
    FlgCurveSetView view = flgCurveSetViewDefaults();
    check(flgCurveSetGetView(host.context(), guide, &view));
    const float* columns[3] = {};
    for (uint32_t i = 0; i < view.column_count; ++i) {
        if (view.columns[i].attribute == FLG_ATTRIBUTE_POSITION) columns[0] = view.columns[i].data;
        if (view.columns[i].attribute == FLG_ATTRIBUTE_TANGENT) columns[1] = view.columns[i].data;
        if (view.columns[i].attribute == FLG_ATTRIBUTE_NORMAL) columns[2] = view.columns[i].data;
    }
    const uint32_t fine = 16 * info.point_count;
    const EvenStyle example = even_style(name, fine);
    std::vector<Vec3> displacement;
    for (uint32_t i = 0; i < info.point_count; ++i) {
        const Vec3 p = load_vec3(columns[0] + 3 * i), t = load_vec3(columns[1] + 3 * i),
                   n = load_vec3(columns[2] + 3 * i);
        const double share = std::min(1.0, info.matching[i] / static_cast<double>(info.style_length));
        const Vec3 d = example.points[static_cast<size_t>(share * (fine - 1))] - p;
        displacement.emplace_back(d.dot(t), d.dot(n), d.dot(t.cross(n)));
    }
    check(flgCurveSetRelease(host.context(), guide));
    return displacement;
}

}  // namespace

LiteralTimes literal_stylize(Host& host, FlgStyle style, const char* name, const scenes::Curve& target,
                             uint32_t count) {
    const FlgStyleInfo info = host.info(style);
    const std::vector<Vec3> displacement = displacement_of(host, style, name);
    const std::vector<int> boundaries = {0, static_cast<int>(displacement.size())};
    const int patch = static_cast<int>(info.patch);
    const literal::Graph graph =
        literal::dense_graph(literal::patch_distances_sq(displacement, boundaries, patch), boundaries, 0.0);
    literal::Walk walk;
    for (int i = patch + 1; i < boundaries[1] - patch; ++i) walk.destinations.push_back(i);
    walk.from_start = true;
    walk.patch = patch;
    walk.node_count = boundaries[1];
    walk.draw = [](int index, int below) {
        return static_cast<int>(random_below(1, 0, static_cast<uint64_t>(index), static_cast<uint32_t>(below)));
    };
    std::vector<int> indices;
    LiteralTimes times = {};
    times.paths_ms = time_ms([&] { indices = literal::style_indices(graph, walk, static_cast<int>(count)); });
    times.all_ms =
        times.paths_ms + time_ms([&] {
            std::vector<Vec3> points;
            points.reserve(target.points.size());
            for (const scenes::Point& p : target.points) points.emplace_back(p.x, p.y, p.z);
            const auto framed = literal::resample_polyline(points, static_cast<int>(count) - 1, Vec3::UnitY());
            const double factor = scale_for(info, length_of(target), count);
            literal::displace(framed, literal::copied_displacement(displacement, indices, static_cast<int>(patch)),
                              factor);
        });
    return times;
}

}  // namespace flg::bench
