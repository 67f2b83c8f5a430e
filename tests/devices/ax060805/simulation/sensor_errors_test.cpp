// SPDX-License-Identifier: Apache-2.0
// Tests the errors of the sensor of a simulated AX060805 (manual, 5.1.1, Table 62), and the effect of a part number
// that is given as the device name.
#include "devices/ax060805/simulation/sensor_errors.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "firmware/base/time.hpp"
#include "generated/ax060805/requirements.hpp"
#include "host/base/input_error.hpp"
#include "host/selection/chosen_devices.hpp"
#include "host/sim/bus/candump.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

using ax060805::SensorErrors;
using ax060805::Vector3;
using ax060805::with_errors;
using host::ChosenDevice;
using host::FactoryOptions;
using host::InputError;
using testing::HasSubstr;

constexpr double radians = 3.14159265358979323846 / 180.0;

constexpr Vector3 level{0.0F, 0.0F, -1.0F};

void expect_felt(const Vector3& felt, double x, double y, double z) {
    EXPECT_NEAR(static_cast<double>(felt.x), x, 1e-6);
    EXPECT_NEAR(static_cast<double>(felt.y), y, 1e-6);
    EXPECT_NEAR(static_cast<double>(felt.z), z, 1e-6);
}

ChosenDevice device_with(const std::string& name, const std::vector<std::string>& given = {}) {
    FactoryOptions options{given};
    ChosenDevice chosen = host::choose_device(name, options);
    options.check_used();
    chosen.device->power_on(Instant{});
    return chosen;
}

double input_of(const ChosenDevice& chosen, const std::string& name) {
    const auto& names = chosen.device->input_names();
    const auto at = std::find(names.begin(), names.end(), name) - names.begin();
    return chosen.device->inputs().at(static_cast<std::size_t>(at));
}

std::string refusal(const std::string& name, const std::string& given) {
    try {
        device_with(name, {given});
    } catch (const InputError& error) {
        return error.what();
    }
    return "taken";
}

/// Returns the acceleration that a unit without errors measures at rest with these Euler angles, in degrees (2.1.5).
Vector3 felt_at(int pitch, int roll) {
    const double theta = pitch * radians;
    const double phi = roll * radians;
    return {static_cast<float>(std::sin(theta)), static_cast<float>(-std::sin(phi) * std::cos(theta)),
            static_cast<float>(-std::cos(phi) * std::cos(theta))};
}

/// Returns the angle between two vectors in degrees.
double angle_between(const Vector3& a, const Vector3& b) {
    const std::array<double, 3> p{static_cast<double>(a.x), static_cast<double>(a.y), static_cast<double>(a.z)};
    const std::array<double, 3> q{static_cast<double>(b.x), static_cast<double>(b.y), static_cast<double>(b.z)};
    const double across = std::hypot(p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]);
    return std::atan2(across, p[0] * q[0] + p[1] * q[1] + p[2] * q[2]) / radians;
}

/// Returns pitch, roll and gravity angle that a level unit shows in thousandths of a degree, 2 s after its sensor has
/// reached this temperature.
std::vector<int> angles_at(double celsius, const std::string& factory_value) {
    const ChosenDevice chosen = device_with("ax060805", {factory_value});
    for (const char* digits : {"67F#2B302001E8030000", "67F#2B302002E8030000", "67F#2B302003E8030000"}) {
        chosen.device->receive(host::parse_frame(digits, "test"), Instant{});  // 2030h is 1000 for each angle
    }
    chosen.device->set_input("sensor_temperature", celsius, Instant{});
    for (std::uint64_t us = 0; us <= 2000000; us += 5000) {
        chosen.device->advance(Instant{us});
    }
    std::vector<int> angles;
    for (const std::uint16_t index : std::vector<std::uint16_t>{0x4030, 0x4040, 0x4050}) {
        angles.push_back(static_cast<std::int16_t>(chosen.device->objects()->read(index, 0)));
    }
    return angles;
}

}  // namespace

TEST(SensorErrors, UnitAsShippedHasNoSensorErrors) {
    verifies<req::INC_PLANT_010>();
    expect_felt(with_errors(level, SensorErrors{}, 85.0), 0.0, 0.0, -1.0);
    expect_felt(with_errors({0.5F, -0.25F, 0.75F}, SensorErrors{}, -40.0), 0.5, -0.25, 0.75);
}

