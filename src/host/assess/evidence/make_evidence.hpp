// SPDX-License-Identifier: Apache-2.0
// Creates the evidence that a complete pack needs and that is missing.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "host/assess/evidence/argument.hpp"
#include "host/assess/evidence/own_exhibits.hpp"

namespace canproof::host {

/// Returns the expected evidence that is absent or stale and that a command can create, in the order of the argument.
/// When the results of the tests are absent or stale, also returns coverage, because the coverage run writes the
/// results of the tests.
std::vector<ExpectedEvidence> makeable(const Argument& argument, const Exhibits& exhibits);

/// Runs each command in a shell in `root` and writes its output to build/log/evidence-KEY.log. After a failed command,
/// reports it and continues with the next. `tell` receives lines with progress and an estimate of the time. Returns the
/// number of failed commands. Throws InputError while another run, or a command that outlived its run, still works in
/// `root`.
std::size_t make_evidence(const std::vector<ExpectedEvidence>& wanted, const std::filesystem::path& root,
                          const std::function<void(const std::string&)>& tell);

}  // namespace canproof::host
