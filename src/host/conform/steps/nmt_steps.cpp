// SPDX-License-Identifier: Apache-2.0
#include "host/conform/steps/nmt_steps.hpp"

#include <fmt/format.h>

#include "host/conform/language/expression.hpp"
#include "host/conform/link/node_control.hpp"

namespace canproof::host::conform {

namespace {

constexpr Duration off_time = milliseconds(200);

NmtCommand parse_reset_kind(Scanner& line) {
    if (line.take_word("node")) {
        return NmtCommand::reset_node;
    }
    if (line.take_word("communication")) {
        return NmtCommand::reset_communication;
    }
    line.fail("a reset is missing", "write reset node or reset communication");
}

NmtCommand parse_command(Scanner& line) {
    if (line.take_word("start")) {
        return NmtCommand::start;
    }
    if (line.take_word("stop")) {
        return NmtCommand::stop;
    }
    if (line.take_word("preop")) {
        return NmtCommand::pre_operational;
    }
    if (line.take_word("reset")) {
        return parse_reset_kind(line);
    }
    line.fail(fmt::format("`{}` is no NMT command", line.rest()),
              "write nmt start, stop, preop, reset node or reset communication");
}

Action parse_nmt(Scanner& line, StepSource&) {
    const NmtCommand command = parse_command(line);
    Expression node = [](const Scope& scope) { return *scope.find("N"); };
    if (line.take_word("to")) {
        node = line.take_word("all") ? Expression{[](const Scope&) { return Value{std::int64_t{0}}; }}
                                     : parse_operand(line, Radix::decimal);
    }
    line.finish();
    return [command, node](Context& context) {
        send_nmt(context.link, command, static_cast<std::uint8_t>(number_of(node(*context.scope))));
    };
}

/// Waits for the boot-up message. Returns the time at which it was on the bus.
Instant want_boot_up(Context& context) {
    const std::optional<Instant> time = take_boot_up(context.link, context.node());
    if (!time) {
        throw NoAnswer{fmt::format("no boot-up message came within {} s", boot_limit.us / 1000000U)};
    }
    ++context.journal.judged;
    return *time;
}

Action parse_reset(Scanner& line, StepSource&) {
    const NmtCommand command = parse_reset_kind(line);
    line.finish();
    return [command](Context& context) {
        send_nmt(context.link, command, context.node());
        const Instant booted = want_boot_up(context);
        context.journal.times["boot-up"].add(elapsed(context.link.last_sent(), booted).us, boot_limit.us);
    };
}

Action parse_power(Scanner& line, StepSource&) {
    const bool cycle = line.take_word("cycle");
    const bool on = !cycle && line.take_word("on");
    if (!cycle && !on && !line.take_word("off")) {
        line.fail("a word after `power` is missing", "write power cycle, power off or power on");
    }
    line.finish();
    return [cycle, on](Context& context) {
        Target& target = context.link.target();
        if (target.power_switch() == PowerSwitch::nobody) {
            throw CaseSkipped{
                "in this run, nobody can switch the slave off and on (on a bus, --by-hand lets you do it)"};
        }
        if (cycle) {
            target.power(false);
            context.link.wait(off_time);
            context.link.forget();
        }
        target.power(cycle || on);
        if (cycle) {
            want_boot_up(context);
        }
    };
}

}  // namespace

std::vector<Verb> nmt_verbs() {
    return {{"nmt", parse_nmt}, {"reset", parse_reset}, {"power", parse_power}};
}

}  // namespace canproof::host::conform
