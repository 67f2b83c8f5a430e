// The pages of the pack that follow the register and the verdicts. Each gives the markup of its body.
#pragma once

#include <string>

#include "host/assess/evidence/pack_input.hpp"

namespace canproof::host {

/// Each item of the register with its sources, code, tests and state, to be searched.
std::string audit_page(const PackInput& input);
/// Each manual with its page, what is covered of it, and the sections of those without statements.
std::string sections_page(const PackInput& input);
std::string decisions_page(const PackInput& input);
std::string tests_page(const PackInput& input);
/// The plots of the devices' behaviour.
std::string plots_page(const PackInput& input);

}  // namespace canproof::host
