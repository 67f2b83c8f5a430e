// SPDX-License-Identifier: Apache-2.0
#include "host/conform/steps/lss_steps.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <memory>

#include "host/conform/language/data_pattern.hpp"
#include "host/conform/language/expression.hpp"

namespace canproof::host::conform {

namespace {

constexpr std::uint32_t request_id = 0x7E5U;
constexpr std::uint32_t answer_id = 0x7E4U;
constexpr Duration answer_limit = milliseconds(1000);
// longest wait for an answer in a step of Fastscan; if none comes, no slave matches
constexpr Duration scan_limit = milliseconds(50);
constexpr std::array<const char*, 4> fields{"vendor", "product", "revision", "serial"};

void send_lss(Context& context, std::uint8_t command, const Bytes& data) {
    Frame frame = data_frame(request_id, max_frame_length);
    frame.data[0] = command;
    std::copy(data.begin(), data.end(), frame.data.begin() + 1);
    context.link.send(frame);
}

std::optional<Bytes> take_answer(Context& context, Duration within) {
    const auto record = context.link.take({answer_id, false, false}, context.link.now() + within);
    return record ? std::optional{data_of(record->frame)} : std::nullopt;
}

/// Waits for an LSS answer that begins with `command`. Throws SlaveFailed when another answer or no answer comes.
Bytes want_answer(Context& context, std::uint8_t command) {
    const auto answer = take_answer(context, answer_limit);
    if (!answer) {
        throw SlaveFailed{fmt::format("no LSS answer came within {} ms", answer_limit.us / 1000U)};
    }
    ++context.journal.judged;
    if (answer->size() != max_frame_length || answer->front() != command) {
        throw SlaveFailed{fmt::format("the LSS answer is {}; it must have 8 bytes and begin with {:02X}h",
                                      hex_words(*answer), command)};
    }
    return *answer;
}

Action parse_select(Scanner& line) {
    std::array<Expression, fields.size()> values;
    for (std::size_t i = 0; i < fields.size(); ++i) {
        values[i] = [name = fields[i]](const Scope& scope) { return *scope.find(name); };
    }
    bool other = false;
    while (!line.at_end()) {
        bool found = false;
        for (std::size_t i = 0; i < fields.size() && !found; ++i) {
            found = line.take_word(fields[i]);
            if (found) {
                values[i] = parse_expression(line, Radix::decimal);
                other = true;
            }
        }
        if (!found) {
            line.fail(fmt::format("`{}` is no field of the identity", line.rest()),
                      "use vendor, product, revision, serial");
        }
    }
    return [values, other](Context& context) {
        constexpr std::uint8_t first_command = 0x40;
        for (std::size_t i = 0; i < values.size(); ++i) {
            send_lss(context, static_cast<std::uint8_t>(first_command + i),
                     little_endian(number_of(values[i](*context.scope)), 4));
        }
        if (!other) {
            want_answer(context, 0x44U);
        }
    };
}

void send_scan(Context& context, std::uint32_t number, std::uint8_t bit, std::uint8_t sub, std::uint8_t next) {
    Bytes data = little_endian(number, 4);
    data.insert(data.end(), {bit, sub, next});
    send_lss(context, 0x51U, data);
}

bool scan_answered(Context& context) {
    const auto answer = take_answer(context, scan_limit);
    if (answer && (answer->size() != max_frame_length || answer->front() != 0x4FU)) {
        throw SlaveFailed{
            fmt::format("the answer to Fastscan is {}; it must have 8 bytes and begin with 4Fh", hex_words(*answer))};
    }
    return answer.has_value();
}

/// Performs a complete Fastscan, one bit per step. Returns the four numbers of the LSS address; nothing when no slave
/// answers or a number is not confirmed.
std::optional<std::array<std::uint32_t, 4>> scan(Context& context) {
    constexpr std::uint8_t begin = 0x80;
    send_scan(context, 0, begin, 0, 0);
    if (!scan_answered(context)) {
        return std::nullopt;
    }
    std::array<std::uint32_t, 4> identity{};
    for (std::uint8_t sub = 0; sub < identity.size(); ++sub) {
        std::uint32_t& number = identity[sub];
        for (std::uint8_t bit = 32; bit-- > 0;) {
            send_scan(context, number, bit, sub, sub);
            number |= scan_answered(context) ? 0U : 1U << bit;
        }
        send_scan(context, number, 0, sub, static_cast<std::uint8_t>((sub + 1U) % identity.size()));
        if (!scan_answered(context)) {
            return std::nullopt;
        }
    }
    return identity;
}

Action parse_scan(Scanner& line) {
    if (line.take_word("step")) {
        const Expression bit = parse_operand(line, Radix::decimal);
        const Expression sub = parse_operand(line, Radix::decimal);
        const Expression next = parse_operand(line, Radix::decimal);
        const Expression number = parse_operand(line, Radix::decimal);
        return [=](Context& context) {
            const Scope& scope = *context.scope;
            send_scan(context, static_cast<std::uint32_t>(number_of(number(scope))),
                      static_cast<std::uint8_t>(number_of(bit(scope))),
                      static_cast<std::uint8_t>(number_of(sub(scope))),
                      static_cast<std::uint8_t>(number_of(next(scope))));
        };
    }
    line.want("->", "write lss fastscan -> id, or lss fastscan step …");
    const std::string name = parse_name(line);
    return [name](Context& context) {
        const auto found = scan(context);
        ++context.journal.judged;
        Value value;
        value.fields = [found](const std::string& field) -> std::optional<Value> {
            if (field == "found") {
                return Value{std::int64_t{found.has_value()}};
            }
            for (std::size_t i = 0; i < fields.size(); ++i) {
                if (field == fields[i]) {
                    return Value{std::int64_t{found ? (*found)[i] : 0U}};
                }
            }
            return std::nullopt;
        };
        context.scope->set(name, value);
    };
}

Action parse_inquire(Scanner& line) {
    const Expression command = parse_operand(line, Radix::decimal);
    const std::string name = line.take("->") ? parse_name(line) : "";
    return [command, name](Context& context) {
        const auto byte = static_cast<std::uint8_t>(number_of(command(*context.scope)));
        send_lss(context, byte, {});
        const Bytes answer = want_answer(context, byte);
        constexpr std::uint8_t inquire_node_id = 0x5E;
        if (!name.empty()) {
            context.scope->set(name, Value{from_little_endian(answer, 1, byte == inquire_node_id ? 1 : 4)});
        }
    };
}

Action parse_lss(Scanner& line, StepSource&) {
    Action action;
    if (line.take_word("waiting")) {
        action = [](Context& context) { send_lss(context, 0x04U, {0x00U}); };
    } else if (line.take_word("configuration")) {
        action = [](Context& context) { send_lss(context, 0x04U, {0x01U}); };
    } else if (line.take_word("select")) {
        action = parse_select(line);
    } else if (line.take_word("fastscan")) {
        action = parse_scan(line);
    } else if (line.take_word("inquire")) {
        action = parse_inquire(line);
    } else {
        line.fail(fmt::format("`{}` is no LSS service", line.rest()),
                  "write lss waiting, configuration, select, fastscan or inquire");
    }
    line.finish();
    return action;
}

}  // namespace

std::vector<Verb> lss_verbs() {
    return {{"lss", parse_lss}};
}

}  // namespace canproof::host::conform
