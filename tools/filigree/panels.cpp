// SPDX-License-Identifier: MIT
// filigree panels: several views side by side, with words, in one picture.
#include "panels/panels.h"

#include <cmath>
#include <deque>
#include <map>
#include <memory>
#include <numbers>

#include "command.h"
#include "documents/failure.h"
#include "documents/json_color.h"
#include "documents/progress.h"
#include "documents/text_file.h"
#include "field_file.h"
#include "panels/small_png.h"
#include "render_scene.h"
#include "support/vulkan_loader.h"

namespace flg::cli {
namespace {

using panels::Panel;

constexpr double kFar = 1e6;  // metres, and anything else
constexpr uint32_t kMaxPixels = 8192, kMaxPanels = 100;

struct Options {
    std::string file, output;
};

glm::vec3 color_at(const JsonPlace& place) {
    glm::vec3 color;
    read_color(place, &color.x);
    return color;
}

glm::vec3 point_at(const JsonPlace& place) {
    const std::vector<JsonPlace> numbers = place.items();
    if (numbers.size() != 3) place.fail("must be three numbers");
    glm::vec3 point;
    for (int k = 0; k < 3; ++k) point[k] = numbers[static_cast<size_t>(k)].number(-kFar, kFar);
    return point;
}

void read(const JsonPlace& place, const char* key, float& value, double least, double most) {
    if (const auto found = place.find(key)) value = found->number(least, most);
}

void read(const JsonPlace& place, const char* key, glm::vec3& color) {
    if (const auto found = place.find(key)) color = color_at(*found);
}

void read(const JsonPlace& place, const char* key, std::string& text) {
    if (const auto found = place.find(key)) text = found->text();
}

void read(const JsonPlace& place, const char* key, bool& flag) {
    if (const auto found = place.find(key)) flag = found->flag();
}

// From the eye into the scene.
glm::vec3 sight_of(const JsonPlace& camera) {
    constexpr float kRadians = std::numbers::pi_v<float> / 180.0f;
    const std::vector<JsonPlace> angles = camera.items();
    if (angles.size() != 2) camera.fail("must be [yaw, pitch], degrees");
    const float yaw = kRadians * angles[0].number(-360, 360), pitch = kRadians * angles[1].number(-90, 90);
    return {-std::sin(yaw) * std::cos(pitch), -std::sin(pitch), -std::cos(yaw) * std::cos(pitch)};
}

// A picture as its file describes it, with what its panels show.
class Picture {
public:
    Picture(const std::string& file, Report& report) : json_(JsonPlace::read(file)) {
        const JsonPlace place(json_, file);
        place.allow({"size", "columns", "all", "panels"});
        const std::vector<JsonPlace> size = place.at("size").items();
        if (size.size() != 2) place.at("size").fail("must be [width, height], pixels");
        width_ = size[0].count(1, kMaxPixels), height_ = size[1].count(1, kMaxPixels);
        with_all();
        const std::vector<JsonPlace> list = place.at("panels").items();
        if (list.empty() || list.size() > kMaxPanels) place.at("panels").fail("must be 1 to 100 panels");
        columns_ = static_cast<uint32_t>(list.size());
        if (const auto columns = place.find("columns")) columns_ = columns->count(1, columns_);
        for (const JsonPlace& panel : list) add_panel(panel, report);
        for (const auto& [name, members] : groups_) aim_together(members);
        report.counts["panels"] = panels_.size();
    }

    render::Image taken_by(panels::Studio& studio) const { return studio.compose(panels_, columns_, width_, height_); }

private:
    // What `all` says counts for each panel that doesn't say it itself.
    void with_all() {
        if (!json_.contains("all") || !json_.contains("panels")) return;
        for (nlohmann::json& panel : json_["panels"]) {
            nlohmann::json whole = json_["all"];
            whole.update(panel);
            panel = whole;
        }
        json_.erase("all");
    }

