// SPDX-License-Identifier: Apache-2.0
#include "tests/support/slave.hpp"

#include <stdexcept>

#include "host/register/load.hpp"
#include "tests/support/slave_register.hpp"

namespace canproof::test {

const host::Part& slave_part() {
    static const host::LoadResult loaded = host::load_register(slave_files());
    if (!loaded.faults.empty()) {
        throw std::logic_error{loaded.faults.front().text()};
    }
    return *loaded.content.part("slave");
}

const host::GenericDescription& slave() {
    static const host::GenericDescription description = host::describe(slave_part());
    return description;
}

}  // namespace canproof::test
