// SPDX-License-Identifier: MIT
#include "documents/model_drawing.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "documents/failure.h"
#include "documents/json_color.h"
#include "documents/text_lines.h"

namespace flg::cli {
namespace {

constexpr double largest = 1e30;
constexpr uint32_t points_per_piece = 8;
constexpr float usual_color[] = {0.62f, 0.56f, 0.5f}, usual_roughness = 0.5f;

using Pair = std::array<double, 2>;

std::vector<Pair> read_points(const JsonPlace& list) {
    std::vector<Pair> points;
    for (const JsonPlace& item : list.items()) {
        const std::vector<JsonPlace> numbers = item.items();
        if (numbers.size() != 2) item.fail("must be [x, y]");
        points.push_back({numbers[0].number(-largest, largest), numbers[1].number(-largest, largest)});
    }
    if (points.size() < 3) list.fail("has fewer than three points");
    return points;
}

// A closed Catmull-Rom curve through the points.
std::vector<Pair> smooth(const std::vector<Pair>& points) {
    std::vector<Pair> curve;
    const size_t n = points.size();
    for (size_t i = 0; i < n; ++i) {
        const Pair &a = points[(i + n - 1) % n], &b = points[i], &c = points[(i + 1) % n], &d = points[(i + 2) % n];
        for (uint32_t k = 0; k < points_per_piece; ++k) {
            const double t = static_cast<double>(k) / points_per_piece;
            Pair p;
            for (size_t x = 0; x < 2; ++x) {
                p[x] = b[x] + 0.5 * t *
                                  (c[x] - a[x] +
                                   t * (2 * a[x] - 5 * b[x] + 4 * c[x] - d[x] + t * (3 * (b[x] - c[x]) + d[x] - a[x])));
            }
            curve.push_back(p);
        }
    }
    return curve;
}

void add_ring(ContourArrays& contour, const std::vector<Pair>& points) {
    for (const Pair& p : points) contour.points.insert(contour.points.end(), p.begin(), p.end());
    contour.offsets.push_back(static_cast<uint32_t>(contour.points.size() / 2));
}

// A list of points, or of rings.
template <class AddRing>
void read_rings(const JsonPlace& list, AddRing add) {
    const std::vector<JsonPlace> items = list.items();
    const bool has_rings =
        !items.empty() && items[0].is_array() && !items[0].items().empty() && items[0].items()[0].is_array();
    if (!has_rings) return add(read_points(list));
    for (const JsonPlace& ring : items) add(read_points(ring));
}

std::vector<double> read_numbers(const JsonPlace& list, size_t count) {
    std::vector<double> numbers;
    for (const JsonPlace& item : list.items()) numbers.push_back(item.number(-largest, largest));
    if (numbers.size() != count) list.fail("must be " + std::to_string(count) + " numbers");
    return numbers;
}

// Turned about x, then y, then z, scaled, moved.
void read_placement(const JsonPlace& item, DrawnPart& part) {
    double scale = 1;
    std::vector<double> at = {0, 0, 0}, turn = {0, 0, 0};
    if (const auto place = item.find("scale")) scale = place->number(1e-30, largest);
    if (const auto place = item.find("at")) at = read_numbers(*place, 3);
    if (const auto place = item.find("turn")) turn = read_numbers(*place, 3);
    const double degree = std::acos(-1.0) / 180;
    const double ca = std::cos(turn[0] * degree), sa = std::sin(turn[0] * degree);
    const double cb = std::cos(turn[1] * degree), sb = std::sin(turn[1] * degree);
    const double cc = std::cos(turn[2] * degree), sc = std::sin(turn[2] * degree);
    part.placement = {scale * cb * cc,
                      scale * (sa * sb * cc - ca * sc),
                      scale * (ca * sb * cc + sa * sc),
                      at[0],
                      scale * cb * sc,
                      scale * (sa * sb * sc + ca * cc),
                      scale * (ca * sb * sc - sa * cc),
                      at[1],
                      -scale * sb,
                      scale * sa * cb,
                      scale * ca * cb,
                      at[2]};
}

void set_usual_look(FlgMeshMaterial& look) {
    std::copy_n(usual_color, 3, look.color);
    look.roughness = usual_roughness;
}

void read_look(const JsonPlace& item, DrawnPart& part, ModelDrawing& drawing) {
    set_usual_look(part.material);
    if (const auto place = item.find("color")) {
        read_color(*place, part.material.color);
        drawing.has_colors = true;
    }
    if (const auto place = item.find("metallic")) part.material.metallic = place->number(0, 1);
    if (const auto place = item.find("roughness")) part.material.roughness = place->number(0, 1);
}

void read_thresholds(const JsonPlace& item, FlgBoneThresholds& out) {
    if (const auto place = item.find("simplify")) out.simplify = place->number(0, 10);
    if (const auto place = item.find("merge")) out.merge = place->number(0, 10);
    if (const auto place = item.find("prune")) out.prune = place->number(0, 10);
    if (const auto place = item.find("collapse")) out.collapse = place->number(0, 10);
    if (const auto place = item.find("detail")) out.detail = place->number(0, 20);
}

DrawnPart read_part(const JsonPlace& item, const std::filesystem::path& folder, ModelDrawing& drawing) {
    item.allow({"name",     "contour",   "curve",  "at",           "turn",     "scale",  "thickness",
                "mirrored", "simplify",  "merge",  "prune",        "collapse", "detail", "color",
                "metallic", "roughness", "parent", "parent_joint", "depth",    "picture"});
    DrawnPart part;
    part.name = item.at("name").text();
    const auto contour = item.find("contour"), curve = item.find("curve");
    if (contour.has_value() == curve.has_value()) item.fail("must have either a contour or a curve");
    if (curve) {
        read_rings(*curve, [&](const std::vector<Pair>& points) { add_ring(part.contour, smooth(points)); });
    } else if (contour->is_string()) {
        part.contour = read_contour_file((folder / contour->text()).string());
    } else {
        read_rings(*contour, [&](const std::vector<Pair>& points) { add_ring(part.contour, points); });
    }
    read_placement(item, part);
    if (const auto place = item.find("thickness")) part.thickness = place->number(0.01, 100);
    if (const auto place = item.find("depth")) part.depth = place->number(-largest, largest);
    if (const auto place = item.find("mirrored")) part.is_mirrored = place->flag();
    if (const auto place = item.find("parent")) part.parent = place->text();
    if (const auto place = item.find("parent_joint")) part.parent_joint = place->text();
    if (const auto place = item.find("picture")) {
        const std::vector<double> box = read_numbers(*place, 4);
        if (!(box[0] < box[2] && box[1] < box[3])) place->fail("must be [left, bottom, right, top]");
        std::copy(box.begin(), box.end(), part.picture.begin());
    }
    read_look(item, part, drawing);
    part.thresholds = drawing.thresholds;
    read_thresholds(item, *part.thresholds);
    return part;
}

// In the order of FlgJointEditKind.
constexpr std::initializer_list<const char*> joint_edits = {"pin", "split", "merge", "rename"};

JointEdit read_joint_edit(const JsonPlace& item) {
    item.allow({"joint", "edit", "at", "name", "share"});
    JointEdit edit;
    edit.joint = item.at("joint").text();
    edit.kind = static_cast<FlgJointEditKind>(item.at("edit").word(joint_edits));
    if (edit.kind == FLG_JOINT_EDIT_KIND_PIN) {
        const std::vector<double> at = read_numbers(item.at("at"), 3);
        std::copy(at.begin(), at.end(), edit.at.begin());
    }
    if (edit.kind == FLG_JOINT_EDIT_KIND_SPLIT || edit.kind == FLG_JOINT_EDIT_KIND_RENAME)
        edit.name = item.at("name").text();
    if (const auto place = item.find("share")) edit.share = place->real(0, 1);
    return edit;
}

uint32_t part_named(const ModelDrawing& drawing, const std::string& name, const std::string& subject) {
    for (uint32_t p = 0; p < drawing.parts.size(); ++p)
        if (drawing.parts[p].name == name) return p;
    throw InputError(subject + ": there is no part " + shortened(name));
}

}  // namespace

ModelDrawing read_model_drawing(const std::string& path) {
    return model_drawing_of(JsonPlace::read(path), path, std::filesystem::path(path).parent_path());
}

ModelDrawing model_drawing_of(const nlohmann::json& json, const std::string& subject,
                              const std::filesystem::path& folder) {
    const JsonPlace whole(json, subject + ": model");
    whole.allow({"parts", "mirror", "simplify", "merge", "prune", "collapse", "detail", "root", "root_joint", "joints",
                 "apart", "texture"});
    ModelDrawing drawing;
    if (const auto place = whole.find("mirror")) {
        const std::vector<double> plane = read_numbers(*place, 4);
        for (size_t i = 0; i < 4; ++i) drawing.mirror[i] = static_cast<float>(plane[i]);
    }
    read_thresholds(whole, drawing.thresholds);
    for (const JsonPlace& item : whole.at("parts").items()) drawing.parts.push_back(read_part(item, folder, drawing));
    if (drawing.parts.empty()) whole.at("parts").fail("is empty");
    if (const auto place = whole.find("texture")) drawing.texture = (folder / place->text()).string();
    if (const auto place = whole.find("root")) drawing.root = place->text();
    if (const auto place = whole.find("root_joint")) drawing.root_joint = place->text();
    if (const auto place = whole.find("joints"))
        for (const JsonPlace& item : place->items()) drawing.joint_edits.push_back(read_joint_edit(item));
    if (const auto place = whole.find("apart"))
        for (const JsonPlace& item : place->items()) {
            const std::vector<JsonPlace> names = item.items();
            if (names.size() != 2) item.fail("must be two names of parts");
            drawing.apart.push_back({names[0].text(), names[1].text()});
        }
    return drawing;
}

std::vector<DrawnPart> read_contour_parts(const std::string& path, std::vector<std::string>& warnings) {
    Outlines outlines = read_outlines(path);
    warnings.insert(warnings.end(), outlines.warnings.begin(), outlines.warnings.end());
    const std::string name = std::filesystem::path(path).stem().stem().string();
    std::vector<DrawnPart> parts;
    for (ContourArrays& contour : outlines.contours) {
        DrawnPart& part = parts.emplace_back();
        part.name = parts.size() == 1 ? name : name + "-" + std::to_string(parts.size());
        part.placement[11] = contour.depth;
        part.contour = std::move(contour);
        set_usual_look(part.material);
    }
    return parts;
}

namespace {

// Where the drawing's middle is if it lies so far away that floats would not tell its points apart; else 0. With mirror
// images it is as large as it is far away.
std::array<double, 3> origin_of(const ModelDrawing& drawing) {
    constexpr double far_away = 1000;  // by its size
    std::array<double, 3> low, high, origin = {0, 0, 0};
    low.fill(1e300), high.fill(-1e300);
    for (const DrawnPart& part : drawing.parts) {
        if (part.is_mirrored) return origin;
        for (size_t i = 0; i + 1 < part.contour.points.size(); i += 2)
            for (size_t k = 0; k < 3; ++k) {
                const double* row = part.placement.data() + 4 * k;
                const double at = row[0] * part.contour.points[i] + row[1] * part.contour.points[i + 1] + row[3];
                low[k] = std::min(low[k], at), high[k] = std::max(high[k], at);
            }
    }
    const double size = std::hypot(high[0] - low[0], high[1] - low[1], high[2] - low[2]);
    const auto middle = [&](size_t k) { return low[k] + (high[k] - low[k]) / 2; };
    if (!(std::hypot(middle(0), middle(1), middle(2)) > far_away * size)) return origin;
    for (size_t k = 0; k < 3; ++k) origin[k] = middle(k);
    return origin;
}

}  // namespace

FlgModel make_drawn_model(Session& session, const ModelDrawing& drawing, const std::string& subject, Report& report) {
    const std::array<double, 3> origin = origin_of(drawing);
    std::vector<FlgModelPart> parts;
    std::vector<Session::Pending> jobs;
    for (const DrawnPart& drawn : drawing.parts) {
        const std::string name = subject + ": " + drawn.name;
        FlgPartDesc desc = flgPartDefaults();
        FlgContourView input = flgContourViewDefaults();
        input.points = drawn.contour.points.data();
        input.point_count = static_cast<uint32_t>(drawn.contour.points.size() / 2);
        input.ring_offsets = drawn.contour.offsets.data();
        input.ring_count = static_cast<uint32_t>(drawn.contour.offsets.size()) - 1;
        desc.contour = &input;
        desc.repair = drawing.repair;
        FlgModelPart part = flgModelPartDefaults();
        FlgJob job = {};
        check(flgPartCreate(session.context(), &desc, &part.part, &job), name);
        jobs.push_back({job, name});
        part.name = drawn.name.c_str();
        std::copy(drawn.placement.begin(), drawn.placement.end(), part.placement);
        for (size_t k = 0; k < 3; ++k) part.placement[4 * k + 3] -= origin[k];
        part.thickness = drawn.thickness;
        part.depth = drawn.depth;
        part.mirrored = drawn.is_mirrored;
        std::copy(drawn.picture.begin(), drawn.picture.end(), part.picture);
        part.thresholds = drawn.thresholds ? &*drawn.thresholds : nullptr;
        if (!drawn.parent.empty()) part.parent = part_named(drawing, drawn.parent, name);
        part.parent_joint = drawn.parent_joint.empty() ? nullptr : drawn.parent_joint.c_str();
        parts.push_back(part);
    }
    FlgModelDesc desc = flgModelDefaults();
    desc.parts = parts.data();
    desc.part_count = static_cast<uint32_t>(parts.size());
    desc.thresholds = &drawing.thresholds;
    std::copy(drawing.mirror.begin(), drawing.mirror.end(), desc.mirror);
    std::copy(origin.begin(), origin.end(), desc.origin);
    if (!drawing.root.empty()) desc.root = part_named(drawing, drawing.root, subject);
    desc.root_joint = drawing.root_joint.empty() ? nullptr : drawing.root_joint.c_str();
    std::vector<FlgJointEdit> edits;
    for (const JointEdit& edit : drawing.joint_edits) edits.push_back(described(edit));
    std::vector<uint32_t> apart;
    for (const auto& pair : drawing.apart)
        for (const std::string& name : pair) apart.push_back(part_named(drawing, name, subject));
    desc.apart_pairs = apart.data();
    desc.apart_pair_count = static_cast<uint32_t>(drawing.apart.size());
    desc.joint_edits = edits.data();
    desc.joint_edit_count = static_cast<uint32_t>(edits.size());
    FlgModelView previous;
    if (drawing.previous) {
        previous = drawing.previous->view();
        desc.previous_view = &previous;
    }
    FlgModel model = {};
    FlgJob job = {};
    check(flgModelCreate(session.context(), &desc, &model, &job), subject);
    jobs.push_back({job, subject});
    session.finish(jobs, report);
    return model;
}

FlgJointEdit described(const JointEdit& edit) {
    FlgJointEdit out = flgJointEditDefaults();
    out.kind = edit.kind;
    out.joint = edit.joint.c_str();
    out.name = edit.name.empty() ? nullptr : edit.name.c_str();
    std::copy(edit.at.begin(), edit.at.end(), out.at);
    out.share = edit.share;
    return out;
}

}  // namespace flg::cli
