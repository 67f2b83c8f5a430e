// SPDX-License-Identifier: Apache-2.0
// The objects of the numbered blocks of the AX130751: lookup tables 1 to 10, logic blocks 1 to 3, math blocks 1 to 4.
// For each kind of block a structure has the fields of one block, and an array has these structures for all blocks.
#pragma once

#include <array>

#include "devices/ax130751/firmware/lookup_table.hpp"
#include "firmware/canopen/object_dictionary.hpp"
#include "generated/ax130751/objects.hpp"

namespace canproof::ax130751 {

namespace field = generated::ax130751::field;

constexpr std::uint32_t output_count = 2U;
constexpr std::uint32_t extra_received_count = 6U;
constexpr std::uint32_t table_count = 10U;
constexpr std::uint32_t logic_count = 3U;
constexpr std::uint32_t math_count = 4U;

/// Sets an entry. Returns true when the value changes.
template <typename T>
bool replace(ObjectDictionary& objects, const Field<T> entry, const T value) noexcept {
    const bool changes = objects.get(entry) != value;
    objects.set(entry, value);
    return changes;
}

/// The objects of one lookup table: 3yz0h to 3yz8h, where yz is the number of the table, 01 to 10.
struct LookupFields {
    Field<std::uint8_t> source;
    Field<std::uint8_t> number;
    Field<std::uint8_t> repeat;
    Field<std::uint8_t> x_digits;
    Field<std::uint8_t> y_digits;
    ArrayField<std::uint8_t, lookup_points> response;
    ArrayField<std::int32_t, lookup_points> x;
    ArrayField<std::int16_t, lookup_points> y;
    Field<std::int16_t> output;
};

inline constexpr std::array<LookupFields, table_count> lookup_fields{{
    {field::o3010_lt1_input_x_axis_source, field::o3011_lt1_input_x_axis_number, field::o3012_lt1_auto_repeat,
     field::o3013_lt1_x_axis_decimal_digits_pv, field::o3014_lt1_y_axis_decimal_digits_pv,
     field::o3015_lt1_point_response, field::o3016_lt1_point_x_axis_pv, field::o3017_lt1_point_y_axis_pv,
     field::o3018_lt1_output_y_axis_pv},
    {field::o3020_lt2_input_x_axis_source, field::o3021_lt2_input_x_axis_number, field::o3022_lt2_auto_repeat,
     field::o3023_lt2_x_axis_decimal_digits_pv, field::o3024_lt2_y_axis_decimal_digits_pv,
     field::o3025_lt2_point_response, field::o3026_lt2_point_x_axis_pv, field::o3027_lt2_point_y_axis_pv,
     field::o3028_lt2_output_y_axis_pv},
    {field::o3030_lt3_input_x_axis_source, field::o3031_lt3_input_x_axis_number, field::o3032_lt3_auto_repeat,
     field::o3033_lt3_x_axis_decimal_digits_pv, field::o3034_lt3_y_axis_decimal_digits_pv,
     field::o3035_lt3_point_response, field::o3036_lt3_point_x_axis_pv, field::o3037_lt3_point_y_axis_pv,
     field::o3038_lt3_output_y_axis_pv},
    {field::o3040_lt4_input_x_axis_source, field::o3041_lt4_input_x_axis_number, field::o3042_lt4_auto_repeat,
     field::o3043_lt4_x_axis_decimal_digits_pv, field::o3044_lt4_y_axis_decimal_digits_pv,
     field::o3045_lt4_point_response, field::o3046_lt4_point_x_axis_pv, field::o3047_lt4_point_y_axis_pv,
     field::o3048_lt4_output_y_axis_pv},
    {field::o3050_lt5_input_x_axis_source, field::o3051_lt5_input_x_axis_number, field::o3052_lt5_auto_repeat,
     field::o3053_lt5_x_axis_decimal_digits_pv, field::o3054_lt5_y_axis_decimal_digits_pv,
     field::o3055_lt5_point_response, field::o3056_lt5_point_x_axis_pv, field::o3057_lt5_point_y_axis_pv,
     field::o3058_lt5_output_y_axis_pv},
    {field::o3060_lt6_input_x_axis_source, field::o3061_lt6_input_x_axis_number, field::o3062_lt6_auto_repeat,
     field::o3063_lt6_x_axis_decimal_digits_pv, field::o3064_lt6_y_axis_decimal_digits_pv,
     field::o3065_lt6_point_response, field::o3066_lt6_point_x_axis_pv, field::o3067_lt6_point_y_axis_pv,
     field::o3068_lt6_output_y_axis_pv},
    {field::o3070_lt7_input_x_axis_source, field::o3071_lt7_input_x_axis_number, field::o3072_lt7_auto_repeat,
     field::o3073_lt7_x_axis_decimal_digits_pv, field::o3074_lt7_y_axis_decimal_digits_pv,
     field::o3075_lt7_point_response, field::o3076_lt7_point_x_axis_pv, field::o3077_lt7_point_y_axis_pv,
     field::o3078_lt7_output_y_axis_pv},
    {field::o3080_lt8_input_x_axis_source, field::o3081_lt8_input_x_axis_number, field::o3082_lt8_auto_repeat,
     field::o3083_lt8_x_axis_decimal_digits_pv, field::o3084_lt8_y_axis_decimal_digits_pv,
     field::o3085_lt8_point_response, field::o3086_lt8_point_x_axis_pv, field::o3087_lt8_point_y_axis_pv,
     field::o3088_lt8_output_y_axis_pv},
    {field::o3090_lt9_input_x_axis_source, field::o3091_lt9_input_x_axis_number, field::o3092_lt9_auto_repeat,
     field::o3093_lt9_x_axis_decimal_digits_pv, field::o3094_lt9_y_axis_decimal_digits_pv,
     field::o3095_lt9_point_response, field::o3096_lt9_point_x_axis_pv, field::o3097_lt9_point_y_axis_pv,
     field::o3098_lt9_output_y_axis_pv},
    {field::o3100_lt10_input_x_axis_source, field::o3101_lt10_input_x_axis_number, field::o3102_lt10_auto_repeat,
     field::o3103_lt10_x_axis_decimal_digits_pv, field::o3104_lt10_y_axis_decimal_digits_pv,
     field::o3105_lt10_point_response, field::o3106_lt10_point_x_axis_pv, field::o3107_lt10_point_y_axis_pv,
     field::o3108_lt10_output_y_axis_pv},
}};

/// The entries of the mapping of one RPDO, 1600h to 1603h.
struct MappingFields {
    Field<std::uint8_t> count;
    std::array<Field<std::uint32_t>, 4U> entries;
};

inline constexpr std::array<MappingFields, 4U> rpdo_mappings{{
    {field::o1600_0_number_of_mapped_application_objects_in_pdo,
     {{field::o1600_1_application_object_1, field::o1600_2_application_object_2, field::o1600_3_application_object_3,
       field::o1600_4_application_object_4}}},
    {field::o1601_0_number_of_mapped_application_objects_in_pdo,
     {{field::o1601_1_application_object_1, field::o1601_2_application_object_2, field::o1601_3_application_object_3,
       field::o1601_4_application_object_4}}},
    {field::o1602_0_number_of_mapped_application_objects_in_pdo,
     {{field::o1602_1_application_object_1, field::o1602_2_application_object_2, field::o1602_3_application_object_3,
       field::o1602_4_application_object_4}}},
    {field::o1603_0_number_of_mapped_application_objects_in_pdo,
     {{field::o1603_1_application_object_1, field::o1603_2_application_object_2, field::o1603_3_application_object_3,
       field::o1603_4_application_object_4}}},
}};

/// The object of one condition of a logic block: for condition A1 of logic block 1 this is 3411h.
struct ConditionFields {
    Field<std::uint8_t> first_source;
    Field<std::uint8_t> first_number;
    Field<std::uint8_t> second_source;
    Field<std::uint8_t> second_number;
    Field<std::uint8_t> comparison;
};

/// The objects of one logic block: for logic block 1 these are 3401h, 3402h and the conditions 3411h to 3433h.
struct LogicFields {
    ArrayField<std::uint8_t, 3U> tables;
    ArrayField<std::uint8_t, 3U> operators;
    std::array<ConditionFields, 9U> conditions;  ///< A1, A2, A3, B1, B2, B3, C1, C2, C3
};

inline constexpr std::array<LogicFields, logic_count> logic_fields{{
    {field::o3401_lb1_lookup_table_numbers,
     field::o3402_lb1_function_logical_operator,
     {{
         {field::o3411_1_argument_1_source, field::o3411_2_argument_1_number, field::o3411_3_argument_2_source,
          field::o3411_4_argument_2_number, field::o3411_5_operator},
         {field::o3412_1_argument_1_source, field::o3412_2_argument_1_number, field::o3412_3_argument_2_source,
          field::o3412_4_argument_2_number, field::o3412_5_operator},
         {field::o3413_1_argument_1_source, field::o3413_2_argument_1_number, field::o3413_3_argument_2_source,
          field::o3413_4_argument_2_number, field::o3413_5_operator},
         {field::o3421_1_argument_1_source, field::o3421_2_argument_1_number, field::o3421_3_argument_2_source,
          field::o3421_4_argument_2_number, field::o3421_5_operator},
         {field::o3422_1_argument_1_source, field::o3422_2_argument_1_number, field::o3422_3_argument_2_source,
          field::o3422_4_argument_2_number, field::o3422_5_operator},
         {field::o3423_1_argument_1_source, field::o3423_2_argument_1_number, field::o3423_3_argument_2_source,
          field::o3423_4_argument_2_number, field::o3423_5_operator},
         {field::o3431_1_argument_1_source, field::o3431_2_argument_1_number, field::o3431_3_argument_2_source,
          field::o3431_4_argument_2_number, field::o3431_5_operator},
         {field::o3432_1_argument_1_source, field::o3432_2_argument_1_number, field::o3432_3_argument_2_source,
          field::o3432_4_argument_2_number, field::o3432_5_operator},
         {field::o3433_1_argument_1_source, field::o3433_2_argument_1_number, field::o3433_3_argument_2_source,
          field::o3433_4_argument_2_number, field::o3433_5_operator},
     }}},
    {field::o3501_lb2_lookup_table_numbers,
     field::o3502_lb2_function_logical_operator,
     {{
         {field::o3511_1_argument_1_source, field::o3511_2_argument_1_number, field::o3511_3_argument_2_source,
          field::o3511_4_argument_2_number, field::o3511_5_operator},
         {field::o3512_1_argument_1_source, field::o3512_2_argument_1_number, field::o3512_3_argument_2_source,
          field::o3512_4_argument_2_number, field::o3512_5_operator},
         {field::o3513_1_argument_1_source, field::o3513_2_argument_1_number, field::o3513_3_argument_2_source,
          field::o3513_4_argument_2_number, field::o3513_5_operator},
         {field::o3521_1_argument_1_source, field::o3521_2_argument_1_number, field::o3521_3_argument_2_source,
          field::o3521_4_argument_2_number, field::o3521_5_operator},
         {field::o3522_1_argument_1_source, field::o3522_2_argument_1_number, field::o3522_3_argument_2_source,
          field::o3522_4_argument_2_number, field::o3522_5_operator},
         {field::o3523_1_argument_1_source, field::o3523_2_argument_1_number, field::o3523_3_argument_2_source,
          field::o3523_4_argument_2_number, field::o3523_5_operator},
         {field::o3531_1_argument_1_source, field::o3531_2_argument_1_number, field::o3531_3_argument_2_source,
          field::o3531_4_argument_2_number, field::o3531_5_operator},
         {field::o3532_1_argument_1_source, field::o3532_2_argument_1_number, field::o3532_3_argument_2_source,
          field::o3532_4_argument_2_number, field::o3532_5_operator},
         {field::o3533_1_argument_1_source, field::o3533_2_argument_1_number, field::o3533_3_argument_2_source,
          field::o3533_4_argument_2_number, field::o3533_5_operator},
     }}},
    {field::o3601_lb3_lookup_table_numbers,
     field::o3602_lb3_function_logical_operator,
     {{
         {field::o3611_1_argument_1_source, field::o3611_2_argument_1_number, field::o3611_3_argument_2_source,
          field::o3611_4_argument_2_number, field::o3611_5_operator},
         {field::o3612_1_argument_1_source, field::o3612_2_argument_1_number, field::o3612_3_argument_2_source,
          field::o3612_4_argument_2_number, field::o3612_5_operator},
         {field::o3613_1_argument_1_source, field::o3613_2_argument_1_number, field::o3613_3_argument_2_source,
          field::o3613_4_argument_2_number, field::o3613_5_operator},
         {field::o3621_1_argument_1_source, field::o3621_2_argument_1_number, field::o3621_3_argument_2_source,
          field::o3621_4_argument_2_number, field::o3621_5_operator},
         {field::o3622_1_argument_1_source, field::o3622_2_argument_1_number, field::o3622_3_argument_2_source,
          field::o3622_4_argument_2_number, field::o3622_5_operator},
         {field::o3623_1_argument_1_source, field::o3623_2_argument_1_number, field::o3623_3_argument_2_source,
          field::o3623_4_argument_2_number, field::o3623_5_operator},
         {field::o3631_1_argument_1_source, field::o3631_2_argument_1_number, field::o3631_3_argument_2_source,
          field::o3631_4_argument_2_number, field::o3631_5_operator},
         {field::o3632_1_argument_1_source, field::o3632_2_argument_1_number, field::o3632_3_argument_2_source,
          field::o3632_4_argument_2_number, field::o3632_5_operator},
         {field::o3633_1_argument_1_source, field::o3633_2_argument_1_number, field::o3633_3_argument_2_source,
          field::o3633_4_argument_2_number, field::o3633_5_operator},
     }}},
}};

/// The objects of one math block: 4y00h to 4y50h, where y is the number of the block, 1 to 4.
struct MathFields {
    ArrayField<std::uint8_t, 4U> source;
    ArrayField<std::uint8_t, 4U> number;
    ArrayField<std::uint8_t, 4U> function;
    ArrayField<std::uint8_t, 4U> digits;
    ArrayField<std::int16_t, 4U> scaling_1;
    ArrayField<std::int16_t, 4U> scaling_2;
    ArrayField<std::int8_t, 4U> gain;
    ArrayField<std::uint8_t, 3U> operators;
};

inline constexpr std::array<MathFields, math_count> math_fields{{
    {field::o4100_math_1_input_source, field::o4101_math_1_input_number, field::o4102_math_1_input_function_number,
     field::o4103_math_1_input_decimal_digits_fv, field::o4120_math_1_input_scaling_1_fv,
     field::o4122_math_1_input_scaling_2_fv, field::o4140_math_1_input_gain, field::o4150_math_1_operator},
    {field::o4200_math_2_input_source, field::o4201_math_2_input_number, field::o4202_math_2_input_function_number,
     field::o4203_math_2_input_decimal_digits_fv, field::o4220_math_2_input_scaling_1_fv,
     field::o4222_math_2_input_scaling_2_fv, field::o4240_math_2_input_gain, field::o4250_math_2_operator},
    {field::o4300_math_3_input_source, field::o4301_math_3_input_number, field::o4302_math_3_input_function_number,
     field::o4303_math_3_input_decimal_digits_fv, field::o4320_math_3_input_scaling_1_fv,
     field::o4322_math_3_input_scaling_2_fv, field::o4340_math_3_input_gain, field::o4350_math_3_operator},
    {field::o4400_math_4_input_source, field::o4401_math_4_input_number, field::o4402_math_4_input_function_number,
     field::o4403_math_4_input_decimal_digits_fv, field::o4420_math_4_input_scaling_1_fv,
     field::o4422_math_4_input_scaling_2_fv, field::o4440_math_4_input_gain, field::o4450_math_4_operator},
}};

}  // namespace canproof::ax130751
