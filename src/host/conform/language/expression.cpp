// SPDX-License-Identifier: Apache-2.0
#include "host/conform/language/expression.hpp"

#include <fmt/format.h>

#include <array>
#include <cctype>
#include <vector>

#include "host/conform/language/functions.hpp"

namespace canproof::host::conform {

namespace {

using Operation = std::int64_t (*)(std::int64_t, std::int64_t);

std::uint64_t bits(std::int64_t number) {
    return static_cast<std::uint64_t>(number);
}
std::int64_t signed_of(std::uint64_t number) {
    return static_cast<std::int64_t>(number);
}
std::int64_t divisor(std::int64_t number) {
    if (number == 0 || number == -1) {  // -1 is refused because the smallest number has no positive counterpart
        throw BrokenCase{fmt::format("the expression divides by {}; a divisor must not be 0 or -1", number)};
    }
    return number;
}
std::uint64_t shift(std::int64_t number) {
    if (number < 0 || number > 63) {
        throw BrokenCase{fmt::format("the expression shifts by {} bits; shift by 0 to 63 bits", number)};
    }
    return bits(number);
}

struct Operator {
    const char* symbol;
    int rank;
    Operation apply;
};

// The operators with symbol, rank and function. Longer symbols come first, so that `<<` is not read as `<`. A higher
// rank binds more strongly, as in C.
const std::array<Operator, 18> operators{
    {{"||", 1, [](std::int64_t a, std::int64_t b) { return std::int64_t{a != 0 || b != 0}; }},
     {"&&", 2, [](std::int64_t a, std::int64_t b) { return std::int64_t{a != 0 && b != 0}; }},
     {"==", 6, nullptr},
     {"!=", 6, nullptr},
     {"<=", 7, [](std::int64_t a, std::int64_t b) { return std::int64_t{a <= b}; }},
     {">=", 7, [](std::int64_t a, std::int64_t b) { return std::int64_t{a >= b}; }},
     {"<<", 8, [](std::int64_t a, std::int64_t b) { return signed_of(bits(a) << shift(b)); }},
     {">>", 8, [](std::int64_t a, std::int64_t b) { return signed_of(bits(a) >> shift(b)); }},
     {"|", 3, [](std::int64_t a, std::int64_t b) { return signed_of(bits(a) | bits(b)); }},
     {"^", 4, [](std::int64_t a, std::int64_t b) { return signed_of(bits(a) ^ bits(b)); }},
     {"&", 5, [](std::int64_t a, std::int64_t b) { return signed_of(bits(a) & bits(b)); }},
     {"<", 7, [](std::int64_t a, std::int64_t b) { return std::int64_t{a < b}; }},
     {">", 7, [](std::int64_t a, std::int64_t b) { return std::int64_t{a > b}; }},
     {"+", 9, [](std::int64_t a, std::int64_t b) { return signed_of(bits(a) + bits(b)); }},
     {"-", 9, [](std::int64_t a, std::int64_t b) { return signed_of(bits(a) - bits(b)); }},
     {"*", 10, [](std::int64_t a, std::int64_t b) { return signed_of(bits(a) * bits(b)); }},
     {"/", 10, [](std::int64_t a, std::int64_t b) { return a / divisor(b); }},
     {"%", 10, [](std::int64_t a, std::int64_t b) { return a % divisor(b); }}}};

constexpr int lowest_rank = 1;
constexpr int sum_rank = 9;

/// Reads the next operator if its rank is at least `rank`; otherwise returns nullptr and reads nothing. `->` and `+-`
/// are not operators.
const Operator* next_operator(Scanner& line, int rank) {
    if (line.sees("->") || line.sees("+-")) {
        return nullptr;
    }
    for (const Operator& one : operators) {
        if (line.sees(one.symbol)) {
            if (one.rank < rank) {
                return nullptr;
            }
            line.take(one.symbol);
            return &one;
        }
    }
    return nullptr;
}

Expression parse_ranked(Scanner& line, Radix radix, int rank);

Expression parse_hex_bytes(Scanner& line) {
    Bytes bytes;
    line.want("(", "write hex(01 02 FF)");
    while (!line.take(")")) {
        const std::string word = line.word();
        if (word.size() != 2 || word.find_first_not_of("0123456789abcdefABCDEF") != std::string::npos) {
            line.fail(fmt::format("`{}` is no byte", word), "write two hexadecimal digits a byte: hex(01 02 FF)");
        }
        bytes.push_back(static_cast<std::uint8_t>(std::stoul(word, nullptr, 16)));
    }
    return [bytes](const Scope&) { return Value{bytes}; };
}

Expression parse_call(Scanner& line, const std::string& name) {
    if (name == "hex") {
        return parse_hex_bytes(line);
    }
    const LanguageFunction* const function = find_function(name);
    if (function == nullptr) {
        line.fail(fmt::format("`{}` is not a number, variable or function", name),
                  fmt::format("variables begin with $; functions are {}", function_names()));
    }
    std::vector<Expression> given;
    line.want("(", fmt::format("write {}(…)", name));
    while (given.size() < function->arguments) {
        if (!given.empty()) {
            line.want(",", fmt::format("{} takes {} arguments", name, function->arguments));
        }
        given.push_back(parse_expression(line, Radix::decimal));
    }
    line.want(")", fmt::format("{} takes {} argument(s)", name, function->arguments));
    return [given, function](const Scope& scope) {
        std::vector<Value> values;
        for (const Expression& one : given) {
            values.push_back(one(scope));
        }
        return function->call(values);
    };
}

Expression constant(Scanner& line, const std::string& digits, int base) {
    std::uint64_t number = 0;
    for (const char c : digits) {
        const int digit = std::isdigit(static_cast<unsigned char>(c)) != 0
                              ? c - '0'
                              : std::tolower(static_cast<unsigned char>(c)) - 'a' + 10;
        if (std::isxdigit(static_cast<unsigned char>(c)) == 0 || digit >= base) {
            line.fail(fmt::format("`{}` is not a number", digits), "write 100, 0x64 or 64h");
        }
        const auto added = static_cast<std::uint64_t>(digit);
        if (number > (UINT64_MAX - added) / static_cast<unsigned>(base)) {
            line.fail(fmt::format("`{}` is too large", digits), "write a number of at most 64 bits");
        }
        number = number * static_cast<unsigned>(base) + added;
    }
    return [value = Value{signed_of(number)}](const Scope&) { return value; };
}

bool is_hex_number(const std::string& word) {
    return word.find_first_not_of("0123456789abcdefABCDEF") == std::string::npos;
}

Expression parse_word(Scanner& line, Radix radix) {
    const std::string word = line.word();
    if (word.empty()) {
        line.fail(fmt::format("a value is missing before `{}`", line.rest()), "write a number, $name or (…)");
    }
    if (word.rfind("0x", 0) == 0 && word.size() > 2) {
        return constant(line, word.substr(2), 16);
    }
    if (radix == Radix::hexadecimal) {
        if (word == "N") {
            return [](const Scope& scope) { return Value{number_of(*scope.find("N"))}; };
        }
        return constant(line, word, 16);
    }
    if (word.size() > 1 && word.back() == 'h' && is_hex_number(word.substr(0, word.size() - 1))) {
        return constant(line, word.substr(0, word.size() - 1), 16);
    }
    return std::isdigit(static_cast<unsigned char>(word.front())) != 0 ? constant(line, word, 10)
                                                                       : parse_call(line, word);
}

Expression parse_primary(Scanner& line, Radix radix) {
    if (line.take("(")) {
        Expression inner = parse_expression(line, radix);
        line.want(")", "close the bracket");
        return inner;
    }
    if (line.peek() == '"') {
        const std::string text = line.quoted();
        return [value = Value{Bytes(text.begin(), text.end())}](const Scope&) { return value; };
    }
    return line.peek() == '$' ? parse_variable(line) : parse_word(line, radix);
}

Expression parse_indexed(Scanner& line, Radix radix) {
    Expression value = parse_primary(line, radix);
    while (line.take_close('[')) {
        Expression index = parse_expression(line, Radix::decimal);
        line.want("]", "close the bracket");
        value = [value, index](const Scope& scope) {
            const Value whole = value(scope);
            const std::int64_t at = number_of(index(scope));
            const Bytes& bytes = bytes_of(whole);
            if (at < 0 || at >= static_cast<std::int64_t>(bytes.size())) {
                throw BrokenCase{
                    fmt::format("the value has {} bytes and no byte {}; the first byte is number 0", bytes.size(), at)};
            }
            return Value{std::int64_t{bytes[static_cast<std::size_t>(at)]}};
        };
    }
    return value;
}

Expression with_unit(Scanner& line, Expression value) {
    constexpr std::array<std::pair<const char*, std::int64_t>, 3> units{{{"us", 1}, {"ms", 1000}, {"s", 1000000}}};
    for (const auto& unit : units) {
        if (line.take_word(unit.first)) {
            return [value, factor = unit.second](const Scope& scope) {
                return Value{signed_of(bits(number_of(value(scope))) * bits(factor))};
            };
        }
    }
    return value;
}

Expression parse_unary(Scanner& line, Radix radix) {
    if (line.sees("!=") || line.sees("->")) {
        line.fail("a value is missing", "write a number, $name or (…)");
    }
    if (line.take("!")) {
        return [inner = parse_unary(line, radix)](const Scope& scope) {
            return Value{std::int64_t{number_of(inner(scope)) == 0}};
        };
    }
    if (line.take("~")) {
        return [inner = parse_unary(line, radix)](const Scope& scope) {
            return Value{signed_of(~bits(number_of(inner(scope))))};
        };
    }
    if (line.take("-")) {
        return [inner = parse_unary(line, radix)](const Scope& scope) {
            return Value{signed_of(0U - bits(number_of(inner(scope))))};
        };
    }
    Expression value = parse_indexed(line, radix);
    return radix == Radix::decimal ? with_unit(line, std::move(value)) : value;
}

Expression combine(const Operator& one, Expression left, Expression right) {
    if (one.apply == nullptr) {
        const bool equal = one.symbol[0] == '=';
        return [left, right, equal](const Scope& scope) {
            return Value{std::int64_t{same(left(scope), right(scope)) == equal}};
        };
    }
    if (one.rank <= 2) {  // && and || evaluate the right side only if the left side does not decide the result
        const bool open_when = one.rank == 2;
        return [left, right, open_when](const Scope& scope) {
            const bool first = number_of(left(scope)) != 0;
            return Value{std::int64_t{first == open_when ? number_of(right(scope)) != 0 : first}};
        };
    }
    return [left, right, apply = one.apply](const Scope& scope) {
        return Value{apply(number_of(left(scope)), number_of(right(scope)))};
    };
}

Expression parse_ranked(Scanner& line, Radix radix, int rank) {
    Expression left = parse_unary(line, radix);
    for (const Operator* one = next_operator(line, rank); one != nullptr; one = next_operator(line, rank)) {
        left = combine(*one, left, parse_ranked(line, radix, one->rank + 1));
    }
    return left;
}

}  // namespace

Expression parse_expression(Scanner& line, Radix radix) {
    return parse_ranked(line, radix, lowest_rank);
}

Expression parse_sum(Scanner& line) {
    return parse_ranked(line, Radix::decimal, sum_rank);
}

Expression parse_operand(Scanner& line, Radix radix) {
    return parse_unary(line, radix);
}

std::string parse_name(Scanner& line) {
    const std::string name = line.word();
    if (name.empty() || std::isdigit(static_cast<unsigned char>(name.front())) != 0) {
        line.fail("a name is missing", "write letters, digits and _, a letter first");
    }
    return name;
}

Expression parse_variable(Scanner& line) {
    line.want("$", "write $name");
    const std::string name = parse_name(line);
    Expression value = [name](const Scope& scope) {
        const Value* const found = scope.find(name);
        if (found == nullptr) {
            throw BrokenCase{
                fmt::format("${} has no value here; set it in an earlier step, for example with `let`", name)};
        }
        return *found;
    };
    while (line.take_close('.')) {
        const std::string field = parse_name(line);
        value = [value, name, field](const Scope& scope) {
            const Value whole = value(scope);
            const auto found = whole.fields ? whole.fields(field) : std::nullopt;
            if (!found) {
                throw BrokenCase{fmt::format("${} has no field {}; name a field of this variable", name, field)};
            }
            return *found;
        };
    }
    return value;
}

Expression parse_indexed_variable(Scanner& line) {
    return parse_indexed(line, Radix::decimal);
}

std::uint64_t microseconds_of(const Expression& expression, const Scope& scope) {
    const std::int64_t number = number_of(expression(scope));
    if (number < 0) {
        throw BrokenCase{fmt::format("the time is {} us; a time must not be negative", number)};
    }
    return static_cast<std::uint64_t>(number);
}

}  // namespace canproof::host::conform
