// SPDX-License-Identifier: MIT
#include "io/tangle/tangle_document.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstring>
#include <iterator>

#include "core/sized_struct.h"
#include "io/base/json_text.h"

namespace flg::io {

namespace {

constexpr uint64_t any_count = UINT32_MAX;

uint64_t read_hex(const JsonValue& value) {
    const String text = value.text();
    constexpr size_t digits = 16;
    if (text.size() != digits || text.find_first_not_of("0123456789abcdef") != String::npos) {
        value.refuse("must be 16 digits from 0 to f");
    }
    uint64_t number = 0;
    std::from_chars(text.data(), text.data() + text.size(), number, 16);
    return number;
}

uint32_t read_count(const JsonValue& object, const char* key, uint32_t otherwise) {
    const std::optional<JsonValue> found = object.find(key);
    return found ? static_cast<uint32_t>(found->count(any_count)) : otherwise;
}

float read_number(const JsonValue& object, const char* key, float otherwise) {
    const std::optional<JsonValue> found = object.find(key);
    return found ? found->number() : otherwise;
}

uint32_t read_flag(const JsonValue& object, const char* key) {
    const std::optional<JsonValue> found = object.find(key);
    return found && found->flag() ? 1 : 0;
}

}  // namespace

SideFile read_side_file(const JsonValue& document) {
    document.allow({"filigree", "version", "base", "box", "made", "arrays", "steps"});
    if (document.at("filigree").text() != "tangle") document.at("filigree").refuse("must be 'tangle'");
    const uint64_t version = document.at("version").count(any_count);
    if (version != tangle_document_version && version != edited_document_version) {
        document.at("version").refuse("is " + to_text(version) + ", only 1 and 2 are known");
    }
    SideFile side;
    const std::optional<JsonValue> arrays = document.find("arrays");
    if (!arrays) return side;
    arrays->allow({"file", "bytes", "checksum"});
    side.name = arrays->at("file").text();
    // Nothing but a file of this folder.
    const bool plain = side.name.find_first_of(std::string_view("/\\\0", 3)) == String::npos;
    if (!plain || side.name.empty() || side.name == "." || side.name == "..") {
        arrays->at("file").refuse("is " + cited(side.name) + ", must be the name of a file beside this one");
    }
    side.bytes = arrays->at("bytes").count(max_bytes);
    side.checksum = read_hex(arrays->at("checksum"));
    return side;
}

// Lists of numbers: in the JSON, or in the side file, one behind the other.
class TangleDocument::Arrays {
public:
    explicit Arrays(Bytes bytes) : bytes_(bytes) {}

    Vector<uint32_t> integers(const JsonValue& value) {
        Vector<uint32_t> list;
        read(value, 1, list,
             [](const JsonValue& number, uint64_t) { return static_cast<uint32_t>(number.count(any_count)); });
        return list;
    }
    // `words` a item.
    Vector<float> floats(const JsonValue& value, uint32_t words) {
        Vector<float> list;
        read(value, words, list, [](const JsonValue& number, uint64_t) { return number.number(); });
        for (const float number : list) check(value, number);
        return list;
    }
    Vector<FlgSurfacePoint> points(const JsonValue& value) {
        Vector<uint32_t> words;
        read(value, 3, words, [](const JsonValue& number, uint64_t i) {
            if (i % 3 == 0) return static_cast<uint32_t>(number.count(any_count));
            const float weight = number.number();
            uint32_t word;
            std::memcpy(&word, &weight, sizeof word);
            return word;
        });
        Vector<FlgSurfacePoint> list(words.size() / 3);
        for (size_t i = 0; i < list.size(); ++i) {
            list[i].triangle = words[3 * i];
            std::memcpy(&list[i].u, &words[3 * i + 1], sizeof list[i].u);
            std::memcpy(&list[i].v, &words[3 * i + 2], sizeof list[i].v);
            check(value, list[i].u);
            check(value, list[i].v);
        }
        return list;
    }
    void expect_end() const {
        if (at_ != bytes_.size()) {
            fail(FLG_ERROR_FORMAT, "arrays", "have %zu bytes, of which the steps name %zu", bytes_.size(), at_);
        }
    }

private:
    static void check(const JsonValue& value, float number) {
        if (!(std::abs(number) <= max_coordinate)) value.refuse("holds a number that is not finite");
    }
    template <class T, class Convert>
    void read(const JsonValue& value, uint32_t words, Vector<T>& list, Convert convert) {
        if (value.is_list()) {
            if (value.size() % words != 0) value.refuse("must have " + to_text(words) + " numbers an item");
            for (size_t i = 0; i < value.size(); ++i) list.push_back(convert(value[i], i));
            return;
        }
        value.allow({"at", "count"});
        // Each byte is read once: what is made of a file is no larger than the file.
        if (value.at("at").count(max_bytes) != at_) {
            value.at("at").refuse("must be " + to_text(at_) + ": arrays follow one another");
        }
        const uint64_t bytes = value.at("count").count(any_count) * words * sizeof(T);
        if (bytes > bytes_.size() - at_) {
            value.refuse("takes " + to_text(bytes) + " bytes, the side file has " + to_text(bytes_.size() - at_) +
                         " left");
        }
        list.resize(bytes / sizeof(T));
        if (bytes > 0) std::memcpy(list.data(), bytes_.data() + at_, bytes);
        at_ += bytes;
    }

