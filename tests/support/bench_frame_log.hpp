// SPDX-License-Identifier: Apache-2.0
// Writes every frame of the test fixtures (benches) to a file: for each test a line `# Suite.Test`, then a line for
// each frame: `microseconds <605#…` to the device, `microseconds >585#…` from it. The same tests write the same file,
// byte for byte, on every machine.
#pragma once

namespace canproof::test {

/// Opens the log at `path`, for all tests that run afterwards.
void open_frame_log(const char* path);

}  // namespace canproof::test
