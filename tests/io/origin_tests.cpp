// SPDX-License-Identifier: MIT
// Files of things far from their origin: what they hold to more digits than floats keeps its shape.
#include <cmath>
#include <cstring>

#include "io/files.h"
#include "io/gltf_files.h"

namespace flg::test {
namespace {

using Place = std::array<double, 3>;
constexpr Place home = {0, 0, 0}, far_away = {1e6, -2e6, 3e6};

// Not by the defaults function: this program has io alone.
// A mesh a metre wide of cells x cells squares, on a raster of 1/1024 m; its coordinates in the world.
struct Bumps {
    explicit Bumps(const Place& at, uint32_t cells = 16) {
        for (uint32_t j = 0; j <= cells; ++j) {
            for (uint32_t i = 0; i <= cells; ++i) {
                const double z = std::round(1024 * 0.1 * std::sin(7.0 * i / cells) * std::cos(5.0 * j / cells)) / 1024;
                vertices.insert(vertices.end(), {at[0] + double(i) / cells, at[1] + double(j) / cells, at[2] + z});
            }
        }
        for (uint32_t j = 0; j < cells; ++j) {
            for (uint32_t i = 0; i < cells; ++i) {
                const uint32_t a = j * (cells + 1) + i, b = a + cells + 1;
                triangles.insert(triangles.end(), {a, a + 1, b + 1, a, b + 1, b});
            }
        }
    }
    std::vector<double> vertices;
    std::vector<uint32_t> triangles;
};

std::string number(double value) {
    char text[40];
    std::snprintf(text, sizeof text, "%.17g", value);
    return text;
}

std::string obj_of(const Bumps& mesh) {
    std::string text;
    for (size_t i = 0; i < mesh.vertices.size(); ++i) text += (i % 3 == 0 ? "\nv " : " ") + number(mesh.vertices[i]);
    for (size_t i = 0; i < mesh.triangles.size(); ++i)
        text += (i % 3 == 0 ? "\nf " : " ") + std::to_string(mesh.triangles[i] + 1);
    return text + "\n";
}

std::string off_of(const Bumps& mesh) {
    std::string text =
        "OFF\n" + std::to_string(mesh.vertices.size() / 3) + " " + std::to_string(mesh.triangles.size() / 3) + " 0";
    for (size_t i = 0; i < mesh.vertices.size(); ++i) text += (i % 3 == 0 ? "\n" : " ") + number(mesh.vertices[i]);
    for (size_t i = 0; i < mesh.triangles.size(); ++i)
        text += (i % 3 == 0 ? "\n3 " : " ") + std::to_string(mesh.triangles[i]);
    return text + "\n";
}

template <class Number>
std::string ply_of(const Bumps& mesh, const char* type) {
    std::string text =
        "ply\nformat binary_little_endian 1.0\nelement vertex " + std::to_string(mesh.vertices.size() / 3) + "\n";
    for (const char* axis : {"x", "y", "z"}) text += std::string("property ") + type + " " + axis + "\n";
    text += "element face " + std::to_string(mesh.triangles.size() / 3) +
            "\nproperty list uchar int vertex_indices\nend_header\n";
    for (const double value : mesh.vertices) {
        const Number stored = static_cast<Number>(value);
        text.append(reinterpret_cast<const char*>(&stored), sizeof stored);
    }
    for (size_t i = 0; i < mesh.triangles.size(); i += 3) {
        text += '\3';
        text.append(reinterpret_cast<const char*>(&mesh.triangles[i]), 3 * sizeof(uint32_t));
    }
    return text;
}

// A mesh as it was read.
struct Loaded {
    Place origin{};
    std::vector<float> positions;
    std::vector<uint32_t> triangles;
    FlgMeshFileInfo info = flgMeshFileInfoDefaults();

