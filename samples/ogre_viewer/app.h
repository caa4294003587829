// SPDX-License-Identifier: MIT
// An OGRE application with Filigree in its frame loop. Everything lives as long as it must: the SDK's objects end
// before their context, that before the job system's queue, and the queue with OGRE.
#pragma once

#include <OgreApplicationContext.h>
#include <OgreCameraMan.h>

#include <memory>
#include <optional>
#include <string>

#include "decorated_mesh.h"
#include "frame_times.h"
#include "host_hooks.h"
#include "job_system.h"
#include "skinned_model.h"
#include "strokes.h"

namespace viewer {

struct Options {
    uint32_t frames = 0;  // once all is made; 0: until the window is closed
    double rate = 60;     // of these frames, a second
    std::string screenshot;
    uint32_t width = 1280, height = 720;
};

class App final : public OgreBites::ApplicationContext, private OgreBites::InputListener {
public:
    explicit App(const Options& options);
    ~App() override;

    // Runs until the end; returns the bytes that the SDK has not given back.
    size_t run();

private:
    // What OGRE asks of its application.
    void createRoot() override;
    bool oneTimeConfig() override;
    void locateResources() override;
    void setup() override;
    bool frameStarted(const Ogre::FrameEvent& event) override;
    bool keyPressed(const OgreBites::KeyboardEvent& event) override;

    // Of all that is logged, by OGRE or Filigree: warnings and errors, on the console.
    struct Warnings final : Ogre::LogListener {
        void messageLogged(const Ogre::String& message, Ogre::LogMessageLevel level, bool, const Ogre::String&,
                           bool&) override;
    };
    struct Content;
    void place_camera(Ogre::SceneManager& scene);
    bool is_over() const;
    void report() const;
    size_t close();

    Options options_;
    Warnings warnings_;
    std::unique_ptr<Ogre::LogManager> log_;
    CountingAllocator allocator_;
    std::unique_ptr<JobSystem> jobs_;
    std::optional<filigree::Context> context_;
    std::unique_ptr<Content> content_;
    std::unique_ptr<OgreBites::CameraMan> camera_;
    double time_ = 0;  // seconds since all is made
    uint32_t frame_ = 0, frames_before_ = 0;
    bool closed_ = false;
    FrameTimes ticks_, frames_;
};

}  // namespace viewer
