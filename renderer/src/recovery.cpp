// SPDX-License-Identifier: MIT
// How a renderer goes on with another device: all that is on the device is made anew, what is the host's is taken over.
#include "renderer_state.h"

namespace flg::render {

void Renderer::recover() {
    State& old = *state_;
    auto fresh = std::make_unique<State>(old.options, old.log);
    fresh->scene = old.scene;
    fresh->environment = old.environment;
    fresh->frame = old.frame;
    fresh->curves.follow(old.curves);
    fresh->surfaces.follow(old.surfaces);
    fresh->textures.follow(old.textures);
    fresh->targets = old.targets;
    std::vector<std::unique_ptr<TargetImage>> images;
    for (const State::Entry& entry : old.targets) {
        const TargetImage& image = **entry.image;
        if (image.eyes() == Eyes::both) fresh->need_stereo();
        images.push_back(std::make_unique<TargetImage>(fresh->memory, fresh->passes(), fresh->samples, image.width(),
                                                       image.height(), image.eyes()));
    }
    // Nothing fails from here on.
    vkDeviceWaitIdle(old.device.handle());
    for (size_t i = 0; i < images.size(); ++i) {
        if (old.targets[i].target) old.targets[i].target->leave_device();
        *old.targets[i].image = std::move(images[i]);
    }
    state_ = std::move(fresh);
}

void Renderer::simulate_device_loss(uint32_t calls) {
    state_->device.simulate_loss(calls);
}

}  // namespace flg::render
