// `--bus` as a bus.
#pragma once

#include <memory>

#include "host/app/cli/run_command.hpp"
#include "host/sim/bus/bus.hpp"

namespace canproof::host {

/// `bit_rate` in bit/s is what the devices are set to. Throws InputError.
std::unique_ptr<Bus> make_bus(const RunOptions& options, std::uint32_t bit_rate);

}  // namespace canproof::host
