// SPDX-License-Identifier: Apache-2.0
#include "host/sim/image/start_image.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <vector>

#include "host/base/child_process.hpp"
#include "host/base/input_error.hpp"

namespace canproof::host {

namespace {

struct Pipe {
    Descriptor reads;
    Descriptor writes;
};

Pipe open_pipe() {
    const auto ends = make_pipe();
    return {Descriptor{ends[0]}, Descriptor{ends[1]}};
}

/// Returns the words of the command that starts QEMU. By semihosting, the image uses the standard streams of that
/// process.
std::vector<std::string> command_line(const std::string& path) {
    return {"qemu-system-arm",
            "-nodefaults",
            "-no-user-config",
            "-machine",
            "netduinoplus2",
            "-display",
            "none",
            "-monitor",
            "none",
            "-serial",
            "none",
            "-parallel",
            "none",
            "-semihosting-config",
            "enable=on,target=native",
            "-kernel",
            path};
}

}  // namespace

std::unique_ptr<ImageLink> start_image(const std::string& path) {
    if (!std::filesystem::is_regular_file(path)) {
        throw InputError{
            fmt::format("there is no image {}; `cmake --build --preset target` makes bridged_NAME.elf", path)};
    }
    Pipe to = open_pipe();
    Pipe from = open_pipe();
    Emulator emulator{start_process(command_line(path), {}, {to.reads.number(), from.writes.number(), true})};
    return std::make_unique<ImageLink>(std::move(to.writes), std::move(from.reads),
                                       std::filesystem::path{path}.filename().string(), std::move(emulator));
}

}  // namespace canproof::host
