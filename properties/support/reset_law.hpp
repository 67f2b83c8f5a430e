// SPDX-License-Identifier: Apache-2.0
// Properties ("laws"): a reset clears all earlier state. A device with any history (unit) is reset. From then on it
// must send the same frames and have the same outputs as a device that is switched on at that moment with the same
// stored parameters and inputs. The law restart_law() is about reset node and power-on (CiA 301, 7.3.2.2). The law
// communication_law() is about reset communication, which keeps the application. The law lss_law() is about the reset
// by LSS.
#pragma once

#include "properties/support/reset_events.hpp"

namespace canproof::test {

enum class Reset { node, power };

inline bool every_entry(const EntryRef&) {
    return true;
}

template <typename Traits>
void read_all(ResetUnit<Traits>& unit, bool reads_all) {
    if (!reads_all) {
        return;
    }
    for (const ObjectRow& object : unit.device->objects().tables().objects) {
        for (std::size_t i = 0; i < object.count; ++i) {
            const unsigned sub = unit.device->objects().tables().entries[object.first_entry + i].subindex;
            unit.request(0x40, object.index, sub, 0);
        }
    }
}

/// Performs the same events on both units, step by step. Returns, as text, the first difference and the step in which
/// it appeared, or an empty text.
template <typename Traits, typename Counts>
std::string first_difference(ResetUnit<Traits>& one, ResetUnit<Traits>& other, const std::vector<Event>& stimulus,
                             bool reads_all, const Counts& counts) {
    std::string found = difference(one, other, counts);
    std::string after = "at once";
    const auto both = [&](const std::string& what, const auto& act) {
        if (found.empty()) {
            act(one);
            act(other);
            found = difference(one, other, counts);
            after = what;
        }
    };
    using Unit = ResetUnit<Traits>;
    both("3 ms", [](Unit& unit) { unit.pass(milliseconds(3)); });
    both("all values by SDO", [reads_all](Unit& unit) { read_all(unit, reads_all); });
    both("start", [](Unit& unit) { unit.command(1); });
    both("60 ms", [](Unit& unit) { unit.pass(milliseconds(60)); });
    for (unsigned number = 0; number < 2; ++number) {
        both("an RPDO", [number](Unit& unit) {
            unit.send(unit.value(0x1400U + number, 1) & 0x7FFU, {0x10, 0x02, 0x90, 0x01, 0x30, 0, 0x77, 0});
        });
    }
    both("SYNC", [](Unit& unit) { unit.send(0x80, {}); });
    both("guarding", [](Unit& unit) { unit.ask_remote(0x700U + unit.node()); });
    both("LSS configuration", [](Unit& unit) { unit.send(0x7E5, {0x5E, 0, 0, 0, 0, 0, 0, 0}); });
    for (const Event& event : stimulus) {
        both(rc::toString(event), [&event](Unit& unit) { Happening<Traits>::happen(unit, event); });
    }
    both("recovery", [](Unit& unit) { unit.recover(); });
    both("400 ms", [](Unit& unit) { unit.pass(milliseconds(400)); });
    both("all values by SDO", [reads_all](Unit& unit) { read_all(unit, reads_all); });
    return found.empty() ? "" : fmt::format("after {}: {}", after, found);
}

/// Checks reset node or power-on: resets a unit with any history, and compares it with a new unit that is switched on
/// at the same time.
template <typename Traits>
void restart_law(Reset reset) {
    ResetUnit<Traits> used;
    Happening<Traits>::happen(used, some_events({EventKind::setting, EventKind::setting, EventKind::communication}));
    for (const Write& write : Traits::lively()) {
        if (*rc::gen::inRange(0, 8) != 0) {
            used.write(write.index, write.sub, write.bytes, write.value);
        }
    }
    if (*rc::gen::inRange(0, 3) != 0) {
        used.write(0x1010, 1, 4, 0x65766173);  // "save" to 1010h:1: present values remain after the reset
    }
    Happening<Traits>::happen(used, some_events(every_kind));
    used.recover();
    const auto stimulus = some_events(every_kind);
    used.take_frames();
    if (reset == Reset::node) {
        used.command(0x81);
        RC_PRE(!Traits::keeps_outputs(*used.device, used.inputs));
    } else {
        used.power_on();
    }
    used.pass(Duration{});  // a self-start without delay happens here
    ResetUnit<Traits> fresh{used.memory.bytes(), used.inputs, used.now};
    fresh.pass(Duration{});
    const bool reads_all = *rc::gen::inRange(0, 8) == 0;
    const std::string found = first_difference(used, fresh, stimulus, reads_all, every_entry);
    RC_ASSERT(found == "");
}

/// Returns whether reset communication restores an entry to its stored value or default: all entries below 2000h,
/// except 1001h (error register) and 1003h (error list), because errors continue.
inline bool is_communication_parameter(const EntryRef& entry) {
    return entry.index >= 0x1000 && entry.index < 0x2000 && entry.index != 0x1001 && entry.index != 0x1003;
}

/// The kinds of events that only `used` gets in live_apart(). They concern the communication and do not affect the
/// application.
inline const std::vector<EventKind> own_kinds{EventKind::communication, EventKind::communication, EventKind::request,
                                              EventKind::heartbeat, EventKind::remote};
/// The kinds of events that both units get in live_apart(). Their effect on the application does not depend on the
/// state of the communication.
inline const std::vector<EventKind> shared_kinds{EventKind::setting, EventKind::setting, EventKind::nmt,
                                                 EventKind::input,   EventKind::time,    EventKind::late};

/// Performs the same events on both units. On `used` also performs events that concern only its communication, and
/// leaves some of these activities unfinished.
template <typename Traits>
void live_apart(ResetUnit<Traits>& used, ResetUnit<Traits>& spared) {
    const int rounds = *rc::gen::inRange(1, 4);
    for (int round = 0; round < rounds; ++round) {
        const auto both = some_events(shared_kinds);
        Happening<Traits>::happen(used, both);
        Happening<Traits>::happen(spared, both);
        for (const Event& event : some_events(own_kinds)) {
            Happening<Traits>::happen_to_communication(used, event);
        }
    }
    Happening<Traits>::leave_waiting(used, *rc::gen::inRange(0U, 4U));
}

/// Checks reset communication. Two units get the same events. One of the units also gets events that concern only its
/// communication: parameters, unfinished transfers, timers, a SYNC that is due. Both units are reset, and must then
/// behave the same: the application continues as in the unit without these events, and these events have no effect any
/// more.
template <typename Traits>
void communication_law() {
    ResetUnit<Traits> used;
    ResetUnit<Traits> spared;
    const auto first = some_events(every_kind);
    for (ResetUnit<Traits>* unit : {&used, &spared}) {
        Happening<Traits>::happen(*unit, first);
        unit->recover();
        unit->command(0x82);
    }
    live_apart(used, spared);
    const auto stimulus = some_events(every_kind);
    for (ResetUnit<Traits>* unit : {&used, &spared}) {
        unit->take_frames();
        unit->command(0x82);
    }
    ResetUnit<Traits> fresh{used.memory.bytes(), used.inputs, used.now};
    const std::string of_parameters = difference_of_values(used, fresh, is_communication_parameter);
    // The communication parameters may differ only if the node-IDs differ: then LSS has set a node-ID that is not
    // stored.
    RC_ASSERT(of_parameters == "" || used.node() != fresh.node());
    const std::string found = first_difference(used, spared, stimulus, false, every_entry);
    RC_ASSERT(found == "");
}

/// Sets the node-ID of a unit to `node_id` by LSS. The unit must not be operational. At the switch from LSS
/// configuration back to LSS waiting, the node resets itself.
template <typename Traits>
void give_node_id(ResetUnit<Traits>& unit, unsigned node_id, bool stores) {
    constexpr std::uint32_t lss_request = 0x7E5;
    unit.send(lss_request, {0x04, 1, 0, 0, 0, 0, 0, 0});
    unit.send(lss_request, {0x11, node_id, 0, 0, 0, 0, 0, 0});
    if (stores) {
        unit.send(lss_request, {0x17, 0, 0, 0, 0, 0, 0, 0});
    }
    unit.send(lss_request, {0x04, 0, 0, 0, 0, 0, 0, 0});
}

/// Sends the LSS request `command` with 1018h:`sub` (identity object), one of the four numbers of the unit's own LSS
/// address.
template <typename Traits>
void name_own(ResetUnit<Traits>& unit, unsigned command, unsigned sub) {
    const std::uint32_t number = unit.value(0x1018, sub);
    unit.send(0x7E5,
              {command, number & 0xFFU, (number >> 8U) & 0xFFU, (number >> 16U) & 0xFFU, number >> 24U, 0, 0, 0});
}

/// Checks a reset by LSS: switch to configuration, a new node-ID, back to waiting. The device resets its communication
/// and boots with that node-ID (AX130751 3.1.2, AX188001 3.1.1.1, AX060805 4.1.1.1). From then on it must behave like a
/// unit that has had this node-ID since power-on, has the same stored parameters, and gets reset communication at the
/// same time.
template <typename Traits>
void lss_law() {
    const unsigned node_id = *rc::gen::inRange(1U, 128U);
    const bool stores = *rc::gen::inRange(0, 3) != 0;
    ResetUnit<Traits> used;
    Happening<Traits>::happen(used, some_events(every_kind));
    used.recover();
    ResetUnit<Traits> spared{used.memory.bytes(), used.inputs, used.now};
    spared.command(0x80);
    give_node_id(spared, node_id, true);
    for (ResetUnit<Traits>* unit : {&used, &spared}) {
        unit->power_on();
        unit->pass(Duration{});  // a self-start without delay happens here
    }
    RC_ASSERT(spared.node() == node_id);
    live_apart(used, spared);
    for (ResetUnit<Traits>* unit : {&used, &spared}) {
        unit->command(0x80);
        unit->take_frames();
    }
    name_own(used, 0x40, 1);  // sends the first half of switch state selective and of identify remote slave
    name_own(used, 0x41, 2);
    for (unsigned frame = 0; frame < 3; ++frame) {
        name_own(used, 0x46 + frame, 1 + frame);
    }
    give_node_id(used, node_id, stores);
    spared.command(0x82);
    const auto sent = used.take_frames();
    const std::string boot_up = fmt::format("{} {:03X}#00", used.now.us, 0x700U + node_id);
    RC_ASSERT(std::count(sent.begin(), sent.end(), boot_up) == 1);
    spared.take_frames();
    for (ResetUnit<Traits>* unit : {&used, &spared}) {
        unit->pass(Duration{});
    }
    ResetUnit<Traits> fresh{spared.memory.bytes(), spared.inputs, spared.now};
    RC_ASSERT(difference_of_values(used, fresh, is_communication_parameter) == "");
    for (ResetUnit<Traits>* unit : {&used, &spared}) {  // both units receive the second half of each sequence now
        name_own(*unit, 0x42, 3);
        name_own(*unit, 0x43, 4);
        name_own(*unit, 0x49, 3);
        name_own(*unit, 0x4A, 4);
        name_own(*unit, 0x4B, 4);
        unit->send(0x7E5, {0x5E, 0, 0, 0, 0, 0, 0, 0});
    }
    auto kinds = every_kind;
    if (!stores) {  // leaves out reset node, which would load the stored node-ID
        kinds.erase(std::remove(kinds.begin(), kinds.end(), EventKind::reset), kinds.end());
    }
    // Entries that take effect only at the next power-on contain the stored node-ID or bit rate. So they are compared
    // only when LSS has stored the node-ID.
    const auto counts = [stores](const EntryRef& entry) { return stores || Traits::may_write(entry.index); };
    const std::string found = first_difference(used, spared, some_events(kinds), false, counts);
    RC_ASSERT(found == "");
}

}  // namespace canproof::test
