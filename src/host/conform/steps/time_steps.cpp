// SPDX-License-Identifier: Apache-2.0
#include "host/conform/steps/time_steps.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <numeric>

#include "host/conform/steps/frame_spec.hpp"

namespace canproof::host::conform {

namespace {

constexpr std::uint64_t patience = 3;  // a step waits three times as long as the expected frames take
constexpr Duration grace = milliseconds(1000);

/// Collects frames (a watch) until the step ends. The destructor ends the watch, also after an exception.
class EndingWatch {
  public:
    EndingWatch(Context& context, Watched wanted) : link_{context.link}, watched_{link_.watch(std::move(wanted))} {}
    ~EndingWatch() { link_.end_watch(watched_); }
    EndingWatch(const EndingWatch&) = delete;
    EndingWatch& operator=(const EndingWatch&) = delete;
    const Watched& operator*() const { return *watched_; }
    const Watched* operator->() const { return watched_.get(); }

  private:
    Link& link_;
    std::shared_ptr<const Watched> watched_;
};

/// The tolerance of an expected number: absolute as in `+- 1`, or in per cent as in `+- 5 %`.
struct Tolerance {
    Expression amount;
    bool percent{false};

    double of(double value, const Scope& scope) const {
        if (!amount) {
            return 0.0;
        }
        const auto given = static_cast<double>(number_of(amount(scope)));
        return percent ? std::abs(value) * given / 100.0 : given;
    }
};

Tolerance parse_tolerance(Scanner& line) {
    Tolerance tolerance;
    tolerance.amount = parse_operand(line, Radix::decimal);
    tolerance.percent = line.take("%");
    return tolerance;
}

/// A kind of frame, with the data that such a frame must have.
struct KeyAndData {
    FrameKey key;
    DataPattern data;

