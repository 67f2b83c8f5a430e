// SPDX-License-Identifier: Apache-2.0
// A device whose firmware runs in an image behind a bridge does what the manual says. Its stored parameters and its
// simulated physical world are in this program.
#include "host/sim/image/image_device.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "devices/ax188001/firmware/ax188001.hpp"
#include "devices/catalogue.hpp"
#include "devices/cbx-ao412/firmware/cbx_ao412.hpp"
#include "firmware/base/time.hpp"
#include "host/sim/bus/candump.hpp"
#include "tests/host/sim/image/bridged_image.hpp"

namespace canproof::host::test {

namespace {

using Frames = std::vector<std::string>;

void be_ao412(target::Channel& channel) {
    target::serve<cbx_ao412::Device, cbx_ao412::Inputs, cbx_ao412::Outputs, cbx_ao412::FactoryData>(channel,
                                                                                                    "cbx-ao412");
}

/// Runs a CAN-CBX-AO412 with the greeting of an image that has its own clock.
void be_ao412_by_its_own_clock(target::Channel& channel) {
    using Image = target::Bridge<cbx_ao412::Device, cbx_ao412::Inputs, cbx_ao412::Outputs, cbx_ao412::FactoryData>;
    const std::size_t memory_size =
        target::greet<cbx_ao412::Inputs, cbx_ao412::Outputs>(channel, "cbx-ao412", bridge::protocol_of_own_clock);
    Image image{channel, memory_size};
    image.serve();
}

void be_ax188001(target::Channel& channel) {
    target::serve<ax188001::Device, ax188001::Inputs, ax188001::Outputs, ax188001::FactoryData>(channel, "ax188001");
}

/// A firmware image and the device that it runs. The device is destroyed first.
class Bridged {
  public:
    explicit Bridged(const std::function<void(target::Channel&)>& life, const FactoryValues& twins_factory = {})
        : image_{life} {
        auto link = image_.take_link();
        const ImageGreeting greeting = link->greeting();
        device_ = std::make_unique<ImageDevice>(std::move(link), greeting, make_device(greeting.device, twins_factory));
    }

    ImageDevice& device() { return *device_; }
    Frames power_on(int node) {
        device_->set_node_id(node);
        device_->power_on(now_);
        return sent();
    }
    Frames send(const std::string& frame) {
        device_->receive(parse_frame(frame, "test"), now_);
        return sent();
    }
    Frames pass(Duration time) {
        const Instant end = now_ + time;
        Frames all;
        while (device_->next_deadline() <= end) {
            now_ = device_->next_deadline();
            device_->advance(now_);
            const Frames more = sent();
            all.insert(all.end(), more.begin(), more.end());
        }
        now_ = end;
        return all;
    }
    Frames sent() {
        Frames all;
        while (!device_->queue().empty()) {
            all.push_back(format_frame(device_->queue().pop()));
        }
        return all;
    }
    double output(const std::string& name) {
        const auto& names = device_->output_names();
        const auto at = std::find(names.begin(), names.end(), name) - names.begin();
        return device_->outputs().at(static_cast<std::size_t>(at));
    }

