// SPDX-License-Identifier: MIT
// Maps of a unit square that an isoline cuts, against closed forms.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "filigree/filigree_bake.h"

namespace flg::test {
namespace {

struct Square {
    std::vector<float> positions;
    std::vector<uint32_t> triangles;
    std::vector<float> uvs;
    FlgContext context = {};
    FlgSurface surface = {};
    FlgTangle tangle = {};
    FlgColumn column = {};
    FlgMeshView mesh = flgMeshViewDefaults();
    uint32_t budget_us = FLG_UNLIMITED;

    void run(FlgJob job) {
        FlgJobStatus status = flgJobStatusDefaults();
        do {
            flgContextTick(context, budget_us, nullptr);
            flgJobGetStatus(context, job, &status);
        } while (status.result == FLG_NOT_READY);
        last = status.result;
        if (last != FLG_OK) error = status.error;
    }
    FlgResult last = FLG_OK;
    std::string error;

    // Of cells x cells squares. The edge x = 0 is a line; the contour lies at `delta` from it.
    explicit Square(float delta, uint32_t cells = 1, uint32_t workers = 0) {
        FlgContextDesc desc = flgContextDefaults();
        desc.worker_count = workers;
        EXPECT_EQ(flgContextCreate(&desc, &context), FLG_OK);
        const auto at = [&](uint32_t i) { return static_cast<float>(i) / static_cast<float>(cells); };
        for (uint32_t j = 0; j <= cells; ++j)
            for (uint32_t i = 0; i <= cells; ++i) positions.insert(positions.end(), {at(i), at(j), 0});
        for (uint32_t j = 0; j < cells; ++j) {
            for (uint32_t i = 0; i < cells; ++i) {
                const uint32_t a = j * (cells + 1) + i, b = a + cells + 1;
                triangles.insert(triangles.end(), {a, a + 1, b + 1, a, b + 1, b});
            }
        }
        for (const uint32_t v : triangles) uvs.insert(uvs.end(), {positions[3 * v], positions[3 * v + 1]});
        column = {FLG_ATTRIBUTE_POSITION, 3, positions.data(), 0, 0};
        mesh.vertex_count = (cells + 1) * (cells + 1);
        mesh.triangle_count = 2 * cells * cells;
        mesh.column_count = 1;
        mesh.columns = &column;
        mesh.triangles = triangles.data();
        FlgSurfaceDesc made = flgSurfaceDefaults();
        made.mesh = &mesh;
        made.provenance = 1;
        FlgJob job = {};
        EXPECT_EQ(flgSurfaceCreate(context, &made, &surface, &job), FLG_OK);
        run(job);
        EXPECT_EQ(flgTangleCreate(context, surface, nullptr, &tangle, &job), FLG_OK);
        run(job);
        FlgTangleSeeds seeds = flgTangleSeedsDefaults();
        const FlgBorderStretch stretch = {0, 0.75f, 1.0f};
        seeds.stretches = &stretch;
        seeds.stretch_count = 1;
        FlgTangleDivideDesc divide = flgTangleDivideDefaults();
        const uint32_t root = 0;
        divide.tangle = tangle;
        divide.regions = &root;
        divide.region_count = 1;
        divide.a = &seeds;
        divide.delta = delta;
        EXPECT_EQ(flgTangleDivide(context, &divide, &job), FLG_OK) << flgErrorGetMessage();
        run(job);
        EXPECT_EQ(last, FLG_OK) << error;
    }
    ~Square() { flgContextDestroy(context); }
};

TEST(Baking, ASquareThatALineDividesIsDrawnToTheTexel) {
    constexpr uint32_t size = 64;
    constexpr float line = 0.3f;
    Square square(line);
    std::vector<uint32_t> ids(size * size);
    std::vector<float> distances(size * size);
    std::vector<uint8_t> borders(size * size);
    FlgTangleBakeDesc desc = flgTangleBakeDefaults();
    desc.size = size;
    desc.tangle = square.tangle;
    desc.mesh = &square.mesh;
    desc.corner_uvs = square.uvs.data();
    desc.border_width = 0.1f;
    desc.ids = ids.data();
    desc.distances = distances.data();
    desc.borders = borders.data();
    FlgJob job = {};
    ASSERT_EQ(flgTangleBake(square.context, &desc, &job), FLG_OK) << flgErrorGetMessage();
    square.run(job);
    ASSERT_EQ(square.last, FLG_OK) << square.error;
    double covered = 0;
    for (uint32_t y = 0; y < size; ++y) {
        for (uint32_t x = 0; x < size; ++x) {
            const float middle = (static_cast<float>(x) + 0.5f) / size;
            const uint32_t texel = y * size + x;
            EXPECT_EQ(ids[texel], middle < line ? ids[0] : ids[size - 1]) << x << ' ' << y;
            EXPECT_NEAR(distances[texel], std::abs(middle - line), 1e-5f) << x << ' ' << y;
            covered += borders[texel] / 255.0;
        }
    }
    EXPECT_NE(ids[0], ids[size - 1]);
    EXPECT_NEAR(covered / (size * size), 0.1 * 1.0, 1e-3);
}

// What a texel's middle shows on the cut mesh: the label, and the height there.
struct Seen {
    uint32_t label;
    float height;
};

std::vector<Seen> look_at(const Square& square, uint32_t size) {
    FlgSurfaceView view = {};
    view.struct_size = sizeof view;
    EXPECT_EQ(flgSurfaceGetView(square.context, square.surface, &view), FLG_OK);
    const auto* const places = static_cast<const float*>(view.mesh->columns[0].data);
    std::vector<Seen> seen(size_t{size} * size, {FLG_NO_INDEX, 0});
    for (uint32_t t = 0; t < view.mesh->triangle_count; ++t) {
        const uint32_t* const v = view.mesh->triangles + 3 * size_t{t};
        const float *a = places + 3 * v[0], *b = places + 3 * v[1], *c = places + 3 * v[2];
        const double area = double{b[0] - a[0]} * (c[1] - a[1]) - double{c[0] - a[0]} * (b[1] - a[1]);
        if (area == 0) continue;
        for (uint32_t y = 0; y < size; ++y) {
            for (uint32_t x = 0; x < size; ++x) {
                const double px = (x + 0.5) / size - a[0], py = (y + 0.5) / size - a[1];
                const double s = (px * (c[1] - a[1]) - (c[0] - a[0]) * py) / area;
                const double r = ((b[0] - a[0]) * py - px * (b[1] - a[1])) / area;
                if (s < 0 || r < 0 || s + r > 1) continue;
                const double height = a[2] + s * (b[2] - a[2]) + r * (c[2] - a[2]);
                seen[size_t{y} * size + x] = {view.mesh->regions[t], static_cast<float>(height)};
            }
        }
    }
    return seen;
}

struct Maps {
    explicit Maps(uint32_t map_size)
        : size(map_size), ids(size * size), distances(size * size), heights(size * size), normals(3 * size * size) {}

