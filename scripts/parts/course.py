# SPDX-FileCopyrightText: 2026 The glark authors
# SPDX-License-Identifier: MIT
"""Makes the course a site and a book: course.py OUTPUT [--site] [--pdf].

The pages of examples/course are copied to OUTPUT/pages, with the pages of docs/ that they link to. Sources become
pages, too. mkdocs makes OUTPUT/site of the copies, WeasyPrint OUTPUT/course.pdf. Both need no network.
"""
import argparse
import os
import pathlib
import re
import shutil
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
COURSE = pathlib.Path("examples/course")
THEME = ROOT / "scripts/parts/course_theme"
LINK = re.compile(r"(!?)\[([^\]]*)\]\(([^)\s#]*)(#[^)\s]*)?\)")
SOURCES = {".cpp": "cpp", ".c": "c", ".h": "cpp", ".py": "python"}
FENCE = "```"


def chapters() -> list:
    """The pages of the course in their order, as paths from the root of the sources."""
    lessons = sorted(page.relative_to(ROOT) for page in (ROOT / COURSE).glob("[0-9][0-9]_*/README.md"))
    return [COURSE / "README.md", *lessons, COURSE / "teachers.md"]


def title_of(page: pathlib.Path) -> str:
    found = re.search(r"^# (.+)$", (ROOT / page).read_text(), re.MULTILINE)
    return found.group(1) if found else page.stem


def target_of(page: pathlib.Path, link: str) -> pathlib.Path:
    """The file that a link on a page leads to, as a path from the root of the sources."""
    return pathlib.Path(os.path.normpath(page.parent / link))


def links_of(page: pathlib.Path) -> list:
    """(is a picture, target) for each link on a page to a file of the sources."""
    links = []
    for bang, _, link, _ in LINK.findall((ROOT / page).read_text()):
        if link and "://" not in link and (ROOT / target_of(page, link)).is_file():
            links.append((bool(bang), target_of(page, link)))
    return links


def staged_files() -> list:
    """The course, what it links to, and the pictures of these pages."""
    course = chapters()
    linked = [target for page in course for _, target in links_of(page)]
    pictures = [target for page in linked if page.suffix == ".md" for picture, target in links_of(page) if picture]
    return list(dict.fromkeys(course + linked + pictures))


def staged_name(file: pathlib.Path) -> pathlib.Path:
    """Where the site has a file."""
    name = file.relative_to(COURSE) if file.is_relative_to(COURSE) else file
    if name.name == "README.md":
        return name.with_name("index.md")
    return name.with_name(name.name + ".md") if file.suffix in SOURCES else name


def separate_blocks(text: str) -> str:
    """Blank lines around code, and before lists and tables: Python's Markdown needs them."""
    out, in_code = [], False
    for line in text.splitlines():
        fence = line.startswith(FENCE)
        before = out[-1] if out else ""
        item = re.match(r"(- |\d+\. |\|)", line)
        opens_list = item and not re.match(r"(- |\d+\. |\||  )", before)
        if before and not in_code and (fence or opens_list):
            out.append("")
        out.append(line)
        if fence and in_code:
            out.append("")
        in_code = in_code != fence
    return "\n".join(out) + "\n"


def number_exercises(text: str) -> str:
    """Numbers of exercises as text: a list would begin with 1 again after each picture."""
    head, mark, tail = text.partition("\n## Exercises\n")
    tail, more, rest = tail.partition("\n## ")
    return head + mark + re.sub(r"^(\d+)\. ", r"\n**\1.** ", tail, flags=re.MULTILINE) + more + rest


def page_text(page: pathlib.Path, rewrite) -> str:
    """The text of a page. `rewrite(target)` gives the new address of a file, or nothing: then the link becomes text."""
    def replace(match: re.Match) -> str:
        bang, text, link, anchor = match.groups()
        if not link or "://" in link:
            return match.group(0)
        address = rewrite(target_of(page, link))
        return f"{bang}[{text}]({address}{anchor or ''})" if address else text
    text = re.sub(r"<!--.*?-->\n?", "", (ROOT / page).read_text(), flags=re.DOTALL)
    return separate_blocks(number_exercises(LINK.sub(replace, text)))


def stage(pages: pathlib.Path) -> None:
    shutil.rmtree(pages, ignore_errors=True)
    files = staged_files()
    for file in files:
        place = pages / staged_name(file)
        place.parent.mkdir(parents=True, exist_ok=True)
        if file.suffix == ".md":
            def rewrite(target, folder=staged_name(file).parent):
                return os.path.relpath(staged_name(target), folder) if target in files else ""
            place.write_text(page_text(file, rewrite))
        elif file.suffix in SOURCES:
            place.write_text(f"# {file.name}\n\n{FENCE}{SOURCES[file.suffix]}\n{(ROOT / file).read_text()}{FENCE}\n")
        else:
            shutil.copy(ROOT / file, place)


def colours(selector: str) -> str:
    from pygments.formatters import HtmlFormatter
    return HtmlFormatter(style="tango").get_style_defs(selector)


