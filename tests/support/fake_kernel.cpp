// SPDX-License-Identifier: Apache-2.0
// Replaces the calls of the C library and of libsocketcan that concern CAN or that send and read text. These calls use
// the FakeKernel object that exists. Without one, and for sockets that the fake kernel did not open, the calls of the C
// library reach the real kernel.
#include "tests/support/fake_kernel.hpp"

#include <fmt/format.h>
#include <libsocketcan.h>
#include <linux/can/raw.h>
#include <linux/sock_diag.h>
#include <sys/ioctl.h>
#include <sys/socket.h>
#include <sys/syscall.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdarg>
#include <cstring>

namespace canproof::test {

namespace {

FakeKernel* kernel_of(int descriptor) {
    FakeKernel* const kernel = FakeKernel::present();
    return kernel != nullptr && kernel->has(descriptor) ? kernel : nullptr;
}

int fail(int error) {
    errno = error;
    return -1;
}

/// Returns whether this call fails; sets errno.
bool fails(const char* call) {
    const FakeKernel* const kernel = FakeKernel::present();
    const bool fails = kernel != nullptr && kernel->errors.count(call) != 0U;
    errno = fails ? kernel->errors.at(call) : errno;
    return fails;
}

std::size_t at_once(std::size_t size) {
    const FakeKernel* const kernel = FakeKernel::present();
    return kernel != nullptr && kernel->most_at_once != 0 ? std::min(size, kernel->most_at_once) : size;
}

int open_socket(FakeKernel& kernel, int kind) {
    if (kernel.socket_error != 0) {
        return fail(kernel.socket_error);
    }
    std::array<int, 2> ends{};
    if (socketpair(AF_UNIX, SOCK_DGRAM | (kind & (SOCK_NONBLOCK | SOCK_CLOEXEC)), 0, ends.data()) != 0) {
        return -1;
    }
    const auto former = kernel.peers.find(ends[0]);
    if (former != kernel.peers.end()) {  // the kernel reuses the descriptor of a closed socket
        ::close(former->second);
    }
    kernel.peers[ends[0]] = ends[1];
    kernel.opened.push_back(ends[0]);
    kernel.kinds.push_back(kind);
    return ends[0];
}

int set_option(FakeKernel& kernel, int level, int option, const void* value, socklen_t size) {
    if (level == SOL_CAN_RAW && option == CAN_RAW_FILTER) {
        kernel.filters.resize(size / sizeof(can_filter));
        if (size != 0) {
            std::memcpy(kernel.filters.data(), value, size);
        }
        return 0;
    }
    int number = 0;
    std::memcpy(&number, value, std::min<std::size_t>(size, sizeof number));
    kernel.options.push_back(fmt::format("{}:{}={}", level, option, number));
    return 0;
}

int get_option(const FakeKernel& kernel, int option, void* value, const socklen_t* size) {
    if (option == SO_RCVBUF) {
        std::memcpy(value, &kernel.room, sizeof kernel.room);
        return 0;
    }
    std::array<std::uint32_t, SK_MEMINFO_VARS> numbers{};
    numbers[SK_MEMINFO_DROPS] = kernel.dropped;
    std::memcpy(value, numbers.data(), std::min<std::size_t>(*size, sizeof numbers));
    return 0;
}

/// Appends a control message to a received message, as the kernel does (cmsghdr).
void add_control(msghdr& message, std::size_t& used, int kind, const void* data, std::size_t size) {
    auto* const at = reinterpret_cast<cmsghdr*>(static_cast<char*>(message.msg_control) + used);
    at->cmsg_level = SOL_SOCKET;
    at->cmsg_type = kind;
    at->cmsg_len = CMSG_LEN(size);
    std::memcpy(CMSG_DATA(at), data, size);
    used += CMSG_SPACE(size);
}

int receive(FakeKernel& kernel, mmsghdr* messages, unsigned count) {
    if (kernel.arriving.empty()) {
        return fail(kernel.receive_error != 0 ? kernel.receive_error : EAGAIN);
    }
    unsigned filled = 0;
    for (; filled < count && !kernel.arriving.empty(); ++filled) {
        const FakeKernel::Arrival one = kernel.arriving.front();
        kernel.arriving.pop_front();
        msghdr& message = messages[filled].msg_hdr;
        std::memcpy(message.msg_iov[0].iov_base, &one.frame, sizeof one.frame);
        messages[filled].msg_len = sizeof one.frame;
        std::size_t used = 0;
        add_control(message, used, SO_TIMESTAMPNS, &one.stamp, sizeof one.stamp);
        if (one.tells_dropped) {
            add_control(message, used, SO_RXQ_OVFL, &one.dropped, sizeof one.dropped);
        }
        message.msg_controllen = used;
    }
    return static_cast<int>(filled);
}

/// Records a call of libsocketcan. If this call is set to fail, prints a message to stderr as the library does, and
/// returns -1.
int call(const std::string& name, const std::string& text) {
    FakeKernel* const kernel = FakeKernel::present();
    if (kernel == nullptr) {
        return -1;
    }
    if (name != "get") {
        kernel->calls.push_back(text);
    }
    if (kernel->failing.count(name) != 0U) {
        static_cast<void>(!write(STDERR_FILENO, "failed\n", 7));
        return -1;
    }
    return 0;
}

}  // namespace

}  // namespace canproof::test

