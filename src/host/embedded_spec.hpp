// The register as it stood when the program was built.
#pragma once

#include "host/speccompiler/register.hpp"

namespace canproof::host {

const SpecFiles& embedded_spec();

}  // namespace canproof::host
