"""What is written of the house is true. CONTRIBUTING.md's lists are complete: the places that a list names are those that know the word that
it follows, in the libraries, the program, their manuals and the table of bits.

Usage: recipes_test.py FOLDER
"""

import pathlib
import re
import sys
import unittest

from rules import includes_between_rooms

ROOT = pathlib.Path(sys.argv.pop())
FOLDERS = ["core", "io", "lod2d", "lod3d", "scenes", "measure", "viz", "cli", "tests/determinism"]
# The same word for something else.
OTHERS = {"in_order": {"lod2d/source/paths/clean_work.cpp"}}


def recipes():
    """(title, word, places) of every list that follows a word."""
    for part in (ROOT / "CONTRIBUTING.md").read_text(encoding="utf-8").split("\n## ")[1:]:
        follow = re.search(r"^Follow `(\w+)`:$", part, re.M)
        if follow:
            places = set()
            for line in re.findall(r"^- (`.*?): ", part, re.M):
                places.update(re.findall(r"`([^`]+)`", line))
            yield part.split("\n")[0], follow.group(1), places


def files_with(word):
    files = {"METHOD.md", "README.md"} | {
        path.relative_to(ROOT).as_posix()
        for folder in FOLDERS
        for path in (ROOT / folder).rglob("*")
        if path.suffix in (".cpp", ".hpp") or path.name == "README.md"
    }
    return {name for name in files if re.search(rf"\b{word}\b", (ROOT / name).read_text(encoding="utf-8"))}


class Recipes(unittest.TestCase):
    def test_each_list_names_all_places_that_know_its_word(self):
        found = list(recipes())
        self.assertGreaterEqual(len(found), 6)
        for title, word, places in found:
            with self.subTest(title):
                self.assertEqual(places, files_with(word) - OTHERS.get(word, set()))

    def test_the_picture_of_the_rooms_is_of_the_includes(self):
        drawn = (ROOT / "doc/rooms.txt").read_text(encoding="utf-8").split("\n")[:-1]
        self.assertEqual(drawn, includes_between_rooms(ROOT), "draw doc/rooms.svg anew: tests/structure/draw_rooms.cpp")

    def test_every_file_that_a_comment_or_a_manual_names_is_there(self):
        manuals = [path for path in ROOT.glob("*.md") if path.name != "CHANGELOG.md"]
        sources = [path for folder in FOLDERS + ["lessons", "examples"] for path in (ROOT / folder).rglob("*")]
        for path in manuals + [path for path in sources if path.suffix in (".hpp", ".cpp", ".md")]:
            text = path.read_text(encoding="utf-8")
            if path.suffix != ".md":
                text = "\n".join(re.findall(r"//.*", text))
            for name in re.findall(r"(?<![\w/<.])(?:[a-z]\w*/)*\w+\.[ch]pp\b", text):
                if name.split("/")[-1] in ("game.cpp", "lesson.cpp", "NAME.cpp", "meet.cpp"):  # a reader's own; one of many
                    continue
                with self.subTest(f"{path.relative_to(ROOT)}: {name}"):
                    self.assertTrue((ROOT / name).is_file() or (path.parent / name).is_file())

    def test_every_lesson_is_a_folder_of_a_text_and_a_function(self):
        lessons = sorted(path for path in (ROOT / "lessons").rglob("[0-9][0-9]_*") if path.is_dir())
        self.assertTrue(lessons)
        for folder in lessons:
            slug = folder.name[3:]
            self.assertTrue((folder / "lesson.md").is_file(), folder)
            self.assertIn(f"make_{slug}(", (folder / "lesson.cpp").read_text(encoding="utf-8"))


if __name__ == "__main__":
    unittest.main()
