# SPDX-License-Identifier: Apache-2.0
"""Compares the records of people (plan, deviations and reviews) with the findings of the tools."""
import csv
import datetime
import fnmatch
import hashlib
import os
import pathlib
import re
import tomllib

from .rules import HERE, ROOT, Finding, records_of, without_comments_and_literals

REVIEWS = ROOT / "misra" / "reviews.toml"
WEAKER = {"mandatory": [], "required": ["mandatory"], "advisory": ["mandatory", "required", "disapplied"]}


def read_plan(rules, faults):
    """Reads plan.csv, which must have each of the 179 guidelines once. An `enforced` guideline must have tested checkers, and a
    guideline under `review` a tested matcher that finds the places to judge."""
    with open(HERE / "plan.csv", newline="", encoding="utf-8") as file:
        plan = list(csv.DictReader(file))
    numbers = [row["guideline"] for row in plan]
    if numbers != (HERE / "guidelines.txt").read_text().split():
        faults.add("plan.csv must contain each guideline of guidelines.txt once and in the same order")
    for row in plan:
        number, how = row["guideline"], row["enforcement"]
        if how not in ("enforced", "review", "not applicable"):
            faults.add(f"plan.csv {number}: unknown enforcement {how}; write enforced, review or not applicable")
        if (how in ("enforced", "review")) != (number in rules.folders):
            faults.add(f"plan.csv {number} is {how}: rules/{number} {'not expected' if how == 'not applicable' else 'missing'}")
        if (how == "review") != (number in rules.scopes):
            faults.add(f"plan.csv {number} is {how}: rules/{number}/review.query {'missing' if how == 'review' else 'not expected'}")
        if how != "enforced" and not row["note"]:
            faults.add(f"plan.csv {number}: {how} without a reason; write it into the column `note`")
        if row["recategorised"] and row["recategorised"] not in WEAKER[row["category"]]:
            faults.add(f"plan.csv {number}: a {row['category']} guideline cannot become {row['recategorised']}")
    for number in rules.folders.keys() - set(numbers):
        faults.add(f"rules/{number} has the name of no guideline in plan.csv")
    return plan


def file_of(path, generated):
    return (pathlib.Path(generated) if path.startswith("generated/") else ROOT) / path


def source_line(finding, generated):
    return file_of(finding.path, generated).read_text().splitlines()[finding.line - 1]


def read_deviations():
    """Returns the deviations of the checked project. If this is not canproof, adds those of canproof outside src/; they may be unused."""
    records = []
    for path in records_of("deviations.toml"):
        borrowed = path.parent.parent != ROOT
        found = tomllib.loads(path.read_text()).get("deviation", [])
        records += [{**record, "borrowed": borrowed} for record in found if not (borrowed and record["place"].startswith("src/"))]
    return records


def apply_deviations(findings, generated, today, records, faults):
    """Returns the findings without a deviation, and (finding, deviation) of the others. Adds the faults of the records to `faults`."""
    open_findings, deviated, used = [], [], set()
    for at, record in enumerate(records):
        missing = {"rule", "place", "line", "reason", "risk", "expiry"} - record.keys()
        if missing:
            faults.add(f"deviation {at + 1} lacks {', '.join(sorted(missing))}")
        elif record["expiry"] < today:
            faults.add(f"deviation {at + 1} (rule {record['rule']}) expired on {record['expiry']}; renew or remove the deviation")
    for finding in sorted(findings):
        text = source_line(finding, generated)
        for at, record in enumerate(records):
            if finding.rule == record["rule"] and fnmatch.fnmatchcase(finding.path, record["place"]) and re.search(record["line"], text):
                used.add(at)
                deviated.append((finding, record))
                break
        else:
            open_findings.append(finding)
    for at, record in enumerate(records):
        if at not in used and not record["borrowed"]:
            faults.add(f"deviation {at + 1} (rule {record.get('rule')} in {record.get('place')}) matches no finding; "
                       "correct or remove the deviation")
    return open_findings, deviated


LINK = re.compile(r"\bstatic_assert\s*\(\s*implements<[^;]*;")  # an assertion that names requirements and always holds


def fingerprint(text):
    """Returns a hash of a file without comments, literals, spacing and links to requirements. A change of these needs no new review."""
    bare = LINK.sub(" ", without_comments_and_literals(text))
    return hashlib.sha256(" ".join(bare.split()).encode()).hexdigest()[:16]


def read_reviews():
    return tomllib.loads(REVIEWS.read_text()).get("review", []) if REVIEWS.exists() else []


def apply_reviews(scoped, generated, reviews, faults):
    """Returns one finding for each file and rule that a person must judge and has not judged in its present form."""
    first = {}
    for finding in sorted(scoped):
        first.setdefault((finding.rule, finding.path), finding)
    known = {}
    for review in reviews:
        missing = {"rule", "file", "date", "by", "fingerprint", "judgement"} - review.keys()
        if missing:
            faults.add(f"review of {review.get('file')} for {review.get('rule')} lacks {', '.join(sorted(missing))}")
        elif (review["rule"], review["file"]) not in first:
            faults.add(f"review of {review['file']} for {review['rule']} has nothing to judge; remove the review from reviews.toml")
        known[(review.get("rule"), review.get("file"))] = review
    for key, finding in sorted(first.items()):
        now = fingerprint(file_of(finding.path, generated).read_text())
        if key not in known or known[key].get("fingerprint") != now:
            yield finding


def replace_file(path, text):
    """Replaces the file atomically: after an interruption it has the old or the new text."""
    beside = path.with_name(f".{path.name}.{os.getpid()}.new")
    try:
        with open(beside, "w") as file:
            file.write(text)
            file.flush()
            os.fsync(file.fileno())
        beside.replace(path)
    finally:
        beside.unlink(missing_ok=True)


def add_review(arguments, generated):
    """Handles `review FILE RULE --by NAME --judgement TEXT`: writes or renews the record for the file's present form."""
    file, rule = arguments.file, arguments.rule
    if not file_of(file, generated).exists():
        raise SystemExit(f"misra review: there is no file {file}; name the file relative to the project's folder, as in the finding")
    kept = [review for review in read_reviews() if (review["rule"], review["file"]) != (rule, file)]
    kept.append({"rule": rule, "file": file, "date": datetime.date.today(), "by": arguments.by,
                 "fingerprint": fingerprint(file_of(file, generated).read_text()), "judgement": arguments.judgement})
    lines = ["# Judgements by a person, each for one version of one file; `canproof misra review FILE RULE` writes these records.", ""]
    for review in sorted(kept, key=lambda one: ([int(part) for part in one["rule"].split(".")], one["file"])):
        quoted = review["judgement"].replace("\\", "\\\\").replace('"', '\\"')
        lines += ["[[review]]", f'rule = "{review["rule"]}"', f'file = "{review["file"]}"', f'date = {review["date"]}',
                  f'by = "{review["by"]}"', f'fingerprint = "{review["fingerprint"]}"', f'judgement = "{quoted}"', ""]
    REVIEWS.parent.mkdir(exist_ok=True)
    replace_file(REVIEWS, "\n".join(lines))
