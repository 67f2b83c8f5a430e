// SPDX-License-Identifier: Apache-2.0
// Faults of the SYNC producer.
#include "tests/conformance/zoo/distortions.hpp"
#include "tests/conformance/zoo/faults.hpp"

namespace canproof::test::zoo {

namespace {

bool is_sync(WrongSlave& slave, const Frame& frame) {
    return is_data(frame, slave.dictionary().read(0x1005, 0) & 0x7FFU);
}

bool is_too_early(WrongSlave& slave, const Frame& frame) {
    return is_sync(slave, frame) && slave.state() == NmtState::pre_operational;
}

void count_from_0(WrongSlave& slave, const Frame& frame) {
    const bool counts = is_sync(slave, frame) && frame.length == 1;
    slave.say(counts ? with_byte(frame, 0, frame.data[0] - 1U) : frame);
}

/// Makes the slave continue the SYNC counter when it leaves the NMT state `stopped`. A correct slave restarts the
/// counter. With this fault, only an SDO write restarts it.
Distortion counts_on() {
    const auto hear = [](WrongSlave& slave, const Frame& frame) {
        if (is_sdo_request(slave, frame) && specifier_of(frame) == 1) {
            slave.notes[0] = 0;
        }
        slave.pass(frame);
    };
    const auto say = [](WrongSlave& slave, const Frame& frame) {
        const std::uint32_t overflow = slave.dictionary().read(0x1019, 0);
        if (is_sync(slave, frame) && overflow != 0) {
            slave.notes[0] = slave.notes[0] % overflow + 1;
            slave.say(with_byte(frame, 0, slave.notes[0]));
        } else {
            slave.say(frame);
        }
    };
    return hears_and_says(hear, say);
}

/// Makes the slave ignore writes that clear bit 30 of 1005h (COB-ID SYNC), so that it never ends the production of
/// SYNC.
Frame without_end(WrongSlave& slave, const Frame& frame) {
    const bool stops =
        is_expedited_download(frame) && index_of(frame) == 0x1005 && (value_of(frame) & 0x40000000U) == 0;
    const bool produces = (slave.dictionary().read(0x1005, 0) & 0x40000000U) != 0;
    return stops && produces ? with_value(frame, value_of(frame) | 0x40000000U) : frame;
}

/// Makes the slave produce SYNC for ten more cycles after the NMT command stop.
void go_on_when_stopped(WrongSlave& slave, const Frame& frame) {
    const bool stops = is_data(frame, 0) && frame.length == 2 && frame.data[0] == 2 && frame.data[1] == slave.node_id();
    const std::uint32_t period = slave.dictionary().read(0x1006, 0);
    const std::uint32_t identifier = slave.dictionary().read(0x1005, 0);
    for (std::uint64_t cycle = 1; stops && (identifier & 0x40000000U) != 0 && period != 0 && cycle <= 10; ++cycle) {
        slave.say_at(slave.now() + microseconds(cycle * period), data_frame(identifier & 0x7FFU, 0));
    }
    slave.pass(frame);
}

}  // namespace

Faults sync_faults() {
    const std::string period = "605#23061000A0860100 ";   // 1006h communication cycle period: 100 ms
    const std::string produce = "605#2305100080000040 ";  // 1005h COB-ID SYNC: producer
    const std::string counter = "605#2F19100002000000 ";  // 1019h synchronous counter overflow value: 2
    const std::string counting = counter + period + produce;
    return {
        {"sync-late", "sync", "produces SYNC 5 % late", period + produce + "+110", "100:080#", "105:080#",
         works_with(object(0x1006), percent(105))},
        {"sync-missing", "sync", "produces no SYNC", period + produce + "+100", "100:080#", "",
         works_with(object(0x1006), always(0))},
        {"sync-pre-operational", "sync", "produces no SYNC in Pre-operational", period + produce + "+100", "100:080#",
         "", keeps_back(is_too_early)},
        {"sync-stopped", "sync", "goes on with SYNC in Stopped", period + produce + "000#0205 +100", "", "100:080#",
         hears(go_on_when_stopped)},
        {"sync-no-end", "sync", "goes on with SYNC when bit 30 of 1005h is cleared",
         period + produce + "605#2305100080000000 +100", "", "100:080#", takes_requests_as(without_end)},
        {"sync-identifier", "sync", "produces SYNC with 080h when 1005h has another identifier",
         period + "605#2305100081000040 +100", "100:081#", "100:080#",
         works_with(object(0x1005), [](std::uint32_t value) { return (value & 0x40000000U) | 0x80U; })},
        {"sync-identifier-locked", "sync", "confirms another identifier while it produces SYNC",
         period + produce + "605#2305100081000040", "585#8005100022000008", "585#6005100000000000",
         confirms_refused(object(0x1005), 0x08000022)},
        {"sync-counter-missing", "sync", "produces SYNC without the counter", counting + "+100", "100:080#01",
         "100:080#", works_with(object(0x1019), always(0))},
        {"sync-counter-from-0", "sync", "counts from 0", counting + "+100", "100:080#01", "100:080#00",
         says(count_from_0)},
        {"sync-counter-overflow", "sync", "counts one too far", counting + "+300", "300:080#01", "300:080#03",
         works_with(object(0x1019), [](std::uint32_t value) { return value == 0 ? 0 : value + 1; })},
        {"sync-counter-goes-on", "sync", "counts on after Stopped", counting + "+100 000#0205 000#8005 +100",
         "200:080#01", "200:080#02", counts_on()},
        {"sync-overflow-1", "sync", "confirms the reserved value 1 of 1019h", "605#2F19100001000000",
         "585#8019100030000906", "585#6019100000000000", confirms_refused(object(0x1019), 0x06090030)},
        {"sync-overflow-locked", "sync", "confirms 1019h while 1006h is not 0", period + "605#2F19100005000000",
         "585#8019100022000008", "585#6019100000000000", confirms_refused(object(0x1019), 0x08000022)},
    };
}

}  // namespace canproof::test::zoo
