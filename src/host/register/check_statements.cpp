// SPDX-License-Identifier: Apache-2.0
#include "host/register/check_statements.hpp"

#include <fmt/format.h>

#include <map>
#include <set>

#include "host/register/refs.hpp"

namespace canproof::host {

namespace {

/// The properties of an item or decision that decide whether the field `covered` of a statement may contain its id.
struct Known {
    const Part* part{nullptr};
    bool retired{false};
};

class StatementCheck {
  public:
    StatementCheck(const Register& content, Faults& faults) : content_{content}, faults_{faults} {
        for (const Part& part : content.parts) {
            content.for_each_item(part, [&](const Item& item, const char*) { known_[item.id] = {&part, false}; });
            for (const auto& decision : part.decisions) {
                known_[decision.id] = {&part, false};
            }
            for (const auto& requirement : part.requirements) {
                known_[requirement.id].retired = !requirement.retired.empty();
            }
        }
    }

    void run() {
        for (const Manual& manual : content_.manuals) {
            const std::set<std::string> refs = refs_of(manual);
            std::map<Mark, std::string> marked;
            for (const Statement& statement : manual.statements) {
                check_section(manual, statement, refs);
                check_marks(manual, statement, marked);
                check_covered(manual, statement);
            }
        }
    }

  private:
    void check_section(const Manual& manual, const Statement& statement, const std::set<std::string>& refs) {
        if (!statement.section.empty() && refs.count(statement.section) == 0) {
            faults_.emplace_back(
                statement.section_place, fmt::format("{} has no section {}", manual.key, statement.section),
                fmt::format("correct the section, or add {} to {}", statement.section, manual.place.file));
        }
    }

    void check_marks(const Manual& manual, const Statement& statement, std::map<Mark, std::string>& marked) {
        for (const Mark& mark : statement.marks) {
            const auto [at, fresh] = marked.emplace(mark, statement.id(manual.key));
            if (!fresh) {
                faults_.emplace_back(
                    statement.mark_place,
                    fmt::format("mark {} (hash of a passage) also belongs to {}", mark.text(), at->second),
                    "write the mark of another passage, or merge the two statements");
            }
        }
    }

    void check_covered(const Manual& manual, const Statement& statement) {
        const std::string id = statement.id(manual.key);
        std::set<std::string> seen;
        for (const auto& item : statement.covered) {
            const auto found = known_.find(item);
            const auto fault = [&](const std::string& why, const char* fix) {
                faults_.emplace_back(statement.covered_place, fmt::format("{} is covered by {}, {}", id, item, why),
                                     fix);
            };
            if (!seen.insert(item).second) {
                fault("which `covered` names twice", "name the item once");
            } else if (found == known_.end()) {
                fault("which does not exist", "correct the id or remove it");
            } else if (found->second.retired) {
                fault("which is retired", "name an item that is not retired");
            } else if (found->second.part->is_device() && found->second.part->info.manual != manual.key) {
                fault("which belongs to another device", "name an item of a device with this manual, or a shared one");
            }
        }
    }

    const Register& content_;
    Faults& faults_;
    std::map<std::string, Known> known_;
};

}  // namespace

void check_statements(const Register& content, Faults& faults) {
    StatementCheck{content, faults}.run();
}

}  // namespace canproof::host
