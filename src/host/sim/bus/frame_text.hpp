// SPDX-License-Identifier: Apache-2.0
// Frames in the text form of candump: `603#2B116401B33E0000`, or `703#R` for a remote frame. The parser reads single
// characters and allocates no memory for a valid frame, because a log can have millions of frames.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "firmware/canopen/frame.hpp"

namespace canproof::host {

/// Description of the fault in a text; nothing for a valid text.
using TextFault = std::optional<std::string>;

struct FrameText {
    Frame frame{};
    bool error{false};  ///< whether it is an error frame in candump's form
    /// whether a length code of 9 to 15 follows the data; the length of the data is still eight bytes
    bool coded{false};
};

/// Parses a data frame or a remote frame. Returns nothing for a valid text, otherwise its fault.
TextFault read_frame_text(std::string_view text, FrameText& read);
/// Parses a data frame, a remote frame or an error frame (`20000004#0000000000000000`). Returns nothing for a valid
/// text, otherwise its fault.
TextFault read_logged_frame(std::string_view text, FrameText& read);

/// Returns whether both frames give the same text.
bool are_alike(const Frame& a, const Frame& b);
/// Appends a frame to `text` in the form `703#00`.
void append_frame(std::string& text, const Frame& frame);

}  // namespace canproof::host
