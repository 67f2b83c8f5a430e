// SPDX-License-Identifier: Apache-2.0
// Tests the default answers of Application and LssApplication, with a device that implements only the functions without
// a default. Also tests a node and a dictionary by direct calls of their functions.
#include <gtest/gtest.h>

#include <algorithm>
#include <optional>

#include "generated/canopen/requirements.hpp"
#include "tests/support/altered_slave.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

/// A device that provides memory for a DOMAIN but does not process it, and stores nothing.
class PlainApplication final : public Application {
  public:
    AbortCode check_access(const EntryRef& entry) override {
        return access.has_value() ? *access : Application::check_access(entry);
    }
    AbortCode before_write(const EntryRef& entry, ByteView value) override {
        return last_word.has_value() ? *last_word : Application::before_write(entry, value);
    }
    void after_write(const EntryRef& entry, Instant) override { written.push_back(entry.index); }
    void put_factory_values(ParameterGroup) override {}
    void restart(Instant) override {}
    void booted(Instant) override {}
    MutableBytes staging(const EntryRef&) override { return MutableBytes{memory_}; }

    /// The answers of the application to the node. While a member is empty, the application gives the default answer.
    std::optional<AbortCode> access{};
    std::optional<AbortCode> last_word{};
    /// The indices of the objects whose writes the node has reported to the application.
    std::vector<std::uint16_t> written{};

  private:
    std::array<std::uint8_t, 4> memory_{};
};

/// Node 5 with the dictionary and services of the conformance slave, but with a PlainApplication.
class PlainNode {
  public:
    PlainNode(NonVolatileMemory& memory, TransmitQueue& queue)
        : image_(description_.rows.layout.image.size()),
          objects_{tables_, MutableBytes{image_.data(), image_.size()}, LimitAbort::high_low},
          node_{objects_, memory, queue, application_, errors_, description_.profile, pdos_.memory()} {}

    void power_on(std::uint8_t node_id, Instant now) { node_.power_on({node_id, 125000}, 0, false, now); }
    void receive(const Frame& frame, Instant now) { node_.receive(frame, now); }
    void advance(Instant now) { node_.advance(now); }
    Instant next_deadline() const { return node_.next_deadline(); }
    const Node& node() const { return node_; }

    PlainApplication& application() { return application_; }
    /// Makes `service` the service to which the entry of object `index` belongs.
    void give(std::uint16_t index, Service service) {
        const auto is_wanted = [index](const ObjectRow& row) { return row.index == index; };
        const auto& objects = description_.rows.objects;
        const auto wanted = std::find_if(objects.begin(), objects.end(), is_wanted);
        description_.rows.entries.at(wanted->first_entry).service = service;
    }

  private:
    host::GenericDescription description_{slave()};
    DictionaryTables tables_{description_.rows.tables()};
    std::vector<std::uint8_t> image_;
    ObjectDictionary objects_;
    PlainApplication application_;
    ErrorTable errors_{host::standard_errors()};
    SizedPdoMemory<4, 4, 8> pdos_{};
    Node node_;
};

class Plain : public testing::Test, public FrameBench<PlainNode> {
  protected:
    Plain() : FrameBench{4096} {
        device = std::make_unique<PlainNode>(memory, queue);
        device->power_on(5, now);
        sent();
    }
};

class DirectCall : public testing::Test, public AlteredSlaveBench {
  protected:
    DirectCall() { power_on(); }
};

}  // namespace

TEST_F(Plain, TransferOfADomainThatTheApplicationDoesNotServeIsRefused) {
    verifies<req::CO_SDO_046>();
    EXPECT_EQ(send("605#2300240001020304"), Frames{"585#8000240000000106"});
    EXPECT_EQ(send("605#4000240000000000"), Frames{"585#8000240000000106"});
}

TEST_F(Plain, ApplicationCanRefuseAccessOnlyToProgramDownloadEntries) {
    verifies<req::CO_SDO_016, req::CO_SDO_011>();
    device->application().access = AbortCode::device_state;
    EXPECT_EQ(send("605#2307220001020304"), Frames{"585#6007220000000000"});
    EXPECT_EQ(send("605#4007220000000000"), Frames{"585#4307220001020304"});
    device->give(0x2207, Service::device);
    EXPECT_EQ(send("605#2307220004030201"), Frames{"585#6007220000000000"});
    EXPECT_EQ(send("605#2307220001020304"), Frames{"585#6007220000000000"});
    device->give(0x2207, Service::program);
    EXPECT_EQ(send("605#2307220005060708"), Frames{"585#8007220022000008"});
    EXPECT_EQ(send("605#4007220000000000"), Frames{"585#8007220022000008"});
    device->application().access.reset();
    EXPECT_EQ(send("605#4007220000000000"), Frames{"585#4307220001020304"});
}

