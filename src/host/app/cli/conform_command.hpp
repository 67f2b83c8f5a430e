// SPDX-License-Identifier: Apache-2.0
// `canproof conform`: the conformance test of a slave.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace canproof::host {

struct ConformCommandOptions {
    std::string device;               ///< name in the catalogue; empty: `eds` or `arm` is given
    std::string eds;                  ///< path of an EDS, DCF or XDD; empty: `device` or `arm` is given
    std::string arm;                  ///< path of the slave's program for the emulated microcontroller; empty: none
    std::optional<std::string> node;  ///< node-ID; without it, that of the data sheet
    std::string bus;                  ///< socketcan:INTERFACE or socketcand-client:HOST:PORT; empty: virtual time
    bool list{false};
    std::vector<std::string> only;   ///< services, such as sdo, whose test cases run; empty: all
    std::vector<std::string> skip;   ///< ids, numbers or services of the test cases to leave out
    std::vector<std::string> cases;  ///< ids or numbers of the test cases to run; empty: all
    std::string folder;              ///< folder with test cases that replace the built-in test cases
    std::string report;              ///< folder for the report; empty: no report
    bool json{false};
    bool allow_outputs{false};
    bool allow_store{false};
    bool allow_lss{false};
    bool by_hand{false};           ///< whether the user switches the slave off and on
    bool no_remote_frames{false};  ///< the user's adapter does not transmit remote frames
    double traffic{0.0};           ///< load by traffic of other nodes, in per cent of the bus's capacity
};

/// Prints the verdict of each test case and writes the report. Returns the exit status of the report: 0 when every case
/// that applies passed. Throws InputError when the run is not possible.
int run_conform(const ConformCommandOptions& options);

}  // namespace canproof::host
