// SPDX-License-Identifier: Apache-2.0
// Generates events for a device before and after a reset. RapidCheck shrinks a failure to the events that cause it.
#pragma once

#include <rapidcheck.h>

#include <ostream>

#include "properties/support/reset_unit.hpp"

namespace canproof::test {

enum class EventKind : std::uint8_t {
    setting,        ///< a parameter of the application
    communication,  ///< a communication parameter
    entry,          ///< any entry, with any value
    request,        ///< an SDO request that starts or continues a transfer
    nmt,
    reset,
    pdo,
    remote,  ///< a remote frame for a TPDO, an RPDO or error control
    sync,
    heartbeat,  ///< heartbeat of another node
    lss,
    store,
    input,
    controller,
    time,
    late
};

struct Event {
    EventKind kind{EventKind::time};
    unsigned which{0};
    unsigned sub{0};
    std::uint32_t value{0};
};

inline std::ostream& operator<<(std::ostream& out, const Event& event) {
    constexpr const char* names[]{"setting", "communication", "entry", "request",   "nmt", "reset",
                                  "pdo",     "remote",        "sync",  "heartbeat", "lss", "store",
                                  "input",   "controller",    "time",  "late"};
    return out << fmt::format("{} {} {} {:X}", names[static_cast<std::size_t>(event.kind)], event.which, event.sub,
                              event.value);
}

/// Generates events whose kinds are in `kinds`. A kind that is listed twice is twice as frequent.
inline rc::Gen<Event> some_event(const std::vector<EventKind>& kinds) {
    return rc::gen::exec([kinds] {
        Event event;
        event.kind = *rc::gen::elementOf(kinds);
        event.which = *rc::gen::inRange(0U, 4096U);
        event.sub = *rc::gen::inRange(0U, 256U);
        event.value = *rc::gen::oneOf(rc::gen::inRange<std::uint32_t>(0, 1000), rc::gen::arbitrary<std::uint32_t>());
        return event;
    });
}
inline std::vector<Event> some_events(const std::vector<EventKind>& kinds) {
    return *rc::gen::container<std::vector<Event>>(some_event(kinds));
}

/// All kinds of events. A kind with wide effects is listed several times, so that it is more frequent.
inline const std::vector<EventKind> every_kind{
    EventKind::setting,   EventKind::setting, EventKind::setting, EventKind::setting, EventKind::communication,
    EventKind::entry,     EventKind::request, EventKind::nmt,     EventKind::nmt,     EventKind::communication,
    EventKind::reset,     EventKind::pdo,     EventKind::pdo,     EventKind::remote,  EventKind::sync,
    EventKind::heartbeat, EventKind::lss,     EventKind::store,   EventKind::input,   EventKind::input,
    EventKind::input,     EventKind::time,    EventKind::time,    EventKind::time,    EventKind::late,
    EventKind::controller};

/// Communication parameters that switch something on or off.
inline const std::vector<Setting>& communication_settings() {
    static const std::vector<Setting> all{
        {0x1003, 0, 1, {0}},
        {0x1005, 0, 4, {0x80, 0x40000080, 0x81}},
        {0x1006, 0, 4, {0, 3000, 70000}},
        {0x100C, 0, 2, {0, 40, 300}},
        {0x100D, 0, 1, {0, 1, 3}},
        {0x1014, 0, 4, {0x80000085, 0x85, 0x95}},
        {0x1015, 0, 2, {0, 50, 3000, 20000}},
        {0x1016, 4, 4, {0, 0x00710014, 0x0072012C, 0x00730BB8}},
        {0x1017, 0, 2, {0, 7, 110, 900}},
        {0x1019, 0, 1, {0, 10}},
        {0x1020, 2, 4, {0, 77}},
        {0x1029, 3, 1, {0, 1, 2}},
        {0x1800, 6, 1, {0, 1, 2, 240, 252, 253, 254, 255}},
        {0x1801, 6, 1, {0, 1, 2, 240, 252, 253, 254, 255}},
        {0x1800, 6, 2, {0, 30, 600, 5000}},
        {0x1801, 6, 2, {0, 30, 600, 5000}},
        {0x1802, 6, 2, {0, 30, 600, 5000}},
        {0x1803, 6, 2, {0, 30, 600, 5000}},
        {0x1A00, 0, 1, {0, 1, 2}},
        {0x1A00, 4, 4, {0x10010008, 0x10180420}},
        {0x1F80, 0, 4, {0, 8}},
    };
    return all;
}
/// Parameters of RPDOs, which decide which frames reach the application.
inline const std::vector<Setting>& reception_settings() {
    static const std::vector<Setting> all{
        {0x1400, 5, 1, {0, 1, 254, 255}}, {0x1401, 5, 1, {0, 1, 254, 255}}, {0x1400, 5, 2, {0, 20, 250}},
        {0x1401, 5, 2, {0, 20, 250}},     {0x1600, 0, 1, {0, 1}},           {0x1600, 4, 4, {0x00050008, 0x00060010}},
    };
    return all;
}

/// Performs events on a device (unit): sends frames, changes inputs, lets time pass.
template <typename Traits>
class Happening {
  public:
    using Unit = ResetUnit<Traits>;

