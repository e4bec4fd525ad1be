"""A lesson's words stand in its lesson.md alone. Reads every .cpp of lessons/course and fails on a literal that
is a sentence, on a lesson with more code than a reader can follow, and on a number of a lesson that is typed.

Usage: prose_test.py SOURCE    exits 0 when all is well, 1 with a line for each fault
"""

import pathlib
import re
import sys

MOST_LINES = 530  # of all .cpp of a lesson
FEWEST_WORDS = 7  # of a sentence without a full stop

LITERALS = re.compile(r'"(?:\\.|[^"\\\n])*"(?:\s*"(?:\\.|[^"\\\n])*")*')
TYPED = re.compile(r"\blessons? \d", re.I)


def words_of(text):
    return re.findall(r"[^\W\d_]{2,}", text)


def is_sentence(text):
    ends = re.search(r"[.?!]($|\s)", text) is not None
    return len(words_of(text)) >= (3 if ends else FEWEST_WORDS)


def literals_of(code):
    """(line, text) of each literal, those side by side as one; comments and includes are none."""
    code = re.sub(r"//[^\n]*|^\s*#[^\n]*", lambda match: " " * len(match.group()), code, flags=re.M)
    for match in LITERALS.finditer(code):
        parts = re.findall(r'"((?:\\.|[^"\\\n])*)"', match.group())
        yield code.count("\n", 0, match.start()) + 1, "".join(parts)


def main(source):
    faults = []
    for folder in sorted((source / "lessons/course").iterdir()):
        lines = 0
        for file in sorted(folder.glob("*.cpp")):
            code = file.read_text()
            lines += code.count("\n")
            for line, text in literals_of(code):
                if is_sentence(text):
                    faults.append(f"{file.relative_to(source)}:{line}: words of the lesson in its code: \"{text}\"; "
                                  "write them into lesson.md")
        if lines > MOST_LINES:
            faults.append(f"{folder.relative_to(source)}: {lines} lines of code, at most {MOST_LINES}; "
                          "share what it draws in lessons/engine")
        for line, text in enumerate((folder / "lesson.md").read_text().splitlines(), 1):
            if TYPED.search(text):
                faults.append(f"{folder.relative_to(source)}/lesson.md:{line}: types the number of a lesson; "
                              "write {{lesson: NAME}}")
    assert TYPED.search("as in Lesson 4,") and not TYPED.search("this lesson. 4 of them")
    assert is_sentence("They meet. Do they?") and is_sentence("the circles of every level of a tree")
    assert not is_sentence("where they come nearest") and not is_sentence("1.5 m/s")
    assert list(literals_of('a("one "\n  "two"); // "three"')) == [(1, "one two")]
    print("\n".join(faults))
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main(pathlib.Path(sys.argv[1])))
