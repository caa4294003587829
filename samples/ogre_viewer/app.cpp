// SPDX-License-Identifier: MIT
#include "app.h"

#include <OgreCamera.h>
#include <OgreRenderWindow.h>
#include <OgreRoot.h>
#include <OgreViewport.h>

#include <cstdio>
#include <stdexcept>
#include <utility>

#include "stage.h"

namespace viewer {
namespace {

constexpr uint32_t kBudgetUs = 2000;  // of a frame, for the SDK
constexpr uint32_t kVaseColumns = 192;

// In the order of Colour.
std::vector<Ogre::MaterialPtr> glazes() {
    using Rgb = Ogre::ColourValue;
    return {
        make_material("cream", Rgb(0.82f, 0.74f, 0.58f), 0.25f), make_material("blue", Rgb(0.012f, 0.055f, 0.3f), 0.5f),
        make_material("rust", Rgb(0.46f, 0.065f, 0.022f), 0.35f),
        make_material("gold", Rgb(0.74f, 0.36f, 0.035f), 0.6f), make_material("sage", Rgb(0.27f, 0.45f, 0.32f), 0.3f)};
}

Ogre::SceneNode& place(Ogre::SceneNode* parent, const Ogre::Vector3& at, float degrees = 0, float scale = 1) {
    Ogre::SceneNode* const node = parent->createChildSceneNode(at, {Ogre::Degree(degrees), Ogre::Vector3::UNIT_Y});
    node->setScale(Ogre::Vector3(scale));
    return *node;
}

}  // namespace

// All that Filigree makes for the scene.
struct App::Content {
    Content(filigree::Context& context, Ogre::SceneManager& scene)
        : paint(make_vertex_colour_material("paint", 0.35f)),
          fur(make_vertex_colour_material("fur", 0.08f)),
          vase_node(place(scene.getRootSceneNode(), {-0.85f, 0, 0})),
          vase(context, flg::scenes::make_vase(kVaseColumns), vase_node, glazes(), paint),
          bouquet(context, place(&vase_node, {0, 1.45f, 0}), paint),
          live(context, place(scene.getRootSceneNode(), {0.62f, 1.35f, -0.35f}), paint),
          cat(context, read_drawing(Ogre::ResourceGroupManager::getSingleton().openResource("cat.json")->getAsString()),
              place(scene.getRootSceneNode(), {0.6f, 0.375f, 0.35f}, -155, 0.12f), fur) {}

    bool ready() const { return vase.ready() && bouquet.ready() && live.ready() && cat.ready(); }

