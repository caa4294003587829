// SPDX-License-Identifier: MIT
#include "tangles/region_names.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "runtime/each.h"

namespace flg {

namespace {

double apart(const Position& a, const Position& b) {
    return (load_vec3(a.data()) - load_vec3(b.data())).squaredNorm();
}

bool is_of_cells(const TangleStep& step) {
    const auto* const divide = std::get_if<DivideRequest>(&step.record->request);
    return divide && divide->desc.kind == FLG_TANGLE_OPERATOR_VORONOI;
}

// Pairs of old and new regions of one operator.
class Pairing {
public:
    Pairing(const TangleStep& before, const TangleStep& after, const RegionMap& map, const Groups& by_parent,
            Memory* memory)
        : before_(before),
          after_(after),
          map_(map),
          by_parent_(by_parent),
          any_part_(is_of_cells(before) || is_of_cells(after)),
          to_(before.tree.added().size(), memory),
          from_(after.tree.added().size(), memory),
          nearest_(from_.size(), memory) {}

    uint32_t old_count() const { return static_cast<uint32_t>(to_.size()); }
    uint32_t new_count() const { return static_cast<uint32_t>(from_.size()); }
    void clear_old(uint32_t i) { to_[i] = no_index; }
    void clear_new(uint32_t j) {
        from_[j] = no_index;
        nearest_[j] = std::numeric_limits<double>::infinity();
    }
    // The nearest new one of an old one, and of that one the nearest old one. Returns the work.
    uint32_t find_nearest(uint32_t i) {
        double least = std::numeric_limits<double>::infinity();
        const Position& place = before_.record->places[i];
        return visit(i, [&](uint32_t j) {
            const double distance = apart(place, after_.record->places[j]);
            if (distance < least) {
                least = distance;
                to_[i] = j;
            }
            if (distance < nearest_[j]) {
                nearest_[j] = distance;
                from_[j] = i;
            }
        });
    }
    void keep_mutual(uint32_t i) {
        if (to_[i] != no_index && from_[to_[i]] != i) to_[i] = no_index;
    }
    void release(uint32_t j) {
        if (from_[j] != no_index && to_[from_[j]] != j) from_[j] = no_index;
    }
    // The first new one that is left over.
    uint32_t take_left_over(uint32_t i) {
        if (to_[i] != no_index) return 1;
        return visit(i, [&](uint32_t j) {
            if (to_[i] != no_index || from_[j] != no_index) return;
            to_[i] = j;
            from_[j] = i;
        });
    }
    RegionId found(uint32_t i) const { return to_[i] == no_index ? no_region : after_.record->first_region + to_[i]; }

private:
    template <class Visit>
    uint32_t visit(uint32_t i, Visit visit) const {
        const RegionNode& old = before_.tree.added()[i];
        const RegionId parent = map_[old.parent];
        if (parent == no_region) return 1;
        uint32_t work = 1;
        for (const uint32_t j : by_parent_.of(parent)) {
            ++work;
            if (any_part_ || after_.tree.added()[j].part == old.part) visit(j);
        }
        return work;
    }

    const TangleStep &before_, &after_;
    const RegionMap& map_;
    const Groups& by_parent_;
    const bool any_part_;
    Buffer<uint32_t> to_, from_;
    Buffer<double> nearest_;
};

bool makes_regions(const TangleStep& step) {
    return step.state == StepState::made && !step.tree.added().empty() &&
           step.record->places.size() == step.tree.added().size();
}

// ---- Names

// The step that made a region, and its place among those that go on together.
struct Maker {
    const TangleStep* step = nullptr;
    uint32_t operation = 0;
};

Maker maker_of(const TangleSteps& steps, RegionId region) {
    Maker maker;
    for (const std::shared_ptr<TangleStep>& step : steps) {
        maker.operation = step->goes_on ? maker.operation + 1 : 0;
        const RegionId first = step->record->first_region;
        if (!makes_regions(*step) || region < first || region - first >= step->tree.added().size()) continue;
        maker.step = step.get();
        return maker;
    }
    return {};
}

// Names for regions before the edit, each once.
class Naming {
public:
    Naming(const TangleSteps& before, WantedRegions& wanted) : before_(before), wanted_(wanted) {}

