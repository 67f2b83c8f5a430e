// SPDX-License-Identifier: Apache-2.0
// `canproof run`: devices in real time on a bus.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace canproof::host {

struct RunOptions {
    std::vector<std::string> devices;  ///< NAME or NAME@NODE; none here, in `eds` and in `arm`: the whole catalogue
    std::vector<std::string> eds;      ///< FILE or FILE@NODE
    std::vector<std::string> arm;      ///< IMAGE or IMAGE@NODE, on the emulated microcontroller
    std::vector<std::string> factory;  ///< KEY=VALUE or DEVICE.KEY=VALUE
    std::string bus{"inproc"};         ///< inproc, socketcan:INTERFACE, socketcand[:HOST:PORT],
                                       ///< socketcand-client:HOST:PORT[/BUS]
    std::string bus_faults;            ///< faults of the in-process bus, see parse_bus_faults()
    bool control_interface{false};     ///< the run may set the bit rate of an interface and restart its controller
    bool plain{false};                 ///< no table, even on a terminal
    std::string log;                   ///< log of all frames; its name's ending selects pcapng or pcap
    bool log_marks{false};             ///< T and R after the frames of a candump log
    std::string nvm;                   ///< folder with one memory image per device
    std::string stimulus;
    std::string outputs;
    std::optional<double> seconds;
};

/// Runs the devices for `seconds`, or until it is interrupted. Returns the exit status.
int run_devices(const RunOptions& options);

}  // namespace canproof::host