    Ogre::MaterialPtr paint, fur;
    Ogre::SceneNode& vase_node;
    DecoratedMesh vase;
    Bouquet bouquet;
    LiveStroke live;
    SkinnedModel cat;
};

App::App(const Options& options) : OgreBites::ApplicationContext("Filigree in OGRE"), options_(options) {}

App::~App() {
    close();
}

void App::Warnings::messageLogged(const Ogre::String& message, Ogre::LogMessageLevel level, bool, const Ogre::String&,
                                  bool&) {
    if (level >= Ogre::LML_WARNING) std::fprintf(stderr, "%s\n", message.c_str());
}

void App::createRoot() {
    log_ = std::make_unique<Ogre::LogManager>();
    log_->createLog("ogre_viewer", true, false, true)->addListener(&warnings_);
    mRoot = OGRE_NEW Ogre::Root("", "", "");
    for (const char* plugin : {"RenderSystem_GL3Plus", "Codec_STBI"})
        mRoot->loadPlugin(Ogre::String(OGRE_VIEWER_PLUGINS) + "/" + plugin);
}

bool App::oneTimeConfig() {
    Ogre::RenderSystem* const system = mRoot->getAvailableRenderers().front();
    system->setConfigOption("FSAA", "4");
    system->setConfigOption("sRGB Gamma Conversion", "Yes");
    system->setConfigOption("Full Screen", "No");
    system->setConfigOption("Video Mode", std::to_string(options_.width) + " x " + std::to_string(options_.height));
    mRoot->setRenderSystem(system);
    return true;
}

// Shaders that OGRE's generator is made of, and drawings.
void App::locateResources() {
    Ogre::ResourceGroupManager& groups = Ogre::ResourceGroupManager::getSingleton();
    for (const char* folder : {"RTShaderLib/materials", "RTShaderLib/GLSL", "ShadowVolume"})
        groups.addResourceLocation(Ogre::String(OGRE_VIEWER_MEDIA) + "/" + folder, "FileSystem", Ogre::RGN_INTERNAL);
    groups.addResourceLocation(OGRE_VIEWER_MODELS, "FileSystem", Ogre::RGN_DEFAULT);
}

void App::setup() {
    OgreBites::ApplicationContext::setup();
    // OGRE's workers are started, its scene is there: Filigree moves in.
    const auto threads = static_cast<Ogre::DefaultWorkQueueBase*>(mRoot->getWorkQueue())->getWorkerThreadCount();
    jobs_ = std::make_unique<JobSystem>(*mRoot->getWorkQueue(), static_cast<uint32_t>(threads));
    FlgContextDesc desc = flgContextDefaults();
    const FlgAllocator allocator = allocator_.hook();
    const FlgJobSystem job_system = jobs_->hook();
    const FlgLog log = ogre_log();
    desc.allocator = &allocator;
    desc.job_system = &job_system;
    desc.log = &log;
    context_ = filigree::Context::create(desc);

    Ogre::SceneManager* const scene = mRoot->createSceneManager();
    set_up_shading(*scene);
    build_stage(*scene);
    place_camera(*scene);
    content_ = std::make_unique<Content>(*context_, *scene);
    addInputListener(this);
}

void App::place_camera(Ogre::SceneManager& scene) {
    Ogre::Camera* const camera = scene.createCamera("camera");
    camera->setNearClipDistance(0.1f);
    camera->setFarClipDistance(60);
    camera->setAutoAspectRatio(true);
    camera->setFOVy(Ogre::Degree(32));
    Ogre::SceneNode* const target = scene.getRootSceneNode()->createChildSceneNode(Ogre::Vector3(0, 0.88f, 0));
    Ogre::SceneNode* const node = scene.getRootSceneNode()->createChildSceneNode();
    node->attachObject(camera);
    camera_ = std::make_unique<OgreBites::CameraMan>(node);
    camera_->setStyle(OgreBites::CS_ORBIT);
    camera_->setTarget(target);
    camera_->setYawPitchDist(Ogre::Degree(4), Ogre::Degree(12), 3.9f);
    getRenderWindow()->addViewport(camera)->setBackgroundColour(scene.getFogColour());
    addInputListener(camera_.get());
}

// The only place where the SDK is given time: what its jobs have made appears in the tick and nowhere else.
bool App::frameStarted(const Ogre::FrameEvent& event) {
    OgreBites::ApplicationContext::frameStarted(event);
    const FlgFrameReport tick = context_->tick(kBudgetUs);
    ticks_.add(tick.tick_us);
    frames_.add(1000.0 * event.timeSinceLastFrame);
    content_->vase.update();
    content_->bouquet.update();
    content_->live.update(time_);
    content_->cat.update(static_cast<float>(time_));
    if (!content_->ready()) {
        ++frames_before_;
    } else {
        ++frame_;
        time_ += options_.frames > 0 ? 1.0 / options_.rate : event.timeSinceLastFrame;
    }
    return true;
}

bool App::keyPressed(const OgreBites::KeyboardEvent& event) {
    if (event.keysym.sym == OgreBites::SDLK_ESCAPE) mRoot->queueEndRendering();
    return true;
}

bool App::is_over() const {
    return mRoot->endRenderingQueued() || getRenderWindow()->isClosed() ||
           (options_.frames > 0 && frame_ >= options_.frames);
}

size_t App::run() try {
    initApp();
    while (!is_over() && mRoot->renderOneFrame()) {}
    if (!options_.screenshot.empty()) getRenderWindow()->writeContentsToFile(options_.screenshot);
    report();
    return close();
} catch (const Ogre::Exception& error) {
    // Its texts may lie in a plugin, which is gone before main could print them.
    throw std::runtime_error(error.getDescription());
}

void App::report() const {
    std::printf("%u frames until all was made, %u after that\n", frames_before_, frame_);
    std::printf("ticks: p50 %.0f us, p99 %.0f us, longest %.0f us, of a budget of %u us\n", ticks_.quantile(0.5),
                ticks_.quantile(0.99), ticks_.quantile(1), kBudgetUs);
    std::printf("jobs: %zu tasks on OGRE's threads\n", jobs_->tasks());
    std::printf("frames: p50 %.1f ms, p99 %.1f ms\n", frames_.quantile(0.5), frames_.quantile(0.99));
    std::printf("live stroke: %u points, at most %zu bytes uploaded in a frame\n", content_->live.points(),
                content_->live.largest_upload());
}

size_t App::close() {
    if (closed_) return allocator_.bytes();
    closed_ = true;
    content_.reset();
    context_.reset();  // waits for tasks that OGRE's workers still run
    jobs_.reset();
    camera_.reset();
    if (getRenderWindow())
        closeApp();
    else
        OGRE_DELETE std::exchange(mRoot, nullptr);  // there is no display: OGRE was never started
    std::printf("memory: at most %.1f MB in %zu allocations, %zu bytes left\n",
                1e-6 * static_cast<double>(allocator_.peak()), allocator_.calls(), allocator_.bytes());
    return allocator_.bytes();
}

}  // namespace viewer
