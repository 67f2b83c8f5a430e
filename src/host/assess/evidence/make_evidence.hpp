// Makes what a whole pack needs and does not have.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "host/assess/evidence/argument.hpp"
#include "host/assess/evidence/own_exhibits.hpp"

namespace canproof::host {

/// The expected evidence with a command that is absent or stale, in the order of the argument. Coverage is made too
/// when the tests are stale: its run leaves their verdicts.
std::vector<ExpectedEvidence> makeable(const Argument& argument, const Exhibits& exhibits);

/// Runs each command in a shell in `root`, its output in build/log/evidence-KEY.log; what fails is told and the next
/// one begins. `tell` gets lines with progress and an estimate. Returns how many have failed.
std::size_t make_evidence(const std::vector<ExpectedEvidence>& wanted, const std::filesystem::path& root,
                          const std::function<void(const std::string&)>& tell);

}  // namespace canproof::host
