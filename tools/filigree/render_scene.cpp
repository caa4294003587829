// SPDX-License-Identifier: MIT
#include "render_scene.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "documents/failure.h"
#include "drawn_picture.h"
#include "field_file.h"
#include "joined_curves.h"
#include "render_bones.h"
#include "support/brush_shape.h"

namespace flg::cli {
namespace {

// Radius of curves that bring none: this share of the diagonal of the picture's content.
constexpr float kDefaultRadiusShare = 1.0f / 400.0f;
constexpr double kUsualLevels = 20.0;
constexpr float kBorderWidthPx = 1.2f;

// sRGB, as in picture editors. Neighbours in the list differ in lightness and in warmth.
constexpr uint32_t kRegionColors[] = {0xe9dcc3, 0x2f6f76, 0xd7793f, 0x27395b, 0xa9c3a0, 0xb94a45,
                                      0xedb95e, 0x6a5282, 0x86b6c9, 0x85563a, 0xe0b9bd, 0x4c7a52};

float linear_of_srgb(uint32_t byte) {
    const double v = byte / 255.0;
    return static_cast<float>(v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4));
}

std::vector<render::Material> region_materials() {
    std::vector<render::Material> materials;
    for (const uint32_t color : kRegionColors) {
        render::Material& material = materials.emplace_back();
        material.color = {linear_of_srgb(color >> 16), linear_of_srgb(color >> 8 & 255), linear_of_srgb(color & 255)};
        material.roughness = 0.45f;
    }
    return materials;
}

// Those that a file gives its regions.
std::vector<render::Material> materials_of(const std::vector<FlgMeshMaterial>& given) {
    constexpr float kThinnestPx = 0.5f;  // that the renderer draws
    std::vector<render::Material> materials;
    for (const FlgMeshMaterial& from : given) {
        render::Material& to = materials.emplace_back();
        to.color = {from.color[0], from.color[1], from.color[2]};
        to.metallic = from.metallic;
        to.roughness = from.roughness;
        to.texture = from.texture == FLG_NO_INDEX ? render::no_texture : from.texture;
        if (from.border_width_px > 0.0f) to.border_width_px = std::max(from.border_width_px, kThinnestPx);
        to.border_color = {from.border_color[0], from.border_color[1], from.border_color[2]};
    }
    return materials;
}

render::Wrap wrap_of(FlgTextureWrap wrap) {
    if (wrap == FLG_TEXTURE_WRAP_CLAMP) return render::Wrap::clamp;
    return wrap == FLG_TEXTURE_WRAP_MIRROR ? render::Wrap::mirror : render::Wrap::repeat;
}

std::vector<render::SurfaceTexture> textures_of(const std::vector<FlgTexture>& given, const std::string& subject) {
    std::vector<render::SurfaceTexture> textures;
    for (const FlgTexture& from : given) {
        DecodedPicture picture = decode_picture(from.picture, from.picture_size, subject);
        render::SurfaceTexture& to = textures.emplace_back();
        to.image = {picture.width, picture.height, std::move(picture.pixels)};
        to.wrap_u = wrap_of(from.wrap_u);
        to.wrap_v = wrap_of(from.wrap_v);
        to.nearest = from.nearest != 0;
    }
    return textures;
}

bool have_colors(const FlgMeshView& mesh) {
    const auto is_color = [](const FlgColumn& column) { return column.attribute == FLG_ATTRIBUTE_COLOR; };
    return std::any_of(mesh.columns, mesh.columns + mesh.column_count, is_color);
}

bool look_alike(const std::vector<render::Material>& materials) {
    return std::all_of(materials.begin(), materials.end(), [&](const render::Material& material) {
        const render::Material& first = materials.front();
        return material.color == first.color && material.metallic == first.metallic &&
               material.roughness == first.roughness && material.texture == first.texture &&
               material.border_width_px == 0.0f;
    });
}

// 1, 2 or 5 times a power of ten: the one that gives the most levels up to the usual number.
double round_spacing(double span) {
    const double least = span / kUsualLevels;
    const double power = std::pow(10.0, std::floor(std::log10(least)));
    for (const double step : {1.0, 2.0, 5.0}) {
        if (step * power >= least * (1.0 - 1e-9)) return step * power;
    }
    return 10.0 * power;
}

render::Shape shape_of(Shapes shapes) {
    if (shapes == Shapes::lines) return render::Shape::line;
    return shapes == Shapes::ribbon ? render::Shape::ribbon : render::Shape::tube;
}

}  // namespace

