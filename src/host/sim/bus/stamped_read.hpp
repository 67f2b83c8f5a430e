// SPDX-License-Identifier: Apache-2.0
// Reads sockets with the kernel's time stamps of reception (SO_TIMESTAMPNS), and the clock of these stamps.
#pragma once

#include <sys/socket.h>
#include <sys/types.h>

#include <cstddef>
#include <cstdint>

namespace canproof::host {

/// Returns the time of CLOCK_REALTIME in ns.
std::uint64_t kernel_realtime_ns();

/// Returns the kernel's time stamp of a received message in ns; 0 when the message has none.
std::uint64_t receive_stamp_ns(msghdr& message);

/// The result of reading a stream socket.
struct StampedRead {
    ssize_t count{0};           ///< number of bytes, as recv() returns it
    std::uint64_t stamp_ns{0};  ///< time of arrival of the last byte; 0: unknown
};

/// Switches time stamps of reception on. A failure is ignored: receive_stamped() then returns no time stamp.
void ask_for_stamps(int descriptor);
/// Reads up to `size` bytes, as recv() without flags does.
StampedRead receive_stamped(int descriptor, char* into, std::size_t size);

}  // namespace canproof::host
