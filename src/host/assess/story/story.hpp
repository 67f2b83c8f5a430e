// One thread of the web that the audit looks at, told from any of its ends.
#pragma once

#include <optional>
#include <string>

#include "host/assess/mutation/mutation_counts.hpp"
#include "host/assess/trace/audit.hpp"
#include "host/assess/trace/evidence.hpp"

namespace canproof::host {

struct Story {
    std::string text;
    bool open{false};  ///< something in it is failed, open or suspect
};

class StoryTeller {
  public:
    StoryTeller(const Register& content, const std::vector<PartAudit>& audits, const Evidence& evidence,
                const CountsByItem& mutations);

    /// By the id of an item or a decision, a section ("AX130751:1.3"), a statement of it ("AX130751:1.3/2"), a file of
    /// the code or a test ("Suite.Name"); nothing when it is none of them.
    std::optional<Story> tell(const std::string& subject) const;

  private:
    Story item(const AuditedItem& audited) const;
    Story decision(const Decision& decision) const;
    std::optional<Story> section(const std::string& subject) const;
    Story statement(const AuditedStatement& audited) const;
    std::optional<Story> file(const std::string& subject) const;
    std::optional<Story> test(const std::string& subject) const;
    /// `  ID  status  text`, a line an id.
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
    std::map<std::string, const PartAudit*> audits_;  ///< by key of the manual
};

/// One line of a list of items.
std::string item_line(const AuditedItem& audited);
/// One line of a list of statements.
std::string statement_line(const AuditedStatement& audited);

}  // namespace canproof::host
