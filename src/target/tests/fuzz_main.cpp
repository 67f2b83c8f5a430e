// SPDX-License-Identifier: Apache-2.0
// Runs a fuzz target on the files that --list=FILE names, one per line. --every-work=FILE records the number of
// instructions of each frame; --work=FILE records only the worst case of each kind of work (work_log.hpp). When an
// invariant is violated, the program ends with a status other than 0.
#include <cstdint>
#include <cstdio>
#include <cstdlib>

#include "firmware/base/time.hpp"
#include "firmware/canopen/frame.hpp"
#include "fuzz/support/frame_probe.hpp"
#include "host/sim/bus/candump.hpp"
#include "semihosting.hpp"
#include "work_log.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace {

using namespace canproof;

std::string input_name;
test::Work work = test::Work::frame;  ///< of the frame that the device processes

std::vector<std::uint8_t> read_file(const std::string& path) {
    std::vector<std::uint8_t> bytes;
    std::FILE* const file = std::fopen(path.c_str(), "rb");
    if (file == nullptr) {
        std::fprintf(stderr, "cannot read %s\n", path.c_str());
        std::exit(2);
    }
    std::uint8_t part[256];
    for (std::size_t count = std::fread(part, 1, sizeof part, file); count > 0;
         count = std::fread(part, 1, sizeof part, file)) {
        bytes.insert(bytes.end(), part, part + count);
    }
    std::fclose(file);
    return bytes;
}

}  // namespace

extern "C" void image_main() {
    std::vector<std::string> words = target::begin_image();
    const std::vector<std::uint8_t> list = read_file(target::take_option(words, "list"));
    const std::string every_work = target::take_option(words, "every-work");
    if (!every_work.empty()) {
        target::write_every_work(every_work);
    }
    fuzz::frame_probe.begins = [](const Frame&, Instant now) {
        work = test::frame_work(fuzz::frame_probe.deadline, now);
        target::work_begins(work);
    };
    fuzz::frame_probe.ends = [](const Frame& frame) {
        target::work_stops();
        target::note_frame(work, frame, host::format_frame(frame), input_name);
    };
    fuzz::frame_probe.answers = target::note_answer;
    std::string path;
    for (const std::uint8_t byte : list) {
        if (byte != '\n') {
            path += static_cast<char>(byte);
            continue;
        }
        input_name = path.substr(path.find_last_of('/') + 1);
        const std::vector<std::uint8_t> input = read_file(path);
        LLVMFuzzerTestOneInput(input.data(), input.size());
        path.clear();
    }
    std::exit(target::write_work(target::take_option(words, "work")) ? 0 : 2);
}
