// SPDX-License-Identifier: Apache-2.0
#include "host/assess/source/test_bodies.hpp"

#include <algorithm>
#include <regex>

#include "host/assess/source/cpp_text.hpp"
#include "host/base/read_file.hpp"
#include "host/base/sha256.hpp"

namespace canproof::host {

namespace {

constexpr std::size_t hash_digits = 16;

/// Returns the two arguments of the macro that defines a test, such as TEST(Suite, Name), as `Suite,Name`. `test` is
/// Suite.Name or, for an instance of a parameterized test, One/Suite.Name/3.
std::string defined_as(const std::string& test) {
    const auto dot = test.find('.');
    const std::string suite = test.substr(0, dot);
    const std::string name = dot == std::string::npos ? "" : test.substr(dot + 1);
    const auto slash = suite.find('/');
    return (slash == std::string::npos ? suite : suite.substr(slash + 1)) + "," + name.substr(0, name.find('/'));
}

}  // namespace

const std::string& TestBodies::hash(const std::string& file, const std::string& test) {
    const std::string definition = defined_as(test);
    const auto [found, is_new] = hashes_.emplace(file + ":" + definition, "");
    if (is_new) {
        found->second = hash_of(file, definition);
    }
    return found->second;
}

bool TestBodies::has(const std::string& file, const std::string& wanted) {
    static const std::regex definition{
        R"((?:TEST|TEST_F|TEST_P|RC_GTEST_PROP|RC_GTEST_FIXTURE_PROP)\((\w+),(\w+)[,)])"};
    const std::string& text = text_of(file);
    return std::any_of(std::sregex_iterator{text.begin(), text.end(), definition}, std::sregex_iterator{},
                       [&](const std::smatch& test) { return hash(file, test.str(1) + "." + test.str(2)) == wanted; });
}

const std::string& TestBodies::text_of(const std::string& file) {
    auto found = sources_.find(file);
    if (found == sources_.end()) {
        const auto path = root_ / file;
        const bool is_there = !file.empty() && std::filesystem::is_regular_file(path);
        found = sources_.emplace(file, is_there ? without_layout(read_file(path)) : "").first;
    }
    return found->second;
}

std::string TestBodies::hash_of(const std::string& file, const std::string& definition) {
    const std::string& text = text_of(file);
    for (const char* end : {")", ","}) {  // a comma ends the name in RC_GTEST_PROP(Suite, Name, (parameters))
        const auto at = text.find("(" + definition + end);
        if (at != std::string::npos) {
            const auto body = at + 1 + definition.size();  // the position after the name of the test
            return sha256(text.substr(body, block_end(text, at) - body)).substr(0, hash_digits);
        }
    }
    return "";
}

}  // namespace canproof::host
