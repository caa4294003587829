// SPDX-License-Identifier: MIT
// Closed curves, networks, strokes, bases, frames and attributes of results, through the C ABI.
#include <array>

#include "api/host.h"

namespace flg::test {
namespace {

using Floats = std::vector<float>;

// Curves with any columns beside their positions.
struct Set {
    Curves curves;
    struct Extra {
        FlgAttribute attribute;
        uint32_t components;
        Floats values;
    };
    std::vector<Extra> extras;

    FlgCurveSet create(const Host& host) {
        FlgCurveSetView view = curves.view();
        for (const Extra& extra : extras) {
            curves.columns.push_back({extra.attribute, extra.components, extra.values.data(), 0, 0});
        }
        view.columns = curves.columns.data();
        view.column_count = static_cast<uint32_t>(curves.columns.size());
        FlgCurveSet set{};
        EXPECT_EQ(flgCurveSetCreate(host.context, &view, &set), FLG_OK) << flgErrorGetMessage();
        return set;
    }
};

// The coil with all that a style can transfer.
Set rich_style() {
    Set set{coil(), {}};
    Floats radius, color, radii, angle, width, speed, user;
    for (int i = 0; i < 400; ++i) {
        const float u = static_cast<float>(i) / 399;
        radius.push_back(0.02f + 0.01f * u);
        color.insert(color.end(), {u, 1 - u, 0.5f, 1});
        radii.insert(radii.end(), {0.1f + u, 0.2f, 0.3f * u});
        angle.push_back(9 * u);
        width.push_back(0.1f + 0.1f * u);
        speed.push_back(1 + u);
        user.insert(user.end(), {u, -u});
    }
    set.extras = {{FLG_ATTRIBUTE_RADIUS, 1, radius}, {FLG_ATTRIBUTE_COLOR, 4, color}, {FLG_ATTRIBUTE_RADII, 3, radii},
                  {FLG_ATTRIBUTE_ANGLE, 1, angle},   {FLG_ATTRIBUTE_WIDTH, 1, width}, {FLG_ATTRIBUTE_SPEED, 1, speed},
                  {FLG_ATTRIBUTE_USER, 2, user}};
    return set;
}

FlgStyle make_style(const Host& host, Set example, bool with_attributes) {
    FlgStyleDesc desc = flgStyleDefaults();
    desc.style = example.create(host);
    std::vector<FlgStyleAttribute> attributes;
    for (const Set::Extra& extra : example.extras) attributes.push_back({extra.attribute, FLG_METRIC_AUTO, 0.01f, 0});
    if (with_attributes) {
        desc.attributes = attributes.data();
        desc.attribute_count = static_cast<uint32_t>(attributes.size());
    }
    FlgStyle style{};
    EXPECT_EQ(flgStyleCreate(host.context, &desc, &style, nullptr), FLG_OK) << flgErrorGetMessage();
    return style;
}

// Runs the job to its end.
FlgCurveSetView stylized(const Host& host, const FlgCurveSetStylizeDesc& desc) {
    FlgCurveSet out{};
    FlgJob job{};
    EXPECT_EQ(flgCurveSetStylize(host.context, &desc, &out, &job), FLG_OK) << flgErrorGetMessage();
    host.finish();
    EXPECT_EQ(host.status_of(job).result, FLG_OK) << host.status_of(job).error;
    return host.view_of(out);
}

const float* column(const FlgCurveSetView& view, FlgAttribute attribute) {
    const FlgColumn* found = find_column(view, attribute);
    EXPECT_NE(found, nullptr) << "attribute " << attribute;
    return found->data;
}

std::array<float, 3> at(const float* column, uint32_t i) {
    return {column[3 * i], column[3 * i + 1], column[3 * i + 2]};
}

double distance(const float* p, uint32_t i, uint32_t j) {
    return std::hypot(p[3 * i] - p[3 * j], p[3 * i + 1] - p[3 * j + 1], p[3 * i + 2] - p[3 * j + 2]);
}

// A bent ring and an arc, with normals, times and radii of their own.
Set targets() {
    Set set;
    Floats normals, times;
    for (int c = 0; c < 2; ++c) {
        for (int i = 0; i < 90; ++i) {
            const double a = 2 * M_PI * i / 90;
            set.curves.add_point(3 * std::cos(a), 3 * std::sin(a) + c, 0.5 * std::sin(3 * a) + 0.3 * c * a);
            set.curves.radii.push_back(0.5f);
            normals.insert(normals.end(), {0.2f, 0, 1});
            times.push_back(7.0f + static_cast<float>(i));
        }
        set.curves.end_curve(c == 0 ? FLG_CURVE_CLOSED : 0);
    }
    set.extras = {{FLG_ATTRIBUTE_NORMAL, 3, normals}, {FLG_ATTRIBUTE_TIME, 1, times}};
    return set;
}

FlgCurveSetStylizeDesc all_options() {
    FlgCurveSetStylizeDesc desc = flgCurveSetStylizeDefaults();
    desc.temperature = 0.5f;
    desc.scale = 0.7f;
    desc.magnitude = 0.8f;
    desc.frame = FLG_FRAME_METHOD_SUPPLIED;
    const float basis[9] = {0, 1, 0, 0, 0, 1, 1, 0, 0};
    std::copy(basis, basis + 9, desc.basis);
    desc.strokes = 3;
    desc.keep_displacement = 1;
    return desc;
}

TEST(StylizeOptionsApi, SameBitsUnderAnyWorkersWithAllOptions) {
    for (uint32_t pin_ends : {0u, 1u}) {
        std::string expected;
        for (uint32_t workers : {0u, 1u, 2u, 4u}) {
            for (uint32_t budget_us : {FLG_UNLIMITED, 300u}) {
                Host host(workers);
                FlgCurveSetStylizeDesc desc = all_options();
                desc.pin_ends = pin_ends;
                desc.style = make_style(host, rich_style(), true);
                desc.target = targets().create(host);
                FlgCurveSet out{};
                ASSERT_EQ(flgCurveSetStylize(host.context, &desc, &out, nullptr), FLG_OK) << flgErrorGetMessage();
                host.finish(budget_us);
                const std::string now = bits(host.view_of(out));
                if (expected.empty()) expected = now;
                EXPECT_TRUE(now == expected) << workers << " workers, budget " << budget_us;
            }
        }
    }
}

TEST(StylizeOptionsApi, ResultsHaveTheStylesAttributesAndTheTargetsOthers) {
    Host host;
    FlgCurveSetStylizeDesc desc = flgCurveSetStylizeDefaults();
    desc.style = make_style(host, rich_style(), true);
    desc.target = targets().create(host);
    desc.scale = 0.5f;
    const FlgCurveSetView view = stylized(host, desc);
    const uint32_t first = view.curve_offsets[1], last = view.curve_offsets[2];  // the open one
    EXPECT_EQ(column(view, FLG_ATTRIBUTE_TIME)[first], 7.0f);
    uint32_t since_jump = 10;
    for (uint32_t i = first; i < last; ++i) {
        // All were made from the place u on the style, and lie linearly in it.
        const float u = column(view, FLG_ATTRIBUTE_USER)[2 * i];
        EXPECT_NEAR(column(view, FLG_ATTRIBUTE_USER)[2 * i + 1], -u, 1e-5);
        EXPECT_NEAR(column(view, FLG_ATTRIBUTE_RADIUS)[i], 0.5f * (0.02f + 0.01f * u), 1e-6);
        EXPECT_NEAR(column(view, FLG_ATTRIBUTE_COLOR)[4 * i + 1], 1 - u, 1e-5);
        EXPECT_NEAR(column(view, FLG_ATTRIBUTE_RADII)[3 * i], 0.5f * (0.1f + u), 1e-5);
        EXPECT_NEAR(column(view, FLG_ATTRIBUTE_RADII)[3 * i + 1], 0.1f, 1e-6);
        EXPECT_NEAR(std::remainder(column(view, FLG_ATTRIBUTE_RADII)[3 * i + 2] - 0.3f * u, 2 * M_PI), 0, 1e-4);
        // Angles are blended by the shorter way around, so not along with u, but over p points behind a jump.
        const bool jump = i > first && column(view, FLG_ATTRIBUTE_STYLE_INDEX)[i] !=
                                           column(view, FLG_ATTRIBUTE_STYLE_INDEX)[i - 1] + 1;
        since_jump = jump ? 0 : since_jump + 1;
        if (since_jump >= 10) {
            EXPECT_NEAR(std::remainder(column(view, FLG_ATTRIBUTE_ANGLE)[i] - 9 * u, 2 * M_PI), 0, 1e-4);
        }
        if (i > first) {
            EXPECT_LT(std::abs(column(view, FLG_ATTRIBUTE_ANGLE)[i] - column(view, FLG_ATTRIBUTE_ANGLE)[i - 1]), 0.7);
        }
        EXPECT_NEAR(column(view, FLG_ATTRIBUTE_WIDTH)[i], 0.5f * (0.1f + 0.1f * u), 1e-6);
        EXPECT_NEAR(column(view, FLG_ATTRIBUTE_SPEED)[i], 1 + u, 1e-5);
        if (i > first) {
            EXPECT_GT(column(view, FLG_ATTRIBUTE_TIME)[i], column(view, FLG_ATTRIBUTE_TIME)[i - 1]);
        }
    }
    EXPECT_EQ(find_column(view, FLG_ATTRIBUTE_DISPLACEMENT), nullptr);
    // A style that has them but doesn't transfer them leaves the target's.
    desc.style = make_style(host, rich_style(), false);
    const FlgCurveSetView plain = stylized(host, desc);
    EXPECT_EQ(column(plain, FLG_ATTRIBUTE_RADIUS)[5], 0.5f);
    EXPECT_EQ(find_column(plain, FLG_ATTRIBUTE_SPEED), nullptr);
    EXPECT_NEAR(column(plain, FLG_ATTRIBUTE_TIME)[plain.curve_offsets[2] - 1], 7 + 89, 1e-3);
    // Without times of its own the result's begin at 0, though the target has nothing to replace.
    desc.style = make_style(host, rich_style(), true);
    desc.target = host.create(arcs(1));
    EXPECT_EQ(column(stylized(host, desc), FLG_ATTRIBUTE_TIME)[0], 0.0f);
}

TEST(StylizeOptionsApi, ClosedTargetsComeOutClosed) {
    Host host;
    FlgCurveSetStylizeDesc desc = flgCurveSetStylizeDefaults();
    desc.style = make_style(host, {coil(), {}}, false);
    desc.target = targets().create(host);
    desc.keep_displacement = 1;
    const FlgCurveSetView view = stylized(host, desc);
    EXPECT_EQ(view.curve_flags[0], FLG_CURVE_CLOSED);
    EXPECT_EQ(view.curve_flags[1], 0);
    const float* p = column(view, FLG_ATTRIBUTE_POSITION);
    const uint32_t count = view.curve_offsets[1];
    double longest = 0;
    for (uint32_t i = 1; i < count; ++i) longest = std::max(longest, distance(p, i - 1, i));
    EXPECT_GT(distance(p, count - 1, 0), 0);
    EXPECT_LT(distance(p, count - 1, 0), 1.5 * longest);
}

// An n x n grid of vertices that are moved about: its edges are slightly bent curves.
struct Network {
    Curves curves;
    std::vector<std::pair<uint32_t, uint32_t>> edges;
    uint32_t size;

