// SPDX-License-Identifier: Apache-2.0
#include "target/bridge/semihosting_channel.hpp"

#include "target/semihost.hpp"

namespace canproof::target {

namespace {

constexpr int sys_open = 0x01;
constexpr int sys_write = 0x05;
constexpr int sys_read = 0x06;
constexpr int sys_exit_extended = 0x20;
constexpr std::uint32_t mode_read_binary = 1U;
constexpr std::uint32_t mode_write_binary = 5U;
constexpr std::uint32_t application_exit = 0x20026U;
constexpr std::uint32_t internal_error = 70U;

/// Paths on the machine that runs QEMU, which is a Linux machine.
constexpr char standard_input[] = "/proc/self/fd/0";
constexpr char standard_output[] = "/proc/self/fd/1";

template <std::size_t Size>
int open(const char (&name)[Size], const std::uint32_t mode) {
    const struct {
        const char* name;
        std::uint32_t mode;
        std::uint32_t length;
    } block{name, mode, Size - 1U};
    return semihost(sys_open, &block);
}

/// Calls SYS_READ or SYS_WRITE, and returns the number of bytes that were not transferred.
std::size_t transfer(const int operation, const int handle, const std::uint8_t* const bytes, const std::size_t count) {
    const struct {
        int handle;
        const std::uint8_t* bytes;
        std::size_t count;
    } block{handle, bytes, count};
    return static_cast<std::size_t>(semihost(operation, &block));
}

/// Transfers all bytes. Returns false at the end of the stream and after an error.
bool transfer_all(const int operation, const int handle, const std::uint8_t* const bytes, const std::size_t count) {
    std::size_t left{count};
    bool moves{handle >= 0};
    while (moves && (left != 0U)) {
        const std::size_t after = transfer(operation, handle, bytes + (count - left), left);
        moves = after < left;
        left = moves ? after : left;
    }
    return moves;
}

}  // namespace

SemihostingChannel::SemihostingChannel()
    : in_{open(standard_input, mode_read_binary)}, out_{open(standard_output, mode_write_binary)} {}

bool SemihostingChannel::read(std::uint8_t* const to, const std::size_t count) {
    return transfer_all(sys_read, in_, to, count);
}

bool SemihostingChannel::write(const ByteView bytes) {
    return transfer_all(sys_write, out_, bytes.data(), bytes.size());
}

void end_image(const std::uint32_t status) {
    const std::uint32_t block[]{application_exit, status};
    for (;;) {
        static_cast<void>(semihost(sys_exit_extended, block));
    }
}

}  // namespace canproof::target

/// Handles any exception of the processor: the image ends with the status of an internal software error.
extern "C" void fault() {
    canproof::target::end_image(canproof::target::internal_error);
}
