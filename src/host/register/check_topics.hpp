// Check of the answers that items give to one question.
#pragma once

#include "host/register/register.hpp"

namespace canproof::host {

/// Items that answer one question in two ways: in one folder, against a shared item, or in two devices of one maker.
void check_topics(const Register& content, Faults& faults);

}  // namespace canproof::host
