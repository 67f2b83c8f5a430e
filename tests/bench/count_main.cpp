// SPDX-License-Identifier: Apache-2.0
// Runs each transaction for a node and for the floor (the minimum that any server must do, floor/floor.hpp). Without
// callgrind it only checks that the transactions work. Under callgrind, which counts only in receive(), pump() and
// change() of node and floor, each transaction writes a dump file. tests/bench/count makes its table from these dumps.
#include <valgrind/callgrind.h>

#include <cstdio>
#include <exception>

#include "tests/bench/transactions.hpp"

namespace {

void count(const canproof::bench::Transaction& transaction, canproof::bench::Server& server, const std::string& name) {
    transaction.prepare(server);
    transaction.run(server);  // warm-up: initialises static objects and branch prediction
    CALLGRIND_ZERO_STATS;
    transaction.run(server);
    CALLGRIND_DUMP_STATS_AT(name.c_str());
}

}  // namespace

int main() {
    try {
        for (const auto& transaction : canproof::bench::transactions()) {
            canproof::bench::TestNode node;
            count(transaction, node, transaction.name);
            count(transaction, *canproof::bench::make_floor(), "floor of " + transaction.name);
            std::printf("%s\t%.0f\t%.0f\n", transaction.name.c_str(), transaction.limit, transaction.plain_limit);
        }
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
    return 0;
}
