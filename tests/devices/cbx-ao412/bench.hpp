// SPDX-License-Identifier: Apache-2.0
// The test fixtures of the CAN-CBX-AO412.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "devices/cbx-ao412/firmware/cbx_ao412.hpp"
#include "tests/support/frame_bench.hpp"

namespace canproof::test {

/// A CAN-CBX-AO412 as node 3. send() returns the frames that it sends, as text.
class CbxBench : public UnitBench<cbx_ao412::Device, cbx_ao412::Inputs, cbx_ao412::FactoryData> {
  public:
    explicit CbxBench(std::size_t memory_size = 1024) : UnitBench{memory_size} {}

    float volts(int output) const { return device->outputs().aout[static_cast<std::size_t>(output - 1)]; }

    /// Sends an SDO request that writes, and expects that it is confirmed.
    void write(const std::string& request) {
        const Frames answer = send(request);
        ASSERT_EQ(answer.size(), 1U) << request;
        EXPECT_EQ(answer[0].substr(0, 6), "583#60") << request << " was answered " << answer[0];
    }
};

/// A test fixture whose device has booted.
class CbxTest : public testing::Test, public CbxBench {
  protected:
    void SetUp() override { power_on(); }
};

}  // namespace canproof::test
