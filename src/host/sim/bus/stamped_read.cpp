// SPDX-License-Identifier: Apache-2.0
#include "host/sim/bus/stamped_read.hpp"

#include <sys/uio.h>

#include <array>
#include <cstring>
#include <ctime>

namespace canproof::host {

namespace {

constexpr std::uint64_t second_ns = 1000000000;

std::uint64_t nanoseconds(const timespec& time) {
    return static_cast<std::uint64_t>(time.tv_sec) * second_ns + static_cast<std::uint64_t>(time.tv_nsec);
}

}  // namespace

std::uint64_t kernel_realtime_ns() {
    timespec now{};
    clock_gettime(CLOCK_REALTIME, &now);
    return nanoseconds(now);
}

std::uint64_t receive_stamp_ns(msghdr& message) {
    for (cmsghdr* one = CMSG_FIRSTHDR(&message); one != nullptr; one = CMSG_NXTHDR(&message, one)) {
        if (one->cmsg_level == SOL_SOCKET && one->cmsg_type == SO_TIMESTAMPNS) {
            timespec stamp{};
            std::memcpy(&stamp, CMSG_DATA(one), sizeof stamp);
            return nanoseconds(stamp);
        }
    }
    return 0;
}

void ask_for_stamps(int descriptor) {
    int on = 1;
    static_cast<void>(setsockopt(descriptor, SOL_SOCKET, SO_TIMESTAMPNS, &on, sizeof on));
}

StampedRead receive_stamped(int descriptor, char* into, std::size_t size) {
    alignas(cmsghdr) std::array<char, CMSG_SPACE(sizeof(timespec))> control{};
    iovec place{into, size};
    msghdr message{};
    message.msg_iov = &place;
    message.msg_iovlen = 1;
    message.msg_control = control.data();
    message.msg_controllen = control.size();
    StampedRead read;
    read.count = recvmsg(descriptor, &message, 0);
    read.stamp_ns = read.count > 0 ? receive_stamp_ns(message) : 0;
    return read;
}

}  // namespace canproof::host
