// SPDX-License-Identifier: MIT
#include "workspaces.h"

namespace flg::studio {
namespace {

class Strokes final : public Workspace {
public:
    using Workspace::Workspace;
    const char* title() const override { return "Strokes"; }
    std::string help() const override { return "Drag to draw."; }
    void update() override {}
    void panel() override {}
    void pointer(const Pointer&) override {}
    void overlay(ImDrawList&) override {}
    bool shortcut(const Chord&) override { return false; }
    std::span<const Shortcut> shortcuts() const override { return {}; }
    bool can_undo() const override { return false; }
    bool can_redo() const override { return false; }
    void undo() override {}
    void redo() override {}
    bool open(const std::string&) override { return false; }
    nlohmann::json save() const override { return {}; }
    void load(const nlohmann::json&) override {}
    void device_lost() override {}
    double count(const std::string&) const override { return 0; }
};

}  // namespace

std::unique_ptr<Workspace> make_strokes(Desk& desk) {
    return std::make_unique<Strokes>(desk);
}

}  // namespace flg::studio
