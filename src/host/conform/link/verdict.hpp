// How a case ends other than by its last step, and what is noted on the way.
#pragma once

#include <cstdint>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include "host/conform/link/measured.hpp"

namespace canproof::host::conform {

/// The slave does not do what the case asks for.
class SlaveFailed : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// The slave does not answer at all.
class NoAnswer : public SlaveFailed {
  public:
    using SlaveFailed::SlaveFailed;
};

/// The case does not apply, for this reason.
class CaseSkipped : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// What a case measures and says.
struct Journal {
    std::map<std::string, Measured> times;  ///< by what was measured
    std::vector<std::string> notes;
    std::uint64_t judged{0};  ///< how often the slave could have failed
};

}  // namespace canproof::host::conform
