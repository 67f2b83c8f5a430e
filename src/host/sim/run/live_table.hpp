// SPDX-License-Identifier: Apache-2.0
// The table that `run` shows on a terminal: one line for the bus, then one line per node.
#pragma once

#include <string>
#include <vector>

#include "host/sim/run/run_session.hpp"

namespace canproof::host {

struct TableSize {
    std::size_t columns{80};
    std::size_t rows{24};
};

/// Returns at most `rows - 1` lines of at most `columns` characters; the last line counts the nodes without a line.
/// `notices` are shown below, the newest last. `lag` is the delay of the simulation, shown unless it is 0.
std::vector<std::string> table_lines(const RunSession& session, const std::vector<std::string>& notices, TableSize size,
                                     Duration lag = {});

/// Returns the word of a state, such as "operational".
const char* state_word(NmtState state);

}  // namespace canproof::host
