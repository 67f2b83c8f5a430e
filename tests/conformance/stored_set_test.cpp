// SPDX-License-Identifier: Apache-2.0
// Tests damaged stored parameters in each device (CiA 301, 7.5.2.13; CAN-CBX-AO412, 7.9.4; AX130751, 3.2.7; AX188001,
// 3.2.7; AX060805, 4.2.7). Damage is distinguished from an interrupted save and never leads to an older set. The stored
// value is 1017h (producer heartbeat time), default 0.
#include "generated/ax060805/requirements.hpp"
#include "generated/canopen/requirements.hpp"
#include "tests/support/device_by_sdo.hpp"
#include "tests/support/every_device.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

constexpr std::uint32_t no_error = 0;

/// Runs a device of the catalogue as node 5.
class Stored : public DeviceBySdo {
  public:
    explicit Stored(const std::string& name)
        : DeviceBySdo{name, 5}, code_of_damage{name == "cbx-ao412" ? 0x6110U : 0x6300U} {}

    void save_value(std::uint32_t milliseconds) {
        ASSERT_TRUE(write(0x1017, 0, 2, milliseconds));
        ASSERT_TRUE(save());
    }
    std::uint32_t value() { return read(0x1017, 0) & 0xFFFFU; }
    /// Returns the code of the latest error in 1003h (error list), or no_error if 1001h (error register) is 0.
    std::uint32_t error() { return (read(0x1001, 0) & 0xFFU) == 0 ? no_error : read(0x1003, 1) & 0xFFFFU; }
    std::vector<std::uint8_t>& bytes() { return device->memory().bytes(); }
    /// Returns the size of one of the two banks, the first of which starts at 0. Both begin with "COP" once each has
    /// been written.
    std::size_t bank_size() {
        const std::string magic = "COP";
        return static_cast<std::size_t>(std::search(bytes().begin() + 1, bytes().end(), magic.begin(), magic.end()) -
                                        bytes().begin());
    }
    std::uint32_t code_of_damage;
};

class StoredSetOfTheDevice : public testing::TestWithParam<std::string> {};

/// Returns the offsets in a bank at which the tests damage it: all bytes of the header and of the CRC, some of the
/// values.
std::vector<std::size_t> places(std::size_t bank_size) {
    std::vector<std::size_t> all;
    for (std::size_t at = 0; at < bank_size; at += at < 16 || at + 12 > bank_size ? 1 : 11) {
        all.push_back(at);
    }
    return all;
}

}  // namespace

TEST_P(StoredSetOfTheDevice, FlippedByteInTheNewestSetIsReportedAndNoOlderSetIsUsed) {
    verifies<req::CO_STORE_006, req::INC_ERR_012, req::CO_STORE_016, req::INC_ERR_021>();
    for (const int saves : {2, 3}) {  // after two saves the newest set is in the second bank, after three in the first
        Stored unit{GetParam()};
        for (int n = 1; n <= saves; ++n) {
            unit.save_value(static_cast<std::uint32_t>(1000 * n));
        }
        const auto stored = unit.bytes();
        const std::size_t size = unit.bank_size();
        const std::size_t newest = saves == 2 ? size : 0;
        for (const std::size_t at : places(size)) {
            unit.bytes() = stored;
            unit.bytes()[newest + at] ^= 0xFF;
            unit.power_cycle();
            const bool is_marker = at == 3;  // damage to the marker alone leaves the set valid
            EXPECT_EQ(unit.value(), is_marker ? 1000U * static_cast<unsigned>(saves) : 0U) << at;
            EXPECT_EQ(unit.error(), is_marker ? no_error : unit.code_of_damage) << at;
            unit.bytes() = stored;
            unit.bytes()[size - newest + at] ^= 0xFF;  // damage to the older set has no effect
            unit.power_cycle();
            EXPECT_EQ(unit.value(), 1000U * static_cast<unsigned>(saves)) << at;
            EXPECT_EQ(unit.error(), no_error) << at;
        }
    }
}

TEST_P(StoredSetOfTheDevice, SetSavedAfterDamageIsLoaded) {
    verifies<req::CO_STORE_006, req::CO_STORE_001, req::CO_STORE_016>();
    for (const int saves : {1, 2, 3}) {
        Stored unit{GetParam()};
        for (int n = 1; n <= saves; ++n) {
            unit.save_value(1000);
        }
        unit.bytes()[(saves == 2 ? unit.bank_size() : 0) + 20] ^= 0x01;
        unit.power_cycle();
        EXPECT_EQ(unit.error(), unit.code_of_damage);
        unit.save_value(3000);
        EXPECT_EQ(unit.error(), unit.code_of_damage);  // the error lasts until the next reset
        unit.power_cycle();
        EXPECT_EQ(unit.value(), 3000U);
        EXPECT_EQ(unit.error(), no_error);
    }
}

