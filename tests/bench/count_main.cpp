// Instructions of each transaction. Run by itself it only checks that the transactions work; under callgrind, told to
// collect in receive(), pump() and change() of TestNode, each leaves a dump named after it, of which tests/bench/count
// makes the table.
#include <valgrind/callgrind.h>

#include <cstdio>
#include <exception>

#include "tests/bench/transactions.hpp"

int main() {
    try {
        for (const auto& transaction : canproof::bench::transactions()) {
            canproof::bench::TestNode node;
            transaction.prepare(node);
            transaction.run(node);  // warm: statics are made, the branch is taken once
            CALLGRIND_ZERO_STATS;
            transaction.run(node);
            CALLGRIND_DUMP_STATS_AT(transaction.name.c_str());
            std::printf("%s\t%.0f\t%.0f\n", transaction.name.c_str(), transaction.limit, transaction.best_other);
        }
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
    return 0;
}
