// SPDX-License-Identifier: MIT
#include <charconv>
#include <cmath>
#include <cstring>

#include "io/tangle_document.h"

namespace flg::io {

namespace {

using OrderedJson = nlohmann::ordered_json;

// Longer arrays go into the side file.
constexpr uint64_t longest_line = 12;  // numbers

// The double with the fewest digits that is read as this float.
double shortest(float value) {
    char text[32];
    char* const end = std::to_chars(text, text + sizeof text, value).ptr;
    double number = value;
    std::from_chars(text, end, number);
    return static_cast<float>(number) == value ? number : double{value};
}

OrderedJson number(float value, const std::string& place) {
    if (!(std::abs(value) <= max_coordinate)) {
        fail(FLG_ERROR_INVALID_ARGUMENT, place, "is %g, must be finite and at most 1e30 in size", double{value});
    }
    return shortest(value);
}

std::string hex(uint64_t number) {
    char text[17];
    std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(number));
    return text;
}

class Writer {
public:
    OrderedJson step(const FlgTangleStep& step, const std::string& place);

    std::string arrays;

private:
    // `count` items of `words` words each, at `data`; to_json makes a number of a word.
    template <class ToJson>
    OrderedJson list(const void* data, uint64_t count, uint32_t words, const std::string& where, ToJson to_json) {
        if (count > 0 && !data) fail(FLG_ERROR_INVALID_ARGUMENT, where, "is null");
        const auto* const bytes = static_cast<const char*>(data);
        if (count * words > longest_line) {
            const size_t at = arrays.size();
            if (at + count * words * 4 > max_bytes)
                fail(FLG_ERROR_LIMIT, where, "makes the document's arrays too large");
            arrays.append(bytes, count * words * 4);
            return {{"at", at}, {"count", count}};
        }
        OrderedJson numbers = OrderedJson::array();
        for (uint64_t i = 0; i < count * words; ++i) numbers.push_back(to_json(bytes + 4 * i, i % words));
        return numbers;
    }
    OrderedJson integers(const uint32_t* data, uint64_t count, const std::string& where) {
        return list(data, count, 1, where, [](const char* word, uint64_t) {
            uint32_t value;
            std::memcpy(&value, word, sizeof value);
            return OrderedJson(value);
        });
    }
    OrderedJson floats(const float* data, uint64_t count, uint32_t words, const std::string& where) {
        for (uint64_t i = 0; data && i < count * words; ++i) number(data[i], where);
        return list(data, count, words, where, [&](const char* word, uint64_t) {
            float value;
            std::memcpy(&value, word, sizeof value);
            return number(value, where);
        });
    }
    OrderedJson points(const FlgSurfacePoint* data, uint64_t count, const std::string& where) {
        for (uint64_t i = 0; data && i < count; ++i) {
            number(data[i].u, where);
            number(data[i].v, where);
        }
        return list(data, count, 3, where, [&](const char* word, uint64_t k) {
            uint32_t index;
            float weight;
            std::memcpy(&index, word, sizeof index);
            std::memcpy(&weight, word, sizeof weight);
            return k == 0 ? OrderedJson(index) : number(weight, where);
        });
    }
    OrderedJson seeds(const FlgTangleSeeds& seeds, const std::string& place);
    OrderedJson places(const FlgTangleSeedPlaces& places, const std::string& place);
    void divide(OrderedJson& json, const FlgTangleDivideDesc& desc, const std::string& place);
    void macro(OrderedJson& json, const FlgTangleMacroDesc& desc, const std::string& place);
    void displace(OrderedJson& json, const FlgTangleDisplaceDesc& desc, const std::string& place);
};

// What a host wrote into an enum, which may be none of its values (reading that as the enum would be undefined).
template <class Enum>
int32_t number_of(const Enum& value) {
    int32_t number;
    std::memcpy(&number, &value, sizeof number);
    return number;
}

template <size_t count>
const char* word_of(const char* const (&words)[count], int32_t value, const std::string& place) {
    if (value < 0 || static_cast<size_t>(value) >= count) {
        fail(FLG_ERROR_INVALID_ARGUMENT, place, "is %d, which is none of its values", value);
    }
    return words[value];
}

template <class T>
const T& need(const T* pointer, const std::string& place) {
    if (!pointer) fail(FLG_ERROR_INVALID_ARGUMENT, place, "is null");
    return *pointer;
}

OrderedJson Writer::seeds(const FlgTangleSeeds& seeds, const std::string& place) {
    OrderedJson json = OrderedJson::object();
    if (number_of(seeds.borders) != FLG_TANGLE_BORDERS_NONE) {
        json["borders"] = word_of(border_words, number_of(seeds.borders), place + ".borders");
    }
    for (uint32_t i = 0; i < seeds.stretch_count; ++i) {
        const std::string where = place + ".stretches";
        const FlgBorderStretch& stretch = (&need(seeds.stretches, where))[i];
        json["stretches"].push_back(
            {{"loop", stretch.loop}, {"begin", number(stretch.begin, where)}, {"end", number(stretch.end, where)}});
    }
    if (seeds.point_count > 0) json["points"] = points(seeds.points, seeds.point_count, place + ".points");
    if (seeds.sample_radius != 0) {
        json["samples"]["radius"] = number(seeds.sample_radius, place + ".sample_radius");
        if (seeds.sample_count != 0) json["samples"]["count"] = seeds.sample_count;
    }
    if (seeds.border_spacing != 0) json["spacing"] = number(seeds.border_spacing, place + ".border_spacing");
    if (seeds.region_count > 0) json["of"] = integers(seeds.regions, seeds.region_count, place + ".regions");
    return json;
}

OrderedJson Writer::places(const FlgTangleSeedPlaces& places, const std::string& place) {
    OrderedJson json = OrderedJson::object();
    if (places.point_count > 0) json["points"] = floats(places.points, places.point_count, 3, place + ".points");
    if (places.loop_count > 0) json["loops"] = floats(places.loops, places.loop_count, 3, place + ".loops");
    if (places.sample_count > 0) json["samples"] = floats(places.samples, places.sample_count, 3, place + ".samples");
    const FlgSurfaceCurvesView& curves = places.curves;
    if (curves.curve_count == 0) return json;
    const std::string where = place + ".curves";
    const uint32_t* const offsets = &need(curves.curve_offsets, where + ".curve_offsets");
    const uint8_t* const flags = &need(curves.curve_flags, where + ".curve_flags");
    const uint32_t count = offsets[curves.curve_count];
    const std::vector<uint32_t> words(flags, flags + curves.curve_count);
    json["curves"]["offsets"] = integers(offsets, uint64_t{curves.curve_count} + 1, where);
    json["curves"]["flags"] = integers(words.data(), words.size(), where);
    json["curves"]["values"] = floats(curves.curve_values, curves.curve_count, 1, where + ".curve_values");
    json["curves"]["points"] = points(curves.points, count, where + ".points");
    if (places.curve_points) json["curves"]["places"] = floats(places.curve_points, count, 3, place + ".curve_points");
    return json;
}

void Writer::divide(OrderedJson& json, const FlgTangleDivideDesc& desc, const std::string& place) {
    json["op"] = word_of(operator_words, number_of(desc.kind), place + ".kind");
    json["on"] = integers(desc.regions, desc.region_count, place + ".regions");
    json["from"] = seeds(desc.a, place + ".a");
    OrderedJson to = seeds(desc.b, place + ".b");
    if (!to.empty()) json["to"] = std::move(to);
    json["delta"] = number(desc.delta, place + ".delta");
    json["count"] = desc.count;
    json["groups"] = word_of(grouping_words, number_of(desc.grouping), place + ".grouping");
    if (number_of(desc.grouping) == FLG_TANGLE_GROUP_CYCLE) json["cycle"] = desc.cycle;
    if (desc.scaffold != 0) json["scaffold"] = true;
    if (desc.closed != 0) json["closed"] = true;
    if (desc.perturbation != 0) {
        json["perturbation"] = number(desc.perturbation, place + ".perturbation");
        json["frequency"] = number(desc.frequency, place + ".frequency");
    }
    json["seed"] = desc.seed;
}

void Writer::macro(OrderedJson& json, const FlgTangleMacroDesc& desc, const std::string& place) {
    json["op"] = word_of(macro_words, number_of(desc.kind), place + ".kind");
    json["on"] = integers(desc.regions, desc.region_count, place + ".regions");
    json["count"] = desc.count;
    json["size"] = number(desc.size, place + ".size");
    json["spacing"] = number(desc.spacing, place + ".spacing");
    json["seed"] = desc.seed;
}

void Writer::displace(OrderedJson& json, const FlgTangleDisplaceDesc& desc, const std::string& place) {
    json["op"] = change_words[displace_word];
    json["on"] = integers(desc.regions, desc.region_count, place + ".regions");
    json["amount"] = number(desc.amount, place + ".amount");
    json["bias"] = number(desc.bias, place + ".bias");
    json["gain"] = number(desc.gain, place + ".gain");
    json["reach"] = number(desc.reach, place + ".reach");
}

OrderedJson Writer::step(const FlgTangleStep& step, const std::string& place) {
    OrderedJson json;
    const int32_t kind = number_of(step.kind);
    switch (kind) {
        case FLG_TANGLE_STEP_DIVIDE: divide(json, need(step.divide, place + ".divide"), place + ".divide"); break;
        case FLG_TANGLE_STEP_MACRO: macro(json, need(step.macro, place + ".macro"), place + ".macro"); break;
        case FLG_TANGLE_STEP_DISPLACE:
            displace(json, need(step.displace, place + ".displace"), place + ".displace");
            break;
        case FLG_TANGLE_STEP_UNGROUP:
            json["op"] = change_words[ungroup_word];
            json["group"] = step.group;
            break;
        case FLG_TANGLE_STEP_GROUP:
        case FLG_TANGLE_STEP_JOIN:
            json["op"] = change_words[kind == FLG_TANGLE_STEP_GROUP ? group_word : join_word];
            json["on"] = integers(step.regions, step.region_count, place + ".regions");
            break;
        default: fail(FLG_ERROR_INVALID_ARGUMENT, place + ".kind", "is %d, which is none of its values", kind);
    }
    json["first"] = step.first_region;
    if (step.made_count > 0) json["made"] = floats(step.made, step.made_count, 3, place + ".made");
    if (step.placed != 0) json["placed"] = true;
    for (uint32_t i = 0; i < step.place_count; ++i) {
        const std::string where = place + ".places[" + std::to_string(i) + "]";
        json["places"].push_back(places((&need(step.places, where))[i], where));
    }
    return json;
}

}  // namespace

