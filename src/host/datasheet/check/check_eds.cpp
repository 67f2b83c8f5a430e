// SPDX-License-Identifier: Apache-2.0
#include "host/datasheet/check/check_eds.hpp"

#include <array>
#include <map>

#include "host/datasheet/check/device_info_rules.hpp"
#include "host/datasheet/check/entry_rules.hpp"
#include "host/datasheet/check/file_info_rules.hpp"
#include "host/datasheet/check/list_rules.hpp"
#include "host/datasheet/check/mapping_rules.hpp"
#include "host/datasheet/check/object_rules.hpp"
#include "host/datasheet/check/pdo_rules.hpp"
#include "host/datasheet/check/service_rules.hpp"
#include "host/datasheet/check/small_section_rules.hpp"
#include "host/datasheet/check/text_rules.hpp"
#include "host/datasheet/check/value_rules.hpp"

namespace canproof::host {

namespace {

struct Group {
    const std::vector<EdsRule>& (*rules)();
    void (*check)(const EdsSheet& sheet, EdsFindings& findings);
};

constexpr std::array<Group, 11> groups{{{text_rules, check_text},
                                        {file_info_rules, check_file_info},
                                        {device_info_rules, check_device_info},
                                        {small_section_rules, check_small_section},
                                        {list_rules, check_list},
                                        {object_rules, check_object},
                                        {entry_rules, check_entry},
                                        {value_rules, check_value},
                                        {mapping_rules, check_mapping},
                                        {pdo_rules, check_pdo},
                                        {service_rules, check_service}}};

const std::map<std::string, EdsRule>& rules_by_id() {
    static const std::map<std::string, EdsRule> rules = [] {
        std::map<std::string, EdsRule> all;
        for (const EdsRule& rule : eds_rules()) {
            all.emplace(rule.id, rule);
        }
        return all;
    }();
    return rules;
}

}  // namespace

std::vector<EdsRule> eds_rules() {
    std::vector<EdsRule> all;
    for (const Group& group : groups) {
        const std::vector<EdsRule>& some = group.rules();
        all.insert(all.end(), some.begin(), some.end());
    }
    return all;
}

std::vector<EdsFinding> check_eds(std::string_view text, std::string_view name) {
    const EdsSheet sheet{text, name};
    EdsFindings findings{rules_by_id()};
    for (const Group& group : groups) {
        group.check(sheet, findings);
    }
    return findings.take();
}

}  // namespace canproof::host