render::SurfaceLook look_of(const MeshFile& mesh) {
    render::SurfaceLook look;
    const std::vector<render::Material> materials = materials_of(mesh.materials());
    if (mesh.info().region_count > 1 && materials.empty()) {
        look.regions = region_materials();
        look.border_width_px = kBorderWidthPx;
    } else if (mesh.info().region_count > 1 && !(have_colors(mesh.view()) && look_alike(materials))) {
        look.regions = materials;
    } else if (!materials.empty()) {
        look.material = materials[0];
    }
    look.textures = textures_of(mesh.textures(), mesh.name());
    if (mesh.info().corner_uvs) look.corner_uvs = {mesh.info().corner_uvs, 6 * size_t{mesh.view().triangle_count}};
    return look;
}

render::SurfaceLook look_of(const SkinFile& skin) {
    render::SurfaceLook look;
    std::vector<render::Material> materials = materials_of(skin.materials());
    for (render::Material& material : materials) material.border_width_px = 0.0f;
    const float* const colors = skin.info().vertex_colors;
    if (materials.empty() && !colors && skin.info().part_count > 1) {
        look.regions = region_materials();
    } else if (materials.size() == 1) {
        look.material = materials[0];
    } else {
        look.regions = materials;
    }
    look.textures = textures_of(skin.textures(), skin.name());
    if (colors) look.vertex_colors = {colors, 4 * size_t{skin.view().vertex_count}};
    return look;
}

RenderScene::RenderScene(const SceneOptions& options, Report& report) : options_(options) {
    uint64_t curves = 0, points = 0, vertices = 0, triangles = 0;
    for (const std::string& name : options.files) {
        FileContents contents = read_contents(name);
        if (contents.curves) {
            const samples::CurveSource& source = curves_.emplace_back(std::move(*contents.curves));
            for (const std::string& warning : source.warnings()) report.warn(source.name() + ": " + warning);
            curves += source.view().curve_count;
            points += source.point_count();
        }
        if (contents.skin || !contents.why_no_skin.empty()) add_skin(contents, name, report);
        if (contents.skin) {
            vertices += skins_.back().file.view().vertex_count;
            triangles += skins_.back().file.view().triangle_count;
        } else if (contents.mesh) {
            const MeshFile& mesh = meshes_.emplace_back(std::move(*contents.mesh));
            const FlgMeshFileInfo& info = mesh.info();
            for (uint32_t i = 0; i < info.warning_count; ++i) report.warn(name + ": " + info.warnings[i]);
            vertices += mesh.view().vertex_count;
            triangles += mesh.view().triangle_count;
        }
    }
    report.counts = {{"files", options.files.size()}, {"curves", curves},     {"points", points},
                     {"meshes", meshes_.size()},      {"vertices", vertices}, {"triangles", triangles},
                     {"skins", skins_.size()}};
    if (skins_.empty() && ((options.pose.time && options.camera_motion.empty()) || options.bones))
        throw UsageError(std::string(options.bones ? "--bones" : "--time") + ": no file has a skin");
    if (!options.field.empty()) {
        read_field(report);
    } else if (options.every > 0.0) {
        throw UsageError("--every: there are no isolines without --field");
    }
}

void RenderScene::add_skin(FileContents& contents, const std::string& name, Report& report) {
    if (!contents.skin) {
        if (options_.pose.time || options_.bones) throw InputError(contents.why_no_skin);
        report.warn(name + ": drawn as it stands, without its skin: " + contents.why_no_skin);
        return;
    }
    const FlgSkinFileInfo& info = contents.skin->info();
    for (uint32_t i = 0; i < info.warning_count; ++i) report.warn(name + ": " + info.warnings[i]);
    SkinPose pose = pose_skin(*contents.skin, options_.pose);
    skins_.push_back({std::move(*contents.skin), std::move(pose)});
}

void RenderScene::read_field(Report& report) {
    if (meshes_.size() != 1)
        throw UsageError("--field: needs exactly one mesh, and there are " + std::to_string(meshes_.size()));
    field_ = read_field_file(options_.field);
    const uint32_t vertices = meshes_[0].view().vertex_count;
    if (field_.size() != vertices) {
        throw InputError(options_.field + ": " + std::to_string(field_.size()) + " values, but " + meshes_[0].name() +
                         " has " + std::to_string(vertices) + " vertices");
    }
    float low = std::numeric_limits<float>::max(), high = std::numeric_limits<float>::lowest();
    for (const float value : field_) {
        if (std::isinf(value)) continue;
        low = std::min(low, value);
        high = std::max(high, value);
    }
    const double span = double{high} - double{low};
    spacing_ = options_.every > 0.0 ? options_.every : span > 0.0 ? round_spacing(span) : 0.0;
    if (span >= 0.0) report.quality["field"] = {{"low", low}, {"high", high}, {"every", spacing_}};
}

