// The steps of a case, from text.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "host/conform/language/scanner.hpp"
#include "host/conform/steps/step.hpp"

namespace canproof::host::conform {

/// The lines that are still to be read.
class StepSource {
  public:
    /// `first` is the place of the first line of `text`.
    StepSource(const std::string& text, const Place& first);

    /// Steps up to the `}` of the block, which is left behind; up to the end of the text for the outermost.
    Steps block(bool inner);
    /// Behind the `}` of block(): whether `else` follows on its line, and what.
    Scanner& closing() { return closing_; }
    /// Wants `{` at the end of the line, and reads the block.
    Steps block_of(Scanner& line);

    /// Procedures that the steps call, with the place of the call and the number of arguments.
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

/// A verb: reads the rest of its line, and its block where it has one.
using VerbParser = Action (*)(Scanner& line, StepSource& source);

struct Verb {
    const char* word;
    VerbParser parse;
};

}  // namespace canproof::host::conform
