// The table that `run` shows on a terminal: the bus in one line, then one line a node.
#pragma once

#include <string>
#include <vector>

#include "host/sim/run/run_session.hpp"

namespace canproof::host {

struct TableSize {
    std::size_t columns{80};
    std::size_t rows{24};
};

/// Lines of at most `columns` characters, at most `rows - 1` of them; nodes that find no room are counted in the last.
/// `notices`: the newest last, shown below. `lag`: how far the simulation is behind, shown where it is.
std::vector<std::string> table_lines(const RunSession& session, const std::vector<std::string>& notices, TableSize size,
                                     Duration lag = {});

/// "operational"
const char* state_word(NmtState state);

}  // namespace canproof::host
