// A decision table as C++: the types of its columns, and its rows with alternatives written out.
#pragma once

#include <string>
#include <vector>

#include "host/register/register.hpp"

namespace canproof::host {

/// One member of a generated row.
struct RowField {
    std::string name;
    const Column* column{nullptr};
    Value value;
    bool hexadecimal{false};      ///< as spec/ writes it
    std::size_t register_row{0};  ///< of the table in spec/, from 0
};
using FieldRow = std::vector<RowField>;

/// Whether every node can notice the error of this name: `ErrorId` has it.
bool is_node_error(const std::string& word);
/// Errors that only this device has, in the order of its tables.
std::vector<std::string> own_errors(const Part& part);

class TableCode {
  public:
    TableCode(const Register& content, const Part& part, const Table& table)
        : content_{content}, part_{part}, table_{table} {}

    /// Whether an input holds ranges: it becomes two members, first and last.
    bool is_ranged(const Column& column) const;
    std::string type_of(const Column& column) const;
    std::string enumeration_of(const Column& column) const;
    /// `hexadecimal`: an unsigned number is to be written so.
    std::string literal(const Column& column, const Value& value, bool hexadecimal = false) const;
    /// Whether the words of a column are errors of the node.
    bool is_errors(const Column& column) const { return !table_.errors.empty() && column.name == table_.errors; }
    /// Inputs, then outputs; "*" and alternatives become one row each, an integer range a pair of members.
    std::vector<FieldRow> rows() const;
    /// `enable_response`
    const std::string& space() const { return table_.name; }

  private:
    std::vector<FieldRow> choices(std::size_t input, std::size_t row) const;
    std::size_t position(const Column& column) const;

    const Register& content_;
    const Part& part_;
    const Table& table_;
};

}  // namespace canproof::host
