// SPDX-License-Identifier: Apache-2.0
// The `diff` command: prints which items of the requirements register, code and tests the changes since a revision
// affect.
#include "host/app/cli/diff_command.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "host/app/cli/sound_register.hpp"
#include "host/assess/change/impact.hpp"
#include "host/assess/change/revision.hpp"
#include "host/assess/trace/evidence.hpp"
#include "host/register/embedded_spec.hpp"
#include "host/register/load.hpp"
#include "host/register/spec_files.hpp"

namespace canproof::host {

int diff(const DiffOptions& options) {
    const std::filesystem::path root{options.root};
    const LoadResult before = load_register(with_shared_rules(spec_files_at(root, options.revision), embedded_spec()));
    const Register after = sound_register(root / "spec");
    const auto verdicts = options.verdicts.empty() ? newest_verdicts(root) : std::filesystem::path{options.verdicts};
    const Evidence evidence = collect_evidence(root, verdicts, after, WorkDetail::parts);
    Impact impact;
    impact.items = compare(before.content, after);
    impact.files = files_changed_since(root, options.revision, {"src", "tests", "properties", "fuzz"});
    impact.stale = work_changes(work_at(root, options.revision, verdicts, after, evidence.work), evidence.work);
    if (!options.old_verdicts.empty()) {
        impact.verdicts = verdict_changes(read_verdict_files(options.old_verdicts), evidence);
    }
    fmt::print("{}", options.json ? impact_json(impact) : write_impact(impact, after, evidence));
    const bool worse = std::any_of(impact.verdicts.begin(), impact.verdicts.end(),
                                   [](const VerdictChange& one) { return one.before == "passed"; });
    return worse || (options.exit_code && !impact.empty()) ? 1 : 0;
}

}  // namespace canproof::host
