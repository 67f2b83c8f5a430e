// SPDX-License-Identifier: Apache-2.0
// Compares every object of the RC-22 with section 1 of its data sheet, at node 5.
#include "tests/support/object_sheet.hpp"

#include "generated/relay_counter/objects.hpp"
#include "generated/relay_counter/requirements.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

using namespace sheet;

class RelayCounterSheet : public ObjectSheet {
  protected:
    RelayCounterSheet()
        : ObjectSheet{generated::relay_counter::tables, generated::relay_counter::image_size, LimitAbort::high_low, 5} {
    }
};

}  // namespace

TEST_F(RelayCounterSheet, ObjectsMatchTheDataSheet) {
    verifies<req::RC_OD_1000, req::RC_OD_1001, req::RC_OD_1017, req::RC_OD_1018, req::RC_OD_2000, req::RC_OD_2010>();
    check({
        {0x1000, 0, u32, Access::ro, {0}, none, none},
        {0x1001, 0, u8, Access::ro, {0}, none, none},
        {0x1017, 0, u16, Access::rw, {0}, 0, 0xFFFF},
        {0x1018, 1, u32, Access::ro, {0}, none, none},
        {0x2000, 2, u8, Access::rw, {0}, 0, 1, Map::no, false},
        {0x2010, 0, u32, Access::ro, {0}, none, none},
    });
}

}  // namespace canproof::test
