// `canproof conform`: the conformance test of a slave.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace canproof::host {

struct ConformCommandOptions {
    std::string device;               ///< of the catalogue; empty: `eds`
    std::string eds;                  ///< file
    std::optional<std::string> node;  ///< as shipped without it
    std::string bus;                  ///< socketcan:INTERFACE or socketcand-client:HOST:PORT; empty: virtual time
    bool list{false};
    std::vector<std::string> only;   ///< services
    std::vector<std::string> skip;   ///< ids, numbers or services
    std::vector<std::string> cases;  ///< ids or numbers
    std::string folder;              ///< with other cases than the program's
    std::string report;              ///< folder
    bool json{false};
    bool allow_outputs{false};
    bool allow_store{false};
    bool allow_lss{false};
    bool by_hand{false};  ///< the user switches the slave off and on
    double traffic{0.0};  ///< per cent of the bus
};

/// Prints verdicts and writes the report. Exit status: 0 all passed, 1 a case failed, 2 the run could not be done.
int run_conform(const ConformCommandOptions& options);

}  // namespace canproof::host