void RenderScene::upload_skins(render::Renderer& renderer) const {
    for (const Skin& skin : skins_) {
        const render::SurfaceLook look = look_of(skin.file);
        renderer.set_pose(renderer.upload(morphed(skin.file, skin.pose), look), options_.pose.skinning,
                          skin.pose.transforms);
    }
    if (!options_.bones) return;
    const float size = renderer.bounds().diagonal();
    for (const Skin& skin : skins_) upload_bones(renderer, skin.file.view(), skin.pose.joint_positions, size);
}

void RenderScene::upload_curves(render::Renderer& renderer) const {
    // Curves of one shape: those of a file, or of a sketch those of flat and of round brushes.
    struct Part {
        JoinedCurves joined;
        FlgCurveSetView view;
        render::Shape shape;
    };
    std::vector<Part> parts;
    parts.reserve(2 * curves_.size());
    for (const samples::CurveSource& source : curves_) {
        const std::vector<FlgCurveGeometry> brushes = samples::shapes_of_strokes(source);
        if (options_.as != Shapes::automatic || brushes.empty()) {
            parts.push_back({{}, source.view(), shape_of(options_.as)});
            continue;
        }
        for (const FlgCurveGeometry geometry : {FLG_CURVE_GEOMETRY_RIBBON, FLG_CURVE_GEOMETRY_TUBE}) {
            Part& part = parts.emplace_back();
            for (uint32_t c = 0; c < brushes.size(); ++c) {
                if (brushes[c] == geometry) part.joined.add(source.view(), c);
            }
            part.view = part.joined.view();
            part.shape = geometry == FLG_CURVE_GEOMETRY_RIBBON ? render::Shape::ribbon : render::Shape::tube;
            if (part.joined.curve_count() == 0) parts.pop_back();
        }
    }
    render::CurveLook look;
    look.shape = render::Shape::line;
    std::vector<render::CurvesId> ids;
    for (const Part& part : parts) ids.push_back(renderer.upload(part.view, look));
    // Now that the size of the whole is known, so is a sensible radius.
    look.radius = options_.radius > 0.0 ? static_cast<float>(options_.radius)
                                        : renderer.bounds().diagonal() * kDefaultRadiusShare;
    for (size_t i = 0; i < ids.size(); ++i) {
        look.shape = parts[i].shape;
        if (look.shape != render::Shape::line) renderer.update(ids[i], parts[i].view, look);
    }
}

void RenderScene::upload(render::Renderer& renderer) const {
    for (const MeshFile& mesh : meshes_) {
        render::SurfaceLook look = look_of(mesh);
        look.isoline_spacing = static_cast<float>(spacing_);
        renderer.upload(mesh.view(), look, field_);
    }
    upload_skins(renderer);
    upload_curves(renderer);
}

std::vector<glm::vec3> RenderScene::points() const {
    std::vector<glm::vec3> points;
    const auto add = [&](const float* p) { points.emplace_back(p[0], p[1], p[2]); };
    for (const samples::CurveSource& source : curves_) {
        const FlgColumn& column = *samples::find_column(source.view(), FLG_ATTRIBUTE_POSITION);
        for (size_t i = 0; i < source.point_count(); ++i) add(samples::value_at(column, i));
    }
    for (const Skin& skin : skins_) {
        for (size_t i = 0; i < skin.pose.positions.size(); i += 3) add(&skin.pose.positions[i]);
        for (size_t i = 0; options_.bones && i < skin.pose.joint_positions.size(); i += 3)
            add(&skin.pose.joint_positions[i]);
    }
    for (const MeshFile& mesh : meshes_) {
        const FlgMeshView& view = mesh.view();
        for (uint32_t i = 0; i < view.column_count; ++i) {
            if (view.columns[i].attribute != FLG_ATTRIBUTE_POSITION) continue;
            for (size_t v = 0; v < view.vertex_count; ++v) add(samples::value_at(view.columns[i], v));
        }
    }
    return points;
}

}  // namespace flg::cli