    explicit Network(uint32_t n) : size(n) {
        for (uint32_t i = 0; i < n; ++i) {
            for (uint32_t j = 0; j < n; ++j) {
                if (i + 1 < n) add_edge(i, j, i + 1, j);
                if (j + 1 < n) add_edge(i, j, i, j + 1);
            }
        }
    }
    static std::array<float, 3> vertex(uint32_t i, uint32_t j) {
        const double x = i + 0.2 * std::sin(3.0 * i + j), y = j + 0.2 * std::cos(2.0 * j - i);
        return {static_cast<float>(x), static_cast<float>(y), static_cast<float>(std::sin(0.3 * (x + 2 * y)))};
    }
    void add_edge(uint32_t i, uint32_t j, uint32_t k, uint32_t l) {
        const auto a = vertex(i, j), b = vertex(k, l);
        curves.add_point(a[0], a[1], a[2]);
        curves.add_point(0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1]) + 0.05, 0.5 * (a[2] + b[2]));
        curves.add_point(b[0], b[1], b[2]);
        curves.end_curve();
        edges.emplace_back(i * size + j, k * size + l);
    }
};

TEST(StylizeOptionsApi, NetworksKeepTheirTopology) {
    Host host(1);
    const Network network(46);
    ASSERT_GT(network.edges.size(), 4000u);
    FlgCurveSetStylizeDesc desc = flgCurveSetStylizeDefaults();
    desc.style = make_style(host, {coil(400, 12, 6, 0.1), {}}, false);
    desc.target = host.create(network.curves);
    desc.pin_ends = 1;
    desc.keep_displacement = 1;
    for (float magnitude : {1.0f, -20.0f}) {
        desc.magnitude = magnitude;
        const FlgCurveSetView view = stylized(host, desc);
        ASSERT_EQ(view.curve_count, network.edges.size());
        const float* p = column(view, FLG_ATTRIBUTE_POSITION);
        const float* d = column(view, FLG_ATTRIBUTE_DISPLACEMENT);
        double displaced = 0;
        for (uint32_t c = 0; c < view.curve_count; ++c) {
            const uint32_t first = view.curve_offsets[c], last = view.curve_offsets[c + 1] - 1;
            const auto vertex = [&](uint32_t v) { return Network::vertex(v / network.size, v % network.size); };
            ASSERT_EQ(at(p, first), vertex(network.edges[c].first)) << c;
            ASSERT_EQ(at(p, last), vertex(network.edges[c].second)) << c;
            ASSERT_EQ(at(d, first), (std::array<float, 3>{}));
            ASSERT_EQ(at(d, last), (std::array<float, 3>{}));
            for (uint32_t i = first; i < last; ++i) displaced = std::max(displaced, std::abs(d[3 * i + 2] + 0.0));
        }
        EXPECT_GT(displaced, 0.05);
    }
}

