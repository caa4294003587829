// SPDX-License-Identifier: MIT
// Finished pieces: scripts of samples/tangles on forms made here, run as `filigree tangle` runs them.
#include <algorithm>
#include <cstdio>
#include <deque>
#include <filesystem>
#include <set>
#include <thread>

#include "documents/tangle_script.h"
#include "gallery/forms.h"
#include "gallery/looks.h"
#include "gallery/marks.h"
#include "gallery/pictures.h"
#include "support/curve_source.h"

namespace flg::gallery {
namespace {

struct Piece {
    const char* name;  // of the script and of the picture
    filigree::Surface (*form)(Workshop& workshop);
    glm::vec3 sight;
    uint32_t width, height;
};

// Removed again.
class TemporaryFile {
public:
    explicit TemporaryFile(const char* name) : path_(std::filesystem::temp_directory_path() / name) {}
    ~TemporaryFile() {
        std::error_code ignored;
        std::filesystem::remove(path_, ignored);
    }
    TemporaryFile(const TemporaryFile&) = delete;
    TemporaryFile& operator=(const TemporaryFile&) = delete;
    std::string name() const { return path_.string(); }

private:
    std::filesystem::path path_;
};

std::vector<render::Material> materials_of(const cli::TangleMaterials& decor) {
    constexpr float kOversampling = 2.0f;  // the picture is averaged from a larger one
    std::vector<render::Material> materials;
    for (const FlgMeshMaterial& from : decor.table) {
        materials.push_back({.color = {from.color[0], from.color[1], from.color[2]},
                             .metallic = from.metallic,
                             .roughness = from.roughness,
                             .border_width_px = kOversampling * from.border_width_px,
                             .border_color = {from.border_color[0], from.border_color[1], from.border_color[2]}});
    }
    return materials;
}

// A script's first operations, and the materials that need no others.
nlohmann::json first_operations(nlohmann::json script, size_t count) {
    nlohmann::json operations = nlohmann::json::array(), materials = nlohmann::json::array();
    std::set<std::string> names = {"default", "root"};
    for (size_t i = 0; i < count; ++i) {
        operations.push_back(script.at("operations").at(i));
        names.insert(operations.back().value("name", ""));
    }
    for (const nlohmann::json& material : script.at("materials")) {
        const std::string on = material.at("on").get<std::string>();
        if (names.contains(on.substr(0, on.find('.')))) materials.push_back(material);
    }
    script["operations"] = std::move(operations);
    script["materials"] = std::move(materials);
    return script;
}

// What a script makes of a form. Kept until the picture is taken.
class Decorated {
public:
    // `form` is a file.
    Decorated(const std::string& form, const nlohmann::json& script, const std::string& name)
        : report_("tangle", common()),
          session_(common()),
          surface_(session_, form, 0.0f, report_),
          script_(session_, surface_, report_) {
        script_.run(script, name);
        const FlgMeshView mesh = surface_.view().mesh;
        labels_.assign(mesh.regions, mesh.regions + mesh.triangle_count);
        for (uint32_t& label : labels_) label = script_.materials().of_region[label];
    }

    SurfaceLayer layer() const {
        SurfaceLayer layer{surface_.view().mesh, {}};
        layer.look.regions = materials_of(script_.materials());
        layer.mesh.regions = labels_.data();
        return layer;
    }

private:
    static const cli::CommonOptions& common() {
        static const cli::CommonOptions options = {
            .report = "", .workers = std::max(1u, std::thread::hardware_concurrency()), .quiet = true};
        return options;
    }

