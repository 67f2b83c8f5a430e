// SPDX-License-Identifier: Apache-2.0
// Parses the steps of a conformance case.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "host/conform/language/scanner.hpp"
#include "host/conform/steps/step.hpp"

namespace canproof::host::conform {

/// The lines of a case that are not parsed yet.
class StepSource {
  public:
    /// Splits `text` into lines. `first` is the place of its first line.
    StepSource(const std::string& text, const Place& first);

    /// Parses the steps of a block. An inner block ends with `}`, which is skipped; the outermost block ends with the
    /// text.
    Steps block(bool inner);
    /// Returns the text after the `}` that ended the block which block() parsed last. This text may begin with `else`.
    Scanner& closing() { return closing_; }
    /// Requires `{` at the end of the line. Parses and returns the block that follows.
    Steps block_of(Scanner& line);

    /// A call of a procedure: its name, the place of the call and the number of arguments.
    struct Call {
        std::string name;
        std::size_t arguments;
        Place place;
    };
    std::vector<Call> calls;

  private:
    struct Line {
        std::string text;
        unsigned number;
    };
    Step parse_line(Scanner& line);

    std::string file_;
    std::vector<Line> lines_;
    std::size_t next_{0};
    Scanner closing_;
    unsigned depth_{0};
};

/// Parses the line of a step after its first word (the verb), and its block if it has one.
using VerbParser = Action (*)(Scanner& line, StepSource& source);

struct Verb {
    const char* word;
    VerbParser parse;
};

}  // namespace canproof::host::conform
