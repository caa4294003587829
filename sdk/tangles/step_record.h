// SPDX-License-Identifier: MIT
// What a step was asked to do, with all that is needed to do it again: on the same mesh, or on another of its shape.
#pragma once

#include <optional>
#include <variant>

#include "tangles/tangle_displacement.h"
#include "tangles/tangle_macros.h"
#include "tangles/tangle_seeds.h"

namespace flg {

struct GroupRequest {
    std::pmr::vector<RegionId> regions;
};
struct UngroupRequest {
    uint32_t group = 0;
};
struct JoinRequest {
    std::pmr::vector<RegionId> regions;
};

// Regions by how they came about: what a step acts on where some of it is not there now.
struct WantedRegions {
    explicit WantedRegions(Memory* memory) : names(memory), regions(memory), a(memory), b(memory) {}

    struct Name {
        uint32_t step;       // that made it, by its identity; no_index: the root
        uint32_t operation;  // of the step
        uint32_t part;       // of the operation's partition
        uint32_t parent;     // a name before this one
        Position place;      // in it
        float reach;         // metres: what is farther away is another; 0: nothing is
    };
    std::pmr::vector<Name> names;
    // Of the request, and of the seeds of an operator; an ungrouping's: one of the group.
    std::pmr::vector<uint32_t> regions, a, b;
};

struct StepRecord {
    using Request = std::variant<DivideRequest, DisplaceRequest, GroupRequest, UngroupRequest, JoinRequest>;

    explicit StepRecord(Request what) : request(std::move(what)) {}

    Request request;
    // Of the first of a macro's operators, which are a step each: what they all come from.
    std::optional<MacroRequest> macro;
    // Of the first record of a step: all its regions, while some of them are not there. Those that are stand in the
    // request.
    std::shared_ptr<const WantedRegions> wanted;
    SeedAnchors a, b;  // of the operator
    // The first one it made; of an ungrouping: one of the group, or no_region.
    RegionId first_region = 0;
    Buffer<Position> places;  // inside each region it made
};

// Steps to be made and taken back together: a macro's, or a single one.
using StepRecords = std::pmr::vector<std::shared_ptr<StepRecord>>;

StepRecords record_step(StepRecord::Request request, Memory* memory);
StepRecords record_step(MacroRequest macro, Memory* memory);

// A copy that shares nothing which making it may change.
Task<std::shared_ptr<StepRecord>> copy_record(Pace& pace, const StepRecord& record);

// Remembers where the operator's points are, before it changes anything. Refuses points in triangles that do not exist.
Task<void> record_seeds(Pace& pace, const Mesh& mesh, StepRecord& record);

// Remembers a place inside each region from the record's first one on: the middle of the roomiest of the few triangles
// that are looked at. Cost: some ns a triangle of the regions, 1 us a region.
Task<void> record_places(Pace& pace, const Mesh& mesh, uint32_t region_count, StepRecord& record);

}  // namespace flg