    static void happen(Unit& unit, const Event& event) {
        switch (event.kind) {
            case EventKind::setting:
                return put(unit, pick(Traits::settings(), event.which), event);
            case EventKind::communication:
                return put(unit,
                           pick((event.value & 3U) == 0 ? reception_settings() : communication_settings(), event.which),
                           event);
            case EventKind::entry:
                return write_entry(unit, event);
            case EventKind::request:
                return request(unit, event);
            case EventKind::nmt:
                return unit.command(pick(std::vector<unsigned>{1, 1, 1, 2, 0x80}, event.which));
            case EventKind::reset:
                return unit.command(event.which % 2U == 0 ? 0x81U : 0x82U);
            default:
                return happen_outside(unit, event);
        }
    }
    static void happen(Unit& unit, const std::vector<Event>& events) {
        for (const Event& event : events) {
            happen(unit, event);
        }
    }

    /// Performs an event that concerns only the communication. Skips events that could affect the application: those
    /// that start the monitoring of another node, and writes to the parameters of guarding, heartbeat consumers, SYNC,
    /// EMCY and to 1029h (error behaviour).
    static void happen_to_communication(Unit& unit, const Event& event) {
        if (would_start_supervision(unit, event.kind)) {
            return;
        }
        if (event.kind != EventKind::communication) {
            return happen(unit, event);
        }
        const Setting& setting = pick(communication_settings(), event.which);
        const bool is_watched = setting.index == 0x1016 || setting.index == 0x100C || setting.index == 0x100D;
        const bool syncs = setting.index == 0x1005 || setting.index == 0x1006 || setting.index == 0x1019;
        // Skips settings that empty 1003h (error list), delay or drop emergency messages, or lead to an NMT state in
        // which the node does not answer.
        const bool tells =
            setting.index == 0x1003 || setting.index == 0x1014 || setting.index == 0x1015 || setting.index == 0x1029;
        if (!is_watched && !syncs && !tells) {
            put(unit, setting, event);
        }
    }
    /// Starts activities that must not continue after the reset: an RPDO that waits for its SYNC, a heartbeat,
    /// guarding, a SYNC that is due, an SDO transfer.
    static void leave_waiting(Unit& unit, unsigned number) {
        unit.write(0x1400U + number, 2, 1, 1);
        if (unit.value(0x1400U + number, 2) == 1) {
            unit.send(unit.value(0x1400U + number, 1) & 0x7FFU, {0x44, 0x03, 0x33, 0x02, 0x22, 0x01, 0x11, 0x01});
        }
        unit.write(0x1016, 1, 4, 0x0071'0064);
        unit.send(0x771, {5});
        unit.write(0x100C, 0, 2, 50);
        unit.write(0x100D, 0, 1, 2);
        unit.ask_remote(0x700U + unit.node());
        unit.write(0x1019, 0, 1, 10);
        unit.write(0x1006, 0, 4, 8000);
        unit.write(0x1005, 0, 4, 0x40000080);
        unit.write(0x1400U + (number + 1U) % 4U, 5, 2, 30);
        unit.request(0x21, 0x1400, 1, 4);
    }

  private:
    template <typename Value>
    static const Value& pick(const std::vector<Value>& all, std::size_t which) {
        return all[which % all.size()];
    }
    static std::vector<unsigned> bytes_of(std::uint32_t value, std::size_t length) {
        std::vector<unsigned> bytes;
        for (std::size_t i = 0; i < length; ++i) {
            bytes.push_back((value >> (8U * (i % 4U))) & 0xFFU);
        }
        return bytes;
    }

    /// Returns whether an event of this kind may start the monitoring of another node, whose silence would then be an
    /// error of the device. Such an event is a heartbeat of a node that 1016h (consumer heartbeat time) names, or a
    /// remote frame while guarding is on.
    static bool would_start_supervision(const Unit& unit, EventKind kind) {
        const unsigned watched = unit.value(0x1016, 0);
        bool names_a_node = false;
        for (unsigned sub = 1; sub <= watched; ++sub) {
            names_a_node = names_a_node || unit.value(0x1016, sub) != 0;
        }
        const bool guards = unit.value(0x100C, 0) != 0 && unit.value(0x100D, 0) != 0;
        return (kind == EventKind::heartbeat && names_a_node) || (kind == EventKind::remote && guards);
    }
    static void put(Unit& unit, const Setting& setting, const Event& event) {
        const unsigned sub = setting.subs == 0 ? 0 : 1 + event.sub % setting.subs;
        unit.write(setting.index, sub, setting.bytes, pick(setting.values, event.value));
    }
    static void write_entry(Unit& unit, const Event& event) {
        const DictionaryTables& tables = unit.device->objects().tables();
        const std::size_t chosen = (event.which * 256U + event.sub) % tables.entries.count;
        const EntryRow& entry = tables.entries[chosen];
        for (const ObjectRow& object : tables.objects) {
            const bool holds = chosen >= object.first_entry && chosen < std::size_t{object.first_entry} + object.count;
            if (holds && entry.size >= 1 && entry.size <= 4 && Traits::may_write(object.index)) {
                unit.write(object.index, entry.subindex, entry.size, event.value);
            }
        }
    }
    static void request(Unit& unit, const Event& event) {
        // SDO command bytes: initiate and further requests of segmented and block uploads and downloads, and abort.
        static const std::vector<unsigned> commands{0x40, 0x60, 0x70, 0x21, 0x20, 0x00, 0x10,
                                                    0xA4, 0xA3, 0xA2, 0xC6, 0xC2, 0x80};
        const DictionaryTables& tables = unit.device->objects().tables();
        const ObjectRow& object = tables.objects[event.sub % tables.objects.count];
        unit.request(pick(commands, event.which), object.index, event.value % (object.count + 1U), event.value % 200U);
    }
    static void happen_outside(Unit& unit, const Event& event) {
        switch (event.kind) {
            case EventKind::pdo:
                return unit.send(unit.value(0x1400U + event.which % 4U, 1) & 0x7FFU,
                                 bytes_of(event.value, event.sub % 8U + 1U));
            case EventKind::remote:
                return unit.ask_remote(pick(std::vector<std::uint32_t>{0x700U + unit.node(), unit.value(0x1800, 1),
                                                                       unit.value(0x1801, 1), unit.value(0x1401, 1)},
                                            event.which));
            case EventKind::sync:
                return unit.send(unit.value(0x1005, 0) & 0x7FFU,
                                 bytes_of(event.value % 11U, event.which % 8U == 0 ? 1 : 0));
            case EventKind::heartbeat:
                return unit.send(0x771U + event.which % 3U, {5});
            case EventKind::lss:
                return serve(unit, event);
            case EventKind::store:
                return unit.write(event.which % 4U == 0 ? 0x1011 : 0x1010, 1 + event.sub % 4U, 4,
                                  event.which % 4U == 0 ? 0x64616F6C : 0x65766173);
            case EventKind::input:
                return set_input(unit, event);
            case EventKind::controller:
                unit.set_input("can_overrun", event.sub % 2U);
                static_cast<void>(unit.set_input("can_state", pick(std::vector<double>{0, 1, 2, 3}, event.which)));
                return;
            case EventKind::late:
                return unit.pass_unattended(microseconds(event.value % 40'000U));
            default:
                return unit.pass(microseconds((event.which % 4U == 0 ? 1000U : 50U) * (event.value % 300U)));
        }
    }
    static void set_input(Unit& unit, const Event& event) {
        const InputChoice& input = pick(Traits::inputs(), event.which);
        RC_ASSERT(unit.set_input(input.name, pick(input.values, event.value)));
    }
    static void serve(Unit& unit, const Event& event) {
        constexpr std::uint32_t lss_request = 0x7E5;
        const unsigned delay = event.value % 20U;
        switch (event.which % 8U) {
            case 0:
                return unit.send(lss_request, {4, 0, 0, 0, 0, 0, 0, 0});
            case 1:
                return unit.send(lss_request, {0x11, 1 + event.sub % 127U, 0, 0, 0, 0, 0, 0});
            case 2:
                return unit.send(lss_request, {0x13, 0, event.sub % 9U, 0, 0, 0, 0, 0});
            case 3:
                unit.silent_until = std::max(unit.silent_until, unit.now + milliseconds(2U * delay),
                                             [](Instant one, Instant other) { return one < other; });
                return unit.send(lss_request, {0x15, delay, 0, 0, 0, 0, 0, 0});
            case 4:
                return unit.send(lss_request, {0x17, 0, 0, 0, 0, 0, 0, 0});
            case 5:
                return unit.send(lss_request, {0x40U + event.sub % 4U, 0, 0, 0, 0, 0, 0, 0});
            default:
                return unit.send(lss_request, {4, 1, 0, 0, 0, 0, 0, 0});
        }
    }
};

}  // namespace canproof::test