    void bake(Square& square, uint32_t padding = 0) {
        FlgTangleBakeDesc desc = flgTangleBakeDefaults();
        desc.size = size;
        desc.padding = padding;
        desc.tangle = square.tangle;
        desc.mesh = &square.mesh;
        desc.corner_uvs = square.uvs.data();
        desc.ids = ids.data();
        desc.distances = distances.data();
        desc.heights = heights.data();
        desc.normals = normals.data();
        FlgJob job = {};
        square.last = flgTangleBake(square.context, &desc, &job);
        square.error = flgErrorGetMessage();
        if (square.last == FLG_OK) square.run(job);
    }

    uint32_t size;
    std::vector<uint32_t> ids;
    std::vector<float> distances, heights, normals;
};

void displace(Square& square, float amount) {
    const uint32_t root = 0;
    FlgTangleDisplaceDesc desc = flgTangleDisplaceDefaults();
    desc.tangle = square.tangle;
    desc.regions = &root;
    desc.region_count = 1;
    desc.amount = amount;
    FlgJob job = {};
    ASSERT_EQ(flgTangleDisplace(square.context, &desc, &job), FLG_OK) << flgErrorGetMessage();
    square.run(job);
    ASSERT_EQ(square.last, FLG_OK) << square.error;
}

// The edges between two regions of the cut mesh, each with both ends.
std::vector<std::array<float, 4>> border_edges(const Square& square) {
    FlgSurfaceView view = {};
    view.struct_size = sizeof view;
    EXPECT_EQ(flgSurfaceGetView(square.context, square.surface, &view), FLG_OK);
    const auto* const places = static_cast<const float*>(view.mesh->columns[0].data);
    std::map<std::pair<uint32_t, uint32_t>, uint32_t> region_of_edge;
    std::vector<std::array<float, 4>> edges;
    for (uint32_t t = 0; t < view.mesh->triangle_count; ++t) {
        for (uint32_t k = 0; k < 3; ++k) {
            const uint32_t a = view.mesh->triangles[3 * t + k], b = view.mesh->triangles[3 * t + (k + 1) % 3];
            region_of_edge[{a, b}] = view.mesh->regions[t];
            const auto other = region_of_edge.find({b, a});
            if (other == region_of_edge.end() || other->second == view.mesh->regions[t]) continue;
            edges.push_back({places[3 * a], places[3 * a + 1], places[3 * b], places[3 * b + 1]});
        }
    }
    return edges;
}

TEST(Baking, DistancesAreThoseToTheNearestEdgeBetweenRegions) {
    for (const uint32_t cells : {7u, 40u, 90u}) {
        Square square(0.3f, cells);
        Maps maps(64);
        maps.bake(square);
        ASSERT_EQ(square.last, FLG_OK) << square.error;
        const auto edges = border_edges(square);
        EXPECT_GE(edges.size(), cells);
        for (uint32_t i = 0; i < 64 * 64; ++i) {
            const double x = (i % 64 + 0.5) / 64, y = (i / 64 + 0.5) / 64;
            double least = INFINITY;
            for (const auto& [ax, ay, bx, by] : edges) {
                const double dx = double{bx} - double{ax}, dy = double{by} - double{ay};
                const double share = ((x - double{ax}) * dx + (y - double{ay}) * dy) / (dx * dx + dy * dy);
                const double at = std::clamp(share, 0.0, 1.0);
                least = std::min(least, std::hypot(x - double{ax} - at * dx, y - double{ay} - at * dy));
            }
            EXPECT_GE(double{maps.distances[i]}, least - 1e-6) << cells << ' ' << i;
            EXPECT_LE(double{maps.distances[i]}, least + 1e-5) << cells << ' ' << i;
        }
    }
}

TEST(Baking, IdsAndHeightsAreThoseOfTheCutMesh) {
    Square square(0.3f, 24);
    displace(square, 0.05f);
    Maps maps(96);
    maps.bake(square);
    ASSERT_EQ(square.last, FLG_OK) << square.error;
    const std::vector<Seen> seen = look_at(square, maps.size);
    float highest = 0;
    for (size_t i = 0; i < seen.size(); ++i) {
        ASSERT_NE(seen[i].label, FLG_NO_INDEX);
        if (maps.distances[i] > 1e-4f) {
            EXPECT_EQ(maps.ids[i], seen[i].label) << i;
        }
        EXPECT_NEAR(maps.heights[i], seen[i].height, 1e-5f) << i;
        highest = std::max(highest, maps.heights[i]);
    }
    EXPECT_GT(highest, 0.01f);
}

// The field's slope, by differences of heights over two cells, where the ground is smooth.
TEST(Baking, NormalsLeanAgainstTheRiseOfHeights) {
    Square square(0.3f, 48);
    displace(square, 0.05f);
    constexpr uint32_t size = 96;
    Maps maps(size);
    maps.bake(square);
    ASSERT_EQ(square.last, FLG_OK) << square.error;
    double off = 0, lean = 0;
    uint32_t count = 0;
    for (uint32_t y = 4; y + 4 < size; ++y) {
        for (uint32_t x = 4; x + 4 < size; ++x) {
            const size_t i = size_t{y} * size + x;
            const float* const n = &maps.normals[3 * i];
            EXPECT_NEAR(n[0] * n[0] + n[1] * n[1] + n[2] * n[2], 1, 1e-5f);
            EXPECT_GT(n[2], 0);
            const double rise_x = double{maps.heights[i + 4] - maps.heights[i - 4]} * size / 8;
            const double rise_y = double{maps.heights[i + 4 * size] - maps.heights[i - 4 * size]} * size / 8;
            off += std::hypot(-n[0] / n[2] - rise_x, n[1] / n[2] - rise_y);
            lean += std::hypot(rise_x, rise_y);
            ++count;
        }
    }
    EXPECT_GT(lean / count, 0.01);
    EXPECT_LT(off, 0.15 * lean);
}

TEST(Baking, AnUndisplacedSquareIsFlat) {
    Square square(0.3f, 4);
    Maps maps(32);
    maps.bake(square);
    ASSERT_EQ(square.last, FLG_OK) << square.error;
    for (size_t i = 0; i < maps.heights.size(); ++i) {
        EXPECT_EQ(maps.heights[i], 0);
        EXPECT_EQ(maps.normals[3 * i], 0);
        EXPECT_EQ(maps.normals[3 * i + 1], 0);
        EXPECT_EQ(maps.normals[3 * i + 2], 1);
    }
}

TEST(Baking, PaddingCopiesTheNearestTexelAndMipsMeetNoBackground) {
    Square square(0.3f);
    for (float& value : square.uvs) value = 0.25f + 0.5f * value;
    constexpr int size = 64, padding = 8, first = 16, last = 47;
    Maps maps(size);
    maps.bake(square, padding);
    ASSERT_EQ(square.last, FLG_OK) << square.error;
    for (int y = 0; y < size; ++y) {
        for (int x = 0; x < size; ++x) {
            const int near_x = std::clamp(x, first, last), near_y = std::clamp(y, first, last);
            const int off_sq = (x - near_x) * (x - near_x) + (y - near_y) * (y - near_y);
            const auto i = static_cast<size_t>(y * size + x), from = static_cast<size_t>(near_y * size + near_x);
            if (off_sq <= padding * padding) {
                EXPECT_EQ(maps.ids[i], maps.ids[from]) << x << ' ' << y;
                EXPECT_EQ(maps.distances[i], maps.distances[from]) << x << ' ' << y;
            } else {
                EXPECT_EQ(maps.ids[i], FLG_NO_INDEX) << x << ' ' << y;
            }
        }
    }
    // Charts that end anywhere: a texel of level 2 that is of the chart at all, is of nothing else.
    for (float& value : square.uvs) value += 0.7f / size;
    maps.bake(square, padding);
    ASSERT_EQ(square.last, FLG_OK) << square.error;
    constexpr int block = 4;
    for (int y = 0; y < size; y += block) {
        for (int x = 0; x < size; x += block) {
            const bool is_of_chart = x + block > first + 1 && x <= last + 1 && y + block > first + 1 && y <= last + 1;
            for (int k = 0; is_of_chart && k < block * block; ++k) {
                EXPECT_NE(maps.ids[static_cast<size_t>((y + k / block) * size + x + k % block)], FLG_NO_INDEX);
            }
        }
    }
}

TEST(Baking, SameBitsWithAnyWorkersAndBudget) {
    constexpr uint32_t size = 300;
    Square square(0.3f, 40);
    displace(square, 0.05f);
    Maps expected(size);
    expected.bake(square, 4);
    ASSERT_EQ(square.last, FLG_OK) << square.error;
    for (const uint32_t workers : {0u, 1u, 3u}) {
        Square other(0.3f, 40, workers);
        displace(other, 0.05f);
        other.budget_us = 50;
        Maps maps(size);
        maps.bake(other, 4);
        ASSERT_EQ(other.last, FLG_OK) << other.error;
        EXPECT_TRUE(maps.ids == expected.ids);
        EXPECT_TRUE(maps.distances == expected.distances);
        EXPECT_TRUE(maps.heights == expected.heights);
        EXPECT_TRUE(maps.normals == expected.normals);
    }
}

TEST(Baking, CoordinatesThatAreNotUsableAreRefusedWithTheirPlace) {
    Square square(0.3f);
    const std::vector<float> good = square.uvs;
    Maps maps(64);
    const auto expect_refused = [&](size_t i, float value, const char* place, const char* why) {
        square.uvs = good;
        square.uvs[i] = value;
        maps.bake(square);
        EXPECT_EQ(square.last, FLG_ERROR_INVALID_ARGUMENT);
        EXPECT_NE(square.error.find(place), std::string::npos) << square.error;
        EXPECT_NE(square.error.find(why), std::string::npos) << square.error;
    };
    expect_refused(9, NAN, "corner_uvs[9]", "no number");
    expect_refused(4, INFINITY, "corner_uvs[4]", "no number");
    expect_refused(2, 1.5f, "corner_uvs[2] is 1.5", "outside 0 to 1");
    expect_refused(0, -0.25f, "corner_uvs[0] is -0.25", "outside 0 to 1");
    square.uvs.assign(good.size(), 0.5f);
    maps.bake(square);
    EXPECT_EQ(square.last, FLG_ERROR_INVALID_ARGUMENT);
    EXPECT_NE(square.error.find("unwrap it"), std::string::npos) << square.error;
}

TEST(Baking, SizesOutOfRangeAreRefused) {
    Square square(0.3f);
    uint32_t id = 0;
    FlgTangleBakeDesc desc = flgTangleBakeDefaults();
    desc.tangle = square.tangle;
    desc.mesh = &square.mesh;
    desc.corner_uvs = square.uvs.data();
    desc.ids = &id;
    for (const uint32_t size : {0u, FLG_BAKE_MAX_SIZE + 1, UINT32_MAX}) {
        desc.size = size;
        EXPECT_EQ(flgTangleBake(square.context, &desc, nullptr), FLG_ERROR_INVALID_ARGUMENT);
        EXPECT_NE(std::string(flgErrorGetMessage()).find("desc.size"), std::string::npos);
    }
    desc.size = 1;
    FlgJob job = {};
    ASSERT_EQ(flgTangleBake(square.context, &desc, &job), FLG_OK) << flgErrorGetMessage();
    square.run(job);
    EXPECT_EQ(square.last, FLG_OK) << square.error;
    EXPECT_NE(id, FLG_NO_INDEX);
}

TEST(Baking, OverlapsAreRefusedWithBothTriangles) {
    Square square(0.3f);
    square.uvs = {0, 0, 1, 0, 1, 1, 0, 0, 1, 0, 1, 1};
    std::vector<uint32_t> ids(64 * 64);
    FlgTangleBakeDesc desc = flgTangleBakeDefaults();
    desc.size = 64;
    desc.tangle = square.tangle;
    desc.mesh = &square.mesh;
    desc.corner_uvs = square.uvs.data();
    desc.ids = ids.data();
    FlgJob job = {};
    ASSERT_EQ(flgTangleBake(square.context, &desc, &job), FLG_OK);
    square.run(job);
    EXPECT_EQ(square.last, FLG_ERROR_INVALID_ARGUMENT);
    EXPECT_NE(square.error.find("triangles 0 and 1 of the mesh overlap at "), std::string::npos) << square.error;
}

}  // namespace
}  // namespace flg::test
