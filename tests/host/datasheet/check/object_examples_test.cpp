// SPDX-License-Identifier: Apache-2.0
// A bad and a good data sheet for each rule of `canproof eds check` about lists and objects.
#include "tests/host/datasheet/check/examples.hpp"

namespace canproof::host::test {

std::vector<RuleExample> object_examples() {
    return {
        {"list-missing", "-[ManufacturerObjects] | @1", ""},
        {"list-count-missing", "[MandatoryObjects] -SupportedObjects", "[MandatoryObjects] SupportedObjects=0x3"},
        {"list-count", "[MandatoryObjects] SupportedObjects=4", "[MandatoryObjects] SupportedObjects=03"},
        {"list-key", "[MandatoryObjects] First=0x1000", ""},
        {"list-no-index", "[MandatoryObjects] 3=none", "[MandatoryObjects] 3=0x1018"},
        {"list-numbering", "[MandatoryObjects] 3~4=0x1018", ""},
        {"list-order", "[MandatoryObjects] 1=0x1001 | [MandatoryObjects] 2=0x1000", ""},
        {"list-duplicate", "[MandatoryObjects] 4=0x1018", ""},
        {"list-two", "[OptionalObjects] 1=0x1000 | @[OptionalObjects] 1", ""},
        {"list-form", "[MandatoryObjects] 1=4096", "[MandatoryObjects] 1=0X1000"},
        {"list-no-section", "-[2004] | @[ManufacturerObjects] 5", ""},
        {"list-data-type", "[OptionalObjects] 99=0x0005", ""},
        {"list-wrong", "[ManufacturerObjects] 1=0x1017", ""},
        {"list-none",
         "[2010] ParameterName=New | [2010] ObjectType=0x7 | [2010] DataType=0x0005 | [2010] AccessType=rw | @[2010]",
         "[2010] ParameterName=New | [2010] ObjectType=0x7 | [2010] DataType=0x0005 | [2010] AccessType=rw | "
         "[ManufacturerObjects] 8=0x2010"},

        {"object-mandatory", "-[1001]", ""},
        {"object-name-missing", "[1017] -ParameterName", ""},
        {"object-name-long", "[1017] ParameterName=" + std::string(242, 'x'),
         "[1017] ParameterName=" + std::string(241, 'x')},
        {"object-key-unknown", "[1017] Unit=ms", "[1017] ObjFlags=0"},
        {"object-type-missing", "[1017] -ObjectType", ""},
        {"object-type-unknown", "[1017] ObjectType=0x3", "[2000] ObjectType=7"},
        {"object-type-place", "[2000] ObjectType=0x5", "[0040] ObjectType=0x5"},
        {"object-data-type", "[0040] ObjectType=0x7 | @[0040]", "[0040] ObjectType=0x6"},
        {"object-reserved", "[C000] ParameterName=Far | @[C000]", "[BFFF] ParameterName=Far"},
        {"object-flags", "[1017] ObjFlags=4", "[1017] ObjFlags=3"},
        {"object-single-subs", "[1003] ObjectType=0x7 | @[1003]", ""},
        {"object-single-number", "[1017] SubNumber=1", "[1017] SubNumber=0"},
        {"object-no-subs", "[1017] ObjectType=0x8 | @[1017]", "[2006] ObjectType=0x9"},
        {"object-own-value", "[1003] DefaultValue=0", "[1003] DataType=0x0007"},
        {"sub-alone", "-[1029] | @[1029sub0]", ""},
        {"sub-object-type", "[1003sub1] ObjectType=0x8", "[1003sub1] ObjectType=0x2"},
        {"subnumber-missing", "[1003] -SubNumber", ""},
        {"subnumber", "[1003] SubNumber=2", "[1003] SubNumber=0x3"},
        {"sub0-missing", "-[1029sub0] | @[1029]", ""},
        {"sub0-type", "[1029sub0] DataType=0x0006", "[1029sub0] DataType=5"},
        {"sub0-access", "[1029sub0] AccessType=rw", "[1029sub0] AccessType=const"},
        {"sub0-default-missing", "[1029sub0] -DefaultValue", ""},
        {"sub0-value", "[1029sub0] DefaultValue=2", "[1003sub0] DefaultValue=1"},
        {"array-gap", "[6200sub2] ~[6200sub3]", "[1018sub4] ~[1018sub5]"},
        {"array-types", "[6200sub2] DataType=0x0006", "[1018sub2] DataType=0x0006"},
        {"compact-count", "[2006] CompactSubObj=255", "[2006] CompactSubObj=254"},
        {"compact-single", "[2000] CompactSubObj=2", "[2000] CompactSubObj=0"},
        {"compact-subs", "[2006sub1] ParameterName=One | @[2006] CompactSubObj", ""},
        {"compact-alone", "[2006] CompactSubObj=0 | @[2006Name] | @[2006Value]", ""},
        {"compact-beyond", "[2006Name] 4=Fourth", "[2006Name] 3=Third"},
        {"compact-entries", "[2006Name] NrOfEntries=2", "[2006Name] NrOfEntries=2 | [2006Name] 1=First"},
    };
}

}  // namespace canproof::host::test
