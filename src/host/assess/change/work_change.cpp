// SPDX-License-Identifier: Apache-2.0
#include "host/assess/change/work_change.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <set>
#include <utility>

#include "host/assess/source/test_bodies.hpp"
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

std::set<std::string> hashes_of(const std::vector<WorkPart>& parts) {
    std::set<std::string> hashes;
    for (const WorkPart& part : parts) {
        hashes.insert(part.hash);
    }
    return hashes;
}

/// Adds the parts whose hash is not in `known`, each hash once.
void add_new(std::vector<WorkPart>& to, const std::vector<WorkPart>& parts, std::set<std::string> known) {
    for (const WorkPart& part : parts) {
        if (known.insert(part.hash).second) {
            to.push_back(part);
        }
    }
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
        const std::set<std::string> functions = hashes_of(was.functions);
        const std::set<std::string> bodies = hashes_of(was.bodies);
        WorkChange change{id, functions != hashes_of(is.functions), bodies != hashes_of(is.bodies)};
        add_new(change.parts, is.functions, functions);
        add_new(change.parts, is.bodies, bodies);
        if (change.code || change.tests) {
            changes.push_back(std::move(change));
        }
    }
    return changes;
}

WorkByItem work_at(const fs::path& root, const std::string& revision, const fs::path& verdicts, const Register& content,
                   const WorkByItem& now) {
    const Checkout checkout{root, revision};
    WorkByItem work = collect_evidence(checkout.folder(), verdicts, content, WorkDetail::parts).work;
    TestBodies bodies{checkout.folder()};
    for (auto& [id, then] : work) {
        const std::vector<WorkPart>& present = work_of(id, now).bodies;
        for (WorkPart& test : then.bodies) {
            const auto same = std::find_if(present.begin(), present.end(), [&](const WorkPart& one) {
                return one.file == test.file && one.name == test.name;
            });
            if (test.hash.empty() && same != present.end() && bodies.has(test.file, same->hash)) {
                test.hash = same->hash;
            }
        }
    }
    return work;
}

}  // namespace canproof::host
