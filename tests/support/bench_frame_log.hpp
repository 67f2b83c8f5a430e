// Every frame that passes a bench, in a file: `# Suite.Test`, then `microseconds <605#…` to the device and `>585#…`
// from it. The same tests leave the same file, byte for byte, wherever they run.
#pragma once

namespace canproof::test {

/// Begins the log at `path`; the tests that run from now on are in it.
void open_frame_log(const char* path);

}  // namespace canproof::test
