// SPDX-License-Identifier: Apache-2.0
// Faults of NMT commands and boot-up.
#include "tests/conformance/zoo/distortions.hpp"
#include "tests/conformance/zoo/faults.hpp"

namespace canproof::test::zoo {

namespace {

constexpr unsigned start = 0x01;
constexpr unsigned stop = 0x02;
constexpr unsigned pre_operational = 0x80;
constexpr unsigned reset_node = 0x81;
constexpr unsigned reset_communication = 0x82;

bool is_command(const Frame& frame) {
    return is_data(frame, 0) && frame.length == 2;
}
bool is_command(const WrongSlave& slave, const Frame& frame, unsigned command) {
    return is_command(frame) && frame.data[0] == command && (frame.data[1] == 0 || frame.data[1] == slave.node_id());
}

Frame command_to(unsigned command, unsigned node) {
    return with_byte(with_byte(data_frame(0, 2), 0, command), 1, node);
}

Distortion takes_commands_as(FrameChange change) {
    return hears(
        [change = std::move(change)](WrongSlave& slave, const Frame& frame) { slave.pass(change(slave, frame)); });
}

/// Makes the slave execute NMT command `other` when it receives `command`.
Distortion obeys_as(unsigned command, unsigned other) {
    return takes_commands_as([=](WrongSlave& slave, const Frame& frame) {
        return is_command(slave, frame, command) ? with_byte(frame, 0, other) : frame;
    });
}

FrameTest commands(unsigned command) {
    return [command](WrongSlave& slave, const Frame& frame) { return is_command(slave, frame, command); };
}

bool is_own_boot_up(WrongSlave& slave, const Frame& frame) {
    return is_boot_up(frame, slave.node_id());
}

void boot_up_twice(WrongSlave& slave, const Frame& frame) {
    slave.say(frame);
    if (is_own_boot_up(slave, frame)) {
        slave.say_at(slave.now() + milliseconds(1), frame);
    }
}

void boot_up_empty(WrongSlave& slave, const Frame& frame) {
    slave.say(is_own_boot_up(slave, frame) ? with_length(frame, 0) : frame);
}

void start_after_boot_up(WrongSlave& slave, const Frame& frame) {
    slave.say(frame);
    if (is_own_boot_up(slave, frame)) {
        slave.pass(command_to(start, slave.node_id()));
    }
}

Frame other_nodes_too(WrongSlave& slave, const Frame& frame) {
    return is_command(frame) ? with_byte(frame, 1, slave.node_id()) : frame;
}

bool is_to_all(WrongSlave&, const Frame& frame) {
    return is_command(frame) && frame.data[1] == 0;
}

Frame of_any_length(WrongSlave&, const Frame& frame) {
    return is_data(frame, 0) && frame.length > 2 ? with_length(frame, 2) : frame;
}

Frame without_node(WrongSlave& slave, const Frame& frame) {
    return is_data(frame, 0) && frame.length == 1 ? command_to(frame.data[0], slave.node_id()) : frame;
}

Frame extended_too(WrongSlave&, const Frame& frame) {
    Frame standard = frame;
    standard.extended = frame.extended && frame.id != 0;
    return standard;
}

Frame unknown_as_stop(WrongSlave&, const Frame& frame) {
    const unsigned command = frame.data[0];
    const bool known = (command >= start && command <= stop) || (command >= pre_operational && command <= 0x82);
    return is_command(frame) && !known ? with_byte(frame, 0, stop) : frame;
}

/// Makes the slave answer reset communication with a boot-up message, but keep all values.
void keep_communication(WrongSlave& slave, const Frame& frame) {
    if (!is_command(slave, frame, reset_communication)) {
        slave.pass(frame);
        return;
    }
    slave.pass(command_to(pre_operational, slave.node_id()));
    slave.say(with_length(data_frame(error_control + slave.node_id(), 1), 1));
}

void ignore_start_when_stopped(WrongSlave& slave, const Frame& frame) {
    if (!is_command(slave, frame, start) || slave.state() != NmtState::stopped) {
        slave.pass(frame);
    }
}

}  // namespace

Faults nmt_faults() {
    const std::string heartbeat = "605#2B17100064000000 ";  // 1017h producer heartbeat time: 100 ms
    return {
        {"nmt-no-boot-up", "nmt", "sends no boot-up message", "000#8105", "705#00", "", keeps_back(is_own_boot_up)},
        {"nmt-boot-up-twice", "nmt", "sends its boot-up message twice", "000#8105 +10", "", "1:705#00",
         says(boot_up_twice)},
        {"nmt-boot-up-empty", "nmt", "sends a boot-up message without data", "000#8105", "705#00", "705#",
         says(boot_up_empty)},
        {"nmt-self-start", "nmt", "goes to Operational after its boot-up", "000#8205 " + heartbeat + "+100",
         "100:705#7F", "185#0000 100:705#05", says(start_after_boot_up)},
        {"nmt-other-node", "nmt", "obeys a command for another node", heartbeat + "000#0206 +100", "100:705#7F",
         "100:705#04", takes_commands_as(other_nodes_too)},
        {"nmt-not-to-all", "nmt", "ignores a command for all nodes", heartbeat + "000#0200 +100", "100:705#04",
         "100:705#7F", is_deaf_to(is_to_all)},
        {"nmt-long-command", "nmt", "obeys a command of more than two bytes", heartbeat + "000#020500 +100",
         "100:705#7F", "100:705#04", takes_commands_as(of_any_length)},
        {"nmt-short-command", "nmt", "obeys a command of one byte", heartbeat + "000#02 +100", "100:705#7F",
         "100:705#04", takes_commands_as(without_node)},
        {"nmt-extended-obeyed", "nmt", "obeys commands with a 29-bit identifier", heartbeat + "00000000#0205 +100",
         "100:705#7F", "100:705#04", takes_commands_as(extended_too)},
        {"nmt-unknown-command", "nmt", "stops at a command that does not exist", heartbeat + "000#0305 +100",
         "100:705#7F", "100:705#04", takes_commands_as(unknown_as_stop)},
        {"nmt-stop-ignored", "nmt", "ignores the command to stop", heartbeat + "000#0205 +100", "100:705#04",
         "100:705#7F", is_deaf_to(commands(stop))},
        {"nmt-pre-operational-ignored", "nmt", "ignores the command to enter Pre-operational",
         heartbeat + "000#0205 000#8005 +100", "100:705#7F", "100:705#04", is_deaf_to(commands(pre_operational))},
        {"nmt-start-when-stopped", "nmt", "cannot be started in Stopped", heartbeat + "000#0205 000#0105 +100",
         "185#0000 100:705#05", "100:705#04", hears(ignore_start_when_stopped)},
        {"nmt-communication-as-node", "nmt", "resets application objects at reset communication",
         "605#2F01220008000000 000#8205 605#4001220000000000", "585#4F01220008000000", "585#4F01220002000000",
         obeys_as(reset_communication, reset_node)},
        {"nmt-node-as-communication", "nmt", "keeps application objects at reset node",
         "605#2F01220008000000 000#8105 605#4001220000000000", "585#4F01220002000000", "585#4F01220008000000",
         obeys_as(reset_node, reset_communication)},
        {"nmt-communication-kept", "nmt", "keeps communication objects at reset communication",
         "605#2B15100007000000 000#8205 605#4015100000000000", "585#4B15100000000000", "585#4B15100007000000",
         hears(keep_communication)},
    };
}

}  // namespace canproof::test::zoo