TEST(StylizeOptionsApi, EdgesThatDoNotMeetArePinnedToTheirOwnEnds) {
    Host host;
    Curves edges;
    edges.add_point(0, 0, 0);
    edges.add_point(2, 0, 0);
    edges.end_curve();
    edges.add_point(2.001, 0, 0);  // nearly
    edges.add_point(4, 1, 0);
    edges.end_curve();
    FlgCurveSetStylizeDesc desc = flgCurveSetStylizeDefaults();
    desc.style = make_style(host, {coil(), {}}, false);
    desc.target = host.create(edges);
    desc.pin_ends = 1;
    const FlgCurveSetView view = stylized(host, desc);
    const float* p = column(view, FLG_ATTRIBUTE_POSITION);
    EXPECT_EQ(at(p, view.curve_offsets[1] - 1), (std::array<float, 3>{2, 0, 0}));
    EXPECT_EQ(at(p, view.curve_offsets[1]), (std::array<float, 3>{2.001f, 0, 0}));
}

TEST(StylizeOptionsApi, StrokesDifferAndTheFirstIsTheOnlyOne) {
    Host host;
    FlgCurveSetStylizeDesc desc = flgCurveSetStylizeDefaults();
    desc.style = make_style(host, {coil(), {}}, false);
    for (uint32_t curves : {1u, 3u}) {
        desc.target = host.create(arcs(curves));
        desc.strokes = 1;
        const FlgCurveSetView one = stylized(host, desc);
        desc.strokes = 4;
        const FlgCurveSetView four = stylized(host, desc);
        ASSERT_EQ(four.curve_count, 4 * curves);
        for (uint32_t c = 0; c < curves; ++c) {
            const uint32_t points = one.curve_offsets[c + 1] - one.curve_offsets[c];
            const auto stroke = [&](const FlgCurveSetView& view, uint32_t curve) {
                EXPECT_EQ(view.curve_offsets[curve + 1] - view.curve_offsets[curve], points);
                const float* p = column(view, FLG_ATTRIBUTE_POSITION) + size_t{3} * view.curve_offsets[curve];
                return Floats(p, p + size_t{3} * points);
            };
            EXPECT_EQ(stroke(four, 4 * c), stroke(one, c));
            for (uint32_t k = 1; k < 4; ++k) {
                EXPECT_NE(column(four, FLG_ATTRIBUTE_STYLE_INDEX)[four.curve_offsets[4 * c + k]], 0.0f);
                for (uint32_t l = 0; l < k; ++l) EXPECT_NE(stroke(four, 4 * c + k), stroke(four, 4 * c + l));
            }
            const float* radius = column(four, FLG_ATTRIBUTE_RADIUS);  // carried over to each
            EXPECT_EQ(radius[four.curve_offsets[4 * c + 3]], 0.01f);
        }
    }
}