TEST_P(StoredSetOfTheDevice, InterruptedSaveAfterDamageRestoresNoOlderSet) {
    verifies<req::CO_STORE_006, req::CO_STORE_004, req::CO_STORE_016>();
    Stored unit{GetParam()};
    unit.save_value(1000);
    unit.save_value(2000);
    const std::size_t size = unit.bank_size();
    unit.bytes()[size + 20] ^= 0x01;
    const auto damaged = unit.bytes();
    const std::size_t whole = size + 3;  // a save writes the bytes of a bank, two that invalidate a bank, and one that
                                         // commits
    for (std::size_t cut = 0; cut <= whole; cut += cut < 24 || cut + 20 > whole ? 1 : 17) {
        unit.bytes() = damaged;
        unit.power_cycle();
        ASSERT_TRUE(unit.write(0x1017, 0, 2, 3000));
        unit.device->memory().cut_power_after(cut);
        unit.save();
        unit.device->memory().restore_power();
        unit.power_cycle();
        EXPECT_EQ(unit.value(), cut == whole ? 3000U : 0U) << cut;
        EXPECT_EQ(unit.error(), cut == whole ? no_error : unit.code_of_damage) << cut;
    }
}

TEST_P(StoredSetOfTheDevice, InterruptedFirstSaveIsNotReportedAsDamage) {
    verifies<req::CO_STORE_004, req::CO_STORE_017>();
    Stored unit{GetParam()};
    const auto blank = unit.bytes();
    unit.save_value(1000);
    unit.save_value(1000);
    const std::size_t whole = unit.bank_size() + 3;
    for (std::size_t cut = 0; cut <= whole; cut += cut < 24 || cut + 20 > whole ? 1 : 17) {
        unit.bytes() = blank;
        unit.power_cycle();
        ASSERT_TRUE(unit.write(0x1017, 0, 2, 1000));
        unit.device->memory().cut_power_after(cut);
        unit.save();
        unit.device->memory().restore_power();
        unit.power_cycle();
        EXPECT_EQ(unit.value(), cut + 1 >= whole ? 1000U : 0U) << cut;
        EXPECT_EQ(unit.error(), no_error) << cut;
    }
}

INSTANTIATE_TEST_SUITE_P(Each, StoredSetOfTheDevice, testing::ValuesIn(every_device_with(0x1010)),
                         [](const auto& one) { return one.param.substr(0, 3) + std::to_string(one.index); });

// The Axiomatic devices store their node-ID by LSS. The CAN-CBX-AO412 has switches instead.
TEST(StoredNodeIdOfTheDevice, FlippedByteInTheLatestNodeIdIsReportedAndNoOlderNodeIdIsUsed) {
    verifies<req::CO_LSS_065, req::CO_LSS_087>();
    for (const char* name : {"ax060805", "ax130751", "ax188001"}) {
        DeviceBySdo unit{name, 5};
        unit.move_to(6);
        EXPECT_EQ(unit.device->node_id(), 6) << name;
        EXPECT_EQ(unit.read(0x1001, 0) & 0xFFU, 0U) << name;
        auto& bytes = unit.device->memory().bytes();
        const std::size_t first = bytes.size() - 40;  // two slots of 20 bytes; the one in use begins with "CLS1"
        const std::size_t latest = bytes[first + 3] == '1' ? first : first + 20;
        ASSERT_EQ(bytes[latest + 12], 6) << name;
        bytes[latest + 12] ^= 0x01;
        unit.power_cycle();
        EXPECT_EQ(unit.device->node_id(), 127) << name;  // the node-ID as shipped
        EXPECT_EQ(unit.read(0x1003, 1), 0x6300U) << name;
        EXPECT_EQ(unit.read(0x1001, 0) & 0xFFU, 1U) << name;
        unit.move_to(7);
        EXPECT_EQ(unit.device->node_id(), 7) << name;
        EXPECT_EQ(unit.read(0x1001, 0) & 0xFFU, 0U) << name;
    }
}

}  // namespace canproof::test
