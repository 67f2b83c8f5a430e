# SPDX-License-Identifier: Apache-2.0
"""Writes the reports of a run: misra.sarif, and compliance.md and misra.html in the form of MISRA Compliance:2020."""
import html
import json

MARKS = {"violations": "open", "deviations": "", "compliant": "shown"}
STYLE = """:root{color-scheme:light dark}body{font:15px/1.5 system-ui,sans-serif;max-width:72rem;margin:2rem auto;padding:0 1rem}
h1,h2{line-height:1.2}table{border-collapse:collapse;width:100%;font-size:.9em}th,td{text-align:left;vertical-align:top;padding:.3rem .5rem;border-bottom:1px solid #8884}
caption{position:absolute;width:1px;height:1px;overflow:hidden;clip-path:inset(50%)}td{overflow-wrap:anywhere}.open{color:#a32016}.shown{color:#1c6b3a}
@media(prefers-color-scheme:dark){.open{color:#ff9b8e}.shown{color:#7fd39b}}@media print{body{max-width:none}}"""


class Outcome:
    """The content of the reports."""

    def __init__(self, version, plan, open_findings, deviated, reviews, figures, faults, records, reviewed_rules):
        self.version = version
        self.reviewed_rules = reviewed_rules  # guidelines whose findings a review closes
        self.plan, self.open, self.deviated, self.reviews = plan, open_findings, deviated, reviews
        self.figures, self.faults, self.records = figures, faults, records
        self.counts = {how: sum(row["enforcement"] == how for row in plan) for how in ("enforced", "review", "not applicable")}

    def level(self, row):
        """Returns a guideline's level according to MISRA Compliance:2020."""
        if row["recategorised"] == "disapplied":
            return "disapplied"
        if any(finding.rule == row["guideline"] for finding in self.open):
            return "violations"
        return "deviations" if any(finding.rule == row["guideline"] for finding, _ in self.deviated) else "compliant"


def write_sarif(folder, outcome):
    def result(finding, record=None):
        location = {"artifactLocation": {"uri": finding.path, "uriBaseId": "PROJECT"}, "region": {"startLine": finding.line}}
        entry = {
            "ruleId": finding.rule,
            "ruleIndex": numbers.index(finding.rule),
            "level": "error",
            "message": {"text": f"MISRA C++:2023 {finding.rule}: {topics[finding.rule]}"},
            "locations": [{"physicalLocation": location}],
        }
        if record:
            entry["suppressions"] = [{"kind": "external", "status": "accepted", "justification": record["reason"]}]
        return entry

    topics = {row["guideline"]: row["topic"] for row in outcome.plan}
    numbers = list(topics)
    descriptors = [
        {"id": row["guideline"], "shortDescription": {"text": row["topic"]}, "properties": {"category": row["category"]}}
        for row in outcome.plan
    ]
    run = {
        "tool": {"driver": {"name": "canproof misra", "version": outcome.version, "semanticVersion": outcome.version, "rules": descriptors}},
        "originalUriBaseIds": {"PROJECT": {"description": {"text": "The folder of the project: every uri is relative to it."}}},
        "invocations": [{"executionSuccessful": not outcome.faults,
                         "toolExecutionNotifications": [{"level": "error", "message": {"text": fault}} for fault in outcome.faults]}],
        "results": [result(finding) for finding in outcome.open] + [result(*pair) for pair in outcome.deviated],
    }
    sarif = {"$schema": "https://json.schemastore.org/sarif-2.1.0.json", "version": "2.1.0", "runs": [run]}
    (folder / "misra.sarif").write_text(json.dumps(sarif, indent=1) + "\n")


