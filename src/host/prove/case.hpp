// SPDX-License-Identifier: Apache-2.0
// The cases of a theorem, counted as the digits of a number.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace canproof::host::prove {

/// One case of a theorem: the numbers that each() returns in it, in the order of the calls. The first case has zeros;
/// next() goes on to the following one.
class Case {
  public:
    /// Returns the number at `place`, which is below `count`.
    unsigned number(std::size_t place, unsigned count);
    /// Goes on to the next case. Returns false behind the last one.
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
