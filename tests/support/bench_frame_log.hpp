// SPDX-License-Identifier: Apache-2.0
// Writes every frame of a bench to a file: `# Suite.Test`, then `microseconds <605#…` for a frame to the device and
// `>585#…` for a frame from it. The same tests write the same file, byte for byte, on every machine.
#pragma once

namespace canproof::test {

/// Opens the log at `path`, for all tests that run afterwards.
void open_frame_log(const char* path);

}  // namespace canproof::test
