// SPDX-License-Identifier: MIT
// Sentences for the user: shown for some seconds in the lower right corner, the last hundred kept for the log.
#pragma once

#include <deque>
#include <string>

namespace flg::studio {

enum class Weight { info, warning, error };

class Notices {
public:
    // A sentence. The same one again while it is shown only stays longer.
    void add(Weight weight, std::string sentence);
    // Draws what is to be seen; `seconds` since the last call.
    void draw(float seconds);

    struct Notice {
        Weight weight;
        std::string sentence;
        float left_s;
    };
    const std::deque<Notice>& log() const { return log_; }

private:
    std::deque<Notice> log_;
};

}  // namespace flg::studio
