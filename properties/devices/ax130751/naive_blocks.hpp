// SPDX-License-Identifier: Apache-2.0
// Naive logic and math blocks of the AX130751 (manual, 1.6.1, 1.6.2, 1.7), written from the sentences of the manual and
// not from generated tables. Properties compare the blocks of the firmware with these blocks.
#pragma once

#include <algorithm>
#include <array>
#include <vector>

namespace canproof::naive_blocks {

enum class State { fine, error, unused };

struct Argument {
    double value{0.0};
    State state{State::unused};
};

struct Condition {
    Argument one;
    Argument other;
    int comparison{0};  ///< number of the operator in Table 16
};

enum class Answer { no, yes, error, not_applicable };

/// Evaluates a condition by Tables 16 and 17. If one argument is in error and the other is not used, the answer is
/// `error`.
inline Answer answer(const Condition& condition) {
    const double a = condition.one.value;
    const double b = condition.other.value;
    if (condition.one.state == State::error || condition.other.state == State::error) {
        return Answer::error;
    }
    if (condition.one.state == State::unused || condition.other.state == State::unused) {
        return Answer::not_applicable;
    }
    const std::array<bool, 6> all{a >= b && a <= b, a < b || a > b, a > b, a >= b, a < b, a <= b};
    return all.at(static_cast<std::size_t>(condition.comparison)) ? Answer::yes : Answer::no;
}

struct Function {
    std::array<Condition, 3> conditions;
    int logical{0};  ///< number of the operator in Table 18
};

/// Returns whether a function selects its table (Table 19).
inline bool selects(const Function& function) {
    std::array<Answer, 3> answers{};
    std::transform(function.conditions.begin(), function.conditions.end(), answers.begin(), answer);
    const auto yes = [&](std::size_t number) { return answers.at(number - 1) == Answer::yes; };
    const auto any = [&](Answer one) { return std::count(answers.begin(), answers.end(), one) != 0; };
    switch (function.logical) {
        case 0:
            return true;
        case 1:
            return !any(Answer::no) && !any(Answer::error);
        case 2:
            return any(Answer::yes);
        case 3:
            return (yes(1) && yes(2)) || yes(3);
        default:
            return (yes(1) && yes(3)) || (yes(2) && yes(3));
    }
}

/// Returns which table is selected: 0, 1 or 2 for table A, B or C. When no function selects its table, table A is
/// selected.
inline std::size_t selected(const std::array<Function, 3>& functions) {
    const auto first = std::find_if(functions.begin(), functions.end(), selects);
    return first == functions.end() ? 0 : static_cast<std::size_t>(first - functions.begin());
}

struct Input {
    int value{0};
    State state{State::unused};
    int scaling_1{0};
    int scaling_2{100};
    int gain{100};        ///< per cent
    int own_function{0};  ///< 1 to 3: the input is the result of this function of the same block; 0: it is `value`
};

/// Returns the value of an input in millionths of the way from its scaling 1 (0) to its scaling 2 (1,000,000), rounded
/// to the nearest integer.
inline long long millionths(const Input& input) {
    long long way = input.value - input.scaling_1;
    long long length = input.scaling_2 - input.scaling_1;
    if (length < 0) {
        way = -way;
        length = -length;
    }
    if (input.state == State::error || length == 0 || way <= 0) {
        return 0;
    }
    return way >= length ? 1'000'000 : (2 * way * 1'000'000 + length) / (2 * length);
}

/// Applies operator `number` of Table 21 to two numbers, `a` and `b`.
inline double operate(int number, double a, double b) {
    const bool p = a >= 0.5;
    const bool q = b >= 0.5;
    const std::vector<double> all{static_cast<double>(a >= b && a <= b),
                                  static_cast<double>(a < b || a > b),
                                  static_cast<double>(a > b),
                                  static_cast<double>(a >= b),
                                  static_cast<double>(a < b),
                                  static_cast<double>(a <= b),
                                  static_cast<double>(p || q),
                                  static_cast<double>(!p && !q),
                                  static_cast<double>(p && q),
                                  static_cast<double>(!(p && q)),
                                  static_cast<double>(p != q),
                                  static_cast<double>(p == q),
                                  a + b,
                                  a - b,
                                  a * b,
                                  b < 0.0 || b > 0.0 ? a / b : 0.0,
                                  std::min(a, b),
                                  std::max(a, b)};
    return all.at(static_cast<std::size_t>(number));
}

/// The results of the three functions of a math block. A negative difference is stored with its sign, although the
/// output is clamped to 0: an input with a negative gain that reads it needs the sign.
class Math {
  public:
    /// Evaluates the block for one cycle. Returns its result, or 0 when no function is evaluated.
    double cycle(const std::array<Input, 4>& inputs, const std::array<int, 3>& operators) {
        double chain = value_of(inputs[0]);
        bool goes_on = inputs[0].state != State::unused && inputs[1].state != State::unused;
        bool done = false;
        for (std::size_t function = 0; function < 3; ++function) {
            const Input& second = inputs.at(function + 1);
            if (!goes_on || second.state == State::unused) {
                signed_.at(function) = 0.0;
                continue;
            }
            const bool may_be_negative = second.gain < 0 || (function == 0 && inputs[0].gain < 0);
            const double result = held(operate(operators.at(function), chain, value_of(second)));
            const bool is_difference = operators.at(function) == 13;
            signed_.at(function) = result;
            is_cut_.at(function) = is_difference && !may_be_negative;
            chain = seen(function);
            done = true;
        }
        return done ? chain : 0.0;
    }

  private:
    /// Clamps the result of a function, so that feedback through products or quotients stays finite. The output of the
    /// block is clamped to at most 1 later.
    static double held(double value) { return std::clamp(value, -1.0e9, 1.0e9); }
    double seen(std::size_t function) const {
        return is_cut_.at(function) ? std::max(signed_.at(function), 0.0) : signed_.at(function);
    }
    double value_of(const Input& input) const {
        const double gain = input.gain / 100.0;
        if (input.own_function == 0) {
            return static_cast<double>(millionths(input)) / 1.0e6 * gain;
        }
        const auto function = static_cast<std::size_t>(input.own_function) - 1;
        return (input.gain < 0 ? signed_.at(function) : seen(function)) * gain;
    }

    std::array<double, 3> signed_{};
    std::array<bool, 3> is_cut_{};
};

}  // namespace canproof::naive_blocks
