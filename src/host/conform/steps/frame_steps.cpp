// SPDX-License-Identifier: Apache-2.0
#include "host/conform/steps/frame_steps.hpp"

#include <fmt/format.h>

#include <memory>

#include "host/conform/language/object_reference.hpp"
#include "host/conform/steps/abort_list.hpp"
#include "host/conform/steps/frame_spec.hpp"

namespace canproof::host::conform {

namespace {

constexpr std::uint64_t usual_wait_us = 1000000;

/// Parses `within 2 s`. Returns 1 s when the line has no `within` here.
Expression parse_within(Scanner& line) {
    if (line.take_word("within")) {
        return parse_expression(line, Radix::decimal);
    }
    return [](const Scope&) { return Value{std::int64_t{usual_wait_us}}; };
}

/// Parses `-> name`. Returns an empty name when the line has no `->` here.
std::string parse_capture(Scanner& line) {
    return line.take("->") ? parse_name(line) : std::string{};
}

void want_remote_frames(Context& context, bool remote) {
    if (remote && !context.link.target().has_remote_frames()) {
        throw CaseSkipped{"this bus carries no remote frames"};
    }
}

Action parse_send(Scanner& line, StepSource&) {
    const FrameSpec spec = parse_frame_spec(line);
    line.finish();
    if (spec.any_data && !spec.remote) {
        line.fail("the frame has no data", "write a colon and its bytes: send 600+N: 40 00 10 00 ...; `080:` for none");
    }
    return [spec](Context& context) {
        want_remote_frames(context, spec.remote);
        context.link.send(spec.frame(*context.scope));
    };
}

std::string late(const FrameKey& key, std::uint64_t us) {
    return fmt::format("{} did not come within {} ms", words_of(key), static_cast<double>(us) / 1000.0);
}

[[noreturn]] void fail_late(const Context& context, const FrameKey& key, std::uint64_t us) {
    const std::uint32_t node = context.node();
    if (key.id == context.sdo.answer_key().id || key.id == 0x700U + node) {
        throw NoAnswer{late(key, us)};
    }
    throw SlaveFailed{late(key, us)};
}

Action parse_awaited(Scanner& line, bool passes_over) {
    const FrameSpec spec = parse_frame_spec(line);
    std::string name = parse_capture(line);
    const Expression within = parse_within(line);
    name = name.empty() ? parse_capture(line) : name;
    line.finish();
    return [spec, name, within, passes_over](Context& context) {
        const FrameKey key = spec.key(*context.scope);
        const std::uint64_t us = microseconds_of(within, *context.scope);
        const Instant start = context.link.now();
        const Instant deadline = start + Duration{us};
        std::string last;
        for (auto record = context.link.take(key, deadline); record; record = context.link.take(key, deadline)) {
            Captures captures;
            const Bytes data = data_of(record->frame);
            if (spec.data.matches(*context.scope, data, captures)) {
                ++context.journal.judged;
                context.journal.times["wait for " + words_of(key)].add(
                    elapsed(context.link.last_sent(), record->time).us, us);
                keep(context, *record, captures, name);
                return;
            }
            last = fmt::format("{} came with {}, which the step does not accept", words_of(key),
                               data.empty() ? "no data" : hex_words(data));
            if (!passes_over) {
                throw SlaveFailed{last};
            }
        }
        if (!last.empty()) {
            throw SlaveFailed{fmt::format("{}; the last frame was: {}", late(key, us), last)};
        }
        fail_late(context, key, us);
    };
}

Action parse_expect(Scanner& line, StepSource&) {
    return parse_awaited(line, false);
}

Action parse_await(Scanner& line, StepSource&) {
    return parse_awaited(line, true);
}

Action parse_sdo(Scanner& line, StepSource&) {
    const DataPattern data = DataPattern::parse(line);
    line.finish();
    return [data](Context& context) { context.sdo.send(data.to_send(*context.scope)); };
}

Action parse_answer(Scanner& line, StepSource&) {
    DataPattern data = DataPattern::parse(line);
    data.leave_rest_open();
    std::string name = parse_capture(line);
    const bool has_time = line.sees_word("within");
    const Expression within = parse_within(line);
    line.finish();
    return [data, name, within, has_time](Context& context) {
        const Duration time = has_time ? Duration{microseconds_of(within, *context.scope)} : context.sdo.timeout();
        const FrameRecord record = context.sdo.answer_frame(time);
        const Bytes bytes = data_of(record.frame);
        Captures captures;
        if (!data.matches(*context.scope, bytes, captures)) {
            const auto code = abort_code(bytes);
            throw SlaveFailed{fmt::format("the SDO server answered {}{}, which the step does not accept",
                                          hex_words(bytes), code ? fmt::format(" ({})", abort_words(*code)) : "")};
        }
        keep(context, record, captures, name);
    };
}

Action parse_abort(Scanner& line, StepSource&) {
    ObjectReference place;
    if (line.take("@")) {
        place = parse_object(line);
    }
    const AbortList codes = AbortList::parse(line);
    line.finish();
    return [place, codes](Context& context) {
        const Bytes bytes = context.sdo.answer();
        const auto code = abort_code(bytes);
        if (!code) {
            throw SlaveFailed{fmt::format("the SDO server answered {} instead of an abort", hex_words(bytes))};
        }
        codes.want(*code);
        if (place) {
            want_object(bytes, place(*context.scope), "the abort");
        }
    };
}

Action parse_clear(Scanner& line, StepSource&) {
    if (line.at_end()) {
        return [](Context& context) { context.link.forget(); };
    }
    const FrameSpec spec = parse_frame_id(line);
    line.finish();
    return [spec](Context& context) { context.link.forget(spec.key(*context.scope)); };
}

Action parse_produce(Scanner& line, StepSource&) {
    if (line.take_word("off")) {
        if (line.at_end()) {
            return [](Context& context) { context.link.stop_producing(); };
        }
        const FrameSpec spec = parse_frame_id(line);
        line.finish();
        return [spec](Context& context) { context.link.stop_producing(spec.key(*context.scope).id); };
    }
    const FrameSpec spec = parse_frame_spec(line);
    if (!line.take_word("every")) {
        line.fail("a period is missing", "write produce 700+$other: 05 every 500 ms");
    }
    const Expression period = parse_expression(line, Radix::decimal);
    line.finish();
    return [spec, period](Context& context) {
        want_remote_frames(context, spec.remote);
        const std::uint64_t us = microseconds_of(period, *context.scope);
        if (us == 0) {
            throw BrokenCase{"the period is 0; write a period such as 500 ms"};
        }
        context.link.produce(spec.frame(*context.scope), Duration{us});
    };
}

Action parse_traffic(Scanner& line, StepSource&) {
    if (line.take_word("off")) {
        line.finish();
        return [](Context& context) { context.link.set_traffic(0.0, false); };
    }
    const Expression percent = parse_operand(line, Radix::decimal);
    line.want("%", "write traffic 50 %");
    const bool high = line.take_word("high");
    line.finish();
    return [percent, high](Context& context) {
        context.link.set_traffic(static_cast<double>(number_of(percent(*context.scope))), high);
    };
}

Action parse_wait(Scanner& line, StepSource&) {
    const Expression time = parse_expression(line, Radix::decimal);
    line.finish();
    return [time](Context& context) { context.link.wait(Duration{microseconds_of(time, *context.scope)}); };
}

}  // namespace

std::vector<Verb> frame_verbs() {
    return {{"send", parse_send},       {"expect", parse_expect}, {"await", parse_await}, {"sdo", parse_sdo},
            {"answer", parse_answer},   {"abort", parse_abort},   {"clear", parse_clear}, {"produce", parse_produce},
            {"traffic", parse_traffic}, {"wait", parse_wait}};
}

}  // namespace canproof::host::conform
