// SPDX-License-Identifier: Apache-2.0
#include "tests/bench/test_dictionary.hpp"

#include <stdexcept>

#include "host/register/embedded_spec.hpp"
#include "host/register/load.hpp"
#include "host/register/spec_files.hpp"

namespace canproof::bench {

namespace {

const char* const added_objects = R"toml(
[[object]]
index = 0x5F00
name = "Program"
type = "DOMAIN"
access = "rw"
source = ["AX130751:3.4"]
[[object]]
index = 0x5F01
name = "Text"
type = "VISIBLE_STRING"
access = "rw"
length = 64
default = "0123456789abcdef0123456789abcdef0123456789abcdef0123456789abcdef"
source = ["AX130751:3.4"]
[[object]]
index = 0x5F02
name = "Words"
type = "UNSIGNED16"
array = 8
access = "rw"
default = 0
mapping = "both"
source = ["AX130751:3.4"]
)toml";

}  // namespace

const host::Part& test_part() {
    static const host::Part part = [] {
        host::SpecFiles files = host::embedded_spec();
        files["spec/devices/ax130751/objects/bench.toml"] = added_objects;
        const host::LoadResult loaded = host::load_register(files);
        if (!loaded.faults.empty()) {
            throw std::logic_error{loaded.faults.front().text()};
        }
        host::Part found = *loaded.content.part("ax130751");
        found.info.block_sdo = true;
        return found;
    }();
    return part;
}

}  // namespace canproof::bench
