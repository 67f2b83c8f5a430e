// SPDX-License-Identifier: Apache-2.0
// Checks the spelling of lines, sections and keys.
#include "host/datasheet/check/text_rules.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>

#include "host/datasheet/check/known_names.hpp"

namespace canproof::host {

namespace {

constexpr auto error = EdsSeverity::error;
constexpr auto warning = EdsSeverity::warning;
constexpr const char* format = "CiA 306, format of the file";
constexpr std::size_t longest_line = 255;  // greatest length of a line in characters (CiA 306)

class TextCheck {
  public:
    TextCheck(const EdsSheet& sheet, EdsFindings& findings) : sheet_{sheet}, findings_{findings} {}

    void run() {
        if (sheet_.has_byte_order_mark()) {
            findings_.add("text-byte-order-mark", 1, "the file begins with a UTF-8 byte order mark",
                          replace_line(1, sheet_.lines().empty() ? "" : sheet_.line(1).text));
        }
        check_line_ends();
        for (const EdsLine& line : sheet_.lines()) {
            ++number_;
            check_bytes(line);
            if (line.kind == EdsLine::Kind::section) {
                skips_ = false;
                open_section(line);
            } else if (line.kind == EdsLine::Kind::value && !skips_) {
                check_key(line);
            } else if (line.kind == EdsLine::Kind::strange) {
                findings_.add("text-strange-line", number_,
                              fmt::format("`{}` is neither [Section] nor Key=Value", line.text.substr(0, 40)));
                skips_ = skips_ || line.text.find('[') == line.text.find_first_not_of(" \t");
            }
        }
    }

  private:
    void check_line_ends() {
        const auto& lines = sheet_.lines();
        const auto crlf = static_cast<std::size_t>(
            std::count_if(lines.begin(), lines.end(), [](const EdsLine& line) { return line.crlf; }));
        // The last line may lack a line break.
        const std::size_t ended = lines.empty() || lines.back().crlf ? lines.size() : lines.size() - 1;
        if (crlf == 0 || crlf == ended || lines.size() < 2) {
            return;
        }
        std::vector<EdsEdit> edits;
        unsigned first = 0;
        for (unsigned i = 1; i <= lines.size(); ++i) {
            if (!sheet_.line(i).crlf) {
                first = first == 0 ? i : first;
                edits.push_back({EdsEdit::Kind::crlf, i, {}});
            }
        }
        findings_.add("text-line-ends", first, fmt::format("only {} of {} lines end with CR LF", crlf, lines.size()),
                      std::move(edits));
    }

    void check_bytes(const EdsLine& line) {
        const auto has = [&](auto wanted) {
            return std::any_of(line.text.begin(), line.text.end(),
                               [&](char c) { return wanted(static_cast<unsigned char>(c)); });
        };
        if (line.text.size() > longest_line) {
            findings_.add("text-long-line", number_,
                          fmt::format("the line has {} characters; {} are allowed", line.text.size(), longest_line));
        }
        if (has([](unsigned char c) { return c >= 0x80U; })) {
            findings_.add("text-not-ascii", number_, "the line contains characters beyond ASCII");
        }
        if (has([](unsigned char c) { return c < 0x20U && c != '\t'; })) {
            findings_.add("text-control", number_, "the line contains control characters");
        }
    }

    void open_section(const EdsLine& line) {
        section_ = lower_case(line.name);
        keys_.clear();
        if (!line.behind.empty() && line.behind.front() != ';' && line.behind.front() != '#') {
            findings_.add("text-behind-section", number_,
                          fmt::format("`{}` follows [{}]", line.behind.substr(0, 40), line.name));
        }
        const auto [first, is_new] = sections_.emplace(section_, number_);
        if (!is_new) {
            findings_.add("section-duplicate", number_,
                          fmt::format("[{}] is already in line {}", line.name, first->second));
        }
        check_section_name(line);
    }

