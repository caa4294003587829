// SPDX-License-Identifier: MIT
// Files of every kind, written and read again.
#ifdef FLG_WITH_IO
#include <filesystem>
#include <fstream>
#include <numeric>

#include "filigree/filigree_io.h"
#include "hardening/folder.h"
#include "hardening/scenarios.h"
#include "io/tilt_files.h"

namespace flg::test {

namespace {

// Gives a file's memory back, however the scenario ends.
template <class File>
class Owned {
public:
    Owned(Calls& calls, void (*release)(File), const char* name) : calls_(calls), release_(release), name_(name) {}
    ~Owned() { calls_.value(name_, release_, file); }
    Owned(const Owned&) = delete;
    Owned& operator=(const Owned&) = delete;

    File file = nullptr;

private:
    Calls& calls_;
    void (*const release_)(File);
    const char* const name_;
};

template <class Info, class File>
Info info_of(Calls& calls, const char* name, FlgResult (*get)(File, Info*), File file, Info info) {
    calls.call(name, get, file, &info);
    return info;
}

}  // namespace

// Formats without JSON.
void keep_plain_files(Calls& calls) {
    const Folder folder;
    Curves curves = arcs(2, 9);
    MeshArrays mesh = cube(2);
    const FlgCurveSetView given = curves.view();
    const FlgMeshView shape = mesh.view();
    for (const char* name : {"curves.xyz", "curves.obj"}) {
        const std::string path = folder.at(name);
        FLG_CALL(calls, flgCurveFileWrite, path.c_str(), &given, nullptr);
        Owned<FlgCurveFile> read(calls, flgCurveFileRelease, "flgCurveFileRelease");
        FLG_CALL(calls, flgCurveFileRead, path.c_str(), nullptr, &read.file);
        FlgCurveSetView view = flgCurveSetViewDefaults();
        FLG_CALL(calls, flgCurveFileGetView, read.file, &view);
        calls.bits += bits(view);
    }
    for (const char* name : {"mesh.ply", "mesh.off", "mesh.obj"}) {
        const std::string path = folder.at(name);
        FLG_CALL(calls, flgMeshFileWrite, path.c_str(), &shape, nullptr);
        Owned<FlgMeshFile> read(calls, flgMeshFileRelease, "flgMeshFileRelease");
        FLG_CALL(calls, flgMeshFileRead, path.c_str(), nullptr, &read.file);
        FlgMeshView view = flgMeshViewDefaults();
        FLG_CALL(calls, flgMeshFileGetView, read.file, &view);
        calls.note(view.triangles, size_t{3} * view.triangle_count * sizeof(uint32_t));
    }
}

void keep_curve_files(Calls& calls) {
    EXPECT_NE(FLG_VALUE(calls, flgIoErrorGetMessage), nullptr);
    const Folder folder;
    const std::string path = folder.at("curves.glb");
    Curves curves = arcs(2, 9);
    const FlgCurveSetView given = curves.view();
    const FlgFileHooks hooks = FLG_INIT(calls, flgFileHooksInit);
    EXPECT_EQ(FLG_INIT(calls, flgFileSystemInit).open, nullptr);
    FlgCurveFileWriteDesc desc = FLG_INIT(calls, flgCurveFileWriteDescInit);
    desc.hooks = &hooks;
    FlgCurveFileReadDesc read_desc = FLG_INIT(calls, flgCurveFileReadDescInit);
    read_desc.hooks = &hooks;
    FLG_CALL(calls, flgCurveFileWrite, path.c_str(), &given, &desc);
    Owned<FlgCurveFile> read(calls, flgCurveFileRelease, "flgCurveFileRelease");
    FLG_CALL(calls, flgCurveFileRead, path.c_str(), &read_desc, &read.file);
    FlgCurveSetView view = flgCurveSetViewDefaults();
    FLG_CALL(calls, flgCurveFileGetView, read.file, &view);
    calls.bits += bits(view);
    const FlgCurveFileInfo info =
        info_of(calls, "flgCurveFileGetInfo", flgCurveFileGetInfo, read.file, FLG_INIT(calls, flgCurveFileInfoInit));
    EXPECT_EQ(info.curve_count, 2u);
    EXPECT_EQ(info.stroke_count, 0u);

    TiltStroke drawn;
    drawn.points.resize(3);
    drawn.points[1].position[0] = drawn.points[2].position[1] = 1;
    std::filesystem::create_directory(folder.at("a.tilt"));
    std::ofstream(folder.at("a.tilt/metadata.json")) << tilt_metadata;
    std::ofstream(folder.at("a.tilt/data.sketch"), std::ios::binary) << tilt_sketch({drawn});
    Owned<FlgCurveFile> sketch(calls, flgCurveFileRelease, "flgCurveFileRelease");
    FLG_CALL(calls, flgCurveFileRead, folder.at("a.tilt").c_str(), &read_desc, &sketch.file);
    FlgStroke stroke = FLG_INIT(calls, flgStrokeInit);
    FLG_CALL(calls, flgCurveFileGetStroke, sketch.file, 0u, &stroke);
    EXPECT_NE(stroke.brush[0], '\0');
}

namespace {

// A mesh into the file that it is of, with one material for all.
void write_into_asset(Calls& calls, const std::string& asset, FlgMeshView mesh, const std::string& path) {
    std::vector<uint32_t> triangles(mesh.triangle_count);
    std::iota(triangles.begin(), triangles.end(), 0u);
    std::vector<FlgSourceWeights> weights;
    for (uint32_t v = 0; v < mesh.vertex_count; ++v) weights.push_back({{v, FLG_NO_INDEX, FLG_NO_INDEX}, {0, 0}});
    FlgSurfaceProvenanceView lies = flgSurfaceProvenanceViewDefaults();
    lies.vertex_count = mesh.vertex_count;
    lies.triangle_count = lies.input_triangle_count = mesh.triangle_count;
    lies.triangles = triangles.data();
    lies.input_vertices = mesh.triangles;
    lies.weights = weights.data();
    const FlgMeshMaterial material = flgMeshMaterialDefaults();
    const std::vector<uint32_t> labels(mesh.triangle_count, 0);
    mesh.regions = labels.data();
    FlgMeshFileWriteDesc desc = FLG_INIT(calls, flgMeshFileWriteDescInit);
    desc.materials = &material;
    desc.material_count = 1;
    desc.asset = asset.c_str();
    desc.provenance = &lies;
    FLG_CALL(calls, flgMeshFileWrite, path.c_str(), &mesh, &desc);
}

}  // namespace

void keep_mesh_files(Calls& calls) {
    const Folder folder;
    MeshArrays mesh = cube(2);
    mesh.set_regions([](const Point& p) { return p[0] > 0.5 ? 1u : 0u; });
    const std::vector<uint32_t> numbers(mesh.triangle_count(), 3);
    FlgMeshFaceColumn column = FLG_INIT(calls, flgMeshFaceColumnInit);
    column.name = "kind";
    column.values = numbers.data();
    const FlgMeshMaterial materials[2] = {FLG_INIT(calls, flgMeshMaterialInit), flgMeshMaterialDefaults()};
    const FlgMeshFileReadDesc read_desc = FLG_INIT(calls, flgMeshFileReadDescInit);
    for (const char* name : {"mesh.ply", "mesh.glb"}) {
        const std::string path = folder.at(name);
        const FlgMeshView given = mesh.view();
        FlgMeshFileWriteDesc desc = FLG_INIT(calls, flgMeshFileWriteDescInit);
        if (path.ends_with(".ply")) {
            desc.face_columns = &column;
            desc.face_column_count = 1;
        } else {
            desc.split_regions = 1;
            desc.materials = materials;
            desc.material_count = 2;
        }
        FLG_CALL(calls, flgMeshFileWrite, path.c_str(), &given, &desc);
        Owned<FlgMeshFile> read(calls, flgMeshFileRelease, "flgMeshFileRelease");
        FLG_CALL(calls, flgMeshFileRead, path.c_str(), &read_desc, &read.file);
        FlgMeshView view = flgMeshViewDefaults();
        FLG_CALL(calls, flgMeshFileGetView, read.file, &view);
        calls.note(view.triangles, size_t{3} * view.triangle_count * sizeof(uint32_t));
        const FlgMeshFileInfo info =
            info_of(calls, "flgMeshFileGetInfo", flgMeshFileGetInfo, read.file, FLG_INIT(calls, flgMeshFileInfoInit));
        EXPECT_EQ(info.region_count, 2u);
        ASSERT_EQ(info.face_column_count, path.ends_with(".ply") ? 1u : 0u);
        ASSERT_EQ(info.material_count, path.ends_with(".glb") ? 2u : 0u);
        if (path.ends_with(".ply")) {
            FlgMeshFaceColumn shown = flgMeshFaceColumnDefaults();
            FLG_CALL(calls, flgMeshFileGetFaceColumn, read.file, 0u, &shown);
            EXPECT_STREQ(shown.name, "kind");
        } else {
            FlgMeshMaterial shown = flgMeshMaterialDefaults();
            FLG_CALL(calls, flgMeshFileGetMaterial, read.file, 1u, &shown);
            EXPECT_EQ(shown.roughness, 0.6f);
            write_into_asset(calls, path, view, folder.at("again.glb"));
        }
    }
}

void keep_skin_files(Calls& calls) {
    const Folder folder;
    const float positions[] = {0, 0, 0, 1, 0, 0, 0, 1, 0}, normals[] = {0, 0, 1, 0, 0, 1, 0, 0, 1};
    const uint32_t triangle[] = {0, 1, 2}, parts[] = {0, 0, 0}, parents[] = {FLG_NO_INDEX, 0};
    const uint16_t joints[12] = {0, 1, 0, 0, 0, 1, 0, 0, 1, 0, 0, 0};
    const float weights[12] = {0.75f, 0.25f, 0, 0, 0.5f, 0.5f, 0, 0, 1, 0, 0, 0}, places[] = {0, 0, 0, 1, 0, 0};
    const char* const names[] = {"root", "tip"};
    const FlgSkinView skin = {sizeof skin, 3,      1,       2,     positions, normals, triangle, joints,  weights,
                              parts,       places, parents, names, {},        nullptr, {},       nullptr, nullptr};
    const float times[] = {0, 1}, rotations[] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0.6f, 0.8f, 0, 0, 0, 1};
    const FlgSkinAnimation animation = {sizeof animation, 2, "nod", times, rotations, nullptr};
    FlgSkinFileWriteDesc desc = FLG_INIT(calls, flgSkinFileWriteDescInit);
    desc.skin = &skin;
    desc.animations = &animation;
    desc.animation_count = 1;
    const std::string path = folder.at("skin.glb"), motion_path = folder.at("motion.glb");
    const FlgMeshMaterial look = flgMeshMaterialDefaults();
    desc.materials = &look;
    desc.material_count = 1;
    const FlgSkinFileReadDesc read_desc = FLG_INIT(calls, flgSkinFileReadDescInit);
    const float moves[9] = {0, 0, 0.5f, 0, 0, 0, 0, 0, 0}, amounts[] = {0, 1};
    FlgMorphTarget shape = FLG_INIT(calls, flgMorphTargetInit);
    shape.moves = moves;
    FlgMorphAnimation swelling = FLG_INIT(calls, flgMorphAnimationInit);
    swelling.key_count = 2;
    swelling.times = times;
    swelling.weights = amounts;
    desc.morphs = &shape;
    desc.morph_count = 1;
    desc.morph_animations = &swelling;
    desc.morph_animation_count = 1;
    constexpr uint8_t picture[] = {0x89, 'P', 'N', 'G', 0x0d, 0x0a, 0x1a, 0x0a};  // no reader looks further
    FlgTexture texture = FLG_INIT(calls, flgTextureInit);
    texture.picture = picture;
    texture.picture_size = sizeof picture;
    const float uvs[6] = {0, 0, 1, 0, 0, 1};
    FlgSkinView textured = skin;
    textured.corner_uvs = uvs;
    FlgMeshMaterial painted = look;
    painted.texture = 0;
    desc.skin = &textured;
    desc.materials = &painted;
    desc.textures = &texture;
    desc.texture_count = 1;
    FLG_CALL(calls, flgSkinFileWrite, path.c_str(), &desc);
    // As an avatar: too few bones.
    FlgVrm vrm = FLG_INIT(calls, flgVrmInit);
    const char* const author = "somebody";
    vrm.authors = &author;
    vrm.author_count = 1;
    vrm.bones = names;
    desc.vrm = &vrm;
    EXPECT_EQ(flgSkinFileWrite(path.c_str(), &desc), FLG_ERROR_INVALID_ARGUMENT);
    desc.vrm = nullptr;
    Owned<FlgSkinFile> read(calls, flgSkinFileRelease, "flgSkinFileRelease");
    FLG_CALL(calls, flgSkinFileRead, path.c_str(), &read_desc, &read.file);
    FlgSkinView view = flgSkinViewDefaults();
    FLG_CALL(calls, flgSkinFileGetView, read.file, &view);
    calls.note(view.positions, size_t{3} * view.vertex_count * sizeof(float));
    FlgSkinAnimation shown = FLG_INIT(calls, flgSkinAnimationInit);
    FLG_CALL(calls, flgSkinFileGetAnimation, read.file, 0u, &shown);
    EXPECT_STREQ(shown.name, "nod");
    FlgMorphTarget shown_shape = flgMorphTargetDefaults();
    FLG_CALL(calls, flgSkinFileGetMorphTarget, read.file, 0u, &shown_shape);
    EXPECT_EQ(shown_shape.moves[2], 0.5f);
    FlgMorphAnimation shown_weights = flgMorphAnimationDefaults();
    FLG_CALL(calls, flgSkinFileGetMorphAnimation, read.file, 0u, &shown_weights);
    EXPECT_EQ(shown_weights.weights[1], 1);
    FlgTexture shown_texture = flgTextureDefaults();
    FLG_CALL(calls, flgSkinFileGetTexture, read.file, 0u, &shown_texture);
    EXPECT_EQ(shown_texture.picture_size, sizeof picture);
    Owned<FlgMeshFile> plain(calls, flgMeshFileRelease, "flgMeshFileRelease");
    const FlgMeshFileReadDesc plain_desc = FLG_INIT(calls, flgMeshFileReadDescInit);
    FLG_CALL(calls, flgMeshFileRead, path.c_str(), &plain_desc, &plain.file);
    FLG_CALL(calls, flgMeshFileGetTexture, plain.file, 0u, &shown_texture);
    EXPECT_EQ(shown_texture.picture_size, sizeof picture);
    FlgMeshMaterial shown_look = flgMeshMaterialDefaults();
    FLG_CALL(calls, flgSkinFileGetMaterial, read.file, 0u, &shown_look);
    EXPECT_EQ(info_of(calls, "flgSkinFileGetInfo", flgSkinFileGetInfo, read.file, FLG_INIT(calls, flgSkinFileInfoInit))
                  .part_count,
              1u);

