// SPDX-License-Identifier: MIT
// Documents of tangles: a history as JSON that can be read, with a side file of the arrays that are longer than a line.
//
// The side file has the arrays one behind the other, in the order in which the JSON names them: words of 4 bytes,
// little-endian. The JSON names it, with its size and the checksum of its bytes.
#pragma once

#include "filigree/filigree_tangle.h"
#include "io/base/files.h"
#include "io/base/json_value.h"
#include "io/base/memory.h"

namespace flg::io {

// Documents whose steps all are made, without names of regions, have the first version; others the second.
constexpr uint32_t tangle_document_version = 1, edited_document_version = 2;
// What the JSON calls the values of FlgTangleOperator, FlgTangleMacro, FlgTangleBorders and FlgTangleGrouping, and
// other steps.
inline constexpr const char* operator_words[] = {"contour", "stream", "voronoi", "polyline"};
inline constexpr const char* macro_words[] = {"sunburst", "polka_dots", "frames", "flower",
                                              "grid",     "outline",    "lace",   "cells"};
inline constexpr const char* change_words[] = {"displace", "group", "ungroup", "join"};
constexpr size_t displace_word = 0, group_word = 1, ungroup_word = 2, join_word = 3;
inline constexpr const char* border_words[] = {"none", "outer", "each"};
inline constexpr const char* grouping_words[] = {"two", "one", "each", "cycle"};

// Of the JSON: parsed it takes some twenty times as much.
constexpr uint64_t max_tangle_json = uint64_t{8} << 20;

// A side file, by the part of the JSON that names it.
struct SideFile {
    String name;
    uint64_t bytes = 0;
    uint64_t checksum = 0;
};

// FNV-1a, of 64 bits.
uint64_t checksum_of(Bytes bytes);

// What it says of its side file; no name: it has none. Refuses what is no document of a version that is known.
SideFile read_side_file(const JsonValue& document);

struct TangleText {
    String json;
    SideFile side;  // no name: none is needed
    String arrays;  // what belongs into it
};

// `file_name`: of the JSON; that of the side file is made of it and the checksum, so that no save writes over the side
// file of another. Refuses histories that point to nothing, or hold values that no file may hold.
TangleText write_tangle(const FlgTangleHistory& history, const String& file_name);

// A history with its memory.
class TangleDocument {
public:
    TangleDocument(const JsonValue& document, Bytes arrays);
    TangleDocument(const TangleDocument&) = delete;
    TangleDocument& operator=(const TangleDocument&) = delete;

    const FlgTangleHistory& history() const { return history_; }

private:
    class Arrays;

    void read_step(const JsonValue& value, Arrays& arrays);
    const FlgTangleSeeds* read_seeds(const JsonValue& value, Arrays& arrays);
    void read_divide(const JsonValue& value, FlgTangleOperator kind, Arrays& arrays, FlgTangleStep& step);
    void read_macro(const JsonValue& value, FlgTangleMacro kind, Arrays& arrays, FlgTangleStep& step);
    void read_displace(const JsonValue& value, Arrays& arrays, FlgTangleStep& step);
    void read_places(const JsonValue& value, Arrays& arrays, FlgTangleStep& step);
    void read_state(const JsonValue& value, FlgTangleStep& step);
    FlgTangleSeedPlaces read_places_of(const JsonValue& value, Arrays& arrays);

    FlgTangleHistory history_{};
    Vector<const FlgTangleStep*> shown_steps_;
    // Deques: what is pointed to stays where it is.
    Deque<FlgTangleStep> steps_;
    Deque<FlgTangleDivideDesc> divides_;
    Deque<FlgTangleApplyMacroDesc> macros_;
    Deque<FlgTangleDisplaceDesc> displaces_;
    Deque<FlgTangleSeedPlaces> places_;
    Deque<Vector<const FlgTangleSeedPlaces*>> shown_places_;
    Deque<FlgTangleSeeds> seeds_;
    Deque<FlgSurfaceCurvesView> curves_;
    Deque<Vector<FlgBorderStretch>> stretches_;
    Deque<Vector<FlgSurfacePoint>> points_;
    Deque<Vector<uint32_t>> numbers_;
    Deque<Vector<uint8_t>> flags_;
    Deque<Vector<float>> floats_;
    Deque<Vector<FlgTangleRegionName>> names_;
    Deque<String> sentences_;
};

}  // namespace flg::io
