// SPDX-License-Identifier: Apache-2.0
#include "host/assess/documents/residual_errors.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <set>

#include "host/assess/documents/words.hpp"

namespace canproof::host {

namespace {

constexpr double seconds_an_hour = 3600.0;
constexpr int crc_bits = 15;
constexpr std::array<double, 3> bit_errors{1e-2, 1e-5, 1e-8};

std::set<std::int64_t> rates_of(const Register& content) {
    std::set<std::int64_t> rates;
    for (const auto& part : content.parts) {
        rates.merge(bit_rates_of(part));
    }
    return rates;
}

Chapter arithmetic_chapter() {
    DocumentTable table{
        "One frame of eight bytes",
        {"Bit error probability p", "P(at least two bits wrong)", "That times 2^-15: wrong and undetected"},
        {}};
    for (const double p : bit_errors) {
        table.rows.push_back({fmt::format("{:.0e}", p), fmt::format("{:.2e}", two_or_more_wrong(longest_frame_bits, p)),
                              fmt::format("{:.2e}", undetected_in_frame(p))});
    }
    return {"Arithmetic",
            {fmt::format("A data frame with an 11-bit identifier and eight bytes has 1 + 11 + 1 + 2 + 4 + 64 + 15 + 1 "
                         "+ 2 + 7 + 3 = {} bits, intermission included, stuff bits left out.",
                         longest_frame_bits),
             fmt::format("With bit errors that are independent and have the probability p, at least two of n = {} bits "
                         "are wrong with the probability 1 - (1 - p)^n - n p (1 - p)^(n - 1).",
                         longest_frame_bits),
             "CAN detects each single bit error. For two or more bit errors, the estimate ignores the Hamming distance "
             "of the CRC, because an error at a stuff bit can shift the bits behind it. It assumes that a wrong frame "
             "passes the CRC of 15 bits with the probability 2^-15 = 3.05e-5. This is an estimate, not a bound: it "
             "also ignores the checks of form, acknowledgement and stuffing."},
            {table}};
}

Chapter rates_chapter(const Register& content) {
    DocumentTable table{"Undetected wrong frames an hour, on a full bus",
                        {"Bit rate (bit/s)", "Frames an hour", "p = 1e-2", "p = 1e-5", "p = 1e-8"},
                        {}};
    for (const auto rate : rates_of(content)) {
        const double frames = frames_an_hour(static_cast<double>(rate));
        auto& row = table.rows.emplace_back(
            std::vector<std::string>{std::to_string(rate), fmt::format("{:.0f}", std::floor(frames))});
        for (const double p : bit_errors) {
            row.push_back(fmt::format("{:.1e}", frames * undetected_in_frame(p)));
        }
    }
    return {"Figures",
            {fmt::format("A full bus carries bit rate / {} x 3600 frames of this length an hour.", longest_frame_bits),
             "IEC 61784-3 requires p = 1e-2 unless a better value is shown. One per cent of the dangerous failures "
             "that SIL 3 allows is 1e-9 an hour. Where a rate of the table exceeds 1e-9, CAN alone must not carry a "
             "safety function. A safety protocol above CANopen (EN 50325-5, for example) is not part of this firmware.",
             "No bit error was measured: p is assumed."},
            {table}};
}

}  // namespace

double two_or_more_wrong(const int bits, const double bit_error) {
    // For small p, 1 - (1-p)^n - n p (1-p)^(n-1) loses all significant digits. The sum over the probabilities of 2 to n
    // wrong bits keeps them.
    double sum = 0.0;
    double term = bits * bit_error * std::pow(1.0 - bit_error, bits - 1);
    for (int wrong = 2; wrong <= bits; ++wrong) {
        term *= (bits - wrong + 1.0) / wrong * bit_error / (1.0 - bit_error);
        sum += term;
    }
    return sum;
}

double undetected_in_frame(const double bit_error) {
    return std::ldexp(two_or_more_wrong(longest_frame_bits, bit_error), -crc_bits);
}

double frames_an_hour(const double bit_rate) {
    return bit_rate / longest_frame_bits * seconds_an_hour;
}

Document residual_errors(const Register& content, const Analysis& analysis) {
    DocumentTable table{"Errors of communication", {"Error", "Noticed by", "What is left"}, {}};
    for (const auto& one : analysis.communication) {
        table.rows.push_back({one.error, joined_or(one.by, missing), one.rest});
    }
    return {"residual-errors",
            "Residual errors of the communication",
            "The rate of wrong frames that pass the checks of CAN, with the arithmetic, and the detection of the "
            "errors of communication that IEC 61784-3 lists.",
            {arithmetic_chapter(), rates_chapter(content),
             Chapter{"Errors by kind", {"The list follows the kinds of IEC 61784-3, in our words."}, {table}}}};
}

}  // namespace canproof::host