    const double motion_times[] = {0, 1};
    const double poses[] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 1, 0, 0, 1, 0, 0, -1, 0, 0, 1, 0, 0};
    FlgMotionFileWriteDesc motion = FLG_INIT(calls, flgMotionFileWriteDescInit);
    motion.position_count = 2;
    motion.times = motion_times;
    motion.poses = poses;
    FLG_CALL(calls, flgMotionFileWrite, motion_path.c_str(), &motion);
}

void keep_tangle_files(Calls& calls) {
    EXPECT_STREQ(FLG_VALUE(calls, flgTangleOperatorGetName, uint32_t{FLG_TANGLE_OPERATOR_VORONOI}), "voronoi");
    EXPECT_STREQ(FLG_VALUE(calls, flgTangleMacroGetName, uint32_t{FLG_TANGLE_MACRO_FLOWER}), "flower");
    const Folder folder;
    std::vector<uint32_t> regions;
    for (uint32_t i = 0; i < 40; ++i) regions.push_back(i);
    FlgTangleStep step{};
    step.struct_size = sizeof step;
    step.kind = FLG_TANGLE_STEP_KIND_GROUP;
    step.regions = regions.data();
    step.region_count = 40;
    const FlgTangleStep* const steps[] = {&step};
    FlgTangleHistory history{};
    history.struct_size = sizeof history;
    history.step_count = history.made_count = 1;
    history.steps = steps;
    history.box_max[0] = 1;
    const std::string path = folder.at("tangle.json");
    const FlgTangleFileWriteDesc write_desc = FLG_INIT(calls, flgTangleFileWriteDescInit);
    const FlgTangleFileReadDesc read_desc = FLG_INIT(calls, flgTangleFileReadDescInit);
    FLG_CALL(calls, flgTangleFileWrite, path.c_str(), &history, &write_desc);
    Owned<FlgTangleFile> read(calls, flgTangleFileRelease, "flgTangleFileRelease");
    FLG_CALL(calls, flgTangleFileRead, path.c_str(), &read_desc, &read.file);
    FlgTangleHistory shown{};
    shown.struct_size = sizeof shown;
    FLG_CALL(calls, flgTangleFileGetHistory, read.file, &shown);
    ASSERT_EQ(shown.step_count, 1u);
    calls.note(shown.steps[0]->regions, shown.steps[0]->region_count * sizeof(uint32_t));
}

}  // namespace flg::test
#endif
