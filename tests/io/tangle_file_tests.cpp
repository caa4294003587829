// SPDX-License-Identifier: MIT
// Documents of tangles: what is written is read; what is damaged, cut short or made up is refused.
#include <cmath>
#include <cstring>
#include <functional>
#include <random>

#include "io/files.h"

namespace flg::test {
namespace {

// A history of every kind of step, with short arrays and long ones. The numbers are made up: no mesh is asked.
struct MadeUp {
    std::vector<uint32_t> root = {0}, many;
    std::vector<float> positions;
    std::vector<FlgSurfacePoint> points;
    std::vector<uint32_t> offsets = {0, 20, 23};
    std::vector<uint8_t> flags = {0, FLG_CURVE_CLOSED};
    std::vector<float> values = {0.1f, -2};
    FlgBorderStretch stretch = {2, 0.3f, 1.1f};
    FlgTangleSeeds a{}, b{};
    FlgSurfaceCurvesView lines{};
    FlgTangleDivideDesc divide{};
    FlgTangleApplyMacroDesc macro{};
    FlgTangleDisplaceDesc displace{};
    FlgTangleSeedPlaces places[2] = {};
    const FlgTangleSeedPlaces* const shown_places[2] = {&places[0], &places[1]};
    FlgTangleStep steps[6];
    const FlgTangleStep* shown_steps[6];
    FlgTangleHistory history{};

    MadeUp() {
        for (uint32_t i = 0; i < 40; ++i) {
            many.push_back(3 * i);
            points.push_back({i, 0.01f * float(i), 1.0f / float(i + 2)});
            for (uint32_t k = 0; k < 3; ++k) positions.push_back(float(i) / 7 - float(k));
        }
        divide.struct_size = sizeof divide;
        divide.kind = FLG_TANGLE_OPERATOR_STREAM;
        divide.regions = many.data();
        divide.region_count = 40;
        divide.count = 7;
        a.struct_size = b.struct_size = sizeof a;
        divide.a = &a;
        divide.b = &b;
        a.borders = FLG_TANGLE_BORDERS_EACH;
        a.stretches = &stretch;
        a.stretch_count = 1;
        a.points = points.data();
        a.point_count = 3;
        b.points = points.data();
        b.point_count = 40;
        b.sample_radius = 0.1f;
        b.sample_count = 9;
        b.border_spacing = 1e-20f;
        b.regions = root.data();
        b.region_count = 1;
        divide.delta = 0.1f;
        divide.grouping = FLG_TANGLE_GROUPING_CYCLE;
        divide.cycle = 5;
        divide.scaffold = divide.closed = 1;
        divide.perturbation = 0.3f;
        divide.frequency = 3e7f;
        divide.seed = UINT64_MAX;
        macro.struct_size = sizeof macro;
        macro.kind = FLG_TANGLE_MACRO_CELLS;
        macro.regions = root.data();
        macro.region_count = 1;
        macro.count = 4;
        macro.size = 0.1f;
        macro.spacing = 1.0f / 3;
        macro.seed = 1;
        displace.struct_size = sizeof displace;
        displace.amount = -0.7f;
        displace.regions = root.data();
        displace.region_count = 1;
        displace.bias = 0.2f;
        displace.gain = 0.9f;
        displace.reach = 2;
        for (FlgTangleSeedPlaces& place : places) place.struct_size = sizeof place;
        places[0].points = positions.data();
        places[0].point_count = 3;
        places[0].loops = positions.data();
        places[0].loop_count = 1;
        places[1].samples = positions.data();
        places[1].sample_count = 30;
        lines.struct_size = sizeof lines;
        places[1].curves = &lines;
        lines.curve_count = 2;
        lines.curve_offsets = offsets.data();
        lines.curve_flags = flags.data();
        lines.curve_values = values.data();
        lines.points = points.data();
        places[1].curve_points = positions.data();
        for (uint32_t i = 0; i < 6; ++i) {
            steps[i] = {};
            steps[i].struct_size = sizeof steps[i];
            shown_steps[i] = &steps[i];
            steps[i].kind = static_cast<FlgTangleStepKind>(i);
            steps[i].first_region = i + 1;
        }
        steps[0].divide = &divide;
        steps[0].places = shown_places;
        steps[0].place_count = 2;
        steps[0].made = positions.data();
        steps[0].made_count = 40;
        steps[0].placed = 1;
        steps[1].macro = &macro;
        steps[1].made = positions.data();
        steps[1].made_count = 2;
        steps[2].displace = &displace;
        steps[3].regions = root.data();
        steps[3].region_count = 1;
        steps[4].group = 17;
        steps[4].first_region = UINT32_MAX;
        steps[5].regions = many.data();
        steps[5].region_count = 40;
        history.struct_size = sizeof history;
        history.steps = shown_steps;
        history.step_count = 6;
        history.made_count = 4;
        history.base = 0xfedcba9876543210;
        for (int k = 0; k < 3; ++k) {
            history.box_min[k] = -0.1f * float(k);
            history.box_max[k] = 0.1f * float(k + 1);
        }
    }
};

struct Opened {
    FlgTangleFile file = nullptr;
    FlgTangleHistory history{};
    FlgResult result;
    std::string error;

