// SPDX-License-Identifier: Apache-2.0
// Reads one TOML table. Records which keys are requested, and reports every fault with its line.
#pragma once

#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "host/register/register.hpp"

// Declares two classes of toml++, so that only sources that read nodes need to include toml++.
namespace toml {
inline namespace v3 {
class node;
class table;
}  // namespace v3
}  // namespace toml

namespace canproof::host {

class TomlItem {
  public:
    TomlItem(const toml::table& table, std::string file, Faults& faults)
        : table_{table}, file_{std::move(file)}, faults_{faults} {}

    Place place() const;
    Place place(const std::string& key) const;
    Place place(const toml::node& node) const;
    bool has(const std::string& key) const;

    /// Returns a required string. Adds a fault when it is missing, empty or no string.
    std::string text(const std::string& key);
    std::string text_or(const std::string& key, const std::string& otherwise);
    /// Returns a required whole number. Adds a fault when it is missing or not in [minimum, maximum].
    std::int64_t integer(const std::string& key, std::int64_t minimum, std::int64_t maximum);
    std::int64_t integer_or(const std::string& key, std::int64_t otherwise, std::int64_t minimum, std::int64_t maximum);
    bool boolean_or(const std::string& key, bool otherwise);
    std::optional<double> number(const std::string& key);
    std::vector<std::string> texts(const std::string& key, bool required);
    std::vector<std::int64_t> integers(const std::string& key);
    /// Returns the value of the key, which must be one of the words; adds a fault that lists the words for any other
    /// value. Without the key, returns `otherwise`, and adds a fault if `otherwise` is empty.
    std::string word(const std::string& key, const std::vector<std::string>& words, const std::string& otherwise);
    Value value(const std::string& key);
    const toml::node* node(const std::string& key);
    /// Returns the tables in the array of tables `key`.
    std::vector<TomlItem> items(const std::string& key);
    std::optional<TomlItem> item(const std::string& key);

    void fault(const std::string& what, const std::string& fix) { fault(place(), what, fix); }
    void fault(const Place& at, const std::string& what, const std::string& fix) { faults_.push_back({at, what, fix}); }
    /// Adds a fault for each key of the table that was never requested, because such a key is unknown.
    void finish();

    Faults& faults() { return faults_; }
    const std::string& file() const { return file_; }
    const toml::table& table() const { return table_; }

  private:
    void missing(const std::string& key, const std::string& what);
    void wrong_type(const std::string& key, const std::string& expected);

    const toml::table& table_;
    std::string file_;
    Faults& faults_;
    std::set<std::string> asked_;
};

Value literal(const toml::node& node);
/// Returns whether the file contains this whole number in hexadecimal form (0x…).
bool is_hexadecimal(const toml::node& node);

}  // namespace canproof::host
