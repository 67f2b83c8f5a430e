// SPDX-License-Identifier: Apache-2.0
// Each [[object]] that must be refused, with the line, the message and the fix that the fault must contain.
#include <gtest/gtest.h>

#include "tests/host/register/broken_register.hpp"

namespace canproof::host::test {

namespace {

const std::string var = R"([[object]]
index = 0x2000
name = "One"
source = ["M1:1"]
)";  // four lines; the text that a case adds begins in line 5

const std::string rw16 =
    var + "type = \"INTEGER16\"\naccess = \"rw\"\n";  // six lines; the text that a case adds begins in line 7

const std::string plain_byte = "type = \"UNSIGNED8\"\naccess = \"rw\"\ndefault = 0\n";

/// Returns object 6411h with one element, and the PDO mapping `index` with one entry. The default of this entry is
/// `entry`, in line 16.
std::string mapped(const std::string& index, const std::string& type, const std::string& mapping,
                   const std::string& entry) {
    return "[[object]]\nindex = 0x6411\nname = \"Out\"\nsource = [\"M1:1\"]\narray = 1\ntype = \"" + type +
           "\"\naccess = \"rw\"\ndefault = 0\nmapping = \"" + mapping + "\"\n[[object]]\nindex = " + index +
           "\nname = \"Mapping\"\nsource = [\"M1:1\"]\nkind = \"record\"\narray = 1\ndefault = " + entry +
           "\ntype = \"UNSIGNED32\"\naccess = \"const\"\n";
}

const std::vector<Broken> cases{
    {"RpdoMapsAnEntryForTpdos", items_file, mapped("0x1600", "INTEGER16", "tpdo", "0x64110110"), 16,
     "1600h:1 maps 6411h:1, which has mapping = \"tpdo\"", "set mapping = \"rpdo\" or \"both\" there"},
    {"TpdoMapsAnEntryForRpdos", items_file, mapped("0x1A00", "INTEGER16", "rpdo", "0x64110110"), 16,
     "1A00h:1 maps 6411h:1, which has mapping = \"rpdo\"", "set mapping = \"tpdo\" or \"both\" there"},
    {"PdoMapsAWrongLength", items_file, mapped("0x1600", "UNSIGNED8", "rpdo", "0x64110110"), 16,
     "1600h:1 maps 6411h:1, which has 8 bits and not 16", "correct the last two digits of the default"},
    {"PdoMapsAMissingEntry", items_file, mapped("0x1600", "INTEGER16", "rpdo", "0x64110210"), 16,
     "1600h:1 maps 6411h:2, which is no entry of the device", "correct the default, or add the entry"},
    {"NameIsNotAscii", items_file, "[[object]]\nindex = 0x2000\nname = \"Größe\"\nsource = [\"M1:1\"]\n" + plain_byte,
     3, "name \"Größe\" is not printable ASCII", "write the name in ASCII"},
    {"ElementNameIsNotAscii", items_file, var + "array = 2\nelement = \"Größe {n}\"\n" + plain_byte, 6,
     "element \"Größe {n}\" is not printable ASCII", "write the name in ASCII"},
    {"ElementsHaveOneName", items_file, var + "array = 4\nelement = \"AOUT\"\n" + plain_byte, 6,
     "4 elements have the name \"AOUT\"", "write {n} in the name"},
    {"UnknownKey", items_file, rw16 + "default = 0\ncolour = 1\n", 8, "the key `colour` is unknown",
     "correct its spelling"},
    {"MissingType", items_file, var + "access = \"rw\"\n", 1, "type is missing", "add `type = …`"},
    {"UnknownType", items_file, var + "type = \"INTEGER24\"\naccess = \"rw\"\ndefault = 0\n", 5,
     "type INTEGER24 is unknown", "use a CiA 301 type in capitals"},
    {"UnknownAccess", items_file, var + "type = \"UNSIGNED8\"\naccess = \"write\"\ndefault = 0\n", 6,
     "access = \"write\" is unknown", "use one of ro, wo, rw, const"},
    {"UnknownMapping", items_file, rw16 + "default = 0\nmapping = \"pdo\"\n", 8, "mapping = \"pdo\" is unknown",
     "use one of none, rpdo, tpdo, both"},
    {"UnknownService", items_file, rw16 + "default = 0\nservice = \"sdo\"\n", 8, "service = \"sdo\" is unknown",
     "use one of none, sync"},
    {"IndexBelow1000h", items_file,
     "[[object]]\nindex = 0xFFF\nname = \"a\"\nsource = [\"M1:1\"]\ntype = \"UNSIGNED8\"\naccess = \"ro\"\ndefault = "
     "0\n",
     2, "index is not a whole number from 4096 to 65535", "write a whole number"},
    {"NameIsNoString", items_file,
     "[[object]]\nindex = 0x2000\nname = 5\nsource = [\"M1:1\"]\ntype = \"UNSIGNED8\"\naccess = \"ro\"\ndefault = 0\n",
     3, "name is not a non-empty string", "write a non-empty string"},
    {"MissingSource", items_file,
     "[[object]]\nindex = 0x2000\nname = \"a\"\ntype = \"UNSIGNED8\"\naccess = \"ro\"\ndefault = 0\n", 1,
     "source is missing", "add `source = …`"},
    {"NoDefault", items_file, rw16, 1, "2000h:0 has no default", "a whole number from -32768 to 32767"},
    {"DefaultAboveType", items_file, rw16 + "default = 32768\n", 7, "2000h:0 default 32768 is no INTEGER16",
     "use a whole number from -32768 to 32767"},
    {"DefaultIsNoWholeNumber", items_file, rw16 + "default = 1.5\n", 7, "2000h:0 default 1.5 is no INTEGER16",
     "use a whole number"},
    {"DefaultIsText", items_file, rw16 + "default = \"1\"\n", 7, "2000h:0 default 1 is no INTEGER16",
     "use a whole number"},
    {"ListForOneValue", items_file, rw16 + "default = [1, 2]\n", 7, "2000h:0 default [list] is no INTEGER16",
     "use a whole number"},
    {"BooleanAsNumber", items_file, rw16 + "default = true\n", 7, "2000h:0 default true is no INTEGER16",
     "use a whole number"},
    {"NodeIdWithoutNumber", items_file, rw16 + "default = \"$NODEID+x\"\n", 7, "default $NODEID+x is no INTEGER16",
     "use a whole number"},
    {"NodeIdWithMoreThanANumber", items_file, rw16 + "default = \"$NODEID+180h\"\n", 7,
     "default $NODEID+180h is no INTEGER16", "use a whole number"},
    {"DefaultAboveMaximum", items_file, rw16 + "default = 11\nrange = { min = 0, max = 10 }\n", 7,
     "2000h:0 default 11 exceeds its limit (10)", "lower the default or raise the limit"},
    {"DefaultBelowMinimum", items_file, rw16 + "default = -1\nrange = { min = 0, max = 10 }\n", 7,
     "2000h:0 default -1 is below its limit (0)", "raise the default or lower the limit"},
    {"DefaultNotAmongValues", items_file, rw16 + "default = 3\nrange = { values = [2, 8] }\n", 7,
     "2000h:0 default 3 is not among the allowed values",
     "use an allowed value, or add the default to the allowed values"},
    {"MinimumAboveMaximum", items_file, rw16 + "default = 5\nrange = { min = 10, max = 0 }\n", 8,
     "2000h:0 minimum (10) exceeds its maximum (0)", "lower the minimum or raise the maximum"},
    {"DefaultAboveMaximumOnceTheNodeIdIsAdded", items_file,
     rw16 + "default = \"$NODEID+0x9\"\nrange = { min = 1, max = 11 }\n", 7,
     "2000h:0 default $NODEID+9 exceeds its limit (11)", "lower the default or raise the limit"},
    {"ZeroBesideNoMinimum", items_file, rw16 + "default = 5\nrange = { max = 10, zero = true }\n", 8,
     "2000h:0 allows 0 in addition to its range", "write a `min` above 0"},
    {"ZeroBesideNegativeMinimum", items_file, rw16 + "default = 5\nrange = { min = -1, max = 10, zero = true }\n", 8,
     "2000h:0 allows 0 in addition to its range", "remove `zero`"},
    {"DefaultBetweenZeroAndMinimum", items_file, rw16 + "default = 9\nrange = { min = 10, zero = true }\n", 7,
     "2000h:0 default 9 is below its limit (10)", "raise the default or lower the limit"},
    {"LimitOutsideType", items_file, rw16 + "default = 5\nrange = { max = 40000 }\n", 8,
     "2000h:0 limit 40000 is no INTEGER16", "use a whole number from -32768 to 32767"},
    {"AllowedValueOutsideType", items_file, rw16 + "default = 5\nrange = { values = [5, 40000] }\n", 8,
     "2000h:0 allows 40000, which is no INTEGER16", "allow a whole number"},
    {"RangeSaysNothing", items_file, rw16 + "default = 5\nrange = { }\n", 8, "range is empty", "leave range out"},
    {"LimitIsNoReference", items_file, rw16 + "default = 5\nrange = { max = \"40x0\" }\n", 8,
     "limit max is neither a number nor an object", "write a number, \"4020\""},
    {"LimitObjectMissing", items_file, rw16 + "default = 5\nrange = { max = \"4020\" }\n", 8,
     "2000h:0 is limited by 4020h:0, which does not exist", "name an object of this device"},
    {"LimitSubIndexAbove255", items_file,
     rw16 + "default = 5\nrange = { max = \"4020:100\" }\n[[object]]\nindex = 0x4020\nname = \"b\"\nsource = "
            "[\"M1:1\"]\ntype = \"INTEGER16\"\naccess = \"rw\"\ndefault = 9\n",  // 100h = 256, the low byte is 0
     8, "2000h:0 is limited by 4020h:256, which does not exist", "name an object of this device"},
    {"LimitObjectOfOtherType", items_file,
     rw16 + "default = 5\nrange = { max = \"4020\" }\n[[object]]\nindex = 0x4020\nname = \"b\"\nsource = [\"M1:1\"]\n"
            "type = \"UNSIGNED16\"\naccess = \"rw\"\ndefault = 9\n",
     8, "2000h:0 has the type INTEGER16, but its limit 4020h:0 has the type UNSIGNED16",
     "name an object of the same type"},
    {"DefaultAboveLimitObject", items_file,
     rw16 + "default = 2600\nrange = { max = { object = \"4020\", add = -100 } }\n[[object]]\nindex = 0x4020\nname = "
            "\"b\"\n"
            "source = [\"M1:1\"]\ntype = \"INTEGER16\"\naccess = \"rw\"\ndefault = 2500\n",
     7, "2000h:0 default 2600 exceeds its limit (4020h:0 default 2500 - 100)", "lower the default or raise 4020h:0"},
    {"RealLimitedByObject", items_file,
     var + "type = \"REAL32\"\naccess = \"rw\"\ndefault = 0.5\nrange = { max = \"2001\" }\n[[object]]\nindex = 0x2001\n"
           "name = \"b\"\nsource = [\"M1:1\"]\ntype = \"REAL32\"\naccess = \"rw\"\ndefault = 2.5\n",
     8, "2000h:0 is a REAL32, but its limit is the object 2001h:0", "write a number as limit"},
    {"RangeOfString", items_file,
     var + "type = \"VISIBLE_STRING\"\naccess = \"rw\"\ndefault = \"a\"\nrange = { max = 5 }\n", 8,
     "2000h:0 has the type VISIBLE_STRING and cannot have a range", "remove range"},
    {"RangeTableMissing", items_file, rw16 + "default = 5\nrange = { table = \"AO4-T9\" }\n", 8,
     "2000h:0 takes its range from table AO4-T9, which does not exist", "name a [[table]]"},
    {"RangeTableOfWords", items_file,
     rw16 +
         "default = 5\nrange = { table = \"AO4-T1\" }\n[[table]]\nid = \"AO4-T1\"\ntitle = \"t\"\nsource = [\"M1:1\"]\n"
         "inputs = [\"a\"]\noutputs = [\"b\"]\nrows = [[\"on\", 1]]\n",
     8, "table AO4-T1 has no numbers in its first column", "whose first input is a number"},
    {"RangeTableTooLong", items_file,
     rw16 +
         "default = 5\nrange = { table = \"AO4-T1\" }\n[[table]]\nid = \"AO4-T1\"\ntitle = \"t\"\nsource = [\"M1:1\"]\n"
         "inputs = [{ name = \"a\", min = 0, max = 65537 }]\noutputs = [\"b\"]\nrows = [[\"*\", 1]]\n",
     8, "table AO4-T1 has a range of more than 65537 numbers", "as `min` and `max`"},
    {"RangeTableOfAllNumbers", items_file,
     rw16 +
         "default = 5\nrange = { table = \"AO4-T1\" }\n[[table]]\nid = \"AO4-T1\"\ntitle = \"t\"\nsource = [\"M1:1\"]\n"
         "inputs = [\"a\"]\noutputs = [\"b\"]\nrows = [[\"-9223372036854775808..9223372036854775807\", 1]]\n",
     8, "table AO4-T1 has a range of more than 65537 numbers", "as `min` and `max`"},
    {"StringLongerThanLength", items_file,
     var + "type = \"VISIBLE_STRING\"\naccess = \"rw\"\nlength = 3\ndefault = \"four\"\n", 8,
     "2000h:0 default has 4 bytes, its length is 3", "shorten the default or raise `length`"},
    {"StringWithoutText", items_file, var + "type = \"VISIBLE_STRING\"\naccess = \"ro\"\ndefault = 5\n", 7,
     "2000h:0 has no text as default", "give default"},
    {"LengthOfNumber", items_file, rw16 + "default = 5\nlength = 2\n", 1,
     "2000h:0 has a length, but the length of the type INTEGER16 is fixed", "remove length"},
    {"DomainWithDefault", items_file, var + "type = \"DOMAIN\"\naccess = \"wo\"\ndefault = 5\n", 7,
     "2000h:0 is a DOMAIN with a default", "remove default"},
    {"StringMapped", items_file,
     var + "type = \"VISIBLE_STRING\"\naccess = \"rw\"\ndefault = \"a\"\nmapping = \"tpdo\"\n", 1,
     "2000h:0 has the type VISIBLE_STRING and cannot be mapped", "set mapping = \"none\""},
    {"ReadOnlyReceived", items_file, var + "type = \"UNSIGNED8\"\naccess = \"ro\"\ndefault = 0\nmapping = \"rpdo\"\n",
     1, "2000h:0 is ro and cannot be mapped into an RPDO", "set mapping = \"tpdo\""},
    {"WriteOnlyTransmitted", items_file,
     var + "type = \"UNSIGNED8\"\naccess = \"wo\"\ndefault = 0\nmapping = \"tpdo\"\n", 1,
     "2000h:0 is wo and cannot be mapped into a TPDO", "set mapping = \"rpdo\""},
    {"ReadOnlyStored", items_file, var + "type = \"UNSIGNED8\"\naccess = \"ro\"\ndefault = 0\nstored = true\n", 1,
     "2000h:0 is ro and cannot be stored", "remove stored"},
    {"ConstLive", items_file, var + "type = \"UNSIGNED8\"\naccess = \"const\"\ndefault = 0\nlive = true\n", 1,
     "2000h:0 is const, so it cannot be live", "remove live"},
    {"StoredIsNoBoolean", items_file, rw16 + "default = 0\nstored = 1\n", 8, "stored is not true or false",
     "write true or false"},
    {"ListTooShort", items_file, rw16 + "array = 3\ndefault = [1, 2]\n", 8, "default lists 2 values for 3 elements",
     "give one value for all elements, or one value for each element"},
    {"ArrayTooLarge", items_file, rw16 + "array = 255\ndefault = 0\n", 7, "array is not a whole number from 1 to 254",
     "write a whole number from 1 to 254"},
    {"ArrayListsEntryOne", items_file,
     rw16 + "array = 2\ndefault = 0\n[[object.entry]]\nsub = 3\nname = \"x\"\ntype = \"UNSIGNED8\"\naccess = "
            "\"ro\"\ndefault = 0\n",
     10, "an object with `array` also lists entry 3", "list entry 0 only"},
    {"RangeListTooShort", items_file, rw16 + "array = 3\nrange = [ { max = 5 }, { max = 6 } ]\ndefault = 1\n", 8,
     "range lists 2 ranges for 3 elements", "for each element"},
    {"RangeOfAnElementIsNoTable", items_file, rw16 + "array = 2\nrange = [ { max = 5 },\n 6 ]\ndefault = 1\n", 9,
     "range of element 2 is no table", "{ min = "},
    {"SecondElementOutsideItsOwnLimit", items_file,
     rw16 + "array = 2\nrange = [ { max = 9 }, { max = 5 } ]\ndefault = [\n  7,\n  6,\n]\n", 11,
     "2000h:2 default 6 exceeds its limit (5)", "lower the default or raise the limit"},
    {"RangeListWithoutArray", items_file, rw16 + "default = 1\nrange = [ { max = 5 } ]\n", 8, "range", "table"},
    {"ElementNamesTooFew", items_file, rw16 + "array = 2\nelement = [ \"a\" ]\ndefault = 1\n", 8,
     "element lists 1 names for 2 elements", "for each element"},
    {"SecondElementOutsideLimit", items_file, rw16 + "array = 2\nrange = { max = 5 }\ndefault = [\n  1,\n  6,\n]\n", 11,
     "2000h:2 default 6 exceeds its limit (5)", "lower the default or raise the limit"},
    {"TooManyMappingEntries", items_file,
     "[[object]]\nindex = 0x1600\nname = \"m\"\nsource = [\"M1:1\"]\ntype = \"UNSIGNED32\"\narray = 65\nkind = "
     "\"record\"\naccess = "
     "\"rw\"\ndefault = 0\n",
     1, "1600h has 65 mapping entries", "a PDO maps at most 64"},
    {"MappingAsArray", items_file,
     "[[object]]\nindex = 0x1A00\nname = \"m\"\nsource = [\"M1:1\"]\ntype = \"UNSIGNED32\"\narray = 4\naccess = "
     "\"rw\"\ndefault = 0\n",
     1, "1A00h is a RECORD in CiA 301", "add kind = \"record\""},
    {"VerifyConfigurationAsRecord", items_file,
     "[[object]]\nindex = 0x1020\nname = \"v\"\nsource = [\"M1:1\"]\n[[object.entry]]\nsub = 1\nname = \"a\"\ntype = "
     "\"UNSIGNED32\"\naccess = \"rw\"\ndefault = 0\n",
     1, "1020h is an ARRAY in CiA 301", "add kind = \"array\""},
    {"UnknownKind", items_file, rw16 + "array = 2\nkind = \"list\"\ndefault = 0\n", 8, "kind \"list\" is unknown",
     "write \"array\" or \"record\""},
    {"KindOfAVar", items_file, rw16 + "kind = \"array\"\ndefault = 0\n", 7, "the key `kind` is unknown",
     "correct its spelling"},
    {"DuplicateSubindex", items_file,
     var + "[[object.entry]]\nsub = 1\nname = \"a\"\ntype = \"UNSIGNED8\"\naccess = \"ro\"\ndefault = 0\n"
           "[[object.entry]]\nsub = 1\nname = \"b\"\ntype = \"UNSIGNED8\"\naccess = \"ro\"\ndefault = 0\n",
     11, "2000h:1 occurs twice", "give each entry its own sub-index"},
    {"DuplicateIndex", items_file,
     rw16 + "default = 0\n[[object]]\nindex = 0x2000\nname = \"b\"\nsource = [\"M1:1\"]\ntype = \"INTEGER16\"\naccess "
            "= \"rw\"\ndefault = 0\n",
     9, "id AO4-OD-2000 is a duplicate of spec/devices/box/items.toml:2", "an object's id follows from its index"},
    {"FamilyBeyondLastIndex", items_file,
     "[[object]]\nindex = 0xFFF0\nname = \"a{n}\"\nrepeat = { first = 1, last = 2, step = 0x10 }\nsource = [\"M1:1\"]\n"
     "type = \"UNSIGNED8\"\naccess = \"ro\"\ndefault = 0\n",
     4, "family reaches index 10000h", "the greatest index is FFFFh"},
    {"DecimalFamilyBeyondLastIndex", items_file,
     "[[object]]\nindex = 0xFF00\nname = \"a{n}\"\nrepeat = { first = 0, last = 10, step = 0x10, decimal = true }\n"
     "source = [\"M1:1\"]\ntype = \"UNSIGNED8\"\naccess = \"ro\"\ndefault = 0\n",
     4, "family reaches index 10000h", "the greatest index is FFFFh"},
    {"FamilyDefaultMissing", items_file, rw16 + "repeat = { first = 1, last = 2, step = 1 }\ndefault = { 1 = 5 }\n", 8,
     "default gives no value for member 2", "add `2 = …`"},
    {"FamilyDefaultForStranger", items_file,
     rw16 + "repeat = { first = 1, last = 2, step = 1 }\ndefault = { 1 = 5, 2 = 6, 3 = 7 }\n", 8,
     "default names member 3, which the family lacks", "use members 1 to 2"},
    {"FamilyEntryDefaultMissing", items_file,
     var + "repeat = { first = 1, last = 2, step = 1 }\n[[object.entry]]\nsub = 1\nname = \"a\"\ntype = "
           "\"UNSIGNED8\"\naccess = \"ro\"\ndefault = { 1 = 5 }\n",
     11, "default gives no value for member 2", "add `2 = …`"},
};

}  // namespace

INSTANTIATE_TEST_SUITE_P(Objects, BrokenRegister, testing::ValuesIn(cases), case_name);

}  // namespace canproof::host::test
