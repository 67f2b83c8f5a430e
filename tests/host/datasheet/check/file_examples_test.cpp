// SPDX-License-Identifier: Apache-2.0
// A bad and a good data sheet for each rule of `canproof eds check` about the file itself.
#include "tests/host/datasheet/check/examples.hpp"

namespace canproof::host::test {

std::vector<RuleExample> file_examples() {
    const std::string long_line = "[FileInfo] Description=" + std::string(243, 'x');  // 12 characters before it
    const std::string longest_line = "[FileInfo] Description=" + std::string(242, 'x');
    return {
        {"text-byte-order-mark", "@1 | top \xEF\xBB\xBF; made with an editor | @1", "top ; made with an editor"},
        {"text-line-ends", "@1 | [FileInfo] FileVersion=1\r", ""},
        {"text-long-line", long_line + "x", longest_line + "x"},
        {"text-not-ascii", "[FileInfo] Description=B\xC3\xB6x", "[FileInfo] Description=Box~"},
        {"text-control",
         "[FileInfo] Description=A\x01"
         "box",
         "[FileInfo] Description=A\tbox"},
        {"text-strange-line", "end nonsense", "end ; nonsense"},
        {"text-before-section", "top FileVersion=1", "top # FileVersion=1"},
        {"text-behind-section", "[1017] ~[1017] heartbeat", "[1017] ~[1017] ; heartbeat"},
        {"section-duplicate", "end [1017]", ""},
        {"section-unknown", "[Nonsense] A=1", "[Tools] Items=1"},
        {"section-case", "[FileInfo] ~[FILEINFO]", "[100C] ~[100c]"},
        {"section-sub-zeros", "[1018sub1] ~[1018sub01]", "[1018sub0] DefaultValue=4"},
        {"key-duplicate", "[1017] +DataType=0x0006", "[1017] +; DataType=0x0006"},
        {"key-case", "[1017] AccessType~accesstype=rw", ""},

        {"fileinfo-missing", "-[FileInfo]", ""},
        {"fileinfo-key-missing", "[FileInfo] -CreatedBy", "[FileInfo] -ModifiedBy"},
        {"fileinfo-key-unknown", "[FileInfo] Author=Nobody", "[FileInfo] LastEDS=old.eds"},
        {"fileinfo-name-extension", "[FileInfo] FileName=box.txt", "[FileInfo] FileName=BOX.EDS"},
        {"fileinfo-name-differs", "[FileInfo] FileName=other.eds", "[FileInfo] FileName=Box.eds"},
        {"fileinfo-version", "[FileInfo] FileVersion=256", "[FileInfo] FileVersion=255"},
        {"fileinfo-revision", "[FileInfo] FileRevision=1.2", "[FileInfo] FileRevision=0"},
        {"fileinfo-eds-version", "[FileInfo] EDSVersion=5.0", "[FileInfo] EDSVersion=3.0"},
        {"fileinfo-date", "[FileInfo] CreationDate=2020-02-29", "[FileInfo] CreationDate=01-31-2020"},
        {"fileinfo-no-such-day", "[FileInfo] CreationDate=02-29-2019", "[FileInfo] CreationDate=02-29-2000"},
        {"fileinfo-time", "[FileInfo] CreationTime=14:05", "[FileInfo] CreationTime=12:59PM"},
        {"fileinfo-modified-before", "[FileInfo] ModificationDate=02-28-2020",
         "[FileInfo] ModificationDate=02-29-2020"},

        {"deviceinfo-missing", "-[DeviceInfo]", ""},
        {"deviceinfo-key-missing", "[DeviceInfo] VendorName=", "[DeviceInfo] -OrderCode"},
        {"deviceinfo-key-unknown", "[DeviceInfo] Colour=red", "[DeviceInfo] CompactPDO=0"},
        {"deviceinfo-flag", "[DeviceInfo] BaudRate_10=2", "[DeviceInfo] BaudRate_10=0x1"},
        {"deviceinfo-number", "[DeviceInfo] VendorNumber=0x100000000", "[DeviceInfo] VendorNumber=0xFFFFFFFF"},
        {"deviceinfo-vendor-differs", "[DeviceInfo] VendorNumber=0x18", "[DeviceInfo] VendorNumber=23"},
        {"deviceinfo-product-differs", "[DeviceInfo] ProductNumber=2345", "[DeviceInfo] ProductNumber=9029"},
        {"deviceinfo-revision-differs", "[DeviceInfo] RevisionNumber=2", "[DeviceInfo] RevisionNumber=0x00000001"},
        {"deviceinfo-no-bit-rate", "[DeviceInfo] BaudRate_125=0 | @[DeviceInfo]",
         "[DeviceInfo] BaudRate_125=0 | [DeviceInfo] BaudRate_1000=1"},
        {"deviceinfo-boot-up", "[DeviceInfo] SimpleBootUpSlave=0",
         "[DeviceInfo] SimpleBootUpSlave=0 | [DeviceInfo] SimpleBootUpMaster=1"},
        {"deviceinfo-rpdo-count", "[DeviceInfo] NrOfRXPDO=3", "[DeviceInfo] NrOfRXPDO=0x2"},
        {"deviceinfo-tpdo-count", "[DeviceInfo] NrOfTXPDO=0",
         "[DeviceInfo] NrOfTXPDO=4 | [DeviceInfo] CompactPDO=0x1A"},
        {"deviceinfo-granularity", "[DeviceInfo] Granularity=65", "[DeviceInfo] Granularity=64"},
        {"deviceinfo-granularity-mapping", "[DeviceInfo] Granularity=0", "[DeviceInfo] Granularity=1"},
        {"deviceinfo-lss-identity", "-[1018sub4] | @[DeviceInfo] LSS_Supported",
         "-[1018sub4] | [DeviceInfo] LSS_Supported=0"},
        {"deviceinfo-dynamic-channels", "[DeviceInfo] DynamicChannelsSupported=1",
         "[DeviceInfo] DynamicChannelsSupported=1 | [DynamicChannels] NrOfSeg=0"},
        {"deviceinfo-group-messaging", "[1A00sub0] DefaultValue=254",
         "[1A00sub0] DefaultValue=254 | [DeviceInfo] GroupMessaging=1"},

        {"comments-lines-missing", "[Comments] -Lines", ""},
        {"comments-count", "[Comments] Lines=3", "[Comments] Lines=3 | [Comments] Line3=Three"},
        {"comments-gap", "[Comments] Line2~Line3=Two", "[Comments] Line3=Three"},
        {"comments-key-unknown", "[Comments] Text=Two", "[Comments] Line3=Three"},
        {"dummy-missing", "-[DummyUsage] | @[1600]", ""},
        {"dummy-key", "[DummyUsage] Dummy0009=1", "[DummyUsage] Dummy0007=1"},
        {"dummy-flag", "[DummyUsage] Dummy0001=2", "[DummyUsage] Dummy0001=1"},
        {"dcf-section", "[DeviceComissioning] NodeID=5 | @[DeviceComissioning]", ""},
        {"dcf-section-name", "[DeviceCommissioning] NodeID=5", "[DeviceComissioning] NodeID=5"},
        {"dcf-node-id", "[DeviceComissioning] NodeID=128", "[DeviceComissioning] NodeID=127"},
        {"dcf-bit-rate", "[DeviceComissioning] Baudrate=125000", "[DeviceComissioning] Baudrate=125"},
        {"dcf-key", "[1017] ParameterValue=5", "[1017] ObjFlags=1"},
    };
}

}  // namespace canproof::host::test
