// SPDX-License-Identifier: Apache-2.0
#include "host/datasheet/check/fix_eds.hpp"

#include <algorithm>
#include <map>
#include <set>

#include "host/datasheet/check/check_eds.hpp"
#include "host/datasheet/check/eds_sheet.hpp"

namespace canproof::host {

namespace {

/// Greatest number of rounds of checking and fixing. A fix can make another finding visible, which needs another round.
/// If more rounds were necessary, two rules would contradict each other.
constexpr int most_rounds = 20;

/// The edits of one round. All edits of a line belong to the same fix.
class Round {
  public:
    /// Adds the edits of a finding, unless they are added already. If another fix already changes one of the edited
    /// lines, adds nothing and returns false.
    bool take(const EdsFinding& finding) {
        if (taken_.count(finding.edits) != 0) {
            return true;  // several findings share this fix
        }
        const std::vector<EdsEdit>& edits = *finding.edits;
        if (std::any_of(edits.begin(), edits.end(),
                        [&](const EdsEdit& edit) { return lines_.count(edit.line) != 0; })) {
            return false;
        }
        for (const EdsEdit& edit : edits) {
            lines_[edit.line].push_back(edit);
        }
        taken_.insert(finding.edits);
        return true;
    }

    /// Returns the text `old` with all edits of the round.
    std::string text(std::string_view old) const {
        const EdsSheet sheet{old, {}};
        const auto& lines = sheet.lines();
        const bool crlf = std::any_of(lines.begin(), lines.end(), [](const EdsLine& line) { return line.crlf; });
        std::string out;
        for (unsigned number = 1; number <= lines.size(); ++number) {
            const EdsLine& line = sheet.line(number);
            const auto found = lines_.find(number);
            const std::string end = line.crlf ? "\r\n" : "\n";
            if (found == lines_.end()) {
                out += line.text + end;
            } else {
                out += changed(line, found->second, crlf ? "\r\n" : "\n");
            }
        }
        return out;
    }

  private:
    static std::string changed(const EdsLine& line, const std::vector<EdsEdit>& edits, const std::string& new_end) {
        std::string text = line.text + (line.crlf ? "\r\n" : "\n");
        std::string behind;
        for (const EdsEdit& edit : edits) {
            switch (edit.kind) {
                case EdsEdit::Kind::replace:
                    text = edit.text + (line.crlf ? "\r\n" : "\n");
                    break;
                case EdsEdit::Kind::erase:
                    text.clear();
                    break;
                case EdsEdit::Kind::crlf:
                    text = line.text + "\r\n";
                    break;
                case EdsEdit::Kind::insert_after:
                    behind += with_ends(edit.text, new_end);
                    break;
            }
        }
        return text + behind;
    }

    static std::string with_ends(const std::string& text, const std::string& end) {
        std::string out;
        for (const char c : text) {
            out += c == '\n' ? end : std::string{c};
        }
        return out + end;
    }

    std::map<unsigned, std::vector<EdsEdit>> lines_;
    std::set<EdsEdits> taken_;
};

}  // namespace

EdsFixed fix_eds(std::string_view text, std::string_view name) {
    EdsFixed fixed{std::string{text}, {}};
    for (int i = 0; i < most_rounds; ++i) {
        Round round;
        bool any = false;
        for (const EdsFinding& finding : check_eds(fixed.text, name)) {
            if (finding.is_fixable() && round.take(finding)) {
                fixed.done.push_back(finding);
                any = true;
            }
        }
        if (!any) {
            break;
        }
        fixed.text = round.text(fixed.text);
    }
    return fixed;
}

}  // namespace canproof::host
