# SPDX-License-Identifier: Apache-2.0
"""Good and bad texts for tests/words_check: file, text, and a part of each fault in the order of the faults."""
import textwrap

LONG = " ".join(["word"] * 36)
FITS = " ".join(["word"] * 35)


def wrapped(text):
    return "\n  ".join(textwrap.wrap(text, 80)) + "\n"


EXAMPLES = (
    # Banned words, in each kind of text; the line is that of the word.
    ("a.cpp", "// An error is\n// told once.\nint a;\n", ["2: comment: `told`; write reported"]),
    ("a.cpp", "int a;  // the dearest case\n", ["1: comment: `dearest`"]),
    ("a.cpp", "/* Begins anew. */\n", ["1: comment: `anew`; write again"]),
    ("a.cpp", "TEST_F(Output, TellsNumberOfTimes) {\n", []),
    ("a.cpp", "TEST_F(Output, IsHeldAtItsEnd) {\n", ["1: test name: `Held`"]),
    ("a.cpp", "TEST(Output, ANoNumberIsNaN) {\n", ["1: test name: `No Number`"]),
    ("a.py", '"""Fixes a fault.\n\nIt mends it."""\n', ["3: comment: `mends`; write fix"]),
    ("a.py", "a = '# told'  # The cell is told.\n", ["1: comment: `told`"]),
    ("a.sh", "# The value is held.\necho told\n", ["1: comment: `held`"]),
    ("CMakeLists.txt", 'set(a "told")  # Not anew.\n', ["1: comment: `anew`"]),
    ("a.toml", 'text = "The output shall be held."\n', ["1: text: `held`"]),
    ("a.toml", 'name = "held"\n', []),
    ("a.toml", 'reason = """\nOne.\nIt is told."""\n', ["2: text: `told`"]),
    ("a.md", "# Title\n\nIt is told.\n", ["3: prose: `told`"]),
    ("a.md", "```\nIt is told.\n```\n", []),
    ("a.md", "| a |\n|---|\n| It is told. |\n", ["3: layout: `told`"]),
    ("a.cpp", "// A sign stands for a number; the machine stands still. It stands above.\n", ["1: comment: `stands`; write is"]),
    ("a.md", "The boards are ours.\n", ["1: prose: `ours`"]),
    ("a.cpp", "// The device lends memory to all who ask.\n", ["1: comment: `lends`"]),
    ("a.cpp", "// Requests of an obedient client.\n", ["1: comment: `obedient`; write that follows the protocol"]),
    ("a.md", "The test was seen red.\n", ["1: prose: `seen red`; write seen to fail"]),
    ("a.cpp", "TEST(Clock, ComparisonIsGoodEnough) {\n", ["1: test name: `Good Enough`"]),
    # Names, parts of words, strings of a program.
    ("a.cpp", "// `held` and \"told\" are names; amend, threshold and re-mend are other words.\n", []),
    ("a.cpp", 'const char* a = "it is told // told";\n', []),
    # Fragments at the beginning of a comment, not of a question or of a later line.
    ("a.cpp", "// What the bus sends.\n", ["1: comment: begins with `What`"]),
    ("a.cpp", "int a;  ///< which of the two\n", ["1: comment: begins with `which`"]),
    ("a.cpp", "// Returns\n// what the bus sends.\n", []),
    ("a.cpp", "// SPDX-License-Identifier: Apache-2.0\n// What the bus sends.\n", ["2: comment: begins with `What`"]),
    ("a.py", "# Which of the two?\n", []),
    # Long sentences: a blank line, a list item and a full stop end one; a table has none.
    ("a.cpp", f"// {LONG}.\n", ["1: comment: `word word word word word word …` has 36 words"]),
    ("a.cpp", f"// {FITS}. Two.\n", []),
    ("a.cpp", f"// {FITS}\n//\n// word\n", []),
    ("a.cpp", f"int a;  // {FITS}\nint b;  // word\n", []),
    ("a.md", wrapped(f"- {FITS}") + "- word\n", []),
    ("a.toml", f'text = "{LONG}"\n', ["1: text: `word"]),
    ("a.md", wrapped(f"`a` {FITS} · `b` word"), ["1: prose: `_ word"]),
    ("a.md", wrapped(f"{FITS} · `b` word"), []),
    ("a.toml", f'text = "{FITS}; word"\n', []),
    ("a.sh", f"# {FITS}; word.\n", ["1: comment: `word"]),
    ("a.sh", f"# {FITS}   word\n", []),
    # Width and length of pages.
    ("a.md", "x" * 60 + " " + "y" * 40 + "\n", ["1: prose: 101 characters"]),
    ("a.md", "x" * 60 + " [y](" + "z" * 90 + ")\n", []),
    ("README.md", "a\n\n" * 61, ["122: prose: 122 lines; at most 120"]),
    ("b/README.md", "a\n\n" * 61, []),
)