    uint32_t name(RegionId region) {
        const Maker maker = maker_of(before_, region);
        if (!maker.step) return add({no_index, no_index, 0, no_index, {}, 0});
        const size_t place = region - maker.step->record->first_region;
        const RegionNode& node = maker.step->tree.added()[place];
        const uint32_t parent = name(node.parent);  // as deep as the tree
        return add({maker.step->identity, maker.operation, node.part, parent, maker.step->record->places[place],
                    reach(*maker.step, place)});
    }

private:
    // Half the way to the nearest region that differs in nothing else.
    static float reach(const TangleStep& step, size_t region) {
        const std::pmr::deque<RegionNode>& nodes = step.tree.added();
        const bool any_part = is_of_cells(step);
        double least = std::numeric_limits<double>::infinity();
        for (size_t i = 0; i < nodes.size(); ++i) {
            if (i == region || nodes[i].parent != nodes[region].parent) continue;
            if (!any_part && nodes[i].part != nodes[region].part) continue;
            least = std::min(least, apart(step.record->places[i], step.record->places[region]));
        }
        return std::isfinite(least) ? static_cast<float>(std::sqrt(least) / 2) : 0;
    }
    uint32_t add(const WantedRegions::Name& name) {
        for (uint32_t i = 0; i < wanted_.names.size(); ++i) {
            const WantedRegions::Name& other = wanted_.names[i];
            if (other.step == name.step && other.operation == name.operation && other.parent == name.parent &&
                other.part == name.part && other.place == name.place)
                return i;
        }
        wanted_.names.push_back(name);
        return static_cast<uint32_t>(wanted_.names.size() - 1);
    }

