// SPDX-License-Identifier: MIT
#include "documents/tangle_borders.h"

#include <algorithm>
#include <limits>
#include <map>
#include <vector>

#include "documents/failure.h"

namespace flg::cli {

namespace {

// An edge of a triangle: 3 * triangle + k, from its corner k to the next one.
using Edge = uint32_t;

Edge next_in_triangle(Edge edge) {
    return edge % 3 == 2 ? edge - 2 : edge + 1;
}

class BorderWalk {
public:
    BorderWalk(const FlgSurfaceView& surface, const std::set<uint32_t>& inside) : surface_(surface), inside_(inside) {}

    bool is_inside(uint32_t triangle) const { return inside_.contains(surface_.mesh->regions[triangle]); }
    uint32_t across(Edge edge) const { return surface_.neighbours[edge]; }
    uint32_t start(Edge edge) const { return surface_.mesh->triangles[edge]; }
    bool is_border(Edge edge) const { return across(edge) == FLG_NO_INDEX || !is_inside(across(edge)); }

    // The border's next edge: around the edge's end, within the regions.
    Edge next(Edge edge) const {
        const uint32_t end = start(next_in_triangle(edge));
        for (edge = next_in_triangle(edge); !is_border(edge);) {
            const uint32_t other = across(edge);
            edge = 3 * other;
            while (start(edge) != end) ++edge;
        }
        return edge;
    }

private:
    const FlgSurfaceView& surface_;
    const std::set<uint32_t>& inside_;
};

std::map<uint32_t, Vector> normals_of(const FlgMeshView& mesh, const std::vector<std::vector<Edge>>& loops) {
    std::map<uint32_t, Vector> normals;
    for (const std::vector<Edge>& loop : loops) {
        for (const Edge edge : loop) {
            normals[mesh.triangles[edge]] = normals[mesh.triangles[next_in_triangle(edge)]] = {};
        }
    }
    for (uint32_t corner = 0; corner < 3 * mesh.triangle_count; ++corner) {
        const auto found = normals.find(mesh.triangles[corner]);
        if (found != normals.end()) found->second = found->second + area_vector(mesh, corner / 3);
    }
    return normals;
}

double max_side(const SpaceLines& lines) {
    double longest = 0;
    for (size_t k = 0; k < 3; ++k) {
        float lower = std::numeric_limits<float>::infinity(), upper = -lower;
        for (size_t i = k; i < lines.positions.size(); i += 3) {
            lower = std::min(lower, lines.positions[i]);
            upper = std::max(upper, lines.positions[i]);
        }
        longest = std::max(longest, double{upper} - double{lower});
    }
    return longest;
}

}  // namespace

RegionBorders find_borders(const FlgSurfaceView& surface, const std::set<uint32_t>& inside) {
    const BorderWalk walk(surface, inside);
    const FlgMeshView& mesh = *surface.mesh;
    std::vector<bool> passed(size_t{3} * mesh.triangle_count);
    std::vector<std::vector<Edge>> loops;
    RegionBorders borders;
    borders.lines.origin = origin_of(mesh);
    for (Edge first = 0; first < 3 * mesh.triangle_count; ++first) {
        if (passed[first] || !walk.is_inside(first / 3) || !walk.is_border(first)) continue;
        loops.emplace_back();
        for (Edge edge = first; !passed[edge]; edge = walk.next(edge)) {
            passed[edge] = true;
            loops.back().push_back(edge);
            if (walk.across(edge) != FLG_NO_INDEX) borders.around.insert(mesh.regions[walk.across(edge)]);
        }
    }
    std::map<uint32_t, Vector> normals = normals_of(mesh, loops);
    const auto add = [&](uint32_t vertex) { borders.lines.add(vertex_at(mesh, vertex), unit(normals[vertex])); };
    for (std::vector<Edge>& loop : loops) {
        const auto ends = [&](Edge edge) { return walk.across(edge) == FLG_NO_INDEX; };
        const auto end = std::find_if(loop.begin(), loop.end(), ends);
        if (end == loop.end()) {
            for (const Edge edge : loop) add(walk.start(edge));
            borders.lines.end_line(true);
            continue;
        }
        // The surface ends along some of it: what is between is open.
        std::rotate(loop.begin(), end, loop.end());
        bool drawing = false;
        for (const Edge edge : loop) {
            if (!ends(edge)) {
                add(walk.start(edge));
            } else if (drawing) {
                add(walk.start(edge));
                borders.lines.end_line(false);
            }
            drawing = !ends(edge);
        }
        if (drawing) {
            add(walk.start(loop.front()));
            borders.lines.end_line(false);
        }
    }
    return borders;
}

FlgCurveSet stylize_lines(Session& session, const SpaceLines& lines, const StrokeLook& look, const std::string& subject,
                          Report& report) {
    const FlgContext context = session.context();
    const SpaceLines example = read_lines(look.file, report);
    if (!(max_side(example) > 0)) throw InputError(look.file + ": has no length");
    FlgStyleDesc style;
    flgStyleDescInit(&style, sizeof style);
    style.style = create_set(context, example, look.file);
    FlgCurveSetStylizeDesc desc = flgCurveSetStylizeDefaults();
    FlgJob prepared = {}, applied = {};
    check(flgStyleCreate(context, &style, &desc.style, &prepared), look.file);
    desc.target = create_set(context, lines, subject);
    desc.scale = static_cast<float>(look.length / max_side(example));
    desc.frame = FLG_FRAME_METHOD_SUPPLIED;
    desc.seed = look.seed;
    desc.pin_ends = 1;
    // A stroke in a plane goes to the side along its first normal; a border along its second, as the first is the
    // surface's.
    const float sideways[] = {1, 0, 0, 0, 0, -1, 0, 1, 0};
    std::copy(std::begin(sideways), std::end(sideways), desc.basis);
    FlgCurveSet result = {};
    check(flgCurveSetStylize(context, &desc, &result, &applied), subject);
    session.finish({{{prepared, look.file}, {applied, subject}}}, report);
    for (const FlgCurveSet set : {style.style, desc.target}) flgCurveSetRelease(context, set);
    flgStyleRelease(context, desc.style);
    return result;
}

}  // namespace flg::cli