    bool fits(const FrameRecord& record) const {
        Captures none;
        return key.fits(record.frame) && data.matches(Scope{}, data_of(record.frame), none);
    }
};

/// Returns a watch for the frames that fit one of `specs`; without specs, for all frames except the tester's own.
Watched watched_of(const std::vector<FrameSpec>& specs, const Context& context) {
    Watched wanted;
    std::vector<KeyAndData> patterns;
    for (const FrameSpec& spec : specs) {
        wanted.keys.push_back(spec.key(*context.scope));
        // Inserts the present values of the variables, because a watch can last longer than its scope, for example
        // that of a procedure.
        patterns.push_back(
            {wanted.keys.back(), spec.any_data ? DataPattern::any() : spec.data.with_values_of(*context.scope)});
    }
    if (!specs.empty()) {
        wanted.counts = [patterns](const FrameRecord& record) {
            return std::any_of(patterns.begin(), patterns.end(),
                               [&](const KeyAndData& one) { return one.fits(record); });
        };
    }
    return wanted;
}

Action parse_silence(Scanner& line, StepSource&) {
    std::vector<FrameSpec> specs;
    const bool all = line.take_word("all");
    if (!all) {
        do {
            specs.push_back(parse_frame_spec(line));
        } while (line.take(","));
    }
    if (!line.take_word("for")) {
        line.fail("a time is missing", "write silence 580+N for 500 ms");
    }
    const Expression time = parse_sum(line);
    line.finish();
    return [specs, time](Context& context) {
        const EndingWatch seen{context, watched_of(specs, context)};
        const Instant end = context.link.now() + Duration{microseconds_of(time, *context.scope)};
        ++context.journal.judged;
        if (context.link.wait_for([&] { return !seen->frames.empty(); }, end)) {
            const Frame& frame = seen->frames.front().frame;
            const Bytes data = data_of(frame);
            throw SlaveFailed{fmt::format("{} came with {}, where nothing may come",
                                          words_of(FrameKey{frame.id, frame.extended, frame.remote}),
                                          data.empty() ? "no data" : hex_words(data))};
        }
    };
}

Action parse_count(Scanner& line, StepSource&) {
    const FrameSpec spec = parse_frame_spec(line);
    if (!line.take_word("for")) {
        line.fail("a time is missing", "write count 180+N for 10 s = 100 +- 1");
    }
    const Expression time = parse_sum(line);
    const bool at_least = line.take(">=");
    const bool at_most = !at_least && line.take("<=");
    if (!at_least && !at_most) {
        line.want("=", "write `= 100 +- 1`, `>= 5` or `<= 5` after the time");
    }
    const Expression number = parse_expression(line, Radix::decimal);
    const Tolerance tolerance = line.take("+-") ? parse_tolerance(line) : Tolerance{};
    line.finish();
    return [=](Context& context) {
        const EndingWatch seen{context, watched_of({spec}, context)};
        context.link.wait(Duration{microseconds_of(time, *context.scope)});
        const auto wanted = static_cast<double>(number_of(number(*context.scope)));
        const auto count = static_cast<double>(seen->frames.size());
        const double off = tolerance.of(wanted, *context.scope);
        ++context.journal.judged;
        context.journal.times["gap of " + words_of(spec.key(*context.scope))] = {seen->gaps(), {}, {}};
        const bool too_few = !at_most && count < wanted - off;
        const bool too_many = !at_least && count > wanted + off;
        if (too_few || too_many) {
            throw SlaveFailed{fmt::format("{} frames of {} came where the case wants {}{}{}", seen->frames.size(),
                                          words_of(spec.key(*context.scope)),
                                          at_least  ? "at least "
                                          : at_most ? "at most "
                                                    : "",
                                          wanted, off > 0.0 ? fmt::format(" ± {}", off) : "")};
        }
    };
}

struct PeriodSpec {
    FrameSpec frame;
    Expression mean;
    Tolerance tolerance;
    Expression shortest;
    Expression longest;
    Expression gaps;
    Tolerance jitter;
};

std::string ms(double us) {
    return fmt::format("{:.3f} ms", us / 1000.0);
}

/// Returns the times between the frames, with the limits that the step sets for them.
Measured measured_gaps(const PeriodSpec& spec, const std::vector<std::uint64_t>& gaps, const Scope& scope) {
    Measured measured{gaps, {}, {}};
    TimeLimits each{0.0, std::numeric_limits<double>::infinity()};
    if (spec.mean) {
        const auto wanted = static_cast<double>(number_of(spec.mean(scope)));
        const double off = spec.tolerance.of(wanted, scope);
        measured.of_mean = TimeLimits{wanted - off, wanted + off};
        if (spec.jitter.amount) {
            const double jitter = spec.jitter.of(wanted, scope);
            each = {wanted - jitter, wanted + jitter};
        }
    }
    if (spec.shortest) {
        each.least = std::max(each.least, static_cast<double>(number_of(spec.shortest(scope))));
    }
    if (spec.longest) {
        each.most = std::min(each.most, static_cast<double>(number_of(spec.longest(scope))));
    }
    if (spec.jitter.amount || spec.shortest || spec.longest) {
        measured.of_each = each;
    }
    return measured;
}

void judge_gaps(const Measured& measured) {
    const std::vector<std::uint64_t>& gaps = measured.times;
    if (measured.of_mean) {
        const auto [least, most] = *measured.of_mean;
        const double mean = static_cast<double>(std::accumulate(gaps.begin(), gaps.end(), std::uint64_t{0})) /
                            static_cast<double>(gaps.size());
        if (mean < least || mean > most) {
            throw SlaveFailed{fmt::format("the mean period is {} where the case wants {} ± {}", ms(mean),
                                          ms((least + most) / 2.0), ms((most - least) / 2.0))};
        }
    }
    if (measured.of_each) {
        const auto [low, high] = std::minmax_element(gaps.begin(), gaps.end());
        if (const auto shortest = static_cast<double>(*low); shortest < measured.of_each->least) {
            throw SlaveFailed{fmt::format("the time between two frames is {}, but must be at least {}", ms(shortest),
                                          ms(measured.of_each->least))};
        }
        if (const auto longest = static_cast<double>(*high); longest > measured.of_each->most) {
            throw SlaveFailed{fmt::format("the time between two frames is {}, but must be at most {}", ms(longest),
                                          ms(measured.of_each->most))};
        }
    }
}

void run_period(const PeriodSpec& spec, Context& context) {
    const std::string name = words_of(spec.frame.key(*context.scope));
    const EndingWatch seen{context, watched_of({spec.frame}, context)};
    const std::int64_t gaps = number_of(spec.gaps(*context.scope));
    if (gaps < 1) {
        throw BrokenCase{"the number of periods after `over` is below 1; write `over 1` or more"};
    }
    const Expression& longest = spec.mean ? spec.mean : spec.longest ? spec.longest : spec.shortest;
    const std::uint64_t expected = microseconds_of(longest, *context.scope) * static_cast<std::uint64_t>(gaps + 1);
    const auto wanted = static_cast<std::size_t>(gaps) + 1;
    const Instant deadline = context.link.now() + Duration{expected * patience} + grace;
    const bool all = context.link.wait_for([&] { return seen->frames.size() >= wanted; }, deadline);
    const Measured measured = measured_gaps(spec, seen->gaps(), *context.scope);
    context.journal.times["gap of " + name] = measured;
    ++context.journal.judged;
    if (!all) {
        throw SlaveFailed{fmt::format("{} came {} times within {}, where the case wants {} frames", name,
                                      seen->frames.size(), ms(static_cast<double>(expected * patience + grace.us)),
                                      wanted)};
    }
    judge_gaps(measured);
}

Action parse_period(Scanner& line, StepSource&) {
    PeriodSpec spec;
    spec.frame = parse_frame_spec(line);
    while (!line.at_end()) {
        if (line.take("=")) {
            spec.mean = parse_operand(line, Radix::decimal);
            line.want("+-", "give the tolerance: = 100 ms +- 5 %");
            spec.tolerance = parse_tolerance(line);
        } else if (line.take_word("min")) {
            spec.shortest = parse_operand(line, Radix::decimal);
        } else if (line.take_word("max")) {
            spec.longest = parse_operand(line, Radix::decimal);
        } else if (line.take_word("over")) {
            spec.gaps = parse_operand(line, Radix::decimal);
        } else if (line.take_word("jitter")) {
            spec.jitter = parse_tolerance(line);
        } else {
            line.fail(fmt::format("`{}` is no option of a period", line.rest()),
                      "write period 700+N = 100 ms +- 5 % over 20 jitter 10 %");
        }
    }
    if (!spec.gaps || (!spec.mean && !spec.shortest && !spec.longest)) {
        line.fail("the period, or the number of periods after `over`, is missing",
                  "write period 700+N = 100 ms +- 5 % over 20");
    }
    return [spec](Context& context) { run_period(spec, context); };
}

std::optional<Value> field_of(const Watched& seen, const std::string& field) {
    const std::vector<std::uint64_t> gaps = seen.gaps();
    const auto number = [](std::uint64_t value) { return Value{static_cast<std::int64_t>(value)}; };
    if (field == "count") {
        return number(seen.frames.size());
    }
    if (field == "data" && !seen.frames.empty()) {
        return Value{data_of(seen.frames.back().frame)};
    }
    if (field == "first" && !seen.frames.empty()) {
        return number(elapsed(seen.since, seen.frames.front().time).us);
    }
    if (field == "last" && !seen.frames.empty()) {
        return number(elapsed(seen.since, seen.frames.back().time).us);
    }
    if (field == "mean" && !gaps.empty()) {
        return number(std::accumulate(gaps.begin(), gaps.end(), std::uint64_t{0}) / gaps.size());
    }
    if (field == "min" && !gaps.empty()) {
        return number(*std::min_element(gaps.begin(), gaps.end()));
    }
    if (field == "max" && !gaps.empty()) {
        return number(*std::max_element(gaps.begin(), gaps.end()));
    }
    const bool known =
        field == "data" || field == "first" || field == "last" || field == "mean" || field == "min" || field == "max";
    return known ? throw SlaveFailed{fmt::format("too few frames came to determine `{}`", field)}
                 : std::optional<Value>{};
}

Action parse_watch(Scanner& line, StepSource&) {
    const FrameSpec spec = parse_frame_spec(line);
    if (!line.take_word("as")) {
        line.fail("a name is missing", "write watch 700+N as hb");
    }
    const std::string name = parse_name(line);
    line.finish();
    return [spec, name](Context& context) {
        const std::shared_ptr<const Watched> seen = context.link.watch(watched_of({spec}, context));
        const auto before = context.watches.find(name);
        if (before != context.watches.end()) {
            context.link.end_watch(before->second);
        }
        context.watches[name] = seen;
        Value value;
        value.fields = [seen](const std::string& field) { return field_of(*seen, field); };
        context.scope->set(name, value);
    };
}

Action parse_end(Scanner& line, StepSource&) {
    const std::string name = parse_name(line);
    line.finish();
    return [name](Context& context) {
        const auto found = context.watches.find(name);
        if (found == context.watches.end()) {
            throw BrokenCase{fmt::format("nothing is watched as {0}; write `watch … as {0}` before this step", name)};
        }
        context.link.end_watch(found->second);
    };
}

}  // namespace

std::vector<Verb> time_verbs() {
    return {{"silence", parse_silence},
            {"count", parse_count},
            {"period", parse_period},
            {"watch", parse_watch},
            {"end", parse_end}};
}

}  // namespace canproof::host::conform