TEST(SensorErrors, InitialSensorErrorMakesALevelUnitMeasureATilt) {
    verifies<req::INC_PLANT_008>();
    // sin 2° / sqrt(2) = 0.0348995 / 1.4142136 = 0.0246777
    expect_felt(with_errors(level, {2.0, 0.0, 0.0, 0.0}, 25.0), 0.0246777, 0.0246777, -1.0);
    expect_felt(with_errors(level, {2.0, 0.0, 0.0, 0.0}, -40.0), 0.0246777, 0.0246777, -1.0);
}

TEST(SensorErrors, DriftAtMinus40DegreesIsThatOfTheSensorTable) {
    verifies<req::INC_PLANT_008, req::INC_K_DRIFT_REFERENCE, req::INC_K_LOWEST_AMBIENT>();
    const SensorErrors errors{0.0, 3.5, 0.0, 0.0};
    expect_felt(with_errors(level, errors, 25.0), 0.0, 0.0, -1.0);
    // sin -3.5° / sqrt(2) = -0.0610485 / 1.4142136 = -0.0431678
    expect_felt(with_errors(level, errors, -40.0), -0.0431678, -0.0431678, -1.0);
    // 60 K above 25 °C the drift is sin (3.5° * 60 / 65) / sqrt(2) = 0.0563577 / 1.4142136 = 0.0398509
    expect_felt(with_errors(level, errors, 85.0), 0.0398509, 0.0398509, -1.0);
}

/// The initial error is 2° at most, and the drift 3.5° at most; together they are at most 5.5° (Table 62).
TEST(SensorErrors, OffsetTurnsTheMeasuredDirectionOfGravityByAtMostTheErrorInEachAttitude) {
    verifies<req::INC_PLANT_012>();
    for (const double error : {-5.5, -2.0, 0.5, 2.0, 3.5, 5.5}) {
        double worst = 0.0;
        for (int pitch = -90; pitch <= 90; pitch += 5) {
            for (int roll = -180; roll < 180; roll += 5) {
                const Vector3 right = felt_at(pitch, roll);
                worst = std::max(worst, angle_between(right, with_errors(right, {error, 0.0, 0.0, 0.0}, 25.0)));
            }
        }
        EXPECT_LT(worst, std::fabs(error) + 2e-5);  // 2e-5° is 3e-7 g: the rounding of two accelerations
        EXPECT_GT(worst, 0.99 * std::fabs(error));
    }
}

TEST(SensorErrors, NonLinearityIsZeroAt0And1gAndLargestInBetween) {
    verifies<req::INC_PLANT_009>();
    const SensorErrors errors{0.0, 0.0, 0.7, 0.0};
    expect_felt(with_errors({1.0F, 0.0F, -1.0F}, errors, 25.0), 1.0, 0.0, -1.0);
    // The non-linearity of 0.7 % increases the magnitude of each axis by 0.007.
    expect_felt(with_errors({0.57735027F, -0.57735027F, 0.0F}, errors, 25.0), 0.5843503, -0.5843503, 0.0);
    expect_felt(with_errors({2.0F, -1.5F, 0.0F}, errors, 25.0), 2.0, -1.5, 0.0);
    for (int thousandths = -1000; thousandths <= 1000; ++thousandths) {
        const float g = static_cast<float>(thousandths) / 1000.0F;
        EXPECT_LE(std::abs(with_errors({g, 0.0F, 0.0F}, errors, 25.0).x - g), 0.0070001F) << g;
    }
}

TEST(SensorErrors, CrossAxisErrorAddsAShareOfTheNextAxis) {
    verifies<req::INC_PLANT_004>();
    const SensorErrors errors{0.0, 0.0, 0.0, 3.5};
    expect_felt(with_errors(level, errors, 25.0), 0.0, -0.035, -1.0);
    expect_felt(with_errors({1.0F, 0.0F, 0.0F}, errors, 25.0), 1.0, 0.0, 0.035);
    expect_felt(with_errors({0.0F, 1.0F, 0.0F}, errors, 25.0), 0.035, 1.0, 0.0);
}

