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
    std::size_t register_row{0};  ///< of the table in spec/, from 0
};
using FieldRow = std::vector<RowField>;

class TableCode {
  public:
    TableCode(const Register& content, const Part& part, const Table& table)
        : content_{content}, part_{part}, table_{table} {}

    /// Whether an input holds ranges: it becomes two members, first and last.
    bool is_ranged(const Column& column) const;
    std::string type_of(const Column& column) const;
    std::string enumeration_of(const Column& column) const;
    std::string literal(const Column& column, const Value& value) const;
    /// Inputs, then outputs; "*" and alternatives become one row each, an integer range a pair of members.
    std::vector<FieldRow> rows() const;
    /// `t_aor_t07`
    std::string space() const;

  private:
    std::vector<FieldRow> choices(std::size_t input, std::size_t row) const;
    std::size_t position(const Column& column) const;

    const Register& content_;
    const Part& part_;
    const Table& table_;
};

}  // namespace canproof::host
