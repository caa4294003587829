// SPDX-License-Identifier: MIT
// Scripts of tangles: a list of operations that anyone can read and write. sdk/tangles/README.md describes it.
#pragma once

#include <array>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "filigree/filigree_tangle.h"
#include "json_place.h"
#include "mesh_surface.h"

namespace flg::cli {

class TangleScript {
public:
    // Makes the tangle of the surface. Throws InputError, as does all below.
    TangleScript(Session& session, const MeshSurface& surface, Report& report);

    // Runs all operations of a script, a JSON value of the file `name`.
    void run(const nlohmann::json& script, const std::string& name);

    FlgTangle tangle() const { return tangle_; }
    FlgTangleInfo info() const;
    FlgTangleRegion region(uint32_t region) const;

private:
    // What an operation was applied to, and what it made.
    struct Result {
        std::vector<uint32_t> applied, made;
    };

    void run_operation(const JsonPlace& operation);
    void divide(const JsonPlace& operation, FlgTangleOperator kind, const std::vector<uint32_t>& regions);
    void apply_macro(const JsonPlace& operation, FlgTangleMacro kind, const std::vector<uint32_t>& regions);
    void displace(const JsonPlace& operation, const std::vector<uint32_t>& regions);
    std::vector<uint32_t> select(const JsonPlace& selection) const;
    std::vector<uint32_t> select_by_name(const JsonPlace& place) const;
    float length(const JsonPlace& place) const;
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
};

}  // namespace flg::cli
