#include "tests/support/slave.hpp"

#include "tests/support/slave_register.hpp"

namespace canproof::test {

const host::GenericDescription& slave() {
    static const host::GenericDescription description = host::describe(slave_part());
    return description;
}

}  // namespace canproof::test
