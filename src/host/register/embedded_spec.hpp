// The register as it stood when the program was built, without decisions and reviews.
#pragma once

#include "host/register/spec_files.hpp"

namespace canproof::host {

const SpecFiles& embedded_spec();

}  // namespace canproof::host
