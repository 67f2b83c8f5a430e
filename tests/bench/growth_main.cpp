// SPDX-License-Identifier: Apache-2.0
// Runs each kind of work (load) in growing sizes. Under callgrind with --instr-atstart=no each run writes a dump named
// `load<TAB>size`, from which tests/bench/growth makes its table. Without callgrind the program only checks that the
// work is done. With any argument it runs each load only at its full size.
#include <valgrind/callgrind.h>

#include <cstdio>
#include <exception>

#include "tests/bench/growth_loads.hpp"

namespace {

void measure(const canproof::bench::Load& load, std::size_t size) {
    const std::function<void()> run = load.prepare(size);
    CALLGRIND_START_INSTRUMENTATION;
    CALLGRIND_ZERO_STATS;
    run();
    CALLGRIND_STOP_INSTRUMENTATION;
    const std::string name = load.name + "\t" + std::to_string(size);
    CALLGRIND_DUMP_STATS_AT(name.c_str());
    std::printf("%s\t%zu\t%s\t%.0f\n", load.name.c_str(), size, load.unit.c_str(), load.limit);
}

}  // namespace

int main(int argc, char**) {
    try {
        for (const canproof::bench::Load& load : canproof::bench::loads()) {
            if (argc > 1) {
                measure(load, load.largest);
                continue;
            }
            for (const std::size_t size : load.sizes) {
                measure(load, size);
            }
        }
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
    return 0;
}
