// SPDX-License-Identifier: Apache-2.0
#include "host/conform/steps/sdo_ending.hpp"

#include <fmt/format.h>

namespace canproof::host::conform {

namespace {

Value value_of(const SdoOutcome& outcome) {
    Value value{outcome.data};
    value.fields = [outcome](const std::string& field) -> std::optional<Value> {
        return field == "abort"      ? std::optional{Value{std::int64_t{outcome.abort}}}
               : field == "switched" ? std::optional{Value{std::int64_t{outcome.switched}}}
               : field == "blocks"   ? std::optional{Value{std::int64_t{outcome.blocks}}}
                                     : std::nullopt;
    };
    return value;
}

void judge_value(const SdoOutcome& outcome, const Value& wanted, const ObjectPlace& place) {
    const Bytes bytes = wanted.bytes ? *wanted.bytes : little_endian(wanted.number, outcome.data.size());
    const bool fits = wanted.bytes || outcome.data.size() >= 8 ||
                      same(Value{from_little_endian(bytes, 0, bytes.size())}, wanted) || wanted.number < 0;
    if (bytes != outcome.data || !fits) {
        throw SlaveFailed{fmt::format("a read of {} returned {} instead of {}", words_of(place),
                                      hex_words(outcome.data), words_of(wanted))};
    }
}

}  // namespace

bool Ending::take(Scanner& line) {
    if (line.take_word("fails")) {
        fails = AbortList::parse(line);
        return true;
    }
    if (line.take("->")) {
        name = parse_name(line);
        return true;
    }
    return false;
}

void Ending::judge(const SdoOutcome& outcome, const ObjectPlace& place, Context& context) const {
    if (fails) {
        if (outcome.abort == 0) {
            throw SlaveFailed{fmt::format("the transfer of {} was accepted, but must be refused", words_of(place))};
        }
        fails->want(outcome.abort);
    } else if (outcome.abort != 0 && !any) {
        throw SlaveFailed{fmt::format("the transfer of {} ended with {}", words_of(place), abort_words(outcome.abort))};
    }
    if (value) {
        judge_value(outcome, value(*context.scope), place);
    }
    if (!name.empty()) {
        context.scope->set(name, value_of(outcome));
    }
}

Bytes bytes_to_write(const Value& value, std::size_t width, const ObjectPlace& place, const Context& context) {
    if (width != 0) {
        return little_endian(number_of(value), width);
    }
    if (value.bytes) {
        return *value.bytes;
    }
    const SheetEntry known = context.sheet.find(place.index, place.subindex);
    const std::size_t size = known.entry == nullptr ? 0 : type_size(known.entry->type);
    if (size == 0) {
        throw BrokenCase{fmt::format(
            "the data sheet gives no fixed width for {}; write the value with its width in bytes, for example le(5, 2)",
            words_of(place))};
    }
    return little_endian(value.number, size);
}

}  // namespace canproof::host::conform
