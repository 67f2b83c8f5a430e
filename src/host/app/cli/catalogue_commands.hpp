// `canproof devices`, `signals` and `eds`: what the program knows without running anything.
#pragma once

#include <string>

namespace canproof::host {

/// Each returns the exit status, and throws InputError for a device that is not in the catalogue.
int list_devices();
int list_signals(const std::string& device);
struct EdsOptions {
    std::string device;         ///< of the catalogue; with format dbc a file as well: a word with a dot or a slash
    std::string format{"eds"};  ///< eds, eds-lely, xdd, json, md or dbc
    int node{0};                ///< node-ID of a DBC, 1 to 127; 0: as shipped
};
int print_eds(const EdsOptions& options);

}  // namespace canproof::host
