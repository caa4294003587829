// SPDX-License-Identifier: MIT
// Picking against brute force over all triangles and segments.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <thread>

#include "filigree/filigree_pick.h"
#include "surfaces/test_meshes.h"

namespace flg::test {
namespace {

class Picking : public testing::Test {
protected:
    void SetUp() override { ASSERT_EQ(flgPickSceneCreate(nullptr, &scene), FLG_OK) << flgPickErrorGetMessage(); }
    void TearDown() override { flgPickSceneDestroy(scene); }
    FlgPickScene scene = nullptr;
};

// A soup as the SDK would show it as a surface.
struct Shown {
    explicit Shown(const Soup& soup) : column{FLG_ATTRIBUTE_POSITION, 3, soup.positions[0].data(), 0, 0} {
        view.struct_size = sizeof view;
        mesh = {.struct_size = sizeof mesh,
                .vertex_count = static_cast<uint32_t>(soup.positions.size()),
                .triangle_count = static_cast<uint32_t>(soup.triangles.size()),
                .column_count = 1,
                .columns = &column,
                .triangles = soup.triangles[0].data(),
                .regions = nullptr,
                .origin = {}};
        view.mesh = &mesh;
    }
    Shown(const Shown&) = delete;
    Shown& operator=(const Shown&) = delete;
    FlgColumn column;
    FlgMeshView mesh{};
    FlgSurfaceView view{};
};

Vec3 random_direction(uint64_t item) {
    const double z = 2 * random_unit(7, item, 0) - 1, angle = 2 * std::numbers::pi * random_unit(7, item, 1);
    return {std::sqrt(1 - z * z) * std::cos(angle), std::sqrt(1 - z * z) * std::sin(angle), z};
}

// From far outside towards somewhere near the middle.
FlgRay random_ray(uint64_t item) {
    const Vec3 origin = 3 * random_direction(2 * item);
    const Vec3 direction = 0.5 * random_direction(2 * item + 1) - origin;
    FlgRay ray{{}, 0, {}, HUGE_VALF};
    store_vec3(origin, ray.origin);
    store_vec3(direction, ray.direction);
    return ray;
}

// The distance to the first triangle along a ray, by Cramer's rule for each; infinite if none.
double first_hit(const Soup& soup, const FlgRay& ray) {
    const Vec3 o = load_vec3(ray.origin), d = load_vec3(ray.direction);
    double best = HUGE_VAL;
    for (const Triple& t : soup.triangles) {
        const Vec3 a = load_vec3(soup.positions[t[0]].data()), ab = load_vec3(soup.positions[t[1]].data()) - a,
                   ac = load_vec3(soup.positions[t[2]].data()) - a;
        const Vec3 n = d.cross(ac);
        const double det = ab.dot(n);
        if (det == 0) continue;
        const double u = (o - a).dot(n) / det, v = d.dot((o - a).cross(ab)) / det;
        const double along = ac.dot((o - a).cross(ab)) / det;
        if (u >= 0 && v >= 0 && u + v <= 1 && along >= 0) best = std::min(best, along);
    }
    return best;
}

double distance_to_segment(const Vec3& p, const Vec3& a, const Vec3& b) {
    const double t = std::clamp((p - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0);
    return (p - a - t * (b - a)).norm();
}

double distance_to(const Soup& soup, const Vec3& p) {
    double best = HUGE_VAL;
    for (const Triple& t : soup.triangles) {
        const Vec3 a = load_vec3(soup.positions[t[0]].data()), b = load_vec3(soup.positions[t[1]].data()),
                   c = load_vec3(soup.positions[t[2]].data());
        const Vec3 normal = (b - a).cross(c - a).normalized();
        const Vec3 foot = p - normal.dot(p - a) * normal;
        const bool inside = normal.dot((b - a).cross(foot - a)) >= 0 && normal.dot((c - b).cross(foot - b)) >= 0 &&
                            normal.dot((a - c).cross(foot - c)) >= 0;
        best = std::min({best, inside ? (p - foot).norm() : HUGE_VAL, distance_to_segment(p, a, b),
                         distance_to_segment(p, b, c), distance_to_segment(p, c, a)});
    }
    return best;
}

void expect_like_brute_force(FlgPickScene scene, const Soup& soup, uint32_t object) {
    std::vector<FlgRay> rays;
    for (uint64_t i = 0; i < 301; ++i) rays.push_back(random_ray(i));
    std::vector<FlgHit> hits(rays.size());
    ASSERT_EQ(flgPickSceneCastRays(scene, rays.data(), static_cast<uint32_t>(rays.size()), hits.data()), FLG_OK);
    uint32_t met = 0;
    for (size_t i = 0; i < rays.size(); ++i) {
        const double expected = first_hit(soup, rays[i]);
        if (expected == HUGE_VAL) {
            EXPECT_EQ(hits[i].object, FLG_NO_INDEX);
            continue;
        }
        ++met;
        ASSERT_EQ(hits[i].object, object);
        EXPECT_NEAR(hits[i].distance, expected, 1e-5);
        const Vec3 place = load_vec3(rays[i].origin) + expected * load_vec3(rays[i].direction);
        EXPECT_LT((load_vec3(hits[i].position) - place).norm(), 2e-5);
        const Triple& t = soup.triangles[hits[i].element];
        const Vec3 a = load_vec3(soup.positions[t[0]].data()), b = load_vec3(soup.positions[t[1]].data()),
                   c = load_vec3(soup.positions[t[2]].data());
        const double u = hits[i].u, v = hits[i].v;
        EXPECT_LT(((1 - u - v) * a + u * b + v * c - place).norm(), 2e-5);
        EXPECT_GT(load_vec3(hits[i].normal).dot((b - a).cross(c - a).normalized()), 0.9999);
    }
    EXPECT_GT(met, 50u);
    for (uint64_t i = 0; i < 100; ++i) {
        const Vec3 p = 1.6 * random_unit(3, i, 0) * random_direction(i);
        float point[3];
        store_vec3(p, point);
        FlgHit hit;
        ASSERT_EQ(flgPickSceneFindNearest(scene, point, HUGE_VALF, &hit), FLG_OK);
        const double expected = distance_to(soup, load_vec3(point));
        EXPECT_NEAR(hit.distance, expected, 1e-5);
        EXPECT_NEAR((load_vec3(hit.position) - load_vec3(point)).norm(), expected, 1e-5);
        ASSERT_EQ(flgPickSceneFindNearest(scene, point, static_cast<float>(0.9 * expected), &hit), FLG_OK);
        EXPECT_EQ(hit.object, FLG_NO_INDEX);
    }
}

TEST_F(Picking, SurfacesAnswerAsBruteForceDoes) {
    for (const Soup& soup : {sphere(2), torus(24, 16), plane(6, 0.3)}) {
        const Shown shown(soup);
        ASSERT_EQ(flgPickSceneSetSurface(scene, 7, &shown.view, nullptr, 0), FLG_OK) << flgPickErrorGetMessage();
        ASSERT_EQ(flgPickSceneCommit(scene), FLG_OK) << flgPickErrorGetMessage();
        expect_like_brute_force(scene, soup, 7);
    }
}

// Splits some triangles at a raised middle, as a cut and a displacement would.
void change_some(Soup& soup, uint32_t step, std::vector<uint32_t>& changed) {
    changed.clear();
    const auto count = static_cast<uint32_t>(soup.triangles.size());
    for (uint32_t i = 0; i < count; i += step) {
        const Triple t = soup.triangles[i];
        Vec3 middle = Vec3::Zero();
        for (uint32_t v : t) middle += load_vec3(soup.positions[v].data()) / 3;
        const auto vertex = static_cast<uint32_t>(soup.positions.size());
        soup.positions.push_back(to_position(1.2 * middle));
        soup.triangles[i] = {t[0], t[1], vertex};
        soup.triangles.push_back({t[1], t[2], vertex});
        soup.triangles.push_back({t[2], t[0], vertex});
        changed.push_back(i);
    }
}

TEST_F(Picking, ChangedSurfacesAnswerAsTheyAreNow) {
    Soup soup = sphere(3);
    std::vector<uint32_t> changed;
    const Shown shown(soup);
    ASSERT_EQ(flgPickSceneSetSurface(scene, 0, &shown.view, nullptr, 0), FLG_OK);
    ASSERT_EQ(flgPickSceneCommit(scene), FLG_OK);
    // The last step passes what the delta may hold, so the whole is built anew.
    for (uint32_t step : {97u, 131u, 89u, 4u}) {
        change_some(soup, step, changed);
        const Shown now(soup);
        ASSERT_EQ(flgPickSceneSetSurface(scene, 0, &now.view, changed.data(), static_cast<uint32_t>(changed.size())),
                  FLG_OK);
        ASSERT_EQ(flgPickSceneCommit(scene), FLG_OK);
        expect_like_brute_force(scene, soup, 0);
    }
}

// Enough for parts of three levels, so that some are joined, and for triangles that change again and again.
TEST_F(Picking, ManySmallChangesAnswerAsTheyAreNow) {
    Soup soup = sphere(4);
    const Shown shown(soup);
    ASSERT_EQ(flgPickSceneSetSurface(scene, 0, &shown.view, nullptr, 0), FLG_OK);
    ASSERT_EQ(flgPickSceneCommit(scene), FLG_OK);
    for (uint32_t update = 0; update < 70; ++update) {
        // Every second one among the same few.
        const uint64_t most = update % 2 == 0 ? 40 : soup.triangles.size();
        const uint32_t v = soup.triangles[random_bits(5, update, 0) % most][0];
        soup.positions[v] = to_position(1.02 * load_vec3(soup.positions[v].data()));
        std::vector<uint32_t> changed;
        for (uint32_t t = 0; t < soup.triangles.size(); ++t) {
            if (std::ranges::count(soup.triangles[t], v) > 0) changed.push_back(t);
        }
        const Shown now(soup);
        ASSERT_EQ(flgPickSceneSetSurface(scene, 0, &now.view, changed.data(), static_cast<uint32_t>(changed.size())),
                  FLG_OK);
        ASSERT_EQ(flgPickSceneCommit(scene), FLG_OK);
        if (update == 7 || update == 64) expect_like_brute_force(scene, soup, 0);
    }
}

// Many rays are shot in another order than they come in.
TEST_F(Picking, ManyRaysAnswerAsEachByItself) {
    const Soup soup = torus(24, 16);
    const Shown shown(soup);
    std::vector<FlgRay> rays;
    for (uint64_t i = 0; i < 12'345; ++i) rays.push_back(random_ray(i));
    std::vector<FlgHit> hits(rays.size());
    ASSERT_EQ(flgPickSceneCastRays(scene, rays.data(), 12'345, hits.data()), FLG_OK) << "nothing is there yet";
    EXPECT_EQ(hits[77].object, FLG_NO_INDEX);
    ASSERT_EQ(flgPickSceneSetSurface(scene, 0, &shown.view, nullptr, 0), FLG_OK);
    ASSERT_EQ(flgPickSceneCommit(scene), FLG_OK);
    ASSERT_EQ(flgPickSceneCastRays(scene, rays.data(), 12'345, hits.data()), FLG_OK);
    for (size_t i = 0; i < rays.size(); ++i) {
        FlgHit hit;
        ASSERT_EQ(flgPickSceneCastRays(scene, &rays[i], 1, &hit), FLG_OK);
        ASSERT_EQ(hits[i].object, hit.object) << i;
        ASSERT_NEAR(hits[i].position[0], hit.position[0], 1e-5) << i;
        ASSERT_NEAR(hits[i].position[2], hit.position[2], 1e-5) << i;
    }
}

TEST_F(Picking, DirectionsMayBeOfAnyLength) {
    const Soup soup = sphere(3);
    const Shown shown(soup);
    ASSERT_EQ(flgPickSceneSetSurface(scene, 0, &shown.view, nullptr, 0), FLG_OK);
    ASSERT_EQ(flgPickSceneCommit(scene), FLG_OK);
    for (float length : {1e-30f, 1e-20f, 1e-7f, 1.0f, 1e7f, 1e20f, 3e38f}) {
        FlgRay ray{{0.1f, 0.2f, 5}, 0, {0, 0, -length}, HUGE_VALF};
        FlgHit hit;
        ASSERT_EQ(flgPickSceneCastRays(scene, &ray, 1, &hit), FLG_OK);
        ASSERT_EQ(hit.object, 0u) << length;
        EXPECT_NEAR(hit.position[2], std::sqrt(0.95), 0.01);
        EXPECT_NEAR(double{hit.distance} * length, 5 - double{hit.position[2]}, 1e-5) << length;
        ray.furthest = 3.9f / length;
        ASSERT_EQ(flgPickSceneCastRays(scene, &ray, 1, &hit), FLG_OK);
        EXPECT_EQ(hit.object, FLG_NO_INDEX) << "it ends before the sphere";
        ray.nearest = 4.5f / length;
        ray.furthest = HUGE_VALF;
        ASSERT_EQ(flgPickSceneCastRays(scene, &ray, 1, &hit), FLG_OK);
        EXPECT_LT(hit.position[2], 0) << "it begins within the sphere";
    }
}

TEST_F(Picking, CurvesAreTubes) {
    // A straight tube of radius 0.1 along x and a closed square about z that rays along z only graze.
    const float positions[] = {-1, 0, 0, 1, 0, 0, 2, 2, 0, 3, 2, 0, 3, 3, 0, 2, 3, 0};
    const float radii[] = {0.1f, 0.1f, 0.05f, 0.05f, 0.05f, 0.05f};
    const FlgColumn columns[] = {{FLG_ATTRIBUTE_POSITION, 3, positions, 0, 0}, {FLG_ATTRIBUTE_RADIUS, 1, radii, 0, 0}};
    const uint32_t offsets[] = {0, 2, 6};
    const uint8_t flags[] = {0, FLG_CURVE_CLOSED};
    FlgCurveSetView view{sizeof view, 2, offsets, flags, columns, 2, 0, {}};
    ASSERT_EQ(flgPickSceneSetCurves(scene, 3, &view, 0.01f), FLG_OK) << flgPickErrorGetMessage();
    ASSERT_EQ(flgPickSceneCommit(scene), FLG_OK);

    const FlgRay rays[] = {{{0.5f, 0, 5}, 0, {0, 0, -1}, HUGE_VALF},
                           {{0.5f, 0.099f, 5}, 0, {0, 0, -1}, HUGE_VALF},
                           {{0.5f, 0.101f, 5}, 0, {0, 0, -1}, HUGE_VALF},
                           {{2, 2.5f, 5}, 0, {0, 0, -1}, HUGE_VALF}};
    FlgHit hits[4];
    ASSERT_EQ(flgPickSceneCastRays(scene, rays, 4, hits), FLG_OK);
    EXPECT_EQ(hits[0].object, 3u);
    EXPECT_EQ(hits[0].element, 0u);
    EXPECT_EQ(hits[0].region, 0u);
    EXPECT_NEAR(hits[0].u, 0.75, 1e-5);
    EXPECT_NEAR(hits[0].distance, 4.9, 1e-5);
    EXPECT_NEAR(hits[0].normal[2], 1, 1e-5);
    EXPECT_EQ(hits[1].object, 3u);
    EXPECT_EQ(hits[2].object, FLG_NO_INDEX);
    EXPECT_EQ(hits[3].region, 1u);  // the stretch that closes the square
    EXPECT_EQ(hits[3].element, 5u);

    const float point[3] = {0.2f, 0.6f, 0};
    FlgHit hit;
    ASSERT_EQ(flgPickSceneFindNearest(scene, point, 1, &hit), FLG_OK);
    EXPECT_NEAR(hit.distance, 0.5, 1e-6);
    EXPECT_NEAR(hit.u, 0.6, 1e-6);
    EXPECT_NEAR(hit.normal[1], 1, 1e-6);
}

TEST_F(Picking, ObjectsGoByTheirNumber) {
    const Soup soup = sphere(1);
    const Shown shown(soup);
    const FlgRay ray{{0.1f, 0.2f, 5}, 0, {0, 0, -1}, HUGE_VALF};
    FlgHit hit;
    ASSERT_EQ(flgPickSceneCastRays(scene, &ray, 1, &hit), FLG_OK);
    EXPECT_EQ(hit.object, FLG_NO_INDEX);
    ASSERT_EQ(flgPickSceneSetSurface(scene, 1, &shown.view, nullptr, 0), FLG_OK);
    ASSERT_EQ(flgPickSceneCommit(scene), FLG_OK);
    ASSERT_EQ(flgPickSceneCastRays(scene, &ray, 1, &hit), FLG_OK);
    EXPECT_EQ(hit.object, 1u);
    ASSERT_EQ(flgPickSceneRemove(scene, 1), FLG_OK);
    ASSERT_EQ(flgPickSceneCommit(scene), FLG_OK);
    ASSERT_EQ(flgPickSceneCastRays(scene, &ray, 1, &hit), FLG_OK);
    EXPECT_EQ(hit.object, FLG_NO_INDEX);
    EXPECT_EQ(flgPickSceneRemove(scene, 1), FLG_ERROR_INVALID_ARGUMENT);
    EXPECT_STREQ(flgPickErrorGetMessage(), "object is 1, nothing in the scene");
}

TEST_F(Picking, QueriesRunSideBySide) {
    const Soup soup = torus(40, 20);
    const Shown shown(soup);
    ASSERT_EQ(flgPickSceneSetSurface(scene, 0, &shown.view, nullptr, 0), FLG_OK);
    ASSERT_EQ(flgPickSceneCommit(scene), FLG_OK);
    std::vector<FlgRay> rays;
    for (uint64_t i = 0; i < 2000; ++i) rays.push_back(random_ray(i));
    std::array<std::vector<FlgHit>, 4> hits;
    std::vector<std::thread> threads;
    for (auto& own : hits) {
        own.resize(rays.size());
        threads.emplace_back(
            [&] { flgPickSceneCastRays(scene, rays.data(), static_cast<uint32_t>(rays.size()), own.data()); });
    }
    for (std::thread& thread : threads) thread.join();
    for (const auto& own : hits) {
        for (size_t i = 0; i < rays.size(); ++i) {
            EXPECT_EQ(own[i].element, hits[0][i].element);
            EXPECT_EQ(own[i].distance, hits[0][i].distance);
        }
    }
}

TEST_F(Picking, RefusesWhatIsNoRayPointOrSurface) {
    FlgHit hit;
    const float nan = std::nanf("");
    const struct {
        FlgRay ray;
        const char* sentence;
    } cases[] = {
        {{{0, nan, 0}, 0, {0, 0, 1}, 1}, "the origin of rays[0] holds nan, must be finite and at most 1e18 in size"},
        {{{0, 0, 1e19f}, 0, {0, 0, 1}, 1},
         "the origin of rays[0] holds 1e+19, must be finite and at most 1e18 in size"},
        {{{0, 0, 0}, 0, {0, 0, 0}, 1}, "the direction of rays[0] is 0"},
        {{{0, 0, 0}, 0, {HUGE_VALF, 0, 0}, 1}, "the direction of rays[0] holds inf, must be finite"},
        {{{0, 0, 0}, -1, {0, 0, 1}, 1}, "rays[0] goes from -1 to 1, must be 0 or above and rising"},
        {{{0, 0, 0}, 2, {0, 0, 1}, 1}, "rays[0] goes from 2 to 1, must be 0 or above and rising"},
        {{{0, 0, 0}, 0, {0, 0, 1}, nan}, "rays[0] goes from 0 to nan, must be 0 or above and rising"},
    };
    for (const auto& [ray, sentence] : cases) {
        EXPECT_EQ(flgPickSceneCastRays(scene, &ray, 1, &hit), FLG_ERROR_INVALID_ARGUMENT);
        EXPECT_STREQ(flgPickErrorGetMessage(), sentence);
    }
    const float point[3] = {0, 0, 0}, bad[3] = {nan, 0, 0};
    EXPECT_EQ(flgPickSceneFindNearest(scene, bad, 1, &hit), FLG_ERROR_INVALID_ARGUMENT);
    EXPECT_EQ(flgPickSceneFindNearest(scene, point, 0, &hit), FLG_ERROR_INVALID_ARGUMENT);
    EXPECT_EQ(flgPickSceneFindNearest(nullptr, point, 1, &hit), FLG_ERROR_INVALID_ARGUMENT);
    EXPECT_STREQ(flgPickErrorGetMessage(), "scene is null");

    const Soup soup = sphere(0);
    Shown shown(soup);
    const uint32_t changed[] = {20};
    EXPECT_EQ(flgPickSceneSetSurface(scene, 0, &shown.view, changed, 1), FLG_ERROR_INVALID_ARGUMENT);
    EXPECT_STREQ(flgPickErrorGetMessage(), "changed[0] is 20, but there are 20 triangles");
    Soup far = soup;
    far.positions[3][1] = 2e18f;
    const Shown far_away(far);
    EXPECT_EQ(flgPickSceneSetSurface(scene, 0, &far_away.view, nullptr, 0), FLG_ERROR_INVALID_ARGUMENT);
    EXPECT_STREQ(flgPickErrorGetMessage(),
                 "the position of vertex 3 holds 2e+18, must be finite and at most 1e18 in size");
    shown.mesh.vertex_count = 5;
    EXPECT_EQ(flgPickSceneSetSurface(scene, 0, &shown.view, nullptr, 0), FLG_ERROR_INVALID_ARGUMENT);
    EXPECT_STREQ(flgPickErrorGetMessage(), "surface.mesh.triangles[1] is 11, but there are 5 vertices");
    FlgCurveSetView curves{sizeof curves, 1, nullptr, nullptr, nullptr, 0, 0, {}};
    EXPECT_EQ(flgPickSceneSetCurves(scene, 0, &curves, 0.1f), FLG_ERROR_INVALID_ARGUMENT);
    EXPECT_STREQ(flgPickErrorGetMessage(), "curves.columns has no FLG_ATTRIBUTE_POSITION");
}

// ---- Large worlds

constexpr double far_away[3] = {1e6, -1e6 + 0.5, 3e9};

FlgPickScene scene_at(const double (&origin)[3]) {
    FlgPickSceneDesc desc = flgPickSceneDefaults();
    std::copy(origin, origin + 3, desc.origin);
    FlgPickScene scene = nullptr;
    EXPECT_EQ(flgPickSceneCreate(&desc, &scene), FLG_OK) << flgPickErrorGetMessage();
    return scene;
}

// Hits of rays and of the nearest point on a surface and a curve of one origin, in a scene of another; `offset` is
// where the objects' coordinates begin.
std::string hits_of(const double (&scene_origin)[3], const double (&origin)[3], float offset) {
    Soup soup = sphere(3);
    for (auto& position : soup.positions) {
        for (float& x : position) x = std::round(256 * x) / 256 + offset;
    }
    Shown shown(soup);
    std::copy(origin, origin + 3, shown.mesh.origin);
    const float points[] = {2 + offset, -1 + offset, offset, 2 + offset, 1 + offset, offset};
    const FlgColumn column = {FLG_ATTRIBUTE_POSITION, 3, points, 0, 0};
    const uint32_t offsets[] = {0, 2};
    FlgCurveSetView curves = flgCurveSetViewDefaults();
    curves.curve_count = 1;
    curves.curve_offsets = offsets;
    curves.columns = &column;
    curves.column_count = 1;
    std::copy(origin, origin + 3, curves.origin);
    const FlgPickScene scene = scene_at(scene_origin);
    EXPECT_EQ(flgPickSceneSetSurface(scene, 3, &shown.view, nullptr, 0), FLG_OK) << flgPickErrorGetMessage();
    EXPECT_EQ(flgPickSceneSetCurves(scene, 4, &curves, 0.01f), FLG_OK) << flgPickErrorGetMessage();
    EXPECT_EQ(flgPickSceneCommit(scene), FLG_OK) << flgPickErrorGetMessage();
    std::vector<FlgRay> rays;
    for (uint64_t i = 0; i < 200; ++i) rays.push_back(random_ray(i));
    rays.push_back({{2, 0.25f, -3}, 0, {0, 0, 1}, HUGE_VALF});
    std::vector<FlgHit> hits(rays.size() + 1);
    EXPECT_EQ(flgPickSceneCastRays(scene, rays.data(), static_cast<uint32_t>(rays.size()), hits.data()), FLG_OK);
    EXPECT_EQ(hits[200].object, 4u);
    const float point[] = {0.3f, 1.4f, 0.2f};
    EXPECT_EQ(flgPickSceneFindNearest(scene, point, HUGE_VALF, &hits.back()), FLG_OK);
    EXPECT_EQ(hits.back().object, 3u);
    flgPickSceneDestroy(scene);
    return {reinterpret_cast<const char*>(hits.data()), hits.size() * sizeof(FlgHit)};
}

TEST(PickingInLargeWorlds, HitsHaveTheSameBitsWhereverSceneAndObjectsAre) {
    constexpr double home[3] = {0, 0, 0}, beside[3] = {1e6 - 4, -1e6 + 0.5 - 4, 3e9 - 4};
    const std::string at_home = hits_of(home, home, 0);
    EXPECT_TRUE(hits_of(far_away, far_away, 0) == at_home);
    EXPECT_TRUE(hits_of(far_away, beside, 4) == at_home) << "moved from their origin to the scene's";
}

TEST(PickingInLargeWorlds, WhatTheScenesFloatsCannotHoldIsRefused) {
    constexpr double home[3] = {0, 0, 0};
    const Soup soup = sphere(3);
    Shown shown(soup);
    std::copy(far_away, far_away + 3, shown.mesh.origin);
    const FlgPickScene scene = scene_at(home);
    EXPECT_EQ(flgPickSceneSetSurface(scene, 0, &shown.view, nullptr, 0), FLG_ERROR_INVALID_ARGUMENT);
    EXPECT_NE(std::string(flgPickErrorGetMessage()).find("FlgPickSceneDesc::origin"), std::string::npos)
        << flgPickErrorGetMessage();
    const float points[] = {0, 0, 0, 0, 1, 0};
    const FlgColumn column = {FLG_ATTRIBUTE_POSITION, 3, points, 0, 0};
    const uint32_t offsets[] = {0, 2};
    FlgCurveSetView curves = flgCurveSetViewDefaults();
    curves.curve_count = 1;
    curves.curve_offsets = offsets;
    curves.columns = &column;
    curves.column_count = 1;
    std::copy(far_away, far_away + 3, curves.origin);
    EXPECT_EQ(flgPickSceneSetCurves(scene, 0, &curves, 0.01f), FLG_ERROR_INVALID_ARGUMENT);
    EXPECT_NE(std::string(flgPickErrorGetMessage()).find("min_radius"), std::string::npos) << flgPickErrorGetMessage();
    flgPickSceneDestroy(scene);
    FlgPickSceneDesc desc = flgPickSceneDefaults();
    desc.origin[1] = HUGE_VAL;
    FlgPickScene none = nullptr;
    EXPECT_EQ(flgPickSceneCreate(&desc, &none), FLG_ERROR_INVALID_ARGUMENT);
    EXPECT_EQ(none, nullptr);
}

}  // namespace
}  // namespace flg::test
