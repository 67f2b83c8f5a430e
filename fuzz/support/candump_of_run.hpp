// SPDX-License-Identifier: Apache-2.0
// Writes the frames that a target gives to its device as a candump log. Writes each frame before the device receives
// it, so that the log is complete even when this frame ends the process.
#pragma once

#include <fmt/format.h>

#include <filesystem>
#include <fstream>

#include "firmware/base/time.hpp"
#include "firmware/canopen/frame.hpp"
#include "fuzz/support/frame_probe.hpp"
#include "fuzz/support/replays_as.hpp"
#include "host/sim/bus/candump.hpp"

namespace canproof::fuzz {

inline std::ofstream frame_log;

/// Writes one frame. Times count from the start of the input, at which `canproof replay` switches the device on.
inline void log_frame(const Frame& frame, Instant now) {
    frame_log << host::format_candump_line({Instant{elapsed(frame_probe.start, now).us}, "can0", frame}) << " R"
              << std::endl;
}

/// Writes the frames from now on into FOLDER/frames.log. Also writes FOLDER/replay, the command that replays this log,
/// and the data sheet that the command may need.
inline bool begin_frame_log(const std::filesystem::path& folder) {
    if (replays_as == nullptr) {
        return false;
    }
    std::filesystem::create_directories(folder);
    const ReplaysAs how = replays_as();
    std::string arguments = how.arguments;
    if (!how.eds.empty()) {
        std::ofstream{folder / "device.eds", std::ios::binary} << how.eds;
        arguments = fmt::format("--eds device.eds {}", arguments);
    }
    std::ofstream{folder / "replay"} << fmt::format("canproof replay {} frames.log\n", arguments);
    frame_log.open(folder / "frames.log");
    frame_probe.begins = log_frame;
    return frame_log.good();
}

}  // namespace canproof::fuzz
