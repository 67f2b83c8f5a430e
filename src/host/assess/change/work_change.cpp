// SPDX-License-Identifier: Apache-2.0
#include "host/assess/change/work_change.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <set>

#include "host/assess/trace/evidence.hpp"
#include "host/base/child_process.hpp"
#include "host/base/input_error.hpp"

namespace canproof::host {

namespace {

namespace fs = std::filesystem;

/// The sources of a git revision in a temporary folder, which the destructor removes.
class Checkout {
  public:
    Checkout(const fs::path& root, const std::string& revision)
        : folder_{fs::temp_directory_path() / "canproof-diff-XXXXXX"} {
        std::string name = folder_.string();
        if (mkdtemp(name.data()) == nullptr) {
            throw InputError{fmt::format("cannot make a folder in {}; make sure that it is writable and has free space",
                                         fs::temp_directory_path().string())};
        }
        folder_ = name;
        const auto done = output_of({"sh", "-c",
                                     "cd \"$1\" && git archive --output=\"$3/all.tar\" \"$2^{commit}\" -- . && "
                                     "tar -x -f \"$3/all.tar\" -C \"$3\" && rm \"$3/all.tar\"",
                                     "sh", root.string(), revision, name});
        if (!done) {
            remove();
            throw InputError{
                fmt::format("cannot extract the revision `{}` with git and tar; name a commit, branch or tag, install "
                            "both programs, or free space on the disk",
                            revision)};
        }
    }
    Checkout(const Checkout&) = delete;
    Checkout& operator=(const Checkout&) = delete;
    ~Checkout() { remove(); }

    const fs::path& folder() const { return folder_; }

  private:
    void remove() const {
        std::error_code ignored;
        fs::remove_all(folder_, ignored);
    }

    fs::path folder_;
};

const ItemWork& work_of(const std::string& id, const WorkByItem& all) {
    static const ItemWork none;
    const auto found = all.find(id);
    return found == all.end() ? none : found->second;
}

}  // namespace

std::vector<WorkChange> work_changes(const WorkByItem& before, const WorkByItem& after) {
    std::set<std::string> ids;
    for (const auto* all : {&before, &after}) {
        for (const auto& [id, work] : *all) {
            ids.insert(id);
        }
    }
    std::vector<WorkChange> changes;
    for (const auto& id : ids) {
        const ItemWork& was = work_of(id, before);
        const ItemWork& is = work_of(id, after);
        if (was.code != is.code || was.tests != is.tests) {
            changes.push_back({id, was.code != is.code, was.tests != is.tests});
        }
    }
    return changes;
}

WorkByItem work_at(const fs::path& root, const std::string& revision, const fs::path& verdicts,
                   const Register& content) {
    const Checkout checkout{root, revision};
    return collect_evidence(checkout.folder(), verdicts, content).work;
}

}  // namespace canproof::host