def sarif_faults(path):
    """Yields where the log at `path` violates SARIF 2.1.0, section 3, in the properties that write_sarif() writes."""
    log = json.loads(path.read_text())
    if log.get("version") != "2.1.0" or len(log.get("runs", [])) != 1:
        yield "misra.sarif: version must be 2.1.0, with one run"
        return
    run = log["runs"][0]
    driver = run["tool"]["driver"]
    if not driver.get("version") or "PROJECT" not in run["originalUriBaseIds"]:
        yield "misra.sarif: the driver needs a version, and the uris their base"
    if not driver.get("name") or not all(rule.get("id") for rule in driver["rules"]):
        yield "misra.sarif: the driver needs a name, each rule an id"
    for result in run["results"]:
        place = result["locations"][0]["physicalLocation"]
        uri, line = place["artifactLocation"]["uri"], place["region"]["startLine"]
        if driver["rules"][result["ruleIndex"]]["id"] != result["ruleId"]:
            yield f"misra.sarif: ruleIndex and ruleId of {uri}:{line} differ"
        if not result["message"]["text"] or line < 1 or uri.startswith("/") or result["level"] not in ("none", "note", "warning", "error"):
            yield f"misra.sarif: result {uri}:{line} lacks a message, a line, a relative place or a level"
        if any(one["kind"] not in ("inSource", "external") for one in result.get("suppressions", [])):
            yield f"misra.sarif: a suppression of {uri}:{line} has no kind"


def tables(outcome):
    """Returns (title, introduction, columns, rows) of each section; both reports have the same content."""
    plan = outcome.plan
    summary = [[row["guideline"], row["category"], row["recategorised"] or row["category"], outcome.level(row)] for row in plan]
    yield "Guideline compliance summary", "This table gives the compliance level of each guideline in this build.", ["guideline", "category", "recategorised", "compliance"], summary
    findings = [[finding.rule, f"{finding.path}:{finding.line}"] for finding in outcome.open]
    yield "Open findings", "Violations without a deviation, and places without a valid review.", ["guideline", "place"], findings
    yield "Faults", "Faults of the checkers, the plan, the records, the call graph, the symbols or the layers.", ["fault"], [[fault] for fault in outcome.faults]
    enforcement = [[row["guideline"], row["topic"], row["decidability"], row["enforcement"], row["checkers"], row["note"]] for row in plan]
    yield "Guideline enforcement plan", "This table lists how each guideline is checked. Examples test every checker before its findings count.", [
        "guideline", "topic in our words", "decidability", "enforcement", "checkers", "note"], enforcement
    changed = [[row["guideline"], row["category"], row["recategorised"]] for row in plan if row["recategorised"]]
    yield "Guideline recategorisation plan", "These guidelines have a stricter category here or are disapplied; the others keep the category of MISRA.", [
        "guideline", "category", "recategorised"], changed
    records = [[record["rule"], record["place"], record["reason"], record["risk"], str(record["expiry"]),
                str(sum(one is record for _, one in outcome.deviated))] for record in outcome.records]
    yield "Deviation records", "The last column is the number of findings that a deviation covers. An unused or expired deviation is a fault.", [
        "guideline", "place", "reason", "risk", "expiry", "findings"], records
    reviews = [[one["rule"], one["file"], str(one["date"]), one["by"], one["judgement"]] for one in outcome.reviews]
    yield "Review records", "Each judgement of a person is valid for the content of the file on that date, without comments and spacing.", ["guideline", "file", "date", "by", "judgement"], reviews
    stack = [[name, str(used), str(allowed)] for name, (used, allowed) in outcome.figures["stack"].items()]
    yield "Stack", "The greatest stack use of any public call of a device, computed from the call graph, which has no recursion (host, g++ -O1).", ["device", "bytes", "allowed"], stack


def lead(outcome):
    counts, figures = outcome.counts, outcome.figures
    return (f"{counts['enforced']} guidelines enforced by tested checkers, {counts['review']} reviewed, {counts['not applicable']} not applicable, "
            f"of {len(outcome.plan)}; {len(outcome.open)} open finding(s), {len(outcome.deviated)} under {len(outcome.records)} deviation(s), "
            f"{len(outcome.reviews)} review(s), {len(outcome.faults)} fault(s). Call graph of {figures['functions']} functions: no recursion, "
            f"{figures['indirect_calls']} indirect calls, all listed. {figures['unserved']} of {figures['all_functions']} functions (counted by name) serve no "
            f"item of the register; each has a reason.")


