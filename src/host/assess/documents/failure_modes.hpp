// The skeleton of a software FMEA.
#pragma once

#include "host/assess/documents/analysis.hpp"
#include "host/assess/documents/document.hpp"
#include "host/register/register.hpp"

namespace canproof::host {

/// Signal and message by failure mode: detection, reaction, emergency code.
Document failure_modes(const Register& content, const Part& part, const Analysis& analysis);

}  // namespace canproof::host
