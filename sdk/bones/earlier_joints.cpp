// SPDX-License-Identifier: MIT
#include "bones/earlier_joints.h"

#include <charconv>
#include <string_view>

#include "runtime/each.h"

namespace flg {
namespace {

constexpr uint32_t max_kept_number = 1000000;  // numbers that are taken are listed

// Of a key NAME_NUMBER, maybe with .L or .R.
struct OwnKey {
    std::string_view name, side;
    uint32_t number = no_number;  // no_number: it is of another kind
};

OwnKey read_key(std::string_view key) {
    OwnKey own;
    if (key.ends_with(".L") || key.ends_with(".R")) {
        own.side = key.substr(key.size() - 2);
        key.remove_suffix(2);
    }
    const size_t last = key.rfind('_');
    if (last == std::string_view::npos) return own;
    const char *begin = key.data() + last + 1, *end = key.data() + key.size();
    uint32_t number = 0;
    const auto [stop, error] = std::from_chars(begin, end, number);
    if (error != std::errc() || stop != end || begin == end || number > max_kept_number) return own;
    own.name = key.substr(0, last);
    own.number = number;
    return own;
}

}  // namespace

Task<EarlierParts> EarlierParts::find(Pace& pace, const HeldModel& model) {
    EarlierParts out(pace.memory());
    co_await read_edits(pace, model, out);
    if (!model.previous) {
        co_await read_kept(pace, model, out);
        co_return out;
    }
    const HeldModel& before = *model.previous;
    out.parts_.reserve(before.parts.size());
    co_await each(pace, before.parts.size(), Cost::hundreds_of_ns, [&](uint32_t p) {
        const ModelPart& part = before.parts[p];
        const size_t begin = before.own_begins[p], count = before.own_counts[p];
        out.parts_.emplace(std::pmr::string(part.name, pace.memory()).append(part.suffix),
                           EarlierJoints{std::span(before.own_joints).subspan(begin, count),
                                         std::span(before.own_numbers).subspan(begin, count),
                                         {}});
    });
    co_return out;
}

// A key without its side means both.
Task<void> EarlierParts::read_edits(Pace& pace, const HeldModel& model, EarlierParts& out) {
    co_await each(pace, model.edits.size(), Cost::hundreds_of_ns, [&](uint32_t e) {
        const OwnKey key = read_key(model.edits[e].joint);
        if (key.number == no_number) return;
        const std::pmr::string name(key.name, pace.memory());
        for (const char* side : {"", ".L", ".R"})
            if (key.side.empty() || key.side == side)
                out.awaited_[std::pmr::string(name).append(side)].push_back(key.number);
    });
}

Task<void> EarlierParts::read_kept(Pace& pace, const HeldModel& model, EarlierParts& out) {
    const auto& kept = model.kept_joints;
    if (kept.empty()) co_return;
    std::pmr::unordered_map<std::pmr::string, uint32_t> part_of_name(pace.memory());
    part_of_name.reserve(model.parts.size());
    co_await each(pace, model.parts.size(), Cost::hundreds_of_ns, [&](uint32_t p) {
        part_of_name.emplace(std::pmr::string(model.parts[p].name, pace.memory()).append(model.parts[p].suffix), p);
    });
    Buffer<uint32_t> part(kept.size(), pace.memory());
    co_await each(pace, kept.size(), Cost::hundreds_of_ns, [&](uint32_t j) {
        const OwnKey key = read_key(kept[j].key);
        const auto found = part_of_name.find(std::pmr::string(key.name, pace.memory()).append(key.side));
        part[j] = key.number == no_number || found == part_of_name.end() ? no_key : found->second;
    });
    const Groups joints = co_await group_by(pace, kept.size(), model.parts.size(), [&](uint32_t j) { return part[j]; });
    Buffer<uint32_t> place(kept.size(), pace.memory());
    out.joints_.reserve(kept.size());
    out.numbers_.reserve(kept.size());
    Slice slice(Cost::tens_of_ns);
    for (uint32_t p = 0; p < model.parts.size(); ++p) {
        const size_t begin = out.joints_.size();
        for (const uint32_t j : joints.of(p)) {
            // Where other parts hang there are joints between.
            uint32_t before = kept[j].parent;
            for (; before != no_number && part[before] != p; before = kept[before].parent)
                if (slice.is_over()) co_await pace;
            place[j] = static_cast<uint32_t>(out.joints_.size() - begin);
            // They hang together, if only by a joint of another kind, as in the middle of a trunk.
            const uint32_t root = place[j] == 0 ? no_joint_before : 0;
            out.joints_.push_back({kept[j].at, before == no_number ? root : place[before]});
            out.numbers_.push_back(read_key(kept[j].key).number);
            if (slice.is_over(4)) co_await pace;
        }
        if (out.joints_.size() == begin) continue;
        const size_t count = out.joints_.size() - begin;
        out.parts_.emplace(
            std::pmr::string(model.parts[p].name, pace.memory()).append(model.parts[p].suffix),
            EarlierJoints{{out.joints_.data() + begin, count}, {out.numbers_.data() + begin, count}, {}});
    }
}

EarlierJoints EarlierParts::of(const ModelPart& part) const {
    if (parts_.empty()) return {};
    const std::pmr::string name = std::pmr::string(part.name, parts_.get_allocator().resource()).append(part.suffix);
    const auto found = parts_.find(name);
    if (found == parts_.end()) return {};
    EarlierJoints joints = found->second;
    if (const auto awaited = awaited_.find(name); awaited != awaited_.end()) joints.awaited = awaited->second;
    return joints;
}

}  // namespace flg
