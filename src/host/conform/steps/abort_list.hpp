// SPDX-License-Identifier: Apache-2.0
// Abort codes that a step accepts: a list such as `06010000|06010002`, or `any`.
#pragma once

#include <cstdint>
#include <vector>

#include "host/conform/language/scanner.hpp"

namespace canproof::host::conform {

class AbortList {
  public:
    static AbortList parse(Scanner& line);

    /// Throws SlaveFailed for a code that is not in the list.
    void want(std::uint32_t code) const;

  private:
    std::vector<std::uint32_t> codes_;  ///< accepted codes; empty: any code
};

}  // namespace canproof::host::conform
