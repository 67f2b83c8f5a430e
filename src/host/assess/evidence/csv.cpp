// SPDX-License-Identifier: Apache-2.0
#include "host/assess/evidence/csv.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "host/assess/documents/item_words.hpp"
#include "host/assess/trace/audit.hpp"
#include "host/assess/trace/evidence.hpp"
#include "host/base/csv_line.hpp"

namespace canproof::host {

namespace {

std::string joined(const std::vector<std::string>& words) {
    return fmt::format("{}", fmt::join(words, "; "));
}

std::string tests_of(const std::string& id, const Evidence& evidence) {
    std::vector<std::string> all;
    if (const auto found = evidence.verdicts.find(id); found != evidence.verdicts.end()) {
        for (const auto& verdict : found->second) {
            all.push_back(fmt::format("{} {} {}", verdict.kind, verdict.test, verdict.passed ? "passed" : "failed"));
        }
    }
    return joined(all);
}

}  // namespace

std::string write_requirements_csv(const std::vector<PartAudit>& audits, const Evidence& evidence) {
    std::string text =
        csv_line({"id", "part", "kind", "text", "facts", "sources", "decisions", "code", "demanded", "tests", "state"});
    for (const auto& audit : audits) {
        for (const auto& one : audit.items) {
            text += csv_line({one.item->id, audit.part->name, one.word, one.item->text,
                              item_words(*audit.part, one.item->id), joined(origins(*one.item)), joined(one.decisions),
                              joined(code_of(one.item->id, evidence)), joined(one.demanded),
                              tests_of(one.item->id, evidence), one.status()});
        }
    }
    return text;
}

std::string write_decisions_csv(const std::vector<PartAudit>& audits) {
    std::string text = csv_line({"id", "part", "severity", "question", "readings", "chosen", "because", "affects"});
    for (const auto& audit : audits) {
        for (const auto& decision : audit.part->decisions) {
            std::vector<std::string> readings;
            for (const auto& reading : decision.readings) {
                readings.push_back(fmt::format("{} ({})", reading.says, reading.source));
            }
            text += csv_line({decision.id, audit.part->name, decision.severity, decision.text, joined(readings),
                              decision.chosen, decision.because,
                              decision.affects.empty() ? decision.none : joined(decision.affects)});
        }
    }
    return text;
}

std::string write_statements_csv(const std::vector<PartAudit>& audits) {
    std::string text = csv_line({"id", "part", "statement", "passages", "covered by", "reason", "state"});
    for (const auto& audit : audits) {
        for (const auto& one : audit.statements) {
            std::vector<std::string> marks;
            for (const Mark& mark : one.statement->marks) {
                marks.push_back(mark.text());
            }
            text += csv_line({one.id, audit.part->name, one.statement->text, joined(marks),
                              joined(one.statement->covered), one.statement->reason, one.status});
        }
    }
    return text;
}

}  // namespace canproof::host