TEST(StylizeOptionsApi, RigidMotionOfTheTargetMovesTheResultWithAllOptions) {
    // A rotation by a about z, then x -> (y, z, x), and a shift.
    const auto turned = [](const float* v, float* out) {
        const double x = std::cos(0.7) * v[0] - std::sin(0.7) * v[1], y = std::sin(0.7) * v[0] + std::cos(0.7) * v[1];
        const float z = v[2];
        out[0] = static_cast<float>(y);
        out[1] = z;
        out[2] = static_cast<float>(x);
    };
    const float shift[3] = {3, -5, 11};
    Host host;
    const FlgStyle style = make_style(host, rich_style(), true);
    for (FlgFrameMethod frame :
         {FLG_FRAME_METHOD_ROTATION_MINIMIZING, FLG_FRAME_METHOD_FRENET, FLG_FRAME_METHOD_SUPPLIED}) {
        for (uint32_t pin_ends : {0u, 1u}) {
            Set here = targets(), there = targets();
            for (size_t i = 0; i < there.curves.positions.size(); i += 3) {
                turned(&here.curves.positions[i], &there.curves.positions[i]);
                turned(&here.extras[0].values[i], &there.extras[0].values[i]);
                for (int k = 0; k < 3; ++k) there.curves.positions[i + k] += shift[k];
            }
            FlgCurveSetStylizeDesc desc = all_options();
            desc.style = style;
            desc.frame = frame;
            desc.pin_ends = pin_ends;
            desc.target = here.create(host);
            const FlgCurveSetView a = stylized(host, desc);
            desc.target = there.create(host);
            const FlgCurveSetView b = stylized(host, desc);
            ASSERT_EQ(a.curve_offsets[6], b.curve_offsets[6]);
            for (FlgAttribute attribute :
                 {FLG_ATTRIBUTE_POSITION, FLG_ATTRIBUTE_NORMAL, FLG_ATTRIBUTE_TANGENT, FLG_ATTRIBUTE_DISPLACEMENT}) {
                for (uint32_t i = 0; i < a.curve_offsets[6]; ++i) {
                    float expected[3];
                    turned(column(a, attribute) + size_t{3} * i, expected);
                    const float moved = attribute == FLG_ATTRIBUTE_POSITION ? 1.0f : 0.0f;
                    for (int k = 0; k < 3; ++k) {
                        ASSERT_NEAR(column(b, attribute)[3 * i + k], expected[k] + moved * shift[k], 2e-3)
                            << attribute << " " << i << " frame " << frame;
                    }
                }
            }
            for (uint32_t i = 0; i < a.curve_offsets[6]; ++i) {
                ASSERT_EQ(column(a, FLG_ATTRIBUTE_RADIUS)[i], column(b, FLG_ATTRIBUTE_RADIUS)[i]);
            }
        }
    }
}