    const Bytes bytes_;
    uint64_t at_ = 0;
};

TangleDocument::TangleDocument(const JsonValue& document, Bytes bytes) {
    Arrays arrays(bytes);
    history_.struct_size = sizeof history_;
    history_.base = read_hex(document.at("base"));
    const JsonValue box = document.at("box");
    if (box.size() != 6) box.refuse("must have six numbers");
    for (size_t k = 0; k < 3; ++k) {
        history_.box_min[k] = box[k].number();
        history_.box_max[k] = box[k + 3].number();
    }
    const JsonValue steps = document.at("steps");
    history_.made_count = static_cast<uint32_t>(document.at("made").count(steps.size()));
    for (size_t i = 0; i < steps.size(); ++i) read_step(steps[i], arrays);
    arrays.expect_end();
    history_.steps = shown_steps_.data();
    history_.step_count = static_cast<uint32_t>(shown_steps_.size());
}

void TangleDocument::read_step(const JsonValue& value, Arrays& arrays) {
    value.allow({"op",       "on",     "from",         "to",        "delta", "count", "groups",  "cycle",
                 "scaffold", "closed", "perturbation", "frequency", "seed",  "size",  "spacing", "amount",
                 "bias",     "gain",   "reach",        "group",     "first", "made",  "placed",  "places",
                 "mute",     "lost",   "missing",      "names",     "border"});
    const JsonValue op = value.at("op");
    Vector<const char*> words(std::begin(operator_words), std::end(operator_words));
    words.insert(words.end(), std::begin(macro_words), std::end(macro_words));
    const size_t first_change = words.size();
    words.insert(words.end(), std::begin(change_words), std::end(change_words));
    const size_t word = op.word(words);
    FlgTangleStep step{};
    step.struct_size = sizeof step;
    if (word < std::size(operator_words)) {
        read_divide(value, static_cast<FlgTangleOperator>(word), arrays, step);
    } else if (word < first_change) {
        read_macro(value, static_cast<FlgTangleMacro>(word - std::size(operator_words)), arrays, step);
    } else if (word == first_change + displace_word) {
        read_displace(value, arrays, step);
    } else if (word == first_change + ungroup_word) {
        step.kind = FLG_TANGLE_STEP_KIND_UNGROUP;
        step.group = static_cast<uint32_t>(value.at("group").count(any_count));
    } else {
        step.kind = word == first_change + group_word ? FLG_TANGLE_STEP_KIND_GROUP : FLG_TANGLE_STEP_KIND_JOIN;
        const Vector<uint32_t>& regions = numbers_.emplace_back(arrays.integers(value.at("on")));
        step.regions = regions.data();
        step.region_count = static_cast<uint32_t>(regions.size());
    }
    step.first_region = read_count(value, "first", 0);
    if (const auto made = value.find("made")) {
        const Vector<float>& places = floats_.emplace_back(arrays.floats(*made, 3));
        step.made = places.data();
        step.made_count = static_cast<uint32_t>(places.size() / 3);
    }
    step.placed = read_flag(value, "placed");
    read_places(value, arrays, step);
    read_state(value, step);
    shown_steps_.push_back(&steps_.emplace_back(step));
}

void TangleDocument::read_state(const JsonValue& value, FlgTangleStep& step) {
    const auto lost = value.find("lost"), missing = value.find("missing");
    if (lost || missing) step.why = sentences_.emplace_back((lost ? lost : missing)->text()).c_str();
    if (lost) step.state = FLG_TANGLE_STEP_STATE_LOST;
    if (read_flag(value, "mute") != 0) step.state = FLG_TANGLE_STEP_STATE_MUTED;
    const auto list = value.find("names");
    if (!list) return;
    Vector<FlgTangleRegionName>& names = names_.emplace_back();
    for (size_t i = 0; i < list->size(); ++i) {
        const JsonValue item = (*list)[i];
        item.allow({"step", "operation", "part", "in", "place", "reach"});
        FlgTangleRegionName name{};
        name.step = read_count(item, "step", FLG_NO_INDEX);
        name.operation = read_count(item, "operation", 0);
        name.part = read_count(item, "part", 0);
        name.parent = read_count(item, "in", FLG_NO_INDEX);
        if (const auto place = item.find("place")) {
            if (place->size() != 3) place->refuse("must have three numbers");
            for (size_t k = 0; k < 3; ++k) name.place[k] = (*place)[k].number();
        }
        name.reach = read_number(item, "reach", 0);
        names.push_back(name);
    }
    step.names = names.data();
    step.name_count = static_cast<uint32_t>(names.size());
}

const FlgTangleSeeds* TangleDocument::read_seeds(const JsonValue& value, Arrays& arrays) {
    value.allow({"borders", "stretches", "points", "samples", "spacing", "of"});
    FlgTangleSeeds& seeds = seeds_.emplace_back(sized<FlgTangleSeeds>());
    if (const auto borders = value.find("borders")) {
        seeds.borders = static_cast<FlgTangleBorders>(borders->word(border_words));
    }
    if (const auto list = value.find("stretches")) {
        Vector<FlgBorderStretch>& stretches = stretches_.emplace_back();
        for (size_t i = 0; i < list->size(); ++i) {
            const JsonValue stretch = (*list)[i];
            stretch.allow({"loop", "begin", "end"});
            stretches.push_back({static_cast<uint32_t>(stretch.at("loop").count(any_count)),
                                 stretch.at("begin").number(), stretch.at("end").number()});
        }
        seeds.stretches = stretches.data();
        seeds.stretch_count = static_cast<uint32_t>(stretches.size());
    }
    if (const auto list = value.find("points")) {
        const Vector<FlgSurfacePoint>& points = points_.emplace_back(arrays.points(*list));
        seeds.points = points.data();
        seeds.point_count = static_cast<uint32_t>(points.size());
    }
    if (const auto samples = value.find("samples")) {
        samples->allow({"radius", "count"});
        seeds.sample_radius = samples->at("radius").number();
        seeds.sample_count = read_count(*samples, "count", 0);
    }
    seeds.border_spacing = read_number(value, "spacing", 0);
    if (const auto of = value.find("of")) {
        const Vector<uint32_t>& regions = numbers_.emplace_back(arrays.integers(*of));
        seeds.regions = regions.data();
        seeds.region_count = static_cast<uint32_t>(regions.size());
    }
    return &seeds;
}

void TangleDocument::read_divide(const JsonValue& value, FlgTangleOperator kind, Arrays& arrays, FlgTangleStep& step) {
    FlgTangleDivideDesc desc{};
    desc.struct_size = sizeof desc;
    desc.kind = kind;
    const Vector<uint32_t>& regions = numbers_.emplace_back(arrays.integers(value.at("on")));
    desc.regions = regions.data();
    desc.region_count = static_cast<uint32_t>(regions.size());
    desc.a = read_seeds(value.at("from"), arrays);
    if (const auto to = value.find("to")) desc.b = read_seeds(*to, arrays);
    desc.delta = value.at("delta").number();
    desc.count = read_count(value, "count", 1);
    if (const auto groups = value.find("groups")) {
        desc.grouping = static_cast<FlgTangleGrouping>(groups->word(grouping_words));
    }
    desc.cycle = read_count(value, "cycle", 3);
    desc.scaffold = read_flag(value, "scaffold");
    desc.closed = read_flag(value, "closed");
    desc.perturbation = read_number(value, "perturbation", 0);
    desc.frequency = read_number(value, "frequency", 1);
    desc.seed = value.at("seed").count(UINT64_MAX);
    step.kind = FLG_TANGLE_STEP_KIND_DIVIDE;
    step.divide = &divides_.emplace_back(desc);
}

void TangleDocument::read_macro(const JsonValue& value, FlgTangleMacro kind, Arrays& arrays, FlgTangleStep& step) {
    FlgTangleApplyMacroDesc desc{};
    desc.struct_size = sizeof desc;
    desc.kind = kind;
    const Vector<uint32_t>& regions = numbers_.emplace_back(arrays.integers(value.at("on")));
    desc.regions = regions.data();
    desc.region_count = static_cast<uint32_t>(regions.size());
    desc.count = static_cast<uint32_t>(value.at("count").count(any_count));
    desc.size = value.at("size").number();
    desc.spacing = value.at("spacing").number();
    desc.seed = value.at("seed").count(UINT64_MAX);
    const std::optional<JsonValue> border = value.find("border");
    desc.border = border ? static_cast<uint32_t>(border->count(any_count)) : FLG_NO_INDEX;
    step.kind = FLG_TANGLE_STEP_KIND_MACRO;
    step.macro = &macros_.emplace_back(desc);
}

void TangleDocument::read_displace(const JsonValue& value, Arrays& arrays, FlgTangleStep& step) {
    FlgTangleDisplaceDesc desc{};
    desc.struct_size = sizeof desc;
    const Vector<uint32_t>& regions = numbers_.emplace_back(arrays.integers(value.at("on")));
    desc.regions = regions.data();
    desc.region_count = static_cast<uint32_t>(regions.size());
    desc.amount = value.at("amount").number();
    desc.bias = read_number(value, "bias", 0.5f);
    desc.gain = read_number(value, "gain", 0.5f);
    desc.reach = read_number(value, "reach", 0);
    step.kind = FLG_TANGLE_STEP_KIND_DISPLACE;
    step.displace = &displaces_.emplace_back(desc);
}

void TangleDocument::read_places(const JsonValue& value, Arrays& arrays, FlgTangleStep& step) {
    const auto list = value.find("places");
    if (!list) return;
    Vector<const FlgTangleSeedPlaces*>& places = shown_places_.emplace_back();
    for (size_t i = 0; i < list->size(); ++i) {
        places.push_back(&places_.emplace_back(read_places_of((*list)[i], arrays)));
    }
    step.places = places.data();
    step.place_count = static_cast<uint32_t>(places.size());
}

FlgTangleSeedPlaces TangleDocument::read_places_of(const JsonValue& value, Arrays& arrays) {
    value.allow({"points", "loops", "samples", "curves"});
    auto places = sized<FlgTangleSeedPlaces>();
    const auto positions = [&](const char* key, const float*& out, uint32_t& count) {
        const auto found = value.find(key);
        if (!found) return;
        const Vector<float>& list = floats_.emplace_back(arrays.floats(*found, 3));
        out = list.data();
        count = static_cast<uint32_t>(list.size() / 3);
    };
    positions("points", places.points, places.point_count);
    positions("loops", places.loops, places.loop_count);
    positions("samples", places.samples, places.sample_count);
    const auto curves = value.find("curves");
    if (!curves) return places;
    curves->allow({"offsets", "flags", "values", "points", "places"});
    const Vector<uint32_t>& offsets = numbers_.emplace_back(arrays.integers(curves->at("offsets")));
    const Vector<uint32_t> words = arrays.integers(curves->at("flags"));
    const Vector<float>& values = floats_.emplace_back(arrays.floats(curves->at("values"), 1));
    const Vector<FlgSurfacePoint>& points = points_.emplace_back(arrays.points(curves->at("points")));
    if (words.empty() || offsets.size() != words.size() + 1 || values.size() != words.size()) {
        curves->refuse("must have one flag and value a curve, and one offset more");
    }
    if (offsets.back() != points.size()) {
        curves->refuse("has " + to_text(points.size()) + " points, the last offset is " + to_text(offsets.back()));
    }
    Vector<uint8_t>& flags = flags_.emplace_back();
    for (const uint32_t word : words) flags.push_back(static_cast<uint8_t>(word & FLG_CURVE_CLOSED));
    FlgSurfaceCurvesView& view = curves_.emplace_back(sized<FlgSurfaceCurvesView>());
    view.curve_count = static_cast<uint32_t>(words.size());
    view.curve_offsets = offsets.data();
    view.curve_flags = flags.data();
    view.curve_values = values.data();
    view.points = points.data();
    places.curves = &view;
    const Vector<float>& at = floats_.emplace_back(arrays.floats(curves->at("places"), 3));
    if (at.size() != 3 * points.size()) curves->at("places").refuse("must be one a point");
    places.curve_points = at.data();
    return places;
}

namespace {

// Longer arrays go into the side file.
constexpr uint64_t max_line = 12;  // numbers

// The double with the fewest digits that is read as this float.
double shortest(float value) {
    char text[32];
    char* const end = std::to_chars(text, text + sizeof text, value).ptr;
    double number = value;
    std::from_chars(text, end, number);
    return static_cast<float>(number) == value ? number : double{value};
}

// The fewest digits that are read as this double: with a point up to 15 places before and 4 behind it, else with an
// exponent.
String number_text(double value) {
    char text[32];
    const auto to_text = [&](std::chars_format format) {
        return std::string_view(text, std::to_chars(text, text + sizeof text, value, format).ptr - text);
    };
    constexpr double least = 1e-4, most = 1e15;
    const double size = std::abs(value);
    const bool plain = size == 0 || (size >= least && size < most);
    String result(to_text(plain ? std::chars_format::fixed : std::chars_format::scientific));
    if (plain && result.find('.') == String::npos) result += ".0";
    return result;
}

void check_number(float value, const String& place) {
    if (std::abs(value) <= max_coordinate) return;
    fail(FLG_ERROR_INVALID_ARGUMENT, place, "is %g, must be finite and at most 1e30 in size", double{value});
}

String number(float value, const String& place) {
    check_number(value, place);
    return number_text(shortest(value));
}

// The text of an object or a list that grows.
class JsonText {
public:
    // Members by name, in their order.
    void member(std::string_view name, std::string_view value) {
        next();
        (((text_ += '"') += name) += "\":") += value;
    }
    void word(std::string_view name, std::string_view value) { member(name, json_text(value)); }
    void count(std::string_view name, uint64_t value) { member(name, to_text(value)); }
    void flag(std::string_view name) { member(name, "true"); }
    void item(std::string_view value) {
        next();
        text_ += value;
    }
    bool empty() const { return text_.empty(); }
    String object() const { return "{" + text_ + "}"; }
    String list() const { return "[" + text_ + "]"; }

private:
    void next() {
        if (!text_.empty()) text_ += ',';
    }

