// SPDX-License-Identifier: Apache-2.0
// A decision table as C++: the types of its columns, and its rows. A row of the register with several alternatives
// becomes several rows.
#pragma once

#include <string>
#include <vector>

#include "host/register/register.hpp"

namespace canproof::host {

/// One member of a row in a generated table.
struct RowField {
    std::string name;
    const Column* column{nullptr};
    Value value;
    bool hexadecimal{false};      ///< whether spec/ contains the value as a hexadecimal number
    std::size_t register_row{0};  ///< row of the table in spec/ that contains the value, counted from 0
};
using FieldRow = std::vector<RowField>;

/// Returns whether every node has this error. The firmware's enumeration `ErrorId` contains these errors.
bool is_node_error(const std::string& word);
/// Returns the errors that only this device has, in the order of its tables.
std::vector<std::string> own_errors(const Part& part);

class TableCode {
  public:
    TableCode(const Register& content, const Part& part, const Table& table)
        : content_{content}, part_{part}, table_{table} {}

    /// Returns whether the cells of an integer input column contain ranges or "*". Such a column becomes two members:
    /// first and last.
    bool is_ranged(const Column& column) const;
    std::string type_of(const Column& column) const;
    std::string enumeration_of(const Column& column) const;
    /// Returns the C++ literal of a value; with `hexadecimal`, an unsigned number is hexadecimal.
    std::string literal(const Column& column, const Value& value, bool hexadecimal = false) const;
    /// Returns whether the words in a column are names of errors, either errors that every node has or errors of this
    /// device alone.
    bool is_errors(const Column& column) const { return !table_.errors.empty() && column.name == table_.errors; }
    /// Returns the rows. In each row, the inputs are before the outputs. A row of the table in spec/ becomes one row
    /// for each combination of its alternatives. "*" becomes a row for each value of a boolean or word column. An
    /// integer column with ranges or "*" becomes two members, first and last.
    std::vector<FieldRow> rows() const;
    /// Returns the namespace of the table, such as `enable_response`.
    const std::string& space() const { return table_.name; }

  private:
    std::vector<FieldRow> choices(std::size_t input, std::size_t row) const;
    std::size_t position(const Column& column) const;

    const Register& content_;
    const Part& part_;
    const Table& table_;
};

}  // namespace canproof::host
