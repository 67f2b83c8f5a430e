// SPDX-License-Identifier: Apache-2.0
// Tests that a device acknowledges a save only after the data are stored. The tests use every simulated device and one
// read from an EDS.
#include <gtest/gtest.h>

#include <memory>

#include "devices/catalogue.hpp"
#include "firmware/base/time.hpp"
#include "generated/canopen/requirements.hpp"
#include "host/datasheet/read_eds.hpp"
#include "host/datasheet/write_eds.hpp"
#include "host/selection/built_in.hpp"
#include "host/sim/bus/candump.hpp"
#include "host/sim/devices/generic_simulation.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::host::test {

namespace {

using canproof::test::verifies;
using Frames = std::vector<std::string>;

std::unique_ptr<SimulatedDevice> make(const std::string& name) {
    if (name != "generic") {
        return make_device(name);
    }
    const Register& all = built_in_register();
    return std::make_unique<GenericSimulation>(read_eds(write_eds(all, *all.part("ax188001")), "tcs.eds").part);
}

class Acknowledged : public testing::TestWithParam<const char*> {
  protected:
    Acknowledged() {
        device->set_node_id(node);
        device->memory().keep_by([this](const std::vector<std::uint8_t>&) {
            ++commits;
            answered_before = answered_before || !device->queue().empty();
            return is_sound;
        });
        device->power_on(Instant{});
        sent();
    }
    Frames sent() {
        Frames all;
        while (!device->queue().empty()) {
            all.push_back(format_frame(device->queue().pop()));
        }
        return all;
    }
    Frames send(const std::string& frame) {
        device->receive(parse_frame(frame, "test"), Instant{});
        return sent();
    }
    Frames save() { return send("603#2310100173617665"); }
    Frames restore() { return send("603#231110016C6F6164"); }
    Frames store_by_lss() {
        send("7E5#0401000000000000");
        send("7E5#1122000000000000");  // node-ID 22h
        return send("7E5#1700000000000000");
    }

    static constexpr int node = 3;
    bool is_sound{true};
    int commits{0};
    bool answered_before{false};
    std::unique_ptr<SimulatedDevice> device{make(GetParam())};
};

class AcknowledgedByLss : public Acknowledged {};

}  // namespace

TEST_P(Acknowledged, SaveAndRestoreAreCommittedBeforeTheAnswer) {
    verifies<req::CO_STORE_010>();
    EXPECT_EQ(save(), Frames{"583#6010100100000000"});
    EXPECT_EQ(commits, 1);
    EXPECT_EQ(restore(), Frames{"583#6011100100000000"});
    EXPECT_EQ(commits, 2);
    EXPECT_FALSE(answered_before);
}

TEST_P(Acknowledged, RefusedSaveAndRestoreLeaveTheMemoryUnchanged) {
    verifies<req::CO_STORE_014, req::CO_STORE_005, req::CO_STORE_013, req::CO_STORE_018>();
    EXPECT_EQ(save(), Frames{"583#6010100100000000"});
    const auto before = device->memory().bytes();
    is_sound = false;
    EXPECT_EQ(save(), Frames{"583#8010100100000606"});
    EXPECT_EQ(restore(), Frames{"583#8011100100000606"});
    EXPECT_EQ(device->memory().bytes(), before);
    is_sound = true;
    EXPECT_EQ(save(), Frames{"583#6010100100000000"});
    EXPECT_NE(device->memory().bytes(), before);
}

INSTANTIATE_TEST_SUITE_P(Devices, Acknowledged,
                         testing::Values("ax060805", "ax130751", "ax188001", "cbx-ao412", "generic"));

TEST_P(AcknowledgedByLss, LssStoreIsCommittedBeforeTheAnswer) {
    verifies<req::CO_LSS_020>();
    EXPECT_EQ(store_by_lss(), Frames{"7E4#1700000000000000"});
    EXPECT_EQ(commits, 1);
    EXPECT_FALSE(answered_before);
}

TEST_P(AcknowledgedByLss, LssStoreThatTheMemoryRefusesIsAnsweredWithError2) {
    verifies<req::CO_LSS_076, req::CO_LSS_088>();
    const auto before = device->memory().bytes();
    is_sound = false;
    EXPECT_EQ(store_by_lss(), Frames{"7E4#1702000000000000"});
    EXPECT_EQ(device->memory().bytes(), before);
    device->power_on(Instant{});
    EXPECT_EQ(device->node_id(), node);
}

TEST_P(AcknowledgedByLss, StoredNodeIdOf200IsIgnored) {
    verifies<req::CO_LSS_066>();
    const std::string name = GetParam();
    // the generic device starts with the given node-ID 3, the others with 127
    const bool is_generic = name == "generic";
    EXPECT_EQ(LssStore{device->memory()}.store({200, 20000}), LssError::none);
    device->power_on(Instant{});
    EXPECT_EQ(sent(), Frames{is_generic ? "703#00" : "77F#00"});  // 7Fh is 127, the node-ID as shipped
    EXPECT_EQ(device->bit_rate(), 125000U);
}

INSTANTIATE_TEST_SUITE_P(Devices, AcknowledgedByLss, testing::Values("ax060805", "ax130751", "ax188001", "generic"));

}  // namespace canproof::host::test
