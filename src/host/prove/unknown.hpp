// Why a theorem stays undecided.
#pragma once

#include <stdexcept>

namespace canproof::host::prove {

/// Something that the prover does not model, or a bound that it reached: names the function and the source line. The
/// theorem is unknown then, never proven.
class Unknown : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

}  // namespace canproof::host::prove
