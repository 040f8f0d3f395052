#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""build.py OUT MODULES: writes the site into the folder OUT. MODULES is where bindings/small/wasm/build.sh has built. Needs
doxygen and python3-markdown. A link that leads nowhere is an error."""
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
    ("platforms", ROOT / "docs/platforms.md", "platforms"),
    ("abi", ROOT / "capi/ABI.md", "what may change, and when"),
]
NAVIGATION = [
    ("playground/", "Playground"), ("functions.html", "Functions"), ("guide.html", "Guide"),
    ("cookbook.html", "Cookbook"), ("recipes.html", "Recipes"),
    ("detection.html", "Detection"), ("planning.html", "Planning"),
    ("reference/index.html", "Reference"), ("methods.html", "Methods"), ("benchmarks.html", "Speed"), ("join.html", "Join"), ("motion.html", "Motion"),
    ("cuda.html", "CUDA"), ("hosts.html", "Languages"), ("platforms.html", "Platforms"), ("abi.html", "ABI"),
]
TO_PAGE = {source: f"{name}.html" for name, source, _ in PAGES}


def navigation(here, up=""):
    def link(target, text):
        current = ' aria-current="page"' if target == here else ""
        return f'<a href="{up}{target}"{current}>{text}</a>'
    home = f'<a class="home" href="{up}index.html">Vesica</a>'
    links = "".join(link(*item) for item in NAVIGATION)
    return f'<header class="site"><nav aria-label="Site">{home}{links}</nav></header>'


def sample(match):
    text = html.escape((HERE / "samples" / match[1]).read_text(), quote=False)
    return f'<pre tabindex="0"><code>{text}</code></pre>'


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
    body = markdown.markdown(source.read_text(), extensions=["tables", "fenced_code", "toc"])

    def link(match):
        target, _, part = match[1].partition("#")
        if re.match(r"[a-z]+:", target) or not target:
            return match[0]
        page = TO_PAGE.get((source.parent / target).resolve())
        if page is None:
            return match[2]
        return f'<a href="{page}{"#" + part if part else ""}">{match[2]}</a>'

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
        body = re.sub(r"<!-- sample (\S+) -->", sample, source.read_text())
        linked = '<a href="{}"><code>{}</code></a>'
        body = re.sub(r"\{(vesica_\w+)\}", lambda match: linked.format(places[match[1]], match[1]), body)
    page = (HERE / "template.html").read_text().replace("{title}", title).replace("{version}", version)
    page = page.replace("<!-- navigation -->", navigation(f"{name}.html")).replace("{body}", body)
    (out / f"{name}.html").write_text(page)


def write_reference(out):
    settings = (HERE / "reference/Doxyfile").read_text() + f"\nOUTPUT_DIRECTORY = {out / 'reference'}\n"
    (out / "reference").mkdir()
    subprocess.run(["doxygen", "-"], input=settings, text=True, cwd=ROOT, check=True)


def write_playground(out, modules):
    shutil.copytree(HERE / "playground", out / "playground")
    page = out / "playground/index.html"
    page.write_text(page.read_text().replace("<!-- navigation -->", navigation("playground/", "../")))
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
    write_reference(out)
    places = reference_of(out)
    shutil.copy(HERE / "site.css", out)
    shutil.copytree(ROOT / "docs/figures", out / "figures", ignore=shutil.ignore_patterns("*.cpp", "*.hpp", "*.txt"))
    for image in (ROOT / "docs/pictures").iterdir():
        shutil.copy(image, out)
    shutil.copy(ROOT / "docs/architecture.svg", out)
    for name, source, title in PAGES:
        write_page(out, name, source, title, version, places)
    write_playground(out, modules)
    dead = dead_links(out)
    for link in dead:
        print(f"a dead link: {link}", file=sys.stderr)
    return bool(dead)


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    sys.exit(main(pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()))