  private:
    BridgedImage image_;
    std::unique_ptr<ImageDevice> device_;
    Instant now_{};
};

}  // namespace

// CBX-AO412 7.2, 7.9.2 and 7.10.2.3: boot-up, device type, output 1 at 5.0 V.
TEST(ImageDevice, FirmwareImageAnswersTheTelegramsOfItsManual) {
    Bridged ao412{be_ao412};
    EXPECT_EQ(ao412.power_on(3), Frames{"703#00"});
    EXPECT_EQ(ao412.send("603#4000100000000000"), Frames{"583#4300100091010800"});
    EXPECT_EQ(ao412.send("603#2B116401B33E0000"), Frames{"583#6011640100000000"});
    EXPECT_NEAR(ao412.output("aout1"), 5.0, 0.02);
    EXPECT_EQ(ao412.device().node_id(), 3);
    EXPECT_EQ(ao412.device().state(), NmtState::pre_operational);
}

// With a producer heartbeat time (1017h) of 10 ms, 35 ms have heartbeats at 10, 20 and 30 ms.
TEST(ImageDevice, FirmwareImageUsesTheTimePassedWithEachCall) {
    Bridged ao412{be_ao412};
    ao412.power_on(3);
    EXPECT_EQ(ao412.send("603#2B1710000A000000"), Frames{"583#6017100000000000"});
    EXPECT_EQ(ao412.pass(milliseconds(35)), (Frames{"703#7F", "703#7F", "703#7F"}));
}

TEST(ImageDevice, FirmwareImageStoresItsParametersInTheMemoryOfTheHost) {
    Bridged ao412{be_ao412};
    ao412.power_on(3);
    ao412.send("603#2B17100034120000");
    const std::vector<std::uint8_t> before = ao412.device().memory().bytes();
    EXPECT_EQ(ao412.send("603#2310100173617665"), Frames{"583#6010100100000000"});  // "save"
    EXPECT_NE(ao412.device().memory().bytes(), before);
    ao412.power_on(3);
    EXPECT_EQ(ao412.send("603#4017100000000000"), Frames{"583#4B17100034120000"});
}

// CiA 301, 7.5.2.13: a save that fails is answered by 06060000h.
TEST(ImageDevice, FailedMemoryIsReportedByTheFirmwareImage) {
    Bridged ao412{be_ao412};
    ao412.device().memory().keep_by([](const std::vector<std::uint8_t>&) { return false; });
    ao412.power_on(3);
    EXPECT_EQ(ao412.send("603#2310100173617665"), Frames{"583#8010100100000606"});
}

// The boot-up message is sent before the answer, although the answer has the lower identifier.
TEST(ImageDevice, FramesAreSentInTheOrderOfTheFirmwareImage) {
    Bridged ao412{be_ao412};
    ao412.device().set_node_id(3);
    ao412.device().power_on(Instant{});
    ao412.device().receive(parse_frame("603#4000100000000000", "test"), Instant{});
    EXPECT_EQ(ao412.sent(), (Frames{"703#00", "583#4300100091010800"}));
}

// The thermocouple has the type in 6110h (AX188001 3.3.2), J as shipped. By the tables of ITS-90 its voltage at 100
// degC, with the terminals at 25 degC, is 5.269 mV - 1.277 mV for J and 4.096 mV - 1.000 mV for K. Both are read as 100
// degC: 7130h:1 has 16 counts per degree (3.3.4) and an offset of 4368 (3.3.5).
TEST(ImageDevice, SimulatedPlantFollowsTheObjectsOfTheFirmwareImage) {
    Bridged tcs{be_ax188001};
    EXPECT_EQ(tcs.power_on(5), Frames{"705#00"});
    EXPECT_EQ(tcs.device().node_id(), 5);
    EXPECT_TRUE(tcs.device().set_input("tc1_celsius", 100.0, Instant{}));
    EXPECT_NEAR(tcs.device().inputs().at(0), 3992.0, 1.5);
    EXPECT_EQ(tcs.send("605#2B10610102000000"), Frames{"585#6010610100000000"});
    EXPECT_NEAR(tcs.device().inputs().at(0), 3096.0, 1.5);
    tcs.pass(milliseconds(2000));
    const Frames answer = tcs.send("605#4030710100000000");
    ASSERT_EQ(answer.size(), 1U);
    const Frame frame = parse_frame(answer[0], "test");
    EXPECT_NEAR(frame.data[4] + 256 * frame.data[5], 16 * 100 + 4368, 2);
    EXPECT_FALSE(tcs.device().set_input("no_such_input", 1.0, Instant{}));
}

TEST(ImageDevice, FirmwareImageThatDiffersFromTheHostFirmwareIsRefused) {
    FactoryValues other;
    other.set_number("serial_number", 7.0);
    Bridged ao412{be_ao412, other};
    ao412.power_on(3);
    EXPECT_THROW(ao412.send("603#4018100400000000"), ImageFailed);  // 1018h:4 has the serial number
}

// 1018h:4 (identity object) has the serial number: that of the image differs from that of the host's firmware.
TEST(ImageDevice, FirmwareImageWithItsOwnClockIsNotComparedWithHostFirmware) {
    FactoryValues other;
    other.set_number("serial_number", 7.0);
    Bridged ao412{be_ao412_by_its_own_clock, other};
    EXPECT_EQ(ao412.power_on(3), Frames{"703#00"});
    const Frames answer = ao412.send("603#4018100400000000");
    ASSERT_EQ(answer.size(), 1U);
    EXPECT_EQ(answer[0].substr(0, 12), "583#43181004");
    EXPECT_NE(answer[0].substr(12), "07000000");
    EXPECT_EQ(ao412.device().node_id(), 3);
}

TEST(ImageDevice, FirmwareImageWithAnotherNumberOfOutputsIsRefused) {
    BridgedImage image{be_ao412};
    auto link = image.take_link();
    ImageGreeting greeting = link->greeting();
    EXPECT_EQ(greeting.device, "cbx-ao412");
    ++greeting.outputs;
    EXPECT_THROW(ImageDevice(std::move(link), greeting, make_device("cbx-ao412")), ImageFailed);
}

}  // namespace canproof::host::test
