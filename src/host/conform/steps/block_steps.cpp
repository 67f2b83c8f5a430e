// SPDX-License-Identifier: Apache-2.0
#include "host/conform/steps/block_steps.hpp"

#include <fmt/format.h>

#include <cctype>
#include <limits>

#include "host/conform/steps/sdo_ending.hpp"

namespace canproof::host::conform {

namespace {

/// An optional number, which is computed when the step runs.
struct Option {
    Expression value;

    explicit operator bool() const { return static_cast<bool>(value); }
    template <typename Number>
    Number of(const Scope& scope) const {
        const std::int64_t number = number_of(value(scope));
        constexpr std::uint64_t most = std::numeric_limits<Number>::max();
        if (number < 0 || static_cast<std::uint64_t>(number) > most) {
            throw BrokenCase{fmt::format("{} is out of range; write 0 to {}", number, most)};
        }
        return static_cast<Number>(number);
    }
};

Option parse_option(Scanner& line) {
    return {parse_operand(line, Radix::decimal)};
}

struct ReadOptions {
    std::vector<Option> block_sizes;
    bool crc{false};
    Option switch_size;
    Option short_ack;
    Option break_after;

    bool take(Scanner& line) {
        if (line.take_word("blksizes") || line.take_word("blksize")) {
            do {
                block_sizes.push_back(parse_option(line));
            } while (std::isdigit(static_cast<unsigned char>(line.peek())) != 0 || line.peek() == '$');
        } else if (line.take_word("crc")) {
            crc = true;
        } else if (line.take_word("pst")) {
            switch_size = parse_option(line);
        } else if (line.take_word("ack")) {
            short_ack = parse_option(line);
            line.take_word("once");
        } else if (line.take_word("break")) {
            line.take_word("after");
            break_after = parse_option(line);
        } else {
            return false;
        }
        return true;
    }

    BlockRead of(const Scope& scope) const {
        BlockRead how;
        how.crc = crc;
        if (!block_sizes.empty()) {
            how.block_sizes.clear();
        }
        for (const Option& one : block_sizes) {
            how.block_sizes.push_back(one.of<std::uint8_t>(scope));
        }
        if (switch_size) {
            how.switch_size = switch_size.of<std::uint8_t>(scope);
        }
        if (short_ack) {
            how.short_ack = short_ack.of<std::uint8_t>(scope);
        }
        if (break_after) {
            how.break_after = break_after.of<std::uint32_t>(scope);
        }
        return how;
    }
};

struct WriteOptions {
    BlockWrite how;
    Option size;
    Option lose;
    Option repeat;
    Option padding;
    Option break_after;

    bool take(Scanner& line) {
        if (line.take_word("crc")) {
            how.crc = true;
        } else if (line.take_word("wrong")) {
            line.want("crc", "write `wrong crc`");
            how.wrong_crc = true;
        } else if (line.take_word("no")) {
            line.want("size", "write `no size`");
            how.without_size = true;
        } else if (line.take_word("size")) {
            size = parse_option(line);
        } else if (line.take_word("lose")) {
            how.lose_last = line.take_word("last");
            lose = how.lose_last ? Option{} : parse_option(line);
        } else if (line.take_word("repeat")) {
            repeat = parse_option(line);
        } else if (line.take_word("padding")) {
            padding = {parse_operand(line, Radix::hexadecimal)};
        } else if (line.take_word("break")) {
            line.take_word("after");
            break_after = parse_option(line);
        } else {
            return false;
        }
        return true;
    }

    BlockWrite of(const Scope& scope) const {
        BlockWrite all = how;
        if (size) {
            all.size = size.of<std::uint32_t>(scope);
        }
        if (lose) {
            all.lose = lose.of<unsigned>(scope);
        }
        if (repeat) {
            all.repeat = repeat.of<unsigned>(scope);
        }
        if (padding) {
            all.padding = padding.of<std::uint8_t>(scope);
        }
        if (break_after) {
            all.break_after = break_after.of<std::uint32_t>(scope);
        }
        return all;
    }
};

template <typename Options>
void parse_options(Scanner& line, Options& options, Ending& ending, const char* known) {
    while (!line.at_end()) {
        if (!options.take(line) && !ending.take(line)) {
            line.fail(fmt::format("`{}` is no option of a block transfer", line.rest()), known);
        }
    }
}

Action parse_block_read(Scanner& line, Ending ending) {
    const ObjectReference object = parse_object(line);
    if (line.take("=")) {
        ending.value = parse_expression(line, Radix::decimal);
    }
    ReadOptions options;
    parse_options(line, options, ending,
                  "use blksize 1, blksizes 1 127, crc, pst 20, ack 3 once, break after 2, fails CODE, -> name");
    return [=](Context& context) {
        const ObjectPlace place = object(*context.scope);
        ending.judge(context.sdo.block_read(place, options.of(*context.scope)), place, context);
    };
}

Action parse_block_write(Scanner& line, Ending ending) {
    const ObjectReference object = parse_object(line);
    line.want("=", "write block write 1008:00 = pattern(100)");
    const Expression value = parse_expression(line, Radix::decimal);
    WriteOptions options;
    parse_options(line, options, ending,
                  "use crc, wrong crc, no size, size 9, lose 3, lose last, repeat 3, padding FF, break after 2, fails "
                  "CODE, -> name");
    return [=](Context& context) {
        const ObjectPlace place = object(*context.scope);
        const Bytes bytes = bytes_to_write(value(*context.scope), 0, place, context);
        ending.judge(context.sdo.block_write(place, bytes, options.of(*context.scope)), place, context);
    };
}

}  // namespace

Action parse_block(Scanner& line, bool any) {
    Ending ending;
    ending.any = any;
    if (line.take_word("read")) {
        return parse_block_read(line, ending);
    }
    if (line.take_word("write")) {
        return parse_block_write(line, ending);
    }
    line.fail("a direction is missing", "write block read or block write");
}

}  // namespace canproof::host::conform
