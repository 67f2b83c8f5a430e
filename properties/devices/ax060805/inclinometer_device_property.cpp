// SPDX-License-Identifier: Apache-2.0
// Properties of the whole AX060805: for any writes and any inputs, its values stay within their limits. The frames that
// it sends do not depend on how often advance() is called.
#include <gtest/gtest.h>
// RapidCheck needs the GoogleTest header first
#include <rapidcheck/gtest.h>

#include <cmath>
#include <cstring>
#include <string>
#include <vector>

#include "devices/ax060805/firmware/ax060805.hpp"
#include "firmware/base/time.hpp"
#include "firmware/canopen/frame.hpp"
#include "generated/ax060805/requirements.hpp"
#include "generated/canopen/requirements.hpp"
#include "host/sim/bus/candump.hpp"
#include "host/sim/devices/memory.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

float from_bits(std::uint32_t bits) {
    float value = 0.0F;
    std::memcpy(&value, &bits, sizeof value);
    return value;
}

/// One event: a change of an input, a frame or a write. It happens `after_ms` milliseconds after the previous event.
struct Event {
    int kind{0};  ///< see happen()
    std::uint32_t a{0};
    std::uint32_t b{0};
    std::uint64_t after_ms{0};
};

Event any_event() {
    Event event;
    event.kind = *rc::gen::inRange(0, 8);
    event.a = *rc::gen::resize(rc::kNominalSize, rc::gen::arbitrary<std::uint32_t>());
    event.b = *rc::gen::oneOf(rc::gen::resize(rc::kNominalSize, rc::gen::arbitrary<std::uint32_t>()),
                              rc::gen::inRange<std::uint32_t>(0, 40));
    event.after_ms = *rc::gen::inRange<std::uint64_t>(0, 300);
    return event;
}

std::vector<Event> any_events() {
    std::vector<Event> events(*rc::gen::inRange<std::size_t>(1, 60));
    for (auto& event : events) {
        event = any_event();
    }
    return events;
}

/// Returns one of the writable entries, except those of 1010h (store parameters) and 1011h (restore default
/// parameters).
std::pair<std::uint16_t, std::uint8_t> some_entry(const ObjectDictionary& objects, std::uint32_t choice) {
    const auto& tables = objects.tables();
    std::vector<std::pair<std::uint16_t, std::uint8_t>> writable;
    for (const ObjectRow& object : tables.objects) {
        for (std::size_t i = 0; i < object.count; ++i) {
            const EntryRow& row = tables.entries[object.first_entry + i];
            if ((row.rights & rights::write) != 0U && object.index != 0x1010 && object.index != 0x1011) {
                writable.emplace_back(object.index, row.subindex);
            }
        }
    }
    return writable[choice % writable.size()];
}

class Run {
  public:
    Run() {
        device.power_on(inputs, now);
        collect();
    }

    void let(const Event& event, const std::vector<std::uint64_t>& extra_advances) {
        pass_to(now + milliseconds(event.after_ms), extra_advances);
        happen(event);
        collect();
    }
    /// Checks that every value is within its limits and no float is NaN or infinite.
    void check_values() const {
        const auto& objects = device.objects();
        for (const ObjectRow& object : objects.tables().objects) {
            for (std::size_t i = 0; i < object.count; ++i) {
                const EntryRef entry{&objects.tables().entries[object.first_entry + i], object.index};
                const bool counts =
                    // not checked: the limits of 1003h:0 (number of errors) are for writes, which only clear the list
                    entry.is(0x1003, 0);
                RC_ASSERT(counts || objects.check_value(entry, objects.value(entry)) == AbortCode::none);
            }
        }
    }

    std::vector<std::string> frames;

