// SPDX-License-Identifier: Apache-2.0
// Checks that devices send the same frames in three runs: two runs on the in-process bus, and one run on the SocketCAN
// bus, whose CAN interface is simulated in this process.
#include <gtest/gtest.h>
// RapidCheck needs the GoogleTest header first
#include <rapidcheck/gtest.h>

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "host/selection/chosen_devices.hpp"
#include "host/sim/bus/arbitrated_bus.hpp"
#include "host/sim/bus/socketcan_bus.hpp"
#include "host/sim/run/run_session.hpp"
#include "tests/host/sim/bus/virtual_can.hpp"

namespace canproof::host {

namespace {

/// Records the frames that each device sends, in their order, under the name of the device. Frames that no device sent
/// are under an empty name.
class Record final : public SessionObserver {
  public:
    void on_frame(const BusFrame& frame) override {
        said[frame.sender == nullptr ? "" : frame.sender->name()].push_back(format_frame(frame.frame));
    }
    void on_step(Instant) override {}

    std::map<std::string, std::vector<std::string>> said;
};

/// Returns requests to two devices. Each request comes long after the answers to the previous one. The only timer that
/// ends is the time-out of a heartbeat that node 6 monitors; it ends between two requests.
std::vector<std::string> any_requests() {
    static const std::vector<std::string> requests{"000#0100",
                                                   "000#8005",
                                                   "000#0106",
                                                   "000#8206",
                                                   "000#8100",
                                                   "080#",
                                                   "605#4000100000000000",
                                                   "606#4000100000000000",
                                                   "606#4018100400000000",
                                                   "605#4008100000000000",
                                                   "605#6000000000000000",
                                                   "605#2F00180201000000",
                                                   "606#2F00180201000000",
                                                   "606#23001401060200A0",
                                                   "606#2300140106020020",
                                                   "605#23001401050200A0",
                                                   "605#2300140105020000",
                                                   "605#2300140105020020",
                                                   "00000205#FF7F",
                                                   "205#FF7F",
                                                   "00000206#FF7FFF7F",
                                                   "206#FF7FFF7F",
                                                   "705#R",
                                                   "706#R",
                                                   "00000705#R",
                                                   "00000605#4000100000000000",
                                                   "185#R",
                                                   "606#231610015A000500",
                                                   "605#2B1164010FFF0000",
                                                   "7E5#0401000000000000",
                                                   "7E5#5E00000000000000",
                                                   "7E5#0400000000000000"};
    std::vector<std::string> chosen(*rc::gen::inRange<std::size_t>(1, 25));
    for (std::string& one : chosen) {
        one = *rc::gen::elementOf(requests);
    }
    return chosen;
}

std::map<std::string, std::vector<std::string>> dialogue(std::unique_ptr<Bus> bus, test::VirtualCan* system,
                                                         const std::vector<std::string>& requests) {
    std::vector<std::unique_ptr<DeviceNode>> nodes;
    nodes.push_back(std::make_unique<DeviceNode>("five", choose_device("cbx-ao412@5").device));
    nodes.push_back(std::make_unique<DeviceNode>("six", choose_device("ax188001@6").device));
    Record record;
    SessionOutputs outputs;
    outputs.observer = &record;
    RunSession session{std::move(bus), std::move(nodes), {}, outputs};
    session.power_on();
    std::uint64_t us = 0;
    const auto settle = [&] {
        for (int turn = 0; turn < 20; ++turn) {
            us += 1000;
            if (system != nullptr) {
                system->realtime_us += 1000;
            }
            session.advance_to(Instant{us});
        }
    };
    settle();
    for (const std::string& request : requests) {
        RC_ASSERT(session.put(parse_frame(request, "law")));
        settle();
    }
    return record.said;
}

}  // namespace

RC_GTEST_PROP(AlikeBusesLaw, DevicesSendTheSameFramesOnTheInprocBusAndTheSocketCanBus, ()) {
    const std::vector<std::string> requests = any_requests();
    const auto inproc = [&] {
        return dialogue(std::make_unique<ArbitratedBus>("inproc", 1000000, BusFaultRates{}), nullptr, requests);
    };
    const auto first = inproc();
    RC_ASSERT(inproc() == first);
    test::VirtualCan system;
    const auto socketcan =
        dialogue(std::make_unique<SocketCanBus>("vcan0", system, InterfaceControl::none, Instant{}), &system, requests);
    RC_ASSERT(socketcan == first);
}

}  // namespace canproof::host
