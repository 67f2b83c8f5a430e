// SPDX-License-Identifier: Apache-2.0
// slave_tables DIR writes the tables of the conformance slave, because the target cannot read its requirements
// register.
#include <iostream>

#include "host/codegen/write_all.hpp"
#include "host/register/load.hpp"
#include "tests/support/slave_register.hpp"

int main(int argc, char** argv) {
    if (argc != 2) {
        std::cerr << "slave_tables DIR\n";
        return 2;
    }
    const auto files = canproof::test::slave_files();
    const auto loaded = canproof::host::load_register(files);
    for (const auto& fault : loaded.faults) {
        std::cerr << fault.text() << '\n';
    }
    if (!loaded.faults.empty()) {
        return 1;
    }
    canproof::host::write_all(loaded.content, files, argv[1]);
    return 0;
}
