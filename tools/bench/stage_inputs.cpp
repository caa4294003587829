// SPDX-License-Identifier: MIT
#include "bench/stage_inputs.h"

#include "scenes/scenes.h"

namespace flg::bench {

EvenStyle even_style(std::string_view name, uint32_t count) {
    const scenes::Curve curve = scenes::make_style(name);
    std::vector<Vec3> given;
    std::vector<double> arc = {0.0};
    for (const scenes::Point& p : curve.points) {
        given.emplace_back(p.x, p.y, p.z);
        if (given.size() > 1) arc.push_back(arc.back() + (given.back() - given[given.size() - 2]).norm());
    }
    EvenStyle style;
    style.length = arc.back();
    size_t segment = 0;
    for (uint32_t i = 0; i < count; ++i) {
        const double s = style.length * i / (count - 1);
        while (segment + 2 < arc.size() && arc[segment + 1] < s) ++segment;
        const double t = (s - arc[segment]) / (arc[segment + 1] - arc[segment]);
        style.points.push_back(given[segment] + t * (given[segment + 1] - given[segment]));
    }
    return style;
}

}  // namespace flg::bench
