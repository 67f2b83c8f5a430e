// SPDX-License-Identifier: Apache-2.0
// NAME_cost FILE|FOLDER...: replays inputs (FILE) or corpora (FOLDER) of the fuzz target NAME. Under callgrind with
// --collect-atstart=no it writes one dump file for each frame that the fuzz target gives to a device.
// tests/bench/frame_cost finds the most expensive frame in these dumps.
#include <valgrind/callgrind.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "firmware/base/time.hpp"
#include "firmware/canopen/frame.hpp"
#include "fuzz/support/frame_probe.hpp"
#include "host/sim/bus/candump.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace {

std::string input_name;
unsigned long frames = 0;

void frame_begins(const canproof::Frame&, canproof::Instant) {
    CALLGRIND_ZERO_STATS;
    CALLGRIND_TOGGLE_COLLECT;
}

void frame_ends(const canproof::Frame& frame) {
    CALLGRIND_TOGGLE_COLLECT;
    ++frames;
    const std::string label = input_name + " " + canproof::host::format_frame(frame);
    CALLGRIND_DUMP_STATS_AT(label.c_str());
}

void replay(const std::filesystem::path& path) {
    std::ifstream in{path, std::ios::binary};
    const std::vector<char> text{std::istreambuf_iterator<char>{in}, {}};
    const std::vector<std::uint8_t> bytes{text.begin(), text.end()};
    input_name = path.filename().string();
    LLVMFuzzerTestOneInput(bytes.data(), bytes.size());
}

std::vector<std::filesystem::path> files_of(const std::vector<std::string>& arguments) {
    std::vector<std::filesystem::path> files;
    for (const std::filesystem::path path : arguments) {
        if (!std::filesystem::is_directory(path)) {
            files.push_back(path);
            continue;
        }
        for (const auto& file : std::filesystem::recursive_directory_iterator(path)) {
            if (file.is_regular_file()) {
                files.push_back(file.path());
            }
        }
    }
    return files;
}

}  // namespace

int main(int argc, char** argv) {
    const auto files = files_of({argv + 1, argv + argc});
    if (!files.empty()) {
        replay(files.front());  // does the work that happens only once per process, before the count begins
    }
    canproof::fuzz::frame_probe = {frame_begins, frame_ends};
    for (const auto& file : files) {
        replay(file);
    }
    std::printf("%lu\n", frames);
    return frames == 0 ? 2 : 0;
}
