// SPDX-License-Identifier: Apache-2.0
// Sockets with the kernel's receive time stamps (SO_TIMESTAMPNS), and the clock of these stamps.
#pragma once

#include <sys/socket.h>
#include <sys/types.h>

#include <cstddef>
#include <cstdint>

namespace canproof::host {

/// Returns CLOCK_REALTIME in ns.
std::uint64_t kernel_realtime_ns();

/// Returns the receive time stamp in ns (SO_TIMESTAMPNS) of a received message; 0 when it has none.
std::uint64_t receive_stamp_ns(msghdr& message);

/// The result of reading a stream socket.
struct StampedRead {
    ssize_t count{0};           ///< as recv() returns it
    std::uint64_t stamp_ns{0};  ///< arrival of the last byte; 0: unknown
};

/// Switches receive time stamps on, best effort: without them receive_stamped() gives no time stamp.
void ask_for_stamps(int descriptor);
/// Reads up to `size` bytes, as recv() without flags does.
StampedRead receive_stamped(int descriptor, char* into, std::size_t size);

}  // namespace canproof::host
