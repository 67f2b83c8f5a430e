// SPDX-License-Identifier: Apache-2.0
// Tests how the signals attitude, noise and supply affect the simulated AX060805 (manual, 3.9, 5.1.1).
#include "devices/ax060805/simulation/inclinometer_plant.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

#include "devices/catalogue.hpp"
#include "generated/ax060805/requirements.hpp"
#include "host/sim/devices/simulated_device.hpp"
#include "tests/support/frame_bench.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

/// Fixture that tests the model of the sensor (plant) without a device: a stimulus changes the device's inputs.
class InclinometerPlantTest : public testing::Test {
  protected:
    void expect_felt(float x, float y, float z) {
        EXPECT_NEAR(inputs.acceleration_x, x, 1e-6F);
        EXPECT_NEAR(inputs.acceleration_y, y, 1e-6F);
        EXPECT_NEAR(inputs.acceleration_z, z, 1e-6F);
    }
    void set(float ax060805::Inputs::*input, const char* name, float value) {
        inputs.*input = value;
        plant.stimulus(name, inputs);
    }
    /// Returns the mean products of the noise of a level unit over many samples: XX, YY, ZZ, XY, YZ and ZX.
    std::array<double, 6> products() {
        std::array<double, 6> sums{};
        constexpr int samples = 20000;
        for (int sample = 0; sample < samples; ++sample) {
            plant.add_noise(inputs);
            const auto x = static_cast<double>(inputs.acceleration_x);
            const auto y = static_cast<double>(inputs.acceleration_y);
            const auto z = static_cast<double>(inputs.acceleration_z) + 1.0;  // at rest, Z is -1 g
            const std::array<double, 6> now{x * x, y * y, z * z, x * y, y * z, z * x};
            for (std::size_t at = 0; at < sums.size(); ++at) {
                sums[at] += now[at] / samples;
            }
        }
        return sums;
    }

    ax060805::Inputs inputs{};
    ax060805::InclinometerPlant plant;
};

/// Advances a simulated device until `end` and returns the frames that it sends.
Frames frames_until(host::SimulatedDevice& device, Instant end) {
    Frames all;
    while (device.next_deadline() <= end) {
        device.advance(device.next_deadline());
        while (!device.queue().empty()) {
            all.push_back(host::format_frame(device.queue().pop()));
        }
    }
    return all;
}

}  // namespace

TEST_F(InclinometerPlantTest, SimulatedAccelerationsFollowThePitchAndRollStimuli) {
    verifies<req::INC_PLANT_001, req::INC_PLANT_013, req::INC_S_PITCH, req::INC_S_ROLL>();
    set(&ax060805::Inputs::pitch, "pitch", 30.0F);
    expect_felt(0.5F, 0.0F, -0.8660254F);
    set(&ax060805::Inputs::roll, "roll", 90.0F);
    expect_felt(0.5F, -0.8660254F, 0.0F);
}

TEST_F(InclinometerPlantTest, SimulatedAccelerationsFollowTheQuaternionOfTheAttitude) {
    verifies<req::INC_PLANT_001, req::INC_PLANT_013, req::INC_S_ATTITUDE_W, req::INC_S_ATTITUDE_X,
             req::INC_S_ATTITUDE_Y, req::INC_S_ATTITUDE_Z>();
    // A turn of 30 degrees about Y, nose up, is the quaternion (cos 15, 0, sin 15, 0).
    set(&ax060805::Inputs::attitude_w, "attitude_w", 0.9659258F);
    set(&ax060805::Inputs::attitude_y, "attitude_y", 0.2588190F);
    expect_felt(0.5F, 0.0F, -0.8660254F);
    // A turn of 90 degrees about X is the quaternion (1, 1, 0, 0); a quaternion may have any length.
    set(&ax060805::Inputs::attitude_y, "attitude_y", 0.0F);
    set(&ax060805::Inputs::attitude_w, "attitude_w", 0.5F);
    set(&ax060805::Inputs::attitude_x, "attitude_x", 0.5F);
    expect_felt(0.0F, -1.0F, 0.0F);
    // a turn about the vertical changes nothing
    set(&ax060805::Inputs::attitude_x, "attitude_x", 0.0F);
    set(&ax060805::Inputs::attitude_z, "attitude_z", 0.5F);
    expect_felt(0.0F, 0.0F, -1.0F);
    // the quaternion 0 describes no rotation: the unit stays level
    set(&ax060805::Inputs::attitude_z, "attitude_z", 0.0F);
    set(&ax060805::Inputs::attitude_w, "attitude_w", 0.0F);
    expect_felt(0.0F, 0.0F, -1.0F);
}

TEST_F(InclinometerPlantTest, SimulatedAccelerationsFollowTheLatestStimulus) {
    verifies<req::INC_PLANT_013>();
    set(&ax060805::Inputs::pitch, "pitch", 30.0F);
    set(&ax060805::Inputs::acceleration_y, "acceleration_y", 0.25F);
    expect_felt(0.5F, 0.25F, -0.8660254F);
    set(&ax060805::Inputs::acceleration_x, "acceleration_x", 0.125F);
    set(&ax060805::Inputs::acceleration_z, "acceleration_z", -0.75F);
    expect_felt(0.125F, 0.25F, -0.75F);
    set(&ax060805::Inputs::roll, "roll", 0.0F);
    expect_felt(0.5F, 0.0F, -0.8660254F);
}