/// Table 62: the errors of a unit do not exceed those of its part number.
TEST(SensorErrors, LimitsOfSensorErrorsAreThoseOfThePartNumber) {
    verifies<req::INC_PLANT_011, req::INC_T62, req::INC_K_INITIAL_ACCURACY>();
    for (const char* first :
         {"sensor_initial_error=2", "sensor_drift=-3.5", "sensor_nonlinearity=0.7", "sensor_cross_axis=3.5"}) {
        EXPECT_EQ(refusal("ax060805", first), "taken") << first;
    }
    for (const char* name : {"ax060835", "AX060840@5", "ax060841"}) {
        for (const char* most :
             {"sensor_initial_error=-2", "sensor_drift=3", "sensor_nonlinearity=-0.1", "sensor_cross_axis=1"}) {
            EXPECT_EQ(refusal(name, most), "taken") << name << " " << most;
        }
        EXPECT_THAT(refusal(name, "sensor_initial_error=2.01"), HasSubstr("-2 … 2"));
        EXPECT_THAT(refusal(name, "sensor_drift=3.01"), HasSubstr("-3 … 3"));
        EXPECT_THAT(refusal(name, "sensor_nonlinearity=-0.11"), HasSubstr("-0.1 … 0.1"));
        EXPECT_THAT(refusal(name, "sensor_cross_axis=1.01"), HasSubstr("-1 … 1"));
    }
    EXPECT_THAT(refusal("ax060805", "sensor_nonlinearity=0.71"), HasSubstr("-0.7 … 0.7"));
    EXPECT_THAT(refusal("ax188001", "sensor_drift=1"), HasSubstr("no sensor_drift"));
}

/// The angles are in thousandths of a degree. With the offset o on X and Y, the angles of section 2.1.4 of a level unit
/// are pitch = atan(o / sqrt(1 + o^2)), roll = -pitch, and gravity angle = atan(sqrt(2) o).
TEST(SensorErrors, AnglesOfALevelUnitKeepTheLimitsOfTheSensorTable) {
    verifies<req::INC_PLANT_004, req::INC_PLANT_011, req::INC_PLANT_012>();
    EXPECT_EQ(angles_at(25.0, "sensor_initial_error=0"), (std::vector<int>{0, 0, 0}));
    // o = sin 2° / sqrt(2) = 0.0246777; Table 62 allows 2°
    EXPECT_EQ(angles_at(25.0, "sensor_initial_error=2"), (std::vector<int>{1413, -1413, 1999}));
    EXPECT_EQ(angles_at(25.0, "sensor_initial_error=-2"), (std::vector<int>{-1413, 1413, 1999}));
    // o = sin (3.5° * 60 / 65) / sqrt(2) = 0.0398509; Table 62 allows 3.5°
    EXPECT_EQ(angles_at(85.0, "sensor_drift=3.5"), (std::vector<int>{2280, -2280, 3226}));
    // o = -sin 3.5° / sqrt(2) = -0.0431678
    EXPECT_EQ(angles_at(-40.0, "sensor_drift=3.5"), (std::vector<int>{-2470, 2470, 3493}));
}

/// From 25 to 85 degC the drift of 3 degrees changes by 3 * 60 / 65 = 2.77 degrees: sin 2.77° / sqrt(2) = 0.0341627.
TEST(SensorErrors, SensorDriftFollowsTheTemperatureOfTheSensor) {
    verifies<req::INC_PLANT_008>();
    const ChosenDevice chosen = device_with("ax060841", {"sensor_drift=3"});
    chosen.device->set_input("noise_of", 0.0, Instant{});
    EXPECT_NEAR(input_of(chosen, "acceleration_x"), 0.0, 1e-6);
    chosen.device->set_input("sensor_temperature", 85.0, Instant{});
    EXPECT_NEAR(input_of(chosen, "acceleration_x"), 0.0341627, 1e-6);
}

TEST(PartNumbers, PartNumberOfAnInclinometerSetsItsNoise) {
    verifies<req::INC_PLANT_005>();
    const std::vector<std::pair<const char*, double>> names{
        {"ax060805", 0.0}, {"AX060805@5", 0.0}, {"ax060835", 60835.0}, {"AX060840", 60840.0}, {"ax060841@5", 60841.0}};
    for (const auto& [name, noise_of] : names) {
        const ChosenDevice chosen = device_with(name);
        EXPECT_EQ(input_of(chosen, "noise_of"), noise_of) << name;
        EXPECT_EQ(input_of(chosen, "acceleration_x") != 0.0, noise_of != 0.0) << name;
    }
    EXPECT_EQ(input_of(device_with("ax060841"), "acceleration_x"), input_of(device_with("ax060841"), "acceleration_x"));
}

TEST(PartNumbers, PartNumbersOnTheManualCoversAreAcceptedAsDeviceNames) {
    for (const char* name : {"ax060805", "ax060835", "ax060840", "ax060841", "ax130751", "ax130771", "AX130771@9",
                             "ax188001", "cbx-ao412", "c.3040.02"}) {
        EXPECT_EQ(device_with(name).name, name);
    }
}

}  // namespace canproof::test