    String text_;
};

String hex(uint64_t number) {
    char text[17];
    std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(number));
    return text;
}

class Writer {
public:
    String step(const FlgTangleStep* given, const String& place);

    String arrays;
    bool has_edits = false;  // it holds what the first version does not know

private:
    // `count` items of `words` words each, at `data`; to_json makes a number of a word.
    template <class ToJson>
    String list(const void* data, uint64_t count, uint32_t words, const String& where, ToJson to_json) {
        if (count > 0 && !data) fail(FLG_ERROR_INVALID_ARGUMENT, where, "is null");
        const auto* const bytes = static_cast<const char*>(data);
        JsonText json;
        if (count * words > max_line) {
            const size_t at = arrays.size();
            if (at + count * words * 4 > max_bytes)
                fail(FLG_ERROR_LIMIT, where, "makes the document's arrays too large");
            arrays.append(bytes, count * words * 4);
            json.count("at", at);
            json.count("count", count);
            return json.object();
        }
        for (uint64_t i = 0; i < count * words; ++i) json.item(to_json(bytes + 4 * i, i % words));
        return json.list();
    }
    String integers(const uint32_t* data, uint64_t count, const String& where) {
        return list(data, count, 1, where, [](const char* word, uint64_t) {
            uint32_t value;
            std::memcpy(&value, word, sizeof value);
            return to_text(value);
        });
    }
    String floats(const float* data, uint64_t count, uint32_t words, const String& where) {
        for (uint64_t i = 0; data && i < count * words; ++i) check_number(data[i], where);
        return list(data, count, words, where, [&](const char* word, uint64_t) {
            float value;
            std::memcpy(&value, word, sizeof value);
            return number(value, where);
        });
    }
    String points(const FlgSurfacePoint* data, uint64_t count, const String& where) {
        for (uint64_t i = 0; data && i < count; ++i) {
            check_number(data[i].u, where);
            check_number(data[i].v, where);
        }
        return list(data, count, 3, where, [&](const char* word, uint64_t k) {
            uint32_t index;
            float weight;
            std::memcpy(&index, word, sizeof index);
            std::memcpy(&weight, word, sizeof weight);
            return k == 0 ? to_text(index) : number(weight, where);
        });
    }
    JsonText seeds(const FlgTangleSeeds* given, const String& place);
    String places(const FlgTangleSeedPlaces* given, const String& place);
    void divide(JsonText& json, const FlgTangleDivideDesc* given, const String& place);
    void macro(JsonText& json, const FlgTangleApplyMacroDesc* given, const String& place);
    void displace(JsonText& json, const FlgTangleDisplaceDesc* given, const String& place);
    void state(JsonText& json, const FlgTangleStep& step, const String& place);
};

// What a host wrote into an enum, which may be none of its values (reading that as the enum would be undefined).
template <class Enum>
int32_t number_of(const Enum& value) {
    int32_t number;
    std::memcpy(&number, &value, sizeof number);
    return number;
}

template <size_t count>
const char* word_of(const char* const (&words)[count], int32_t value, const String& place) {
    if (value < 0 || static_cast<size_t>(value) >= count) {
        fail(FLG_ERROR_INVALID_ARGUMENT, place, "is %d, which is none of its values", value);
    }
    return words[value];
}

template <class T>
const T& need(const T* pointer, const String& place) {
    if (!pointer) fail(FLG_ERROR_INVALID_ARGUMENT, place, "is null");
    return *pointer;
}

// A struct of the host's, as far as we know it; `place` says where it is.
template <class T>
T read_at(const T* given, const String& place) {
    need(given, place);
    return read_struct<Longer::cut>(given, sized<T>(), place.c_str());
}

JsonText Writer::seeds(const FlgTangleSeeds* given, const String& place) {
    JsonText json;
    if (!given) return json;
    const FlgTangleSeeds seeds = read_at(given, place);
    if (number_of(seeds.borders) != FLG_TANGLE_BORDERS_NONE) {
        json.word("borders", word_of(border_words, number_of(seeds.borders), place + ".borders"));
    }
    JsonText stretches;
    for (uint32_t i = 0; i < seeds.stretch_count; ++i) {
        const String where = place + ".stretches";
        const FlgBorderStretch& stretch = (&need(seeds.stretches, where))[i];
        JsonText item;
        item.count("loop", stretch.loop);
        item.member("begin", number(stretch.begin, where));
        item.member("end", number(stretch.end, where));
        stretches.item(item.object());
    }
    if (!stretches.empty()) json.member("stretches", stretches.list());
    if (seeds.point_count > 0) json.member("points", points(seeds.points, seeds.point_count, place + ".points"));
    if (seeds.sample_radius != 0) {
        JsonText samples;
        samples.member("radius", number(seeds.sample_radius, place + ".sample_radius"));
        if (seeds.sample_count != 0) samples.count("count", seeds.sample_count);
        json.member("samples", samples.object());
    }
    if (seeds.border_spacing != 0) json.member("spacing", number(seeds.border_spacing, place + ".border_spacing"));
    if (seeds.region_count > 0) json.member("of", integers(seeds.regions, seeds.region_count, place + ".regions"));
    return json;
}

String Writer::places(const FlgTangleSeedPlaces* given, const String& place) {
    const FlgTangleSeedPlaces places = read_at(given, place);
    JsonText json;
    if (places.point_count > 0) json.member("points", floats(places.points, places.point_count, 3, place + ".points"));
    if (places.loop_count > 0) json.member("loops", floats(places.loops, places.loop_count, 3, place + ".loops"));
    if (places.sample_count > 0)
        json.member("samples", floats(places.samples, places.sample_count, 3, place + ".samples"));
    if (!places.curves) return json.object();
    const String where = place + ".curves";
    const FlgSurfaceCurvesView curves = read_at(places.curves, where);
    const uint32_t* const offsets = &need(curves.curve_offsets, where + ".curve_offsets");
    const uint8_t* const flags = &need(curves.curve_flags, where + ".curve_flags");
    const uint32_t count = offsets[curves.curve_count];
    const Vector<uint32_t> words(flags, flags + curves.curve_count);
    JsonText text;
    text.member("offsets", integers(offsets, uint64_t{curves.curve_count} + 1, where));
    text.member("flags", integers(words.data(), words.size(), where));
    text.member("values", floats(curves.curve_values, curves.curve_count, 1, where + ".curve_values"));
    text.member("points", points(curves.points, count, where + ".points"));
    if (places.curve_points) text.member("places", floats(places.curve_points, count, 3, place + ".curve_points"));
    json.member("curves", text.object());
    return json.object();
}

void Writer::divide(JsonText& json, const FlgTangleDivideDesc* given, const String& place) {
    const FlgTangleDivideDesc desc = read_at(given, place);
    json.word("op", word_of(operator_words, number_of(desc.kind), place + ".kind"));
    json.member("on", integers(desc.regions, desc.region_count, place + ".regions"));
    json.member("from", seeds(desc.a, place + ".a").object());
    const JsonText to = seeds(desc.b, place + ".b");
    if (!to.empty()) json.member("to", to.object());
    json.member("delta", number(desc.delta, place + ".delta"));
    json.count("count", desc.count);
    json.word("groups", word_of(grouping_words, number_of(desc.grouping), place + ".grouping"));
    if (number_of(desc.grouping) == FLG_TANGLE_GROUPING_CYCLE) json.count("cycle", desc.cycle);
    if (desc.scaffold != 0) json.flag("scaffold");
    if (desc.closed != 0) json.flag("closed");
    if (desc.perturbation != 0) {
        json.member("perturbation", number(desc.perturbation, place + ".perturbation"));
        json.member("frequency", number(desc.frequency, place + ".frequency"));
    }
    json.count("seed", desc.seed);
}

void Writer::macro(JsonText& json, const FlgTangleApplyMacroDesc* given, const String& place) {
    const FlgTangleApplyMacroDesc desc = read_at(given, place);
    json.word("op", word_of(macro_words, number_of(desc.kind), place + ".kind"));
    json.member("on", integers(desc.regions, desc.region_count, place + ".regions"));
    json.count("count", desc.count);
    json.member("size", number(desc.size, place + ".size"));
    json.member("spacing", number(desc.spacing, place + ".spacing"));
    json.count("seed", desc.seed);
    if (desc.border != FLG_NO_INDEX) json.count("border", desc.border);
}

void Writer::displace(JsonText& json, const FlgTangleDisplaceDesc* given, const String& place) {
    const FlgTangleDisplaceDesc desc = read_at(given, place);
    json.word("op", change_words[displace_word]);
    json.member("on", integers(desc.regions, desc.region_count, place + ".regions"));
    json.member("amount", number(desc.amount, place + ".amount"));
    json.member("bias", number(desc.bias, place + ".bias"));
    json.member("gain", number(desc.gain, place + ".gain"));
    json.member("reach", number(desc.reach, place + ".reach"));
}

void Writer::state(JsonText& json, const FlgTangleStep& step, const String& place) {
    const int32_t state = number_of(step.state);
    if (state < FLG_TANGLE_STEP_STATE_MADE || state > FLG_TANGLE_STEP_STATE_LOST)
        fail(FLG_ERROR_INVALID_ARGUMENT, place + ".state", "is %d, which is none of its values", state);
    const bool says = step.why && step.why[0] != 0;
    if (state == FLG_TANGLE_STEP_STATE_MUTED) json.flag("mute");
    if (state == FLG_TANGLE_STEP_STATE_LOST) json.word("lost", says ? step.why : "");
    if (state == FLG_TANGLE_STEP_STATE_MADE && says) json.word("missing", step.why);
    JsonText names;
    for (uint32_t i = 0; i < step.name_count; ++i) {
        const String where = place + ".names";
        const FlgTangleRegionName& name = (&need(step.names, where))[i];
        JsonText item;
        if (name.parent != FLG_NO_INDEX) {
            if (name.step != FLG_NO_INDEX) item.count("step", name.step);
            if (name.operation != 0) item.count("operation", name.operation);
            item.count("part", name.part);
            item.count("in", name.parent);
            JsonText at;
            for (const float value : name.place) at.item(number(value, where));
            item.member("place", at.list());
            if (name.reach != 0) item.member("reach", number(name.reach, where));
        }
        names.item(item.object());
    }
    if (!names.empty()) json.member("names", names.list());
    has_edits |= state != FLG_TANGLE_STEP_STATE_MADE || says || step.name_count > 0;
}

String Writer::step(const FlgTangleStep* given, const String& place) {
    const FlgTangleStep step = read_at(given, place);
    JsonText json;
    const int32_t kind = number_of(step.kind);
    switch (kind) {
        case FLG_TANGLE_STEP_KIND_DIVIDE: divide(json, step.divide, place + ".divide"); break;
        case FLG_TANGLE_STEP_KIND_MACRO: macro(json, step.macro, place + ".macro"); break;
        case FLG_TANGLE_STEP_KIND_DISPLACE: displace(json, step.displace, place + ".displace"); break;
        case FLG_TANGLE_STEP_KIND_UNGROUP:
            json.word("op", change_words[ungroup_word]);
            json.count("group", step.group);
            break;
        case FLG_TANGLE_STEP_KIND_GROUP:
        case FLG_TANGLE_STEP_KIND_JOIN:
            json.word("op", change_words[kind == FLG_TANGLE_STEP_KIND_GROUP ? group_word : join_word]);
            json.member("on", integers(step.regions, step.region_count, place + ".regions"));
            break;
        default: fail(FLG_ERROR_INVALID_ARGUMENT, place + ".kind", "is %d, which is none of its values", kind);
    }
    json.count("first", step.first_region);
    if (step.made_count > 0) json.member("made", floats(step.made, step.made_count, 3, place + ".made"));
    if (step.placed != 0) json.flag("placed");
    JsonText all_places;
    for (uint32_t i = 0; i < step.place_count; ++i) {
        const String where = place + ".places[" + to_text(i) + "]";
        all_places.item(places((&need(step.places, where))[i], where));
    }
    if (!all_places.empty()) json.member("places", all_places.list());
    state(json, step, place);
    return json.object();
}

// The head's box, a number a line.
String box_text(const FlgTangleHistory& history) {
    String text;
    const auto add = [&](const float(&corner)[3], const char* place) {
        for (const float value : corner) text += (text.empty() ? "\n    " : ",\n    ") + number(value, place);
    };
    add(history.box_min, "history.box_min");
    add(history.box_max, "history.box_max");
    return "[" + text + "\n  ]";
}

}  // namespace

