// SPDX-License-Identifier: Apache-2.0
#include "host/conform/steps/parse_steps.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "host/base/trimmed.hpp"
#include "host/conform/steps/flow_steps.hpp"
#include "host/conform/steps/frame_steps.hpp"
#include "host/conform/steps/lss_steps.hpp"
#include "host/conform/steps/nmt_steps.hpp"
#include "host/conform/steps/sdo_steps.hpp"
#include "host/conform/steps/time_steps.hpp"

namespace canproof::host::conform {

namespace {

constexpr unsigned deepest_block = 16;

/// Returns the line without its comment. A comment starts at a `#` outside quotes.
std::string without_comment(const std::string& text) {
    bool quoted = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        quoted = quoted != (text[i] == '"');
        if (text[i] == '#' && !quoted) {
            return text.substr(0, i);
        }
    }
    return text;
}

const std::vector<Verb>& verbs() {
    static const std::vector<Verb> all = [] {
        std::vector<Verb> every;
        for (const std::vector<Verb>& group :
             {frame_verbs(), time_verbs(), sdo_verbs(), nmt_verbs(), lss_verbs(), flow_verbs()}) {
            every.insert(every.end(), group.begin(), group.end());
        }
        return every;
    }();
    return all;
}

std::string verb_words() {
    std::string text;
    for (const Verb& one : verbs()) {
        text += (text.empty() ? "" : ", ") + std::string{one.word};
    }
    return text;
}

}  // namespace

StepSource::StepSource(const std::string& text, const Place& first) : file_{first.file}, closing_{"", first} {
    unsigned number = first.line;
    std::size_t start = 0;
    while (start <= text.size()) {
        const std::size_t end = std::min(text.find('\n', start), text.size());
        const std::string line = trimmed(without_comment(text.substr(start, end - start)), " \t\r");
        if (!line.empty()) {
            lines_.push_back({line, number});
        }
        ++number;
        start = end + 1;
    }
}

Step StepSource::parse_line(Scanner& line) {
    const std::string word = line.word(true);
    const auto verb = std::find_if(verbs().begin(), verbs().end(), [&](const Verb& one) { return word == one.word; });
    if (verb == verbs().end()) {
        line.fail(fmt::format("`{}` is no step", word.empty() ? line.rest() : word),
                  "begin with one of " + verb_words());
    }
    Step step;
    step.text = line.line();
    step.line = line.place().line;
    step.run = verb->parse(line, *this);
    return step;
}

Steps StepSource::block(bool inner) {
    Steps steps;
    while (next_ < lines_.size()) {
        Scanner line{lines_[next_].text, {file_, lines_[next_].number}};
        ++next_;
        if (line.take("}")) {
            if (!inner) {
                line.fail("there is no block to close", "leave the `}` out");
            }
            closing_ = line;
            return steps;
        }
        steps.push_back(parse_line(line));
    }
    if (inner) {
        closing_.fail("a block has no end", "close it with `}`");
    }
    return steps;
}

Steps StepSource::block_of(Scanner& line) {
    line.want("{", "end the line with `{`");
    line.finish();
    if (++depth_ > deepest_block) {
        line.fail(fmt::format("blocks are nested more than {} deep", deepest_block),
                  "move the inner blocks to a procedure");
    }
    closing_ = line;
    Steps steps = block(true);
    --depth_;
    return steps;
}

void run_steps(const Steps& steps, Context& context) {
    for (const Step& one : steps) {
        context.at = &one;
        one.run(context);
    }
}

}  // namespace canproof::host::conform
