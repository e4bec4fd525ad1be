"""Weighs a book: a page with all that it shows, and the whole.

Usage: bytes_test.py BOOK    exits 0 when all is well, 1 with the heaviest files where a limit is passed
"""

import pathlib
import re
import sys

MOST_OF_PAGE = 1_500_000  # bytes, without its video
MOST_AT_FIRST = 600_000  # before its reader scrolls or steps
MOST_OF_BOOK = 15_000_000  # bytes, with its videos
MOST_WITHOUT_VIDEOS = 8_000_000  # of these a million is the module of the live parts, once for all lessons
VIDEOS = (".mp4", ".webm")


def listed(files):
    heaviest = sorted(files, key=lambda file: -file.stat().st_size)[:5]
    return ", ".join(f"{file.parent.name}/{file.name} {file.stat().st_size}" for file in heaviest)


def files_of(page):
    """What a browser fetches for a page when all of it is looked at."""
    linked = re.findall(r'(?:src|href|poster)="([^"#]+)"', page.read_text())
    files = {(page.parent / link).resolve() for link in linked}
    return {page.resolve()} | {file for file in files if file.suffix != ".html"}


def first_files_of(page):
    """What a browser fetches before: no picture but the first ones, and none of the live part."""
    pictures = [file for file in re.findall(r'<img src="([^"]+)"', page.read_text())][:3]
    rest = re.findall(r'(?:<script src|<link rel="stylesheet" href)="([^"]+)"', page.read_text())
    return {page} | {page.parent / link for link in pictures + rest}


def main(book):
    faults = []
    pages = sorted(book.glob("**/index.html"))
    if len(pages) < 2:
        faults.append(f"{book}: no book")
    for page in pages:
        files = {file for file in files_of(page) if file.suffix not in VIDEOS}
        weight = sum(file.stat().st_size for file in files)
        print(f"{page.relative_to(book)}: {weight} bytes")
        if weight > MOST_OF_PAGE:
            faults.append(f"{page.relative_to(book)}: {weight} bytes, at most {MOST_OF_PAGE}; heaviest: {listed(files)}")
        at_first = sum(file.stat().st_size for file in first_files_of(page))
        if at_first > MOST_AT_FIRST:
            faults.append(f"{page.relative_to(book)}: {at_first} bytes at first, at most {MOST_AT_FIRST}")
    everything = [file for file in book.rglob("*") if file.is_file()]
    weight = sum(file.stat().st_size for file in everything)
    print(f"the whole: {weight} bytes")
    most = MOST_OF_BOOK if any(file.suffix in VIDEOS for file in everything) else MOST_WITHOUT_VIDEOS
    if weight > most:
        faults.append(f"the whole: {weight} bytes, at most {most}; heaviest: {listed(everything)}")
    print("\n".join(faults))
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main(pathlib.Path(sys.argv[1])))
