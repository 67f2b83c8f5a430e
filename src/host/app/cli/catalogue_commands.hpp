// `canproof devices`, `signals`, `eds` and `spec check`: what the program knows without running anything.
#pragma once

#include <string>

namespace canproof::host {

/// Each returns the exit status, and throws InputError for a device that is not in the catalogue.
int list_devices();
int list_signals(const std::string& device);
/// `format`: eds, eds-lely, xdd, json or md.
int print_eds(const std::string& device, const std::string& format);
/// Every fault of the register in this folder; 1 when there is one.
int check_spec(const std::string& spec);

}  // namespace canproof::host