def outcome_json(outcome):
    """Returns the result of a run for programs, as `canproof misra --json` prints it."""
    findings = [{"file": one.path, "line": one.line, "guideline": one.rule, "needs_review": one.rule in outcome.reviewed_rules}
                for one in outcome.open]
    deviations = [{"file": one.path, "line": one.line, "guideline": one.rule, "reason": record["reason"]} for one, record in outcome.deviated]
    stack = {name: {"bytes": used, "allowed": allowed} for name, (used, allowed) in outcome.figures["stack"].items()}
    return json.dumps({"holds": not outcome.open and not outcome.faults, "findings": findings, "faults": list(outcome.faults),
                       "deviations": deviations, "reviews": len(outcome.reviews), "guidelines": outcome.counts, "stack": stack,
                       "functions": outcome.figures["all_functions"], "unserved_functions": outcome.figures["unserved"]}, indent=2)


def write_markdown(folder, outcome):
    lines = ["# MISRA C++:2023 compliance", "", lead(outcome), ""]
    for title, introduction, columns, rows in tables(outcome):
        lines += [f"## {title}", "", introduction if rows else "None.", ""]
        if rows:
            lines += ["| " + " | ".join(columns) + " |", "|" + "---|" * len(columns)]
            lines += ["| " + " | ".join(cell.replace("|", "\\|").replace("\n", " ") for cell in row) + " |" for row in rows] + [""]
    (folder / "compliance.md").write_text("\n".join(lines))


def write_html(folder, outcome):
    """Writes misra.html. The evidence pack copies the content of its <main> and applies the pack's own style sheet to it."""
    mark = "open" if outcome.open or outcome.faults else "shown"
    text = [f'<!doctype html><html lang="en"><meta charset="utf-8"><meta name="viewport" content="width=device-width">'
            f"<title>canproof: MISRA C++:2023</title><style>\n{STYLE}\n</style>\n<main><h1>MISRA C++:2023</h1>"
            f'<p><b class="{mark}">{html.escape(lead(outcome))}</b></p>'
            '<p><a href="misra.sarif">findings as SARIF 2.1.0</a></p>\n']
    for title, introduction, columns, rows in tables(outcome):
        text.append(f"<h2>{title}</h2><p>{introduction if rows else 'None.'}</p>\n")
        if rows:
            heads = [column[0].upper() + column[1:] for column in columns]
            text.append(f"<div{' class=wide' if len(columns) > 4 else ''}><table><caption>{title}</caption><thead><tr>" +
                        "".join(f"<th scope=col>{head}" for head in heads) + "</thead><tbody>\n")
            for row in rows:
                cells = "".join(f'<td class="{MARKS.get(cell, "")}" data-h="{head}">{html.escape(cell)}' if cell else "<td>"
                                for head, cell in zip(heads, row))
                text.append(f"<tr>{cells}\n")
            text.append("</tbody></table></div>\n")
    text.append(f"</main><footer>canproof {html.escape(outcome.version)}</footer></html>\n")
    (folder / "misra.html").write_text("".join(text))


def write_exhibit(folder, outcome):
    """Writes the result of this run for the evidence pack, as exhibit.json (src/host/assess/evidence/exhibit.hpp)."""
    state = "open" if outcome.open or outcome.faults else "holds"
    exhibit = {"title": "MISRA", "state": state, "says": lead(outcome), "page": "misra.html", "data": ["misra.sarif"]}
    (folder / "exhibit.json").write_text(json.dumps(exhibit, indent=1) + "\n")


def write_all(folder, outcome):
    folder.mkdir(parents=True, exist_ok=True)
    write_sarif(folder, outcome)
    for fault in sarif_faults(folder / "misra.sarif"):
        outcome.faults.add(fault)
    write_markdown(folder, outcome)
    write_html(folder, outcome)
    write_exhibit(folder, outcome)