  private:
    void happen(const Event& event) {
        const float physical = from_bits(event.a);
        switch (event.kind) {
            case 0:  // any bit pattern as the acceleration on one axis
                (event.b % 3U == 0U ? inputs.acceleration_x
                                    : (event.b % 3U == 1U ? inputs.acceleration_y : inputs.acceleration_z)) = physical;
                device.set_inputs(inputs, now);
                break;
            case 1:  // accelerations of a position, which are finite
                inputs.acceleration_x = std::sin(static_cast<float>(event.a % 6283U) / 1000.0F);
                inputs.acceleration_y = std::cos(static_cast<float>(event.a % 6283U) / 1000.0F);
                inputs.acceleration_z = static_cast<float>(event.b % 3U) - 1.0F;
                device.set_inputs(inputs, now);
                break;
            case 2:
                inputs.sensor_temperature = physical;
                inputs.processor_temperature = physical;
                inputs.supply_voltage = physical;
                device.set_inputs(inputs, now);
                break;
            case 3:
                inputs.accelerometer_fault = event.b % 4U == 0U;
                inputs.can_overrun = event.b % 3U == 0U;
                inputs.can_state = static_cast<std::uint8_t>(event.b % 5U);
                device.set_inputs(inputs, now);
                break;
            case 4: {  // an NMT command
                Frame frame = data_frame(0U, 2U);
                constexpr std::uint8_t commands[]{0x01, 0x01, 0x02, 0x80, 0x81, 0x82};
                frame.data[0] = commands[event.b % 6U];
                device.receive(frame, now);
                break;
            }
            case 5: {  // RPDO1 of 0 to 8 bytes
                Frame frame = data_frame(0x27FU, static_cast<std::uint8_t>(event.b % 9U));
                write_le(MutableBytes{frame.data}, 0U, 4U, event.a);
                device.receive(frame, now);
                break;
            }
            default:  // an SDO download to an entry, with the length of the entry
                download(event);
                break;
        }
    }
    void download(const Event& event) {
        const auto [index, sub] = some_entry(device.objects(), event.a);
        const auto entry = device.objects().find(index, sub);
        const std::uint16_t size = entry.value().row->size;
        Frame frame = data_frame(0x67FU, 8U);
        frame.data[0] = static_cast<std::uint8_t>(0x23U | ((4U - size) << 2U));
        write_le(MutableBytes{frame.data}, 1U, 2U, index);
        frame.data[3] = sub;
        write_le(MutableBytes{frame.data}, 4U, 4U, event.b);
        device.receive(frame, now);
    }
    void pass_to(Instant end, const std::vector<std::uint64_t>& extra_advances) {
        for (const std::uint64_t extra : extra_advances) {
            const Instant at{now.us + (end.us - now.us) * (extra % 1000U) / 1000U};
            keep_deadlines(at);
            now = at;
            device.advance(now);
            collect();
        }
        keep_deadlines(end);
        now = end;
    }
    void keep_deadlines(Instant end) {
        while (device.next_deadline() <= end) {
            now = device.next_deadline() < now ? now : device.next_deadline();
            device.advance(now);
            collect();
        }
    }
    void collect() {
        while (!queue.empty()) {
            frames.push_back(std::to_string(now.us) + " " + host::format_frame(queue.pop()));
        }
    }

    host::Memory memory_{4096};
    TransmitQueue queue;
    ax060805::Inputs inputs{};
    Instant now{};
    ax060805::Device device{memory_, queue, ax060805::FactoryData{}};
};

}  // namespace

RC_GTEST_PROP(InclinometerLaw, ValuesOfTheDictionaryStayWithinTheirLimits, ()) {
    verifies<req::INC_FV_002, req::INC_BIN_007>("property");
    Run run;
    for (const Event& event : any_events()) {
        run.let(event, {});
        run.check_values();
    }
}

RC_GTEST_PROP(InclinometerLaw, DeviceSendsOnlyFramesWithItsOwnIdentifiers, ()) {
    verifies<req::CO_SDO_044>("property");
    Run run;
    for (const Event& event : any_events()) {
        if (event.kind < 6) {  // leaves out SDO downloads, so that the COB-IDs keep their defaults
            run.let(event, {});
        }
    }
    for (const std::string& frame : run.frames) {
        const std::string id = frame.substr(frame.find(' ') + 1, 3);
        RC_ASSERT(id == "77F" || id == "0FF" || id == "5FF" || id == "1FF");
    }
}

RC_GTEST_PROP(InclinometerLaw, FramesDoNotDependOnHowOftenAdvanceIsCalled, ()) {
    verifies<req::INC_FILTER_002, req::INC_AVG_001>("property");
    const std::vector<Event> events = any_events();
    Run at_deadlines;
    Run more_often;
    for (const Event& event : events) {
        const auto first = *rc::gen::inRange<std::uint64_t>(0, 1000);
        at_deadlines.let(event, {});
        more_often.let(event, {first, first + (1000U - first) / 2U});
    }
    RC_ASSERT(at_deadlines.frames == more_often.frames);
}

}  // namespace canproof::test
