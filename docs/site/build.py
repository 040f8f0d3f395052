#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""build.py OUT MODULES: writes the site into the folder OUT. MODULES is where bindings/small/wasm/build.sh has built.
Needs doxygen and python3-markdown. A link that leads nowhere is an error."""
import html
import itertools
import pathlib
import re
import shutil
import subprocess
import sys

import markdown

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent.parent

# Pages from the repository's own: name on the site, source, title.
PAGES = [
    ("index", HERE / "index.html", "exact overlap queries between plain 2D shapes"),
    ("functions", HERE / "functions.html", "which function do I want?"),
    ("guide", ROOT / "docs/guide.md", "guide"),
    ("cookbook", ROOT / "docs/cookbook.md", "cookbook"),
    ("recipes", ROOT / "docs/recipes.md", "recipes"),
    ("detection", ROOT / "docs/detection.md", "detection and tracking"),
    ("planning", ROOT / "docs/planning.md", "planning"),
    ("methods", ROOT / "docs/methods.md", "the named methods"),
    ("benchmarks", ROOT / "docs/benchmarks.md", "speed"),
    ("join", ROOT / "docs/join.md", "index and join"),
    ("motion", ROOT / "docs/motion.md", "shapes that move"),
    ("cuda", ROOT / "docs/cuda.md", "at compile time and on a GPU"),
    ("hosts", ROOT / "docs/hosts.md", "from other languages"),
    ("python", ROOT / "bindings/python/README.md", "Python"),
    ("javascript", ROOT / "bindings/javascript/README.md", "JavaScript"),
    ("rust", ROOT / "bindings/rust/vesica/README.md", "Rust"),
    ("go", ROOT / "bindings/go/README.md", "Go"),
    ("java", ROOT / "bindings/java/README.md", "Java"),
    ("csharp", ROOT / "bindings/csharp/README.md", "C#"),
    ("platforms", ROOT / "docs/platforms.md", "platforms"),
    ("abi", ROOT / "capi/ABI.md", "what may change, and when"),
]
# The links at the top, and at the bottom all pages; a phone shows the first three of the top.
TOP = [
    ("playground/", "Playground"), ("guide.html", "Guide"), ("reference/index.html", "Reference"),
    ("functions.html", "Functions"), ("benchmarks.html", "Speed"), ("hosts.html", "Languages"),
]
ALL = {
    "Begin": [
        ("playground/", "Playground"), ("guide.html", "Guide"), ("functions.html", "Which function?"),
        ("cookbook.html", "Cookbook"), ("recipes.html", "Recipes"),
    ],
    "Languages": [
        ("python.html", "Python"), ("javascript.html", "JavaScript"), ("rust.html", "Rust"), ("go.html", "Go"),
        ("java.html", "Java"), ("csharp.html", "C#"), ("hosts.html", "Others"),
    ],
    "By task": [
        ("detection.html", "Detection and tracking"), ("planning.html", "Robots and vehicles"),
        ("motion.html", "Rays and moving shapes"), ("join.html", "Pairs among millions"),
        ("cuda.html", "Compile time and GPU"),
    ],
    "Look up": [
        ("reference/index.html", "Reference"), ("benchmarks.html", "Speed"), ("methods.html", "Named methods"),
        ("platforms.html", "Platforms"), ("abi.html", "What may change"),
    ],
}
TO_PAGE = {source: f"{name}.html" for name, source, _ in PAGES}
TITLES = {f"{name}.html": title for name, _, title in PAGES}


def link_to(target, text, here, up):
    current = ' aria-current="page"' if target == here else ""
    return f'<a href="{up}{target}"{current}>{text}</a>'


def navigation(here, up=""):
    links = "".join(link_to(*item, here, up) for item in TOP)
    home = f'<a class="home" href="{up}index.html">Vesica</a>'
    more = '<a href="#pages">More</a>'
    return f'<header class="site"><nav aria-label="Site">{home}{links}{more}</nav></header>'


def all_pages(here, up=""):
    def group(title, items):
        links = "".join(f"<li>{link_to(*item, here, up)}</li>" for item in items)
        return f"<section><h2>{title}</h2><ul>{links}</ul></section>"
    groups = "".join(group(*item) for item in ALL.items())
    return f'<nav id="pages" class="pages" aria-label="All pages">{groups}</nav>'


def framed(page, here, version, up=""):
    """A page with what all have: links at the top and at the bottom, and the version."""
    page = page.replace("<!-- navigation -->", navigation(here, up)).replace("<!-- pages -->", all_pages(here, up))
    return page.replace("{version}", version)


# The programs of the start page, in this order.
SAMPLES = {
    "c": "C", "cpp": "C++", "py": "Python", "mjs": "JavaScript", "rs": "Rust", "go": "Go", "java": "Java", "cs": "C#",
}


def samples():
    """One program in each language, of which one is shown: the style sheet needs no script for that."""
    def choice(name, title):
        checked = " checked" if name == "c" else ""
        return (f'<input type="radio" name="language" id="in-{name}"{checked}>'
                f'<label for="in-{name}">{title}</label>')

    def program(name, title):
        text = html.escape((HERE / f"samples/first.{name}").read_text(), quote=False)
        return f'<pre tabindex="0" class="in-{name}" aria-label="In {title}"><code>{text}</code></pre>'
    shown = ", ".join(f"#in-{name}:checked ~ .in-{name}" for name in SAMPLES)
    parts = [*(choice(*item) for item in SAMPLES.items()), *(program(*item) for item in SAMPLES.items())]
    return (f'<style>{shown} {{ display: block }}</style>'
            f'<fieldset class="languages"><legend>Language</legend>{"".join(parts)}</fieldset>')


def repository():
    return re.search(r"^repository-code: (.*)", (ROOT / "CITATION.cff").read_text(), re.M)[1]


FUNCTION = re.compile(r'<a id="(\w+)" name="\w+"></a>\s*<h2 class="memtitle">.*?</span>(\w+)\(\)')


def reference_of(out):
    """Where doxygen has put each C function."""
    places = {}
    for page in sorted((out / "reference").glob("*_8h.html")):
        for anchor, name in FUNCTION.findall(page.read_text()):
            places[name] = f"reference/{page.name}#{anchor}"
    return places


def from_markdown(source):
    """A page of the repository as HTML; its links to pages that are here lead there, others lose their link."""
    reader = markdown.Markdown(extensions=["tables", "fenced_code", "toc"], extension_configs={"toc": {"toc_depth": 2}})
    body = reader.convert(source.read_text())
    if body.count("<h2") > 4:
        contents = f'<details class="toc"><summary>On this page</summary>{reader.toc}</details>'
        body = body.replace("</h1>", f"</h1>{contents}", 1)

    def link(match):
        target, _, part = match[1].partition("#")
        if re.match(r"[a-z]+:", target) or not target:
            return match[0]
        page = TO_PAGE.get((source.parent / target).resolve())
        if page is None:
            return match[2]
        text = TITLES[page] if match[2].endswith(".md") else match[2]
        return f'<a href="{page}{"#" + part if part else ""}">{text}</a>'

    body = re.sub(r'<a href="([^"]*)">(.*?)</a>', link, body, flags=re.S)
    tables = itertools.count(1)
    scroll = '<div class="scroll" tabindex="0" role="region" aria-label="Table {}"><table>'
    body = re.sub("<table>", lambda _: scroll.format(next(tables)), body)
    body = body.replace("</table>", "</table></div>").replace("<pre>", '<pre tabindex="0">')
    # A head without words is no head.
    return re.sub(r"<th(?: style=\"[^\"]*\")?></th>", "<td></td>", body).replace("<th>", '<th scope="col">')


def write_page(out, name, source, title, version, places):
    if source.suffix == ".md":
        body = from_markdown(source)
    else:
        body = source.read_text().replace("{repository}", repository())
        if "<!-- samples -->" in body:
            body = body.replace("<!-- samples -->", samples())
        linked = '<a href="{}"><code>{}</code></a>'
        body = re.sub(r"\{(vesica_\w+)\}", lambda match: linked.format(places[match[1]], match[1]), body)
    page = (HERE / "template.html").read_text().replace("{title}", title).replace("{body}", body)
    (out / f"{name}.html").write_text(framed(page, f"{name}.html", version))


def write_reference(out, version):
    """By doxygen, between the head and the foot of all pages."""
    folder = out / "reference"
    folder.mkdir()
    settings = (HERE / "reference/Doxyfile").read_text() + f"\nOUTPUT_DIRECTORY = {folder}\n"
    for part in ("header", "footer"):
        file = out / f"{part}.html"
        file.write_text(framed((HERE / f"reference/{part}.html").read_text(), "reference/index.html", version, "../"))
        settings += f"HTML_{part.upper()} = {file}\n"
    subprocess.run(["doxygen", "-"], input=settings, text=True, cwd=ROOT, check=True)
    for part in ("header", "footer"):
        (out / f"{part}.html").unlink()
    search_in_names(folder / "search")


def search_in_names(search):
    """Makes doxygen's search look inside names, as all of ours begin with vesica_."""
    script = (search / "search.js").read_text()
    for old, new in {
        "indexSectionsWithContent[this.searchIndex].indexOf(idxChar)": "0",
        "rowMatchName.substr(0, search.length)==search": "rowMatchName.includes(search)",
    }.items():
        if script.count(old) != 1:
            sys.exit(f"doxygen's search.js has another form: it lacks {old}")
        script = script.replace(old, new)
    (search / "search.js").write_text(script)
    # One list for all first letters, the functions of C first.
    for first in search.glob("*_0.js"):
        parts = [*search.glob(first.name.replace("_0.js", "_*.js"))]
        rows = sorted(row for part in parts for row in re.findall(r"^  (\[.*\]),?$", part.read_text(), re.M))
        rows.sort(key=lambda row: not row.startswith("['vesica_5f"))
        first.write_text("var searchData=\n[\n  " + ",\n  ".join(rows) + "\n];\n")
    style = search / "search.css"
    style.write_text('@import "../site.css";\n' + style.read_text() + (HERE / "reference/search.css").read_text())


