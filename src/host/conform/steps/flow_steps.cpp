// SPDX-License-Identifier: Apache-2.0
#include "host/conform/steps/flow_steps.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "host/base/cia301.hpp"
#include "host/conform/language/expression.hpp"
#include "host/conform/language/filter.hpp"
#include "host/datasheet/check/check_eds.hpp"

namespace canproof::host::conform {

namespace {

constexpr std::uint64_t most_turns = 100000;
constexpr unsigned deepest_call = 8;

std::string parse_text(Scanner& line) {
    const std::string text = line.quoted();
    line.finish();
    return text;
}

Action parse_let(Scanner& line, StepSource&) {
    const std::string name = parse_name(line);
    line.want("=", "write let x = 5");
    const Expression value = parse_expression(line, Radix::decimal);
    line.finish();
    return [name, value](Context& context) { context.scope->set(name, value(*context.scope)); };
}

Action parse_check(Scanner& line, StepSource&) {
    const Expression condition = parse_expression(line, Radix::decimal);
    const std::string text = parse_text(line);
    return [condition, text](Context& context) {
        ++context.journal.judged;
        if (number_of(condition(*context.scope)) == 0) {
            throw SlaveFailed{"this does not hold: " + text};
        }
    };
}

Action parse_skip(Scanner& line, StepSource&) {
    if (!line.take_word("unless")) {
        line.fail("a condition is missing", "write skip unless $x == 1 \"reason\"");
    }
    const Expression condition = parse_expression(line, Radix::decimal);
    const std::string text = parse_text(line);
    return [condition, text](Context& context) {
        if (number_of(condition(*context.scope)) == 0) {
            throw CaseSkipped{text};
        }
    };
}

Action parse_note(Scanner& line, StepSource&) {
    if (line.peek() == '"') {
        const std::string text = parse_text(line);
        return [text](Context& context) { context.journal.notes.push_back(text); };
    }
    const std::string words = line.line().substr(line.position());
    const Expression value = parse_expression(line, Radix::decimal);
    line.finish();
    return [words, value](Context& context) {
        context.journal.notes.push_back(words + " = " + words_of(value(*context.scope)));
    };
}

Action parse_fail(Scanner& line, StepSource&) {
    const std::string text = parse_text(line);
    return [text](Context&) { throw SlaveFailed{text}; };
}

std::string words_of(const EdsFinding& finding, const std::string& name) {
    return fmt::format("{}:{}: {} {}: {}; {} ({})", name, finding.line, to_text(finding.rule.severity), finding.rule.id,
                       finding.what, finding.fix, finding.rule.source);
}

/// Checks the data sheet with the rules of `canproof eds check`. Each finding becomes a note; an error also fails the
/// case. Skips the case for an XDD.
void check_data_sheet(Context& context) {
    const ConformSheet& sheet = context.sheet;
    if (sheet.ini.sections().empty()) {
        throw CaseSkipped{"the rules apply to an EDS, and this data sheet is an XDD"};
    }
    ++context.journal.judged;
    std::string first_error;
    std::size_t errors = 0;
    for (const EdsFinding& one : check_eds(sheet.text, std::filesystem::path{sheet.name}.filename().string())) {
        const std::string words = words_of(one, sheet.name);
        context.journal.notes.push_back(words);
        if (one.rule.severity == EdsSeverity::error && ++errors == 1) {
            first_error = words;
        }
    }
    if (errors > 0) {
        throw SlaveFailed{fmt::format("the data sheet has {} error(s); the first is: {}", errors, first_error)};
    }
}

Action parse_eds(Scanner& line, StepSource&) {
    line.want("check", "write eds check");
    line.finish();
    return [](Context& context) { check_data_sheet(context); };
}

Action parse_return(Scanner& line, StepSource&) {
    const Expression value =
        line.at_end() ? Expression{[](const Scope&) { return Value{}; }} : parse_expression(line, Radix::decimal);
    line.finish();
    return [value](Context& context) { throw Returned{value(*context.scope)}; };
}

Action parse_next(Scanner& line, StepSource&) {
    if (!line.take_word("unless")) {
        line.fail("a condition is missing", "write next unless $x == 1 \"reason\"");
    }
    const Expression condition = parse_expression(line, Radix::decimal);
    const std::string text = line.at_end() ? line.line() : parse_text(line);
    return [condition, text](Context& context) {
        if (number_of(condition(*context.scope)) == 0) {
            throw NextTurn{text};
        }
    };
}

/// Runs the iterations of a loop, and adds the name of the current iteration to messages. If all iterations are
/// skipped, the case is skipped.
class Turns {
  public:
    explicit Turns(Context& context) : context_{context}, depth_{context.turns.size()} {}

