// SPDX-License-Identifier: Apache-2.0
// Checks every entry of the AX060805's dictionary against chapter 4 of its manual and the decisions of the requirements
// register: value after power-on of a level unit, length and access. Node 127.
#include "generated/ax060805/requirements.hpp"
#include "tests/devices/ax060805/inclinometer_bench.hpp"
#include "tests/support/verifies.hpp"

namespace canproof::test {

namespace {

struct Row {
    std::uint16_t index;
    std::uint8_t sub;
    std::uint32_t value;
    int bytes;
    bool writable;
};

// The entries of sections 4.2.1 to 4.3.45, written by hand. 1.0 = 3F800000h; a level unit measures -1 g on Z, 25 and 30
// degrees Celsius and 23.2 V (41B9999Ah), and its input filter has a delay of 31.8 ms.
const std::vector<Row> rows{
    {0x1000, 0, 0x1003019A, 4, false}, {0x1001, 0, 0, 1, false},         {0x1002, 0, 0, 4, false},
    {0x1003, 0, 0, 1, true},           {0x1003, 1, 0, 4, false},         {0x1003, 2, 0, 4, false},
    {0x1003, 3, 0, 4, false},          {0x1003, 4, 0, 4, false},         {0x100C, 0, 0, 2, true},
    {0x100D, 0, 0, 1, true},           {0x1010, 0, 3, 1, false},         {0x1010, 1, 1, 4, true},
    {0x1010, 2, 1, 4, true},           {0x1010, 3, 1, 4, true},          {0x1011, 0, 3, 1, false},
    {0x1011, 1, 1, 4, true},           {0x1011, 2, 1, 4, true},          {0x1011, 3, 1, 4, true},
    {0x1016, 0, 1, 1, false},          {0x1016, 1, 0, 4, true},          {0x1017, 0, 0, 2, true},
    {0x1018, 0, 4, 1, false},          {0x1018, 1, 0x55, 4, false},      {0x1018, 2, 0xAA060805, 4, false},
    {0x1018, 3, 0x00010101, 4, false}, {0x1018, 4, 1, 4, false},         {0x1020, 0, 2, 1, false},
    {0x1020, 1, 0x01012024, 4, false}, {0x1020, 2, 0, 4, false},         {0x1029, 0, 2, 1, false},
    {0x1029, 1, 0, 1, true},           {0x1029, 2, 0, 1, true},          {0x1400, 0, 5, 1, false},
    {0x1400, 1, 0x4000027F, 4, true},  {0x1400, 2, 255, 1, false},       {0x1400, 3, 0, 2, true},
    {0x1400, 4, 0, 1, true},           {0x1400, 5, 0, 2, true},          {0x1401, 0, 5, 1, false},
    {0x1401, 1, 0xC000037F, 4, true},  {0x1401, 2, 255, 1, false},       {0x1401, 3, 0, 2, true},
    {0x1401, 4, 0, 1, true},           {0x1401, 5, 0, 2, true},          {0x1402, 0, 5, 1, false},
    {0x1402, 1, 0xC000047F, 4, true},  {0x1402, 2, 255, 1, false},       {0x1402, 3, 0, 2, true},
    {0x1402, 4, 0, 1, true},           {0x1402, 5, 0, 2, true},          {0x1403, 0, 5, 1, false},
    {0x1403, 1, 0xC000057F, 4, true},  {0x1403, 2, 255, 1, false},       {0x1403, 3, 0, 2, true},
    {0x1403, 4, 0, 1, true},           {0x1403, 5, 0, 2, true},          {0x1800, 0, 5, 1, false},
    {0x1800, 1, 0x400001FF, 4, true},  {0x1800, 2, 254, 1, false},       {0x1800, 3, 0, 2, true},
    {0x1800, 4, 0, 1, true},           {0x1800, 5, 250, 2, true},        {0x1801, 0, 5, 1, false},
    {0x1801, 1, 0x400002FF, 4, true},  {0x1801, 2, 254, 1, false},       {0x1801, 3, 0, 2, true},
    {0x1801, 4, 0, 1, true},           {0x1801, 5, 0, 2, true},          {0x1802, 0, 5, 1, false},
    {0x1802, 1, 0x400003FF, 4, true},  {0x1802, 2, 254, 1, false},       {0x1802, 3, 0, 2, true},
    {0x1802, 4, 0, 1, true},           {0x1802, 5, 0, 2, true},          {0x1803, 0, 5, 1, false},
    {0x1803, 1, 0xC00004FF, 4, true},  {0x1803, 2, 254, 1, false},       {0x1803, 3, 0, 2, true},
    {0x1803, 4, 0, 1, true},           {0x1803, 5, 0, 2, true},          {0x1600, 0, 3, 1, true},
    {0x1600, 1, 0x25000110, 4, true},  {0x1600, 2, 0x25000210, 4, true}, {0x1600, 3, 0x25000310, 4, true},
    {0x1600, 4, 0, 4, true},           {0x1601, 0, 0, 1, true},          {0x1601, 1, 0, 4, true},
    {0x1601, 2, 0, 4, true},           {0x1601, 3, 0, 4, true},          {0x1601, 4, 0, 4, true},
    {0x1602, 0, 0, 1, true},           {0x1602, 1, 0, 4, true},          {0x1602, 2, 0, 4, true},
    {0x1602, 3, 0, 4, true},           {0x1602, 4, 0, 4, true},          {0x1603, 0, 0, 1, true},
    {0x1603, 1, 0, 4, true},           {0x1603, 2, 0, 4, true},          {0x1603, 3, 0, 4, true},
    {0x1603, 4, 0, 4, true},           {0x1A00, 0, 4, 1, true},          {0x1A00, 1, 0x40300010, 4, true},
    {0x1A00, 2, 0x40400010, 4, true},  {0x1A00, 3, 0x40500010, 4, true}, {0x1A00, 4, 0x40200008, 4, true},
    {0x1A01, 0, 4, 1, true},           {0x1A01, 1, 0x40000110, 4, true}, {0x1A01, 2, 0x40000210, 4, true},
    {0x1A01, 3, 0x40000310, 4, true},  {0x1A01, 4, 0x40600010, 4, true}, {0x1A02, 0, 2, 1, true},
    {0x1A02, 1, 0x50200020, 4, true},  {0x1A02, 2, 0x50300020, 4, true}, {0x1A02, 3, 0, 4, true},
    {0x1A02, 4, 0, 4, true},           {0x1A03, 0, 0, 1, true},          {0x1A03, 1, 0, 4, true},
    {0x1A03, 2, 0, 4, true},           {0x1A03, 3, 0, 4, true},          {0x1A03, 4, 0, 4, true},
    {0x2000, 0, 0, 1, true},           {0x2002, 0, 1, 1, true},          {0x2003, 0, 5, 1, true},
    {0x2010, 0, 3, 1, false},          {0x2010, 1, 1, 2, true},          {0x2010, 2, 1, 2, true},
    {0x2010, 3, 1, 2, true},           {0x2011, 0, 3, 1, false},         {0x2011, 1, 0, 1, true},
    {0x2011, 2, 0, 1, true},           {0x2011, 3, 0, 1, true},          {0x2020, 0, 3, 1, false},
    {0x2020, 1, 0, 4, true},           {0x2020, 2, 0, 4, true},          {0x2020, 3, 0, 4, true},
    {0x2030, 0, 3, 1, false},          {0x2030, 1, 1, 2, true},          {0x2030, 2, 1, 2, true},
    {0x2030, 3, 1, 2, true},           {0x2031, 0, 3, 1, false},         {0x2031, 1, 0, 1, true},
    {0x2031, 2, 0, 1, true},           {0x2031, 3, 0, 1, true},          {0x2040, 0, 3, 1, false},
    {0x2040, 1, 0, 4, true},           {0x2040, 2, 0, 4, true},          {0x2040, 3, 0, 4, true},
    {0x2050, 0, 3, 1, false},          {0x2050, 1, 0, 1, true},          {0x2050, 2, 0, 1, true},
    {0x2050, 3, 0, 1, true},           {0x2051, 0, 3, 1, false},         {0x2051, 1, 10, 2, true},
    {0x2051, 2, 10, 2, true},          {0x2051, 3, 10, 2, true},         {0x2052, 0, 10, 2, true},
    {0x2100, 0, 1, 1, true},           {0x2200, 0, 0, 4, true},          {0x2210, 0, 0, 4, true},
    {0x2300, 0, 0, 1, true},           {0x2400, 0, 0, 4, false},         {0x2401, 0, 0, 4, false},
    {0x2500, 0, 3, 1, false},          {0x2500, 1, 0, 2, true},          {0x2500, 2, 0, 2, true},
    {0x2500, 3, 0, 2, true},           {0x2501, 0, 3, 1, false},         {0x2501, 1, 1000, 2, true},
    {0x2501, 2, 1000, 2, true},        {0x2501, 3, 1000, 2, true},       {0x2502, 0, 3, 1, false},
    {0x2502, 1, 0, 4, true},           {0x2502, 2, 0, 4, true},          {0x2502, 3, 0, 4, true},
    {0x3000, 0, 10, 1, false},         {0x3000, 1, 0, 2, false},         {0x3000, 2, 0, 2, false},
    {0x3000, 3, 0, 2, false},          {0x3000, 4, 0, 2, false},         {0x3000, 5, 0, 2, false},
    {0x3000, 6, 0, 2, false},          {0x3000, 7, 0, 2, false},         {0x3000, 8, 0, 2, false},
    {0x3000, 9, 0, 2, false},          {0x3000, 10, 0, 2, false},        {0x300A, 0, 10, 1, false},
    {0x300A, 1, 0, 1, true},           {0x300A, 2, 0, 1, true},          {0x300A, 3, 0, 1, true},
    {0x300A, 4, 0, 1, true},           {0x300A, 5, 0, 1, true},          {0x300A, 6, 0, 1, true},
    {0x300A, 7, 0, 1, true},           {0x300A, 8, 0, 1, true},          {0x300A, 9, 0, 1, true},
    {0x300A, 10, 0, 1, true},          {0x300B, 0, 10, 1, false},        {0x300B, 1, 0x3F800000, 4, true},
    {0x300B, 2, 0x3F800000, 4, true},  {0x300B, 3, 0x3F800000, 4, true}, {0x300B, 4, 0x3F800000, 4, true},
    {0x300B, 5, 0x3F800000, 4, true},  {0x300B, 6, 0x3F800000, 4, true}, {0x300B, 7, 0x3F800000, 4, true},
    {0x300B, 8, 0x3F800000, 4, true},  {0x300B, 9, 0x3F800000, 4, true}, {0x300B, 10, 0x3F800000, 4, true},
    {0x300C, 0, 10, 1, false},         {0x300C, 1, 0, 4, true},          {0x300C, 2, 0, 4, true},
    {0x300C, 3, 0, 4, true},           {0x300C, 4, 0, 4, true},          {0x300C, 5, 0, 4, true},
    {0x300C, 6, 0, 4, true},           {0x300C, 7, 0, 4, true},          {0x300C, 8, 0, 4, true},
    {0x300C, 9, 0, 4, true},           {0x300C, 10, 0, 4, true},         {0x3010, 0, 2, 1, false},
    {0x3010, 1, 0, 1, true},           {0x3010, 2, 0, 1, true},          {0x3011, 0, 2, 1, false},
    {0x3011, 1, 0, 1, true},           {0x3011, 2, 0, 1, true},          {0x3012, 0, 2, 1, false},
    {0x3012, 1, 0, 4, true},           {0x3012, 2, 0, 4, true},          {0x3013, 0, 2, 1, false},
    {0x3013, 1, 0, 1, true},           {0x3013, 2, 0, 1, true},          {0x3014, 0, 2, 1, false},
    {0x3014, 1, 0x3F800000, 4, true},  {0x3014, 2, 0x3F800000, 4, true}, {0x3015, 0, 2, 1, false},
    {0x3015, 1, 0, 4, true},           {0x3015, 2, 0, 4, true},          {0x3020, 0, 2, 1, false},
    {0x3020, 1, 0, 1, true},           {0x3020, 2, 0, 1, true},          {0x3021, 0, 2, 1, false},
    {0x3021, 1, 0, 1, true},           {0x3021, 2, 0, 1, true},          {0x3022, 0, 2, 1, false},
    {0x3022, 1, 0, 4, true},           {0x3022, 2, 0, 4, true},          {0x3023, 0, 2, 1, false},
    {0x3023, 1, 0, 1, true},           {0x3023, 2, 0, 1, true},          {0x3024, 0, 2, 1, false},
    {0x3024, 1, 0x3F800000, 4, true},  {0x3024, 2, 0x3F800000, 4, true}, {0x3025, 0, 2, 1, false},
    {0x3025, 1, 0, 4, true},           {0x3025, 2, 0, 4, true},          {0x3030, 0, 2, 1, false},
    {0x3030, 1, 0, 1, true},           {0x3030, 2, 0, 1, true},          {0x3031, 0, 2, 1, false},
    {0x3031, 1, 0, 1, true},           {0x3031, 2, 0, 1, true},          {0x3032, 0, 2, 1, false},
    {0x3032, 1, 0, 4, true},           {0x3032, 2, 0, 4, true},          {0x3033, 0, 2, 1, false},
    {0x3033, 1, 0, 1, true},           {0x3033, 2, 0, 1, true},          {0x3034, 0, 2, 1, false},
    {0x3034, 1, 0x3F800000, 4, true},  {0x3034, 2, 0x3F800000, 4, true}, {0x3035, 0, 2, 1, false},
    {0x3035, 1, 0, 4, true},           {0x3035, 2, 0, 4, true},          {0x3040, 0, 2, 1, false},
    {0x3040, 1, 0, 1, true},           {0x3040, 2, 0, 1, true},          {0x3041, 0, 2, 1, false},
    {0x3041, 1, 0, 1, true},           {0x3041, 2, 0, 1, true},          {0x3042, 0, 2, 1, false},
    {0x3042, 1, 0, 4, true},           {0x3042, 2, 0, 4, true},          {0x3043, 0, 2, 1, false},
    {0x3043, 1, 0, 1, true},           {0x3043, 2, 0, 1, true},          {0x3044, 0, 2, 1, false},
    {0x3044, 1, 0x3F800000, 4, true},  {0x3044, 2, 0x3F800000, 4, true}, {0x3045, 0, 2, 1, false},
    {0x3045, 1, 0, 4, true},           {0x3045, 2, 0, 4, true},          {0x3050, 0, 2, 1, false},
    {0x3050, 1, 0, 1, true},           {0x3050, 2, 0, 1, true},          {0x3051, 0, 2, 1, false},
    {0x3051, 1, 0, 1, true},           {0x3051, 2, 0, 1, true},          {0x3052, 0, 2, 1, false},
    {0x3052, 1, 0, 4, true},           {0x3052, 2, 0, 4, true},          {0x3053, 0, 2, 1, false},
    {0x3053, 1, 0, 1, true},           {0x3053, 2, 0, 1, true},          {0x3054, 0, 2, 1, false},
    {0x3054, 1, 0x3F800000, 4, true},  {0x3054, 2, 0x3F800000, 4, true}, {0x3055, 0, 2, 1, false},
    {0x3055, 1, 0, 4, true},           {0x3055, 2, 0, 4, true},          {0x3060, 0, 2, 1, false},
    {0x3060, 1, 0, 1, true},           {0x3060, 2, 0, 1, true},          {0x3061, 0, 2, 1, false},
    {0x3061, 1, 0, 1, true},           {0x3061, 2, 0, 1, true},          {0x3062, 0, 2, 1, false},
    {0x3062, 1, 0, 4, true},           {0x3062, 2, 0, 4, true},          {0x3063, 0, 2, 1, false},
    {0x3063, 1, 0, 1, true},           {0x3063, 2, 0, 1, true},          {0x3064, 0, 2, 1, false},
    {0x3064, 1, 0x3F800000, 4, true},  {0x3064, 2, 0x3F800000, 4, true}, {0x3065, 0, 2, 1, false},
    {0x3065, 1, 0, 4, true},           {0x3065, 2, 0, 4, true},          {0x3070, 0, 2, 1, false},
    {0x3070, 1, 0, 1, true},           {0x3070, 2, 0, 1, true},          {0x3071, 0, 2, 1, false},
    {0x3071, 1, 0, 1, true},           {0x3071, 2, 0, 1, true},          {0x3072, 0, 2, 1, false},
    {0x3072, 1, 0, 4, true},           {0x3072, 2, 0, 4, true},          {0x3073, 0, 2, 1, false},
    {0x3073, 1, 0, 1, true},           {0x3073, 2, 0, 1, true},          {0x3074, 0, 2, 1, false},
    {0x3074, 1, 0x3F800000, 4, true},  {0x3074, 2, 0x3F800000, 4, true}, {0x3075, 0, 2, 1, false},
    {0x3075, 1, 0, 4, true},           {0x3075, 2, 0, 4, true},          {0x3080, 0, 2, 1, false},
    {0x3080, 1, 0, 1, true},           {0x3080, 2, 0, 1, true},          {0x3081, 0, 2, 1, false},
    {0x3081, 1, 0, 1, true},           {0x3081, 2, 0, 1, true},          {0x3082, 0, 2, 1, false},
    {0x3082, 1, 0, 4, true},           {0x3082, 2, 0, 4, true},          {0x3083, 0, 2, 1, false},
    {0x3083, 1, 0, 1, true},           {0x3083, 2, 0, 1, true},          {0x3084, 0, 2, 1, false},
    {0x3084, 1, 0x3F800000, 4, true},  {0x3084, 2, 0x3F800000, 4, true}, {0x3085, 0, 2, 1, false},
    {0x3085, 1, 0, 4, true},           {0x3085, 2, 0, 4, true},          {0x3090, 0, 2, 1, false},
    {0x3090, 1, 0, 1, true},           {0x3090, 2, 0, 1, true},          {0x3091, 0, 2, 1, false},
    {0x3091, 1, 0, 1, true},           {0x3091, 2, 0, 1, true},          {0x3092, 0, 2, 1, false},
    {0x3092, 1, 0, 4, true},           {0x3092, 2, 0, 4, true},          {0x3093, 0, 2, 1, false},
    {0x3093, 1, 0, 1, true},           {0x3093, 2, 0, 1, true},          {0x3094, 0, 2, 1, false},
    {0x3094, 1, 0x3F800000, 4, true},  {0x3094, 2, 0x3F800000, 4, true}, {0x3095, 0, 2, 1, false},
    {0x3095, 1, 0, 4, true},           {0x3095, 2, 0, 4, true},          {0x30A0, 0, 2, 1, false},
    {0x30A0, 1, 0, 1, true},           {0x30A0, 2, 0, 1, true},          {0x30A1, 0, 2, 1, false},
    {0x30A1, 1, 0, 1, true},           {0x30A1, 2, 0, 1, true},          {0x30A2, 0, 2, 1, false},
    {0x30A2, 1, 0, 4, true},           {0x30A2, 2, 0, 4, true},          {0x30A3, 0, 2, 1, false},
    {0x30A3, 1, 0, 1, true},           {0x30A3, 2, 0, 1, true},          {0x30A4, 0, 2, 1, false},
    {0x30A4, 1, 0x3F800000, 4, true},  {0x30A4, 2, 0x3F800000, 4, true}, {0x30A5, 0, 2, 1, false},
    {0x30A5, 1, 0, 4, true},           {0x30A5, 2, 0, 4, true},          {0x4000, 0, 3, 1, false},
    {0x4000, 1, 0, 2, false},          {0x4000, 2, 0, 2, false},         {0x4000, 3, 0xFFFF, 2, false},
    {0x4010, 0, 32, 2, false},         {0x4020, 0, 0, 1, false},         {0x4030, 0, 0, 2, false},
    {0x4040, 0, 0, 2, false},          {0x4050, 0, 0, 2, false},         {0x4060, 0, 25, 2, false},
    {0x4070, 0, 0, 4, true},           {0x4080, 0, 0, 4, true},          {0x5020, 0, 0x41B9999A, 4, false},
    {0x5030, 0, 0x41F00000, 4, false}, {0x5550, 0, 1, 1, true},          {0x5555, 0, 0, 1, true},
};

const std::vector<std::string> upload_specifier{"", "4F", "4B", "", "43"};
const std::vector<std::string> download_specifier{"", "2F", "2B", "", "23"};

std::string address(const Row& row) {
    return hex_le(row.index, 2) + hex_le(row.sub, 1);
}

using InclinometerDictionary = InclinometerTest;

}  // namespace

TEST_F(InclinometerDictionary, EntriesHaveTheirDefaultsAndLengths) {
    verifies<req::INC_OD_1000, req::INC_OD_1001, req::INC_OD_1002, req::INC_OD_1003, req::INC_OD_100C, req::INC_OD_100D,
             req::INC_OD_1010, req::INC_OD_1011, req::INC_OD_1016, req::INC_OD_1017, req::INC_OD_1018, req::INC_OD_1020,
             req::INC_OD_1029, req::INC_OD_1400, req::INC_OD_1401, req::INC_OD_1402, req::INC_OD_1403, req::INC_OD_1600,
             req::INC_OD_1601, req::INC_OD_1602>();
    verifies<req::INC_OD_1603, req::INC_OD_1800, req::INC_OD_1801, req::INC_OD_1802, req::INC_OD_1803, req::INC_OD_1A00,
             req::INC_OD_1A01, req::INC_OD_1A02, req::INC_OD_1A03, req::INC_OD_2000, req::INC_OD_2002, req::INC_OD_2003,
             req::INC_OD_2010, req::INC_OD_2011, req::INC_OD_2020, req::INC_OD_2030, req::INC_OD_2031, req::INC_OD_2040,
             req::INC_OD_2050, req::INC_OD_2051>();
    verifies<req::INC_OD_2052, req::INC_OD_2100, req::INC_OD_2200, req::INC_OD_2210, req::INC_OD_2300, req::INC_OD_2400,
             req::INC_OD_2401, req::INC_OD_2500, req::INC_OD_2501, req::INC_OD_2502, req::INC_OD_3000, req::INC_OD_300A,
             req::INC_OD_300B, req::INC_OD_300C, req::INC_OD_3010, req::INC_OD_3011, req::INC_OD_3012, req::INC_OD_3013,
             req::INC_OD_3014, req::INC_OD_3015>();
    verifies<req::INC_OD_3020, req::INC_OD_3021, req::INC_OD_3022, req::INC_OD_3023, req::INC_OD_3024, req::INC_OD_3025,
             req::INC_OD_3030, req::INC_OD_3031, req::INC_OD_3032, req::INC_OD_3033, req::INC_OD_3034, req::INC_OD_3035,
             req::INC_OD_3040, req::INC_OD_3041, req::INC_OD_3042, req::INC_OD_3043, req::INC_OD_3044, req::INC_OD_3045,
             req::INC_OD_3050, req::INC_OD_3051>();
    verifies<req::INC_OD_3052, req::INC_OD_3053, req::INC_OD_3054, req::INC_OD_3055, req::INC_OD_3060, req::INC_OD_3061,
             req::INC_OD_3062, req::INC_OD_3063, req::INC_OD_3064, req::INC_OD_3065, req::INC_OD_3070, req::INC_OD_3071,
             req::INC_OD_3072, req::INC_OD_3073, req::INC_OD_3074, req::INC_OD_3075, req::INC_OD_3080, req::INC_OD_3081,
             req::INC_OD_3082, req::INC_OD_3083>();
    verifies<req::INC_OD_3084, req::INC_OD_3085, req::INC_OD_3090, req::INC_OD_3091, req::INC_OD_3092, req::INC_OD_3093,
             req::INC_OD_3094, req::INC_OD_3095, req::INC_OD_30A0, req::INC_OD_30A1, req::INC_OD_30A2, req::INC_OD_30A3,
             req::INC_OD_30A4, req::INC_OD_30A5, req::INC_OD_4000, req::INC_OD_4010, req::INC_OD_4020, req::INC_OD_4030,
             req::INC_OD_4040, req::INC_OD_4050>();
    verifies<req::INC_OD_4060, req::INC_OD_4070, req::INC_OD_4080, req::INC_OD_5020, req::INC_OD_5030, req::INC_OD_5550,
             req::INC_OD_5555>();
    for (const auto& row : rows) {
        const std::string data =
            hex_le(row.value, row.bytes) + std::string(static_cast<std::size_t>(8 - 2 * row.bytes), '0');
        EXPECT_EQ(send("67F#40" + address(row) + "00000000"),
                  (Frames{"5FF#" + upload_specifier[static_cast<std::size_t>(row.bytes)] + address(row) + data}));
    }
}

TEST_F(InclinometerDictionary, OnlyWritableEntriesAcceptAWriteOfTheirPresentValue) {
    verifies<req::INC_OD_1000, req::INC_OD_1001, req::INC_OD_1002, req::INC_OD_1003, req::INC_OD_100C, req::INC_OD_100D,
             req::INC_OD_1010, req::INC_OD_1011, req::INC_OD_1016, req::INC_OD_1017, req::INC_OD_1018, req::INC_OD_1020,
             req::INC_OD_1029, req::INC_OD_1400, req::INC_OD_1401, req::INC_OD_1402, req::INC_OD_1403, req::INC_OD_1600,
             req::INC_OD_1601, req::INC_OD_1602>();
    verifies<req::INC_OD_1603, req::INC_OD_1800, req::INC_OD_1801, req::INC_OD_1802, req::INC_OD_1803, req::INC_OD_1A00,
             req::INC_OD_1A01, req::INC_OD_1A02, req::INC_OD_1A03, req::INC_OD_2000, req::INC_OD_2002, req::INC_OD_2003,
             req::INC_OD_2010, req::INC_OD_2011, req::INC_OD_2020, req::INC_OD_2030, req::INC_OD_2031, req::INC_OD_2040,
             req::INC_OD_2050, req::INC_OD_2051>();
    verifies<req::INC_OD_2052, req::INC_OD_2100, req::INC_OD_2200, req::INC_OD_2210, req::INC_OD_2300, req::INC_OD_2400,
             req::INC_OD_2401, req::INC_OD_2500, req::INC_OD_2501, req::INC_OD_2502, req::INC_OD_3000, req::INC_OD_300A,
             req::INC_OD_300B, req::INC_OD_300C, req::INC_OD_3010, req::INC_OD_3011, req::INC_OD_3012, req::INC_OD_3013,
             req::INC_OD_3014, req::INC_OD_3015>();
    verifies<req::INC_OD_3020, req::INC_OD_3021, req::INC_OD_3022, req::INC_OD_3023, req::INC_OD_3024, req::INC_OD_3025,
             req::INC_OD_3030, req::INC_OD_3031, req::INC_OD_3032, req::INC_OD_3033, req::INC_OD_3034, req::INC_OD_3035,
             req::INC_OD_3040, req::INC_OD_3041, req::INC_OD_3042, req::INC_OD_3043, req::INC_OD_3044, req::INC_OD_3045,
             req::INC_OD_3050, req::INC_OD_3051>();
    verifies<req::INC_OD_3052, req::INC_OD_3053, req::INC_OD_3054, req::INC_OD_3055, req::INC_OD_3060, req::INC_OD_3061,
             req::INC_OD_3062, req::INC_OD_3063, req::INC_OD_3064, req::INC_OD_3065, req::INC_OD_3070, req::INC_OD_3071,
             req::INC_OD_3072, req::INC_OD_3073, req::INC_OD_3074, req::INC_OD_3075, req::INC_OD_3080, req::INC_OD_3081,
             req::INC_OD_3082, req::INC_OD_3083>();
    verifies<req::INC_OD_3084, req::INC_OD_3085, req::INC_OD_3090, req::INC_OD_3091, req::INC_OD_3092, req::INC_OD_3093,
             req::INC_OD_3094, req::INC_OD_3095, req::INC_OD_30A0, req::INC_OD_30A1, req::INC_OD_30A2, req::INC_OD_30A3,
             req::INC_OD_30A4, req::INC_OD_30A5, req::INC_OD_4000, req::INC_OD_4010, req::INC_OD_4020, req::INC_OD_4030,
             req::INC_OD_4040, req::INC_OD_4050>();
    verifies<req::INC_OD_4060, req::INC_OD_4070, req::INC_OD_4080, req::INC_OD_5020, req::INC_OD_5030, req::INC_OD_5550,
             req::INC_OD_5555>();
    for (const auto& row : rows) {
        // 1010h and 1011h: a client writes a signature, not the value that it reads
        const bool signature = row.index == 0x1010 || row.index == 0x1011;
        const bool mapping = (row.index & 0xFFF0) == 0x1600 || (row.index & 0xFFF0) == 0x1A00;  // needs five steps
        const bool valid = row.index == 0x1400 || (row.index >= 0x1800 && row.index <= 0x1802);
        const bool inhibit_time = valid && row.sub == 3;  // cannot be written while its PDO is valid
        const std::string code = refusal(row.index, row.sub, row.value, row.bytes);
        if (!row.writable) {
            EXPECT_EQ(code, "06010002") << address(row);
        } else if (signature) {
            EXPECT_EQ(code, "08000020") << address(row);
        } else if (inhibit_time) {
            EXPECT_EQ(code, "08000022") << address(row);
        } else if (!mapping) {
            EXPECT_EQ(code, "") << address(row);
        }
    }
}

TEST_F(InclinometerDictionary, OnlyTheObjectsOfTheManualExist) {
    verifies<req::INC_OD_LIST, req::INC_ANGLE_010>();
    std::size_t listed = 0;
    std::uint16_t last = 0;
    for (const auto& row : rows) {
        listed += row.index == last ? 0 : 1;
        last = row.index;
    }
    std::size_t found = 0;
    for (std::uint32_t index = 0x1000; index <= 0xFFFF; ++index) {
        found += send("67F#40" + hex_le(index, 2) + "0000000000").at(0).substr(12) == "00000206" ? 0 : 1;
    }
    EXPECT_EQ(found, listed);
    // Section 4.2 has 13 objects, and the PDOs have 16 objects. Section 4.3 has 18 objects up to 2401h, 3 up to 2502h,
    // 4 arrays and 60 parameters of functions, 11 up to 5030h, and 2 switches.
    EXPECT_EQ(found, 13U + 16U + 18U + 3U + 4U + 60U + 11U + 2U);
}

TEST_F(InclinometerDictionary, SubIndicesBeyondThoseOfTheManualAreAbsent) {
    verifies<req::INC_OD_LIST, req::INC_OD_1003, req::INC_OD_1010, req::INC_OD_1011, req::INC_OD_1029>();
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const bool is_last = i + 1 == rows.size() || rows[i + 1].index != rows[i].index;
        if (is_last) {
            EXPECT_EQ(refusal(rows[i].index, static_cast<std::uint8_t>(rows[i].sub + 1), 0, 1), "06090011")
                << address(rows[i]);
        }
    }
}

TEST_F(InclinometerDictionary, ValuesOfWrongLengthAreRefused) {
    verifies<req::INC_OD_LIST>();
    for (const auto& row : rows) {
        if (row.writable) {
            EXPECT_EQ(refusal(row.index, row.sub, 0, row.bytes == 1 ? 2 : 1), row.bytes == 1 ? "06070012" : "06070013")
                << address(row);
        }
    }
}

}  // namespace canproof::test
