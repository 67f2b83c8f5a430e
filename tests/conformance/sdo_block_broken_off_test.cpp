// SPDX-License-Identifier: Apache-2.0
// Tests SDO block transfers that are interrupted: by requests that do not fit the state of the transfer, by aborts, by
// time-outs of the client, or by resets.
#include "generated/canopen/requirements.hpp"
#include "tests/conformance/sdo_block_cases.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

TEST_F(SdoBlock, UploadRequestsOutOfTurnAreAborted) {
    verifies<req::CO_SDO_018, req::CO_SDO_056>();
    hold(nine);
    const std::string refused = "585#8000240001000405";
    const std::string initiate = "605#A40024007F000000";
    const Frames initiated{"585#C600240009000000"};
    const std::string start = "605#A300000000000000";
    const Frames segments{"585#0131323334353637", "585#8238390000000000"};
    const std::string acknowledge = "605#A2027F0000000000";
    const Frames ended{"585#D5C3310000000000"};
    talk(*this, {
                    {start, {stray}},
                    {acknowledge, {stray}},
                    {"605#A100000000000000", {stray}},
                    // the upload has not started yet
                    {initiate, initiated},
                    {acknowledge, {refused}},
                    {initiate, initiated},
                    {"605#A100000000000000", {refused}},
                    {initiate, initiated},
                    {"605#6000000000000000", {refused}},
                    {initiate, initiated},
                    {"605#0011223344556677", {refused}},
                    {initiate, initiated},
                    {"605#C100000000000000", {refused}},
                    // segments are being sent
                    {initiate, initiated},
                    {start, segments},
                    {start, {refused}},
                    {initiate, initiated},
                    {start, segments},
                    {"605#A100000000000000", {refused}},
                    {initiate, initiated},
                    {start, segments},
                    {"605#7000000000000000", {refused}},
                    // the end of the block has been sent
                    {initiate, initiated},
                    {start, segments},
                    {acknowledge, ended},
                    {acknowledge, {refused}},
                    {initiate, initiated},
                    {start, segments},
                    {acknowledge, ended},
                    {start, {refused}},
                });
}

TEST_F(SdoBlock, DownloadSegmentAfterABlockUploadInitiateWritesNothing) {
    verifies<req::CO_SDO_011, req::CO_SDO_056>();
    talk(*this, {
                    {"605#A40010007F000000", {"585#C600100004000000"}},  // 1000h (device type) is read-only
                    {"605#09FFFFFFFF000000", {"585#8000100001000405"}},
                    {"605#4000100000000000", {"585#4300100078563412"}},
                    // a download segment is also refused during a segmented upload (1008h, device name, 17 bytes)
                    {"605#4008100000000000", {"585#4108100011000000"}},
                    {"605#01FFFFFFFFFFFFFF", {"585#8008100001000405"}},
                    {"605#4008100000000000", {"585#4108100011000000"}},
                    {"605#6000000000000000", {"585#00436F6E666F726D"}},  // "Conform"
                });
}

TEST_F(SdoBlock, ClientAbortEndsAnUploadInEveryState) {
    verifies<req::CO_SDO_013>();
    hold(nine);
    const std::string initiate = "605#A40024007F000000";
    const Frames initiated{"585#C600240009000000"};
    const std::string start = "605#A300000000000000";
    const Frames segments{"585#0131323334353637", "585#8238390000000000"};
    const std::string abort = "605#8000240000000008";
    talk(*this, {
                    {initiate, initiated},
                    {abort, {}},
                    {start, {stray}},
                    {initiate, initiated},
                    {start, segments},
                    {abort, {}},
                    {"605#A2027F0000000000", {stray}},
                    {initiate, initiated},
                    {start, segments},
                    {"605#A2027F0000000000", {"585#D5C3310000000000"}},
                    {abort, {}},
                    {"605#A100000000000000", {stray}},
                });
}

TEST_F(SdoBlock, NewInitiateEndsAnUploadInEveryState) {
    verifies<req::CO_SDO_012>();
    hold(nine);
    const std::string initiate = "605#A40024007F000000";
    const Frames initiated{"585#C600240009000000"};
    const std::string start = "605#A300000000000000";
    const Frames segments{"585#0131323334353637", "585#8238390000000000"};
    talk(*this, {
                    {initiate, initiated},
                    {"605#4000100000000000", {"585#4300100078563412"}},
                    {start, {stray}},
                    {initiate, initiated},
                    {start, segments},
                    {"605#2F01220008000000", {"585#6001220000000000"}},
                    {"605#A2027F0000000000", {stray}},
                    {initiate, initiated},
                    {start, segments},
                    {"605#A2027F0000000000", {"585#D5C3310000000000"}},
                    {"605#C600240009000000", {"585#A40024007F000000"}},
                    {"605#8000240000000008", {}},
                    {initiate, initiated},
                    {"605#A40010007F000000", {"585#C600100004000000"}},
                    {start, {"585#8178563412000000"}},
                });
}