uint64_t checksum_of(Bytes bytes) {
    uint64_t sum = 0xcbf29ce484222325;
    for (const uint8_t byte : bytes) sum = (sum ^ byte) * 0x100000001b3;
    return sum;
}

TangleText write_tangle(const FlgTangleHistory& history, const String& file_name) {
    if (history.made_count > history.step_count) {
        fail(FLG_ERROR_INVALID_ARGUMENT, "history.made_count", "is %u, but there are %u steps", history.made_count,
             history.step_count);
    }
    Writer writer;
    String steps;
    for (uint32_t i = 0; i < history.step_count; ++i) {
        const String place = "history.steps[" + to_text(i) + "]";
        const FlgTangleStep* const step = (&need(history.steps, "history.steps"))[i];
        steps += (i == 0 ? "\n    " : ",\n    ") + writer.step(step, place);
        if (steps.size() > max_tangle_json) fail(FLG_ERROR_LIMIT, place, "makes the document too large");
    }
    TangleText text;
    text.json = "{\n  \"filigree\": \"tangle\",\n  \"version\": " +
                to_text(writer.has_edits ? edited_document_version : tangle_document_version) + ",\n  \"base\": \"" +
                hex(history.base) + "\",\n  \"box\": " + box_text(history) +
                ",\n  \"made\": " + to_text(history.made_count);
    if (!writer.arrays.empty()) {
        text.side.bytes = writer.arrays.size();
        text.side.checksum =
            checksum_of({reinterpret_cast<const uint8_t*>(writer.arrays.data()), writer.arrays.size()});
        if (!is_utf8(file_name)) fail(FLG_ERROR_INVALID_ARGUMENT, "path", "must be UTF-8");
        text.side.name = file_name + "." + hex(text.side.checksum) + ".bin";
        text.json += ",\n  \"arrays\": {\n    \"file\": " + json_text(text.side.name) +
                     ",\n    \"bytes\": " + to_text(text.side.bytes) + ",\n    \"checksum\": \"" +
                     hex(text.side.checksum) + "\"\n  }";
    }
    text.json += ",\n  \"steps\": [" + steps + (history.step_count > 0 ? "\n  ]\n}\n" : "]\n}\n");
    text.arrays = std::move(writer.arrays);
    return text;
}

}  // namespace flg::io
