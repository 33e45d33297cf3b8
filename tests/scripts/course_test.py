# SPDX-FileCopyrightText: 2026 The glark authors
# SPDX-License-Identifier: MIT
"""The site and the book of the course: what they have, and that their links lead somewhere."""
import pathlib
import re
import shutil
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
sys.path.append(str(ROOT / "scripts" / "parts"))
import course


def links_in(html: str) -> list:
    return re.findall(r'(?:src|href)="([^"#]+)[^"]*"', html)


class Text(unittest.TestCase):
    def test_lists_tables_and_code_stand_alone(self):
        self.assertEqual("a:\n\n- b\n- c\n", course.separate_blocks("a:\n- b\n- c\n"))
        self.assertEqual("a\n\n```\n- b\n```\n\nc\n", course.separate_blocks("a\n```\n- b\n```\nc\n"))
        self.assertEqual("- a\n  b\n- c\n", course.separate_blocks("- a\n  b\n- c\n"))

    def test_exercises_keep_their_numbers(self):
        text = "1. a\n## Exercises\n1. b\n2. c\n## D\n3. e\n"
        self.assertEqual("1. a\n## Exercises\n\n**1.** b\n\n**2.** c\n## D\n3. e\n",
                         course.number_exercises("1. a" + text[4:]))


class Pages(unittest.TestCase):
    def test_the_first_page_names_all_lessons(self):
        first = (ROOT / course.COURSE / "README.md").read_text()
        for page in course.chapters()[1:]:
            self.assertIn(f"]({page.relative_to(course.COURSE)})", first)

    def test_programs_and_solutions_are_pages(self):
        staged = course.staged_files()
        for source in (ROOT / course.COURSE).glob("*/*.cpp"):
            if not source.name.startswith("exercise_"):
                self.assertIn(source.relative_to(ROOT), staged)


@unittest.skipUnless(shutil.which("mkdocs"), "mkdocs is missing")
class Site(unittest.TestCase):
    def test_every_link_leads_to_a_file_of_the_site(self):
        with tempfile.TemporaryDirectory() as temporary:
            output = pathlib.Path(temporary)
            course.stage(output / "pages")
            course.make_site(output)
            pages = list((output / "site").rglob("*.html"))
            self.assertGreater(len(pages), len(course.chapters()))
            for page in pages:
                for link in links_in(page.read_text()):
                    with self.subTest(page=page.relative_to(output), link=link):
                        self.assertTrue(link.startswith("https://") or (page.parent / link).exists() or page.name == "404.html")

    def test_nothing_is_loaded_from_elsewhere(self):
        with tempfile.TemporaryDirectory() as temporary:
            output = pathlib.Path(temporary)
            course.stage(output / "pages")
            course.make_site(output)
            for page in (output / "site").rglob("*.html"):
                self.assertEqual([], re.findall(r'<(?:script|link|img)[^>]*(?:src|href)="(?:https?:)?//', page.read_text()))


@unittest.skipUnless(shutil.which("weasyprint"), "WeasyPrint is missing")
class Book(unittest.TestCase):
    def test_links_lead_to_chapters(self):
        sections = {page: f"chapter-{i}" for i, page in enumerate(course.chapters())}
        for page in sections:
            html = course.section_of(page, sections)
            self.assertEqual([], [link for link in re.findall(r'href="([^"]*)"', html)
                                  if not link.startswith("https://") and link[1:] not in sections.values()])
            self.assertEqual([], [picture for picture in re.findall(r'src="([^"]*)"', html)
                                  if not pathlib.Path(picture).is_file()])

    def test_it_is_a_pdf(self):
        with tempfile.TemporaryDirectory() as temporary:
            course.make_book(pathlib.Path(temporary))
            self.assertEqual(b"%PDF", (pathlib.Path(temporary) / "course.pdf").read_bytes()[:4])


if __name__ == "__main__":
    unittest.main()