    double world(size_t i) const { return origin[i % 3] + positions[i]; }
};

Loaded load(const std::string& path) {
    Loaded loaded;
    FlgMeshFile file = nullptr;
    EXPECT_EQ(flgMeshFileRead(path.c_str(), nullptr, &file), FLG_OK) << flgIoErrorGetMessage();
    FlgMeshView view = sized<FlgMeshView>();
    EXPECT_EQ(flgMeshFileGetView(file, &view), FLG_OK);
    std::copy(view.origin, view.origin + 3, loaded.origin.begin());
    const float* positions = view.columns[0].data;
    loaded.positions.assign(positions, positions + size_t{3} * view.vertex_count);
    loaded.triangles.assign(view.triangles, view.triangles + size_t{3} * view.triangle_count);
    EXPECT_EQ(flgMeshFileGetInfo(file, &loaded.info), FLG_OK);
    flgMeshFileRelease(file);
    return loaded;
}

void expect_holds(const Loaded& loaded, const Bumps& mesh) {
    ASSERT_EQ(loaded.positions.size(), mesh.vertices.size());
    for (size_t i = 0; i < mesh.vertices.size(); ++i) ASSERT_EQ(loaded.world(i), mesh.vertices[i]) << "number " << i;
    EXPECT_EQ(loaded.triangles, mesh.triangles);
}

TEST(FilesOfLargeWorlds, MeshesOfTextAndDoublesKeepTheirShape) {
    const Folder folder;
    const Bumps mesh(far_away);
    for (const std::string& path : {folder.put("a.obj", obj_of(mesh)), folder.put("a.off", off_of(mesh)),
                                    folder.put("a.ply", ply_of<double>(mesh, "double"))}) {
        const Loaded loaded = load(path);
        for (size_t k = 0; k < 3; ++k) {
            EXPECT_EQ(loaded.origin[k], std::round(loaded.origin[k])) << path;
            EXPECT_NEAR(loaded.origin[k], far_away[k], 2) << path;
            EXPECT_LT(std::abs(loaded.info.box_max[k]), 2) << path;
        }
        expect_holds(loaded, mesh);
    }
}

TEST(FilesOfLargeWorlds, MeshesNearTheirOriginNeedNone) {
    const Folder folder;
    for (const Place& at : {home, Place{100, 200, 300}}) {
        const Bumps mesh(at);
        for (const std::string& path : {folder.put("a.obj", obj_of(mesh)), folder.put("a.off", off_of(mesh)),
                                        folder.put("a.ply", ply_of<double>(mesh, "double"))}) {
            const Loaded loaded = load(path);
            EXPECT_EQ(loaded.origin, home) << path;
            expect_holds(loaded, mesh);
        }
    }
}

// What floats lost can't be had back: the mesh stays where it is, and surfaces refuse it.
TEST(FilesOfLargeWorlds, FloatsInFilesStayAsTheyAre) {
    const Folder folder;
    const Bumps mesh(far_away);
    const Loaded loaded = load(folder.put("a.ply", ply_of<float>(mesh, "float")));
    EXPECT_EQ(loaded.origin, home);
    for (size_t i = 0; i < mesh.vertices.size(); ++i)
        ASSERT_EQ(loaded.positions[i], static_cast<float>(mesh.vertices[i]));
}

// A view with an origin, of a mesh near it.
struct Placed {
    explicit Placed(const Place& at) : mesh(home) {
        for (const double value : mesh.vertices) positions.push_back(static_cast<float>(value));
        column = {FLG_ATTRIBUTE_POSITION, 3, positions.data(), 0, 0};
        view.vertex_count = static_cast<uint32_t>(positions.size() / 3);
        view.triangle_count = static_cast<uint32_t>(mesh.triangles.size() / 3);
        view.columns = &column;
        view.column_count = 1;
        view.triangles = mesh.triangles.data();
        std::copy(at.begin(), at.end(), view.origin);
    }
    Bumps mesh;
    std::vector<float> positions;
    FlgColumn column{};
    FlgMeshView view = sized<FlgMeshView>();
};

TEST(FilesOfLargeWorlds, WrittenMeshesAreWhereTheirOriginIs) {
    const Folder folder;
    const Placed mesh(far_away), here(home);
    for (const char* name : {"a.obj", "a.off", "a.ply", "a.glb"}) {
        const std::string path = folder.at(name), near = folder.at(std::string("near_") + name);
        ASSERT_EQ(flgMeshFileWrite(path.c_str(), &mesh.view, nullptr), FLG_OK) << flgIoErrorGetMessage();
        expect_holds(load(path), Bumps(far_away));
        ASSERT_EQ(flgMeshFileWrite(near.c_str(), &here.view, nullptr), FLG_OK) << flgIoErrorGetMessage();
        expect_holds(load(near), Bumps(home));
        EXPECT_EQ(load(near).origin, home);
    }
    EXPECT_EQ(load(folder.at("a.glb")).origin, far_away);
}

TEST(FilesOfLargeWorlds, WrittenCurvesAreWhereTheirOriginIs) {
    const Folder folder;
    const float points[] = {0, 0, 0, 0.125f, 0.25f, 0, 0.25f, 0.25f, 0.125f, 0.5f, 0.25f, 0.125f};
    const FlgColumn column = {FLG_ATTRIBUTE_POSITION, 3, points, 0, 0};
    const uint32_t offsets[] = {0, 4};
    FlgCurveSetView view = sized<FlgCurveSetView>();
    view.curve_count = 1;
    view.curve_offsets = offsets;
    view.columns = &column;
    view.column_count = 1;
    std::copy(far_away.begin(), far_away.end(), view.origin);
    for (const char* name : {"a.obj", "a.xyz", "a.glb"}) {
        const std::string path = folder.at(name);
        ASSERT_EQ(flgCurveFileWrite(path.c_str(), &view, nullptr), FLG_OK) << flgIoErrorGetMessage();
        FlgCurveFile file = nullptr;
        ASSERT_EQ(flgCurveFileRead(path.c_str(), nullptr, &file), FLG_OK) << flgIoErrorGetMessage();
        FlgCurveSetView back = sized<FlgCurveSetView>();
        ASSERT_EQ(flgCurveFileGetView(file, &back), FLG_OK);
        ASSERT_EQ(back.curve_offsets[1], 4u) << name;
        for (size_t i = 0; i < 12; ++i)
            EXPECT_EQ(back.origin[i % 3] + back.columns[0].data[i], far_away[i % 3] + points[i]) << name;
        flgCurveFileRelease(file);
    }
}

TEST(FilesOfLargeWorlds, OriginsMustBeFinite) {
    const Folder folder;
    Placed mesh({0, HUGE_VAL, 0});
    EXPECT_EQ(flgMeshFileWrite(folder.at("a.obj").c_str(), &mesh.view, nullptr), FLG_ERROR_INVALID_ARGUMENT);
    EXPECT_NE(std::strstr(flgIoErrorGetMessage(), "view.origin[1]"), nullptr) << flgIoErrorGetMessage();
    EXPECT_EQ(folder.entries(), 0u);
}

}  // namespace
}  // namespace flg::test
