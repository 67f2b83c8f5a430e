// Thermocouples: from temperature to voltage and back by the reference and inverse functions of the ITS-90 (AX188001,
// 1.1). All in double: the polynomials of degree 14 lose too much in single precision. No library function but
// rounding-free ones is called.
#pragma once

#include <array>
#include <cstddef>

namespace canproof {

/// a0·exp(a1·(t − a2)²), a1 negative; type K only. With a0 = 0 there is none.
struct ExponentialTerm {
    double a0_mv{0.0};
    double a1_per_c2{0.0};
    double a2_c{0.0};
};

/// Σ c[i]·tⁱ in mV with the reference junction at 0 °C, for t from `from_c` to `to_c`.
struct ReferencePiece {
    static constexpr std::size_t size = 15U;
    double from_c{0.0};
    double to_c{0.0};
    std::array<double, size> coefficients{};
    std::size_t terms{size};  ///< coefficients behind these are zero
    ExponentialTerm exponential{};
};

/// Σ d[i]·Eⁱ in °C, approximate, for E from `from_mv` to `to_mv`.
struct InversePiece {
    static constexpr std::size_t size = 11U;
    double from_mv{0.0};
    double to_mv{0.0};
    std::array<double, size> coefficients{};
    std::size_t terms{size};  ///< coefficients behind these are zero
};

/// One type of thermocouple. The pieces ascend; each begins where the one before it ends, or inside it.
struct ThermocoupleCurve {
    static constexpr std::size_t most_reference_pieces = 3U;
    static constexpr std::size_t most_inverse_pieces = 4U;
    std::array<ReferencePiece, most_reference_pieces> reference{};
    std::size_t reference_count{0U};
    std::array<InversePiece, most_inverse_pieces> inverse{};
    std::size_t inverse_count{0U};
    double lowest_c{0.0};   ///< from here to highest_c the voltage rises with the temperature
    double highest_c{0.0};  ///<
};

/// Voltage in mV at `celsius`, reference junction at 0 °C. Beyond the type's range the nearest piece is continued.
double reference_mv(const ThermocoupleCurve& curve, double celsius) noexcept;

/// Slope of reference_mv in mV/°C.
double reference_slope(const ThermocoupleCurve& curve, double celsius) noexcept;

/// Temperature in °C by the inverse function, good to 0.06 °C within its range; beyond it the value at its end.
double approximate_celsius(const ThermocoupleCurve& curve, double mv) noexcept;

/// Temperature in °C at which reference_mv gives `mv`, from lowest_c to highest_c: exact to 1e-6 °C. A voltage beyond
/// that range gives its end.
double exact_celsius(const ThermocoupleCurve& curve, double mv) noexcept;

/// e to the power of `x`, for x of at most 0; relative error below 2e-12.
double decay(double x) noexcept;

}  // namespace canproof
