// SPDX-License-Identifier: Apache-2.0
// COB-IDs and the node-ID in each device of the catalogue (CAN-CBX-AO412, 7.5.1; AX130751, AX188001, 3.2.14; AX060805,
// 4.2.14). A default COB-ID follows the node-ID even when 1010h (store parameters) has stored it. A COB-ID that the
// user has set does not change with the node-ID.
#include <algorithm>

#include "generated/canopen/requirements.hpp"
#include "generated/cbx_ao412/requirements.hpp"
#include "tests/support/device_by_sdo.hpp"
#include "tests/support/every_device.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

/// Returns the index of the communication parameters of the first RPDO; 0 in a device without RPDO.
unsigned first_rpdo(const std::string& name) {
    const auto device = host::make_device(name);
    for (std::uint16_t index = 0x1400; index < 0x1600; ++index) {
        if (device->objects()->find(index, 0).ok()) {
            return index;
        }
    }
    return 0;
}

/// Returns the devices that have an RPDO and 1010h (store parameters).
std::vector<std::string> devices_that_store_an_rpdo() {
    std::vector<std::string> all = every_device_with(0x1010);
    all.erase(std::remove_if(all.begin(), all.end(), [](const auto& name) { return first_rpdo(name) == 0; }),
              all.end());
    return all;
}

/// Starts each device as node 3; the tests use its first RPDO.
class CobIdOfTheDevice : public testing::TestWithParam<std::string> {
  protected:
    std::uint32_t cob_id() { return unit.read(index, 1); }
    /// Sets the COB-ID while the RPDO is not valid.
    void set_cob_id(std::uint32_t value) {
        ASSERT_TRUE(unit.write(index, 1, 4, cob_id() | 0x80000000U));
        ASSERT_TRUE(unit.write(index, 1, 4, value));
    }
    DeviceBySdo unit{GetParam(), 3};
    const unsigned index = first_rpdo(GetParam());
    const std::uint32_t as_shipped = cob_id();  ///< the default COB-ID of node 3
};

}  // namespace

TEST_P(CobIdOfTheDevice, DefaultCobIdFollowsTheNodeIdEvenWhenStored) {
    verifies<req::CO_PDO_030, req::CO_PDO_035, req::AO4_STORE_006>();
    EXPECT_EQ(as_shipped & 0x7FU, 3U);
    ASSERT_TRUE(unit.save());
    unit.move_to(9);
    EXPECT_EQ(cob_id(), as_shipped + 6);
    ASSERT_TRUE(unit.save(3));  // saves another parameter group (1010h:3) while the node-ID is 9
    unit.move_to(4);
    EXPECT_EQ(cob_id(), as_shipped + 1);
    ASSERT_TRUE(unit.save(2));
    unit.move_to(3);
    EXPECT_EQ(cob_id(), as_shipped);
}

TEST_P(CobIdOfTheDevice, ChangedCobIdIsLostUnlessStoredAndDoesNotFollowTheNodeId) {
    verifies<req::CO_PDO_030, req::CO_PDO_060, req::AO4_STORE_004>();
    set_cob_id(as_shipped + 0x40);
    unit.power_cycle();
    EXPECT_EQ(cob_id(), as_shipped);  // the new COB-ID was not stored
    set_cob_id(as_shipped + 0x40);
    ASSERT_TRUE(unit.save());
    for (const int node_id : {9, 3, 0x43}) {
        unit.move_to(node_id);
        EXPECT_EQ(cob_id(), as_shipped + 0x40) << node_id;
    }
}

TEST_P(CobIdOfTheDevice, StoredCobIdEqualToTheDefaultOfANewNodeIdIsKeptWhenTheNodeIdChanges) {
    verifies<req::CO_PDO_060, req::CO_STORE_011>();
    set_cob_id(as_shipped + 6);  // the default COB-ID of node 9
    ASSERT_TRUE(unit.save(2));
    unit.move_to(9);
    EXPECT_EQ(cob_id(), as_shipped + 6);
    ASSERT_TRUE(unit.save(3));
    unit.move_to(3);
    EXPECT_EQ(cob_id(), as_shipped + 6);
}

/// Bit 31 disables the RPDO, and bit 30 has no effect on an RPDO. A change of these flags does not count as a change of
/// the identifier.
TEST_P(CobIdOfTheDevice, CobIdWithOnlyItsFlagsChangedFollowsTheNodeIdAndKeepsTheFlags) {
    verifies<req::CO_PDO_035, req::CO_PDO_061>();
    for (const std::uint32_t flags : {0x80000000U, 0xC0000000U, 0U, 0x40000000U}) {
        unit.move_to(3);
        set_cob_id(flags | (as_shipped & 0x7FFU));
        ASSERT_TRUE(unit.save());
        unit.move_to(9);
        EXPECT_EQ(cob_id(), flags | ((as_shipped & 0x7FFU) + 6U)) << flags;
    }
}

INSTANTIATE_TEST_SUITE_P(Each, CobIdOfTheDevice, testing::ValuesIn(devices_that_store_an_rpdo()),
                         [](const auto& one) { return one.param.substr(0, 3) + std::to_string(one.index); });

}  // namespace canproof::test