    void check_section_name(const EdsLine& line) {
        const auto object = eds_object_name(line.name);
        const std::string known = known_section(line.name);
        // An entry without ParameterName is named after its section, so renaming the section would rename the entry.
        const IniSection* section = sheet_.ini().find(line.name);
        const bool named = !object || (section != nullptr && section->filled("ParameterName") != nullptr) ||
                           object->kind == EdsObjectName::Kind::name || object->kind == EdsObjectName::Kind::value;
        if (object && object->kind == EdsObjectName::Kind::sub && line.name.size() > 8 && line.name[7] == '0') {
            const std::string plain = fmt::format("{:04X}sub{:X}", object->index, object->sub);
            findings_.add("section-sub-zeros", number_,
                          fmt::format("the sub-index in [{}] has leading zeros", line.name),
                          named && sheet_.ini().find(plain) == nullptr ? replace_line(number_, "[" + plain + "]")
                                                                       : std::vector<EdsEdit>{});
        } else if (known.empty()) {
            findings_.add("section-unknown", number_, fmt::format("[{}] is no section of CiA 306", line.name));
        } else if (known != line.name) {
            findings_.add("section-case", number_, fmt::format("[{1}] must be written [{0}]", known, line.name),
                          named ? replace_line(number_, "[" + known + "]") : std::vector<EdsEdit>{});
        }
    }

    void check_key(const EdsLine& line) {
        if (section_.empty()) {
            findings_.add("text-before-section", number_,
                          fmt::format("key {} is before the first section", line.name.substr(0, 40)));
            return;
        }
        const auto [first, is_new] = keys_.emplace(lower_case(line.name), Key{number_, line.behind});
        if (!is_new) {
            const bool same = first->second.value == line.behind;
            findings_.add("key-duplicate", number_,
                          fmt::format("key {} is already in line {}", line.name, first->second.line),
                          same ? erase_line(number_) : std::vector<EdsEdit>{});
        }
        const std::string known = known_key(section_, line.name);
        if (!known.empty() && known != line.name) {
            findings_.add("key-case", number_, fmt::format("{1} must be written {0}", known, line.name),
                          replace_line(number_, known + "=" + line.behind));
        }
    }

    struct Key {
        unsigned line{0};
        std::string value;
    };

    const EdsSheet& sheet_;
    EdsFindings& findings_;
    unsigned number_{0};
    bool skips_{false};  ///< whether the current line is in a section whose first line is invalid
    std::string section_;
    std::map<std::string, unsigned> sections_;
    std::map<std::string, Key> keys_;
};

}  // namespace

const std::vector<EdsRule>& text_rules() {
    static const std::vector<EdsRule> rules{
        {"text-byte-order-mark", warning, "the file begins with a UTF-8 byte order mark",
         "save the file as ASCII text, without the mark", format},
        {"text-line-ends", warning, "some lines end with CR LF, others with LF alone", "end every line with CR LF",
         format},
        {"text-long-line", warning, "a line is longer than 255 characters", "shorten the line", format},
        {"text-not-ascii", warning, "a character is beyond ASCII", "write ASCII characters instead", format},
        {"text-control", error, "a control character is in a line", "remove the character", format},
        {"text-strange-line", error, "a line is neither section, value nor comment",
         "write [Section] or Key=Value, or begin the line with a semicolon", format},
        {"text-before-section", error, "a value is before the first section", "move the value below its section",
         format},
        {"text-behind-section", warning, "text follows the name of a section",
         "remove the text, or begin it with a semicolon", format},
        {"section-duplicate", error, "a section occurs twice", "join the two sections, or rename one", format},
        {"section-unknown", warning, "a section is unknown in CiA 306", "correct the name, or remove the section",
         format},
        {"section-case", warning, "the name of a section differs from CiA 306 in upper and lower case",
         "write the name as CiA 306 does; some tools distinguish upper and lower case", format},
        {"section-sub-zeros", warning, "the sub-index in the name of a section has leading zeros",
         "write the sub-index without leading zeros", "CiA 306, object sections"},
        {"key-duplicate", error, "a key occurs twice in a section", "keep one of the two lines", format},
        {"key-case", warning, "the name of a key differs from CiA 306 in upper and lower case",
         "write the name as CiA 306 does; some tools distinguish upper and lower case", format}};
    return rules;
}

void check_text(const EdsSheet& sheet, EdsFindings& findings) {
    TextCheck{sheet, findings}.run();
}

}  // namespace canproof::host