TEST_F(SdoBlock, StalledUploadIsAbortedInEveryState) {
    verifies<req::CO_SDO_014>();
    hold(nine);
    const Frames timed_out{"1:585#8000240000000405"};
    send("605#A40024007F000000");
    EXPECT_TRUE(pass(999).empty());
    EXPECT_EQ(pass(1), timed_out);
    send("605#A40024007F000000");
    pass(500);
    send("605#A300000000000000");
    EXPECT_TRUE(pass(999).empty());
    EXPECT_EQ(pass(1), timed_out);
    send("605#A40024007F000000");
    send("605#A300000000000000");
    pass(500);
    send("605#A2027F0000000000");
    EXPECT_TRUE(pass(999).empty());
    EXPECT_EQ(pass(1), timed_out);
    EXPECT_TRUE(pass(5000).empty());
}

TEST_F(SdoBlock, DownloadRequestsOutOfTurnAreAborted) {
    verifies<req::CO_SDO_018, req::CO_SDO_056>();
    const std::string refused = "585#8000240001000405";
    const std::vector<Exchange> received{
        {"605#C600240009000000", {"585#A40024007F000000"}},
        {"605#0131323334353637", {}},
        {"605#8238390000000000", {"585#A2027F0000000000"}},
    };
    talk(*this, {{"605#C100000000000000", {stray}}, {"605#0131323334353637", {stray}}});
    for (const std::string wrong : {"605#0338390000000000", "605#6000000000000000", "605#A300000000000000",
                                    "605#A2027F0000000000", "605#A100000000000000"}) {
        talk(*this, received);
        talk(*this, {{wrong, {refused}}, {"605#D5C3310000000000", {stray}}});
    }
    EXPECT_TRUE(held().empty());
}

TEST_F(SdoBlock, ClientAbortEndsADownloadInEveryState) {
    verifies<req::CO_SDO_013, req::CO_SDO_047>();
    hold({7});
    const std::string initiate = "605#C600240009000000";
    const Frames initiated{"585#A40024007F000000"};
    const std::string abort = "605#8000240000000008";
    talk(*this, {
                    {initiate, initiated},
                    {abort, {}},
                    {initiate, initiated},
                    {"605#0131323334353637", {}},
                    {abort, {}},
                    {initiate, initiated},
                    {"605#0131323334353637", {}},
                    {"605#8238390000000000", {"585#A2027F0000000000"}},
                    {abort, {}},
                    {"605#D5C3310000000000", {stray}},
                });
    EXPECT_EQ(held(), Bytes{7});
}

TEST_F(SdoBlock, StalledDownloadIsAborted) {
    verifies<req::CO_SDO_014, req::CO_SDO_047, req::CO_SDO_037>();
    hold({7});
    const Frames timed_out{"1:585#8000240000000405"};
    send("605#C600240009000000");
    EXPECT_TRUE(pass(999).empty());
    EXPECT_EQ(pass(1), timed_out);
    // the last segment is lost, which neither side can detect: the transfer times out
    send("605#C600240009000000");
    pass(900);
    send("605#0131323334353637");
    EXPECT_TRUE(pass(999).empty());  // a segment restarts the time-out
    EXPECT_EQ(pass(1), timed_out);
    send("605#C600240009000000");
    send("605#0131323334353637");
    send("605#8238390000000000");
    EXPECT_TRUE(pass(999).empty());
    EXPECT_EQ(pass(1), timed_out);
    EXPECT_EQ(held(), Bytes{7});
}

TEST_F(SdoBlock, EnteringStoppedOrAResetEndsABlockTransfer) {
    verifies<req::CO_SDO_045, req::CO_SDO_047>();
    hold({7});
    talk(*this, {
                    {"605#C600240009000000", {"585#A40024007F000000"}},
                    {"605#0131323334353637", {}},
                    {"000#0205", {}},
                    {"605#8238390000000000", {}},
                    {"000#8005", {}},
                    {"605#8238390000000000", {}},  // no transfer is open: 82h counts as an abort request (80h), which
                                                   // gets no answer
                    {"605#D5C3310000000000", {stray}},
                    {"605#C600240009000000", {"585#A40024007F000000"}},
                    {"605#0131323334353637", {}},
                    {"000#8205", {"705#00"}},
                    {"605#0238390000000000", {stray}},
                });
    EXPECT_EQ(held(), Bytes{7});
}

}  // namespace canproof::test