    explicit Opened(const std::string& path) {
        history.struct_size = sizeof history;
        result = flgTangleFileRead(path.c_str(), nullptr, &file);
        if (result == FLG_OK) {
            EXPECT_EQ(flgTangleFileGetHistory(file, &history), FLG_OK);
        } else {
            error = flgIoErrorGetMessage();
            EXPECT_EQ(file, nullptr);
            EXPECT_EQ(error.rfind(path, 0), 0u) << error;
        }
    }
    Opened(const Opened&) = delete;
    ~Opened() { flgTangleFileRelease(file); }
};

template <class T>
void expect_same(const T* a, const T* b, size_t count) {
    if (count > 0) {
        ASSERT_NE(b, nullptr);
        EXPECT_EQ(std::memcmp(a, b, count * sizeof(T)), 0);
    }
}

void expect_same(const FlgTangleSeeds& a, const FlgTangleSeeds& b) {
    EXPECT_EQ(a.borders, b.borders);
    ASSERT_EQ(a.stretch_count, b.stretch_count);
    expect_same(a.stretches, b.stretches, a.stretch_count);
    ASSERT_EQ(a.point_count, b.point_count);
    expect_same(a.points, b.points, a.point_count);
    EXPECT_EQ(a.sample_count, b.sample_count);
    EXPECT_EQ(a.sample_radius, b.sample_radius);
    EXPECT_EQ(a.border_spacing, b.border_spacing);
    ASSERT_EQ(a.region_count, b.region_count);
    expect_same(a.regions, b.regions, a.region_count);
}

TEST(TangleFile, WhatIsWrittenIsReadToTheBit) {
    const Folder folder;
    const MadeUp made;
    ASSERT_EQ(flgTangleFileWrite(folder.at("a.json").c_str(), &made.history, nullptr), FLG_OK)
        << flgIoErrorGetMessage();
    EXPECT_EQ(folder.entries(), 2u);
    const Opened read(folder.at("a.json"));
    ASSERT_EQ(read.result, FLG_OK) << read.error;
    EXPECT_EQ(read.history.base, made.history.base);
    EXPECT_EQ(read.history.made_count, 4u);
    expect_same(made.history.box_min, read.history.box_min, 3);
    expect_same(made.history.box_max, read.history.box_max, 3);
    ASSERT_EQ(read.history.step_count, 6u);
    for (uint32_t i = 0; i < 6; ++i) {
        SCOPED_TRACE(i);
        const FlgTangleStep &a = made.steps[i], &b = *read.history.steps[i];
        EXPECT_EQ(a.kind, b.kind);
        EXPECT_EQ(a.group, b.group);
        EXPECT_EQ(a.placed, b.placed);
        EXPECT_EQ(a.first_region, b.first_region);
        ASSERT_EQ(a.region_count, b.region_count);
        expect_same(a.regions, b.regions, a.region_count);
        ASSERT_EQ(a.made_count, b.made_count);
        expect_same(a.made, b.made, size_t{3} * a.made_count);
        ASSERT_EQ(a.place_count, b.place_count);
    }
    const FlgTangleDivideDesc &a = made.divide, &b = *read.history.steps[0]->divide;
    EXPECT_EQ(a.kind, b.kind);
    ASSERT_EQ(a.region_count, b.region_count);
    expect_same(a.regions, b.regions, a.region_count);
    expect_same(*a.a, *b.a);
    expect_same(*a.b, *b.b);
    EXPECT_EQ(a.delta, b.delta);
    EXPECT_EQ(a.count, b.count);
    EXPECT_EQ(a.grouping, b.grouping);
    EXPECT_EQ(a.cycle, b.cycle);
    EXPECT_EQ(a.scaffold, b.scaffold);
    EXPECT_EQ(a.closed, b.closed);
    EXPECT_EQ(a.perturbation, b.perturbation);
    EXPECT_EQ(a.frequency, b.frequency);
    EXPECT_EQ(a.seed, b.seed);
    const FlgTangleApplyMacroDesc& macro = *read.history.steps[1]->macro;
    EXPECT_EQ(macro.kind, FLG_TANGLE_MACRO_CELLS);
    EXPECT_EQ(macro.spacing, 1.0f / 3);
    EXPECT_EQ(macro.size, 0.1f);
    const FlgTangleDisplaceDesc& displace = *read.history.steps[2]->displace;
    EXPECT_EQ(displace.amount, -0.7f);
    EXPECT_EQ(displace.bias, 0.2f);
    EXPECT_EQ(displace.gain, 0.9f);
    EXPECT_EQ(displace.reach, 2);
    const FlgTangleSeedPlaces* const* places = read.history.steps[0]->places;
    ASSERT_EQ(places[0]->point_count, 3u);
    expect_same(made.positions.data(), places[0]->points, 9);
    ASSERT_EQ(places[0]->loop_count, 1u);
    ASSERT_EQ(places[1]->sample_count, 30u);
    expect_same(made.positions.data(), places[1]->samples, 90);
    ASSERT_EQ(places[1]->curves->curve_count, 2u);
    expect_same(made.offsets.data(), places[1]->curves->curve_offsets, 3);
    expect_same(made.flags.data(), places[1]->curves->curve_flags, 2);
    expect_same(made.values.data(), places[1]->curves->curve_values, 2);
    expect_same(made.points.data(), places[1]->curves->points, 23);
    expect_same(made.positions.data(), places[1]->curve_points, 69);
    // The same history gives the same bytes; so does what was read.
    ASSERT_EQ(flgTangleFileWrite(folder.at("b/a.json").c_str(), &read.history, nullptr), FLG_ERROR_FILE);
    std::filesystem::create_directory(folder.at("b"));
    ASSERT_EQ(flgTangleFileWrite(folder.at("b/a.json").c_str(), &read.history, nullptr), FLG_OK)
        << flgIoErrorGetMessage();
    EXPECT_EQ(slurp(folder.at("a.json")), slurp(folder.at("b/a.json")));
}

TEST(TangleFile, StepsThatDoNothingStayAsTheyAre) {
    const Folder folder;
    MadeUp made;
    const std::array<FlgTangleRegionName, 3> names = {{{FLG_NO_INDEX, 0, 0, FLG_NO_INDEX, {}, 0},
                                                       {2, 1, 7, 0, {0.1f, -2, 1.0f / 3}, 0.25f},
                                                       {FLG_NO_INDEX, 0, 1, 1, {1, 2, 3}, 0}}};
    made.steps[0].state = FLG_TANGLE_STEP_STATE_MUTED;
    made.steps[3].state = FLG_TANGLE_STEP_STATE_LOST;
    made.steps[3].why = "the \"first\" region is gone";
    made.steps[3].names = names.data();
    made.steps[3].name_count = 3;
    made.steps[4].why = "1 of its 2 regions are not there";
    const std::string path = folder.at("a.json");
    ASSERT_EQ(flgTangleFileWrite(path.c_str(), &made.history, nullptr), FLG_OK) << flgIoErrorGetMessage();
    EXPECT_NE(slurp(path).find("\"version\": 2"), std::string::npos);
    const Opened read(path);
    ASSERT_EQ(read.result, FLG_OK) << read.error;
    for (uint32_t i = 0; i < 6; ++i) {
        const FlgTangleStep& step = *read.history.steps[i];
        EXPECT_EQ(step.state, made.steps[i].state);
        EXPECT_STREQ(step.why ? step.why : "", made.steps[i].why ? made.steps[i].why : "");
        ASSERT_EQ(step.name_count, made.steps[i].name_count);
    }
    expect_same(names.data(), read.history.steps[3]->names, names.size());
}

TEST(TangleFile, ShortHistoriesNeedNoSideFile) {
    const Folder folder;
    MadeUp made;
    made.history.step_count = made.history.made_count = 0;
    ASSERT_EQ(flgTangleFileWrite(folder.at("a.json").c_str(), &made.history, nullptr), FLG_OK)
        << flgIoErrorGetMessage();
    EXPECT_EQ(folder.entries(), 1u);
    const Opened read(folder.at("a.json"));
    EXPECT_EQ(read.result, FLG_OK) << read.error;
    EXPECT_EQ(read.history.step_count, 0u);
}

// The names of a list that ends with null.
std::vector<std::string> names(const char* (*name)(uint32_t)) {
    std::vector<std::string> list;
    for (uint32_t n = 0; name(n) != nullptr; ++n) list.push_back(name(n));
    return list;
}

TEST(TangleFile, WordsHaveTheEnumeratorsOrder) {
    const std::vector<std::string> operators = names(flgTangleOperatorGetName), macros = names(flgTangleMacroGetName);
    ASSERT_EQ(operators.size(), FLG_TANGLE_OPERATOR_POLYLINE + 1u);
    EXPECT_EQ(operators[FLG_TANGLE_OPERATOR_CONTOUR], "contour");
    EXPECT_EQ(operators[FLG_TANGLE_OPERATOR_VORONOI], "voronoi");
    ASSERT_EQ(macros.size(), FLG_TANGLE_MACRO_CELLS + 1u);
    EXPECT_EQ(macros[FLG_TANGLE_MACRO_GRID], "grid");
    EXPECT_EQ(macros[FLG_TANGLE_MACRO_LACE], "lace");
    EXPECT_EQ(flgTangleOperatorGetName(UINT32_MAX), nullptr);
    EXPECT_EQ(flgTangleMacroGetName(UINT32_MAX), nullptr);
}

std::string side_file(const Folder& folder, const std::string& name) {
    std::string found;
    for (const auto& entry : std::filesystem::directory_iterator(folder.at(""))) {
        const std::string file = entry.path().filename().string();
        if (file.rfind(name + ".", 0) == 0) found = file;
    }
    return found;
}

// A save writes the side file, renames it, writes the JSON, renames it, removes the old side file: wherever it is cut
// short, what is read is the one document or the other.
TEST(TangleFile, ASaveThatIsCutShortLeavesTheDocumentAsItWas) {
    const Folder before, after;
    MadeUp made;
    ASSERT_EQ(flgTangleFileWrite(before.at("a.json").c_str(), &made.history, nullptr), FLG_OK);
    const std::string old_json = slurp(before.at("a.json")), old_side = side_file(before, "a.json");
    const std::string old_arrays = slurp(before.at(old_side));
    made.positions[40] += 1;
    ASSERT_EQ(flgTangleFileWrite(after.at("a.json").c_str(), &made.history, nullptr), FLG_OK);
    const std::string new_json = slurp(after.at("a.json")), new_side = side_file(after, "a.json");
    const std::string new_arrays = slurp(after.at(new_side));
    ASSERT_NE(old_side, new_side);
    const Folder folder;
    folder.put("a.json", old_json);
    folder.put(old_side, old_arrays);
    const auto expect_old = [&] {
        const Opened read(folder.at("a.json"));
        ASSERT_EQ(read.result, FLG_OK) << read.error;
        EXPECT_EQ(read.history.steps[0]->made[40], made.positions[40] - 1);
    };
    for (size_t bytes = 0; bytes <= new_arrays.size(); bytes += 97) {
        folder.put(new_side + ".tmp0", new_arrays.substr(0, bytes));
        expect_old();
    }
    std::filesystem::remove(folder.at(new_side + ".tmp0"));
    folder.put(new_side, new_arrays);
    for (size_t bytes = 0; bytes <= new_json.size(); bytes += 97) {
        folder.put("a.json.tmp0", new_json.substr(0, bytes));
        expect_old();
    }
    folder.put("a.json", new_json);
    {
        const Opened read(folder.at("a.json"));
        ASSERT_EQ(read.result, FLG_OK) << read.error;
        EXPECT_EQ(read.history.steps[0]->made[40], made.positions[40]);
    }
    // The next save passes over what was left, and removes the side file that it takes the place of.
    made.positions[41] += 1;
    ASSERT_EQ(flgTangleFileWrite(folder.at("a.json").c_str(), &made.history, nullptr), FLG_OK)
        << flgIoErrorGetMessage();
    EXPECT_FALSE(std::filesystem::exists(folder.at(new_side)));
    EXPECT_EQ(Opened(folder.at("a.json")).result, FLG_OK);
}

TEST(TangleFile, ASaveThatFailsLeavesNothingBehind) {
    const Folder folder;
    MadeUp made;
    std::filesystem::create_directory(folder.at("a.json"));  // a folder can't be renamed over
    EXPECT_EQ(flgTangleFileWrite(folder.at("a.json").c_str(), &made.history, nullptr), FLG_ERROR_FILE);
    EXPECT_EQ(folder.entries(), 1u);
    ASSERT_EQ(flgTangleFileWrite(folder.at("b.json").c_str(), &made.history, nullptr), FLG_OK);
    const std::string text = slurp(folder.at("b.json"));
    made.positions[5] = NAN;
    EXPECT_EQ(flgTangleFileWrite(folder.at("b.json").c_str(), &made.history, nullptr), FLG_ERROR_INVALID_ARGUMENT);
    EXPECT_NE(std::string(flgIoErrorGetMessage()).find("finite"), std::string::npos) << flgIoErrorGetMessage();
    EXPECT_EQ(slurp(folder.at("b.json")), text);
    EXPECT_EQ(folder.entries(), 3u);
}

TEST(TangleFile, HistoriesThatPointToNothingAreRefused) {
    const Folder folder;
    const std::string path = folder.at("a.json");
    const auto refused = [&](const std::function<void(MadeUp&)>& spoil, const std::string& part) {
        MadeUp made;
        spoil(made);
        EXPECT_EQ(flgTangleFileWrite(path.c_str(), &made.history, nullptr), FLG_ERROR_INVALID_ARGUMENT) << part;
        EXPECT_NE(std::string(flgIoErrorGetMessage()).find(part), std::string::npos) << flgIoErrorGetMessage();
    };
    EXPECT_EQ(flgTangleFileWrite(nullptr, nullptr, nullptr), FLG_ERROR_INVALID_ARGUMENT);
    EXPECT_EQ(flgTangleFileWrite(path.c_str(), nullptr, nullptr), FLG_ERROR_INVALID_ARGUMENT);
    refused([](MadeUp& made) { made.history.struct_size = 8; }, "struct_size");
    refused([](MadeUp& made) { made.history.steps = nullptr; }, "history.steps");
    refused([](MadeUp& made) { made.history.made_count = 7; }, "history.made_count");
    refused([](MadeUp& made) { made.steps[1].struct_size = 0; }, "history.steps[1]");
    refused([](MadeUp& made) { made.steps[0].divide = nullptr; }, "history.steps[0].divide");
    refused([](MadeUp& made) { made.steps[3].regions = nullptr; }, "history.steps[3].regions");
    refused([](MadeUp& made) { made.steps[5].kind = FLG_TANGLE_STEP_KIND_FORCE_32BIT; }, "history.steps[5].kind");
    refused([](MadeUp& made) { made.macro.kind = static_cast<FlgTangleMacro>(8); }, "macro.kind");
    refused([](MadeUp& made) { made.divide.grouping = static_cast<FlgTangleGrouping>(-1); }, "divide.grouping");
    refused([](MadeUp& made) { made.divide.delta = INFINITY; }, "divide.delta");
    refused([](MadeUp& made) { made.lines.curve_offsets = nullptr; }, "curve_offsets");
    EXPECT_EQ(folder.entries(), 0u);
}

class HostileTangleFile : public testing::Test {
protected:
    void SetUp() override {
        ASSERT_EQ(flgTangleFileWrite(path.c_str(), &made.history, nullptr), FLG_OK);
        json = slurp(path);
        side = side_file(folder, "a.json");
        arrays = slurp(folder.at(side));
    }
    void expect_refused(const std::string& sentence) const {
        const Opened read(path);
        EXPECT_TRUE(read.result == FLG_ERROR_FORMAT || read.result == FLG_ERROR_LIMIT || read.result == FLG_ERROR_FILE)
            << read.result;
        EXPECT_NE(read.error.find(sentence), std::string::npos) << read.error;
    }
    // With one piece of the text in place of another.
    void expect_refused(const std::string& piece, const std::string& other, const std::string& sentence) const {
        std::string changed = json;
        const size_t at = changed.find(piece);
        ASSERT_NE(at, std::string::npos) << piece;
        folder.put("a.json", changed.replace(at, piece.size(), other));
        expect_refused(sentence);
    }

