// SPDX-License-Identifier: Apache-2.0
// The `spec review` command: records that a reader has read items of the requirements register in their present form,
// with their code and tests.
#include "host/app/cli/review_command.hpp"

#include <fcntl.h>
#include <fmt/chrono.h>
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <ctime>

#include "host/app/cli/sound_register.hpp"
#include "host/assess/trace/evidence.hpp"
#include "host/assess/trace/review.hpp"
#include "host/base/descriptor.hpp"
#include "host/base/file_lock.hpp"
#include "host/base/files.hpp"
#include "host/base/input_error.hpp"
#include "host/register/written_form.hpp"

namespace canproof::host {

namespace {

/// Returns the date that the options give, otherwise the date of SOURCE_DATE_EPOCH or, without that, of today (UTC).
std::string date_of(const ReviewOptions& options) {
    if (!options.date.empty()) {
        return options.date;
    }
    const char* epoch = std::getenv("SOURCE_DATE_EPOCH");
    const std::time_t now = epoch == nullptr ? std::time(nullptr) : static_cast<std::time_t>(std::atoll(epoch));
    return fmt::format("{:%Y-%m-%d}", fmt::gmtime(now));
}

void check(const ReviewOptions& options) {
    if (!options.date.empty() && !is_date(options.date)) {
        throw InputError{fmt::format("{} is no date; write YYYY-MM-DD", options.date)};
    }
    if (options.mark) {
        if (options.all || options.wording || !options.subjects.empty() || !options.by.empty() ||
            !options.role.empty()) {
            throw InputError{"--mark applies to all reviews; leave out ID, --all, --wording, --by and --role"};
        }
        return;
    }
    if (options.by.empty() || options.role.empty()) {
        throw InputError{"a review needs the reader and the role; write --by NAME --role author|independent"};
    }
    if (options.subjects.empty() != options.all) {
        throw InputError{"name what was read (ids of items or sections, or devices), or write --all, but not both"};
    }
}

/// Returns the items and sections, of a device or of the shared rules, for which this command records a review. If the
/// user named this device or gave --all, returns all that need a review; otherwise returns the named ones. Removes each
/// found name from `names`.
std::set<std::string> chosen_of(const Register& content, const Part& part, const WorkByItem& work,
                                const ReviewOptions& options, std::set<std::string>& names) {
    const std::set<std::string> waiting = unreviewed(content, part, work);
    if (options.all || names.erase(part.name) != 0) {
        return waiting;
    }
    std::set<std::string> chosen;
    for (const auto& id : reviewable(content, part)) {
        if (names.erase(id) != 0) {
            chosen.insert(id);
        }
    }
    return chosen;
}

std::filesystem::path reviews_file(const ReviewOptions& options, const Part& part) {
    return std::filesystem::path{options.spec} / (part.is_device() ? "devices/" + part.name : part.name) /
           "reviews.toml";
}

/// Locks the register until the returned descriptor closes. Waits for another command that records reviews, because
/// both would write the same file from its old content.
Descriptor locked_folder(const std::string& folder) {
    Descriptor file{open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)};
    static_cast<void>(wait_for_lock(file.number()));  // a file system without locks does not prevent a review
    return file;
}

int mark_reviews(const ReviewOptions& options, const Register& content, const WorkByItem& work) {
    const std::string date = date_of(options);
    for (const auto& part : content.parts) {
        if (!part.inherited && !part.reviews.empty()) {
            write_file(reviews_file(options, part), write_marked_reviews(content, part, date, work));
        }
    }
    fmt::print("hashes of the code and tests of reviewed items recorded, without a claim that someone has read them\n");
    return 0;
}

}  // namespace

int review_spec(const ReviewOptions& options) {
    check(options);
    const Descriptor locked = locked_folder(options.spec);
    const Register content = sound_register(options.spec);
    const auto root = (std::filesystem::absolute(options.spec) / ".").lexically_normal().parent_path().parent_path();
    const auto verdicts = options.verdicts.empty() ? newest_verdicts(root) : std::filesystem::path{options.verdicts};
    const WorkByItem work = collect_evidence(root, verdicts, content).work;
    if (options.mark) {
        return mark_reviews(options, content, work);
    }
    const ReviewSession session{date_of(options), options.by, options.role, options.wording};
    std::set<std::string> names{options.subjects.begin(), options.subjects.end()};
    std::vector<std::pair<std::filesystem::path, std::string>> files;
    std::size_t count = 0;
    for (const auto& part : content.parts) {
        const auto chosen = part.inherited ? std::set<std::string>{} : chosen_of(content, part, work, options, names);
        if (chosen.empty()) {
            continue;
        }
        count += chosen.size();
        files.emplace_back(reviews_file(options, part), write_reviews(content, part, chosen, session, work));
    }
    if (!names.empty()) {
        throw InputError{fmt::format(
            "`{}` is no device, item or section (such as AX188001:3.2.8), or it is a retired item; `canproof devices` "
            "lists the devices, `canproof audit --kind requirement` the requirements",
            *names.begin())};
    }
    for (const auto& [file, text] : files) {
        write_file(file, text);
    }
    fmt::print("{} item(s) and section(s) reviewed by {}, {}\n", count, options.by,
               options.role == "author" ? "author of the change" : "not the author of the change");
    return 0;
}

}  // namespace canproof::host