TEST_F(InclinometerPlantTest, SensorNoiseIsThatOfThePartNumber) {
    verifies<req::INC_PLANT_002, req::INC_PLANT_006, req::INC_T62, req::INC_K_RESOLUTION_FACTOR,
             req::INC_K_RATED_CUT_OFF, req::INC_S_NOISE>();
    // For the AX060805 the noise after the input filter is 0.35 deg / 3.46 = 0.10116 deg = 1.7655 mrad, which is 1.7655
    // mg. The filter (coefficient 0.145364) passes the share sqrt(0.145364 / 1.854636) = 0.27996 of white noise. So the
    // noise before the filter is 6.306 mg.
    const std::vector<std::pair<std::uint16_t, double>> parts{
        {60805, 0.006306}, {60835, 0.001081}, {60840, 0.001081}, {60841, 0.001081}, {0, 0.0},    {60804, 0.0},
        {60806, 0.0},      {60834, 0.0},      {60836, 0.0},      {60839, 0.0},      {60842, 0.0}};
    for (const auto& [part, expected] : parts) {
        inputs.noise_of = part;
        plant.stimulus("noise_of", inputs);
        EXPECT_EQ(plant.is_noisy(inputs), expected > 0.0) << part;
        const std::array<double, 6> noise = products();
        for (std::size_t axis = 0; axis < 3; ++axis) {
            // 6 sigma of 20000 samples are 6 / sqrt(2 * 20000) = 3 %; single precision rounds Z by 6e-8 g at most
            EXPECT_NEAR(std::sqrt(noise[axis]), expected, expected * 0.03 + 1e-7) << part << ", axis " << axis;
        }
        for (std::size_t pair = 3; pair < 6; ++pair) {
            // the axes have independent noise: 6 sigma of 20000 products are 6 / sqrt(20000) = 0.042
            EXPECT_NEAR(noise[pair], 0.0, expected * expected * 0.043) << part << ", pair " << pair;
        }
    }
}

TEST_F(InclinometerPlantTest, SameSeedGivesTheSameSensorNoise) {
    verifies<req::INC_PLANT_007, req::INC_S_NOISE_SEED>();
    const auto noise_of_seed = [this](std::uint32_t seed) {
        inputs.noise_of = 60805;
        inputs.noise_seed = seed;
        plant.stimulus("noise_seed", inputs);
        return std::vector<float>{inputs.acceleration_x, inputs.acceleration_y, inputs.acceleration_z};
    };
    const auto first = noise_of_seed(7);
    EXPECT_NE(noise_of_seed(8), first);
    EXPECT_EQ(noise_of_seed(7), first);
    EXPECT_NE(first[0], first[1]);
}

TEST_F(InclinometerPlantTest, ProtectionCircuitLowersTheSupplyVoltageBy800mV) {
    verifies<req::INC_PLANT_003, req::INC_K_SUPPLY_DROP, req::INC_S_CONNECTOR>();
    set(&ax060805::Inputs::connector_voltage, "connector_voltage", 12.0F);
    EXPECT_NEAR(inputs.supply_voltage, 11.2F, 1e-5F);
    set(&ax060805::Inputs::connector_voltage, "connector_voltage", 0.5F);
    EXPECT_EQ(inputs.supply_voltage, 0.0F);
}

TEST(InclinometerSimulation, SimulationSendsTheAngleOfItsStimulus) {
    verifies<req::INC_PLANT_001, req::INC_S_PITCH>();
    const auto device = host::make_device("ax060805");
    ASSERT_NE(device, nullptr);
    device->set_node_id(5);
    device->power_on(Instant{});
    EXPECT_TRUE(device->set_input("pitch", 30.0, Instant{}));
    EXPECT_FALSE(device->set_input("yaw", 30.0, Instant{}));
    frames_until(*device, Instant{1000000});
    device->receive(host::parse_frame("000#0100", "test"), Instant{1000000});
    ASSERT_FALSE(device->queue().empty());
    // The PDO contains pitch 30, roll 0 and gravity angle 30 degrees.
    EXPECT_EQ(host::format_frame(device->queue().pop()), "185#1E0000001E0000");
}

TEST(InclinometerSimulation, SimulatedPitchScattersByTheRatedResolution) {
    verifies<req::INC_PLANT_006>();
    const auto device = host::make_device("ax060805");
    device->power_on(Instant{});
    device->set_input("noise_of", 60805, Instant{});
    for (const char* frame : {"67F#2B302001E8030000", "000#0100"}) {  // 2030h:1: pitch in thousandths of a degree
        device->receive(host::parse_frame(frame, "test"), Instant{});
    }
    double sum = 0.0;
    int count = 0;
    for (const auto& frame : frames_until(*device, Instant{1000000000})) {
        if (frame.substr(0, 4) == "1FF#") {
            const int low = std::stoi(frame.substr(4, 2), nullptr, 16);
            const int high = std::stoi(frame.substr(6, 2), nullptr, 16);
            const double pitch = static_cast<std::int16_t>(high * 256 + low) / 1000.0;
            sum += pitch * pitch;
            ++count;
        }
    }
    EXPECT_EQ(count, 4001);
    EXPECT_NEAR(std::sqrt(sum / count), 0.35 / 3.46, 0.35 / 3.46 * 0.08);  // 6 sigma of 4001 samples
}

}  // namespace canproof::test
