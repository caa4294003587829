// SPDX-License-Identifier: MIT
#include "support/curve_source.h"

#include <charconv>
#include <cmath>
#include <utility>

namespace flg::samples {
namespace {

constexpr std::string_view kPrefix = "builtin:";

std::string known_names() {
    std::string names;
    for (const auto* list : {&scenes::library_names(), &scenes::target_names(), &scenes::scene_names()}) {
        for (const std::string& name : *list) names += (names.empty() ? "" : ", ") + name;
    }
    return names;
}

}  // namespace

CurveSource::CurveSource(const std::string& name) : name_(name), view_(flgCurveSetViewDefaults()) {
    if (name.starts_with(kPrefix)) {
        make(std::string_view(name).substr(kPrefix.size()));
        return;
    }
    if (flgCurveFileRead(name.c_str(), nullptr, &file_) != FLG_OK) throw SourceError(flgIoErrorGetMessage());
    if (flgCurveFileGetView(file_, &view_) != FLG_OK) {
        flgCurveFileRelease(file_);
        throw SourceError(flgIoErrorGetMessage());
    }
    if (view_.curve_count == 0) {
        flgCurveFileRelease(file_);
        throw SourceError(name + ": no curves in it");
    }
}

CurveSource::~CurveSource() {
    flgCurveFileRelease(file_);
}

CurveSource::CurveSource(CurveSource&& other) noexcept
    : name_(std::move(other.name_)),
      view_(other.view_),
      file_(std::exchange(other.file_, nullptr)),
      arrays_(std::move(other.arrays_)),
      network_(other.network_) {}

void CurveSource::make(std::string_view builtin) {
    const std::string_view name = builtin.substr(0, builtin.find(':'));
    uint32_t count = 0;
    if (name.size() < builtin.size()) {
        const std::string_view text = builtin.substr(name.size() + 1);
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), count);
        if (error != std::errc() || end != text.data() + text.size() || count < 2) {
            throw SourceError(name_ + ": '" + std::string(text) +
                              "' is not a number of points or curves (2 to 100000000)");
        }
    }
    scenes::Scene scene = scenes::make_scene(name, count);
    if (scene.curves.empty()) {
        scene.curves.push_back(scenes::make_style(name));
        if (scene.curves[0].points.empty()) scene.curves[0] = scenes::make_target(name, count);
        if (scene.curves[0].points.empty()) {
            throw SourceError(name_ + ": no such built-in curve; there are " + known_names());
        }
    }
    network_ = scene.network;
    arrays_ = CurveArrays(scene.curves);
    view_ = arrays_.view();
}

std::vector<std::string> CurveSource::warnings() const {
    std::vector<std::string> list;
    FlgCurveFileInfo info = {};
    info.struct_size = sizeof info;
    if (file_ != nullptr && flgCurveFileGetInfo(file_, &info) == FLG_OK) {
        for (uint32_t i = 0; i < info.warning_count; ++i) list.emplace_back(info.warnings[i]);
    }
    return list;
}

CurveRange::CurveRange(const FlgCurveSetView& view, uint32_t first, uint32_t count)
    : offsets_(view.curve_offsets + first, view.curve_offsets + first + count + 1),
      columns_(view.columns, view.columns + view.column_count),
      view_(view) {
    const uint32_t start = offsets_[0];
    for (uint32_t& offset : offsets_) offset -= start;
    for (FlgColumn& column : columns_) column.data = value_at(column, start);
    view_.curve_count = count;
    view_.curve_offsets = offsets_.data();
    if (view.curve_flags != nullptr) view_.curve_flags = view.curve_flags + first;
    view_.columns = columns_.data();
}

PointRange::PointRange(const FlgCurveSetView& view, uint32_t first)
    : columns_(view.columns, view.columns + view.column_count), view_(view) {
    if (view.curve_count > 0) offsets_[1] = view.curve_offsets[1] - first;
    for (FlgColumn& column : columns_) column.data = value_at(column, first);
    view_.curve_count = offsets_[1] > 0 ? 1 : 0;
    view_.curve_offsets = offsets_;
    view_.columns = columns_.data();
}

const FlgColumn* find_column(const FlgCurveSetView& view, FlgAttribute attribute) {
    for (uint32_t i = 0; i < view.column_count; ++i) {
        if (view.columns[i].attribute == attribute) return &view.columns[i];
    }
    return nullptr;
}

double curve_length(const FlgCurveSetView& view, uint32_t index) {
    const FlgColumn& positions = *find_column(view, FLG_ATTRIBUTE_POSITION);
    const uint32_t first = view.curve_offsets[index], end = view.curve_offsets[index + 1];
    const auto distance = [&](uint32_t i, uint32_t j) {
        const float *p = value_at(positions, i), *q = value_at(positions, j);
        return std::hypot(static_cast<double>(q[0]) - p[0], static_cast<double>(q[1]) - p[1],
                          static_cast<double>(q[2]) - p[2]);
    };
    double length = 0.0;
    for (uint32_t i = first; i + 1 < end; ++i) length += distance(i, i + 1);
    const bool closed = view.curve_flags != nullptr && (view.curve_flags[index] & FLG_CURVE_CLOSED) != 0;
    return closed && end > first ? length + distance(end - 1, first) : length;
}

}  // namespace flg::samples