using canproof::test::FakeKernel;

extern "C" {

int socket(int domain, int kind, int protocol) noexcept {
    FakeKernel* const kernel = FakeKernel::present();
    return kernel != nullptr && domain == PF_CAN ? canproof::test::open_socket(*kernel, kind)
                                                 : static_cast<int>(syscall(SYS_socket, domain, kind, protocol));
}

int bind(int descriptor, const sockaddr* address, socklen_t size) noexcept {
    FakeKernel* const kernel = canproof::test::kernel_of(descriptor);
    if (kernel == nullptr) {
        return static_cast<int>(syscall(SYS_bind, descriptor, address, size));
    }
    if (kernel->bind_error != 0) {
        return canproof::test::fail(kernel->bind_error);
    }
    sockaddr_can can{};
    std::memcpy(&can, address, sizeof can);
    kernel->bound[descriptor] = can.can_family == AF_CAN ? can.can_ifindex : -1;
    return 0;
}

int listen(int descriptor, int most_waiting) noexcept {
    return canproof::test::fails("listen") ? -1 : static_cast<int>(syscall(SYS_listen, descriptor, most_waiting));
}

int getsockname(int descriptor, sockaddr* address, socklen_t* size) noexcept {
    return canproof::test::fails("getsockname") ? -1
                                                : static_cast<int>(syscall(SYS_getsockname, descriptor, address, size));
}

int setsockopt(int descriptor, int level, int option, const void* value, socklen_t size) noexcept {
    const FakeKernel* const present = FakeKernel::present();
    if (present != nullptr && present->refused.count(option) != 0U) {
        return canproof::test::fail(ENOPROTOOPT);
    }
    FakeKernel* const kernel = canproof::test::kernel_of(descriptor);
    return kernel != nullptr ? canproof::test::set_option(*kernel, level, option, value, size)
                             : static_cast<int>(syscall(SYS_setsockopt, descriptor, level, option, value, size));
}

int getsockopt(int descriptor, int level, int option, void* value, socklen_t* size) noexcept {
    const FakeKernel* const kernel = canproof::test::kernel_of(descriptor);
    return kernel != nullptr ? canproof::test::get_option(*kernel, option, value, size)
                             : static_cast<int>(syscall(SYS_getsockopt, descriptor, level, option, value, size));
}

int recvmmsg(int descriptor, mmsghdr* messages, unsigned count, int flags, timespec* limit) {
    FakeKernel* const kernel = canproof::test::kernel_of(descriptor);
    return kernel != nullptr ? canproof::test::receive(*kernel, messages, count)
                             : static_cast<int>(syscall(SYS_recvmmsg, descriptor, messages, count, flags, limit));
}

ssize_t send(int descriptor, const void* data, std::size_t size, int flags) {
    return syscall(SYS_sendto, descriptor, data, canproof::test::at_once(size), flags, nullptr, 0);
}

ssize_t recvmsg(int descriptor, msghdr* message, int flags) {
    const std::size_t size = message->msg_iovlen != 0 ? message->msg_iov[0].iov_len : 0;
    if (size != 0) {
        message->msg_iov[0].iov_len = canproof::test::at_once(size);
    }
    const ssize_t count = syscall(SYS_recvmsg, descriptor, message, flags);
    if (size != 0) {
        message->msg_iov[0].iov_len = size;
    }
    return count;
}

unsigned if_nametoindex(const char* name) noexcept {
    return FakeKernel::present() != nullptr && std::string{name} == "vcan0" ? 3U : 0U;
}

int ioctl(int descriptor, unsigned long request, ...) noexcept {
    va_list rest;
    va_start(rest, request);
    void* const argument = va_arg(rest, void*);
    va_end(rest);
    FakeKernel* const kernel = canproof::test::kernel_of(descriptor);
    if (kernel == nullptr) {
        return static_cast<int>(syscall(SYS_ioctl, descriptor, request, argument));
    }
    auto* const wanted = static_cast<ifreq*>(argument);
    kernel->asked = wanted->ifr_name;
    if (request != SIOCGIFFLAGS || kernel->asked != "vcan0") {
        return canproof::test::fail(ENODEV);
    }
    wanted->ifr_flags = static_cast<short>(kernel->flags);
    return 0;
}

int can_do_stop(const char* name) {
    return canproof::test::call("stop", fmt::format("stop {}", name));
}
int can_do_start(const char* name) {
    return canproof::test::call("start", fmt::format("start {}", name));
}
int can_do_restart(const char* name) {
    return canproof::test::call("restart", fmt::format("restart {}", name));
}
int can_set_bitrate(const char* name, __u32 rate) {
    return canproof::test::call("rate", fmt::format("rate {} {}", name, rate));
}
int can_get_bittiming(const char* name, can_bittiming* timing) {
    const int failed = canproof::test::call("get", name);
    FakeKernel* const kernel = FakeKernel::present();
    if (failed != 0 || kernel->rate == 0U) {
        return -1;
    }
    *timing = {};
    timing->bitrate = kernel->rate;
    return 0;
}

}  // extern "C"