    cli::Report report_;
    cli::Session session_;
    cli::MeshSurface surface_;
    cli::TangleScript script_;
    std::vector<uint32_t> labels_;
};

Panel panel_of(const Decorated& decorated, const glm::vec3& sight) {
    Panel panel;
    panel.surfaces = {decorated.layer()};
    panel.sight = sight;
    panel.margin = 1.02f;
    return panel;
}

std::string script_file(const char* name) {
    return std::string(FLG_TANGLE_SCRIPTS) + "/" + name + ".json";
}

void draw(const Piece& piece, Workshop& workshop, Studio& studio) {
    const TemporaryFile form((std::string("filigree_gallery_") + piece.name + ".ply").c_str());
    write_form(piece.form(workshop), form.name());
    const std::string file = script_file(piece.name);
    const Decorated decorated(form.name(), cli::JsonPlace::read(file), file);
    const Panel panel = panel_of(decorated, piece.sight);
    studio.take(piece.name, {&panel, 1}, 1, piece.width, piece.height);
}

// The script that sdk/tangles/README.md explains, operation by operation.
void explained(Workshop& workshop, Studio& studio) {
    const TemporaryFile form("filigree_gallery_dots.ply");
    write_form(ball(workshop), form.name());
    const std::string file = script_file("dots");
    const nlohmann::json script = cli::JsonPlace::read(file);
    std::deque<Decorated> stages;
    std::vector<Panel> panels;
    for (size_t count = 1; count <= script.at("operations").size(); ++count) {
        stages.emplace_back(form.name(), first_operations(script, count), file);
        panels.push_back(panel_of(stages.back(), {-0.3f, -0.35f, -1.0f}));
    }
    entitle(panels, {"1 contour: bands", "2 contour: dots", "3 displace: dots"});
    studio.take("tangle_script", panels, static_cast<uint32_t>(panels.size()), 960, 320);
}

// The script `waves` with the borders as they come, and as it redraws them after a stroke.
void waves(Workshop& workshop, Studio& studio) {
    constexpr glm::vec3 kSight = {-0.15f, -1.0f, -0.75f};
    const TemporaryFile form("filigree_gallery_waves.ply");
    write_form(dish(workshop), form.name());
    const std::string file = script_file("waves");
    const nlohmann::json script = cli::JsonPlace::read(file);
    nlohmann::json plain = script;
    plain["operations"].erase(1);
    plain["operations"][1]["on"] = "islands.foreground";
    const samples::CurveSource stroke(std::string(FLG_TANGLE_SCRIPTS) + "/waves.xyz");
    const Decorated before(form.name(), plain, file), after(form.name(), script, file);
    std::vector<Panel> panels = {panel_of(before, kSight), gallery::panel_of(stroke.view(), tube(kInk, 0.08f)),
                                 panel_of(after, kSight)};
    panels[0].title = "Borders as they are cut";
    panels[1].title = "a drawn stroke";
    panels[1].sight = {0.0f, 0.0f, -1.0f};
    panels[1].ground = false;
    panels[2].title = "borders redrawn in its style";
    for (Panel& panel : panels) panel.margin = 1.06f;
    studio.take("waves", panels, 3, kWidth, 320);
}

// Forms as they are made, and decorated by their scripts.
void before_and_after(Workshop& workshop, Studio& studio) {
    const struct {
        const char* name;
        filigree::Surface (*form)(Workshop& workshop);
        glm::vec3 sight;
    } kPieces[] = {{"vase", [](Workshop& w) { return vase(w, kFineVase); }, {-0.25f, -0.22f, -1.0f}},
                   {"cat", [](Workshop& w) { return cat(w, kFineCat); }, {-0.55f, -0.25f, -1.0f}}};
    std::deque<filigree::Surface> forms;
    std::deque<Decorated> decorated;
    std::vector<Panel> panels;
    for (const auto& piece : kPieces) {
        const TemporaryFile form((std::string("filigree_gallery_before_") + piece.name + ".ply").c_str());
        forms.push_back(piece.form(workshop));
        write_form(forms.back(), form.name());
        const std::string file = script_file(piece.name);
        decorated.emplace_back(form.name(), cli::JsonPlace::read(file), file);
        Panel& before = panels.emplace_back();
        before.surfaces = {{forms.back().view().mesh, {}}};
        before.surfaces[0].look.material = {glm::vec3(0.55f), 0.0f, 0.6f};
        before.sight = piece.sight;
        before.margin = 1.05f;
        const uint32_t triangles = before.surfaces[0].mesh.triangle_count;
        char words[40];
        std::snprintf(words, sizeof words, "%u,%03u triangles", triangles / 1000, triangles % 1000);
        before.title = words;
        Panel& after = panels.emplace_back(panel_of(decorated.back(), piece.sight));
        after.margin = 1.05f;
        after.title = std::string("decorated by ") + piece.name + ".json";
    }
    studio.take("tangle_models", panels, 4, 1200, 380);
}

// The script of the cat, from the bare form through its first eleven operations.
void eleven_steps(Workshop& workshop, Studio& studio) {
    constexpr size_t kSteps = 11;
    const TemporaryFile form("filigree_gallery_steps.ply");
    write_form(cat(workshop), form.name());
    const std::string file = script_file("cat");
    nlohmann::json script = cli::JsonPlace::read(file);
    // What later operations paint over.
    script["materials"].insert(script["materials"].begin() + 1,
                               {{{"on", "spots.foreground"}, {"name", "spots"}, {"color", "#c9803a"}},
                                {{"on", "rims.background"}, {"name", "inside"}, {"color", "#f7e8cf"}},
                                {{"on", "hearts.foreground"}, {"name", "hearts"}, {"color", "#e2553d"}}});
    std::deque<Decorated> stages;
    std::vector<Panel> panels;
    for (size_t count = 0; count <= kSteps; ++count) {
        stages.emplace_back(form.name(), first_operations(script, count), file);
        Panel& panel = panels.emplace_back(panel_of(stages.back(), {-0.55f, -0.25f, -1.0f}));
        panel.aim = around({0.262f, 0.36f, 0.198f}, 0.13f);  // no tail behind titles
        if (count == 0) {
            panel.title = "The form";
            continue;
        }
        const nlohmann::json& operation = script.at("operations").at(count - 1);
        const std::string on = operation.at("on").get<std::string>();
        panel.title = std::to_string(count) + " " + operation.at("op").get<std::string>() + ": " +
                      operation.value("name", on.substr(0, on.find('.')));
    }
    studio.take("tangle_steps", panels, 4, 1200, 900);
}

constexpr Piece kEgg = {"egg", egg, {-0.30f, -0.26f, -1.0f}, 480, 592};
constexpr Piece kVase = {
    "vase", [](Workshop& workshop) { return vase(workshop, kFineVase); }, {-0.25f, -0.22f, -1.0f}, 560, 760};
constexpr Piece kCat = {
    "cat", [](Workshop& workshop) { return cat(workshop, kFineCat); }, {-0.55f, -0.25f, -1.0f}, 720, 576};

constexpr Piece kClovers = {"clovers", dish, {-0.2f, -0.62f, -1.0f}, 640, 448};

constexpr Picture kPictures[] = {
    {"tangle_script", "A script of three operations, one after the other", true, explained},
    {"egg", "An egg of gold, enamel and pearls, 1.5 million triangles", true,
     [](Workshop& workshop, Studio& studio) { draw(kEgg, workshop, studio); }},
    {"vase", "A vase in the glazes of a potter", true,
     [](Workshop& workshop, Studio& studio) { draw(kVase, workshop, studio); }},
    {"clovers", "A drawing in every cell", true,
     [](Workshop& workshop, Studio& studio) { draw(kClovers, workshop, studio); }},
    {"tangle_models", "Fig. 1: forms as they are made, and decorated", true, before_and_after},
    {"tangle_steps", "Fig. 4: eleven operations, one after the other", true, eleven_steps},
    {"waves", "Borders redrawn after a stroke", true, waves},
    {"cat", "A cat for a feast", true, [](Workshop& workshop, Studio& studio) { draw(kCat, workshop, studio); }},
};

}  // namespace

std::span<const Picture> piece_pictures() {
    return kPictures;
}

}  // namespace flg::gallery
