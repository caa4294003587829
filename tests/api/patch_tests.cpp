// SPDX-License-Identifier: MIT
// Parametrized surfaces of the host behind the C ABI.
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "api/host.h"
#include "filigree/filigree_spline.h"

namespace flg::test {
namespace {

constexpr double ring = 2, tube = 0.7;

void torus(void*, double u, double v, double* out) {
    const double cu = std::cos(u), su = std::sin(u), c = tube * std::cos(v), s = tube * std::sin(v), r = ring + c;
    const double all[18] = {r * cu,  r * su,  s, -r * su, r * cu,  0, -s * cu, -s * su, c,
                            -r * cu, -r * su, 0, s * su,  -s * cu, 0, -c * cu, -c * su, -s};
    std::copy_n(all, 18, out);
}

FlgPatchFunctions torus_functions() {
    FlgPatchFunctions functions = {};
    EXPECT_EQ(flgPatchFunctionsInit(&functions, sizeof functions), FLG_OK);
    functions.high[0] = functions.high[1] = 2 * M_PI;
    functions.periodic[0] = functions.periodic[1] = 1;
    functions.evaluate = torus;
    functions.size = 2 * (ring + tube);
    return functions;
}

FlgSplineView spline_on(const Host& host, FlgManifold manifold) {
    // Around the seams of both parameters.
    std::vector<double> points;
    for (const double turn : {-0.8, 0.0, 0.9, 2.2, 3.3}) {
        double all[18];
        torus(nullptr, turn, 1.5 * std::sin(2 * turn), all);
        points.insert(points.end(), all, all + 3);
    }
    FlgSplineDesc desc = {};
    EXPECT_EQ(flgSplineDescInit(&desc, sizeof desc), FLG_OK);
    desc.manifold = manifold;
    desc.points = points.data();
    desc.point_count = 5;
    desc.node_count = 161;
    desc.tolerance = 1e-9;
    FlgSpline spline{};
    EXPECT_EQ(flgSplineCreate(host.context, &desc, &spline, nullptr), FLG_OK) << flgErrorGetMessage();
    host.finish();
    FlgSplineView view = {};
    EXPECT_EQ(flgSplineViewInit(&view, sizeof view), FLG_OK);
    EXPECT_EQ(flgSplineGetView(host.context, spline, &view), FLG_OK) << flgErrorGetMessage();
    return view;
}

TEST(PatchApi, ParametrizedAndImplicitTorusHaveTheSameSplines) {
    const Host host;
    const FlgPatchFunctions functions = torus_functions();
    FlgManifold patch{}, implicit{};
    ASSERT_EQ(flgManifoldCreatePatch(host.context, &functions, &patch), FLG_OK) << flgErrorGetMessage();
    FlgManifoldShapeDesc shape = {};
    ASSERT_EQ(flgManifoldShapeDescInit(&shape, sizeof shape), FLG_OK);
    shape.shape = FLG_MANIFOLD_SHAPE_TORUS;
    shape.radius = ring;
    shape.tube_radius = tube;
    ASSERT_EQ(flgManifoldCreateShape(host.context, &shape, &implicit), FLG_OK) << flgErrorGetMessage();
    const FlgSplineView first = spline_on(host, patch), second = spline_on(host, implicit);
    EXPECT_EQ(first.ending, FLG_SPLINE_ENDING_CONVERGED);
    EXPECT_NEAR(first.energy, second.energy, 1e-8 * first.energy);
    ASSERT_EQ(first.node_count, second.node_count);
    for (uint32_t i = 0; i < 3 * first.node_count; ++i) EXPECT_NEAR(first.nodes[i], second.nodes[i], 1e-6);
    FlgManifoldView view = {};
    ASSERT_EQ(flgManifoldViewInit(&view, sizeof view), FLG_OK);
    ASSERT_EQ(flgManifoldGetView(host.context, patch, &view), FLG_OK);
    EXPECT_EQ(view.ambient, 3u);
    EXPECT_EQ(view.dimension, 2u);
    EXPECT_EQ(view.size, 2 * (ring + tube));
    // Outwards.
    EXPECT_GT(first.nodes[0] * first.normals[0] + first.nodes[1] * first.normals[1], 0);
    EXPECT_EQ(flgManifoldRelease(host.context, patch), FLG_OK);
}

TEST(PatchApi, RefusesWhatIsNoSurface) {
    const Host host;
    const auto refusal = [&](const std::function<void(FlgPatchFunctions&)>& change) {
        FlgPatchFunctions functions = torus_functions();
        change(functions);
        FlgManifold manifold{7};
        EXPECT_EQ(flgManifoldCreatePatch(host.context, &functions, &manifold), FLG_ERROR_INVALID_ARGUMENT);
        EXPECT_EQ(manifold.id, 0u);
        return std::string(flgErrorGetMessage());
    };
    using Functions = FlgPatchFunctions;
    EXPECT_EQ(refusal([](Functions& f) { f.evaluate = nullptr; }), "functions.evaluate is null");
    EXPECT_EQ(refusal([](Functions& f) { f.high[1] = 0; }),
              "functions.high is 0, must be above functions.low, at most 1e30");
    EXPECT_EQ(refusal([](Functions& f) { f.low[0] = -HUGE_VAL; }),
              "functions.low is -inf, must be finite and at most 1e30 in size");
    EXPECT_EQ(refusal([](Functions& f) { f.size = 0; }).rfind("functions.size is 0", 0), 0u);
    EXPECT_EQ(refusal([](Functions& f) { f.margin = 2; }), "functions.margin is 2, must be 0 to 1");
    EXPECT_EQ(refusal([](Functions& f) {
                  f.evaluate = [](void*, double u, double, double* out) {
                      std::fill_n(out, 18, 0.0);
                      out[0] = u;
                      out[3] = out[6] = 1;
                  };
              }),
              "functions.evaluate gives derivatives u and v that are parallel");
    EXPECT_EQ(refusal([](Functions& f) {
                  f.evaluate = [](void*, double, double, double* out) { std::fill_n(out, 18, std::nan("")); };
              }),
              "functions.evaluate gives nan at u = 0, v = 0");
    EXPECT_NE(refusal([](Functions& f) { f.struct_size = 3; }).find("functions: struct_size is 3"), std::string::npos);
    EXPECT_EQ(flgManifoldCreatePatch(host.context, nullptr, nullptr), FLG_ERROR_INVALID_ARGUMENT);
}

// A host's surface with a hole of numbers that are none: the job says where, whatever the function.
struct Holed {
    enum Function { evaluate, project, tangent_basis, second_form };
    Function function;
    bool is_broken = false;
};

std::string failure_on(const Host& host, FlgManifold manifold) {
    const double points[] = {2.7, 0, 0, 0, 2.7, 0};
    FlgSplineDesc desc = flgSplineDefaults();
    desc.manifold = manifold;
    desc.points = points;
    desc.point_count = 2;
    FlgSpline spline{};
    EXPECT_EQ(flgSplineCreate(host.context, &desc, &spline, nullptr), FLG_OK) << flgErrorGetMessage();
    host.finish();
    FlgSplineView view = flgSplineViewDefaults();
    EXPECT_EQ(flgSplineGetView(host.context, spline, &view), FLG_ERROR_INVALID_ARGUMENT);
    return flgErrorGetMessage();
}

TEST(PatchApi, NumbersThatAreNoneFailTheJobWithTheirPlace) {
    const Host host;
    Holed patch{Holed::evaluate};
    FlgPatchFunctions functions = torus_functions();
    functions.user_data = &patch;
    functions.evaluate = [](void* user_data, double u, double v, double* out) {
        torus(nullptr, u, v, out);
        if (static_cast<const Holed*>(user_data)->is_broken && u > 0.7 && u < 0.9) out[5] = std::nan("");
    };
    FlgManifold manifold{};
    ASSERT_EQ(flgManifoldCreatePatch(host.context, &functions, &manifold), FLG_OK) << flgErrorGetMessage();
    patch.is_broken = true;
    EXPECT_EQ(failure_on(host, manifold).rfind("functions.evaluate gives nan at u = 0.", 0), 0u)
        << flgErrorGetMessage();

    FlgManifoldFunctions sphere = flgManifoldFunctionsDefaults();
    sphere.project = [](void* user_data, double* x, double*) {
        const double size = std::hypot(x[0], x[1], x[2]);
        for (int c = 0; c < 3; ++c) x[c] *= 2.7 / size;
        const auto* hole = static_cast<const Holed*>(user_data);
        if (hole->is_broken && hole->function == Holed::project && x[0] > 1 && x[1] > 1) x[1] = HUGE_VAL;
        return 1;
    };
    sphere.tangent_basis = [](void* user_data, const double* x, double*, double* basis) {
        const double flat = std::hypot(x[0], x[1]), size = std::hypot(flat, x[2]);
        const double rows[6] = {
            -x[1] / flat, x[0] / flat, 0, -x[0] * x[2] / (flat * size), -x[1] * x[2] / (flat * size), flat / size};
        std::copy_n(rows, 6, basis);
        const auto* hole = static_cast<const Holed*>(user_data);
        if (hole->is_broken && hole->function == Holed::tangent_basis && x[0] > 1 && x[1] > 1) basis[2] = std::nan("");
    };
    sphere.second_form = [](void* user_data, const double* x, double*, const double*, const double* force,
                            double* form) {
        const double along = (force[0] * x[0] + force[1] * x[1] + force[2] * x[2]) / (2.7 * 2.7);
        const double values[4] = {-along, 0, 0, -along};
        std::copy_n(values, 4, form);
        const auto* hole = static_cast<const Holed*>(user_data);
        if (hole->is_broken && hole->function == Holed::second_form && x[0] > 1 && x[1] > 1) form[3] = -HUGE_VAL;
    };
    const double near[3] = {2.7, 0, 0};
    for (const auto& [function, words] : std::vector<std::pair<Holed::Function, std::string>>{
             {Holed::project, "functions.project gives inf near"},
             {Holed::tangent_basis, "functions.tangent_basis gives nan near"},
             {Holed::second_form, "functions.second_form gives -inf near"}}) {
        Holed hole{function};
        sphere.user_data = &hole;
        ASSERT_EQ(flgManifoldCreateHost(host.context, &sphere, near, &manifold), FLG_OK) << flgErrorGetMessage();
        hole.is_broken = true;
        EXPECT_EQ(failure_on(host, manifold).rfind(words, 0), 0u) << flgErrorGetMessage();
    }
}

}  // namespace
}  // namespace flg::test
