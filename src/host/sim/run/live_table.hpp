// SPDX-License-Identifier: Apache-2.0
// The table that `run` shows on a terminal: one line for the bus, and one line for each node.
#pragma once

#include <string>
#include <vector>

#include "host/sim/run/run_session.hpp"

namespace canproof::host {

struct TableSize {
    std::size_t columns{80};
    std::size_t rows{24};
};

/// Returns fewer than `rows` lines of at most `columns` bytes; a terminal with very few rows gets more lines than it
/// has rows. If not all nodes fit, the last line of the nodes contains the number of the others. The three newest
/// `notices` follow below it. `lag` is the delay of the simulation, which is shown unless it is 0.
std::vector<std::string> table_lines(const RunSession& session, const std::vector<std::string>& notices, TableSize size,
                                     Duration lag = {});

/// Returns the word for an NMT state, such as "operational".
const char* state_word(NmtState state);

}  // namespace canproof::host
