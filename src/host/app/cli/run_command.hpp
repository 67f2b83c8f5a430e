// SPDX-License-Identifier: Apache-2.0
// `canproof run`: devices in real time on a bus.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace canproof::host {

struct RunOptions {
    /// devices of the catalogue, each NAME or NAME@NODE; when this, `eds` and `arm` are empty: the whole catalogue
    std::vector<std::string> devices;
    std::vector<std::string> eds;      ///< data sheets, each FILE or FILE@NODE
    std::vector<std::string> arm;      ///< firmware images for the emulated microcontroller, each IMAGE or IMAGE@NODE
    std::vector<std::string> factory;  ///< factory data, each KEY=VALUE or DEVICE.KEY=VALUE
    /// the bus: inproc, socketcan:INTERFACE, socketcand[:HOST:PORT] or socketcand-client:HOST:PORT[/BUS]
    std::string bus{"inproc"};
    std::string bus_faults;         ///< faults of the bus inproc or socketcand; parse_bus_faults() describes the format
    bool control_interface{false};  ///< the run may set the bit rate of an interface and restart its controller
    bool plain{false};              ///< no table, even on a terminal
    /// log of all frames; the ending of its name selects the format: .pcapng, .pcap, otherwise candump
    std::string log;
    bool log_marks{false};  ///< appends T (sent by a device of this run) or R (by others) to each line of a candump log
    std::string nvm;        ///< folder with one file per device, which keeps its non-volatile memory
    std::string stimulus;
    std::string outputs;
    std::optional<double> seconds;
};

/// Runs the devices for `seconds`, or until a signal ends the run. Returns the exit status.
int run_devices(const RunOptions& options);

}  // namespace canproof::host