    /// Runs one iteration. `words` names the iteration in messages; an empty text adds no name. Throws BrokenCase when
    /// a loop begins more than most_turns iterations.
    void run(const Steps& steps, const std::string& words) {
        if (++begun_ > most_turns) {
            throw BrokenCase{fmt::format("the loop has more than {} iterations; let it end earlier", most_turns)};
        }
        if (!words.empty()) {
            context_.turns.push_back(words);
        }
        try {
            run_steps(steps, context_);
            ++done_;
        } catch (const NextTurn& left_out) {
            reason_ = left_out.reason;
        }
        context_.turns.resize(depth_);
    }
    /// Throws CaseSkipped when every iteration was skipped, with the reason of the last one. Uses `nothing` as the
    /// reason when there was no iteration.
    void finish(const std::string& nothing) const {
        if (done_ == 0) {
            throw CaseSkipped{begun_ == 0 ? nothing : reason_};
        }
    }

  private:
    Context& context_;
    std::size_t depth_;
    std::uint64_t begun_{0};
    std::uint64_t done_{0};
    std::string reason_;
};

Action parse_repeat(Scanner& line, StepSource& source) {
    const Expression count = parse_expression(line, Radix::decimal);
    const std::string name = line.take_word("as") ? parse_name(line) : "";
    const Steps steps = source.block_of(line);
    return [count, name, steps](Context& context) {
        Turns turns{context};
        const std::int64_t last = number_of(count(*context.scope));
        for (std::int64_t i = 1; i <= last; ++i) {
            if (!name.empty()) {
                context.scope->set(name, Value{i});
            }
            turns.run(steps, name.empty() ? "" : fmt::format("{} = {}", name, i));
        }
        turns.finish("the number of repetitions is 0 or negative");
    };
}

Action parse_for(Scanner& line, StepSource& source) {
    const std::string name = parse_name(line);
    if (!line.take_word("in")) {
        line.fail("the values are missing", "write for x in 1, 2, 127 {");
    }
    std::vector<Expression> values;
    do {
        values.push_back(parse_expression(line, Radix::decimal));
    } while (line.take(","));
    const Steps steps = source.block_of(line);
    return [name, values, steps](Context& context) {
        Turns turns{context};
        for (const Expression& one : values) {
            const Value value = one(*context.scope);
            context.scope->set(name, value);
            turns.run(steps, fmt::format("{} = {}", name, words_of(value)));
        }
        turns.finish("the step has no values");
    };
}

Action parse_while(Scanner& line, StepSource& source) {
    const Expression condition = parse_expression(line, Radix::decimal);
    const Steps steps = source.block_of(line);
    return [condition, steps](Context& context) {
        Turns turns{context};
        while (number_of(condition(*context.scope)) != 0) {
            turns.run(steps, "");
        }
    };
}

Action parse_if(Scanner& line, StepSource& source) {
    const Expression condition = parse_expression(line, Radix::decimal);
    const Steps steps = source.block_of(line);
    Steps otherwise;
    if (source.closing().take_word("else")) {
        Scanner behind = source.closing();
        if (behind.take_word("if")) {
            Step inner;
            inner.text = behind.line();
            inner.line = behind.place().line;
            inner.run = parse_if(behind, source);
            otherwise.push_back(inner);
        } else {
            otherwise = source.block_of(behind);
        }
    }
    if (otherwise.empty()) {
        source.closing().finish();
    }
    return [condition, steps, otherwise](Context& context) {
        run_steps(number_of(condition(*context.scope)) != 0 ? steps : otherwise, context);
    };
}

Action parse_choose(Scanner& line, StepSource&) {
    const std::string name = parse_name(line);
    line.want(":", "write choose E: writable, u16");
    const Filter filter = parse_filter(line, "");
    return [name, filter](Context& context) {
        const auto found = filter.select(context.sheet);
        if (found.empty()) {
            throw CaseSkipped{"the EDS has no entry that is " + filter.words};
        }
        context.scope->set(name, entry_value(context.sheet, found.front()));
    };
}

/// Returns a PDO as a variable with the fields number, comm (index of the communication parameters) and map (index of
/// the mapping).
Value pdo_value(unsigned number, bool transmit) {
    Value value{std::int64_t{number}};
    value.fields = [number, transmit](const std::string& field) -> std::optional<Value> {
        const std::int64_t offset = std::int64_t{number} - 1;
        return field == "number" ? std::optional{Value{std::int64_t{number}}}
               : field == "comm"
                   ? std::optional{Value{(transmit ? cia301::tpdo_communication : cia301::rpdo_communication) + offset}}
               : field == "map"
                   ? std::optional{Value{(transmit ? cia301::tpdo_mapping : cia301::rpdo_mapping) + offset}}
                   : std::nullopt;
    };
    return value;
}

Action parse_each_pdo(Scanner& line, StepSource& source, bool transmit) {
    if (!line.take_word("as")) {
        line.fail("a name is missing", "write each TPDO as P {");
    }
    const std::string name = parse_name(line);
    const Steps steps = source.block_of(line);
    return [name, steps, transmit](Context& context) {
        const char* const kind = transmit ? "TPDO" : "RPDO";
        Turns turns{context};
        for (const unsigned number : context.sheet.pdos(transmit)) {
            context.scope->set(name, pdo_value(number, transmit));
            turns.run(steps, fmt::format("{} {}", kind, number));
        }
        turns.finish(fmt::format("the EDS has no {}", kind));
    };
}

Action parse_each(Scanner& line, StepSource& source) {
    for (const bool transmit : {true, false}) {
        if (line.take_word(transmit ? "TPDO" : "RPDO")) {
            return parse_each_pdo(line, source, transmit);
        }
    }
    if (!line.take_word("entry")) {
        line.fail(fmt::format("`each` has no list `{}`", line.rest()),
                  "write each TPDO as P {, each RPDO as P { or each entry: FILTER as E {");
    }
    line.want(":", "write each entry: writable, u16 as E {");
    const Filter filter = parse_filter(line, " as ");
    const std::string name = parse_name(line);
    const Steps steps = source.block_of(line);
    return [name, filter, steps](Context& context) {
        Turns turns{context};
        for (const SheetEntry& one : filter.select(context.sheet)) {
            context.scope->set(name, entry_value(context.sheet, one));
            turns.run(steps, entry_words(one));
        }
        turns.finish("the EDS has no entry that is " + filter.words);
    };
}

Value call(const Procedure& procedure, const std::vector<Value>& given, Context& context) {
    if (++context.depth > deepest_call) {
        throw BrokenCase{
            fmt::format("calls of procedures are nested more than {} deep; reduce the nesting", deepest_call)};
    }
    Scope* const outer = context.scope;
    const std::size_t turns = context.turns.size();
    Scope own{outer};
    for (std::size_t i = 0; i < given.size(); ++i) {
        own.set(procedure.takes[i], given[i]);
    }
    context.scope = &own;
    Value value;
    try {
        run_steps(procedure.steps, context);
    } catch (const Returned& returned) {
        value = returned.value;
        context.turns.resize(turns);  // a `return` inside loops of the procedure also ends these loops
    } catch (...) {
        context.scope = outer;
        --context.depth;
        throw;
    }
    context.scope = outer;
    --context.depth;
    return value;
}

Action parse_do(Scanner& line, StepSource& source) {
    const std::string name = line.word(true);
    std::vector<Expression> given;
    while (!line.at_end() && !line.sees("->")) {
        given.push_back(parse_operand(line, Radix::decimal));
    }
    const std::string result = line.take("->") ? parse_name(line) : "";
    line.finish();
    source.calls.push_back({name, given.size(), line.place()});
    return [name, given, result](Context& context) {
        const Step* const at = context.at;
        std::vector<Value> values;
        for (const Expression& one : given) {
            values.push_back(one(*context.scope));
        }
        const Value value = call(context.procedures.at(name), values, context);
        context.at = at;
        if (!result.empty()) {
            context.scope->set(result, value);
        }
    };
}

}  // namespace

std::vector<Verb> flow_verbs() {
    return {{"let", parse_let},   {"check", parse_check},   {"skip", parse_skip}, {"note", parse_note},
            {"fail", parse_fail}, {"return", parse_return}, {"next", parse_next}, {"repeat", parse_repeat},
            {"for", parse_for},   {"while", parse_while},   {"if", parse_if},     {"choose", parse_choose},
            {"each", parse_each}, {"do", parse_do},         {"eds", parse_eds}};
}

}  // namespace canproof::host::conform
