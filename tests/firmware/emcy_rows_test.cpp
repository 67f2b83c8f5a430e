// SPDX-License-Identifier: Apache-2.0
// Tests errors whose row of the error table says that they are not listed in 1003h or not sent
// (firmware/canopen/emcy.hpp).
#include <gtest/gtest.h>

#include "firmware/canopen/emcy.hpp"
#include "generated/canopen/requirements.hpp"
#include "tests/support/altered_slave.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

constexpr ErrorId quiet = ErrorId::can_overrun;        // the error only sets its bits in 1001h
constexpr ErrorId unlisted = ErrorId::error_passive;   // the error sets its bits in 1001h and is sent
constexpr ErrorId unsent = ErrorId::sync_length;       // the error sets its bits in 1001h and is listed in 1003h
constexpr ErrorId usual = ErrorId::internal_software;  // the error sets its bits in 1001h, is listed and sent

/// An EMCY service that uses the dictionary of the conformance slave. The slave's own EMCY service reports nothing.
class EmcyRows : public testing::Test, public AlteredSlaveBench {
  protected:
    void SetUp() override {
        const auto row = [this](ErrorId error, std::uint16_t code, std::uint8_t bits, bool sent, bool listed) {
            errors_[static_cast<std::size_t>(error)] = ErrorRow{code, bits, sent, listed, 0};
        };
        row(quiet, 0x8110, 0x01, false, false);
        row(unlisted, 0x8120, 0x02, true, false);
        row(unsent, 0x8240, 0x04, false, true);
        row(usual, 0x6100, 0x08, true, true);
        power_on();
        keep(ErrorList::active);
    }
    /// Starts the EMCY service. `list` says whether 1003h lists active errors or all errors.
    void keep(ErrorList list) {
        emcy_ = std::make_unique<Emcy>(device->objects(), queue, errors_, list, EmcyContent::detail);
        emcy_->set_node_id(5);
        emcy_->reset();
        emcy_->enable(true, now);
    }
    std::uint32_t error_register() { return device->objects().read(0x1001, 0); }
    std::uint32_t listed(std::uint8_t subindex) { return device->objects().read(0x1003, subindex); }
    Emcy& emcy() { return *emcy_; }

  private:
    ErrorTable errors_{};
    std::unique_ptr<Emcy> emcy_;
};

}  // namespace

TEST_F(EmcyRows, ErrorIsReportedAsItsTableRowRequires) {
    verifies<req::CO_EMCY_001, req::CO_EMCY_007>();
    emcy().set(quiet, true, now);
    EXPECT_EQ(error_register(), 0x01U);
    EXPECT_EQ(listed(0), 0U);
    EXPECT_TRUE(sent().empty());
    emcy().set(unlisted, true, now);
    EXPECT_EQ(error_register(), 0x03U);
    EXPECT_EQ(listed(0), 0U);
    EXPECT_EQ(sent(), Frames{"085#2081030000000000"});
    emcy().set(unsent, true, now);
    EXPECT_EQ(error_register(), 0x07U);
    EXPECT_EQ(listed(1), 0x8240U);
    EXPECT_TRUE(sent().empty());
    emcy().set(usual, true, now);
    EXPECT_EQ(error_register(), 0x0FU);
    EXPECT_EQ(listed(1), 0x6100U);
    EXPECT_EQ(listed(2), 0x8240U);
    EXPECT_EQ(sent(), Frames{"085#00610F0000000000"});
}

TEST_F(EmcyRows, ResetCommunicationKeepsAListOfActiveErrorsAndEmptiesAnErrorHistory) {
    verifies<req::CO_EMCY_011, req::CO_EMCY_024, req::CO_NMT_006>();
    emcy().set(unlisted, true, now);
    emcy().set(unsent, true, now);
    device->objects().load_defaults(ParameterGroup::communication, 5);
    emcy().refresh();
    EXPECT_EQ(listed(0), 1U);
    EXPECT_EQ(listed(1), 0x8240U);
    EXPECT_EQ(error_register(), 0x06U);
    keep(ErrorList::history);
    emcy().set(usual, true, now);
    EXPECT_EQ(listed(0), 1U);
    device->objects().load_defaults(ParameterGroup::communication, 5);
    emcy().refresh();
    EXPECT_EQ(listed(0), 0U);
    EXPECT_EQ(listed(1), 0U);
    EXPECT_EQ(error_register(), 0x08U);
}

TEST_F(EmcyRows, MomentaryErrorIsReportedAsItsTableRowRequires) {
    verifies<req::CO_EMCY_001>();
    emcy().report(quiet, now);
    EXPECT_TRUE(sent().empty());
    EXPECT_EQ(listed(0), 0U);
    emcy().report(unsent, now);
    EXPECT_TRUE(sent().empty());
    EXPECT_EQ(listed(1), 0x8240U);
    emcy().report(unlisted, now);
    EXPECT_EQ(sent(), Frames{"085#2081000000000000"});  // no error is active: 1001h reads 0
    EXPECT_EQ(listed(0), 1U);
    EXPECT_EQ(error_register(), 0U);
}

}  // namespace canproof::test
