// SPDX-License-Identifier: MIT
// Scripts of tangles: a list of operations that anyone can read and write. sdk/tangles/README.md describes it.
#pragma once

#include <array>
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "documents/json_place.h"
#include "documents/mesh_surface.h"
#include "documents/tangle_materials.h"
#include "filigree/filigree_spline.h"
#include "filigree/filigree_tangle.h"

namespace flg::cli {

class TangleScript {
public:
    // Makes the tangle of the surface. Throws InputError, as does all below.
    TangleScript(Session& session, const MeshSurface& surface, Report& report);

    // Runs all operations of a script, a JSON value of the file `name`. `has_own_materials`: of the mesh, kept where
    // the script gives none.
    void run(const nlohmann::json& script, const std::string& name, bool has_own_materials);

    FlgTangle tangle() const { return tangle_; }
    FlgTangleInfo info() const;
    FlgTangleRegion region(uint32_t region) const;
    // Those of the script that was run.
    const TangleMaterials& materials() const { return materials_; }

private:
    // What an operation was applied to, and what it made that it did not divide further.
    struct Result {
        std::vector<uint32_t> applied, made;
        bool muted = false;  // or left out
    };

    void run_operation(const JsonPlace& operation);
    void mute_from(const JsonPlace& operation, uint32_t first);
    bool mutes_any(const JsonPlace& selection) const;
    void keep_result(const JsonPlace& operation, Result result);
    void divide(const JsonPlace& operation, FlgTangleOperator kind, const std::vector<uint32_t>& regions);
    void apply_macro(const JsonPlace& operation, FlgTangleMacro kind, const std::vector<uint32_t>& regions);
    void displace(const JsonPlace& operation, const std::vector<uint32_t>& regions);
    void stylize_borders(const JsonPlace& operation, const std::vector<uint32_t>& regions);
    void cut_shapes(const JsonPlace& operation, const std::vector<uint32_t>& regions);
    void cut_spline(const JsonPlace& operation, const std::vector<uint32_t>& regions);
    void cut_lines(const JsonPlace& operation, const std::vector<uint32_t>& regions, FlgSurfaceCurves lines);
    void read_groups(const JsonPlace& operation, FlgTangleDivideDesc& desc) const;
    std::vector<uint32_t> leaves_of(const std::vector<uint32_t>& regions) const;
    std::map<uint32_t, std::vector<uint32_t>> won_regions(const std::vector<uint32_t>& others, uint32_t first) const;
    std::string file_of(const JsonPlace& place) const;
    std::vector<uint32_t> select(const JsonPlace& selection) const;
    std::vector<uint32_t> select_by_name(const JsonPlace& place) const;
    std::vector<uint32_t> select_inside(const JsonPlace& selection) const;
    bool is_of(uint32_t region, const std::string& which) const;
    void take_materials(const JsonPlace& list, bool has_own);
    float length(const JsonPlace& place) const;
    // Of a length in the script's unit.
    float in_metres(float length) const { return static_cast<float>(unit_ * double{length}); }
    void finish(FlgJob job, const JsonPlace& subject);

    struct SeedArrays {
        std::vector<FlgBorderStretch> stretches;
        std::vector<FlgSurfacePoint> points;
        std::vector<uint32_t> regions;
    };
    FlgTangleSeeds read_seeds(const JsonPlace& seeds, SeedArrays& arrays) const;

    Session& session_;
    const MeshSurface& surface_;
    Report& report_;
    FlgTangle tangle_ = {};
    double unit_ = 1;  // metres a length of the script
    std::map<std::string, Result> results_;
    TangleMaterials materials_;
    FlgManifold spline_manifold_ = {};  // of the surface, once it was needed; lives as long as the context
    std::filesystem::path folder_;      // of the script, which files are named from
};

}  // namespace flg::cli
