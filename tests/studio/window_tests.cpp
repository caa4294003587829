// SPDX-License-Identifier: MIT
// The studio in its window, used with a real mouse and real keys. Labels are aimed at where they are; nothing here
// knows the layout.
#include <gtest/gtest.h>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "shell/input.h"
#include "studio/desktop.h"
#include "studio/pictures.h"

namespace flg::test {
namespace {

const std::vector<std::string> kCounts = {"strokes.count",  "tangles.acts", "skeletons.parts", "splines.points",
                                          "splines.curves", "scene.meshes", "studio.unsaved",  "tangles.trying"};

std::vector<std::string> sized(const std::string& size, const std::string& scale, std::vector<std::string> more = {}) {
    more.insert(more.end(), {"--size", size, "--scale", scale, "--autosave", ""});
    return more;
}

bool shows(const nlohmann::json& report, const char* label) {
    return report.at("labels").contains(label);
}

TEST(StudioWindow, HearsMouseKeysAndItsCloseButton) {
    const Desktop desktop(1280, 800);
    Person person(desktop, sized("1280x800", "1"), kCounts);
    person.drag({{0.4, 0.4}, {0.6, 0.45}, {0.5, 0.6}});
    EXPECT_EQ(person.count("strokes.count"), 1);
    person.keys({"ctrl+z"});
    EXPECT_EQ(person.count("strokes.count"), 0);
    person.keys({"ctrl+shift+z"});
    EXPECT_EQ(person.count("strokes.count"), 1);
    // Work that is not saved is asked about first.
    person.press_close();
    person.until("the question", [](const auto& now) { return shows(now, "Cancel##changes"); });
    person.rest();
    person.keys({"Escape"});
    EXPECT_FALSE(person.sees("Cancel##changes"));
    EXPECT_TRUE(person.studio().runs());
    person.keys({"ctrl+z"});
    person.press_close();
    person.until("the question", [](const auto& now) { return shows(now, "Discard##changes"); });
    person.rest();
    person.leave("Discard##changes");
    EXPECT_EQ(person.studio().wait(), 0);
    EXPECT_EQ(person.said(), "");
}

// In one run: the tasks of all workspaces, saved, closed, opened again.
void does_all_tasks(int width, int height, const std::string& size, const std::string& scale) {
    const Folder folder;
    const std::string document = (folder / "work.filigree").string();
    const Desktop desktop(width, height);
    {
        Person person(desktop, sized(size, scale), kCounts);
        EXPECT_EQ(person.count("scene.meshes"), 1);

        person.click("style knit");
        person.drag({{0.42, 0.4}, {0.5, 0.47}, {0.58, 0.4}});
        EXPECT_EQ(person.count("strokes.count"), 1);

        person.click("Tangles");
        person.click("Contour");
        EXPECT_EQ(person.count("tangles.trying"), 1);
        person.keys({"Return"});
        EXPECT_EQ(person.count("tangles.acts"), 1);

        person.click("Splines");
        for (const Person::Share place : {Person::Share{0.45, 0.45}, {0.55, 0.5}, {0.5, 0.6}}) person.click(place);
        EXPECT_EQ(person.count("splines.points"), 3);
        person.keys({"Return"});

        person.click("Skeletons");
        std::vector<Person::Share> body, leg;
        for (int i = 0; i <= 16; ++i) {
            const double angle = 6.2831853 * i / 16;
            body.push_back({0.47 + 0.2 * std::cos(angle), 0.5 + 0.12 * std::sin(angle)});
            leg.push_back({0.6 + 0.03 * std::cos(angle), 0.65 + 0.16 * std::sin(angle)});
        }
        person.drag(body);
        person.drag(leg);
        EXPECT_EQ(person.count("skeletons.parts"), 2);

        EXPECT_EQ(person.count("studio.unsaved"), 1);
        person.keys({"ctrl+s"});
        person.type(document);
        person.keys({"Return"});
        EXPECT_EQ(person.count("studio.unsaved"), 0);
        EXPECT_TRUE(folder.has("work.filigree"));
        person.press_close();
        EXPECT_EQ(person.studio().wait(), 0);
        EXPECT_EQ(person.said(), "");
    }
    Person person(desktop, sized(size, scale), kCounts);
    person.keys({"ctrl+o"});
    person.type(document);
    person.keys({"Return"});
    const std::pair<const char*, int> kept[] = {{"scene.meshes", 2},    {"strokes.count", 1},  {"tangles.acts", 1},
                                                {"skeletons.parts", 2}, {"splines.curves", 1}, {"studio.unsaved", 0}};
    for (const auto& [name, count] : kept) EXPECT_EQ(person.count(name), count) << name;
    person.sleep();
    if (const char* pictures = std::getenv("FLG_TEST_PICTURES"))
        desktop.photograph(std::filesystem::path(pictures) / ("window_" + size + ".png"));
}

TEST(StudioWindow, DoesAllTasks) {
    does_all_tasks(1280, 800, "1280x800", "1");
}

TEST(StudioWindow, DoesAllTasksInASmallWindow) {
    does_all_tasks(900, 600, "900x600", "1");
}

TEST(StudioWindow, DoesAllTasksAtTwiceTheScale) {
    does_all_tasks(1800, 1200, "900x600", "2");
}

// What was made by different frames' arithmetic on the same places.
void expect_alike(const nlohmann::json& a, const nlohmann::json& b, const std::string& where) {
    if (a.is_number() && b.is_number()) {
        EXPECT_NEAR(a.get<double>(), b.get<double>(), 1e-4) << where;
        return;
    }
    ASSERT_EQ(a.type(), b.type()) << where;
    ASSERT_EQ(a.size(), b.size()) << where;
    if (a.is_object())
        for (const auto& [key, value] : a.items()) {
            ASSERT_TRUE(b.contains(key)) << where << "." << key;
            expect_alike(value, b.at(key), where + "." + key);
        }
    else if (a.is_array())
        for (size_t i = 0; i < a.size(); ++i) expect_alike(a[i], b[i], where + "[" + std::to_string(i) + "]");
    else
        EXPECT_EQ(a, b) << where;
}

TEST(StudioWindow, GlfwCallsWhatScriptsCall) {
    const Desktop desktop(320, 240);
    setenv("DISPLAY", desktop.display().c_str(), 1);
    ASSERT_EQ(glfwInit(), GLFW_TRUE);
    glfwWindowHint(GLFW_CLIENT_API, GLFW_NO_API);
    GLFWwindow* const window = glfwCreateWindow(320, 240, "test", nullptr, nullptr);
    ASSERT_NE(window, nullptr);
    studio::Input input;
    studio::listen(window, {&input, [] { return 7.0; }, {}});
    // Asking for what is installed replaces it.
    EXPECT_EQ(glfwSetCursorPosCallback(window, nullptr), studio::heard::cursor);
    EXPECT_EQ(glfwSetMouseButtonCallback(window, nullptr), studio::heard::button);
    EXPECT_EQ(glfwSetScrollCallback(window, nullptr), studio::heard::scroll);
    EXPECT_EQ(glfwSetKeyCallback(window, nullptr), studio::heard::key);
    EXPECT_EQ(glfwSetCharCallback(window, nullptr), studio::heard::character);
    EXPECT_EQ(glfwSetDropCallback(window, nullptr), studio::heard::drop);
    EXPECT_EQ(glfwSetWindowRefreshCallback(window, nullptr), studio::heard::refresh);
    studio::listen(nullptr, {});
    glfwDestroyWindow(window);
    glfwTerminate();
}

TEST(StudioWindow, ScriptsLeaveWhatAHandLeaves) {
    const Folder folder;
    const std::string by_hand = (folder / "hand.filigree").string(), by_script = (folder / "script.filigree").string();
    const Person::Share places[] = {{0.45, 0.45}, {0.55, 0.5}, {0.5, 0.6}};
    const Desktop desktop(1280, 800);
    std::string script = "open builtin:vase\nwait\nclick \"Splines\"\n";
    {
        Person person(desktop, sized("1280x800", "1"), kCounts);
        person.click("Splines");
        const std::vector<double> picture = person.report().at("picture");
        for (const Person::Share& place : places) {
            person.click(place);
            // A mouse is on whole pixels.
            const double x = std::round(picture[0] + place.x * picture[2]) - picture[0];
            const double y = std::round(picture[1] + place.y * picture[3]) - picture[1];
            char step[80];
            std::snprintf(step, sizeof step, "click %.9f,%.9f\nwait\n", x / picture[2], y / picture[3]);
            script += step;
        }
        person.keys({"Return"});
        person.move({0.98, 0.98});
        person.sleep();
        desktop.photograph(folder / "hand.png");
        person.keys_and_text({"ctrl+s"}, by_hand, {"Return"});
        EXPECT_EQ(person.count("studio.unsaved"), 0);
    }
    folder.write("script.txt",
                 script + "key enter\nmove 0.98,0.98\nwait\nframes 3\nshot script\nsave " + by_script + "\n");
    const Outcome outcome = run_program(FLG_STUDIO_PROGRAM,
                                        {"--script", (folder / "script.txt").string(), "--offscreen", "--size",
                                         "1280x800", "--out", folder.path().string()},
                                        folder.path());
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    expect_alike(nlohmann::json::parse(folder.read("hand.filigree")),
                 nlohmann::json::parse(folder.read("script.filigree")), "document");
    // The window also tells how long its frames take.
    EXPECT_LT(compare_pictures(folder / "hand.png", folder / "script.png").mean, 1.0);
}

TEST(StudioWindow, DrawsNothingWhileNothingHappens) {
    const Desktop desktop(900, 600);
    Person person(desktop, sized("900x600", "1"), kCounts);
    person.drag({{0.4, 0.4}, {0.6, 0.45}, {0.5, 0.6}});
    person.move({0.5, 0.5});
    // Long enough for what the pointer's rest brings, and for many of the frames there were before.
    const auto drawn = [&] { return person.report().at("drawn").get<uint64_t>(); };
    person.pass(0.6);
    person.sleep();
    const uint64_t before = drawn();
    person.pass(2.0);
    EXPECT_EQ(drawn(), before);
    // A button that is held does not keep it awake either.
    person.by_hand({"mousedown", "1"});
    person.pass(0.6);
    person.sleep();
    const uint64_t held = drawn();
    person.pass(1.0);
    EXPECT_EQ(drawn(), held);
    person.by_hand({"mouseup", "1"});
    person.rest();
    // It is there at once.
    person.keys({"ctrl+z"});
    EXPECT_GT(drawn(), held);
}

TEST(StudioWindow, NothingLeaksThroughMenusAndDialogs) {
    const Desktop desktop(1280, 800);
    Person person(desktop, sized("1280x800", "1"), kCounts);
    // A click, or a drag, that closes a menu does nothing else.
    person.click("Help");
    EXPECT_TRUE(person.sees("Keyboard and mouse"));
    person.drag({{0.4, 0.5}, {0.6, 0.5}});
    EXPECT_FALSE(person.sees("Keyboard and mouse"));
    EXPECT_EQ(person.count("strokes.count"), 0);
    // Escape closes a menu; keys don't reach the workspace behind it.
    person.click("File");
    person.keys({"e"});
    person.keys({"Escape"});
    EXPECT_FALSE(person.sees("Save as..."));
    person.drag({{0.4, 0.4}, {0.6, 0.4}});
    EXPECT_EQ(person.count("strokes.count"), 1) << "the E was heard behind the menu: it erases";
    // While a question is open, neither keys nor the mouse get through; Escape is its own.
    person.keys({"ctrl+n"});
    person.keys({"e", "ctrl+z", "ctrl+2"});
    EXPECT_TRUE(person.sees("Cancel##changes"));
    person.drag({{0.4, 0.1}, {0.6, 0.1}});
    EXPECT_EQ(person.count("strokes.count"), 1);
    person.keys({"Escape"});
    EXPECT_FALSE(person.sees("Cancel##changes"));
    person.drag({{0.4, 0.55}, {0.6, 0.55}});
    EXPECT_EQ(person.count("strokes.count"), 2);
}

TEST(StudioWindow, DialogsAreDrivenByKeysAlone) {
    const Folder folder;
    const std::string path = (folder / "a").string();
    const Desktop desktop(1280, 800);
    Person person(desktop, sized("1280x800", "1"), kCounts);
    person.drag({{0.4, 0.4}, {0.6, 0.4}});
    // Typed as fast as it can be, without waiting for the dialog: the offered name is replaced, Enter confirms.
    person.keys_and_text({"ctrl+s"}, path, {"Return"});
    EXPECT_EQ(person.count("studio.unsaved"), 0);
    EXPECT_TRUE(folder.has("a.filigree"));
    // Escape cancels, and what was typed is no shortcut.
    person.keys_and_text({"ctrl+shift+s"}, "geb", {"Escape"});
    EXPECT_FALSE(person.sees("Cancel##file"));
    EXPECT_EQ(folder.list(), std::vector<std::string>{"a.filigree"});
    // A file that is there is replaced by a second Enter.
    const std::string before = folder.read("a.filigree");
    person.drag({{0.4, 0.5}, {0.6, 0.5}});
    person.keys_and_text({"ctrl+shift+s"}, path, {"Return"});
    EXPECT_TRUE(person.sees("Replace##file"));
    EXPECT_EQ(folder.read("a.filigree"), before);
    person.keys({"Return"});
    EXPECT_NE(folder.read("a.filigree"), before);
    // Enter saves what is asked about, and goes on with what was wanted.
    person.drag({{0.4, 0.6}, {0.6, 0.6}});
    person.keys({"ctrl+n", "Return"});
    EXPECT_EQ(person.count("strokes.count"), 0);
    EXPECT_EQ(person.count("studio.unsaved"), 0);
}

TEST(StudioWindow, KeysTypedBetweenTwoFramesAreAllHeard) {
    const Desktop desktop(1280, 800);
    Person person(desktop, sized("1280x800", "1"), kCounts);
    for (const double y : {0.3, 0.4, 0.5}) person.drag({{0.4, y}, {0.6, y}});
    // Key by key in no time, Control let go before Z is.
    person.by_hand({"keydown", "ctrl", "keydown", "z", "keyup",   "ctrl", "keyup", "z",    "keydown", "ctrl",
                    "keydown", "z",    "keyup",   "z", "keydown", "z",    "keyup", "ctrl", "keyup",   "z"});
    person.rest();
    EXPECT_EQ(person.count("strokes.count"), 0);
    // Held long enough, a key repeats.
    person.by_hand({"keydown", "ctrl", "keydown", "shift", "keydown", "z"});
    person.until("all strokes again", [](const auto& now) { return now.at("counts").at("strokes.count") == 3; });
    person.by_hand({"keyup", "z", "keyup", "shift", "keyup", "ctrl"});
    person.rest();
}

TEST(StudioWindow, ShowsItsKeysFromAnywhere) {
    const Desktop desktop(1280, 800);
    Person person(desktop, sized("1280x800", "1"), kCounts);
    const auto shown = [&] { return person.has_window("Keyboard and mouse"); };
    person.keys({"F1"});
    EXPECT_TRUE(shown());
    person.keys({"Escape"});
    EXPECT_FALSE(shown());
    person.click("View");
    person.keys({"F1"});
    EXPECT_TRUE(shown());
    EXPECT_FALSE(person.sees("See everything"));
    person.keys({"F1"});
    EXPECT_FALSE(shown());
    person.click("Help");
    person.click("Keyboard and mouse");
    EXPECT_TRUE(shown());
}

TEST(StudioWindow, TakesFilesThatAreDroppedOnIt) {
    const Folder folder;
    folder.write("two words.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n");
    const Desktop desktop(1280, 800);
    Person person(desktop, sized("1280x800", "1"), kCounts);
    person.drop(Person::Share{0.5, 0.5}, {(folder / "two words.obj").string()});
    EXPECT_EQ(person.count("scene.meshes"), 2);
    EXPECT_TRUE(person.sees("two words"));
}

}  // namespace
}  // namespace flg::test
