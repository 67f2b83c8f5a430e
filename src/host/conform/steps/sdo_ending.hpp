// How a transfer of a step must end, and what it writes.
#pragma once

#include <optional>
#include <string>

#include "host/conform/language/expression.hpp"
#include "host/conform/steps/abort_list.hpp"
#include "host/conform/steps/step.hpp"

namespace canproof::host::conform {

/// How a transfer must end.
struct Ending {
    bool any{false};                 ///< `try`
    std::optional<AbortList> fails;  ///< nothing: it must succeed
    std::string name;                ///< behind `->`
    Expression value;                ///< behind `=` of a read

    /// Reads `fails …` or `-> name`. False when neither follows.
    bool take(Scanner& line);
    /// Throws SlaveFailed when the transfer ended otherwise; keeps its value.
    void judge(const SdoOutcome& outcome, const ObjectPlace& place, Context& context) const;
};

/// What is written: the bytes given, or a number `width` bytes wide; 0: as wide as the data sheet says. Throws
/// BrokenCase.
Bytes bytes_to_write(const Value& value, std::size_t width, const ObjectPlace& place, const Context& context);

}  // namespace canproof::host::conform
