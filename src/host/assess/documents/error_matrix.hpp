// Each error with its codes and lamps, and the requirements that name it.
#pragma once

#include "host/assess/documents/analysis.hpp"
#include "host/assess/documents/document.hpp"
#include "host/register/register.hpp"

namespace canproof::host {

/// Each error with its codes, lamps, and the requirements that name it.
Document error_matrix(const Register& content, const Part& part, const Analysis& analysis);

}  // namespace canproof::host
