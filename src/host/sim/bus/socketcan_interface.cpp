// SPDX-License-Identifier: Apache-2.0
// The functions of SocketCanBus for its CAN interface: sockets, bit rate, and loss and return of the interface.

#include <fmt/format.h>

#include <cstring>
#include <utility>

#include "host/base/input_error.hpp"
#include "host/sim/bus/kernel_frame.hpp"
#include "host/sim/bus/socketcan_bus.hpp"

namespace canproof::host {

namespace {

std::string remedy(const std::string& interface, int error) {
    if (error == EAFNOSUPPORT) {
        return "this kernel has no SocketCAN; use --bus socketcand:127.0.0.1:29536 or --bus inproc";
    }
    if (error == ENODEV) {
        return fmt::format(
            "make the interface with `ip link add dev {0} type vcan; ip link set {0} up`, or name another interface",
            interface);
    }
    return "check that it is a CAN interface and that you have the permission to use it";
}

}  // namespace

void SocketCanBus::open_socket(Port& port) {
    CanOpening opening = system_.open(interface_, port.node != nullptr);
    if (opening.error != 0) {
        throw InputError{fmt::format("{} cannot be opened ({}); {}", interface_, std::strerror(opening.error),
                                     remedy(interface_, opening.error))};
    }
    port.socket = std::move(opening.socket);
    port.dropped = 0;
    roomy_ = roomy_ && opening.roomy;
    if (port.node != nullptr) {
        port.filters = port.node->filters();
        static_cast<void>(system_.set_filters(port.socket.number(), kernel_filters(port.filters)));
    }
}

void SocketCanBus::close_sockets() {
    for (Port& port : ports_) {
        port.socket = {};
    }
}

/// Follows a change of the node: sets the filters of its socket, and calls change_bit_rate() for a new bit rate. A new
/// node-ID or configuration changes the node's filters and can change its bit rate.
void SocketCanBus::follow_node(Port& port) {
    if (port.socket.is_open()) {
        const std::vector<AcceptanceFilter>& wanted = port.node->filters();
        if (!(wanted == port.filters)) {
            static_cast<void>(system_.set_filters(port.socket.number(), kernel_filters(wanted)));
            port.filters = wanted;
        }
    }
    const std::uint32_t rate = port.node->bit_rate();
    if (rate != port.bit_rate) {
        port.bit_rate = rate;
        if (rate != 0) {
            change_bit_rate(port);
        }
    }
}

void SocketCanBus::change_bit_rate(const Port& port) {
    const std::string wish = fmt::format("{}: LSS sets {} bit/s", port.node->name(), port.bit_rate);
    const std::string commands = fmt::format(
        "the commands for this are: ip link set {0} down; ip link set {0} type can bitrate {1}; ip link set {0} up",
        interface_, port.bit_rate);
    if (control_ == InterfaceControl::none) {
        notice(fmt::format("{}; {} is unchanged without --control-interface; {}", wish, interface_, commands));
        return;
    }
    const BitRateOutcome outcome = system_.set_bit_rate(interface_, port.bit_rate);
    if (outcome.done) {
        bit_rate_ = port.bit_rate;
        notice(fmt::format("{}; {} has this bit rate now", wish, interface_));
    } else {
        notice(fmt::format("{}; {}; {}", wish, outcome.why, commands));
    }
}

/// Handles a possible loss of the interface. The kernel also reports a change that is already over, so the present
/// state decides.
void SocketCanBus::lose_interface(Instant now) {
    const bool same = system_.interface_number(interface_) == number_;
    if (same && system_.is_up(interface_)) {
        return;
    }
    down_ = true;
    // Setting the interface up again also starts the controller, so no restart after bus-off is needed.
    restart_at_ = never;
    look_at_ = now + search_period;
    notice(fmt::format("{} is {}; waiting for it", interface_,
                       system_.interface_number(interface_) == 0 ? "gone" : "down"));
    for (Port& port : ports_) {
        port.retry = never;
        port.pause = Duration{};
        port.waiting.clear();
        if (port.node != nullptr) {
            set_state(port, CanState::bus_off, now);
        }
    }
}

void SocketCanBus::look_for_interface(Instant now) {
    look_at_ = now + search_period;
    const unsigned number = system_.interface_number(interface_);
    if (number == 0 || !system_.is_up(interface_)) {
        return;
    }
    if (number != number_) {
        close_sockets();
        try {
            for (Port& port : ports_) {
                open_socket(port);
            }
        } catch (const InputError&) {
            return;  // the interface is lost again; the next search handles this
        }
        number_ = number;
        own_ = EchoMatcher<Sender>{};  // frames that the old sockets have sent do not come back at the new ones
    }
    down_ = false;
    look_at_ = never;
    bit_rate_ = system_.bit_rate(interface_);
    notice(fmt::format("{} is up again", interface_));
    for (Port& port : ports_) {
        if (port.node != nullptr) {
            set_state(port, CanState::error_active, now);
        }
    }
}

void SocketCanBus::restart_controller(Instant now) {
    restart_at_ = never;
    if (control_ == InterfaceControl::none) {
        notice(fmt::format(
            "{0} is bus-off and stays so without --control-interface; to restart it, run: ip link set {0} type can "
            "restart",
            interface_));
    } else if (!system_.restart(interface_)) {
        restart_at_ = now + restart_after;
        if (!restart_failure_told_) {
            notice(
                fmt::format("{0} is bus-off, and the kernel refuses the restart; the program goes on trying. With "
                            "CAP_NET_ADMIN, try: ip link set {0} type can restart",
                            interface_));
        }
        restart_failure_told_ = true;
    }
}

}  // namespace canproof::host
