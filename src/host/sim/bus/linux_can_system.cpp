// SPDX-License-Identifier: Apache-2.0
// Raw CAN sockets of Linux; libsocketcan controls the interface.
#include "host/sim/bus/linux_can_system.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <libsocketcan.h>
#include <linux/can/error.h>
#include <linux/can/raw.h>
#include <linux/sock_diag.h>
#include <net/if.h>
#include <sys/ioctl.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <ctime>
#include <utility>

#include "host/sim/bus/stamped_read.hpp"

namespace canproof::host {

namespace {

constexpr std::size_t batch = 64;  // number of frames that one system call reads

/// Memory for the time stamp and the drop counter of one frame.
struct Control {
    alignas(cmsghdr) std::array<char, CMSG_SPACE(sizeof(timespec)) + CMSG_SPACE(sizeof(std::uint32_t))> bytes{};
};

bool set(int descriptor, int level, int option, int value) {
    return setsockopt(descriptor, level, option, &value, sizeof value) == 0;
}

/// Enlarges the receive buffer: beyond the system's limit if this is permitted, otherwise up to the limit. Returns
/// whether the buffer has the requested size.
bool make_room(int descriptor) {
    if (set(descriptor, SOL_SOCKET, SO_RCVBUFFORCE, receive_room)) {
        return true;
    }
    int given = 0;
    socklen_t size = sizeof given;
    return set(descriptor, SOL_SOCKET, SO_RCVBUF, receive_room) &&
           getsockopt(descriptor, SOL_SOCKET, SO_RCVBUF, &given, &size) == 0 && given >= receive_room;
}

int bind_to(int descriptor, unsigned number) {
    sockaddr_can address{};
    address.can_family = AF_CAN;
    address.can_ifindex = static_cast<int>(number);
    sockaddr_storage general{};
    std::memcpy(&general, &address, sizeof address);
    return bind(descriptor, reinterpret_cast<const sockaddr*>(&general), sizeof address) == 0 ? 0 : errno;
}

void read_control(msghdr& message, CanReception& got) {
    got.stamp_ns = receive_stamp_ns(message);
    for (cmsghdr* one = CMSG_FIRSTHDR(&message); one != nullptr; one = CMSG_NXTHDR(&message, one)) {
        if (one->cmsg_level == SOL_SOCKET && one->cmsg_type == SO_RXQ_OVFL) {
            std::memcpy(&got.dropped, CMSG_DATA(one), sizeof got.dropped);
        }
    }
}

/// Discards standard error as long as the object exists. libsocketcan prints a message when data are missing, such as
/// the bit rate of a vcan. The bus itself reports the errors that matter.
class Hush {
  public:
    Hush() : kept_{dup(STDERR_FILENO)} {
        const Descriptor nowhere{::open("/dev/null", O_WRONLY | O_CLOEXEC)};
        if (kept_.is_open() && nowhere.is_open()) {
            dup2(nowhere.number(), STDERR_FILENO);
        }
    }
    ~Hush() {
        if (kept_.is_open()) {
            dup2(kept_.number(), STDERR_FILENO);
        }
    }
    Hush(const Hush&) = delete;
    Hush& operator=(const Hush&) = delete;

  private:
    Descriptor kept_;
};

class LinuxCanSystem final : public CanSystem {
  public:
    CanOpening open(const std::string& interface, bool error_frames) override {
        Descriptor opened{socket(PF_CAN, SOCK_RAW | SOCK_NONBLOCK | SOCK_CLOEXEC, CAN_RAW)};
        const int descriptor = opened.number();
        if (!opened.is_open()) {
            return {{}, errno};
        }
        const can_err_mask_t errors = CAN_ERR_CRTL | CAN_ERR_BUSOFF | CAN_ERR_RESTARTED;
        const bool roomy = make_room(descriptor);
        bool sound = set(descriptor, SOL_SOCKET, SO_TIMESTAMPNS, 1) && set(descriptor, SOL_SOCKET, SO_RXQ_OVFL, 1);
        if (error_frames) {
            sound = sound && set(descriptor, SOL_CAN_RAW, CAN_RAW_ERR_FILTER, static_cast<int>(errors));
        }
        int error = sound ? 0 : errno;
        if (error == 0) {
            const unsigned number = interface_number(interface);
            error = number == 0 ? ENODEV : bind_to(descriptor, number);
        }
        if (error != 0) {
            return {{}, error};
        }
        return {std::move(opened), 0, roomy};
    }

