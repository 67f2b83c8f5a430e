// SPDX-License-Identifier: Apache-2.0
#include "host/sim/image/start_image.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <vector>

#include "host/base/child_process.hpp"
#include "host/base/dependent_process.hpp"
#include "host/base/input_error.hpp"

namespace canproof::host {

namespace {

/// Returns whether an image starts in the flash of an STM32F405. Other images are for the Zynq UltraScale+. Throws
/// InputError for a file that is no 32-bit ELF program for ARM: QEMU would run such a file, and never answer.
bool starts_in_flash(const std::string& path) {
    constexpr std::size_t machine = 18;  // offset of e_machine in the header of a 32-bit ELF file
    constexpr std::size_t entry = 24;    // offset of e_entry
    constexpr std::size_t high_byte = entry + 3;
    std::ifstream file{path, std::ios::binary};
    std::string head(high_byte + 1, '\0');
    file.read(head.data(), static_cast<std::streamsize>(head.size()));
    const bool is_elf = file && head.compare(0, 5,
                                             "\x7F"
                                             "ELF\x01") == 0;
    if (!is_elf || head[machine] != '\x28' || head[machine + 1] != '\0') {
        throw InputError{fmt::format(
            "{} is no image: it is no 32-bit ELF program for ARM; name bridged_NAME.elf or zynqmp_NAME.elf", path)};
    }
    return head[high_byte] == '\x08';
}

/// Returns the options that the QEMU commands for both microcontrollers have. With semihosting, the image reads and
/// writes the standard streams of QEMU.
const std::vector<std::string>& common_words() {
    static const std::vector<std::string> words{"-nodefaults",
                                                "-no-user-config",
                                                "-display",
                                                "none",
                                                "-monitor",
                                                "none",
                                                "-serial",
                                                "none",
                                                "-parallel",
                                                "none",
                                                "-semihosting-config",
                                                "enable=on,target=native"};
    return words;
}

std::vector<std::string> stm32f405_command(const std::string& path) {
    std::vector<std::string> words{"qemu-system-arm", "-machine", "netduinoplus2", "-kernel", path};
    words.insert(words.end(), common_words().begin(), common_words().end());
    return words;
}

/// Returns the command for a Zynq UltraScale+ whose two CAN controllers are on one bus. The clock of the machine counts
/// instructions, so that every run is the same, and does not wait while the core sleeps.
std::vector<std::string> zynqmp_command(const std::string& path) {
    std::string file;
    for (const char c : path) {
        file += c == ',' ? std::string{",,"} : std::string{c};  // QEMU separates options by single commas
    }
    std::vector<std::string> words{"qemu-system-aarch64",
                                   "-object",
                                   "can-bus,id=bus",
                                   "-machine",
                                   "xlnx-zcu102,virtualization=on,canbus0=bus,canbus1=bus",
                                   "-icount",
                                   "shift=0,sleep=off",
                                   "-device",
                                   "loader,cpu-num=0,file=" + file,
                                   "-audiodev",
                                   "none,id=silent"};
    for (int port = 0; port < 4; ++port) {  // without a peer for each Ethernet port, QEMU prints a warning
        words.insert(words.end(), {"-nic", "user,restrict=on,model=cadence_gem"});
    }
    words.insert(words.end(), common_words().begin(), common_words().end());
    return words;
}

}  // namespace

std::unique_ptr<ImageLink> start_image(const std::string& path) {
    if (!std::filesystem::is_regular_file(path)) {
        throw InputError{fmt::format(
            "there is no image {}; `cmake --build --preset target` makes bridged_NAME.elf, preset zynq zynqmp_NAME.elf",
            path)};
    }
    Pipe to = make_pipe();
    Pipe from = make_pipe();
    const auto command = starts_in_flash(path) ? stm32f405_command(path) : zynqmp_command(path);
    Emulator emulator{start_dependent_process(command, to.reads.number(), from.writes.number())};
    return std::make_unique<ImageLink>(std::move(to.writes), std::move(from.reads),
                                       std::filesystem::path{path}.filename().string(), std::move(emulator));
}

}  // namespace canproof::host