TEST_F(Plain, DeviceIsNotifiedOfWritesToItsOwnEntriesOnly) {
    verifies<req::CO_SDO_016>();
    device->give(0x2207, Service::device);
    // The requests write entries of the node's CANopen services (1005h, 1014h, 100Ch, 1016h:1, 1017h, 1400h:2), then
    // 2207h, an entry of the device.
    for (const char* request :
         {"605#2305100080000000", "605#2314100085000000", "605#2B0C100001000000", "605#2316100100000000",
          "605#2B17100000000000", "605#2F00140201000000", "605#2307220001020304"}) {
        const Frames answer = send(request);
        ASSERT_EQ(answer.size(), 1U) << request;
        EXPECT_EQ(answer.at(0).substr(0, 6), "585#60") << request << ": " << answer.at(0);
    }
    EXPECT_EQ(device->application().written, (std::vector<std::uint16_t>{0x2207}));
}

TEST_F(Plain, ApplicationCanRefuseAWriteToAProgramDownloadEntry) {
    verifies<req::CO_SDO_016, req::CO_SDO_011>();
    device->application().last_word = AbortCode::device_state;
    EXPECT_EQ(send("605#2307220001020304"), Frames{"585#6007220000000000"});
    device->give(0x2207, Service::program);
    EXPECT_EQ(send("605#2307220005060708"), Frames{"585#8007220022000008"});
    EXPECT_EQ(send("605#4007220000000000"), Frames{"585#4307220001020304"});
    device->application().last_word.reset();
    EXPECT_EQ(send("605#2307220005060708"), Frames{"585#6007220000000000"});
    EXPECT_EQ(send("605#4007220000000000"), Frames{"585#4307220005060708"});
}

TEST_F(Plain, LssStoreConfigurationIsRefusedWithoutAMemory) {
    verifies<req::CO_LSS_075>();
    send("7E5#0401000000000000");
    EXPECT_EQ(send("7E5#1700000000000000"), Frames{"7E4#1701000000000000"});
}

TEST_F(Plain, LssSwitchDelaysEndWithoutABitRateDriver) {
    verifies<req::CO_LSS_014, req::CO_LSS_015>();
    send("7E5#0401000000000000");
    EXPECT_EQ(send("7E5#1300030000000000"), Frames{"7E4#1300000000000000"});  // 250 kbit/s
    // the node sends nothing for 10 ms before the switch and for 10 ms after it
    EXPECT_TRUE(send("7E5#150A000000000000").empty());
    EXPECT_TRUE(send("605#4000100000000000").empty());
    EXPECT_TRUE(pass(20).empty());
    EXPECT_EQ(send("605#4000100000000000"), Frames{"585#4300100078563412"});
}

TEST_F(DirectCall, FunctionsPutAndPutBitsDoNotOverwriteAConstantEntry) {
    verifies<req::CO_SDO_009>();
    ObjectDictionary& objects = device->objects();
    const EntryRef name = objects.lookup(0x1008, 0);  // 1008h device name: "Conformance slave", in flash
    ASSERT_TRUE(name.exists());
    const std::array<std::uint8_t, 17> other{{'x'}};
    EXPECT_FALSE(objects.put(name, ByteView{other}));
    EXPECT_FALSE(objects.put_bits(*name.row, 1));
    EXPECT_EQ(objects.value(name)[0], 'C');
    EXPECT_EQ(objects.value(name).size(), 17U);
}

TEST_F(DirectCall, SelfStartIsSuppressedDuringBusOffUnlessErrorBehaviour1029hKeepsTheState) {
    verifies<req::CO_NMT_011, req::CO_NMT_002>();
    Node& node = device->node();
    const auto state_after_start = [this, &node] {
        node.start_at(now + milliseconds(100));
        pass(200);
        return node.state();
    };
    EXPECT_EQ(state_after_start(), NmtState::operational);
    send("000#8005");
    node.set_can_state(CanState::bus_off, now);
    EXPECT_EQ(state_after_start(), NmtState::pre_operational);
    node.set_can_state(CanState::error_active, now);
    // takes the emergency messages after bus-off out of the queue
    sent();
    EXPECT_EQ(send("605#2F29100101000000"), Frames{"585#6029100100000000"});  // 1029h:1 = 1: no change of state
    node.set_can_state(CanState::bus_off, now);
    EXPECT_EQ(state_after_start(), NmtState::operational);
}

TEST_F(DirectCall, PlannedSelfStartIsDroppedIfErrorBehaviour1029hNowForbidsIt) {
    verifies<req::CO_NMT_011>();
    Node& node = device->node();
    send("000#8005");
    EXPECT_EQ(send("605#2F29100101000000"), Frames{"585#6029100100000000"});  // 1029h:1 = 1: no change of state
    // heartbeat consumer 1016h:1: node 31h, 100 ms
    EXPECT_EQ(send("605#2316100164003100"), Frames{"585#6016100100000000"});
    send("731#05");
    node.start_at(now + milliseconds(500));
    pass(200);  // the heartbeat is missed after 100 ms
    EXPECT_EQ(node.state(), NmtState::pre_operational);
    EXPECT_EQ(send("605#2F29100102000000"), Frames{"585#6029100100000000"});  // 1029h:1 = 2: stopped
    pass(400);
    EXPECT_EQ(node.state(), NmtState::pre_operational);
}

}  // namespace canproof::test
