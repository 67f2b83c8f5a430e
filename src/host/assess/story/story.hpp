// SPDX-License-Identifier: Apache-2.0
// Describes one item, section, statement, file or test (its story): everything that the audit knows about it, from the
// manual to the test results.
#pragma once

#include <optional>
#include <string>

#include "host/assess/mutation/mutation_counts.hpp"
#include "host/assess/trace/audit.hpp"
#include "host/assess/trace/evidence.hpp"

namespace canproof::host {

struct Story {
    std::string text;
    bool open{false};  ///< whether the story contains a failed test, or an item, section or statement that no passed
                       ///< test proves
};

class StoryTeller {
  public:
    StoryTeller(const Register& content, const std::vector<PartAudit>& audits, const Evidence& evidence,
                const CountsByItem& mutations);

    /// Returns the description (story) of an item or a decision by its id, of a section ("AX130751:1.3"), a statement
    /// ("AX130751:1.3/2"), a file of the code, or a test ("Suite.Name"). Returns nothing when `subject` is none of
    /// these.
    std::optional<Story> tell(const std::string& subject) const;

  private:
    Story item(const AuditedItem& audited) const;
    Story decision(const Decision& decision) const;
    std::optional<Story> section(const std::string& subject) const;
    Story statement(const AuditedStatement& audited) const;
    std::optional<Story> file(const std::string& subject) const;
    std::optional<Story> test(const std::string& subject) const;
    /// Returns the heading and one line for each id of an audited item: `  ID  status  kind  text`.
    Story list(const std::string& head, const std::vector<std::string>& ids) const;
    std::string sections_of(const AuditedItem& audited) const;
    std::string verdicts_of(const std::string& id) const;
    std::vector<const AuditedStatement*> statements_of(const Manual& manual, const Section& section) const;

    const Register& content_;
    const Evidence& evidence_;
    const CountsByItem& mutations_;
    std::map<std::string, const AuditedItem*> items_;
    std::map<std::string, const Part*> parts_;
    std::map<std::string, const Decision*> decisions_;
    std::map<std::string, const AuditedStatement*> statements_;
    std::map<std::string, const PartAudit*> audits_;  ///< audits by the key of their manual
};

/// Returns one line about an item, for a list of items.
std::string item_line(const AuditedItem& audited);
/// Returns one line about a statement of a manual, for a list of statements.
std::string statement_line(const AuditedStatement& audited);

}  // namespace canproof::host