    void add_panel(const JsonPlace& place, Report& report) {
        place.allow({"show", "title", "credit", "keys", "notes", "camera", "margin", "ground", "aim", "aim_with"});
        Panel& panel = panels_.emplace_back();
        read(place, "title", panel.title);
        read(place, "credit", panel.credit);
        if (const auto camera = place.find("camera")) panel.sight = sight_of(*camera);
        read(place, "margin", panel.margin, 1.0, 100.0);
        read(place, "ground", panel.ground);
        if (const auto aim = place.find("aim")) {
            for (const JsonPlace& point : aim->items()) panel.aim.push_back(point_at(point));
        }
        if (const auto group = place.find("aim_with")) groups_[group->text()].push_back(panels_.size() - 1);
        if (const auto keys = place.find("keys")) {
            for (const JsonPlace& key : keys->items()) {
                key.allow({"color", "text"});
                panel.keys.push_back({color_at(key.at("color")), key.at("text").text()});
            }
        }
        if (const auto notes = place.find("notes")) {
            for (const JsonPlace& note : notes->items()) add_note(note, panel);
        }
        for (const JsonPlace& shown : place.at("show").items()) add_shown(shown, panel, report);
    }

    static void add_note(const JsonPlace& place, Panel& panel) {
        place.allow({"at", "text", "by", "color", "size", "align"});
        panels::Note note;
        note.at = point_at(place.at("at"));
        note.text = place.at("text").text();
        read(place, "color", note.color);
        read(place, "size", note.size, 1.0, 200.0);
        if (const auto by = place.find("by")) {
            const std::vector<JsonPlace> numbers = by->items();
            if (numbers.size() != 2) by->fail("must be two numbers, pixels");
            note.by = {numbers[0].number(-kFar, kFar), numbers[1].number(-kFar, kFar)};
        }
        constexpr panels::Align kAligns[] = {panels::Align::left, panels::Align::center, panels::Align::right};
        if (const auto align = place.find("align")) note.align = kAligns[align->word({"left", "center", "right"})];
        panel.notes.push_back(std::move(note));
    }

    void add_shown(const JsonPlace& place, Panel& panel, Report& report) {
        const std::string file = place.at("file").text();
        FileContents& contents = contents_.emplace_back(read_contents(file));
        if (contents.curves) {
            for (const std::string& warning : contents.curves->warnings()) report.warn(file + ": " + warning);
            add_curves(place, contents.curves->view(), panel);
        } else if (contents.skin) {
            add_skin(place, *contents.skin, panel);
        } else {
            add_mesh(place, *contents.mesh, panel);
        }
    }

    static void add_curves(const JsonPlace& place, const FlgCurveSetView& view, Panel& panel) {
        place.allow({"file", "as", "color", "color_end", "radius", "radius_scale", "sides", "round_ends", "gloss",
                     "shadow", "in_front", "curves", "magnitude"});
        panels::Layer layer{panels::Columns(view), {}};
        render::CurveLook& look = layer.look;
        constexpr render::Shape kShapes[] = {render::Shape::tube, render::Shape::ribbon, render::Shape::line};
        look.shape = render::Shape::tube;
        if (const auto as = place.find("as")) look.shape = kShapes[as->word({"tube", "ribbon", "lines"})];
        // What is said counts, whatever columns the curves bring.
        if (place.find("color")) layer.curves = layer.curves.without(FLG_ATTRIBUTE_COLOR);
        if (place.find("radius")) layer.curves = layer.curves.without(FLG_ATTRIBUTE_RADIUS);
        read(place, "color", look.color);
        look.color_end = look.color;
        read(place, "color_end", look.color_end);
        read(place, "radius", look.radius, 0.0, kFar);
        read(place, "radius_scale", look.radius_scale, 0.0, kFar);
        if (const auto sides = place.find("sides")) look.sides = sides->count(3, 32);
        bool round = true;
        read(place, "round_ends", round);
        if (!round) look.caps = render::Caps::none;
        read(place, "gloss", look.gloss, 0.0, 1.0);
        read(place, "shadow", look.casts_shadow);
        read(place, "in_front", look.in_front);
        if (const auto curves = place.find("curves")) {
            const std::vector<JsonPlace> range = curves->items();
            if (range.size() != 2) curves->fail("must be [first, count]");
            const uint32_t first = range[0].count(0, view.curve_count - 1);
            layer.curves = layer.curves.range(first, range[1].count(1, view.curve_count - first));
        }
        read(place, "magnitude", layer.magnitude_offset, -kFar, kFar);
        panel.layers.push_back(std::move(layer));
    }

    static void read_material(const JsonPlace& place, render::Material& material) {
        read(place, "color", material.color);
        read(place, "metallic", material.metallic, 0.0, 1.0);
        read(place, "roughness", material.roughness, 0.0, 1.0);
    }

