// A frame as candump writes it: `603#2B116401B33E0000`, `703#R` for a remote frame. Read character by character and
// without memory of its own: a log has millions of them.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "firmware/canopen/frame.hpp"

namespace canproof::host {

/// What is wrong with a text; nothing when it is sound.
using TextFault = std::optional<std::string>;

struct FrameText {
    Frame frame{};
    bool error{false};  ///< an error frame, as candump logs it
    bool coded{false};  ///< with a length code of 9 to 15 behind the data: eight bytes all the same
};

/// Reads a frame as a node receives it.
TextFault read_frame_text(std::string_view text, FrameText& read);
/// The same, or an error frame: `20000004#0000000000000000`.
TextFault read_logged_frame(std::string_view text, FrameText& read);

/// Whether both are written the same.
bool are_alike(const Frame& a, const Frame& b);
/// `703#00`, behind what stands in `text`.
void append_frame(std::string& text, const Frame& frame);

}  // namespace canproof::host
