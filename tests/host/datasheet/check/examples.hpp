// SPDX-License-Identifier: Apache-2.0
// A bad and a good example of every rule, as patches of the good sheet (good_sheet.hpp).
#pragma once

#include <string>
#include <vector>

namespace canproof::host::test {

struct RuleExample {
    std::string rule;
    std::string bad;   ///< text of a patch after which the rule has a finding in a changed line
    std::string good;  ///< text of a patch after which the rule has no finding; empty: the good sheet itself
};

/// Return examples of the rules that the comments behind the functions name.
std::vector<RuleExample> file_examples();     ///< about text, [FileInfo], [DeviceInfo], [DummyUsage], [Comments], DCF
std::vector<RuleExample> object_examples();   ///< about lists, objects, sub-objects
std::vector<RuleExample> entry_examples();    ///< about types, access, values, limits
std::vector<RuleExample> service_examples();  ///< about mapping, PDOs, communication objects

}  // namespace canproof::host::test