    int set_filters(int descriptor, const std::vector<can_filter>& filters) override {
        const auto size = static_cast<socklen_t>(filters.size() * sizeof(can_filter));
        return setsockopt(descriptor, SOL_CAN_RAW, CAN_RAW_FILTER, filters.data(), size) == 0 ? 0 : errno;
    }

    int send(int descriptor, const can_frame& frame) override {
        const ssize_t sent = ::write(descriptor, &frame, sizeof frame);
        return sent == static_cast<ssize_t>(sizeof frame) ? 0 : sent < 0 ? errno : EIO;
    }

    int receive(int descriptor, std::vector<CanReception>& into) override {
        std::array<can_frame, batch> frames{};
        std::array<iovec, batch> places{};
        std::array<Control, batch> controls{};
        std::array<mmsghdr, batch> messages{};
        for (std::size_t i = 0; i < batch; ++i) {
            places[i] = {&frames[i], sizeof frames[i]};
            messages[i].msg_hdr.msg_iov = &places[i];
            messages[i].msg_hdr.msg_iovlen = 1;
            messages[i].msg_hdr.msg_control = controls[i].bytes.data();
            messages[i].msg_hdr.msg_controllen = controls[i].bytes.size();
        }
        const int count = recvmmsg(descriptor, messages.data(), batch, 0, nullptr);
        for (int n = 0; n < count; ++n) {
            const auto i = static_cast<std::size_t>(n);
            if (messages[i].msg_len != sizeof frames[i]) {
                return EIO;
            }
            CanReception got;
            got.frame = frames[i];
            read_control(messages[i].msg_hdr, got);
            into.push_back(got);
        }
        return count < 0 ? errno : 0;
    }

    std::uint32_t dropped(int descriptor) override {
        std::array<std::uint32_t, SK_MEMINFO_VARS> numbers{};
        socklen_t size = sizeof numbers;
        static_cast<void>(getsockopt(descriptor, SOL_SOCKET, SO_MEMINFO, numbers.data(), &size));
        return numbers[SK_MEMINFO_DROPS];
    }

    unsigned interface_number(const std::string& interface) override { return if_nametoindex(interface.c_str()); }

    bool is_up(const std::string& interface) override {
        const Descriptor asks{socket(PF_CAN, SOCK_RAW | SOCK_CLOEXEC, CAN_RAW)};
        ifreq request{};
        interface.copy(request.ifr_name, sizeof request.ifr_name - 1);
        const bool known = asks.is_open() && ioctl(asks.number(), SIOCGIFFLAGS, &request) == 0;
        return known && (static_cast<unsigned>(request.ifr_flags) & static_cast<unsigned>(IFF_UP)) != 0U;
    }

    std::uint32_t bit_rate(const std::string& interface) override {
        const Hush hush;
        can_bittiming timing{};
        return can_get_bittiming(interface.c_str(), &timing) == 0 ? timing.bitrate : 0U;
    }

    BitRateOutcome set_bit_rate(const std::string& interface, std::uint32_t wanted) override {
        const std::uint32_t present = bit_rate(interface);
        if (present == 0 || present == wanted) {
            return {present == wanted,
                    present == wanted ? "" : fmt::format("{} has no bit rate that can be set", interface)};
        }
        const Hush hush;
        if (can_do_stop(interface.c_str()) != 0) {
            return {false, fmt::format("{} could not be switched off; this needs CAP_NET_ADMIN", interface)};
        }
        const bool done = can_set_bitrate(interface.c_str(), wanted) == 0;
        const bool up = can_do_start(interface.c_str()) == 0;
        return {done && up, done && up ? ""
                            : done     ? fmt::format("{} could not be switched on again", interface)
                                       : fmt::format("{} does not support this bit rate", interface)};
    }

    bool restart(const std::string& interface) override {
        const Hush hush;
        return can_do_restart(interface.c_str()) == 0;
    }

    std::uint64_t realtime_ns() override { return kernel_realtime_ns(); }
};

}  // namespace

CanSystem& linux_can_system() {
    static LinuxCanSystem system;
    return system;
}

}  // namespace canproof::host
