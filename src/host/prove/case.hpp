// SPDX-License-Identifier: Apache-2.0
// The cases of a theorem. A case is a sequence of numbers, one for each call of each() in the harness; next() counts it
// up like the digits of a number.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace canproof::host::prove {

/// One case of a theorem: the numbers that the calls of each() return in this case, in the order of the calls. In the
/// first case, all numbers are zero. next() selects the following case.
class Case {
  public:
    /// Returns the number that the call of each() at position `place` returns: 0 to `count` - 1.
    unsigned number(std::size_t place, unsigned count);
    /// Selects the next case. Returns false when this was the last one.
    bool next();
    /// Returns the numbers as text; empty when each() was not called.
    std::string text() const;

  private:
    struct Digit {
        unsigned number;
        unsigned count;
    };
    std::vector<Digit> digits_;
};

}  // namespace canproof::host::prove