    const Folder folder;
    const MadeUp made;
    const std::string path = folder.at("a.json");
    std::string json, side, arrays;
};

TEST_F(HostileTangleFile, TextThatIsNoDocument) {
    folder.put("a.json", "");
    expect_refused("is no JSON");
    folder.put("a.json", "[]");
    expect_refused("must be an object");
    folder.put("a.json", "{}");
    expect_refused("needs 'filigree'");
    folder.put("a.json", std::string(1 << 20, '['));
    expect_refused("nests deeper");
    folder.put("a.json", std::string((8 << 20) + 1, ' '));
    expect_refused("limit of 8 MiB");
    for (size_t size = 0; size + 2 < json.size(); size += 7) {
        folder.put("a.json", json.substr(0, size));
        expect_refused("is no JSON");
    }
    std::filesystem::remove(path);
    expect_refused("can't be opened");
}

TEST_F(HostileTangleFile, ValuesThatCantBe) {
    expect_refused("\"version\": 1", "\"version\": 3", "version: is 3, only 1 and 2 are known");
    expect_refused("\"version\": 1", "\"version\": \"1\"", "version: must be a whole number");
    expect_refused("\"filigree\": \"tangle\"", "\"filigree\": \"style\"", "filigree: must be 'tangle'");
    expect_refused("\"made\": 4", "\"made\": 7", "made: must be a whole number from 0 to 6");
    expect_refused("\"base\": \"fedc", "\"base\": \"FEDC", "base: must be 16 digits");
    expect_refused("\"made\": 4", "\"made\": 4, \"more\": 1", "does not know 'more'");
    expect_refused("\"op\":\"stream\"", "\"op\":\"spiral\"", "steps[0].op: is 'spiral', must be one of contour");
    expect_refused("\"op\":\"stream\"", "\"op\":3", "steps[0].op: must be a text");
    expect_refused("\"op\":\"stream\"", "\"po\":\"stream\"", "steps[0]: does not know 'po'");
    expect_refused("\"op\":\"stream\",", "", "steps[0]: needs 'op'");
    expect_refused("\"delta\":0.1", "\"delta\":1e31", "steps[0].delta: must be a number");
    expect_refused("\"delta\":0.1", "\"delta\":null", "steps[0].delta: must be a number");
    expect_refused("\"delta\":0.1", "\"delta\":1e400", "is no JSON");
    expect_refused("\"group\":17", "\"group\":-1", "steps[4].group: must be a whole number");
    expect_refused("\"group\":17", "\"group\":4294967296", "steps[4].group: must be a whole number");
    expect_refused("\"scaffold\":true", "\"scaffold\":1", "steps[0].scaffold: must be true or false");
    expect_refused("\"groups\":\"cycle\"", "\"groups\":\"three\"", "steps[0].groups");
    expect_refused("\"borders\":\"each\"", "\"borders\":\"all\"", "steps[0].from.borders");
    expect_refused("\"loop\":2", "\"loop\":2,\"knot\":1", "stretches[0]: does not know 'knot'");
}

TEST_F(HostileTangleFile, ArraysThatAreNotThere) {
    expect_refused("{\"at\":0,\"count\":40}", "{\"at\":0,\"count\":4294967295}", "the side file has");
    expect_refused("{\"at\":0,\"count\":40}", "{\"at\":4,\"count\":40}", "must be 0: arrays follow one another");
    expect_refused("{\"at\":0,\"count\":40}", "{\"at\":0}", "steps[0].on: needs 'count'");
    expect_refused("{\"at\":0,\"count\":40}", "[0]", "must be 0: arrays follow one another");
    expect_refused("{\"at\":0,\"count\":40}", "7", "steps[0].on: must be an object");
    expect_refused("\"offsets\":[0,20,23]", "\"offsets\":[0,20,22]", "has 23 points, the last offset is 22");
    expect_refused("\"offsets\":[0,20,23]", "\"offsets\":[0,23]", "one offset more");
    expect_refused("\"loops\":[", "\"loops\":[1,", "3 numbers an item");
    expect_refused("\"file\": \"" + side, "\"file\": \"../" + side, "must be the name of a file beside this one");
    expect_refused("\"file\": \"" + side, "\"file\": \"other.bin", "can't be opened");
    expect_refused("\"bytes\": ", "\"bytes\": 1", "arrays.bytes: is 1");
    expect_refused("\"bytes\": ", "\"bytes\": 99999999999", "arrays.bytes: must be a whole number");
}

TEST_F(HostileTangleFile, SideFilesThatAreDamaged) {
    for (size_t size = 0; size < arrays.size(); size += 31) {
        folder.put(side, arrays.substr(0, size));
        expect_refused("arrays.bytes: is");
    }
    for (size_t at = 0; at < arrays.size(); at += 13) {
        std::string damaged = arrays;
        damaged[at] = static_cast<char>(damaged[at] ^ 4);
        folder.put(side, damaged);
        expect_refused("arrays.checksum: is not that of");
    }
    std::filesystem::remove(folder.at(side));
    expect_refused("can't be opened");
    std::filesystem::create_directory(folder.at(side));
    expect_refused("is not a regular file");
}

TEST_F(HostileTangleFile, NumbersOfTheSideFileAreFinite) {
    // With the checksum that belongs to it, made by writing what no history may hold past the writer: on = 40 regions,
    // then the 40 points of `to`, of which one gets a weight that is none.
    std::string damaged = arrays;
    const float none = NAN;
    std::memcpy(damaged.data() + 40 * 4 + 5 * 12 + 4, &none, sizeof none);
    uint64_t sum = 0xcbf29ce484222325;
    for (const char byte : damaged) sum = (sum ^ static_cast<uint8_t>(byte)) * 0x100000001b3;
    char hex[17];
    std::snprintf(hex, sizeof hex, "%016llx", static_cast<unsigned long long>(sum));
    folder.put(side, damaged);
    const std::string old = side.substr(7, 16);
    expect_refused("\"checksum\": \"" + old, std::string("\"checksum\": \"") + hex, "not finite");
}

TEST_F(HostileTangleFile, RandomDamageIsReadOrRefused) {
    std::mt19937 random(1);
    for (int i = 0; i < 1500; ++i) {
        std::string damaged = json;
        for (uint32_t flips = 1 + random() % 3; flips > 0; --flips) {
            damaged[random() % damaged.size()] = "0123456789,:[]{}\"-eax"[random() % 21];
        }
        folder.put("a.json", damaged);
        const Opened read(path);
        if (read.result != FLG_OK) continue;
        for (uint32_t s = 0; s < read.history.step_count; ++s) {
            const FlgTangleStep& step = *read.history.steps[s];
            for (uint32_t k = 0; k < 3 * step.made_count; ++k) ASSERT_LE(std::abs(step.made[k]), 1e30f);
        }
    }
}

}  // namespace
}  // namespace flg::test
