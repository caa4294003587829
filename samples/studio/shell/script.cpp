// SPDX-License-Identifier: MIT
#include "shell/script.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <imgui.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <map>

#include "shell/studio_error.h"
#include "shell/widgets.h"

namespace flg::studio {
namespace {

using Kind = InputEvent::Kind;

constexpr int kPatience = 60;      // frames that a widget may take to appear
constexpr int kMaxWait = 60 * 60;  // frames without idleness: a minute of the script's time
constexpr int kMovesBetween = 12;  // of a drag

struct Key {
    int code;
    bool is_modifier;
};

const std::map<std::string, Key>& keys_by_name() {
    static const std::map<std::string, Key> names = [] {
        std::map<std::string, Key> all = {{"ctrl", {GLFW_KEY_LEFT_CONTROL, true}},
                                          {"shift", {GLFW_KEY_LEFT_SHIFT, true}},
                                          {"alt", {GLFW_KEY_LEFT_ALT, true}},
                                          {"enter", {GLFW_KEY_ENTER, false}},
                                          {"escape", {GLFW_KEY_ESCAPE, false}},
                                          {"delete", {GLFW_KEY_DELETE, false}},
                                          {"backspace", {GLFW_KEY_BACKSPACE, false}},
                                          {"space", {GLFW_KEY_SPACE, false}},
                                          {"tab", {GLFW_KEY_TAB, false}},
                                          {"home", {GLFW_KEY_HOME, false}},
                                          {"left", {GLFW_KEY_LEFT, false}},
                                          {"right", {GLFW_KEY_RIGHT, false}},
                                          {"up", {GLFW_KEY_UP, false}},
                                          {"down", {GLFW_KEY_DOWN, false}},
                                          {"[", {GLFW_KEY_LEFT_BRACKET, false}},
                                          {"]", {GLFW_KEY_RIGHT_BRACKET, false}}};
        for (char c = 'a'; c <= 'z'; ++c) all[std::string(1, c)] = {GLFW_KEY_A + (c - 'a'), false};
        for (char c = '0'; c <= '9'; ++c) all[std::string(1, c)] = {GLFW_KEY_0 + (c - '0'), false};
        for (int f = 1; f <= 12; ++f) all["f" + std::to_string(f)] = {GLFW_KEY_F1 + f - 1, false};
        return all;
    }();
    return names;
}

bool numbers(const std::string& text, std::vector<double>* out) {
    out->clear();
    const char* at = text.c_str();
    while (true) {
        char* end = nullptr;
        const double value = std::strtod(at, &end);
        if (end == at || !std::isfinite(value)) return false;
        out->push_back(value);
        if (*end == '\0') return true;
        if (*end != ',') return false;
        at = end + 1;
    }
}

double number(const std::string& text) {
    std::vector<double> values;
    if (!numbers(text, &values) || values.size() != 1) throw StudioError("\"" + text + "\" is no number.");
    return values[0];
}

// GLFW's bit for a modifier's key.
int bit_of(int key) {
    switch (key) {
        case GLFW_KEY_LEFT_CONTROL: return GLFW_MOD_CONTROL;
        case GLFW_KEY_LEFT_SHIFT: return GLFW_MOD_SHIFT;
        case GLFW_KEY_LEFT_ALT: return GLFW_MOD_ALT;
        default: return 0;
    }
}

int button_of(const ScriptStep& step) {
    for (const std::string& word : step.words) {
        if (word == "right") return kRight;
        if (word == "middle") return kMiddle;
    }
    return kLeft;
}

// Words that are no places but say how.
bool is_manner(const std::string& word) {
    return word == "right" || word == "middle" || word == "double" || keys_by_name().contains(word);
}

}  // namespace

ScriptPlayer::ScriptPlayer(ScriptHost& host, std::string name, std::vector<ScriptStep> steps)
    : host_(host), name_(std::move(name)), steps_(std::move(steps)) {}

bool ScriptPlayer::frame() {
    try {
        while (beats_.empty()) {
            if (next_ == steps_.size()) return false;
            const size_t before = next_;
            start(steps_[next_]);
            if (next_ == before) break;  // it waits
            tries_ = 0;
        }
    } catch (const StudioError& error) {
        throw StudioError(name_ + ":" + std::to_string(steps_[next_].line) + ": " + error.what());
    }
    if (beats_.empty()) return true;
    for (const InputEvent& event : beats_.front()) perform(event);
    beats_.pop_front();
    return true;
}

void ScriptPlayer::perform(const InputEvent& event) {
    switch (event.kind) {
        case Kind::move: return heard::cursor(nullptr, event.px.x, event.px.y);
        case Kind::press: return heard::button(nullptr, event.code, GLFW_PRESS, modifiers_);
        case Kind::release: return heard::button(nullptr, event.code, GLFW_RELEASE, modifiers_);
        case Kind::scroll: return heard::scroll(nullptr, event.px.x, event.px.y);
        case Kind::key_press:
            heard::key(nullptr, event.code, 0, GLFW_PRESS, modifiers_);
            modifiers_ |= bit_of(event.code);
            return;
        case Kind::key_release:
            heard::key(nullptr, event.code, 0, GLFW_RELEASE, modifiers_);
            modifiers_ &= ~bit_of(event.code);
            return;
        case Kind::text: return heard::character(nullptr, static_cast<unsigned>(event.code));
        case Kind::drop: {
            const char* path = event.path.c_str();
            return heard::drop(nullptr, 1, &path);
        }
        case Kind::expose: return heard::refresh(nullptr);
    }
}

void ScriptPlayer::start(const ScriptStep& step) {
    ++tries_;
    if (!start_mouse(step)) start_command(step);
}

bool ScriptPlayer::find(const ScriptStep& step, size_t word, glm::vec2* out) {
    if (word >= step.words.size()) throw StudioError("\"" + step.words[0] + "\" needs a place.");
    const std::string& text = step.words[word];
    if (step.quoted[word]) {
        const ui::Rect* rect = ui::find_widget(text);
        if (rect == nullptr) {
            if (tries_ < kPatience) return false;
            throw StudioError("there is no widget \"" + text + "\"; there are: " + ui::widget_labels() + ".");
        }
        *out = 0.5f * (rect->low + rect->high);
        const bool above = rect->low.y<rect->pane_low.y, below = rect->high.y> rect->pane_high.y;
        if (!above && !below) return true;
        if (tries_ >= kPatience) throw StudioError("the widget \"" + text + "\" can't be scrolled into sight.");
        const glm::vec2 pane = 0.5f * (rect->pane_low + rect->pane_high);
        beats_.push_back({{.kind = Kind::move, .px = pane}});
        beats_.push_back({{.kind = Kind::scroll, .px = {0.0f, above ? 1.0f : -1.0f}}});
        beats_.push_back({});
        return false;
    }
    std::vector<double> values;
    if (text.starts_with("world:")) {
        if (!numbers(text.substr(6), &values) || values.size() != 3)
            throw StudioError("\"" + text + "\" is no place; world:X,Y,Z is, in metres.");
        const auto px = host_.view().project(glm::vec3(values[0], values[1], values[2]));
        if (!px) throw StudioError("the place " + text + " lies behind the camera.");
        *out = *px;
        return true;
    }
    if (!numbers(text, &values) || values.size() != 2)
        throw StudioError("\"" + text +
                          "\" is no place; X,Y of the picture is (0 to 1), and world:X,Y,Z, and \"a label\".");
    const glm::ivec4 viewport = host_.view().viewport;
    *out = glm::vec2(viewport.x, viewport.y) + glm::vec2(values[0], values[1]) * glm::vec2(viewport.z, viewport.w);
    return true;
}

bool ScriptPlayer::start_mouse(const ScriptStep& step) {
    const std::string& verb = step.words[0];
    if (verb == "slide") {
        glm::vec2 at;
        if (find(step, 1, &at)) slide(step);
        return true;
    }
    if (verb != "move" && verb != "click" && verb != "drag" && verb != "scroll") return false;
    std::vector<glm::vec2> way;
    size_t word = 1;
    const size_t most = verb == "drag" ? step.words.size() : 2;
    for (; word < most && word < step.words.size() && (step.quoted[word] || !is_manner(step.words[word])); ++word) {
        glm::vec2 at;
        if (!find(step, word, &at)) return true;
        way.push_back(at);
    }
    if (way.empty()) throw StudioError("\"" + verb + "\" needs a place.");
    ++next_;
    if (verb == "move") {
        beats_.push_back({{.kind = Kind::move, .px = way[0]}});
        beats_.push_back({});
    } else if (verb == "click") {
        click(way[0], step);
    } else if (verb == "scroll") {
        const double notches = number(word < step.words.size() ? step.words[word] : "");
        beats_.push_back({{.kind = Kind::move, .px = way[0]}});
        beats_.push_back({{.kind = Kind::scroll, .px = {0.0f, static_cast<float>(notches)}}});
    } else {
        if (way.size() < 2) throw StudioError("\"drag\" needs two places at least.");
        drag(way, step, word);
    }
    return true;
}

void ScriptPlayer::hold(const ScriptStep& step, size_t from, bool press) {
    Beat beat;
    for (size_t i = from; i < step.words.size(); ++i) {
        const auto key = keys_by_name().find(step.words[i]);
        if (key != keys_by_name().end() && key->second.is_modifier)
            beat.push_back({.kind = press ? Kind::key_press : Kind::key_release, .code = key->second.code});
    }
    if (!beat.empty()) beats_.push_back(std::move(beat));
}

void ScriptPlayer::click(glm::vec2 at, const ScriptStep& step) {
    const int button = button_of(step);
    bool twice = false;
    for (const std::string& word : step.words) twice = twice || word == "double";
    hold(step, 2, true);
    beats_.push_back({{.kind = Kind::move, .px = at}});
    beats_.push_back({});  // hovered, before it is pressed
    for (int i = 0; i < (twice ? 2 : 1); ++i) {
        beats_.push_back({{.kind = Kind::press, .code = button}});
        beats_.push_back({{.kind = Kind::release, .code = button}});
    }
    hold(step, 2, false);
    beats_.push_back({});
}

void ScriptPlayer::drag(const std::vector<glm::vec2>& way, const ScriptStep& step, size_t places) {
    const int button = button_of(step);
    hold(step, places, true);
    beats_.push_back({{.kind = Kind::move, .px = way[0]}});
    beats_.push_back({});
    beats_.push_back({{.kind = Kind::press, .code = button}});
    for (size_t i = 1; i < way.size(); ++i) {
        for (int m = 1; m <= kMovesBetween; ++m) {
            const float share = static_cast<float>(m) / kMovesBetween;
            beats_.push_back({{.kind = Kind::move, .px = glm::mix(way[i - 1], way[i], share)}});
        }
    }
    beats_.push_back({{.kind = Kind::release, .code = button}});
    hold(step, places, false);
    beats_.push_back({});
}

void ScriptPlayer::slide(const ScriptStep& step) {
    if (step.words.size() != 3) throw StudioError("\"slide\" needs a label and a share, 0 to 1.");
    const ui::Rect rect = *ui::find_widget(step.words[1]);
    const auto share = static_cast<float>(number(step.words[2]));
    ++next_;
    // The grab's middle goes from half a grab within the one end to half a grab within the other.
    const float inset = 2.0f + 0.5f * ImGui::GetStyle().GrabMinSize;
    const float y = 0.5f * (rect.low.y + rect.high.y), width = rect.high.x - rect.low.x - 2.0f * inset;
    const auto at = [&](float part) { return glm::vec2(rect.low.x + inset + part * width, y); };
    drag({at(0.5f), at(share)}, step, 3);
}

void ScriptPlayer::keys(const std::string& chord) {
    Beat down, up;
    size_t begin = 0;
    while (begin <= chord.size()) {
        const size_t end = std::min(chord.find('+', begin), chord.size());
        const auto key = keys_by_name().find(chord.substr(begin, end - begin));
        if (key == keys_by_name().end())
            throw StudioError("there is no key \"" + chord.substr(begin, end - begin) + "\".");
        down.push_back({.kind = Kind::key_press, .code = key->second.code});
        up.insert(up.begin(), {.kind = Kind::key_release, .code = key->second.code});
        begin = end + 1;
    }
    beats_.push_back(std::move(down));
    beats_.push_back(std::move(up));
    beats_.push_back({});
}

void ScriptPlayer::expect(const ScriptStep& step) const {
    // expect NAME [=|<|>] VALUE [TOLERANCE]
    size_t word = 2;
    const std::string relation =
        word < step.words.size() && (step.words[word] == "<" || step.words[word] == ">" || step.words[word] == "=")
            ? step.words[word++]
            : "=";
    if (word >= step.words.size()) throw StudioError("\"expect\" needs a name and a value.");
    const double wanted = number(step.words[word++]);
    const double tolerance = word < step.words.size() ? number(step.words[word]) : 0.0;
    const double found = host_.count(step.words[1]);
    const bool holds = relation == "<"   ? found < wanted
                       : relation == ">" ? found > wanted
                                         : std::abs(found - wanted) <= tolerance;
    if (holds) return;
    char text[160];
    std::snprintf(text, sizeof text, " is %.9g; expected %s %.9g.", found, relation.c_str(), wanted);
    throw StudioError(step.words[1] + text);
}

void ScriptPlayer::start_command(const ScriptStep& step) {
    const std::string& verb = step.words[0];
    const auto word = [&](size_t i) -> const std::string& {
        if (i >= step.words.size()) throw StudioError("\"" + verb + "\" needs more than that.");
        return step.words[i];
    };
    if (verb == "wait") {
        // Twice in a row: what is done may start something else.
        if (host_.idle() && tries_ > 2)
            ++next_;
        else if (tries_ > kMaxWait)
            throw StudioError("the app is still busy.");
        return;
    }
    if (verb == "frames") {
        if (tries_ > static_cast<int>(number(word(1)))) ++next_;
        return;
    }
    if (verb == "key")
        keys(word(1));
    else if (verb == "type") {
        Beat beat;
        for (const char c : word(1)) beat.push_back({.kind = Kind::text, .code = c});
        beats_.push_back(std::move(beat));
        beats_.push_back({});
    } else if (verb == "open")
        host_.open_path(word(1));
    else if (verb == "drop")
        beats_.push_back({{.kind = Kind::drop, .path = word(1)}});
    else if (verb == "save")
        host_.save_path(word(1));
    else if (verb == "load")
        host_.load_path(word(1));
    else if (verb == "export")
        host_.export_path(word(1), word(2));
    else if (verb == "resize")
        host_.resize(static_cast<uint32_t>(number(word(1))), static_cast<uint32_t>(number(word(2))));
    else if (verb == "lose_device")
        host_.lose_device();
    else if (verb == "expect")
        expect(step);
    else if (verb == "look") {
        std::vector<double> v;
        if (!numbers(word(1), &v) || v.size() != 3 || (v[0] == 0 && v[1] == 0 && v[2] == 0))
            throw StudioError("\"" + word(1) + "\" is no direction; X,Y,Z is.");
        host_.view().frame(host_.scene_box(), glm::vec3(v[0], v[1], v[2]));
        beats_.push_back({});
    } else if (verb == "shot") {
        host_.take_shot(word(1), step.words.size() > 2 && step.words[2] == "all");
        beats_.push_back({});
    } else {
        throw StudioError("there is no step \"" + verb + "\".");
    }
    ++next_;
}

}  // namespace flg::studio
