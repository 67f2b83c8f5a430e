// SPDX-License-Identifier: Apache-2.0
// Faults of EMCY messages, of 1001h (error register) and of 1003h (error history).
#include "tests/conformance/zoo/distortions.hpp"
#include "tests/conformance/zoo/faults.hpp"

namespace canproof::test::zoo {

namespace {

constexpr std::uint32_t emcy = 0x80;
constexpr std::uint16_t history = 0x1003;
constexpr std::uint8_t history_length = 4;

bool is_emcy(const WrongSlave& slave, const Frame& frame) {
    return is_data(frame, emcy + slave.node_id()) && frame.length == 8;
}
std::uint32_t code_of(const Frame& frame) {
    return static_cast<std::uint32_t>(field_le<0, 2>(frame.data));
}
bool is_error(const WrongSlave& slave, const Frame& frame) {
    return is_emcy(slave, frame) && code_of(frame) != 0;
}
bool is_end_of_error(WrongSlave& slave, const Frame& frame) {
    return is_emcy(slave, frame) && code_of(frame) == 0;
}

Distortion tells_otherwise(FrameChange change) {
    return says([change = std::move(change)](WrongSlave& slave, const Frame& frame) {
        slave.say(is_emcy(slave, frame) ? change(slave, frame) : frame);
    });
}

void say_twice(WrongSlave& slave, const Frame& frame) {
    slave.say(frame);
    if (is_emcy(slave, frame)) {
        slave.say(frame);
    }
}

Frame of_seven_bytes(WrongSlave&, const Frame& frame) {
    return with_length(frame, 7);
}

Frame with_next_code(WrongSlave&, const Frame& frame) {
    return code_of(frame) == 0 ? frame : with_byte(frame, 0, frame.data[0] + 0x10U);
}

/// Makes the slave report a wrong error register, in 1001h and in the EMCY messages.
Distortion shows_register(std::function<unsigned(WrongSlave&, unsigned)> change) {
    return says([change = std::move(change)](WrongSlave& slave, const Frame& frame) {
        const bool reads = is_sdo_answer(slave, frame) && is_expedited_answer(frame) && index_of(frame) == 0x1001;
        if (is_emcy(slave, frame)) {
            slave.say(with_byte(frame, 2, change(slave, frame.data[2])));
        } else {
            slave.say(reads ? with_byte(frame, 4, change(slave, frame.data[4])) : frame);
        }
    });
}

unsigned with_old_bits(WrongSlave& slave, unsigned bits) {
    slave.notes[0] |= bits;
    return slave.notes[0];
}

/// Makes the slave keep only the newest error in 1003h (error history).
void keep_newest(WrongSlave& slave, const Frame& frame) {
    if (is_error(slave, frame)) {
        slave.dictionary().write(history, 0, 1);
        for (std::uint8_t sub = 2; sub <= history_length; ++sub) {
            slave.dictionary().write(history, sub, 0);
        }
    }
    slave.say(frame);
}

/// Makes the slave list the newest error behind the older ones.
void append_newest(WrongSlave& slave, const Frame& frame) {
    if (is_error(slave, frame)) {
        const auto count = static_cast<std::uint8_t>(slave.dictionary().read(history, 0));
        const std::uint32_t newest = slave.dictionary().read(history, 1);
        for (std::uint8_t sub = 1; sub < count; ++sub) {
            slave.dictionary().write(history, sub,
                                     slave.dictionary().read(history, static_cast<std::uint8_t>(sub + 1)));
        }
        slave.dictionary().write(history, count, newest);
    }
    slave.say(frame);
}

/// Makes the slave list the end of an error in 1003h too.
void list_end(WrongSlave& slave, const Frame& frame) {
    if (is_end_of_error(slave, frame)) {
        const std::uint32_t count = slave.dictionary().read(history, 0);
        for (std::uint8_t sub = history_length; sub > 1; --sub) {
            slave.dictionary().write(history, sub,
                                     slave.dictionary().read(history, static_cast<std::uint8_t>(sub - 1)));
        }
        slave.dictionary().write(history, 1, 0);
        slave.dictionary().write(history, 0, count < history_length ? count + 1 : count);
    }
    slave.say(frame);
}

/// Makes the slave confirm a write that should clear 1003h (error history), and keep its entries.
void keep_history(WrongSlave& slave, const Frame& frame) {
    const bool clears = is_sdo_request(slave, frame) && is_expedited_download(frame) && index_of(frame) == history &&
                        sub_of(frame) == 0 && frame.data[4] == 0;
    if (clears) {
        slave.say(confirmation(slave.node_id(), frame));
    } else {
        slave.pass(frame);
    }
}

bool is_heartbeat_error(WrongSlave& slave, const Frame& frame) {
    return is_emcy(slave, frame) && code_of(frame) == 0x8130;
}

ObjectTest history_entries() {
    return [](std::uint16_t index, std::uint8_t sub) { return index == history && sub != 0; };
}

}  // namespace

Faults emcy_faults() {
    const std::string error = "080#00 ";  // a SYNC of wrong length causes error 8240h
    const std::string end = "080# ";
    const std::string told = "085#4082110100000000";
    const std::string ended = "085#0000000100000000";
    const std::string second_error = "000#0105 " + error + "205#00 ";  // then an RPDO that is too short: error 8210h
    const std::string read_count = "605#4003100000000000";
    return {
        {"emcy-twice", "emcy", "sends each EMCY twice", error, "", told, says(say_twice)},
        {"emcy-missing", "emcy", "sends no EMCY when a heartbeat is lost", "605#2316100164000700 707#05 +100",
         "100:085#3081110100000000", "", keeps_back(is_heartbeat_error)},
        {"emcy-length", "emcy", "sends an EMCY of seven bytes", error, told, "085#40821101000000",
         tells_otherwise(of_seven_bytes)},
        {"emcy-code", "emcy", "sends an error code that is 10h too high", "000#0105 205#00", "085#1082110100000000",
         "085#2082110100000000", tells_otherwise(with_next_code)},
        {"emcy-no-end", "emcy", "does not tell the end of an error", error + end, ended, "",
         keeps_back(is_end_of_error)},
        {"emcy-although-off", "emcy", "sends EMCY although bit 31 of 1014h is set", "605#2314100085000080 " + error, "",
         told, works_with(object(0x1014), [](std::uint32_t value) { return value & 0x7FFFFFFFU; })},
        {"emcy-identifier", "emcy", "sends EMCY with its first identifier when 1014h has another",
         "605#2314100085000080 605#2314100088000000 " + error, "088#4082110100000000", told,
         works_with(object(0x1014), [](std::uint32_t value) { return (value & 0x80000000U) | 0x85U; })},
        {"emcy-identifier-locked", "emcy", "confirms another identifier while 1014h is valid", "605#2314100088000000",
         "585#8014100022000008", "585#6014100000000000", confirms_refused(object(0x1014), 0x08000022)},
        {"emcy-inhibit-ignored", "emcy", "ignores the inhibit time 1015h",
         "605#2B151000E8030000 " + error + end + "+100", "100:" + ended, ended, works_with(object(0x1015), always(0))},
        {"emcy-inhibit-short", "emcy", "keeps half the inhibit time 1015h",
         "605#2B151000E8030000 " + error + end + "+100", "100:" + ended, "50:" + ended,
         works_with(object(0x1015), percent(50))},
        {"emcy-register-stuck", "emcy", "keeps bits of the error register after the error",
         error + end + "605#4001100000000000", ended + " 585#4F01100000000000",
         "085#0000110100000000 585#4F01100011000000", shows_register(with_old_bits)},
        {"emcy-register-zero", "emcy", "shows no bit in the error register", error + "605#4001100000000000",
         told + " 585#4F01100011000000", "085#4082000100000000 585#4F01100000000000",
         shows_register([](WrongSlave&, unsigned) { return 0U; })},
        {"emcy-history-not-shifted", "emcy", "keeps the newest error only", second_error + read_count,
         "585#4F03100002000000", "585#4F03100001000000", says(keep_newest)},
        {"emcy-history-order", "emcy", "puts the newest error behind the others", second_error + "605#4003100100000000",
         "585#4303100110820000", "585#4303100140820000", says(append_newest)},
        {"emcy-history-end", "emcy", "enters the end of an error into the history", error + end + read_count,
         "585#4F03100001000000", "585#4F03100002000000", says(list_end)},
        {"emcy-history-written", "emcy", "confirms a write to an entry of the history", "605#2303100101000000",
         "585#8003100102000106", "585#6003100100000000", confirms_refused(history_entries(), 0x06010002)},
        {"emcy-history-count", "emcy", "confirms a count of the history that is not 0", "605#2F03100001000000",
         "585#8003100031000906", "585#6003100000000000", confirms_refused(entry(history, 0), 0x06090031)},
        {"emcy-history-kept", "emcy", "does not clear the history", error + "605#2F03100000000000 " + read_count,
         "585#4F03100000000000", "585#4F03100001000000", hears(keep_history)},
    };
}

}  // namespace canproof::test::zoo
