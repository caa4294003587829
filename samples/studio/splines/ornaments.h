// SPDX-License-Identifier: MIT
// Built-in styles, prepared when first asked for; and a curve decorated with one, kept up to date as the curve changes.
#pragma once

#include <map>
#include <memory>
#include <span>
#include <string>

#include "shell/workspace.h"
#include "splines/curve_solver.h"

namespace flg::studio::splines {

std::span<const char* const> style_names();

class StyleCache {
public:
    explicit StyleCache(AppContext& app) : app_(app) {}
    // Null until it is prepared; throws StudioError for a name that there is none of.
    const filigree::Style* find(const std::string& name);

private:
    AppContext& app_;
    std::map<std::string, filigree::Style> styles_;
};

class Decorator {
public:
    Decorator(AppContext& app, StyleCache& style_cache) : app_(app), style_cache_(style_cache) {}

    // The curve as it is now, lifted by `height` along its normals.
    void update(const FoundCurve& found, uint64_t version, const Ornament& ornament, float height,
                const std::string& name);
    bool busy() const { return ended_ != nullptr || wants_; }
    // Empty while there is nothing.
    const filigree::CurveSet& result() const { return result_; }
    uint64_t version() const { return version_; }

private:
    struct Wanted {
        uint64_t version = 0;
        Ornament ornament;
        float height = 0.0f;
        bool operator==(const Wanted&) const = default;
    };
    struct Ended {
        bool done = false, good = false;
    };

    AppContext& app_;
    StyleCache& style_cache_;
    Wanted submitted_;
    bool wants_ = false;
    filigree::CurveSet running_, result_;
    std::shared_ptr<Ended> ended_;
    uint64_t version_ = 0;
};

// A curve's nodes as the renderer and files take them. Must outlive its view.
class NodeArrays {
public:
    NodeArrays(const FoundCurve& found, float height);
    FlgCurveSetView view() const;

private:
    std::vector<glm::vec3> positions_;
    const std::vector<glm::vec3>& normals_;
    uint32_t offsets_[2];
    uint8_t flags_[1];
    FlgColumn columns_[2];
};

}  // namespace flg::studio::splines
