// SPDX-License-Identifier: Apache-2.0
// Tests segments of an SDO download that carry no data (CiA 301, 7.2.4.3.4). The slave is node 5.
#include "generated/canopen/requirements.hpp"
#include "tests/support/exchange.hpp"
#include "tests/support/slave_bench.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

class SdoSegments : public testing::Test, public SlaveBench {};

}  // namespace

TEST_F(SdoSegments, LastDownloadSegmentMayHaveNoData) {
    verifies<req::CO_SDO_043, req::CO_SDO_004>();
    // the first segment has the two bytes of 2200h, 50, and five unused bytes: 0 | 5 << 1
    talk(*this, {
                    {"605#2100220002000000", {"585#6000220000000000"}},
                    {"605#0A32000000000000", {"585#2000000000000000"}},
                });
    EXPECT_EQ(device->objects().read(0x2200, 0), 7U) << "the default, because the last segment has not come";
    // the last segment has the toggle bit, seven unused bytes, and its mark: 10h | 7 << 1 | 1
    talk(*this, {
                    {"605#1FFFFFFFFFFFFFFF", {"585#3000000000000000"}},
                    {"605#4000220000000000", {"585#4B00220032000000"}},
                });
}

}  // namespace canproof::test
