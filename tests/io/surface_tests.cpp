// SPDX-License-Identifier: MIT
// Ribbons and tubes, read back by another reader of glTF (tinygltf): closed forms, and what the format asks for.
#include <tiny_gltf.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>
#include <numbers>
#include <set>

#include "io/files.h"

namespace flg::test {
namespace {

struct Point {
    double x, y, z;
};
Point operator-(const Point& a, const Point& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
double dot(const Point& a, const Point& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
Point cross(const Point& a, const Point& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

// Of all its primitives.
struct Surface {
    std::vector<Point> positions, normals;
    std::vector<uint32_t> indices;
    bool double_sided = false;  // the last of them
    bool colored = false;
    size_t primitives = 0;

    double area() const {
        double sum = 0;
        for_triangles([&](const Point& a, const Point& b, const Point& c) {
            const Point n = cross(b - a, c - a);
            sum += std::sqrt(dot(n, n)) / 2;
        });
        return sum;
    }
    // By the divergence theorem: positive when triangles are counter-clockwise from outside.
    double volume() const {
        double sum = 0;
        for_triangles([&](const Point& a, const Point& b, const Point& c) { sum += dot(a, cross(b, c)) / 6; });
        return sum;
    }
    template <class Visit>
    void for_triangles(const Visit& visit) const {
        for (size_t i = 0; i < indices.size(); i += 3) {
            visit(positions[indices[i]], positions[indices[i + 1]], positions[indices[i + 2]]);
        }
    }
    // Every edge, by position, once in each direction.
    bool watertight() const {
        std::map<std::vector<double>, int> edges;
        for (size_t i = 0; i < indices.size(); ++i) {
            const Point& a = positions[indices[i]];
            const Point& b = positions[indices[i % 3 == 2 ? i - 2 : i + 1]];
            ++edges[{a.x, a.y, a.z, b.x, b.y, b.z}];
            --edges[{b.x, b.y, b.z, a.x, a.y, a.z}];
        }
        for (const auto& [edge, count] : edges) {
            if (count != 0) return false;
        }
        return true;
    }
};

std::vector<Point> load_points(const tinygltf::Model& model, int index) {
    const tinygltf::Accessor& accessor = model.accessors[static_cast<size_t>(index)];
    const tinygltf::BufferView& view = model.bufferViews[static_cast<size_t>(accessor.bufferView)];
    EXPECT_EQ(view.target, TINYGLTF_TARGET_ARRAY_BUFFER);
    std::vector<Point> points;
    for (size_t i = 0; i < accessor.count; ++i) {
        float p[3];
        std::memcpy(p, &model.buffers[0].data[view.byteOffset + accessor.byteOffset + i * view.byteStride], sizeof p);
        points.push_back({p[0], p[1], p[2]});
    }
    return points;
}

// `smooth`: no corner turns the surface inside out.
Surface load(const std::string& path, bool smooth) {
    tinygltf::Model model;
    std::string error, warning;
    Surface surface;
    const bool loaded = tinygltf::TinyGLTF().LoadBinaryFromFile(&model, &error, &warning, path);
    EXPECT_TRUE(loaded) << error;
    EXPECT_EQ(warning, "");
    if (!loaded) return surface;
    std::set<int> used;
    for (const tinygltf::Primitive& primitive : model.meshes.at(0).primitives) {
        EXPECT_EQ(primitive.mode, TINYGLTF_MODE_TRIANGLES);
        const auto first = static_cast<uint32_t>(surface.positions.size());
        const tinygltf::Accessor& positions = model.accessors[static_cast<size_t>(primitive.attributes.at("POSITION"))];
        for (const Point& p : load_points(model, primitive.attributes.at("POSITION"))) {
            EXPECT_TRUE(p.x >= positions.minValues[0] && p.y >= positions.minValues[1] &&
                        p.z >= positions.minValues[2]);
            EXPECT_TRUE(p.x <= positions.maxValues[0] && p.y <= positions.maxValues[1] &&
                        p.z <= positions.maxValues[2]);
            surface.positions.push_back(p);
        }
        for (const Point& n : load_points(model, primitive.attributes.at("NORMAL"))) surface.normals.push_back(n);
        surface.colored = primitive.attributes.count("COLOR_0") != 0;
        surface.double_sided = model.materials.at(static_cast<size_t>(primitive.material)).doubleSided;
        const tinygltf::Accessor& accessor = model.accessors[static_cast<size_t>(primitive.indices)];
        const tinygltf::BufferView& view = model.bufferViews[static_cast<size_t>(accessor.bufferView)];
        const bool narrow = accessor.componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT;
        // 16 bits wherever they number all vertices.
        EXPECT_EQ(narrow, positions.count <= 65535);
        for (size_t i = 0; i < accessor.count; ++i) {
            uint32_t index = 0;
            const size_t size = narrow ? sizeof(uint16_t) : sizeof index;
            std::memcpy(&index, &model.buffers[0].data[view.byteOffset + i * size], size);
            EXPECT_LT(index, positions.count);
            surface.indices.push_back(first + index);
        }
        used.insert(primitive.material);
        ++surface.primitives;
    }
    EXPECT_EQ(used.size(), model.materials.size());  // none for nothing
    for (const Point& n : surface.normals) EXPECT_NEAR(dot(n, n), 1, 1e-5);
    // Triangles face where their normals point.
    for (size_t i = 0; smooth && i < surface.indices.size(); i += 3) {
        const uint32_t* t = &surface.indices[i];
        const Point face =
            cross(surface.positions[t[1]] - surface.positions[t[0]], surface.positions[t[2]] - surface.positions[t[0]]);
        for (int k = 0; k < 3; ++k) EXPECT_GE(dot(face, surface.normals[t[k]]), -1e-9);
    }
    return surface;
}

FlgCurveFileWriteDesc desc_of(FlgCurveGeometry geometry, uint32_t sides = 8) {
    FlgCurveFileWriteDesc desc;
    EXPECT_EQ(flgCurveFileWriteDescInit(&desc, sizeof desc), FLG_OK);
    desc.geometry = geometry;
    desc.tube_sides = sides;
    return desc;
}

Surface swept(Curves& curves, const FlgCurveFileWriteDesc& desc, bool smooth = true) {
    const Folder folder;
    const FlgResult result = write(folder.at("a.glb"), curves, &desc);
    EXPECT_EQ(result, FLG_OK) << flgIoErrorGetMessage();
    return result == FLG_OK ? load(folder.at("a.glb"), smooth) : Surface{};
}

TEST(Surface, StraightTubeIsAPrism) {
    Curves curves;
    curves.add({1, 2, 3, 1, 2, 4, 1, 2, 4, 1, 2, 6});  // with a repeated point
    for (const uint32_t sides : {3u, 8u, 64u}) {
        FlgCurveFileWriteDesc desc = desc_of(FLG_CURVE_GEOMETRY_TUBE, sides);
        desc.default_radius = 0.5f;
        const Surface tube = swept(curves, desc);
        const double base = sides / 2.0 * 0.25 * std::sin(2 * std::numbers::pi / sides);
        EXPECT_NEAR(tube.volume(), 3 * base, 1e-5);
        EXPECT_NEAR(tube.area(), 2 * base + 3 * sides * std::sin(std::numbers::pi / sides), 1e-4);
        EXPECT_TRUE(tube.watertight());
        EXPECT_FALSE(tube.double_sided);
        EXPECT_FALSE(tube.colored);
    }
}

TEST(Surface, ConeHasSlantedNormalsAndNoCapAtItsTip) {
    Curves curves;
    curves.add({0, 0, 0, 0, 0, 1});
    curves.radii = {1, 0};
    curves.colors.assign(8, 1.0f);
    const Surface cone = swept(curves, desc_of(FLG_CURVE_GEOMETRY_TUBE, 64));
    EXPECT_NEAR(cone.volume(), std::numbers::pi / 3, 0.01);
    EXPECT_EQ(cone.positions.size(), 2u * 64 + 65);
    EXPECT_EQ(cone.normals[0].z, -1);  // the cap at its start, then the sides
    EXPECT_NEAR(cone.normals[65].z, std::sqrt(0.5), 1e-6);
    EXPECT_TRUE(cone.colored);
}

TEST(Surface, ClosedTubeIsATorus) {
    Curves curves;
    constexpr int steps = 256;
    for (int i = 0; i < steps; ++i) {
        const double angle = 2 * std::numbers::pi * i / steps;
        // Not planar, so that frames come back twisted.
        for (double value : {std::cos(angle), std::sin(angle), 0.3 * std::sin(2 * angle + 1)}) {
            curves.positions.push_back(static_cast<float>(value));
        }
    }
    curves.end(true);
    FlgCurveFileWriteDesc desc = desc_of(FLG_CURVE_GEOMETRY_TUBE, 32);
    desc.default_radius = 0.1f;
    const Surface torus = swept(curves, desc);
    EXPECT_TRUE(torus.watertight());
    EXPECT_EQ(torus.indices.size(), 3u * 2 * steps * 32);
    // Pappus: the area of the cross section times the length. An open ring of twist would shear it.
    double length = 0;
    for (size_t i = 0; i < steps; ++i) {
        const float* a = &curves.positions[3 * i];
        const float* b = &curves.positions[3 * ((i + 1) % steps)];
        length += std::hypot(double{a[0]} - b[0], double{a[1]} - b[1], double{a[2]} - b[2]);
    }
    EXPECT_NEAR(torus.volume(), length * 16 * 0.01 * std::sin(2 * std::numbers::pi / 32), 2e-3 * torus.volume());
    // The seam: opposite vertices of neighbouring rings stay as near as everywhere else.
    double longest = 0, seam = 0;
    for (size_t i = 0; i < steps; ++i) {
        const Point d = torus.positions[32 * i] - torus.positions[32 * ((i + 1) % steps)];
        (i + 1 == steps ? seam : longest) = std::max(i + 1 == steps ? seam : longest, std::sqrt(dot(d, d)));
    }
    EXPECT_LT(seam, longest * 1.2);
}

TEST(Surface, RibbonLiesAcrossTheNormal) {
    Curves curves;
    curves.add({0, 0, 0, 1, 0, 0, 3, 0, 0});
    curves.normals = {0, 0, 1, 0, 0, 1, 0, 0, 1};
    curves.radii = {0.5f, 0.5f, 0.5f};
    const Surface ribbon = swept(curves, desc_of(FLG_CURVE_GEOMETRY_RIBBON));
    EXPECT_TRUE(ribbon.double_sided);
    EXPECT_EQ(ribbon.positions.size(), 6u);
    EXPECT_NEAR(ribbon.area(), 3, 1e-6);
    for (const Point& p : ribbon.positions) EXPECT_NEAR(std::abs(p.y), 0.5, 1e-7);
    for (const Point& n : ribbon.normals) EXPECT_NEAR(n.z, 1, 1e-7);
}

// What flgCurveSetStylize makes of a straight target: loops in the plane of its normal, with the target's frame.
Curves loops_with_frames_of_a_line() {
    Curves curves;
    constexpr int count = 121;
    for (int i = 0; i < count; ++i) {
        const double t = 4 * std::numbers::pi * i / (count - 1);
        for (double value : {0.1 * t + std::sin(t), 1 - std::cos(t), 0.02 * t}) {
            curves.positions.push_back(static_cast<float>(value));
        }
        curves.tangents.insert(curves.tangents.end(), {1, 0, 0});
        curves.normals.insert(curves.normals.end(), {0, 1, 0});
        curves.radii.push_back(0.1f);
    }
    curves.end();
    return curves;
}

Point point_of(const Curves& curves, size_t i) {
    const float* p = &curves.positions[3 * i];
    return {p[0], p[1], p[2]};
}

// Vertex `side` of each cross section, the first of which begins at `first`, from its centre: across the curve, and
// never flung to the other side.
void expect_across(const Curves& curves, const Surface& surface, size_t sides, size_t first) {
    const size_t count = curves.positions.size() / 3;
    ASSERT_GE(surface.positions.size(), first + sides * count);
    for (size_t side = 0; side < sides; ++side) {
        for (size_t i = 1; i + 1 < count; ++i) {
            const Point arm = surface.positions[first + sides * i + side] - point_of(curves, i);
            const Point next = surface.positions[first + sides * (i + 1) + side] - point_of(curves, i + 1);
            const Point along = point_of(curves, i + 1) - point_of(curves, i - 1);
            EXPECT_NEAR(dot(arm, arm), 0.01, 1e-5) << i;
            EXPECT_NEAR(dot(arm, along) / std::sqrt(dot(arm, arm) * dot(along, along)), 0, 2e-3) << i;
            EXPECT_GT(dot(arm, next), 0.8 * 0.01) << i;
        }
    }
}

TEST(Surface, TubesStandAcrossTheCurveWhateverItsFrame) {
    Curves curves = loops_with_frames_of_a_line();
    expect_across(curves, swept(curves, desc_of(FLG_CURVE_GEOMETRY_TUBE, 8)), 8, 9);  // after the start's cap
}

TEST(Surface, RibbonsDoNotCrossOverWhereTheNormalPointsAlongTheCurve) {
    Curves curves = loops_with_frames_of_a_line();
    expect_across(curves, swept(curves, desc_of(FLG_CURVE_GEOMETRY_RIBBON)), 2, 0);
}

TEST(Surface, ResultsWithAllTheirColumnsCanBeWritten) {
    Curves curves;
    curves.add({0, 0, 0, 1, 0, 0});
    const std::vector<float> values(2 * 3, 0.5f);
    FlgCurveSetView view = curves.view();
    for (const auto& [attribute, components] : {std::pair(FLG_ATTRIBUTE_RADII, 3u),
                                                {FLG_ATTRIBUTE_ANGLE, 1u},
                                                {FLG_ATTRIBUTE_WIDTH, 1u},
                                                {FLG_ATTRIBUTE_SPEED, 1u},
                                                {FLG_ATTRIBUTE_DISPLACEMENT, 3u}}) {
        curves.columns.push_back({attribute, components, values.data(), 0, 0});
    }
    view.columns = curves.columns.data();
    view.column_count = static_cast<uint32_t>(curves.columns.size());
    const Folder folder;
    EXPECT_EQ(flgCurveFileWrite(folder.at("a.glb").c_str(), &view, nullptr), FLG_OK) << flgIoErrorGetMessage();
}

TEST(Surface, FramesSurviveCornersAndTurnsBack) {
    Curves curves;
    curves.add({0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 1});
    const Surface tube = swept(curves, desc_of(FLG_CURVE_GEOMETRY_TUBE), false);
    EXPECT_TRUE(tube.watertight());
    for (const Point& p : tube.positions) EXPECT_TRUE(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z));
}

TEST(Surface, CurvesWithoutLengthAreLeftOut) {
    Curves curves;
    curves.add({1, 1, 1});
    curves.add({2, 2, 2, 2, 2, 2}, true);
    const Folder folder;
    const FlgCurveFileWriteDesc desc = desc_of(FLG_CURVE_GEOMETRY_TUBE);
    EXPECT_EQ(write(folder.at("a.glb"), curves, &desc), FLG_ERROR_INVALID_ARGUMENT);
    EXPECT_NE(std::string(flgIoErrorGetMessage()).find("no curve with a length"), std::string::npos);
    EXPECT_EQ(folder.entries(), 0u);
    curves.add({0, 0, 0, 1, 0, 0});
    EXPECT_EQ(swept(curves, desc).positions.size(), 2u * 8 + 2 * 9);
}

// A coil of `turns`, 1 m across, 200 points a turn.
Curves coil(int turns, float thickest) {
    Curves curves;
    for (int i = 0; i <= 200 * turns; ++i) {
        const double angle = 2 * std::numbers::pi * i / 200;
        for (double value : {0.5 * std::cos(angle), 0.5 * std::sin(angle), 0.1 * angle})
            curves.positions.push_back(static_cast<float>(value));
        curves.radii.push_back(thickest * (0.6f + 0.4f * static_cast<float>(std::cos(0.1 * angle))));
    }
    curves.end();
    return curves;
}

double distance_to_segment(const Point& p, const Point& a, const Point& b) {
    const Point ab = b - a, ap = p - a;
    const double t = std::clamp(dot(ap, ab) / dot(ab, ab), 0.0, 1.0);
    const Point off = {ap.x - t * ab.x, ap.y - t * ab.y, ap.z - t * ab.z};
    return std::sqrt(dot(off, off));
}

TEST(Surface, ToleranceLeavesOutWhatIsNotNeeded) {
    // A straight tube needs its ends alone, and sides by the closed form: half of the tolerance is r (1 - cos(pi /
    // sides)).
    Curves straight;
    for (int i = 0; i <= 100; ++i) {
        straight.positions.insert(straight.positions.end(), {0.01f * static_cast<float>(i), 0, 0});
        straight.radii.push_back(0.1f);
    }
    straight.end();
    FlgCurveFileWriteDesc desc = desc_of(FLG_CURVE_GEOMETRY_TUBE, 64);
    for (const double tolerance : {1e-4, 1e-3, 1e-2, 0.5}) {
        desc.tolerance = static_cast<float>(tolerance);
        const size_t fewest =
            tolerance > 0.2
                ? 3
                : std::min<size_t>(64,
                                   static_cast<size_t>(std::ceil(std::numbers::pi / std::acos(1 - tolerance / 0.2))));
        const Surface tube = swept(straight, desc, false);
        EXPECT_EQ(tube.positions.size(), 2 * fewest + 2 * (fewest + 1)) << tolerance;
        EXPECT_TRUE(tube.watertight());
    }
    // A coil keeps as many as its bends ask for: less as more is tolerated, and never farther off than that.
    Curves curves = coil(5, 0.02f);
    size_t before = 1001 * 2 + 1;
    for (const float tolerance : {0.0f, 1e-3f, 4e-3f, 1.6e-2f}) {
        desc = desc_of(FLG_CURVE_GEOMETRY_RIBBON);
        desc.tolerance = tolerance;
        const Surface ribbon = swept(curves, desc, false);
        EXPECT_LT(ribbon.positions.size(), before) << tolerance;
        before = ribbon.positions.size();
        std::vector<Point> middles;
        for (size_t i = 0; i + 1 < ribbon.positions.size(); i += 2) {
            const Point &a = ribbon.positions[i], &b = ribbon.positions[i + 1];
            middles.push_back({(a.x + b.x) / 2, (a.y + b.y) / 2, (a.z + b.z) / 2});
        }
        size_t span = 0;
        for (size_t i = 0; i < curves.radii.size(); ++i) {
            const Point p = point_of(curves, i);
            double nearest = 1;
            for (size_t k = span; k + 1 < std::min(span + 3, middles.size()); ++k) {
                const double d = distance_to_segment(p, middles[k], middles[k + 1]);
                if (d < nearest) nearest = d;
            }
            while (span + 2 < middles.size() && middles[span + 1].z <= p.z) ++span;
            EXPECT_LE(nearest, double{tolerance} + 1e-6) << i;
        }
    }
    EXPECT_LT(before, 400u);
    // Closed ones stay closed.
    Curves ring = coil(1, 0.02f);
    ring.flags.back() = FLG_CURVE_CLOSED;
    desc = desc_of(FLG_CURVE_GEOMETRY_TUBE);
    desc.tolerance = 0.01f;
    EXPECT_TRUE(swept(ring, desc, false).watertight());
}

TEST(Surface, ManyCurvesComeInPiecesThat16BitsNumber) {
    Curves curves;
    for (int c = 0; c < 20; ++c) {
        const Curves one = coil(5, 0.02f);
        curves.positions.insert(curves.positions.end(), one.positions.begin(), one.positions.end());
        curves.radii.insert(curves.radii.end(), one.radii.begin(), one.radii.end());
        curves.end();
    }
    const Surface tubes = swept(curves, desc_of(FLG_CURVE_GEOMETRY_TUBE, 8));
    EXPECT_EQ(tubes.primitives, 3u);  // 20 x 8026 vertices
    EXPECT_EQ(tubes.indices.size(), 20u * (1000 * 8 * 2 + 2 * 8) * 3);
    EXPECT_TRUE(tubes.watertight());
    // One curve that alone has more takes 32 bits.
    Curves longest = coil(50, 0.02f);
    EXPECT_EQ(swept(longest, desc_of(FLG_CURVE_GEOMETRY_TUBE, 8)).primitives, 1u);
}

TEST(Surface, CurvesHaveEachTheirOwnGeometry) {
    Curves curves;
    for (const float y : {0.0f, 1.0f, 2.0f}) curves.add({0, y, 0, 1, y, 0});
    const uint8_t geometries[] = {FLG_CURVE_GEOMETRY_TUBE, FLG_CURVE_GEOMETRY_RIBBON, FLG_CURVE_GEOMETRY_TUBE};
    FlgCurveFileWriteDesc desc = desc_of(FLG_CURVE_GEOMETRY_LINES);
    desc.geometries = geometries;
    const Surface both = swept(curves, desc);
    EXPECT_EQ(both.primitives, 2u);
    EXPECT_EQ(both.positions.size(), 2u * (2 * 8 + 2 * 9) + 4);
    EXPECT_TRUE(both.double_sided);  // the ribbon, which comes second
    const uint8_t wrong[] = {FLG_CURVE_GEOMETRY_TUBE, FLG_CURVE_GEOMETRY_LINES, FLG_CURVE_GEOMETRY_TUBE};
    desc.geometries = wrong;
    const Folder folder;
    EXPECT_EQ(write(folder.at("a.glb"), curves, &desc), FLG_ERROR_INVALID_ARGUMENT);
    EXPECT_NE(std::string(flgIoErrorGetMessage()).find("desc.geometries[1]: is 0"), std::string::npos)
        << flgIoErrorGetMessage();
}

// Of a mesh file, in the order of its triangles' corners.
std::vector<Point> corners_of(const std::string& path) {
    FlgMeshFile file = nullptr;
    std::vector<Point> corners;
    EXPECT_EQ(flgMeshFileRead(path.c_str(), nullptr, &file), FLG_OK) << flgIoErrorGetMessage();
    if (file == nullptr) return corners;
    FlgMeshView view = {};
    view.struct_size = sizeof view;
    EXPECT_EQ(flgMeshFileGetView(file, &view), FLG_OK);
    for (size_t i = 0; i < 3 * size_t{view.triangle_count}; ++i) {
        const float* p = view.columns[0].data + 3 * size_t{view.triangles[i]};
        corners.push_back({p[0], p[1], p[2]});
    }
    flgMeshFileRelease(file);
    return corners;
}

TEST(Surface, QuantizedPositionsAreReadBackWithinAStep) {
    const Folder folder;
    Curves curves = coil(5, 0.02f);
    curves.colors.assign(4 * curves.radii.size(), 0.25f);
    for (const FlgCurveGeometry geometry : {FLG_CURVE_GEOMETRY_RIBBON, FLG_CURVE_GEOMETRY_TUBE}) {
        FlgCurveFileWriteDesc desc = desc_of(geometry);
        ASSERT_EQ(write(folder.at("exact.glb"), curves, &desc), FLG_OK);
        desc.quantize = 1;
        ASSERT_EQ(write(folder.at("small.glb"), curves, &desc), FLG_OK);
        const std::vector<Point> exact = corners_of(folder.at("exact.glb")), small = corners_of(folder.at("small.glb"));
        ASSERT_EQ(exact.size(), small.size());
        const double step = (0.1 * 10 * std::numbers::pi + 0.05) / 65535;  // of the coil's height
        for (size_t i = 0; i < exact.size(); ++i) {
            const Point off = exact[i] - small[i];
            EXPECT_LE(std::max({std::abs(off.x), std::abs(off.y), std::abs(off.z)}), step) << i;
        }
        EXPECT_LT(static_cast<double>(slurp(folder.at("small.glb")).size()),
                  0.66 * static_cast<double>(slurp(folder.at("exact.glb")).size()));
        // Where steps would be too coarse, floats stay.
        desc.tolerance = 1e-6f;
        ASSERT_EQ(write(folder.at("fine.glb"), curves, &desc), FLG_OK);
        EXPECT_EQ(slurp(folder.at("fine.glb")).find("\"scale\""), std::string::npos);
    }
}

TEST(Surface, LinesAreReadByOthers) {
    const Folder folder;
    Curves curves;
    curves.add({0, 0, 0, 0.1f, 0.2f, 0.3f});
    curves.add({0, 0, 0, 1, 0, 0, 0, 1, 0}, true);
    curves.add({4, 5, 6});
    ASSERT_EQ(write(folder.at("a.glb"), curves), FLG_OK);
    tinygltf::Model model;
    std::string error, warning;
    ASSERT_TRUE(tinygltf::TinyGLTF().LoadBinaryFromFile(&model, &error, &warning, folder.at("a.glb"))) << error;
    const auto& primitives = model.meshes.at(0).primitives;
    ASSERT_EQ(primitives.size(), 3u);
    EXPECT_EQ(primitives[0].mode, TINYGLTF_MODE_LINE_STRIP);
    EXPECT_EQ(primitives[1].mode, TINYGLTF_MODE_LINE_LOOP);
    const int accessor = primitives[0].attributes.at("POSITION");
    EXPECT_EQ(model.accessors[static_cast<size_t>(accessor)].maxValues,
              (std::vector<double>{double{0.1f}, double{0.2f}, double{0.3f}}));
    EXPECT_GE(primitives[2].indices, 0);
}

}  // namespace
}  // namespace flg::test
