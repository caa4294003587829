// SPDX-License-Identifier: MIT
#include "studio/desktop.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <chrono>
#include <cmath>
#include <cstring>
#include <stdexcept>
#include <thread>

#include "filigree_renderer/image.h"
#include "studio/x_messages.h"

namespace flg::test {
namespace {

using namespace std::chrono_literals;

constexpr auto kPatience = 120s;
// GLFW takes two presses of a key within a millisecond for one.
constexpr const char* kKeyGap_ms = "4";

[[noreturn]] void fail(const std::string& sentence) {
    throw std::runtime_error(sentence);
}

// Looks every few milliseconds; false after two minutes.
template <class Holds>
bool wait_until(Holds&& holds) {
    const auto end = std::chrono::steady_clock::now() + kPatience;
    while (!holds()) {
        if (std::chrono::steady_clock::now() > end) return false;
        std::this_thread::sleep_for(4ms);
    }
    return true;
}

uint32_t big_endian(const std::string& bytes, size_t word) {
    uint32_t value = 0;
    for (size_t i = 0; i < 4; ++i) value = value << 8 | static_cast<unsigned char>(bytes.at(4 * word + i));
    return value;
}

std::vector<std::string> held(const std::string& keys, const char* verb) {
    std::vector<std::string> commands;
    for (size_t begin = 0; begin < keys.size();) {
        const size_t end = std::min(keys.find(' ', begin), keys.size());
        commands.insert(commands.end(), {verb, keys.substr(begin, end - begin)});
        begin = end + 1;
    }
    return commands;
}

void append(std::vector<std::string>& to, const std::vector<std::string>& more) {
    to.insert(to.end(), more.begin(), more.end());
}

uint64_t keys_in(const std::vector<std::string>& chords) {
    uint64_t keys = 0;
    for (const std::string& chord : chords)
        keys += 1 + static_cast<uint64_t>(std::count(chord.begin(), chord.end() - 1, '+'));
    return keys;
}

// Some characters need Shift, which is let go too.
uint64_t keys_for(const std::string& text) {
    uint64_t keys = 0;
    for (const char c : text)
        keys += std::isupper(static_cast<unsigned char>(c)) || std::strchr("_:\"?+~!@#$%^&*(){}|<>", c) ? 2 : 1;
    return keys;
}

}  // namespace

Process::Process(const std::vector<std::string>& command, const std::string& log, int ready_fd) : id_(fork()) {
    if (id_ < 0) fail("can't fork");
    if (id_ > 0) return;
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    const int out = open(log.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    dup2(out, 1);
    dup2(out, 2);
    for (int fd = 3; fd < 64; ++fd)
        if (fd != ready_fd) close(fd);
    std::vector<char*> argv;
    for (const std::string& word : command) argv.push_back(const_cast<char*>(word.c_str()));
    argv.push_back(nullptr);
    execvp(argv[0], argv.data());
    _exit(127);
}

Process::~Process() {
    if (!runs()) return;
    kill(id_, SIGKILL);
    waitpid(id_, &status_, 0);
}

bool Process::runs() {
    if (!ended_) ended_ = waitpid(id_, &status_, WNOHANG) == id_;
    return !ended_;
}

int Process::wait() {
    if (!wait_until([&] { return !runs(); })) fail("the program does not end");
    return WIFEXITED(status_) ? WEXITSTATUS(status_) : -1;
}

Desktop::Desktop(int width, int height) {
    int ends[2];
    if (pipe(ends) != 0) fail("can't make a pipe");
    const std::string screen = std::to_string(width) + "x" + std::to_string(height) + "x24";
    server_ = std::make_unique<Process>(
        std::vector<std::string>{"Xvfb", "-displayfd", std::to_string(ends[1]), "-screen", "0", screen, "-nolisten",
                                 "tcp", "-noreset", "-fbdir", folder_.path().string()},
        (folder_ / "log").string(), ends[1]);
    close(ends[1]);
    display_ = ":";
    char digit = 0;
    while (read(ends[0], &digit, 1) == 1 && digit != '\n') display_ += digit;
    close(ends[0]);
    if (digit != '\n') fail("Xvfb does not start: " + folder_.read("log"));
}

void Desktop::photograph(const std::filesystem::path& png) const {
    // The screen's memory is a file: a header of 32-bit words (XWDFile.h), then colours of 12 bytes, then BGRX.
    const std::string screen = folder_.read("Xvfb_screen0");
    const size_t begin = big_endian(screen, 0) + 12 * size_t{big_endian(screen, 19)};
    render::Image image{big_endian(screen, 4), big_endian(screen, 5), {}};
    const size_t row = big_endian(screen, 12);
    image.pixels.resize(4 * size_t{image.width} * image.height);
    for (size_t y = 0; y < image.height; ++y) {
        for (size_t x = 0; x < image.width; ++x) {
            const size_t from = begin + y * row + 4 * x, to = 4 * (y * image.width + x);
            for (size_t c = 0; c < 3; ++c) image.pixels[to + c] = static_cast<uint8_t>(screen.at(from + 2 - c));
            image.pixels[to + 3] = 255;
        }
    }
    render::write_png(image, png.string());
}

Person::Person(const Desktop& desktop, const std::vector<std::string>& arguments,
               const std::vector<std::string>& counts)
    : desktop_(desktop) {
    std::vector<std::string> command = {"env",      "DISPLAY=" + desktop.display(), FLG_STUDIO_PROGRAM,
                                        "--report", (folder_ / "report").string(),  "--validation"};
    for (const std::string& name : counts) append(command, {"--count", name});
    append(command, arguments);
    studio_ = std::make_unique<Process>(command, (folder_ / "log").string());
    rest();
}

const nlohmann::json& Person::report() {
    if (!studio_->runs()) fail("the studio has ended: " + said());
    const std::string text = folder_.read("report");
    if (!text.empty()) report_ = nlohmann::json::parse(text);
    return report_;
}

void Person::until(const std::string& what, const std::function<bool(const nlohmann::json&)>& holds) {
    const bool held = wait_until([&] {
        const nlohmann::json& now = report();
        return !now.is_null() && holds(now);
    });
    if (!held)
        fail("waited two minutes for: " + what + "; wanted " + std::to_string(buttons_) + " buttons, " +
             std::to_string(keys_) + " keys, " + std::to_string(notches_) +
             " notches; the last report: " + report_.dump());
}

void Person::rest() {
    until("rest", [&](const nlohmann::json& now) {
        const nlohmann::json& taken = now.at("taken");
        return now.at("settled").get<bool>() && taken.at("buttons") >= buttons_ && taken.at("keys") >= keys_ &&
               taken.at("notches") >= notches_ && taken.at("drops") >= drops_;
    });
}

void Person::sleep() {
    until("sleep", [](const nlohmann::json& now) { return now.at("asleep").get<bool>(); });
}

double Person::count(const std::string& name) {
    return report().at("counts").at(name).get<double>();
}

bool Person::sees(const std::string& label) {
    return report().at("labels").contains(label);
}

bool Person::has_window(const std::string& title) {
    const std::vector<std::string> windows = report().at("windows");
    return std::find(windows.begin(), windows.end(), title) != windows.end();
}

void Person::by_hand(const std::vector<std::string>& commands) {
    std::vector<std::string> arguments = {"DISPLAY=" + desktop_.display(), "xdotool"};
    append(arguments, commands);
    const Outcome outcome = run_program("/usr/bin/env", arguments, folder_.path());
    if (outcome.status != 0) fail("xdotool: " + outcome.err);
    for (const std::string& word : commands) {
        if (word == "mouseup") ++buttons_;
        if (word == "keyup") ++keys_;
    }
}

void Person::act(const std::vector<std::string>& commands) {
    by_hand(commands);
    rest();
}

Person::Pixel Person::at(Share place) {
    const nlohmann::json& picture = report().at("picture");
    return {static_cast<int>(std::lround(picture[0].get<double>() + place.x * picture[2].get<double>())),
            static_cast<int>(std::lround(picture[1].get<double>() + place.y * picture[3].get<double>()))};
}

Person::Pixel Person::at(const std::string& label) {
    for (int turn = 0; turn < 60; ++turn) {
        const nlohmann::json& labels = report().at("labels");
        if (!labels.contains(label)) {
            std::string all;
            for (const auto& [name, rect] : labels.items()) all += (all.empty() ? "" : ", ") + name;
            fail("there is no \"" + label + "\" to be seen; there are: " + all);
        }
        const std::vector<double> rect = labels.at(label);
        const double y = 0.5 * (rect[1] + rect[3]);
        const Pixel middle = {static_cast<int>(0.5 * (rect[0] + rect[2])), static_cast<int>(y)};
        if (rect[1] >= rect[5] && rect[3] <= rect[7]) return middle;
        const int wheel = y < 0.5 * (rect[5] + rect[7]) ? 4 : 5;
        ++notches_;
        by_hand({"mousemove", std::to_string(static_cast<int>(0.5 * (rect[4] + rect[6]))),
                 std::to_string(static_cast<int>(0.5 * (rect[5] + rect[7]))), "click", std::to_string(wheel)});
        rest();
    }
    fail("\"" + label + "\" can't be scrolled into sight");
}

void Person::move(Share place) {
    const Pixel to = at(place);
    by_hand({"mousemove", std::to_string(to.x), std::to_string(to.y)});
    until("the pointer there", [&](const nlohmann::json& now) {
        return now.at("pointer")[0] == to.x && now.at("pointer")[1] == to.y && now.at("settled").get<bool>();
    });
}

void Person::click(Share place, const std::string& keys, int button) {
    const Pixel to = at(place);
    std::vector<std::string> commands = {"mousemove", std::to_string(to.x), std::to_string(to.y)};
    append(commands, held(keys, "keydown"));
    append(commands, {"mousedown", std::to_string(button), "mouseup", std::to_string(button)});
    append(commands, held(keys, "keyup"));
    act(commands);
}

void Person::click(const std::string& label, const std::string& keys) {
    const Pixel to = at(label);
    std::vector<std::string> commands = {"mousemove", std::to_string(to.x), std::to_string(to.y)};
    append(commands, held(keys, "keydown"));
    append(commands, {"mousedown", "1", "mouseup", "1"});
    append(commands, held(keys, "keyup"));
    act(commands);
}

void Person::drag(const std::vector<Share>& way, const std::string& keys, int button) {
    const int moves = std::max(1, 24 / static_cast<int>(way.size()));  // from place to place
    std::vector<std::string> commands = held(keys, "keydown");
    Pixel before = at(way.front());
    append(commands,
           {"mousemove", std::to_string(before.x), std::to_string(before.y), "mousedown", std::to_string(button)});
    for (size_t i = 1; i < way.size(); ++i) {
        const Pixel to = at(way[i]);
        for (int m = 1; m <= moves; ++m)
            append(commands, {"mousemove", std::to_string(before.x + (to.x - before.x) * m / moves),
                              std::to_string(before.y + (to.y - before.y) * m / moves), "sleep", "0.002"});
        before = to;
    }
    append(commands, {"mouseup", std::to_string(button)});
    append(commands, held(keys, "keyup"));
    act(commands);
}

void Person::slide(const std::string& label, double share) {
    const Pixel from = at(label);
    const std::vector<double> rect = report().at("labels").at(label);
    const int to = static_cast<int>(rect[0] + share * (rect[2] - rect[0]));
    act({"mousemove", std::to_string(from.x), std::to_string(from.y), "mousedown", "1", "mousemove", std::to_string(to),
         std::to_string(from.y), "mouseup", "1"});
}

void Person::scroll(Share place, int notches) {
    const Pixel to = at(place);
    std::vector<std::string> commands = {"mousemove", std::to_string(to.x), std::to_string(to.y)};
    for (int i = 0; i < std::abs(notches); ++i) append(commands, {"click", notches > 0 ? "4" : "5"});
    notches_ += static_cast<uint64_t>(std::abs(notches));
    act(commands);
}

void Person::keys(const std::vector<std::string>& chords) {
    std::vector<std::string> commands = {"key", "--delay", kKeyGap_ms};
    append(commands, chords);
    keys_ += keys_in(chords);
    act(commands);
}

void Person::type(const std::string& text) {
    keys_ += keys_for(text);
    act({"type", "--delay", kKeyGap_ms, text});
}

void Person::keys_and_text(const std::vector<std::string>& before, const std::string& text,
                           const std::vector<std::string>& after) {
    keys_ += keys_in(before) + keys_for(text) + keys_in(after);
    std::vector<std::string> first = {"key", "--delay", kKeyGap_ms}, last = first;
    append(first, before);
    append(last, after);
    by_hand(first);
    by_hand({"type", "--delay", kKeyGap_ms, text});
    act(last);
}

void Person::leave(const std::string& label) {
    const Pixel to = at(label);
    by_hand({"mousemove", std::to_string(to.x), std::to_string(to.y), "click", "1"});
}

void Person::drop(Share place, const std::vector<std::string>& paths) {
    const Pixel to = at(place);
    drop_files(desktop_.display(), to.x, to.y, paths);
    drops_ += paths.size();
    rest();
}

void Person::pass(double seconds) {
    std::this_thread::sleep_for(std::chrono::duration<double>(seconds));
}

void Person::press_close() {
    send_close(desktop_.display());
}

}  // namespace flg::test