uint64_t checksum_of(Bytes bytes) {
    uint64_t sum = 0xcbf29ce484222325;
    for (const uint8_t byte : bytes) sum = (sum ^ byte) * 0x100000001b3;
    return sum;
}

TangleText write_tangle(const FlgTangleHistory& history, const std::string& file_name) {
    if (history.made_count > history.step_count) {
        fail(FLG_ERROR_INVALID_ARGUMENT, "history.made_count", "is %u, but there are %u steps", history.made_count,
             history.step_count);
    }
    Writer writer;
    std::string steps;
    for (uint32_t i = 0; i < history.step_count; ++i) {
        const std::string place = "history.steps[" + std::to_string(i) + "]";
        const FlgTangleStep& step = (&need(history.steps, "history.steps"))[i];
        if (step.struct_size < sizeof step) {
            fail(FLG_ERROR_INVALID_ARGUMENT, place, "has the struct_size %u, must be at least %zu", step.struct_size,
                 sizeof step);
        }
        steps += (i == 0 ? "\n    " : ",\n    ") + writer.step(step, place).dump();
        if (steps.size() > max_tangle_json) fail(FLG_ERROR_LIMIT, place, "makes the document too large");
    }
    TangleText text;
    OrderedJson head;
    head["filigree"] = "tangle";
    head["version"] = tangle_document_version;
    head["base"] = hex(history.base);
    for (const float value : history.box_min) head["box"].push_back(number(value, "history.box_min"));
    for (const float value : history.box_max) head["box"].push_back(number(value, "history.box_max"));
    head["made"] = history.made_count;
    if (!writer.arrays.empty()) {
        text.side.bytes = writer.arrays.size();
        text.side.checksum =
            checksum_of({reinterpret_cast<const uint8_t*>(writer.arrays.data()), writer.arrays.size()});
        text.side.name = file_name + "." + hex(text.side.checksum) + ".bin";
        head["arrays"] = {{"file", text.side.name}, {"bytes", text.side.bytes}, {"checksum", hex(text.side.checksum)}};
    }
    text.json = head.dump(2);
    text.json.erase(text.json.size() - 2);  // the brace on its line
    text.json += ",\n  \"steps\": [" + steps + (history.step_count > 0 ? "\n  ]\n}\n" : "]\n}\n");
    text.arrays = std::move(writer.arrays);
    return text;
}

}  // namespace flg::io
