// SPDX-License-Identifier: MIT
#include "filigree_renderer/window.h"

#define GLFW_INCLUDE_VULKAN
#include <GLFW/glfw3.h>

#include <algorithm>
#include <cmath>

#include "renderer_state.h"
#include "swapchain.h"

namespace flg::render {
namespace {

constexpr float turn_rad_per_height = 4.0f;  // of dragging over the window's height
constexpr float zoom_per_notch = 0.9f;

// GLFW is one to a process: the first user starts it, the last one ends it. Main thread only, as all of GLFW.
class Glfw {
public:
    Glfw() : started_(users > 0 || glfwInit() == GLFW_TRUE) {
        if (started_) ++users;
    }
    ~Glfw() {
        if (started_ && --users == 0) glfwTerminate();
    }
    Glfw(const Glfw&) = delete;
    Glfw& operator=(const Glfw&) = delete;
    bool started() const { return started_; }

private:
    static inline int users = 0;
    bool started_;
};

}  // namespace

struct Window::State {
    Glfw glfw;
    GLFWwindow* window = nullptr;
    std::unique_ptr<Swapchain> swapchain;  // null: to be made by the next frame
    Swapchain::Fitness fitness = Swapchain::Fitness::outdated;
    int pixels_wide = 0, pixels_high = 0;  // that the images were made for
    bool orbits = false;
    double mouse_x = 0, mouse_y = 0;

    void connect(const Device& device);
    void begin_orbit(Window* owner);

    State() = default;
    State(const State&) = delete;
    State& operator=(const State&) = delete;
    ~State() {
        swapchain.reset();
        if (window) glfwDestroyWindow(window);
    }
};

bool Window::available() {
    return Glfw().started();
}

Window::Window(Renderer& renderer, uint32_t width, uint32_t height, const std::string& title)
    : Target(renderer, width, height), window_(std::make_unique<State>()) {
    State& w = *window_;
    if (!w.glfw.started()) fail("A window can't be opened: there is no display.");
    glfwWindowHint(GLFW_CLIENT_API, GLFW_NO_API);
    w.window = glfwCreateWindow(static_cast<int>(width), static_cast<int>(height), title.c_str(), nullptr, nullptr);
    if (!w.window) fail("A window of %u x %u could not be opened.", width, height);
    w.connect(renderer.state_->device);
}

void Window::State::connect(const Device& device) {
    VkSurfaceKHR surface = VK_NULL_HANDLE;
    const VkResult result = glfwCreateWindowSurface(device.instance(), window, nullptr, &surface);
    if (result != VK_SUCCESS) fail("Vulkan can't draw to the window: %s.", result_name(result));
    swapchain = std::make_unique<Swapchain>(device, surface);
}

void Window::State::begin_orbit(Window* owner) {
    if (orbits) return;
    orbits = true;
    glfwSetWindowUserPointer(window, owner);
    glfwSetScrollCallback(window, [](GLFWwindow* scrolled, double, double notches) {
        static_cast<Window*>(glfwGetWindowUserPointer(scrolled))
            ->orbit.zoom(std::pow(zoom_per_notch, static_cast<float>(notches)));
    });
    glfwGetCursorPos(window, &mouse_x, &mouse_y);
}

Window::~Window() {
    vkDeviceWaitIdle(renderer_.state_->device.handle());
}

bool Window::poll() {
    State& w = *window_;
    w.begin_orbit(this);
    glfwPollEvents();
    if (glfwGetKey(w.window, GLFW_KEY_ESCAPE) == GLFW_PRESS) glfwSetWindowShouldClose(w.window, GLFW_TRUE);
    double x, y;
    glfwGetCursorPos(w.window, &x, &y);
    int window_width, window_height;
    glfwGetWindowSize(w.window, &window_width, &window_height);
    const double unit = window_height > 0 ? 1.0 / window_height : 0.0;
    const auto right = static_cast<float>((x - w.mouse_x) * unit), down = static_cast<float>((y - w.mouse_y) * unit);
    w.mouse_x = x;
    w.mouse_y = y;
    const bool dragged = glfwGetMouseButton(w.window, GLFW_MOUSE_BUTTON_LEFT) == GLFW_PRESS;
    const bool dragged_aside = glfwGetMouseButton(w.window, GLFW_MOUSE_BUTTON_RIGHT) == GLFW_PRESS;
    const bool shift = glfwGetKey(w.window, GLFW_KEY_LEFT_SHIFT) == GLFW_PRESS;
    if (dragged_aside || (dragged && shift))
        orbit.pan(-right, down);
    else if (dragged)
        orbit.turn(-right * turn_rad_per_height, down * turn_rad_per_height);
    return !glfwWindowShouldClose(w.window);
}

bool Window::poll_events() {
    glfwPollEvents();
    fit();
    return !glfwWindowShouldClose(window_->window);
}

GLFWwindow* Window::handle() const {
    return window_->window;
}

float Window::content_scale() const {
    float x = 1.0f, y = 1.0f;
    glfwGetWindowContentScale(window_->window, &x, &y);
    return std::max(x, y);
}

void Window::set_size(uint32_t width, uint32_t height) {
    glfwSetWindowSize(window_->window, static_cast<int>(width), static_cast<int>(height));
}

bool Window::fit() {
    State& w = *window_;
    int pixels_wide, pixels_high;
    glfwGetFramebufferSize(w.window, &pixels_wide, &pixels_high);
    if (pixels_wide <= 0 || pixels_high <= 0) return false;
    if (w.fitness == Swapchain::Fitness::good && pixels_wide == w.pixels_wide && pixels_high == w.pixels_high)
        return true;
    if (w.fitness == Swapchain::Fitness::good) w.fitness = Swapchain::Fitness::outdated;
    const Device& device = renderer_.state_->device;
    renderer_.wait_idle();
    check(vkQueueWaitIdle(device.queue()), "finish its work");
    if (w.fitness == Swapchain::Fitness::lost) w.swapchain.reset();
    if (!w.swapchain) w.connect(device);
    w.fitness = Swapchain::Fitness::outdated;
    if (w.swapchain->rebuild(static_cast<uint32_t>(pixels_wide), static_cast<uint32_t>(pixels_high)) ==
        Swapchain::Fitness::lost) {
        w.fitness = Swapchain::Fitness::lost;
        return false;
    }
    const VkExtent2D extent = w.swapchain->extent();
    if (extent.width == 0 || extent.height == 0) return false;
    if (extent.width != width() || extent.height != height()) resize(extent.width, extent.height);
    w.pixels_wide = pixels_wide;
    w.pixels_high = pixels_high;
    w.fitness = Swapchain::Fitness::good;
    return true;
}

bool Window::begin_frame(uint32_t slot) {
    State& w = *window_;
    // Twice: the images may go out of date between being made and being asked for.
    for (int attempt = 0; attempt < 2; ++attempt) {
        if (!fit()) return false;
        w.fitness = w.swapchain->acquire(slot);
        if (w.fitness == Swapchain::Fitness::good) return true;
    }
    return false;
}

void Window::end_frame(FrameSubmission& submission) {
    window_->swapchain->record_copy(submission);
}

void Window::present(FrameSubmission&) {
    window_->fitness = window_->swapchain->present();
}

void Window::abandon_frame() noexcept {
    // With an image that was taken and a semaphore that nobody waits for.
    window_->fitness = Swapchain::Fitness::lost;
}

void Window::leave_device() noexcept {
    window_->swapchain.reset();
    window_->fitness = Swapchain::Fitness::lost;
}

}  // namespace flg::render