    const TangleSteps& before_;
    WantedRegions& wanted_;
};

// The region with a name, among those there are.
RegionId find(const TangleSteps& steps, const WantedRegions::Name& name, RegionId parent, uint32_t& work) {
    uint32_t operation = 0;
    work += static_cast<uint32_t>(steps.size());
    for (const std::shared_ptr<TangleStep>& step : steps) {
        operation = step->goes_on ? operation + 1 : 0;
        if (step->identity != name.step || operation != name.operation || !makes_regions(*step)) continue;
        RegionId best = no_region;
        const double reach = double{name.reach};
        double least = reach > 0 ? reach * reach : std::numeric_limits<double>::infinity();
        const bool any_part = is_of_cells(*step);
        work += static_cast<uint32_t>(step->tree.added().size());
        for (uint32_t i = 0; i < step->tree.added().size(); ++i) {
            const RegionNode& node = step->tree.added()[i];
            const double distance = apart(step->record->places[i], name.place);
            if (node.parent != parent || (!any_part && node.part != name.part) || !(distance < least)) continue;
            least = distance;
            best = step->record->first_region + i;
        }
        return best;
    }
    return no_region;
}

// By name; in the same order, those that are missed left out.
Task<RegionsFound> find_named(Pace& pace, const TangleSteps& after, const WantedRegions& wanted,
                              const std::array<std::pmr::vector<RegionId>*, 3>& lists) {
    Buffer<RegionId> found(wanted.names.size(), pace.memory());
    co_await each_by_work(pace, found.size(), Cost::tens_of_ns, [&](uint32_t i) {
        uint32_t work = 1;
        const WantedRegions::Name& name = wanted.names[i];
        const bool is_root = name.parent == no_index;
        const RegionId parent = is_root ? no_region : found[name.parent];
        found[i] = is_root ? 0 : parent == no_region ? no_region : find(after, name, parent, work);
        return work;
    });
    RegionsFound result;
    const std::array<const std::pmr::vector<uint32_t>*, 3> names = {&wanted.regions, &wanted.a, &wanted.b};
    for (size_t l = 0; l < lists.size(); ++l) {
        if (!lists[l]) continue;
        lists[l]->clear();
        co_await each(pace, names[l]->size(), Cost::tens_of_ns, [&](uint32_t i) {
            if (found[(*names[l])[i]] != no_region) lists[l]->push_back(found[(*names[l])[i]]);
        });
        result.wanted += names[l]->size();
        result.found += lists[l]->size();
        result.enough &= names[l]->empty() || !lists[l]->empty();
    }
    co_return result;
}

}  // namespace

Task<void> begin(Pace& pace, RegionMap& map, size_t count) {
    if (count <= map.base_) co_return;
    co_await each(pace, count - map.base_, Cost::tens_of_ns, [&](uint32_t) { map.now_.push_back(no_region); });
}

Task<void> follow_anew(Pace& pace, const TangleStep& before, const TangleStep& after, RegionMap& map) {
    if (!makes_regions(before) || !makes_regions(after)) co_return;
    const Groups by_parent = co_await group_by(pace, after.tree.added().size(), after.record->first_region,
                                               [&](uint32_t j) { return after.tree.added()[j].parent; });
    Pairing pairing(before, after, map, by_parent, pace.memory());
    const uint32_t olds = pairing.old_count(), news = pairing.new_count();
    co_await each(pace, olds, Cost::some_ns, [&](uint32_t i) { pairing.clear_old(i); });
    co_await each(pace, news, Cost::some_ns, [&](uint32_t j) { pairing.clear_new(j); });
    co_await each_by_work(pace, olds, Cost::tens_of_ns, [&](uint32_t i) { return pairing.find_nearest(i); });
    co_await each(pace, olds, Cost::some_ns, [&](uint32_t i) { pairing.keep_mutual(i); });
    co_await each(pace, news, Cost::some_ns, [&](uint32_t j) { pairing.release(j); });
    co_await each_by_work(pace, olds, Cost::tens_of_ns, [&](uint32_t i) { return pairing.take_left_over(i); });
    co_await each(pace, olds, Cost::some_ns,
                  [&](uint32_t i) { map.set(before.record->first_region + i, pairing.found(i)); });
}

RegionLists lists_of(StepRecord::Request& request) {
    if (auto* const divide = std::get_if<DivideRequest>(&request))
        return {&divide->regions, &divide->a.regions, &divide->b.regions};
    if (auto* const displace = std::get_if<DisplaceRequest>(&request)) return {&displace->regions};
    if (auto* const group = std::get_if<GroupRequest>(&request)) return {&group->regions};
    if (auto* const join = std::get_if<JoinRequest>(&request)) return {&join->regions};
    return {};
}

Task<RegionsFound> find_regions(Pace& pace, const RegionTree& tree, const TangleSteps& before, const TangleSteps& after,
                                const RegionMap& map, StepRecords& records) {
    Memory* const memory = pace.memory();
    StepRecord& record = *records[0];
    auto* const ungroup = std::get_if<UngroupRequest>(&record.request);
    std::pmr::vector<RegionId> grouped(memory);  // one of the group
    if (ungroup && record.first_region != no_region) grouped.push_back(record.first_region);
    const RegionLists own = lists_of(record.request);
    const std::array<std::pmr::vector<RegionId>*, 3> lists = {ungroup ? &grouped : own.regions, own.a, own.b};
    bool all = !record.wanted;
    for (std::pmr::vector<RegionId>* list : lists)
        if (list && all)
            co_await each(pace, list->size(), Cost::tens_of_ns,
                          [&](uint32_t i) { all &= map[(*list)[i]] != no_region; });
    if (!all && !record.wanted) {
        const auto wanted =
            std::allocate_shared<WantedRegions>(std::pmr::polymorphic_allocator<WantedRegions>(memory), memory);
        Naming naming(before, *wanted);
        const std::array<std::pmr::vector<uint32_t>*, 3> names = {&wanted->regions, &wanted->a, &wanted->b};
        for (size_t l = 0; l < lists.size(); ++l)
            if (lists[l])
                co_await each(pace, lists[l]->size(), Cost::microseconds,
                              [&](uint32_t i) { names[l]->push_back(naming.name((*lists[l])[i])); });
        record.wanted = wanted;
    }
    RegionsFound result;
    if (record.wanted) {
        const std::shared_ptr<const WantedRegions> wanted = record.wanted;
        result = co_await find_named(pace, after, *wanted, lists);
        if (result.found == result.wanted) record.wanted = nullptr;
    } else {
        for (std::pmr::vector<RegionId>* list : lists)
            if (list)
                co_await each(pace, list->size(), Cost::tens_of_ns, [&](uint32_t i) { (*list)[i] = map[(*list)[i]]; });
    }
    if (ungroup && !grouped.empty()) {
        record.first_region = grouped[0];
        ungroup->group = tree[tree.resolve(grouped[0])].group;
    }
    if (record.macro) record.macro->regions = *own.regions;
    for (size_t r = 1; r < records.size(); ++r) *lists_of(records[r]->request).regions = *own.regions;
    co_return result;
}

}  // namespace flg