def make_site(output: pathlib.Path) -> None:
    pages = output / "pages"
    (pages / "colours.css").write_text(colours(".codehilite"))
    nav = "".join(f"  - {title_of(page)!r}: {staged_name(page)}\n" for page in chapters())
    (output / "mkdocs.yml").write_text(
        "site_name: The glark course\nsite_url: ''\nuse_directory_urls: false\nplugins: []\n"
        f"docs_dir: {pages}\nsite_dir: {output / 'site'}\n"
        f"theme: {{name: null, custom_dir: {THEME}}}\n"
        "markdown_extensions: [tables, fenced_code, {codehilite: {guess_lang: false}}]\n"
        f"nav:\n{nav}")
    subprocess.run(["mkdocs", "build", "--quiet", "--strict", "--config-file", output / "mkdocs.yml"], check=True)


PRINT = """
@page { size: A4; margin: 18mm 20mm; @bottom-center { content: counter(page); font: 9pt sans-serif; color: #666; } }
@page :first { @bottom-center { content: none; } }
body { font: 10pt/1.4 "DejaVu Serif", serif; color: #1c1c1c; }
h1, h2, th { font-family: "DejaVu Sans", sans-serif; }
h1 { font-size: 21pt; color: #1f3d6d; margin: 0 0 8mm; }
h2 { font-size: 13pt; color: #1f3d6d; margin: 5mm 0 2mm; break-after: avoid; }
section { break-before: page; }
.cover { break-before: auto; text-align: center; padding-top: 60mm; }
.cover h1 { font-size: 34pt; margin-bottom: 4mm; }
.cover img { width: 90mm; margin-top: 14mm; }
.contents a::after { content: leader('.') target-counter(attr(href), page); }
.contents li { list-style: none; margin: 2mm 0; }
a { color: #1f3d6d; text-decoration: none; }
code { font: 8.6pt "DejaVu Sans Mono", monospace; }
pre { background: #f4f5f7; border-left: 2pt solid #9db3d4; padding: 2mm 3mm; white-space: pre-wrap; }
pre code { font-size: 7.2pt; }
table { border-collapse: collapse; margin: 3mm 0; break-inside: avoid; }
td, th { border: .4pt solid #c4c8ce; padding: 1.2mm 2mm; vertical-align: top; text-align: left; font-size: 9.5pt; }
th { background: #edf1f7; }
img { max-width: 44mm; }
.pictures { table-layout: fixed; width: 100%; }
.pictures img { width: 100%; max-width: 60mm; }
.exercise { break-after: avoid; }
.picture { break-before: avoid; }
"""


def section_of(page: pathlib.Path, sections: dict) -> str:
    """A chapter as HTML. Links to other chapters lead to their sections; other links become text."""
    import markdown

    def rewrite(target: pathlib.Path) -> str:
        if target in sections:
            return "#" + sections[target]
        return str(ROOT / target) if target.suffix in (".png", ".svg") else ""
    html = markdown.markdown(page_text(page, rewrite), extensions=["tables", "fenced_code", "codehilite"],
                             extension_configs={"codehilite": {"guess_lang": False}})
    html = re.sub(r"<table>(?=(?:(?!</table>).)*<img)", '<table class="pictures">', html, flags=re.DOTALL)
    html = re.sub(r"<p>(?=<strong>\d+\.</strong>)", '<p class="exercise">', html)  # stays with its command
    html = re.sub(r"<p>(?=<img)", '<p class="picture">', html)
    html = re.sub(r"<p>The solutions: .*?</p>", "", html)  # students solve first
    html = re.sub(r'href="#[^"]*"', lambda m: m.group(0) if m.group(0)[7:-1] in sections.values() else "", html)
    return f'<section id="{sections[page]}">{html}</section>'


def make_book(output: pathlib.Path) -> None:
    import weasyprint
    sections = {page: f"chapter-{i}" for i, page in enumerate(chapters())}
    contents = "".join(f'<li><a href="#{name}">{title_of(page)}</a></li>' for page, name in sections.items())
    picture = ROOT / COURSE / "10_projects/expected/waving.png"
    html = (f'<style>{PRINT}{colours(".codehilite")}</style><div class="cover"><h1>The glark course</h1>'
            f'<p>Adaptive refinement with OpenGL, in ten lessons</p><img src="{picture}"></div>'
            f'<section class="contents"><h1>Contents</h1><ul>{contents}</ul></section>'
            + "".join(section_of(page, sections) for page in sections))
    weasyprint.HTML(string=html, base_url=str(ROOT)).write_pdf(output / "course.pdf")


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("output", type=pathlib.Path)
    parser.add_argument("--site", action="store_true", help="only the site")
    parser.add_argument("--pdf", action="store_true", help="only the PDF")
    arguments = parser.parse_args()
    output = arguments.output.resolve()
    output.mkdir(parents=True, exist_ok=True)
    both = arguments.site == arguments.pdf
    if arguments.site or both:
        stage(output / "pages")
        make_site(output)
        print(output / "site/index.html")
    if arguments.pdf or both:
        make_book(output)
        print(output / "course.pdf")
    return 0


if __name__ == "__main__":
    sys.exit(main())
