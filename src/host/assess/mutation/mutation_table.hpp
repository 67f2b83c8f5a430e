// Mutants of code by layer and operator, and which harness noticed them.
#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "host/assess/mutation/mutation_outcome.hpp"

namespace canproof::host {

/// What kind of change a mutant of code is: condition, operator, statement, assignment, order, variable, index or
/// literal.
std::string operator_of(const std::string& change);

/// `canopen` for src/firmware/canopen/emcy.cpp, `ax130751` for src/devices/ax130751/firmware/relay.cpp, `host/bus` for
/// src/host/sim/bus/candump.cpp.
std::string layer_of(const std::string& file);

/// Of the host's buses and replay, not of the firmware.
bool is_host(const std::string& file);

/// `conformance`, `units` or `properties`, from the source of the test that noticed; `otherwise` without one.
std::string harness_of(const std::string& test_file);

/// One line of the table.
struct OperatorCount {
    std::size_t mutants{0};
    std::map<std::string, std::size_t> noticed;  ///< by harness
    std::size_t justified{0};
    std::size_t open{0};
};

/// By layer and operator. The operator `all` holds the sums, and so do the layers `all` of the firmware, `host` of the
/// host's buses and replay.
std::map<std::pair<std::string, std::string>, OperatorCount> count_by_operator(
    const std::vector<MutationOutcome>& outcomes);

/// The table with a line of headings.
std::string operators_csv(const std::vector<MutationOutcome>& outcomes);

}  // namespace canproof::host
