// SPDX-License-Identifier: Apache-2.0
#include "host/conform/steps/sdo_steps.hpp"

#include <fmt/format.h>

#include <array>

#include "host/conform/language/expression.hpp"
#include "host/conform/steps/block_steps.hpp"
#include "host/conform/steps/sdo_ending.hpp"

namespace canproof::host::conform {

namespace {

Action parse_read_as(Scanner& line, bool any) {
    const ObjectReference object = parse_object(line);
    Ending ending;
    ending.any = any;
    if (line.take("=")) {
        ending.value = parse_expression(line, Radix::decimal);
    }
    ending.take(line);
    line.finish();
    return [object, ending](Context& context) {
        const ObjectPlace place = object(*context.scope);
        ending.judge(context.sdo.read(place), place, context);
    };
}

/// Parses the word after `as`, the width of a number to write. Returns the width in bytes. Throws LanguageError for any
/// other word.
std::size_t parse_width(Scanner& line) {
    constexpr std::array<std::pair<const char*, std::size_t>, 5> widths{
        {{"u8", 1}, {"u16", 2}, {"u24", 3}, {"u32", 4}, {"u64", 8}}};
    for (const auto& [word, width] : widths) {
        if (line.take_word(word)) {
            return width;
        }
    }
    line.fail(fmt::format("`{}` is no width", line.rest()), "write `as u8`, `as u16`, `as u24`, `as u32` or `as u64`");
}

Transfer parse_transfer(Scanner& line) {
    constexpr std::array<std::pair<const char*, Transfer>, 3> ways{
        {{"expedited", Transfer::expedited}, {"segments", Transfer::segments}, {"block", Transfer::block}}};
    for (const auto& [word, way] : ways) {
        if (line.take_word(word)) {
            return way;
        }
    }
    line.fail(fmt::format("`{}` is no transfer", line.rest()), "write `by expedited`, `by segments` or `by block`");
}

Action parse_write_as(Scanner& line, bool any) {
    const ObjectReference object = parse_object(line);
    line.want("=", "write 1017:00 = 100");
    const Expression value = parse_expression(line, Radix::decimal);
    std::size_t width = 0;
    Transfer transfer = Transfer::automatic;
    Ending ending;
    ending.any = any;
    while (!line.at_end()) {
        if (line.take_word("as")) {
            width = parse_width(line);
        } else if (line.take_word("by")) {
            transfer = parse_transfer(line);
        } else if (!ending.take(line)) {
            line.fail(fmt::format("`{}` is no option of a write", line.rest()),
                      "write `as u16`, `by segments`, `fails CODE` or `-> name`");
        }
    }
    return [=](Context& context) {
        const ObjectPlace place = object(*context.scope);
        const Bytes bytes = bytes_to_write(value(*context.scope), width, place, context);
        ending.judge(context.sdo.write(place, bytes, transfer), place, context);
    };
}

Action parse_read(Scanner& line, StepSource&) {
    return parse_read_as(line, false);
}

Action parse_write(Scanner& line, StepSource&) {
    return parse_write_as(line, false);
}

Action parse_block_steps(Scanner& line, StepSource&) {
    return parse_block(line, false);
}

Action parse_try(Scanner& line, StepSource&) {
    if (line.take_word("read")) {
        return parse_read_as(line, true);
    }
    if (line.take_word("write")) {
        return parse_write_as(line, true);
    }
    if (line.take_word("block")) {
        return parse_block(line, true);
    }
    line.fail("a transfer is missing", "write try read, try write or try block");
}

}  // namespace

std::vector<Verb> sdo_verbs() {
    return {{"read", parse_read}, {"write", parse_write}, {"try", parse_try}, {"block", parse_block_steps}};
}

}  // namespace canproof::host::conform
