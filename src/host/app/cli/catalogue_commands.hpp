// SPDX-License-Identifier: Apache-2.0
// `canproof devices`, `signals` and `eds`: data of the devices, printed without running them.
#pragma once

#include <string>

namespace canproof::host {

/// Each function prints to standard output and returns the exit status. It throws InputError for a device that is not
/// in the catalogue.
int list_devices();
int list_signals(const std::string& device);
struct EdsOptions {
    /// device of the catalogue; for `dbc` also a data sheet. For `dbc`, a text with a dot or a slash is the path of a
    /// data sheet, unless it is the name of a device.
    std::string device;
    std::string format{"eds"};  ///< eds, eds-lely, xdd, json, md or dbc
    int node{0};                ///< node-ID of a DBC, 1 to 127; 0: the node-ID as shipped
};
int print_eds(const EdsOptions& options);

}  // namespace canproof::host