def write_playground(out, modules, version):
    shutil.copytree(HERE / "playground", out / "playground")
    page = out / "playground/index.html"
    page.write_text(framed(page.read_text(), "playground/", version, "../"))
    (out / "vesica").mkdir()
    subprocess.run([sys.executable, "-B", ROOT / "bindings" / "declare", "javascript"], check=True)
    for module in (ROOT / "bindings" / "javascript").glob("*.mjs"):
        shutil.copy(module, out / "vesica")
    for name in ("vesica.wasm", "vesica-methods.wasm"):
        shutil.copy(modules / name, out / "vesica")
    shutil.copy(modules / "simd/vesica.wasm", out / "vesica/vesica-simd.wasm")


def dead_links(out):
    """Links of the site's own pages that lead to no file of it, or to no place in it."""
    dead = []
    for page in [*out.glob("*.html"), out / "playground/index.html", out / "reference/index.html"]:
        for target in re.findall(r'(?:href|src)="([^"]+)"', page.read_text()):
            path, _, part = target.partition("#")
            if re.match(r"[a-z]+:", path):
                continue
            file = (page.parent / path).resolve() if path else page
            file = file / "index.html" if file.is_dir() else file
            # What follows # is the playground's state there, and a place elsewhere.
            is_state = file.parent.name == "playground"
            if not file.is_file() or (part and not is_state and f'id="{part}"' not in file.read_text()):
                dead.append(f"{page.relative_to(out)}: {target}")
    return dead


def main(out, modules):
    shutil.rmtree(out, ignore_errors=True)
    out.mkdir(parents=True)
    version = re.search(r"VERSION ([\d.]+)", (ROOT / "CMakeLists.txt").read_text().split("project(")[1])[1]
    write_reference(out, version)
    places = reference_of(out)
    shutil.copy(HERE / "site.css", out)
    shutil.copytree(ROOT / "docs/figures", out / "figures", ignore=shutil.ignore_patterns("*.cpp", "*.hpp", "*.txt"))
    for image in (ROOT / "docs/pictures").iterdir():
        shutil.copy(image, out)
    shutil.copy(ROOT / "docs/architecture.svg", out)
    for name, source, title in PAGES:
        write_page(out, name, source, title, version, places)
    write_playground(out, modules, version)
    dead = dead_links(out)
    for link in dead:
        print(f"a dead link: {link}", file=sys.stderr)
    return bool(dead)


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    sys.exit(main(pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()))
