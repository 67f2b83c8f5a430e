// SPDX-License-Identifier: Apache-2.0
#include "host/app/cli/run_arguments.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>

namespace canproof::host {

void add_run_options(CLI::App& command, RunOptions& running) {
    command.add_option("DEVICE", running.devices, fmt::format("NAME or NAME@NODE; {}", node_help));
    command
        .add_option("--eds", running.eds, "EDS, DCF or XDD file, or FILE@NODE: a device with the objects of this file")
        ->allow_extra_args(false);
    command
        .add_option("--arm", running.arm,
                    "build/target/bridged_NAME.elf, or FILE@NODE: the device's image on an STM32F405 in QEMU")
        ->allow_extra_args(false);
    command.add_option("--factory", running.factory, factory_help)->allow_extra_args(false);
    command
        .add_option("--bus", running.bus,
                    "inproc, socketcan:vcan0, socketcand:127.0.0.1:29536 (a server; without remote frames) or "
                    "socketcand-client:127.0.0.1:29536/can0 (joins such a server)")
        ->capture_default_str();
    command.add_option(
        "--bus-faults", running.bus_faults,
        "corrupted=0.01,lost=0.001,bus-off=0.0001,seed=1: rates per frame, on the bus inproc or socketcand");
    command.add_flag(
        "--control-interface", running.control_interface,
        "allow the run to set the interface's bit rate for LSS, and to restart the interface after bus-off");
    auto* log =
        command.add_option("--log", running.log,
                           "all frames as `candump -L` writes them; FILE.pcapng for Wireshark, FILE.pcap for SavvyCAN");
    command
        .add_flag("--log-marks", running.log_marks,
                  "write T after the devices' frames and R after all others, as `candump -L -x` does")
        ->needs(log);
    command.add_option("--nvm", running.nvm, "folder that keeps the stored parameters of each device");
    command.add_option("--stimulus", running.stimulus,
                       "CSV file with lines seconds,signal,value; write device.signal for one of several devices");
    command.add_option("--outputs", running.outputs, "CSV file to write changes of outputs to");
}

}  // namespace canproof::host
