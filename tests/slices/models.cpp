// SPDX-License-Identifier: MIT
// Straight skeletons, parts, models, skins, outlines, meshes that are pulled.
#include "filigree/filigree_model.h"
#include "filigree/filigree_pull.h"
#include "slices/meshes.h"
#include "slices/sized_jobs.h"

namespace flg::slices {

namespace {

constexpr double pi = 3.14159265358979323846;

// A blob with five arms.
std::vector<double> blob(uint32_t count, double x = 0) {
    std::vector<double> points;
    for (uint32_t i = 0; i < count; ++i) {
        const double a = 2 * pi * i / count, r = 1 + 0.7 * std::pow(std::cos(2.5 * a), 4);
        points.insert(points.end(), {x + r * std::cos(a), r * std::sin(a)});
    }
    return points;
}

// {count / 1 around}, as polygons that cross themselves: each edge goes across the middle.
std::vector<double> star(uint32_t count, uint32_t step) {
    std::vector<double> points;
    for (uint32_t i = 0; i < count; ++i) {
        const double a = 2 * pi * static_cast<double>((uint64_t{i} * step) % count) / count;
        points.insert(points.end(), {std::cos(a), std::sin(a)});
    }
    return points;
}

void skeleton_of(WatchedHost& host, const std::vector<double>& points, bool repair) {
    FlgContourView view = flgContourViewDefaults();
    view.points = points.data();
    view.point_count = static_cast<uint32_t>(points.size() / 2);
    FlgStraightSkeletonDesc desc = flgStraightSkeletonDefaults();
    desc.contour = &view;
    desc.repair = repair;
    FlgStraightSkeleton skeleton{};
    host.copy("flgStraightSkeletonCreate", flgStraightSkeletonCreate, &desc, &skeleton, host.job());
    host.made("flgStraightSkeletonRelease", flgStraightSkeletonRelease, skeleton);
    host.finish();
}

void skeleton(WatchedHost& host, uint32_t size) {
    skeleton_of(host, blob(size), false);
}
void skeleton_comb(WatchedHost& host, uint32_t size) {
    std::vector<double> points;
    for (uint32_t i = 0; i < size / 4; ++i)
        points.insert(points.end(), {1.0 * i, 0, 1.0 * i + 0.3, 100, 1.0 * i + 0.6, 100, 1.0 * i + 0.8, 0});
    points.insert(points.end(), {0.25 * size, 0, 0.25 * size, -1, 0, -1});
    skeleton_of(host, points, false);
}
// Any drawing: repaired though nothing is wrong with it.
void repair(WatchedHost& host, uint32_t size) {
    skeleton_of(host, blob(size), true);
}
// Some `size` crossings.
void repair_star(WatchedHost& host, uint32_t size) {
    const auto corners = static_cast<uint32_t>(std::lround(std::sqrt(2.0 * size))) | 1;
    skeleton_of(host, star(corners, corners / 2), true);
}
// One edge that many cross.
void repair_zigzag(WatchedHost& host, uint32_t size) {
    std::vector<double> points;
    for (uint32_t i = 0; i < size; ++i) points.insert(points.end(), {1.0 * i, i % 2 ? 3.0 : -1.0});
    points.insert(points.end(), {1.0 * size, 0, 0, 0});
    skeleton_of(host, points, true);
}

FlgPart make_part(WatchedHost& host, uint32_t size, double x = 0) {
    const std::vector<double> points = blob(size, x);
    FlgContourView view = flgContourViewDefaults();
    view.points = points.data();
    view.point_count = static_cast<uint32_t>(points.size() / 2);
    FlgPartDesc desc = flgPartDefaults();
    desc.contour = &view;
    FlgPart part{};
    host.copy("flgPartCreate", flgPartCreate, &desc, &part, host.job());
    host.made("flgPartRelease", flgPartRelease, part);
    host.finish();
    return part;
}

void part(WatchedHost& host, uint32_t size) {
    make_part(host, size);
}

// Some `size` vertices.
void part_mesh(WatchedHost& host, uint32_t size) {
    FlgPartMeshDesc desc = flgPartMeshDefaults();
    desc.part = make_part(host, 400);
    desc.spacing = std::sqrt(10.0 / size);
    FlgPartMesh mesh{};
    host.call("flgPartMeshCreate", flgPartMeshCreate, &desc, &mesh, host.job());
    host.made("flgPartMeshRelease", flgPartMeshRelease, mesh);
    host.finish();
}

void skin(WatchedHost& host, uint32_t size) {
    FlgModelPart parts[2];
    for (uint32_t i = 0; i < 2; ++i) {
        parts[i] = flgModelPartDefaults();
        parts[i].part = make_part(host, 400, 1.5 * i);
    }
    FlgModelDesc model = flgModelDefaults();
    model.parts = parts;
    model.part_count = 2;
    FlgSkinDesc desc = flgSkinDefaults();
    host.copy("flgModelCreate", flgModelCreate, &model, &desc.model, host.job());
    host.made("flgModelRelease", flgModelRelease, desc.model);
    host.finish();
    desc.vertex_count = size;
    FlgSkin made{}, level{}, bound{};
    host.call("flgSkinCreate", flgSkinCreate, &desc, &made, host.job());
    host.made("flgSkinRelease", flgSkinRelease, made);
    host.finish();
    FlgSkinSimplifyDesc simpler = flgSkinSimplifyDefaults();
    simpler.skin = made;
    simpler.vertex_count = size / 2;
    host.call("flgSkinSimplify", flgSkinSimplify, &simpler, &level, host.job());
    host.made("flgSkinRelease", flgSkinRelease, level);
    host.finish();
    FlgSkinView view = flgSkinViewDefaults();
    host.call("flgSkinGetView", flgSkinGetView, made, &view);
    FlgSkinSetWeightsDesc weights = flgSkinSetWeightsDefaults();
    weights.skin = made;
    weights.vertex_count = view.vertex_count;
    weights.vertex_joints = view.vertex_joints;
    weights.vertex_weights = view.vertex_weights;
    host.copy("flgSkinSetWeights", flgSkinSetWeights, &weights, &bound, host.job());
    host.made("flgSkinRelease", flgSkinRelease, bound);
    host.finish();
}

void skin_of_mesh(WatchedHost& host, uint32_t size) {
    Mesh mesh = ball(size);
    const FlgMeshView view = mesh.view();
    FlgSkinFromMeshDesc desc = flgSkinFromMeshDefaults();
    desc.mesh = &view;
    FlgSkin made{};
    host.copy("flgSkinCreateFromMesh", flgSkinCreateFromMesh, &desc, &made, host.job());
    host.made("flgSkinRelease", flgSkinRelease, made);
    host.finish();
}

void outline(WatchedHost& host, uint32_t size) {
    FlgOutlineDesc desc = flgOutlineDefaults();
    desc.surface = make_surface(host, ball(size));
    desc.direction[2] = 1;
    FlgOutline made{};
    host.call("flgOutlineCreate", flgOutlineCreate, &desc, &made, host.job());
    host.made("flgOutlineRelease", flgOutlineRelease, made);
    host.finish();
}

void pull(WatchedHost& host, uint32_t size) {
    Mesh mesh = ball(size);
    const FlgMeshView view = mesh.view();
    FlgPullDesc desc = flgPullDefaults();
    desc.mesh = &view;
    FlgPulledDesc frame = flgPulledDefaults();
    host.copy("flgPullCreate", flgPullCreate, &desc, &frame.pull, host.job());
    host.made("flgPullRelease", flgPullRelease, frame.pull);
    host.finish();
    FlgPullHandle handles[2];
    for (uint32_t h = 0; h < 2; ++h) {
        handles[h] = flgPullHandleDefaults();
        const uint32_t v = h * (mesh.vertex_count() - 1);
        handles[h].vertices[0] = handles[h].vertices[1] = handles[h].vertices[2] = v;
        handles[h].position[2] = h == 0 ? -1.0f : 1.5f;
    }
    frame.handles = handles;
    frame.handle_count = 2;
    FlgPulled pulled{};
    host.call("flgPulledCreate", flgPulledCreate, &frame, &pulled, host.job());
    host.made("flgPulledRelease", flgPulledRelease, pulled);
    host.finish();
}

constexpr SizedJob all[] = {
    {"skeleton", skeleton, 1'000'000},
    {"skeleton_comb", skeleton_comb, 1'000'000},
    {"repair", repair, 1'000'000},
    {"repair_star", repair_star, 1'000'000},
    {"repair_zigzag", repair_zigzag, 100'000},
    {"part", part, 100'000},
    {"part_mesh", part_mesh, 100'000},
    {"skin", skin, 100'000},
    {"skin_of_mesh", skin_of_mesh, 1'000'000},
    {"outline", outline},
    {"pull", pull, 100'000},
};

}  // namespace

std::span<const SizedJob> model_jobs() {
    return all;
}

}  // namespace flg::slices