TEST(StylizeOptionsApi, RefusesEachBadArgument) {
    Host host;
    FlgCurveSetStylizeDesc good = flgCurveSetStylizeDefaults();
    good.style = make_style(host, {coil(), {}}, false);
    good.target = host.create(arcs(1));
    const auto refused = [&](auto change, const char* words) {
        FlgCurveSetStylizeDesc desc = good;
        change(desc);
        FlgCurveSet out{5};
        expect_failure(flgCurveSetStylize(host.context, &desc, &out, nullptr), FLG_ERROR_INVALID_ARGUMENT, words);
        EXPECT_EQ(out.id, 0u);
    };
    refused([](auto& d) { d.strokes = 0; }, "desc.strokes is 0, must be 1 to 1024");
    refused([](auto& d) { d.strokes = 1025; }, "desc.strokes is 1025");
    refused([](auto& d) { d.basis[4] = NAN; }, "desc.basis[4] is nan, must be finite");
    refused([](auto& d) { d.basis[8] = INFINITY; }, "desc.basis[8] is inf");
    host.finish();
}

TEST(StylizeOptionsApi, SuppliedFramesThatAreMissingFailTheJob) {
    Host host;
    FlgCurveSetStylizeDesc stylize = flgCurveSetStylizeDefaults();
    stylize.style = make_style(host, {coil(), {}}, false);
    stylize.target = host.create(arcs(1));
    stylize.frame = FLG_FRAME_METHOD_SUPPLIED;
    FlgCurveSetResampleDesc resample = flgCurveSetResampleDefaults();
    resample.curves = stylize.target;
    resample.spacing = 0.1f;
    resample.frame = FLG_FRAME_METHOD_SUPPLIED;
    FlgCurveSet out{};
    FlgJob stylize_job{}, resample_job{};
    ASSERT_EQ(flgCurveSetStylize(host.context, &stylize, &out, &stylize_job), FLG_OK);
    ASSERT_EQ(flgCurveSetResample(host.context, &resample, &out, &resample_job), FLG_OK);
    host.finish();
    for (FlgJob job : {stylize_job, resample_job}) {
        EXPECT_EQ(host.result_of(job), FLG_ERROR_INVALID_ARGUMENT);
        EXPECT_NE(std::strstr(host.status_of(job).error, "no FLG_ATTRIBUTE_NORMAL column"), nullptr);
    }
    // With normals both do.
    resample.curves = targets().create(host);
    ASSERT_EQ(flgCurveSetResample(host.context, &resample, &out, nullptr), FLG_OK);
    host.finish();
    const FlgCurveSetView view = host.view_of(out);
    for (uint32_t i = 0; i < view.curve_offsets[1]; ++i) EXPECT_GT(column(view, FLG_ATTRIBUTE_NORMAL)[3 * i + 2], 0.8);
}

}  // namespace
}  // namespace flg::test
