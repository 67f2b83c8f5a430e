// SPDX-License-Identifier: Apache-2.0
// Counts the mutants of code by layer and by operator (kind of change), and by the test suite that noticed them.
#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "host/assess/mutation/mutation_outcome.hpp"

namespace canproof::host {

/// Returns the kind of change of a mutant of code: condition, operator, statement, assignment, order, variable, index
/// or literal.
std::string operator_of(const std::string& change);

/// Returns the layer of a source: `canopen` for src/firmware/canopen/emcy.cpp, `ax130751` for
/// src/devices/ax130751/firmware/relay.cpp, `target/zynqmp` for src/target/zynqmp/can.cpp, `host/bus` for
/// src/host/sim/bus/candump.cpp.
std::string layer_of(const std::string& file);

/// Returns whether the file belongs to the host's buses and replay instead of the firmware.
bool is_host(const std::string& file);

/// Returns the test suite to which the file of a test belongs: `conformance`, `units` or `properties`. Returns
/// `otherwise` for an empty path.
std::string harness_of(const std::string& test_file);

/// The numbers of mutants for one layer and one operator (kind of change).
struct OperatorCount {
    std::size_t mutants{0};
    std::map<std::string, std::size_t> noticed;  ///< number of noticed mutants by test suite (harness_of())
    std::size_t justified{0};
    std::size_t open{0};
};

/// Returns the counts by layer and operator. The operator `all` contains the sums over all operators. The layer `all`
/// contains the sums over the firmware; the layer `host` contains the sums over the host's buses and replay.
std::map<std::pair<std::string, std::string>, OperatorCount> count_by_operator(
    const std::vector<MutationOutcome>& outcomes);

/// Returns the table as CSV with a header line.
std::string operators_csv(const std::vector<MutationOutcome>& outcomes);

}  // namespace canproof::host
