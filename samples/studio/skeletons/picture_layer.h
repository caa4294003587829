// SPDX-License-Identifier: MIT
// The picture that is drawn over: read in the background, shown as a quad in the plane z = 0, under all handles.
#pragma once

#include <future>
#include <string>

#include "filigree_renderer/renderer.h"
#include "shell/notices.h"
#include "shell/view.h"
#include "skeletons/drawing.h"

struct ImDrawList;

namespace flg::studio {

class PictureLayer {
public:
    PictureLayer(render::Renderer& renderer, Notices& notices) : renderer_(renderer), notices_(notices) {}
    ~PictureLayer();
    PictureLayer(const PictureLayer&) = delete;
    PictureLayer& operator=(const PictureLayer&) = delete;

    // Once a frame: reads the picture that is wanted, if it is another one.
    void update(const TracedPicture& picture);
    void draw(ImDrawList& list, const View& view, const TracedPicture& picture) const;
    bool is_shown() const { return texture_.value != 0; }
    bool busy() const { return coming_.valid(); }
    void device_lost() { texture_ = {}, path_.clear(); }

private:
    struct Read {
        render::Image image;
        std::string error;  // a sentence; empty: none
    };
    static Read read(const std::string& path);

    render::Renderer& renderer_;
    Notices& notices_;
    std::string path_, coming_path_;  // what is shown or was tried
    std::future<Read> coming_;
    render::TextureId texture_{};
    double aspect_ = 1.0;
};

}  // namespace flg::studio
