// SPDX-License-Identifier: Apache-2.0
#include "host/app/cli/make_bus.hpp"

#include <fmt/format.h>

#include "firmware/base/time.hpp"
#include "host/base/input_error.hpp"
#include "host/base/standard_streams.hpp"
#include "host/sim/bus/arbitrated_bus.hpp"
#include "host/sim/bus/linux_can_system.hpp"
#include "host/sim/bus/socketcan_bus.hpp"
#include "host/sim/bus/socketcand_bus.hpp"
#include "host/sim/bus/socketcand_client_bus.hpp"

namespace canproof::host {

namespace {

constexpr std::size_t longest_interface_name = 15;  // IFNAMSIZ without the terminating zero

std::unique_ptr<Bus> make_socketcan(const RunOptions& options, const std::string& interface) {
    if (interface.empty() || interface.size() > longest_interface_name) {
        throw InputError{
            fmt::format("`{}` cannot name an interface: a name has 1 to {} characters; write --bus socketcan:vcan0",
                        interface, longest_interface_name)};
    }
    const auto control = options.control_interface ? InterfaceControl::granted : InterfaceControl::none;
    return std::make_unique<SocketCanBus>(interface, linux_can_system(), control, Instant{});
}

std::unique_ptr<Bus> make_socketcand(const std::string& address, std::uint32_t bit_rate, const BusFaultRates& faults) {
    auto bus = std::make_unique<SocketcandBus>(parse_listen_address(address), bit_rate, faults,
                                               linux_can_system().realtime_ns() / 1000);
    tell(fmt::format("socketcand listens at port {}; python-can: interface=socketcand channel=can0 port={}",
                     bus->port(), bus->port()));
    return bus;
}

}  // namespace

std::unique_ptr<Bus> make_bus(const RunOptions& options, std::uint32_t bit_rate) {
    const auto colon = options.bus.find(':');
    const std::string kind = options.bus.substr(0, colon);
    const std::string rest = colon == std::string::npos ? "" : options.bus.substr(colon + 1);
    const BusFaultRates faults = parse_bus_faults(options.bus_faults);
    if ((kind == "socketcan" || kind == "socketcand-client") && faults.any()) {
        throw InputError{
            "--bus-faults applies only to --bus inproc and --bus socketcand; use one of these buses, or remove "
            "--bus-faults"};
    }
    if (kind != "socketcan" && options.control_interface) {
        throw InputError{
            "--control-interface applies only to --bus socketcan:INTERFACE; use this bus, or remove "
            "--control-interface"};
    }
    if (kind == "inproc" && rest.empty()) {
        return std::make_unique<ArbitratedBus>("inproc", bit_rate, faults);
    }
    if (kind == "socketcan") {
        return make_socketcan(options, rest);
    }
    if (kind == "socketcand") {
        return make_socketcand(rest, bit_rate, faults);
    }
    if (kind == "socketcand-client") {
        return std::make_unique<SocketcandClientBus>(parse_socketcand_place(rest), bit_rate, Instant{});
    }
    throw InputError{
        fmt::format("bus `{}` is unknown; use inproc, socketcan:vcan0, socketcand:127.0.0.1:29536 "
                    "or socketcand-client:127.0.0.1:29536/can0",
                    options.bus)};
}

bool is_joining(const Bus& bus) {
    const auto* const client = dynamic_cast<const SocketcandClientBus*>(&bus);
    return client != nullptr && !client->has_joined();
}

}  // namespace canproof::host