    void add_mesh(const JsonPlace& place, const MeshFile& mesh, Panel& panel) {
        place.allow({"file", "color", "metallic", "roughness", "regions", "border", "border_color", "field", "every",
                     "line_width", "line_color"});
        panels::SurfaceLayer layer{mesh.view(), look_of(mesh), {}};
        render::SurfaceLook& look = layer.look;
        constexpr auto kLarger = static_cast<float>(panels::kOversampling);
        for (render::Material& material : look.regions) material.border_width_px *= kLarger;
        look.border_width_px *= kLarger;
        if (place.find("color")) {
            look.regions.clear();
            look.border_width_px = 0.0f;
        }
        read_material(place, look.material);
        if (const auto regions = place.find("regions")) {
            look.regions.clear();
            for (const JsonPlace& region : regions->items()) {
                region.allow({"color", "metallic", "roughness"});
                read_material(region, look.regions.emplace_back());
            }
        }
        if (const auto border = place.find("border")) {
            look.border_width_px = kLarger * border->number(0.0, 64.0);
            for (render::Material& material : look.regions) material.border_width_px = 0.0f;
        }
        read(place, "border_color", look.border_color);
        if (const auto field = place.find("field")) {
            const std::vector<float>& values = fields_.emplace_back(read_field_file(field->text()));
            if (values.size() != mesh.view().vertex_count)
                field->fail("has " + std::to_string(values.size()) + " values, but " + mesh.name() + " has " +
                            std::to_string(mesh.view().vertex_count) + " vertices");
            layer.field = values;
        }
        read(place, "every", look.isoline_spacing, 0.0, kFar);
        read(place, "line_width", look.isoline_width_px, 0.5, 32.0);
        look.isoline_width_px *= kLarger;
        read(place, "line_color", look.isoline_color);
        panel.surfaces.push_back(layer);
    }

    void add_skin(const JsonPlace& place, const SkinFile& skin, Panel& panel) {
        place.allow({"file", "time", "animation", "color", "metallic", "roughness"});
        PoseOptions pose;
        if (const auto time = place.find("time")) pose.time = time->real(-kFar, kFar);
        read(place, "animation", pose.animation);
        panels::SkinLayer layer{skin.view(), look_of(skin), pose_skin(skin, pose).transforms};
        if (place.find("color")) layer.look = {};
        read_material(place, layer.look.material);
        panel.skins.push_back(std::move(layer));
    }

    void aim_together(const std::vector<size_t>& members) {
        std::vector<glm::vec3> all;
        for (const size_t i : members) {
            const std::vector<glm::vec3> points = points_of(panels_[i]);
            all.insert(all.end(), points.begin(), points.end());
        }
        for (const size_t i : members) panels_[i].aim = all;
    }

    nlohmann::json json_;
    uint32_t width_ = 0, height_ = 0, columns_ = 1;
    std::deque<FileContents> contents_;
    std::deque<std::vector<float>> fields_;
    std::vector<Panel> panels_;
    std::map<std::string, std::vector<size_t>> groups_;  // panels of one camera
};

void run_panels(const Options& options, const CommonOptions& common) {
    if (!options.output.ends_with(".png")) throw UsageError(options.output + ": pictures are written as .png");
    require_writable(options.output);
    require_writable(common.report);
    Report report("panels", common);
    report.parameters["file"] = options.file;
    const Picture picture(options.file, report);
    say_step("starting the renderer");
    samples::calm_vulkan_loader();
    panels::Studio studio;
    say_step("drawing");
    panels::write_small_png(picture.taken_by(studio), options.output);
    report.quality["device"] = studio.renderer().device_name();
    report.write();
}

}  // namespace

Command add_panels(CLI::App& program, const CommonOptions& common) {
    CLI::App* app = program.add_subcommand("panels", "Draws several views side by side, with words, into one picture");
    const auto o = std::make_shared<Options>();
    app->add_option("PICTURE", o->file,
                    "What the panels show, JSON; samples/gallery/README.md describes it. Files are named as for "
                    "filigree render")
        ->required()
        ->type_name("PICTURE.json");
    app->add_option("-o,--output", o->output, "The picture, packed tightly")->required()->type_name("OUT.png");
    return {app, [o, &common] { run_panels(*o, common); }};
}

}  // namespace flg::cli
