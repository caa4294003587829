// SPDX-License-Identifier: MIT
// The studio's parts that need no window.
#include <gtest/gtest.h>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <cmath>
#include <fstream>

#include "shell/document.h"
#include "shell/input.h"
#include "shell/pen.h"
#include "shell/script.h"
#include "shell/view.h"
#include "tools/program.h"

namespace flg::studio {
namespace {

using Kind = InputEvent::Kind;

TEST(StudioView, RaysGoThroughWhatIsProjectedToTheirPixel) {
    View view;
    view.orbit.camera = {{1.5f, 0.7f, 2.0f}, {0.1f, 0.3f, -0.2f}};
    view.viewport = {300, 60, 700, 500};
    for (const glm::vec3 point : {glm::vec3(0), glm::vec3(0.4f, -0.3f, 0.1f), glm::vec3(-0.5f, 0.6f, 0.2f)}) {
        const auto px = view.project(point);
        ASSERT_TRUE(px);
        const Ray ray = view.ray(*px);
        const glm::vec3 arm = point - ray.origin;
        EXPECT_LT(glm::length(arm - ray.direction * glm::dot(arm, ray.direction)), 1e-4f);
        // A pixel aside is as far as said.
        const auto aside =
            meet_plane(view.ray(*px + glm::vec2(1, 0)), point, view.orbit.camera.eye - view.orbit.camera.target);
        ASSERT_TRUE(aside);
        EXPECT_NEAR(glm::distance(*aside, point), view.metres_per_px(point), 1e-2f * view.metres_per_px(point));
    }
    EXPECT_FALSE(view.project(view.orbit.camera.eye + (view.orbit.camera.eye - view.orbit.camera.target)));
    // The target is in the picture's middle.
    const auto middle = view.project(view.orbit.camera.target);
    EXPECT_NEAR(middle->x, 650.0f, 1e-2f);
    EXPECT_NEAR(middle->y, 310.0f, 1e-2f);
}

TEST(StudioView, FramesABoxFromAnySide) {
    View view;
    view.viewport = {0, 0, 640, 480};
    const render::Box box{{-1, 0, -2}, {3, 1, 1}};
    for (const glm::vec3 sight : {glm::vec3(0, 0, -1), glm::vec3(-1, 0, 0), glm::vec3(0, -1, 0), glm::vec3(1, -2, 3)}) {
        view.frame(box, sight);
        for (int corner = 0; corner < 8; ++corner) {
            const auto px = view.project({corner & 1 ? 3 : -1, corner & 2 ? 1 : 0, corner & 4 ? 1 : -2});
            ASSERT_TRUE(px);
            EXPECT_TRUE(view.contains(*px));
        }
    }
}

TEST(StudioInput, AButtonChangesOnceAFrame) {
    Input input;
    input.push({.kind = Kind::move, .px = {10, 20}});
    input.push({.kind = Kind::press, .code = kLeft});
    input.push({.kind = Kind::release, .code = kLeft});
    input.push({.kind = Kind::press, .code = kLeft});
    input.begin_frame();
    EXPECT_TRUE(input.pressed[kLeft] && input.down[kLeft] && !input.released[kLeft]);
    input.begin_frame();
    EXPECT_TRUE(input.released[kLeft] && !input.down[kLeft] && !input.pressed[kLeft]);
    input.begin_frame();
    EXPECT_TRUE(input.pressed[kLeft] && input.down[kLeft]);
    input.begin_frame();
    EXPECT_TRUE(input.down[kLeft] && !input.pressed[kLeft]);
    EXPECT_FALSE(input.pending());
}

TEST(StudioInput, KeepsEachPlaceOfTheMouseAndEachKey) {
    Input input;
    for (int i = 0; i < 5; ++i) input.push({.kind = Kind::move, .px = {static_cast<float>(i), 0}, .seconds = 0.01 * i});
    input.push({.kind = Kind::key_press, .code = GLFW_KEY_LEFT_SHIFT});
    input.push({.kind = Kind::key_press, .code = GLFW_KEY_B, .modifiers = GLFW_MOD_SHIFT});
    input.push({.kind = Kind::press, .code = 77});  // a button of a strange mouse
    input.push({.kind = Kind::key_press, .code = -1});
    input.push({.kind = Kind::move, .px = {9, 9}});
    input.push({.kind = Kind::key_release, .code = GLFW_KEY_B});
    input.begin_frame();
    ASSERT_EQ(input.path.size(), 6u);
    EXPECT_EQ(input.path[3].px.x, 3.0f);
    EXPECT_EQ(input.px, glm::vec2(9));
    EXPECT_TRUE(input.shift());
    ASSERT_TRUE(input.pressed_key);
    EXPECT_EQ(input.pressed_key->key, GLFW_KEY_B);
    EXPECT_TRUE(input.keys[GLFW_KEY_B]);
    input.begin_frame();
    EXPECT_FALSE(input.keys[GLFW_KEY_B] || input.pressed_key);
}

TEST(StudioInput, AChordTypedBetweenTwoFramesKeepsItsModifiers) {
    Input input;
    input.push({.kind = Kind::key_press, .code = GLFW_KEY_LEFT_CONTROL});
    input.push({.kind = Kind::key_press, .code = GLFW_KEY_Z, .modifiers = GLFW_MOD_CONTROL});
    input.push({.kind = Kind::key_release, .code = GLFW_KEY_LEFT_CONTROL, .modifiers = GLFW_MOD_CONTROL});
    input.push({.kind = Kind::key_release, .code = GLFW_KEY_Z});
    input.push({.kind = Kind::press, .code = kLeft, .modifiers = GLFW_MOD_SHIFT});
    input.begin_frame();
    EXPECT_TRUE(input.control());
    ASSERT_TRUE(input.pressed_key);
    EXPECT_EQ(input.pressed_key->modifiers, GLFW_MOD_CONTROL);
    input.begin_frame();
    EXPECT_TRUE(input.shift() && !input.control() && input.pressed[kLeft]);
}

TEST(StudioInput, KeysAndTextArriveInTheirOrderOneAFrame) {
    Input input;
    const auto type = [&](int key, char32_t character) {
        input.push({.kind = Kind::key_press, .code = key});
        if (character != 0) input.push({.kind = Kind::text, .code = static_cast<int>(character)});
        input.push({.kind = Kind::key_release, .code = key});
    };
    type(GLFW_KEY_A, U'a');
    type(GLFW_KEY_BACKSPACE, 0);
    type(GLFW_KEY_BACKSPACE, 0);
    type(GLFW_KEY_B, U'b');
    input.push({.kind = Kind::press, .code = kLeft});
    std::u32string seen;
    for (int frame = 0; input.pending(); ++frame) {
        ASSERT_LT(frame, 20);
        const bool was_down = input.keys[GLFW_KEY_BACKSPACE];
        input.begin_frame();
        if (input.pressed_key && input.pressed_key->key == GLFW_KEY_BACKSPACE) {
            EXPECT_FALSE(was_down) << "who looks at the keys alone must see it go down twice";
            seen += U'<';
        }
        seen += input.text;
        EXPECT_TRUE(input.text.empty() || !input.pressed[kLeft]);
    }
    EXPECT_EQ(seen, U"a<<b");
    EXPECT_TRUE(input.pressed[kLeft]);
}

TEST(StudioInput, WhatWasDoneBeforeAPressIsNoPartOfIt) {
    Input input;
    input.push({.kind = Kind::move, .px = {10, 10}});
    input.begin_frame();
    input.push({.kind = Kind::move, .px = {400, 10}, .seconds = 1.0});
    input.push({.kind = Kind::move, .px = {500, 60}, .seconds = 1.1});
    input.push({.kind = Kind::press, .code = kLeft, .seconds = 1.2});
    input.push({.kind = Kind::move, .px = {510, 60}, .seconds = 1.3});
    input.begin_frame();
    ASSERT_EQ(input.path.size(), 1u);
    EXPECT_EQ(input.path[0].px, glm::vec2(500, 60));
    EXPECT_EQ(input.path[0].seconds, 1.2);
    EXPECT_EQ(input.moved, glm::vec2(0));
    input.begin_frame();
    EXPECT_EQ(input.moved, glm::vec2(10, 0));
}

TEST(StudioInput, WhatASlowFrameMissedCameOneAfterTheOther) {
    Input input;
    input.push({.kind = Kind::move, .px = {0, 0}, .seconds = 1.0});
    input.came_between(0.9, 1.0);
    for (int i = 1; i <= 4; ++i) input.push({.kind = Kind::move, .px = {static_cast<float>(i), 0}, .seconds = 1.4});
    input.came_between(1.0, 1.4);
    input.push({.kind = Kind::move, .px = {5, 0}, .seconds = 2.0});
    input.came_at_once();
    input.came_between(3.0, 4.0);
    input.begin_frame();
    ASSERT_EQ(input.path.size(), 6u);
    const double came[] = {1.0, 1.1, 1.2, 1.3, 1.4, 2.0};
    for (size_t i = 0; i < 6; ++i) EXPECT_DOUBLE_EQ(input.path[i].seconds, came[i]);
}

TEST(StudioInput, WaitsForADialogThatOpens) {
    Input input;
    input.push({.kind = Kind::key_press, .code = GLFW_KEY_A});
    input.begin_frame(true);
    EXPECT_TRUE(!input.pressed_key && input.pending());
    input.begin_frame();
    EXPECT_TRUE(input.pressed_key && !input.pending());
}

TEST(StudioDocument, IsTheOldOneOrTheNewOneAndNothingElseIsLeft) {
    const test::Folder folder;
    const std::string path = (folder / "a.filigree").string();
    write_document(path, {{"value", 1}});
    write_document(path, {{"value", 2}});
    EXPECT_EQ(read_document(path).at("value"), 2);
    EXPECT_EQ(folder.list(), std::vector<std::string>{"a.filigree"});
    EXPECT_THROW(write_document((folder / "none/a.filigree").string(), {}), StudioError);
    EXPECT_EQ(folder.list().size(), 1u);
}

TEST(StudioDocument, ACopyOfAnotherProcessIsFoundOnceThatIsGone) {
    const test::Folder folder;
    // No process has this number: it is above what Linux gives.
    folder.write("autosave-99999999.filigree", "{\"filigree\": 1, \"value\": 5}");
    folder.write("autosave-1.filigree", "{\"filigree\": 1}");  // of one that runs
    folder.write("notes.txt", "");
    Autosave autosave(folder.path().string());
    const std::vector<std::string> left = autosave.left_behind();
    ASSERT_EQ(left.size(), 1u);
    EXPECT_EQ(read_document(left[0]).at("value"), 5);
}

TEST(StudioDocument, ACopyComesWithTimeAndGoesWithASave) {
    const test::Folder folder;
    {
        Autosave autosave(folder.path().string());
        EXPECT_FALSE(autosave.due(1.0, 1));
        EXPECT_TRUE(autosave.due(100.0, 1));
        EXPECT_FALSE(autosave.due(100.0, 0)) << "nothing has changed";
        autosave.write([] { return nlohmann::json{{"value", 7}}; }, 100.0, 1);
        EXPECT_FALSE(autosave.due(100.5, 2));
        autosave.forget(2);
        EXPECT_TRUE(folder.list().empty());
        autosave.write([] { return nlohmann::json{{"value", 8}}; }, 200.0, 3);
    }
    EXPECT_TRUE(folder.list().empty()) << "a program that ends in good order leaves none";
}

TEST(StudioScript, ReadsWordsLabelsAndComments) {
    const test::Folder folder;
    folder.write("a.txt", "# nothing\n\nclick \"New layer\" double # why\n\tmove 0.5,0.5\r\n");
    const std::vector<ScriptStep> steps = read_script((folder / "a.txt").string());
    ASSERT_EQ(steps.size(), 2u);
    EXPECT_EQ(steps[0].line, 3);
    EXPECT_EQ(steps[0].words, (std::vector<std::string>{"click", "New layer", "double"}));
    EXPECT_TRUE(steps[0].quoted[1] && !steps[0].quoted[2]);
    EXPECT_EQ(steps[1].words, (std::vector<std::string>{"move", "0.5,0.5"}));
}

TEST(StudioPen, MapsWhatADeviceSaysToAPressure) {
    EXPECT_EQ(pressure_of(0.0, 0.0, 2047.0), 0.0f);
    EXPECT_EQ(pressure_of(2047.0, 0.0, 2047.0), 1.0f);
    EXPECT_EQ(pressure_of(150.0, 100.0, 200.0), 0.5f);
    EXPECT_EQ(pressure_of(-5.0, 0.0, 10.0), 0.0f);
    EXPECT_EQ(pressure_of(11.0, 0.0, 10.0), 1.0f);
    EXPECT_EQ(pressure_of(3.0, 0.0, 0.0), 1.0f) << "a device without a range";
    EXPECT_EQ(pressure_of(std::nan(""), 0.0, 1.0), 1.0f);
}

TEST(StudioPen, ItsPressureComesWithEachPlace) {
    Input input;
    float pressure = 0.25f;
    listen(nullptr, {&input, [] { return 1.0; }, [&] { return pressure; }});
    heard::cursor(nullptr, 10, 20);
    heard::button(nullptr, GLFW_MOUSE_BUTTON_LEFT, GLFW_PRESS, 0);
    input.begin_frame();
    ASSERT_EQ(input.path.size(), 1u);
    EXPECT_EQ(input.path[0].pressure, 0.25f);
    pressure = 0.75f;
    heard::cursor(nullptr, 11, 20);
    input.begin_frame();
    ASSERT_EQ(input.path.size(), 1u);
    EXPECT_EQ(input.path[0].pressure, 0.75f);
    listen(nullptr, {});
}

}  // namespace
}  // namespace flg::studio
